#!/usr/bin/env python3
"""Writes a page that plays recorded motions: docs/motion.html with the recordings put into it.

    motion.py PAGE.html --title "Chapter 1: distance" --solution DIR [--mine DIR]

Every *.motion.json in the solution's folder becomes a scene of the page; where the learner's folder
has a recording of the same name, the two play side by side.
"""
import argparse
import json
import math
import re
import sys
from pathlib import Path

TEMPLATE = Path(__file__).resolve().parent.parent / "docs" / "motion.html"
SLOT = ">PLACEHOLDER<"


class MotionError(Exception):
    """What is wrong with the input, in one line."""


def read_run(path, label):
    """One recording, checked, up to its first frame that is not made of ordinary numbers."""
    try:
        text = path.read_text(encoding="utf-8")
        # C++ prints nan, -nan and inf; Python reads NaN; a browser reads neither.
        run = json.loads(re.sub(r"(?<=[\[,])-?(nan|inf)(?=[,\]])", "NaN", text))
        run = {key: run[key] for key in ("title", "dt", "bodies", "lines", "frames")}
        bodies = len(run["bodies"])
        good = isinstance(run["title"], str) and math.isfinite(run["dt"]) and run["dt"] > 0
        good = good and all(body["kind"] in ("box", "ball") and len(body["size"]) == 3 and
                            all(0 < edge < math.inf for edge in body["size"])
                            for body in run["bodies"])
        good = good and all(one in range(bodies) and two in range(bodies) and
                            len(anchor1) == len(anchor2) == 3 and
                            all(map(math.isfinite, anchor1 + anchor2))
                            for one, anchor1, two, anchor2 in run["lines"])
        good = good and bodies > 0 and len(run["frames"]) > 0
        good = good and all(len(frame) == 7 * bodies for frame in run["frames"])
        finite = [all(map(math.isfinite, frame)) for frame in run["frames"]]
    except OSError as error:
        raise MotionError(f"cannot read {path}: {error.strerror}") from error
    except (ValueError, KeyError, TypeError, AttributeError, OverflowError) as error:
        raise MotionError(f"{path} is not a whole recording ({error!r})") from error
    if not good:
        raise MotionError(f"{path} is not a whole recording")
    run["label"] = label
    if not all(finite):
        run["stopped"] = finite.index(False) * run["dt"]
        del run["frames"][finite.index(False):]
    return run


def write_page(page, title, solution_dir, mine_dir=None):
    """Writes the page. Raises MotionError when there is nothing to show or a file is broken."""
    folders = [(Path(folder), label) for folder, label in
               ((mine_dir, "yours"), (solution_dir, "the solution")) if folder is not None]
    for folder, _ in folders:
        if not folder.is_dir():
            raise MotionError(f"no folder {folder}")
    scenes = []
    for path in sorted(Path(solution_dir).glob("*.motion.json")):
        runs = [read_run(folder / path.name, label) for folder, label in folders
                if (folder / path.name).exists()]
        if any(run["frames"] for run in runs):
            name = path.name[:-len(".motion.json")]
            scenes.append({"name": name, "title": runs[-1]["title"] or name, "runs": runs})
    if not scenes:
        raise MotionError(f"nothing to show: no *.motion.json with a frame in {solution_dir}")
    data = json.dumps({"title": title, "scenes": scenes}, separators=(",", ":"), allow_nan=False)
    try:
        template = TEMPLATE.read_text(encoding="utf-8")
        before, after = template.split(SLOT)
        # Inside a script element a "<" could end it early; \u003c is the same to JSON.
        data = data.replace("<", "\\u003c")
        Path(page).parent.mkdir(parents=True, exist_ok=True)
        Path(page).write_text(f"{before}>{data}<{after}", encoding="utf-8")
    except OSError as error:
        raise MotionError(f"cannot write {page}: {error}") from error


def main():
    parser = argparse.ArgumentParser(description="Writes a page that plays recorded motions.")
    parser.add_argument("page", help="the page to write")
    parser.add_argument("--title", default="Motion", help="heading of the page")
    parser.add_argument("--solution", required=True, metavar="DIR",
                        help="folder with the solution's *.motion.json")
    parser.add_argument("--mine", metavar="DIR", help="folder with yours, by the same names")
    arguments = parser.parse_args()
    try:
        write_page(arguments.page, arguments.title, arguments.solution, arguments.mine)
    except MotionError as error:
        print(f"motion: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main())
