"""The pictures of the texts, and the scripts that draw them. They are drawn in one process."""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from base import house
from keep.values import Wrong

MADE_BY = re.compile(r"Matplotlib v([\d.]+)")
SHOWN = re.compile(r"\]\((\w+\.svg)\)")


def pictures(root, tables):
    """(path, script, arguments before the path) of every picture."""
    measured = root / "bench" / "measured"
    for chapter in house.chapters():
        folder = chapter.text.parent
        shown = set(SHOWN.findall(chapter.text.read_text(encoding="utf-8")))
        for name in sorted((shown | {path.name for path in folder.glob("*.svg")}) - {"result.svg"}):
            yield folder / name, f"geometry_{chapter.number:02}.py", []
        yield (folder / "result.svg", f"chapter_{chapter.number:02}.py",
               ["--solution", tables.run(chapter.number, "")[0], "--result"])
    yield (root / "plots/front.svg", "front.py",
           ["--motion", tables.run(2, "")[0] / "chain.motion.json",
            "--csv", measured / "sweeps.csv", "--result"])
    yield (root / "plots/moving.svg", "moving.py",
           ["--motion", tables.run(8, "")[0] / "bridge.motion.json", "--result"])
    for name in ("architecture", "step"):
        yield root / f"docs/{name}.svg", "architecture.py", []
    yield root / "docs/beside.svg", "sweeps.py", ["--csv", measured / "sweeps.csv", "--out"]
    yield (root / "docs/convergence.svg", "convergence.py",
           ["--csv", measured / "convergence.csv", "--out"])
    for name, table in (("maps", "methods"), ("maps_energy", "methods"),
                        ("maps_motion", "trajectories")):
        yield (root / f"docs/{name}.svg", "methods.py",
               ["--csv", measured / f"{table}.csv", "--maps"])


def draw(root, jobs):
    """Draws (path, script, arguments) into a folder; yields (path, script, what was drawn)."""
    with tempfile.TemporaryDirectory() as folder:
        made = [Path(folder) / str(n) / path.name for n, (path, _, _) in enumerate(jobs)]
        for path in made:
            path.parent.mkdir()  # some scripts ask for the name
        lines = [json.dumps([script, *map(str, arguments), str(path)])
                 for path, (_, script, arguments) in zip(made, jobs)]
        result = subprocess.run([sys.executable, "-B", root / "plots" / "several.py"],
                                input="\n".join(lines), capture_output=True, text=True)
        if result.returncode:
            script = result.stdout.split()[-1:] or ["several.py"]
            raise Wrong(f"plots/{script[0]}: {result.stderr.strip()}")
        for path, (kept, script, _) in zip(made, jobs):
            yield kept, script, path.read_text(encoding="utf-8")


def redrawn(root, tables, only=lambda path: True):
    """(path, its text as it is drawn now, words) of every picture that would change; the versions
    of Matplotlib instead of a text where another one has drawn it, and would draw other bytes."""
    jobs = [job for job in pictures(root, tables) if only(job[0])]
    for path, script, now in draw(root, jobs):
        there = path.read_text(encoding="utf-8") if path.is_file() else ""
        kept, here = MADE_BY.findall(there), MADE_BY.findall(now)
        if there and kept and here and kept != here:
            yield path, None, f"drawn by Matplotlib {kept[0]}, here is {here[0]}"
        elif there != now:
            yield path, now, f"drawn anew by plots/{script}"
