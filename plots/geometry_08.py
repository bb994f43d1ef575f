#!/usr/bin/env python3
"""Chapter 8's drawing: a corner over the ground; the wedge of friction; a rebound in two steps.

    python3 plots/geometry_08.py OUT.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, CARD, EDGE, FAINT, INK, arrow, dot, draw, words)
from matplotlib.patches import Circle, Polygon, Rectangle


def into_page(ax, place, colour):
    """An arrow that points away from the reader: its feathers."""
    ax.add_patch(Circle(place, 7, facecolor=CARD, edgecolor=colour, linewidth=2, zorder=6))
    for sign in (1, -1):
        ax.plot((place[0] - 4, place[0] + 4), (place[1] - 4 * sign, place[1] + 4 * sign),
                color=colour, linewidth=1.6, zorder=7)


def measure(ax, x, low, high):
    """A height between two marks."""
    ax.plot((x, x), (low, high), color=INK, linewidth=1.2, zorder=4)
    for y in (low, high):
        ax.plot((x - 5, x + 5), (y, y), color=INK, linewidth=1.2, zorder=4)


def corner(ax):
    """Left: the lowest corner of a tilted box, its levers and its three directions."""
    words(ax, (172, 352), "the gap under a corner", size=12.5, weight="bold")
    top, x1, x2 = 132.0, np.array([112.0, 70.0]), np.array([158.0, 258.0])
    ax.add_patch(Rectangle((24, 48), 300, top - 48, facecolor=BODY1 + "26", linewidth=0))
    ax.plot((24, 324), (top, top), color=BODY1, linewidth=2)
    size, tilt = np.array([140.0, 84.0]), np.radians(-30)
    c, s = np.cos(tilt), np.sin(tilt)
    corners = [x2 + np.array([c * a - s * b, s * a + c * b]) for a, b in (
        size / 2 * np.array(signs) for signs in ((1, -1), (1, 1), (-1, 1), (-1, -1)))]
    ax.add_patch(Polygon(corners, closed=True, facecolor=BODY2 + "26", edgecolor=BODY2,
                         linewidth=2, joinstyle="round"))
    p = corners[0]

    arrow(ax, x1, p, FAINT)
    arrow(ax, x2, p, FAINT)
    arrow(ax, p, p + (0, 74))
    arrow(ax, p, p + (74, 0))
    measure(ax, p[0] - 30, top, p[1])
    ax.plot((p[0] - 38, p[0]), (p[1], p[1]), color=FAINT, linewidth=1, linestyle=(0, (3, 2)))
    measure(ax, 58, x1[1], top)
    ax.plot((50, x1[0]), (x1[1], x1[1]), color=FAINT, linewidth=1, linestyle=(0, (3, 2)))
    dot(ax, p, INK)
    dot(ax, x1, BODY1)
    dot(ax, x2, BODY2)
    t2 = p + (38, -19)
    into_page(ax, t2, ARROW)

    words(ax, p + (13, 66), "$n$", ARROW, 14)
    words(ax, p + (84, -1), "$t_1$", ARROW, 14)
    words(ax, t2 + (18, -1), "$t_2$", ARROW, 14)
    words(ax, p + (11, -12), "$p$", INK)
    words(ax, (p[0] - 45, (top + p[1]) / 2), "$C$", INK, 14)
    words(ax, (x1 + p) / 2 + (18, -20), "$r_1$", FAINT)
    words(ax, (x2 + p) / 2 + (-26, -20), "$r_2 = R_2\\,l$", FAINT, 12, ha="right")
    words(ax, x1 + (2, -14), "$x_1$", BODY1)
    words(ax, x2 + (-14, 9), "$x_2$", BODY2)
    words(ax, (43, x1[1] + 34), "height", INK, 11, rotation=90)
    words(ax, (292, 62), "body 1", BODY1, 12)
    words(ax, (284, 300), "body 2", BODY2, 12)
    words(ax, (172, 28), "$t_1$: direction of sliding, $t_2 = n \\times t_1$", FAINT, 11)


def wedge(ax):
    """Middle: normal impulse and friction impulse of a corner, before and after a solve."""
    words(ax, (526, 352), "the bound follows the normal row", size=12.5, weight="bold")
    origin, right, slope = np.array([392.0, 188.0]), 262.0, 0.5
    ends = [origin + (right, sign * slope * right) for sign in (1, -1)]
    ax.add_patch(Polygon([origin, *ends], closed=True, facecolor=BODY1 + "1c", linewidth=0))
    for end in ends:
        ax.plot(*zip(origin, end), color=BODY1, linewidth=2)
    arrow(ax, origin - (8, 0), origin + (right + 26, 0), INK, 1.5)
    arrow(ax, origin - (0, 138), origin + (0, 140), INK, 1.5)
    words(ax, origin + (right + 12, 15), "$\\lambda_n$", INK, 14)
    words(ax, origin + (33, 132), "friction", INK, 11)
    words(ax, origin + (150, 93), "$+\\mu\\,\\lambda_n$", BODY1, rotation=26)
    words(ax, origin + (224, -94), "$-\\mu\\,\\lambda_n$", BODY1, rotation=-26)

    x = 118.0
    kept, wanted = origin + (x, -slope * x), origin + (x, -128)
    ax.plot((origin[0] + x,) * 2, (origin[1], kept[1]), color=EDGE, linewidth=1.6, zorder=1)
    arrow(ax, wanted, kept + (0, -4), BODY2, 2.6)
    dot(ax, wanted, BODY2)
    dot(ax, kept, INK, 8)
    words(ax, wanted + (-10, 0), "wanted", BODY2, 11, ha="right")
    words(ax, kept + (-11, -9), "clamped: it slides", INK, 11, ha="right")

    held = origin + (196, 36)
    dot(ax, held, ARROW, 8)
    words(ax, held + (0, 15), "not clamped:", ARROW, 10.5)
    words(ax, held + (0, -15), "it holds", ARROW, 11)
    words(ax, (526, 28), "the bound is proportional to $\\lambda_n$", FAINT, 11)


def rebound(ax):
    """Right: a ball before and after the two steps that a rebound takes."""
    words(ax, (876, 352), "a rebound takes two steps", size=12.5, weight="bold")
    top, radius, places = 118.0, 17.0, (764.0, 876.0, 988.0)
    ax.add_patch(Rectangle((718, 62), 316, top - 62, facecolor=BODY1 + "26", linewidth=0))
    ax.plot((718, 1034), (top, top), color=BODY1, linewidth=2)
    for x, bottom in zip(places, (top + 62, top, top + 112)):
        ax.add_patch(Circle((x, bottom + radius), radius, facecolor=BODY2 + "26", edgecolor=BODY2,
                            linewidth=2, zorder=3))
        dot(ax, (x, bottom), INK, 6)
    x = places[0]
    arrow(ax, (x, top + 62), (x, top - 44), FAINT, dashed=True)
    arrow(ax, (x + 6, top + 62), (x + 6, top + 1), BODY2, 2.6)
    measure(ax, x - 26, top, top + 62)
    words(ax, (x - 37, top + 31), "$C$", INK, 14)
    words(ax, (x + 11, top - 36), "$h\\,v_n$", FAINT, 12, ha="left")
    arrow(ax, (places[1], top + 36), (places[1], top + 132), ARROW, 2.6)
    words(ax, (places[1], top + 146), "target: $e\\,v_{\\mathrm{hit}}$", ARROW, 12)
    ax.plot((places[2] - 32, places[2] - 4), (top + 112,) * 2, color=FAINT, linewidth=1,
            linestyle=(0, (3, 2)))
    arrow(ax, (places[2] - 24, top), (places[2] - 24, top + 112), ARROW, 1.6)
    for left, right, said in ((0, 1, "step 1"), (1, 2, "step 2")):
        arrow(ax, (places[left] + 22, 308), (places[right] - 22, 308), INK, 1.4)
        words(ax, ((places[left] + places[right]) / 2, 322), said, INK, 11.5)
    words(ax, (876, 28), "it uses up $C$ and stores $v_{\\mathrm{hit}}$; then it rises", FAINT, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_08", (corner, wedge, rebound), (346, 702), 1050)
