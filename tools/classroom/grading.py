"""./wb grade: what a class has handed in, exercise by exercise."""
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import zlib
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import asdict, replace
from pathlib import Path

from base import exercises
from check import checking
from classroom import alike, collecting, fence, lend, remote, results, submission
from classroom.collecting import MISSING
from judge import grade as grading, runs
from base import house
from learn.status import COLOURS
from base.talk import WIDTH, bold, faint, folded, indented

# What stands in the table, where it is not the same.
SHORT = {grading.OPEN: "-", grading.WAITS: "waits", MISSING: ""}
LEGEND = {grading.OPEN: "-: not written yet",
          grading.BROKEN: "broken: the compiler refuses it, or its markers are damaged",
          grading.WAITS: "waits: right, but it calls one that is wrong or not written yet"}
SUMMED = {grading.WAITS: "waiting for another"}
LIMIT = 180     # for one exercise file, compiler and tests [s]


# ---- grading -------------------------------------------------------------------------------------

def grade_text(text, chapter, plan, again=False):
    """(grades, notes) of one exercise file; None where it is late by the clock, unless again."""
    with tempfile.TemporaryDirectory(prefix="grade_", dir=house.BUILD,  # programs may run there
                                     ignore_cleanup_errors=True) as folder:
        folder = Path(folder)
        exercises.write(folder / "chapters" / chapter.folder / chapter.mine.name, text)
        file = folder / "compiled" / chapter.mine.name
        exercises.write(file, "")
        (folder / "build").mkdir()
        line = lend.moved(plan.line.replace(str(chapter.mine), str(file)), house.BUILD,
                          folder / "build")
        seed = zlib.crc32(text.encode(errors="surrogateescape")) % 100_000
        said, late = ask(folder, chapter, replace(
            plan, line=line, reads=[str(folder / "compiled"), *plan.reads]), str(seed))
    if late and not again:
        return None
    verdicts = [line for line in said.split("\n") if line.startswith("[")]  # not of the progress
    if not verdicts:
        return [grading.Grade(id_, grading.BROKEN, "the file cannot be read")
                for id_ in chapter.ids()], []
    grades, notes = json.loads(verdicts[-1])
    most = results.count_tests(chapter)
    return [replace(one, tests=most[one.id] if one.tests else 0,  # a test of two blames one of them
                    passed=most[one.id] if one.status == grading.DONE else one.passed)
            for one in sorted((grading.Grade(**one) for one in grades),
                              key=lambda one: chapter.ids().index(one.id))], notes


def plan_of(chapter):
    """How a chapter's files are graded. Builds what all of them share."""
    answer = f"{chapter.folder}_answer_mine"
    line = lend.commands(house.BUILD, answer, chapter.name)
    house.must_build([f"{chapter.folder}_judge", f"{chapter.folder}_spare", *lend.needs(line)],
                     f"building the tests of chapter {chapter.number}")
    spare = house.BUILD / (f"tests/CMakeFiles/{chapter.folder}_spare.dir/__/solutions/"
                           f"{chapter.folder}/{chapter.name}.cpp.o")
    words = shlex.split(line)
    headers = [house.ROOT / "engine", *(house.ROOT / "chapters").glob("*/*.h"),
               *(f"{path}{end}" for path in words if path.endswith("cmake_pch.hxx")
                 for end in ("", ".gch"))]
    elsewhere = [path.removeprefix("-I") for before, path in zip(words, words[1:])
                 if (before == "-isystem" or path.startswith("-I/"))
                 and not house.ROOT.is_relative_to(path.removeprefix("-I"))]
    symbols = remote.symbols(spare, exercises.read(chapter.solution))
    tests = exercises.read(house.ROOT / "tests" / chapter.folder / "test.cpp")
    return submission.Plan(
        line, str(spare), f"tests/{answer}", str(house.BUILD / f"tests/{chapter.folder}_judge"),
        symbols, remote.uses(spare, symbols, tests), [*map(str, headers), *elsewhere],
        [str(spare), *(str(house.BUILD / path) for path in words
                       if re.search(r"\.[oa]$", path) and path not in lend.made(line))])


def ask(folder, chapter, plan, seed):
    """What tools/classroom/submission.py says of the file in the folder, so far as it comes, and
    whether it was late."""
    env = dict(os.environ, TMPDIR=str(folder), HOME=str(folder))
    env.setdefault("WORKBOOK_SEED", seed)
    process = subprocess.Popen(
        [sys.executable, "-B", house.ROOT / "tools/classroom/submission.py", folder,
         chapter.folder, json.dumps(asdict(plan))],
        cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL, text=True, start_new_session=True)

    def end():  # with all that it has started; it has not been waited for, so the number is its own
        os.killpg(process.pid, signal.SIGKILL)
    with runs.clock(LIMIT, end) as late:
        said = process.stdout.read()
    end()
    process.wait()
    process.stdout.close()
    return said, late


def graded(jobs, plans):
    """(submissions, their grades and notes) of each file as it is done; what was late by the clock
    comes last, alone."""
    late = []
    with ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        running = {pool.submit(grade_text, text, chapter, plans[folder]): (
            text, chapter, plans[folder], all_) for (folder, text), (chapter, all_) in jobs.items()}
        for job in as_completed(running):
            if job.result():
                yield running[job][-1], job.result()
            else:
                late.append(running[job])
    for text, chapter, plan, all_ in late:
        yield all_, grade_text(text, chapter, plan, again=True)


def grade_all(submissions, chapters):
    """Grades the submissions; the same text only once. Files that equal the stubs need not be
    compiled."""
    jobs = {}
    for chapter in chapters:
        for one in submissions:
            file = one.files.get(chapter.folder)
            if file and collecting.is_untouched(file, chapter):
                one.grades |= {id_: grading.Grade(id_, grading.OPEN) for id_ in chapter.ids()}
            elif file:
                jobs.setdefault((chapter.folder, file.text), (chapter, []))[1].append(one)
    house.configure()
    plans = {chapter.folder: plan_of(chapter) for chapter in
             {folder: chapter for (folder, _), (chapter, _) in jobs.items()}.values()}
    with house.talking():
        for count, (all_, (grades, notes)) in enumerate(graded(jobs, plans), 1):
            for one in all_:
                one.grades |= {grade.id: grade for grade in grades}
                one.notes += notes
            house.progress(f"{count} of {len(jobs)} files graded")
    house.progress_done()


def compare(submissions, chapters):
    """Names those whose files are alike."""
    for chapter in chapters:
        texts = {one.name: one.files[chapter.folder].text for one in submissions
                 if chapter.folder in one.files}
        found = alike.pairs(texts, exercises.read(chapter.solution))
        for one in submissions:
            if one.name in found:
                other, share = found[one.name]
                one.alike = "; ".join(filter(None, [
                    one.alike, f"{chapter.name}: {other} {share:.0%}"]))


# ---- what is said --------------------------------------------------------------------------------

def tell_chapter(chapter, submissions, rules):
    """A table: a line for each submission."""
    ids = chapter.ids()
    states = {one.name: [one.grade(id_).status for id_ in ids] for one in submissions}
    words = {name: [SHORT.get(state, state) for state in all_] for name, all_ in states.items()}
    cell = 1 + max(len(word) for all_ in [["waits"], *words.values()] for word in all_)
    title = f"Chapter {chapter.number}: {chapter.name}"
    room = WIDTH - 2 - cell * len(ids) - len("done  points")
    width = min(room, max(len(name) for name in [title, *words]))

    def line(name, words, done, points, colours=()):
        name = name if len(name) <= width else name[:width - 2] + ".."
        cells = [f"{word:{cell}}" for word in words]
        for place, colour in enumerate(colours):
            cells[place] = colour(cells[place])
        print(f"{name:{width}}  {''.join(cells)}{done:<6}{points}".rstrip())
    line(title, ids, "done", "points", [bold] * len(ids))
    for one in submissions:
        points = f"{results.total(results.lines_of(one, ids, rules)):g}"
        line(one.name, words[one.name],
             *((one.done(ids), points) if chapter.folder in one.files else (MISSING, "")),
             [COLOURS.get(state, str) for state in states[one.name]])
    if len(submissions) > 1:
        total = [sum(one.done([id_]) for one in submissions) for id_ in ids]
        line("done in all", map(str, total), sum(total), "")
    most = results.most(results.lines_of(submissions[0], ids, rules))
    line("the most", [""] * len(ids), len(ids), f"{most:g}")
    print()


def tell_why(submission):
    """The first report of every exercise that is wrong, and the output of the compiler, once."""
    told = set()
    for id_, one in submission.grades.items():
        report = one.failures[0][1] if one.failures else \
            one.detail if one.status == grading.BROKEN else ""
        if report and report not in told:
            told.add(report)
            print(f"{bold(id_)}  {COLOURS[one.status](one.words())}\n{indented(report)}\n")


def grade(place, only=None):
    """Grades a submission or a folder of them, of all chapters that are in it or of some. Exit
    status 0 when everything is done."""
    submissions, is_class = collecting.submissions_in(place)
    rules = results.rules_of((place if is_class else place.parent) / results.RULES)
    chapters = only or [chapter for chapter in house.chapters()
                        if any(chapter.folder in one.files for one in submissions)]
    if words := fence.warning():
        print(folded(f"Note: {words}") + "\n")
    grade_all(submissions, chapters)
    compare(submissions, chapters)
    for chapter in chapters:
        tell_chapter(chapter, submissions, rules)
    ids = [id_ for chapter in chapters for id_ in chapter.ids()]
    states = Counter(one.grades[id_].status for one in submissions for id_ in one.grades)
    if legend := [words for state, words in LEGEND.items() if state in states]:
        print(faint("\n".join(legend)) + "\n")
    for one in submissions:
        for note in [*one.notes, *([f"alike, {one.alike}"] if one.alike else [])]:
            print(folded(f"{one.name}: {note}", hang=2))
    if is_class and not any(one.alike for one in submissions):
        print(folded(f"alike: no two files. {alike.USUAL}", hang=2))
    if not is_class:
        tell_why(submissions[0])
    print(f"{len(submissions)} submission{'s' * (len(submissions) > 1)}: "
          + ", ".join(f"{states[state]} {SUMMED.get(state, state)}"
                      for state in grading.ORDER if states[state]))
    tell_where(place, submissions, is_class, ids, rules)
    return 0 if all(one.done(ids) == len(ids) for one in submissions) else 1


def tell_where(place, submissions, is_class, ids, rules):
    """Writes the table and the feedback and says where they are. One submission renews its own
    feedback and no table."""
    all_ = place if is_class else place.parent
    folder = house.OUT / "grades" / results.file_name(all_.resolve().name)
    for one in submissions:
        path = folder / results.file_name(one.name)
        results.write_forms(path, one, ids, rules)
    if is_class:
        table = folder.with_name(f"{folder.name}.csv")
        results.write_table(table, submissions, ids, rules)
        print(f"the table: {house.short(table)}; feedback: {house.short(folder)}/NAME.md ...")
    else:
        print(f"the feedback: {house.short(path)}.md ...")
    print(f"processor time: {checking.processor_time():.0f} s")
