#!/usr/bin/env python3
"""Chapter 2's drawings: two bodies, their levers and the gap, and the velocity of a turning anchor;
two rows that undo part of each other's work.

    python3 plots/geometry_02.py geometry.svg
    python3 plots/geometry_02.py fight.svg
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, FAINT, INK, arrow, body, dot, draw, words
from matplotlib.patches import Arc, Rectangle


def gap(ax):
    """Left: x, r, p of both bodies, and u from p1 to p2."""
    words(ax, (210, 350), "the gap: $u = p_2 - p_1$", size=12.5, weight="bold")
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
    words(ax, (210, 32), "closed: $u = 0$, which is three numbers", FAINT, 11)


def turning(ax):
    """Right: the velocity of an anchor is the centre's plus that of the rotation."""
    words(ax, (562, 350), "a point's velocity: $v + \\omega \\times r$", size=12.5, weight="bold")
    x, p = np.array([524.0, 150.0]), np.array([588.0, 184.0])
    v = np.array([62.0, -14.0])
    turn = 1.2 * np.array([-(p - x)[1], (p - x)[0]])  # omega points out of the page
    body(ax, x, (150, 132), 16, BODY2)
    arrow(ax, x, p, FAINT, 1.8)
    arrow(ax, x, x + v)
    arrow(ax, p, p + v, dashed=True)
    arrow(ax, p, p + turn)
    arrow(ax, p, p + v + turn, INK, 3)
    for start, step in ((p + turn, v), (p + v, turn)):
        ax.plot(*zip(start, start + step), color=FAINT, linewidth=1, linestyle=":", zorder=3)
    dot(ax, x, BODY2)
    dot(ax, p, BODY2)
    # the rotation itself: a bent arrow round the centre
    ax.add_patch(Arc(x, 72, 72, theta1=95, theta2=215, color=BODY2, linewidth=2, zorder=4))
    end = np.radians(215)
    tip = x + 36 * np.array([np.cos(end), np.sin(end)])
    along = np.array([-np.sin(end), np.cos(end)])
    arrow(ax, tip - along, tip + 7 * along, BODY2, 2)
    words(ax, (477, 172), "$\\omega$", BODY2, 15)
    words(ax, (514, 132), "$x$", BODY2)
    words(ax, (550, 180), "$r$", FAINT)
    words(ax, (566, 124), "$v$", ARROW)
    words(ax, (663, 168), "$v$", ARROW)
    words(ax, (515, 268), "$\\omega \\times r$", ARROW)
    words(ax, (637, 263), "both together", INK, 11)
    words(ax, (562, 32), "$\\omega$ points out of the page, at you", FAINT, 11)


# ---- fight.svg: rows y and z of the pose of Numbers, with its bias -------------------------------

K = np.array([[0.75, -0.5], [-0.5, 1.5]])  # [1/kg]
BIAS = np.array([0.0, 6.0])                # [m/s]


def gauss_seidel(iterations):
    """The impulses after each single solve, and the error of row y after each iteration."""
    impulse, places, errors = np.zeros(2), [np.zeros(2)], []
    for _ in range(iterations):
        for row in (0, 1):
            impulse = impulse.copy()
            impulse[row] -= (K @ impulse + BIAS)[row] / K[row, row]
            places.append(impulse)
        errors.append((K @ impulse + BIAS)[0])
    return places, errors


def lines(ax):
    """Left: each row is satisfied on a line; solving in turns goes from line to line."""
    words(ax, (196, 352), "solved in turns", size=12.5, weight="bold")

    def place(y, z):
        return 352 + 76 * y, 306 + 43 * z

    for row, colour in ((0, BODY1), (1, BODY2)):
        ys = np.array([-3.9, 0.25])
        zs = -(K[row, 0] * ys + BIAS[row]) / K[row, 1]
        ax.plot(*place(ys, zs), color=colour, linewidth=1.8, zorder=3)
    words(ax, (232, 220), "row y satisfied", BODY1, 12, rotation=40, rotation_mode="anchor")
    words(ax, (262, 100), "row z satisfied", BODY2, 12, rotation=11, rotation_mode="anchor")
    places, _ = gauss_seidel(3)
    for start, end in zip(places, places[1:]):
        if np.abs(end - start).max() > 0.05:
            arrow(ax, place(*start), place(*end), INK, 2)
    dot(ax, place(0, 0), INK)
    words(ax, (place(0, 0)[0] - 4, place(0, 0)[1] + 16), "start", INK, 11)
    goal = np.linalg.solve(K, -BIAS)
    dot(ax, place(*goal), ARROW, 9)
    words(ax, (place(*goal)[0] - 36, place(*goal)[1] + 26), "both\nsatisfied", ARROW, 11)
    arrow(ax, (44, 240), (88, 240), FAINT, 1.2)
    arrow(ax, (44, 240), (44, 284), FAINT, 1.2)
    words(ax, (104, 240), "$\\lambda_y$", FAINT)
    words(ax, (44, 298), "$\\lambda_z$", FAINT)
    words(ax, (210, 32), "each solve undoes part of the other", FAINT, 11)


def shrinking(ax):
    """Right: the error of row y after each iteration."""
    words(ax, (552, 352), "the same factor each time", size=12.5, weight="bold")
    foot, one, width = 86, 110, 48  # [px]; `one` for 1 m/s
    _, errors = gauss_seidel(3)
    for number, error in enumerate(errors):
        x = 452 + 84 * number
        ax.add_patch(Rectangle((x, foot), width, one * error, facecolor=BODY1 + "26",
                               edgecolor=BODY1, linewidth=2, zorder=3))
        words(ax, (x + width / 2, foot + one * error + 13), ("2", "4/9", "8/81")[number], INK, 12)
        words(ax, (x + width / 2, foot - 16), str(number + 1), INK, 11)
        if number:
            words(ax, (x + width / 2, foot + one * error + 42), "$\\times\\;2/9$", ARROW, 13)
    words(ax, (552, 48), "iteration", INK, 11)
    words(ax, (512, 290), "error of row y\n[m/s]", INK, 11, ha="left")
    words(ax, (552, 26), "$2/9 = K_{yz}^2 / (K_{yy} K_{zz})$", FAINT, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_02", (gap, turning), (423,),
         more={"fight": ((lines, shrinking), (423,))})
