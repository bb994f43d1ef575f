#!/usr/bin/env python3
"""Chapter 2's drawing: two bodies, their levers and the gap; the velocity of a turning anchor.

    python3 plots/geometry_02.py OUT.svg
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, FAINT, INK, arrow, body, dot, draw, words
from matplotlib.patches import Arc


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


if __name__ == "__main__":
    draw(__doc__, "geometry_02", (gap, turning), (423,))
