"""What the proofs of this folder share: reading texts, and saying what holds.

One function a proof; it yields a line for everything that is wrong. Exit status 1 when something is
wrong, 2 for a bad command line.
"""
import json
import math
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path[:0] = [str(Path(__file__).absolute().parents[2] / folder) for folder in ("tools", "plots")]
from base import exercises, house  # noqa: E402
from base.house import files  # noqa: E402, F401
from keep import keeping, values  # noqa: E402

notes = []
DRAWING = {"WORKBOOK_DRAWN": "1", "WORKBOOK_SEED": "1"}  # tests print digests of their cases
to_do = []  # commands that make broken proofs hold
SLACK = 1.2  # a length is an aim: missed by less it is noted, by more it is wrong


def read(path):
    """The text of a file; "" where there is none (a proof of its own says so)."""
    return path.read_text(encoding="utf-8") if path.is_file() else ""


def regions(chapter):
    return exercises.regions(read(chapter.solution), chapter.solution.name)


def prose(text):
    """A Markdown text without fenced and inline code; formulas stay."""
    kept, fence = [], None
    for line in text.split("\n"):
        if line.lstrip().startswith("```"):
            fence = line.strip() if fence is None else None
        elif fence in (None, "```math"):
            kept.append(re.sub(r"`[^`]*`", "", line))
    return "\n".join(kept)


def sections(text, mark):
    """The parts of a Markdown text by their headings, which begin with mark: (heading, body)."""
    parts = re.split(rf"^{mark} (.+)$", text, flags=re.M)[1:]
    return list(zip([heading.strip() for heading in parts[::2]], parts[1::2]))


def section(chapter, heading):
    """One section of a chapter's text."""
    return dict(sections(prose(read(chapter.text)), "##")).get(heading, "")


def beyond(where, count, aim, what):
    """Notes a length beyond its aim; one beyond the slack is wrong."""
    words = f"{where} has {count} {what}: the aim is {aim}"
    if count > SLACK * aim:
        yield words
    elif count > aim:
        notes.append(words)


def would_change(kind, root, build):
    """A line for all that ./wb keep would change or could not mend."""
    stale = False
    tables = values.Tables(root, build)
    for one in keeping.KINDS[kind](root, tables):
        for words in one.changes + one.faults:
            yield f"{one.path.relative_to(root)}: {words}"
        stale |= bool(one.changes)
        notes.extend(set(one.notes) - set(notes))
    if stale:
        to_do.append(f"./wb keep {kind}")


def other_cases(where, chapter, printed):
    """A line where the cases that were drawn are not the kept ones. `printed` with WORKBOOK_DRAWN
    set: a digest of each test. A rounding error changes the eighth digit."""
    kept = json.loads(read(house.ROOT / "tests/checker/drawn.json")).get(chapter.folder, 0)
    found = [float(number) for number in re.findall(r"^drawn (\S+)$", printed, re.M)]
    if not math.isclose(sum(found), kept, rel_tol=1e-6):
        yield (f"{where}: the drawn cases of chapter {chapter.number} are not those of "
               f"tests/checker/drawn.json: the sum of their digests is {sum(found):.2f}, not "
               f"{kept}. Does a statement draw twice, outside braces?")


def folded(text):
    return " ".join(text.split())


def symbols_of(program):
    """What nm finds in a program, names as C++ writes them."""
    return subprocess.run(["nm", "-C", str(program)], capture_output=True, text=True).stdout


def programs_that_carry(build, first, symbols, at_least):
    """What is wrong with the programs of the chapters if only those from the first on may carry
    these symbols, and the first one carries at least some of them."""
    for chapter in house.chapters():
        program = f"{chapter.folder}_run"
        names = symbols_of(build / program)
        found = sorted(set(symbols.findall(names)))
        if "joints::" not in names:
            yield f"{program}: nm shows no symbols"
        elif chapter.number < first:
            yield from (f"{program} carries {symbol}" for symbol in found)
        elif chapter.number == first and not at_least <= set(found):
            yield f"{program} carries {found} only: are the symbols still called so?"


def main(document, proofs, arguments):
    """Runs the proofs of a file: NAME_test.py ROOT BUILD"""
    if len(arguments) != 2 or not all(Path(argument).is_dir() for argument in arguments):
        print(document.split("\n", maxsplit=1)[0], file=sys.stderr)
        return 2
    root, build = (Path(argument).resolve() for argument in arguments)
    house.ROOT = root
    broken = 0
    for proof in proofs:
        wrong = list(proof(root, build))
        broken += bool(wrong)
        print(f"{'WRONG' if wrong else 'holds'}  {proof.__doc__}")
        for line in wrong:
            print(f"         {line}")
    for note in notes:
        print(f"note   {note}")
    print(f"{len(proofs) - broken} of {len(proofs)} proofs hold")
    for command in to_do:
        print(f"what is kept is brought up to date by: {command}")
    return 1 if broken else 0
