"""Every exercise is whole: stub, task, hints, tests, known answers: exercises_test.py ROOT BUILD"""
import os
import re
import subprocess
import sys
from collections import Counter

from proofs import (DRAWING, exercises, house, main, notes, other_cases, prose, read, regions,
                    sections, would_change)

from check import answers
from judge import grade as grading


def stubs_are_fresh(root, build):
    """the committed stubs are those made from the solutions"""
    stale = list(would_change("stubs", root, build))
    if os.environ.get("CI") == "true":
        yield from stale
    else:  # a reader may have changed what is outside the exercises, too
        notes.extend(stale)
    for chapter in house.chapters():
        if read(chapter.mine) != exercises.stub(read(chapter.solution)) and not stale:
            where = chapter.mine.relative_to(root)
            if os.environ.get("CI") == "true":
                yield f"{where} holds work"
            else:
                notes.append(f"{where} holds work")


def every_region_has_a_task(root, build):
    """every exercise states its task, has an answer, and is numbered by its chapter"""
    for chapter in house.chapters():
        for region in regions(chapter):
            if not region.task() or not "".join(region.answer()).strip():
                yield f"{chapter.solution.name}: {region.id} lacks its task or its answer"
        wanted = [f"{chapter.number}.{n + 1}" for n in range(len(chapter.ids()))]
        if chapter.ids() != wanted:
            yield f"{chapter.folder}: the exercises are {chapter.ids()}, not {wanted}"


def every_exercise_has_hints(root, build):
    """every exercise has three hints, and no hint belongs to nothing"""
    for chapter in house.chapters():
        found = sections(prose(read(chapter.hints)), "##")
        yield from differ(f"{chapter.folder}/hints.md", [id_ for id_, _ in found], chapter.ids())
        for id_, body in found:
            hints = sections(body, "###")
            if [number for number, text in hints if text.strip()] != ["1", "2", "3"]:
                yield f"{chapter.folder}/hints.md: {id_} has not the hints 1, 2, 3"


def every_exercise_stands_in_the_list(root, build):
    """every exercise stands in the list of its chapter's text, and its number leads to its hints"""
    for chapter in house.chapters():
        yield from differ(f"{chapter.folder}/README.md, Exercises", list(chapter.titles()),
                          chapter.ids())
        for id_ in chapter.ids():
            if f"* [{id_}](hints.md#{id_.replace('.', '')}) " not in read(chapter.text):
                yield f"{chapter.folder}/README.md: {id_} does not lead to its hints"


def every_exercise_has_tests(root, build):
    """every exercise has a test, and no test belongs to no exercise"""
    for chapter in house.chapters():
        files = sorted((root / "tests" / chapter.folder).glob("*test.cpp"))
        cases = re.findall(r"TEST_CASE\((.*?)\)\s*\{", "".join(map(read, files)), re.S)
        tags = {tag for case in cases for tag in re.findall(r"\[(\d+\.\d+)\]", case)}
        yield from differ(f"tests/{chapter.folder}", sorted(tags), chapter.ids())


def every_exercise_has_wrong_answers(root, build):
    """every exercise has two known wrong answers, and no answer belongs to no exercise"""
    for chapter in house.chapters():
        paths = answers.files_of(chapter.folder, root)
        yield from differ(f"tests/{chapter.folder}/answers", [path.stem for path in paths],
                          chapter.ids())
        count = Counter(one.id for one in answers.read_all(paths, read(chapter.solution))
                        if one.kind in ("mistake", "wrong"))
        yield from (f"{id_} has {count[id_]} wrong answers: at least two are wanted"
                    for id_ in chapter.ids() if count[id_] < 2)


def every_diagnosis_has_one_name(root, build):
    """every diagnosis with an id is named by a known answer; its id and its wording are its own"""
    shared, texts = answers.diagnoses(root / "checker")
    of_tests, more = answers.diagnoses(root / "tests/checker")
    shared, texts = shared + of_tests, texts + more
    yield from twice("checker", shared, texts)
    never = {id_ for id_, _ in shared}
    for chapter in house.chapters():
        told, texts = answers.diagnoses(root / "tests" / chapter.folder)
        yield from twice(chapter.folder, shared + told, texts)
        known = answers.read_all(answers.files_of(chapter.folder, root), read(chapter.solution))
        named = {id_: one for one in known for id_ in one.ids()}
        yield from (f"tests/{chapter.folder}: no known answer names '{id_}'"
                    for id_ in sorted({id_ for id_, _ in told} - set(named)))
        yield from (f"{one.file.relative_to(root)}:{one.line}: nothing is called '{id_}'"
                    for id_, one in named.items() if id_ not in dict(shared + told))
        never -= set(named)
    yield from (f"checker: no known answer names '{id_}'" for id_ in sorted(never))


def twice(folder, told, texts):
    ids, wordings = {}, {}
    for id_, words in told:
        if ids.setdefault(id_, words) != words:
            yield f"tests/{folder}: '{id_}' is the id of two diagnoses"
        if wordings.setdefault(words, id_) != id_:
            yield f"tests/{folder}: '{words}' has the ids '{id_}' and '{wordings[words]}'"
    yield from (f"tests/{folder}/{name}: '{words}' stands there {count} times"
                for (name, words), count in texts.items() if count > 1 and words in wordings)


def differ(where, found, wanted):
    yield from (f"{where}: {id_} is missing" for id_ in wanted if id_ not in found)
    yield from (f"{where}: {id_} is no exercise" for id_ in found if id_ not in wanted)
    if set(found) == set(wanted) and found != wanted:
        yield f"{where}: {' '.join(found)} where {' '.join(wanted)} is wanted"


def drawn_cases_are_the_kept_ones(root, build):
    """a seed draws the same cases with every compiler"""
    for chapter in house.chapters():
        house.must_build([f"{chapter.folder}_test"])
        run = subprocess.run([build / "tests" / f"{chapter.folder}_test"], text=True,
                             capture_output=True, env={**os.environ, **DRAWING})
        yield from other_cases("natively", chapter, run.stdout)


def a_second_mistake_is_named(*_):
    """a mistake in a second region is named beside the first one"""
    def report(words, line):
        return f"Exercise 1.6: J\n\n  x 1 2\n{words}\n\nWhere: distance.cpp:{line}\nNext:  hint"
    sign, lever = "Likely mistake: the sign", "Likely mistake: the lever of\n     body 1"
    for first, second, place, named in ((sign, lever, 9, True), (sign, lever, 3, False),
                                        ("", lever, 3, True), (sign, "", 9, False)):
        words = grading.second_mistake([("K", report(first, 3)), ("J", report(second, place))])
        if words != (f"Another test names a mistake at distance.cpp:{place}: the lever of body 1"
                     if named else ""):
            yield f"after '{first}' in line 3 '{second}' in line {place} is told as '{words}'"


PROOFS = [stubs_are_fresh, every_region_has_a_task, every_exercise_has_hints,
          every_exercise_stands_in_the_list, every_exercise_has_tests,
          every_exercise_has_wrong_answers, every_diagnosis_has_one_name,
          drawn_cases_are_the_kept_ones, a_second_mistake_is_named]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
