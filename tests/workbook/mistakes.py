"""Mistakes that nobody has written down: mistakes.py ROOT BUILD --seed S --count N [--chapter C]

Each changes tokens of a solution's region, is compiled into the exercise's place as the known
answers are, and is judged by its tests. What comes of it:

    known    named by the sentence of a known answer, or by a diagnosis of the checker
    plain    ended by the tests with a plain sentence: an index outside, a loop without an end
    pointed  found wrong, where and by how much; no sentence says why
    passed   not found: the tests lack a case
    same     not found, and no mistake: equivalents.txt says why

Those that the compiler refuses are not counted. Names are written with --every, too: whether one
misleads must be read. Exit status 1 if a mistake passes.
"""
import argparse
import random
import re
import shlex
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from proofs import exercises, house

from check import answers, judging, slips
from judge import grade as grading

HELPERS = '#define WORKBOOK_SLIPS_FIT\n#include "tests/checker/slips.h"\n'
SIZE = 8  # candidates for each mistake that is wanted: the compiler refuses some


def drawn(chapter, wanted, seed):
    """Writes mistakes as answers, [(answer id, kind, old line, new line)] of each exercise."""
    text, found = chapter.solution.read_text(), {}
    folder = house.BUILD / "mistakes" / chapter.folder
    for id_ in chapter.ids():
        draw, seen, lines = random.Random(f"{seed} {id_}"), set(), []
        regions = [one for one in exercises.regions(text) if one.id == id_]
        codes = [slips.of(text, one) for one in regions]
        for n in range(SIZE * wanted[id_]):
            place = draw.randrange(len(codes))
            code = codes[place]
            kind = draw.choice(sorted({one.kind for one in code.found}))
            slip = draw.choice([one for one in code.found if one.kind == kind])
            body = slip.body(code.text)
            if (place, body) in seen:
                continue
            seen.add((place, body))
            lines += [f"// region {place + 1}", f'// wrong "number {n}":', body, ""]
            line = slice(code.text.rfind("\n", 0, slip.begin) + 1,
                         (code.text + "\n").find("\n", slip.end))
            found[f"{id_} wrong: number {n}"] = (
                slip, " ".join(code.text[line].split()),
                " ".join(body[line.start:line.stop + len(body) - len(code.text)].split()))
        exercises.write(folder / f"{id_}.cpp", "\n".join(lines))
    return found


def build(chapter):
    """A program with those of the mistakes that compile, and the answers in it."""
    folder = house.BUILD / "mistakes" / chapter.folder
    source, program = folder / "all.cpp", folder / "program"
    files = sorted(folder.glob("[0-9]*.cpp"))
    known = answers.read_all(files, chapter.solution.read_text())
    Path(f"{source}.refused.json").unlink(missing_ok=True)
    target = f"{chapter.folder}_answers"
    house.must_build([target])
    commands = subprocess.run(["ninja", "-C", house.BUILD, "-t", "commands", target], text=True,
                              capture_output=True, check=True).stdout.split("\n")
    object_ = f"{chapter.folder}_numbers.cpp.o"
    compiles = next(one for one in commands if f"{object_} -c" in one)
    compiles = [*shlex.split(compiles.partition(" -MD ")[0]), "-c", source, "-o", f"{source}.o"]
    while True:
        answers.make(chapter.solution, files, False, source, house.ROOT)
        source.write_text(HELPERS + source.read_text())
        log = subprocess.run(compiles, cwd=house.BUILD, text=True, capture_output=True).stderr
        if not answers.refuse(source, known, f"FAILED: \n{log}"):
            break
    links = re.sub(rf"\S*{re.escape(object_)}", f"{source}.o", commands[-2])
    links = links.replace(f"-o tests/{target} ", f"-o {program} ")
    subprocess.run(links, shell=True, cwd=house.BUILD, check=True)
    refused = answers.refused_of(source)
    return program, [one for one in known if not one.faults and one.key() not in refused]


def equivalent(id_, kind, line):
    """Why such a change is no mistake; "" where nothing is said."""
    for one in (Path(__file__).parent / "equivalents.txt").read_text().splitlines()[1:]:
        exercise, of, words, why = one.split(" | ")
        if (exercise, of) == (id_, kind) and words in line:
            return why
    return ""


def outcome(answer, program, chapter, slip, line):
    """(what comes of a mistake, the sentence)."""
    one, trouble = judging.graded(answer, answer.id, program, chapter)
    if trouble:
        return "refused", trouble
    if one.status == grading.DONE:
        why = equivalent(answer.id, slip.kind, line)
        return "same" if why else "passed", why
    report = one.failures[0][1]
    words = grading.named(report)
    if not words and not re.match(r"Exercise \d", report.strip()):
        return "plain", " ".join(report.partition("Where:")[0].split())
    vague = not words or "#drawn-alone" in words
    return "pointed" if vague else "known", words


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("root"), parser.add_argument("build")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--chapter", default="")
    parser.add_argument("--every", action="store_true")
    args = parser.parse_args(arguments)
    house.ROOT, house.BUILD = Path(args.root).resolve(), Path(args.build).resolve()
    chapters = [one for one in house.chapters() if args.chapter in ("", str(one.number))]
    ids = [id_ for chapter in chapters for id_ in chapter.ids()]
    wanted = Counter(ids[n % len(ids)] for n in range(args.count))
    total = Counter()
    for chapter in chapters:
        words = drawn(chapter, wanted, args.seed)
        program, compiled = build(chapter)
        chosen = [one for id_ in chapter.ids() for one in
                  [one for one in compiled if one.id == id_][:wanted[id_]]]
        with ThreadPoolExecutor(2) as pool:
            judged = list(pool.map(
                lambda one: outcome(one, program, chapter, *words[one.name][::2]), chosen))
        counts = Counter(kind for kind, _ in judged)
        total += counts
        print(f"chapter {chapter.number}: {dict(counts)}", flush=True)
        for one, (came, said) in zip(chosen, judged):
            slip, old, new = words[one.name]
            if came in ("passed", "pointed") or args.every:
                print(f"  {came} {one.id} ({one.region}) {slip.kind}: {old} ==> {new}\n"
                      f"      {said}")
    print(f"in all: {dict(total)}")
    return 1 if total["passed"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
