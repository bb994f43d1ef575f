#!/usr/bin/env python3
"""Chapter 5's drawings: the load of a welded beam (geometry); an impulse at a far anchor and the
answer of the lock (fight).

    python3 plots/geometry_05.py geometry.svg|fight.svg
"""
import numpy as np
from drawing import (ARROW, BODY2, INK, arrow, below, body, dot, draw, line, measure, title,
                     turn, wall, words)


def load(ax):
    """A beam, its weight, and the load at the wall."""
    title(ax, 230, "a weld carries a force and a torque")
    edge, left, y, cubes = 58, 112.0, 190.0, 5
    wall(ax, left, y - 85, y + 85)
    for k in range(cubes):
        body(ax, (left + (k + 0.5) * edge, y), (edge - 3, edge - 3), 0, BODY2, rounding=6)
    p, middle = (left, y), (left + cubes * edge / 2, y)
    arrow(ax, p, (left, y + 100), INK, 3)
    turn(ax, p, 44, -70, 55, INK)
    arrow(ax, middle, (middle[0], y - 104), ARROW, 3)
    dot(ax, p, INK)
    dot(ax, middle, ARROW)
    words(ax, (left + 14, y + 96), "force $F = n\\,m\\,g$", ha="left")
    words(ax, (left + 56, y + 48), "torque $\\tau_p = n^2 m\\,g\\,\\ell/2$", ha="left")
    words(ax, (middle[0] + 12, y - 96), "weight $n\\,m\\,g$", ARROW, ha="left")
    words(ax, (left - 8, y), "$p$", size=13, ha="right")
    measure(ax, (left, y - 52), (middle[0], y - 52), "$n\\ell/2$", (0, -14), size=12)
    below(ax, 230, "$n$ cubes of mass $m$ and edge $\\ell$, welded to a wall")


def cube_and_wall(ax, shift):
    """A cube and its anchor p, at the end of a long lever, beside the wall; where both are."""
    p, x = np.array([62.0 + shift, 190.0]), np.array([252.0 + shift, 190.0])
    wall(ax, p[0] - 10, 90, 290)
    line(ax, p, x, BODY2, "solid", 2.4)
    body(ax, x, (84, 84), 0, BODY2)
    dot(ax, p, BODY2)
    words(ax, p + (12, -14), "$p$")
    words(ax, x - (0, 58), "body 2", BODY2, 12)
    return p, x


def point(ax):
    """Left: the impulse that stops the anchor rotates the cube."""
    title(ax, 166, "1. the point stops its anchor")
    p, x = cube_and_wall(ax, 0)
    arrow(ax, p, p + (0, 84), ARROW, 3.4)
    turn(ax, x, 66, 160, 100, BODY2, 3)
    words(ax, p + (12, 74), "impulse $P$", ARROW, ha="left")
    below(ax, 166, "the cube rotates", colour=BODY2)


def lock(ax):
    """Right: the lock stops the rotation, and the anchor falls as before."""
    title(ax, 508, "2. the lock stops the rotation")
    p, x = cube_and_wall(ax, 342)
    arrow(ax, p, p - (0, 84), INK, 3)
    turn(ax, x, 66, 100, 160, ARROW, 3.4)
    words(ax, p + (12, -74), "falls again", INK, ha="left")
    words(ax, x + (-34, 82), "angular impulse $T$", ARROW)
    below(ax, 508, "the anchor falls again, nearly as fast")


if __name__ == "__main__":
    draw(__doc__, "geometry_05", geometry=((load,), (0, 460, 6, 376)),
         fight=((point, lock), (0, 670, 6, 376), 332))
