#!/usr/bin/env python3
"""Chapter 11's drawing: a door in numbers, a chain that is pushed, the two passes of the recursion.

    python3 plots/geometry_11.py OUT.svg
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, CARD, FAINT, INK, arrow, body, dot, draw, named, words
from matplotlib.patches import Arc

LEVER = named("lever")


def direction(degrees):
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def door(ax):
    """Left: a door from above, and its one number."""
    words(ax, (125, 352), "a door from above", size=12.5, weight="bold")
    hinge, turn, width = np.array([52.0, 150.0]), 48, 130
    body(ax, hinge + (-6, 60), (26, 130), 0, BODY1)
    ax.plot(*zip(hinge, hinge + (width, 0)), color=FAINT, linewidth=1.4, linestyle=":")
    body(ax, hinge + width / 2 * direction(turn), (width, 16), turn, BODY2)
    dot(ax, hinge, INK, 9)
    ax.add_patch(Arc(hinge, 130, 130, theta1=0, theta2=turn - 6, color=LEVER, linewidth=2))
    tip = hinge + 65 * direction(turn - 6)
    arrow(ax, tip - direction(turn + 80), tip + 6 * direction(turn + 86), LEVER)
    words(ax, hinge + 84 * direction(turn / 2), "$x$", LEVER, 15)
    words(ax, (125, 88), "two bodies: 12 numbers", FAINT, 11.5)
    words(ax, (125, 62), "less five rows of $J$", FAINT, 11.5)
    words(ax, (125, 30), "or one angle", LEVER, 12)


def push(ax):
    """Middle: a hand pushes a chain across: only the near bars follow."""
    words(ax, (372, 352), "how heavy is a chain?", size=12.5, weight="bold")
    start, length = np.array([282.0, 222.0]), 44
    for k in range(4):
        at = start + (k * length + 8, 0)
        ax.plot(*zip(at, at + (length, 0)), color=FAINT, linewidth=7, alpha=0.35,
                solid_capstyle="round")
    place = start + (8, 38)
    for k, degrees in enumerate((-52, 14, -4, 1)):
        end = place + length * direction(degrees)
        ax.plot(*zip(place, end), color=BODY2, linewidth=7, alpha=0.75, solid_capstyle="round")
        dot(ax, place, INK if k else ARROW, 7)
        place = end
    arrow(ax, start + (8, -42), start + (8, 30), ARROW, 3)
    words(ax, start + (34, -34), "across:", ARROW, 12, ha="left")
    words(ax, start + (34, -54), "the far ones stay", FAINT, 11, ha="left")
    arrow(ax, (282, 96), (330, 96), ARROW, 3)
    for k in range(3):
        at = np.array([338.0 + k * 36, 96.0])
        ax.plot(*zip(at, at + (34, 0)), color=BODY2, linewidth=7, alpha=0.75,
                solid_capstyle="round")
        dot(ax, at, INK, 7)
    words(ax, (372, 66), "along: all of them come", FAINT, 11)
    words(ax, (372, 30), "a matrix, not a number", INK, 11.5)


def passes(ax):
    """Right: inward and outward."""
    words(ax, (612, 352), "two passes", size=12.5, weight="bold")
    places = [np.array(p, float) for p in ((612, 84), (612, 160), (560, 236), (664, 236),
                                           (534, 306), (690, 306))]
    parents = (None, 0, 1, 1, 2, 3)
    for k, parent in enumerate(parents):
        if parent is None:
            continue
        one, two = places[parent], places[k]
        along = (two - one) / np.linalg.norm(two - one)
        across = np.array([-along[1], along[0]])
        arrow(ax, two - 17 * along + 7 * across, one + 17 * along + 7 * across, BODY2, 2.2)
        arrow(ax, one + 17 * along - 7 * across, two - 17 * along - 7 * across, LEVER, 2.2)
    for k, place in enumerate(places):
        ax.plot(*place, "o", color=BODY1 if k == 0 else CARD, markersize=17,
                markeredgecolor=BODY1 if k == 0 else INK, markeredgewidth=1.6, zorder=5)
    words(ax, places[0] + (52, 0), "root", BODY1, 12)
    words(ax, (612, 44), "inward: inertia, bias", BODY2, 11.5)
    words(ax, (612, 22), "outward: accelerations", LEVER, 11.5)


if __name__ == "__main__":
    draw(__doc__, "geometry_11", (door, push, passes), (252, 492), 726)
