#!/usr/bin/env python3
"""Writes a page that plays recorded motions: docs/motion.html with the recordings put into it.

    motion.py PAGE.html --title "Chapter 1: distance" --solution DIR [--mine DIR]

Every *.motion.json in the solution's folder becomes a scene of the page, in the order in which the
program wrote them; where the learner's folder has a recording of the same name, the two play side
by side.
"""
import argparse
import base64
import json
import re
import sys
from math import isfinite
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from pictures import pages  # noqa: E402

TEMPLATE = Path(__file__).absolute().parents[2] / "docs" / "motion.html"


class MotionError(Exception):
    """What is wrong with the input, in one line."""


def check(good, what):
    if not good:
        raise ValueError(what)


def read_run(path, label):
    """One recording, checked, up to its first frame that is not made of ordinary numbers."""
    try:
        # C++ prints nan, -nan and inf; Python reads NaN; a browser reads neither.
        text = re.sub(r"(?<=[\[,])-?(nan|inf)(?=[,\]])", "NaN", path.read_text(encoding="utf-8"))
        whole = json.loads(text)
        run = {key: whole[key] for key in ("title", "dt", "bodies", "lines", "frames", "readings")}
        count, frames = len(run["bodies"]), run["frames"]
        check(isinstance(run["title"], str), "its title is not a text")
        check(isfinite(run["dt"]) and run["dt"] > 0, "dt is not a positive number")
        for body in run["bodies"]:
            check(body["kind"] in ("box", "ball"), f"no body is a {body['kind']!r}")
            check(isinstance(body.get("label", ""), str), "a label is not a text")
            check(len(body["size"]) == 3 and all(map(isfinite, body["size"])), "a size is wrong")
        for one, anchor1, two, anchor2 in run["lines"]:
            check({one, two} <= set(range(count)), "a line names a body that does not exist")
            check(len(anchor1) == len(anchor2) == 3 and all(map(isfinite, anchor1 + anchor2)),
                  "an anchor is wrong")
        check(count and frames, "it has no frames")
        check(all(len(frame) == 7 * count for frame in frames), "a frame is too short or too long")
        readings = run["readings"]
        check(len(readings) == len(frames), "there is not one list of readings for each frame")
        names = [of for of, _, _ in readings[0]]
        check(all(isinstance(of, str) for of in names), "a reading is not of a scene")
        check(all([of for of, _, _ in row] == names for row in readings), "readings change names")
        bad = next((i for i, frame in enumerate(frames) if not all(map(isfinite, frame))), None)
    except OSError as error:
        raise MotionError(f"cannot read {path}: {error.strerror}") from error
    except KeyError as error:
        raise MotionError(f"{path} is broken: {error} is missing") from error
    except (ValueError, TypeError, OverflowError) as error:
        raise MotionError(f"{path} is broken: {error}") from error
    if bad is not None:
        run.update(stopped=bad * run["dt"], frames=frames[:bad], readings=readings[:bad])
    return {"label": label, **run}


def coded(numbers):
    """Whole numbers as text, the small ones short: seven bits a byte, the sign in the lowest."""
    out = bytearray()
    for number in numbers:
        rest = 2 * number if number >= 0 else -2 * number - 1
        while rest > 127:
            out.append(rest & 127 | 128)
            rest >>= 7
        out.append(rest)
    return base64.b64encode(out).decode()


def packed(run):
    """A run for the page: frames in whole ten-thousandths, each less what the two before let
    expect; of readings the gaps and the energy gained since the first frame, to the digits
    that are shown."""
    frames = [[round(1e4 * x) for x in frame] for frame in run["frames"]]
    none = [0] * len(frames[0])
    changes = [c - 2 * b + a for three in zip([none, none, *frames], [none, *frames], frames)
               for a, b, c in zip(*three)]

    def rounded(number, digits):
        return float(f"{number:.{digits}g}") if isfinite(number) else None
    whole = {key: value for key, value in run.items() if key not in ("frames", "readings")}
    return {**whole, "changes": coded(changes), "of": [of for of, _, _ in run["readings"][0]],
            "readings": [[cell for (_, gap, energy), first in zip(row, run["readings"][0])
                          for cell in (rounded(gap, 2), rounded(energy - first[2], 3))]
                         for row in run["readings"]]}


def write_page(page, title, solution_dir, mine_dir=None, back=None, watch=None,
               beside=""):
    """Writes the page. Raises MotionError when there is nothing to show or a file is broken.

    `back` is a link beside the heading: {"href": where it leads, "textContent": its words}.
    `watch` says for each scene by its name what there is to see; `beside`, where three.js lies, if
    not in the page.
    """
    folders = [(Path(folder), label) for folder, label in
               ((mine_dir, "yours"), (solution_dir, "the solution")) if folder is not None]
    for folder, _ in folders:
        if not folder.is_dir():
            raise MotionError(f"there is no folder {folder}")
    scenes = []
    recordings = Path(solution_dir).glob("*.motion.json")
    for path in sorted(recordings, key=lambda one: (one.stat().st_mtime_ns, one.name)):
        runs = [read_run(folder / path.name, label) for folder, label in folders
                if (folder / path.name).exists()]
        if any(run["frames"] for run in runs):
            name = path.name[:-len(".motion.json")]
            scenes.append({"name": name, "title": runs[-1]["title"] or name,
                           "watch": (watch or {}).get(name, ""), "runs": list(map(packed, runs))})
    if not scenes:
        raise MotionError(f"nothing to show: no *.motion.json with a good frame in {solution_dir}")
    data = {"title": title, **({"back": back} if back else {}), "scenes": scenes}
    try:
        Path(page).parent.mkdir(parents=True, exist_ok=True)
        Path(page).write_text(pages.filled(TEMPLATE, data, beside), encoding="utf-8")
    except OSError as error:
        raise MotionError(f"cannot write {page}: {error.strerror}") from error


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
        sys.exit(2)


if __name__ == "__main__":
    main()
