"""The pictures of the texts are what their scripts draw today: pictures_test.py ROOT BUILD"""
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from proofs import house, main, notes, read

from keep import tied

MOST_BYTES = 60_000  # of a result: it is read on a code host, over a network
MADE_BY = re.compile(r"Matplotlib v([\d.]+)")


def differences(root, pairs, jobs):
    """A line for every kept file that is not, byte for byte, what was drawn now."""
    for (kept, made), (script, *arguments) in zip(pairs, jobs):
        result = subprocess.run([sys.executable, "-B", root / "plots" / script, *arguments],
                                capture_output=True, text=True)
        there, now = read(kept), read(made)
        again = f"python3 plots/{script} " + " ".join(
            str(kept.relative_to(root) if word == made else word) for word in arguments)
        if result.returncode:
            yield result.stderr.strip()
        elif not there:
            yield f"{kept.relative_to(root)} is missing; draw it: {again}"
        elif MADE_BY.findall(there) != MADE_BY.findall(now):
            yield from skipped(MADE_BY.findall(there), MADE_BY.findall(now))
        elif there != now:
            yield f"{kept.relative_to(root)} is not what its script draws; draw it anew: {again}"


def skipped(kept, here):
    """Another Matplotlib draws other bytes: says so, once; a drawing of none is wrong."""
    if not kept or not here:
        yield f"drawn by Matplotlib {kept}, here by {here}: which is none"
    said = f"kept pictures of Matplotlib {kept}, here is {here}: their bytes were not compared"
    if said not in notes:
        notes.append(said)


def geometry_is_what_its_script_draws(root, build):
    """the drawings of every chapter, all but its result, are what their script draws"""
    with tempfile.TemporaryDirectory() as folder:
        pairs, jobs = [], []
        for chapter in house.chapters():
            drawings = {path.name for path in chapter.text.parent.glob("*.svg")} - {"result.svg"}
            for name in sorted(drawings | {"geometry.svg"}):
                made = Path(folder) / str(chapter.number) / name  # some scripts ask for the name
                made.parent.mkdir(exist_ok=True)
                pairs.append((chapter.text.parent / name, made))
                jobs.append((f"geometry_{chapter.number:02}.py", made))
        yield from differences(root, pairs, jobs)


def results_are_drawn_from_what_the_programs_measure(root, build):
    """the result of every chapter is drawn from what its program writes, and is small"""
    tables = tied.Tables(root, build)
    with tempfile.TemporaryDirectory() as folder:
        pairs, jobs = [], []
        for chapter in house.chapters():
            kept = chapter.text.parent / "result.svg"
            if "](result.svg)" not in read(chapter.text):
                yield f"{chapter.folder}/README.md does not show result.svg"
                continue
            made = Path(folder) / f"{chapter.number}.svg"
            try:
                measured, _ = tables.run(chapter.number, "")
            except tied.Wrong as wrong:
                yield f"{chapter.folder}: {wrong}"
                continue
            pairs.append((kept, made))
            jobs.append((f"chapter_{chapter.number:02}.py", "--solution", measured,
                         "--result", made))
            if len(read(kept)) > MOST_BYTES:
                yield f"{kept.relative_to(root)} has {len(read(kept))} bytes: at most {MOST_BYTES}"
        yield from differences(root, pairs, jobs)


def kept_tables_are_drawn(root, build):
    """the figures of docs/ are drawn from the measurements that are kept"""
    measured = root / "bench" / "measured"
    with tempfile.TemporaryDirectory() as folder:
        pairs, jobs = [], []
        for name, script, table, option in (("beside.svg", "peers.py", "peers.csv", "--together"),
                                            ("maps.svg", "methods.py", "methods.csv", "--maps")):
            made = Path(folder) / name
            pairs.append((root / "docs" / name, made))
            jobs.append((script, "--csv", measured / table, option, made))
        yield from differences(root, pairs, jobs)


PROOFS = [geometry_is_what_its_script_draws, results_are_drawn_from_what_the_programs_measure,
          kept_tables_are_drawn]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
