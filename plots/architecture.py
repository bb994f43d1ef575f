#!/usr/bin/env python3
"""The drawing of docs/architecture.md: the calls of a step, and the includes.

    python3 plots/architecture.py OUT.svg

The arrows of the right half are read off the sources: an include that goes another way changes the
drawing, and a proof of the workbook's tests compares the two.
"""
import sys
from pathlib import Path

import drawing
import layers
from drawing import BODY1, BODY2, CARD, FAINT, INK, arrow, draw, words
from matplotlib.patches import FancyBboxPatch

ROOT = Path(__file__).absolute().parent.parent

# For each group of folders: the place of its box, and the words below its name.
GROUPS = {"tests": (776, 436, "the proofs"),
          "live": (620, 384, "docs/live"),
          "bench": (620, 332, "error and time"),
          "programs": (620, 280, "chapters/*/program"),
          "library": (470, 384, "joints.h, packages"),
          "comparison": (470, 332, "all methods"),
          "joints": (420, 228, "what a user adds"),
          "contacts": (556, 228, "ground, points"),
          "direct": (692, 228, "the direct solver"),
          "reduced": (470, 280, "trees without rows"),
          "solutions": (335, 280, "the exercises"),
          "chapters": (450, 176, "texts and parts"),
          "instruments": (640, 176, "measuring"),
          "checker": (776, 124, "parts, differences"),
          "steps": (560, 124, "other ways to step"),
          "kept": (620, 72, "saving, reactions"),
          "simd": (420, 72, "engine/simd"),
          "core": (510, 24, "engine/*: bodies, blocks, step, solvers")}
WIDE = {"core": 290}
HIGH, LOW = 42, 34  # boxes of the step and of the groups


def box(ax, place, size, name, below, colour):
    (x, y), (width, height) = place, size
    ax.add_patch(FancyBboxPatch((x - width / 2, y - height / 2), width, height, facecolor=CARD,
                                edgecolor=colour, linewidth=1.6, zorder=5,
                                boxstyle="round,pad=0,rounding_size=8"))
    words(ax, (x, y + 6), name, size=10.5, weight="bold")
    words(ax, (x, y - 8), below, FAINT, size=8)


def cycle(ax):
    """Left: the path of a step."""
    words(ax, (125, 440), "a step", size=12.5, weight="bold")
    stations = [("Body", "poses, velocities", 300), ("Joint", "rows of two bodies", 232),
                ("Block", "rows J, errors C, targets", 164),
                ("Solver", "computes the impulses", 96)]
    for k, (name, below, y) in enumerate(stations):
        box(ax, (125, y), (170, HIGH), name, below, (BODY1, BODY2)[k % 2])
        if k:
            arrow(ax, (125, stations[k - 1][2] - HIGH / 2), (125, y + HIGH / 2), INK, 1.6)
    ax.plot((125, 125, 24, 24, 38), (96 - HIGH / 2, 46, 46, 300, 300), color=INK, linewidth=1.6)
    arrow(ax, (32, 300), (40, 300), INK, 1.6)
    words(ax, (131, 60), "velocities, then poses", FAINT, 7.8, ha="left")


def groups(ax):
    """Right: the includes between the groups."""
    words(ax, (300, 440), "includes between folders", size=12.5, weight="bold", ha="left")
    for name, (x, y, below) in GROUPS.items():
        box(ax, (x, y), (WIDE.get(name, 128), LOW), name, below, FAINT)
    for user, used in sorted(layers.direct(layers.includes(ROOT))):
        (x1, y1, _), (x2, y2, _) = GROUPS[user], GROUPS[used]
        reach = WIDE.get(used, 128) / 2 - 14
        end = min(max(x1, x2 - reach), x2 + reach)
        start = min(max(end, x1 - 50), x1 + 50)
        arrow(ax, (start, y1 - LOW / 2), (end, y2 + LOW / 2), INK, 1.3)
        ax.texts[-1].arrow_patch.set_gid(f"{user} includes {used}")


if __name__ == "__main__":
    drawing.HEIGHT = 462
    draw(__doc__, "architecture", [cycle, groups], [258], 850)
