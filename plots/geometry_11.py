#!/usr/bin/env python3
"""Chapter 11's drawings: a door in numbers (geometry), a chain that is pushed (push), the two
passes of the recursion (passes).

    python3 plots/geometry_11.py geometry.svg|push.svg|passes.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, CARD, EDGE, FAINT, INK, LEVER, arrow, below, body,
                     direction, dot, draw, line, title, turn, words)


def leaf(ax, hinge):
    """A door from above, ajar."""
    body(ax, hinge - (60, 0), (120, 34), 0, BODY1, rounding=4)
    body(ax, hinge + 80 * direction(48), (160, 16), 48, BODY2, rounding=6)
    dot(ax, hinge, INK, 10)


def rows(ax):
    """Left: a door by two bodies and the rows of a hinge."""
    title(ax, 170, "on rows: 12 numbers, 5 rows")
    hinge = np.array([150.0, 150.0])
    leaf(ax, hinge)
    for place, colour, beside in ((hinge - (80, 0), BODY1, (0, 68)),
                                  (hinge + 80 * direction(48), BODY2, (-70, 54))):
        for step in ((52, 0), (0, 52)):
            arrow(ax, place, place + step, INK, 1.6)
        dot(ax, place, colour)
        words(ax, place + beside, "6 numbers", colour, 12)
    words(ax, hinge + (14, -24), "less 5 rows", FAINT, 12, ha="left")
    below(ax, 170, "position and orientation of both bodies", 80)


def angle(ax):
    """Right: a door by its angle."""
    title(ax, 500, "by angles: 1 number")
    hinge = np.array([470.0, 150.0])
    leaf(ax, hinge)
    line(ax, hinge, hinge + (150, 0), FAINT, ":", 1.4)
    turn(ax, hinge, 90, 0, 40, LEVER, 3)
    words(ax, hinge + 116 * direction(22), "$x$", LEVER, 18)
    below(ax, 500, "there is no gap that could open", 80)


def across(ax):
    """Left: pushed across, a chain gives way at its joints."""
    title(ax, 170, "across: only the near bars come")
    start, length = np.array([64.0, 190.0]), 62
    for k in range(4):
        at = start + (k * length, 0)
        line(ax, at, at + (length - 4, 0), EDGE, "solid", 9, 1)
    place = start + (0, 56)
    for k, degrees in enumerate((-54, 12, -4, 1)):
        end = place + length * direction(degrees)
        line(ax, place, end, BODY2, "solid", 8)
        dot(ax, place, INK if k else ARROW, 8)
        place = end
    arrow(ax, start - (0, 70), start + (0, 48), ARROW, 4)
    words(ax, start + (12, -54), "push", ARROW, ha="left")
    below(ax, 170, "it feels light", 84)


def along(ax):
    """Right: pushed along, it comes as a whole."""
    title(ax, 510, "along: all of them come")
    start, length = np.array([440.0, 190.0]), 56
    for k in range(4):
        at = start + (k * length, 0)
        line(ax, at, at + (length, 0), BODY2, "solid", 8)
        dot(ax, at, INK if k else ARROW, 8)
    arrow(ax, start - (76, 0), start - (8, 0), ARROW, 4)
    words(ax, start + (-44, 20), "push", ARROW)
    below(ax, 510, "it feels like its whole mass", 84)


TREE = ((200, 92), (200, 162), (130, 226), (270, 226), (90, 298), (310, 298))
PARENTS = (None, 0, 1, 1, 2, 3)


def bodies(ax, shift, said, colour, inward, ends):
    """A tree of bodies with an arrow at every joint, towards the root or away from it."""
    title(ax, 200 + shift, said)
    places = [np.array(place, float) + (shift, 0) for place in TREE]
    for one, parent in zip(places, PARENTS):
        if parent is not None:
            way = places[parent] - one if inward else one - places[parent]
            step = 19 * way / np.linalg.norm(way)
            start = one if inward else places[parent]
            arrow(ax, start + step, start + way - step, colour, 3)
    for k, place in enumerate(places):
        ax.plot(*place, "o", color=BODY1 if k == 0 else CARD, markersize=19,
                markeredgecolor=BODY1 if k == 0 else INK, markeredgewidth=1.6, zorder=5)
    words(ax, places[0] + (46, 0), "wall", BODY1, 12)
    words(ax, places[-1] + (0, 24), "leaf", INK, 12)
    words(ax, places[4] + (0, 24), "leaf", INK, 12)
    below(ax, 200 + shift, ends, 48)


def inward(ax):
    """Left: from the leaves to the wall."""
    bodies(ax, -30, "first inward: how heavy?", BODY2, True, "each adds its children's inertia")


def outward(ax):
    """Right: from the wall to the leaves."""
    bodies(ax, 310, "then outward: how fast?", LEVER, False, "each gets its parent's acceleration")


if __name__ == "__main__":
    draw(__doc__, "geometry_11", geometry=((rows, angle), (0, 670, 56, 376), 340),
         push=((across, along), (0, 690, 60, 376), 340),
         passes=((inward, outward), (0, 680, 24, 376), 340))
