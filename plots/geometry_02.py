#!/usr/bin/env python3
"""Chapter 2's drawings: two bodies, their levers and the gap, and the velocity of a turning anchor;
two rows that undo part of each other's work.

    python3 plots/geometry_02.py geometry.svg|fight.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, FAINT, INK, arrow, below, body, dot, draw, line, title,
                     turn, words)


def gap(ax):
    """Left: x, r, p of both bodies, and u from p1 to p2."""
    title(ax, 210, "the gap: $u = p_2 - p_1$")
    x1, p1 = np.array([100.0, 150.0]), np.array([171.0, 186.0])
    x2, p2 = np.array([316.0, 198.0]), np.array([251.0, 257.0])
    body(ax, x1, (156, 124), 20, BODY1)
    body(ax, x2, (166, 128), -22, BODY2)
    arrow(ax, x1, p1)
    arrow(ax, x2, p2)
    arrow(ax, p1, p2, INK, 3)
    for place, colour in ((x1, BODY1), (p1, BODY1), (x2, BODY2), (p2, BODY2)):
        dot(ax, place, colour)
    words(ax, (90, 133), "$x_1$", BODY1)
    words(ax, (328, 182), "$x_2$", BODY2)
    words(ax, (195, 179), "$p_1$", BODY1)
    words(ax, (241, 276), "$p_2$", BODY2)
    words(ax, (130, 183), "$r_1$", ARROW)
    words(ax, (296, 238), "$r_2$", ARROW)
    words(ax, (196, 232), "$u$", INK, 15)
    words(ax, (60, 246), "body 1", BODY1, 12)
    words(ax, (348, 302), "body 2", BODY2, 12)
    below(ax, 210, "closed: $u = 0$, which is three numbers")


def turning(ax):
    """Right: the velocity of an anchor is the centre's plus that of the rotation."""
    title(ax, 562, "a point's velocity: $v + \\omega \\times r$")
    x, p = np.array([524.0, 150.0]), np.array([588.0, 184.0])
    v = np.array([62.0, -14.0])
    spin = 1.2 * np.array([-(p - x)[1], (p - x)[0]])  # omega points out of the page
    body(ax, x, (150, 132), 16, BODY2)
    arrow(ax, x, p, FAINT, 1.8)
    arrow(ax, x, x + v)
    arrow(ax, p, p + v, dashed=True)
    arrow(ax, p, p + spin)
    arrow(ax, p, p + v + spin, INK, 3)
    for start, step in ((p + spin, v), (p + v, spin)):
        line(ax, start, start + step)
    dot(ax, x, BODY2)
    dot(ax, p, BODY2)
    turn(ax, x, 36, 95, 215, BODY2)
    words(ax, (477, 172), "$\\omega$", BODY2, 15)
    words(ax, (514, 132), "$x$", BODY2)
    words(ax, (550, 180), "$r$", FAINT)
    words(ax, (566, 124), "$v$", ARROW)
    words(ax, (663, 168), "$v$", ARROW)
    words(ax, (515, 268), "$\\omega \\times r$", ARROW)
    words(ax, (637, 263), "both together", INK, 11)
    below(ax, 562, "$\\omega$ points out of the page, at you")


# ---- fight.svg: rows y and z of the pose of Numbers, with its bias -------------------------------

K = np.array([[0.75, -0.5], [-0.5, 1.5]])  # [1/kg]
BIAS = np.array([0.0, 6.0])                # [m/s]


def gauss_seidel(iterations):
    """The impulses after each single solve."""
    impulse, places = np.zeros(2), [np.zeros(2)]
    for _ in range(iterations):
        for row in (0, 1):
            impulse = impulse.copy()
            impulse[row] -= (K @ impulse + BIAS)[row] / K[row, row]
            places.append(impulse)
    return places


def fight(ax):
    """Each row is satisfied on a line; solving in turns goes from line to line."""
    title(ax, 280, "solved in turns, each row undoes part of the other")

    def place(y, z):
        return 450 + 92 * y, 304 + 45 * z

    for row, colour in ((0, BODY1), (1, BODY2)):
        ys = np.array([-3.9, 0.45])
        zs = -(K[row, 0] * ys + BIAS[row]) / K[row, 1]
        ax.plot(*place(ys, zs), color=colour, linewidth=1.8, zorder=3)
    words(ax, (240, 198), "row $y$ satisfied", BODY1, 12, rotation=37, rotation_mode="anchor")
    words(ax, (330, 82), "row $z$ satisfied", BODY2, 12, rotation=10, rotation_mode="anchor")
    places = [place(*impulses) for impulses in gauss_seidel(3)]
    for start, end in zip(places[1:], places[2:]):
        if np.abs(np.subtract(end, start)).max() > 4:
            arrow(ax, start, end, INK, 2)
    dot(ax, places[0], INK)
    words(ax, np.add(places[0], (-22, 10)), "start", INK, 12)
    words(ax, np.add(places[1], (10, -80)), "solve row $z$:\n$y$ is wrong", BODY2, 12, ha="left")
    words(ax, (np.array(places[2]) + places[3]) / 2 + (20, 15), "solve row $y$: $z$ is wrong",
          BODY1, 12)
    goal = place(*np.linalg.solve(K, -BIAS))
    dot(ax, goal, ARROW, 9)
    words(ax, np.add(goal, (-44, 26)), "both\nsatisfied", ARROW, 12)
    for step, name in (((50, 0), "impulse of row $y$"), ((0, 50), "impulse of row $z$")):
        arrow(ax, (60, 246), np.add((60, 246), step), FAINT, 1.2)
        words(ax, np.add((60, 246), step) + np.array((6, 0 if step[0] else 12)), name, FAINT, 11,
              ha="left" if step[0] else "center")
    below(ax, 280, "an iteration, both rows once, leaves 2/9 of the error", 30)


if __name__ == "__main__":
    draw(__doc__, "geometry_02", geometry=((gap, turning), (0, 700, 0, 380), 423),
         fight=((fight,), (-20, 580, 8, 376)))
