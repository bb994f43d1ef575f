#!/usr/bin/env python3
"""Chapter 9's drawing: a chain, a loop and a star of bodies, and the matrix of the joints of each.

    python3 plots/geometry_09.py OUT.svg
"""
import sys
from pathlib import Path

import numpy as np
from drawing import ARROW, BODY1, BODY2, CARD, EDGE, FAINT, INK, draw, named, title, words
from matplotlib.patches import Circle, Rectangle

COUNT = 5  # joints
CELL = 26.0


def bodies(ax, places, links, fixed=(), radius=13.0):
    """Bodies as discs, joints as numbered dots halfway between two of them."""
    for number, (a, b) in enumerate(links, 1):
        ends = np.array([places[a], places[b]])
        ax.plot(*ends.T, color=FAINT, linewidth=1.6, zorder=1)
    for k, place in enumerate(places):
        if k in fixed:
            ax.add_patch(Rectangle(place - radius * 0.8, 1.6 * radius, 1.6 * radius, zorder=2,
                                   facecolor=EDGE, edgecolor=FAINT, linewidth=1.5, hatch="////"))
        else:
            ax.add_patch(Circle(place, radius, facecolor=named("free-body"), edgecolor=BODY1,
                                linewidth=2, zorder=2))
    for number, (a, b) in enumerate(links, 1):
        middle = (places[a] + places[b]) / 2
        ax.add_patch(Circle(middle, 8.5, facecolor=ARROW, edgecolor=CARD, linewidth=1, zorder=4))
        words(ax, middle, str(number), "white", 10.5, weight="bold")


def matrix(ax, corner, own, filled):
    """The blocks on and below the diagonal, with the numbers of the joints beside them."""
    x, y = corner  # its upper left
    for i in range(COUNT):
        for j in range(COUNT):
            colour = INK if i == j or (i + 1, j + 1) in own else \
                BODY2 if (i + 1, j + 1) in filled else None
            if (i >= j) or colour:
                ax.add_patch(Rectangle((x + j * CELL + 1.5, y - (i + 1) * CELL + 1.5), CELL - 3,
                                       CELL - 3, linewidth=0,
                                       facecolor=colour or named("no-block")))
        words(ax, (x - 12, y - (i + 0.5) * CELL), str(i + 1), ARROW, 10.5, weight="bold")
        words(ax, (x + (i + 0.5) * CELL, y + 11), str(i + 1), ARROW, 10.5, weight="bold")


def panel(ax, middle, kind, places, links, own, filled, said, fixed=()):
    title(ax, middle, kind)
    bodies(ax, [np.array(place) + (middle, 270) for place in places], links, fixed)
    matrix(ax, (middle - COUNT * CELL / 2 + 6, 186), own, filled)
    words(ax, (middle, 28), said, FAINT, 10.5)


def chain(ax):
    places = [(-88 + 35 * k, 22 * (-1) ** k) for k in range(COUNT + 1)]
    panel(ax, 122, "a chain", places, [(k, k + 1) for k in range(COUNT)],
          {(k + 1, k) for k in range(1, COUNT)}, (), "neighbours only", fixed=(0,))


def loop(ax):
    angles = np.radians(90 + 72 * np.arange(COUNT))
    places = [(56 * np.cos(a), 50 * np.sin(a) - 3) for a in angles]
    panel(ax, 350, "a loop", places, [(k, (k + 1) % COUNT) for k in range(COUNT)],
          {(k + 1, k) for k in range(1, COUNT)} | {(COUNT, 1)}, {(COUNT, 2), (COUNT, 3)},
          "1 meets 5: two fill in")


def star(ax):
    angles = np.radians(90 + 72 * np.arange(COUNT))
    places = [(0, -3)] + [(60 * np.cos(a), 54 * np.sin(a) - 3) for a in angles]
    panel(ax, 578, "a star", places, [(0, k) for k in range(1, COUNT + 1)],
          {(i, j) for i in range(1, COUNT + 1) for j in range(1, i)}, (),
          "one hub: all are neighbours")


if __name__ == "__main__":
    if Path(sys.argv[-1]).stem == "zigzag":
        import zigzag_09
        zigzag_09.picture(__doc__)
    else:
        draw(__doc__, "geometry_09", geometry=((chain, loop, star), (0, 700, 0, 380), 236, 464))
