#!/usr/bin/env python3
"""The drawings of docs/architecture.md: what a step does (step), and which folders stand on which
(architecture).

    python3 plots/architecture.py architecture.svg|step.svg

The levels of the folders are read off the sources: an include that goes another way changes the
drawing, and a proof of the workbook's tests compares the two.
"""
from pathlib import Path

import layers
from drawing import ARROW, BODY1, BODY2, CARD, FAINT, INK, arrow, below, draw, line, title, words
from matplotlib.patches import FancyBboxPatch

ROOT = Path(__file__).absolute().parent.parent

# Each group of folders, and the words below its name.
GROUPS = {"tests": "everything is tested", "live": "the live page", "library": "one include",
          "bench": "error and time", "comparison": "all methods", "programs": "one a chapter",
          "reduced": "trees without rows", "joints": "finished joints",
          "contacts": "ground, points", "direct": "the direct solver",
          "solutions": "the answers", "chapters": "the exercises", "instruments": "measuring",
          "steps": "other ways to step", "checker": "checks a part",
          "kept": "saves, validates", "simd": "SIMD lanes", "rotation": "free rotation",
          "parts": "what a part is", "core": "engine/*: bodies, blocks, step, solvers"}
ENGINE = ("core", "kept", "parts", "rotation", "simd", "steps", "instruments")
EXERCISES = ("chapters", "solutions")


def box(ax, place, size, name, said, colour, gid=None):
    (x, y), (width, height) = place, size
    ax.add_patch(FancyBboxPatch((x - width / 2, y - height / 2), width, height, facecolor=CARD,
                                edgecolor=colour, linewidth=1.8, zorder=5, gid=gid,
                                boxstyle="round,pad=0,rounding_size=8"))
    words(ax, (x, y + 7), name, size=11.5, weight="bold")
    words(ax, (x, y - 8), said, FAINT, size=9)


def cycle(ax):
    """The path of a step."""
    title(ax, 380, "one step goes round once")
    stations = (("Body", "pose and velocity"), ("Joint", "knows the geometry"),
                ("Block", "plain numbers"), ("Solver", "finds the impulses"))
    for k, (name, said) in enumerate(stations):
        box(ax, (92 + 192 * k, 286), (136, 48), name, said, BODY1)
        if k:
            arrow(ax, (160 + 192 * (k - 1), 286), (24 + 192 * k, 286), INK)
            words(ax, (188 + 192 * (k - 1), 302), ("poses", "C and J", "rows")[k - 1], FAINT, 10)
    line(ax, (668, 262), (668, 222), INK, "solid", 2.2)
    line(ax, (668, 222), (92, 222), INK, "solid", 2.2)
    arrow(ax, (92, 222), (92, 262), INK)
    below(ax, 380, "impulses change the velocities, and these move the bodies", 206)


def levels(ax):
    """Every group on its level, which is above all that it includes."""
    top = 112 + 52 * max(layers.levels(ROOT).values())
    title(ax, 340, "a folder includes only what stands below it", top)
    for name, level in sorted(layers.levels(ROOT).items()):
        row = [other for other in GROUPS if layers.levels(ROOT)[other] == level]
        place = (360 + 152 * (row.index(name) - (len(row) - 1) / 2), 52 + 52 * level)
        box(ax, place, (290 if name == "core" else 144, 40), name, GROUPS[name],
            BODY1 if name in ENGINE else BODY2 if name in EXERCISES else FAINT,
            f"{name} on level {level}")
    arrow(ax, (28, top - 30), (28, 40), ARROW, 3)
    words(ax, (14, 255), "includes", ARROW, 12, rotation=90)
    for k, (text, colour) in enumerate((("the engine", BODY1), ("the exercises", BODY2),
                                        ("tools and uses", FAINT))):
        words(ax, (180 + 170 * k, top - 20), f"\N{BLACK SQUARE} {text}", colour, 10.5,
              weight="bold")


if __name__ == "__main__":
    draw(__doc__, "architecture", step=((cycle,), (0, 760, 190, 376)),
         architecture=((levels,), (0, 690, 20, 134 + 52 * max(layers.levels(ROOT).values()))))
