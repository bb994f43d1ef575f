#!/usr/bin/env python3
"""Draws the picture of chapter 1: geometry_01.py OUT.svg

Left the rod from centre to centre with its error C, right the rod from any point to any point.
"""
import math
import sys

import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patches import Circle, FancyArrowPatch, FancyBboxPatch, Polygon  # noqa: E402

BODY1, BODY2, VECTOR = "#0072B2", "#D55E00", "#009E73"  # told apart by colour-blind eyes too
INK, PALE, CARD = "#222222", "#777777", "#FAFAF7"
WIDTH, HEIGHT = 700, 380  # pixels of the page; the axes count in them


def along(start, direction, distance, aside=0.0):
    """The point `distance` further in a direction and `aside` to the left of it."""
    (x, y), (a, b) = start, direction
    return x + distance * a - aside * b, y + distance * b + aside * a


def toward(start, end):
    """Unit direction and distance from one point to another."""
    x, y = end[0] - start[0], end[1] - start[1]
    size = math.hypot(x, y)
    return (x / size, y / size), size


def arrow(ax, start, end, colour, width=2.2, layer=4):
    ax.add_patch(FancyArrowPatch(start, end, arrowstyle="-|>", mutation_scale=13, color=colour,
                                 linewidth=width, shrinkA=0, shrinkB=0, zorder=layer))


def text(ax, at, words, colour=INK, size=12, turn=0):
    ax.text(*at, words, color=colour, fontsize=size, rotation=turn, rotation_mode="anchor",
            ha="center", va="center", zorder=6)


def dot(ax, at, colour=INK):
    ax.add_patch(Circle(at, 3.6, facecolor=colour, edgecolor="none", zorder=5))


def line(ax, start, end, colour, width, style="-", layer=2):
    ax.plot([start[0], end[0]], [start[1], end[1]], color=colour, linewidth=width, linestyle=style,
            solid_capstyle="butt", zorder=layer)


def measure(ax, start, end, colour, width=1.4):
    """A line with a tick at both ends."""
    direction, size = toward(start, end)
    line(ax, start, end, colour, width)
    for distance in (0, size):
        line(ax, along(start, direction, distance, -6), along(start, direction, distance, 6),
             colour, 1.2)


def tint(colour):
    """The same colour, thinned with a lot of white."""
    return tuple(1 - 0.25 * (1 - part) for part in matplotlib.colors.to_rgb(colour))


def centre_to_centre(ax):
    metre, n = 112, (0.6, 0.8)
    x1 = (120, 64)
    x2 = along(x1, n, 2 * metre)
    slant = math.degrees(math.atan2(n[1], n[0]))
    text(ax, (172, 355), "from centre to centre", size=11.5)

    line(ax, x1, x2, PALE, 5, layer=1)
    for place, colour in ((x1, BODY1), (x2, BODY2)):
        ax.add_patch(Circle(place, 28, facecolor=tint(colour), edgecolor=colour, linewidth=2,
                            zorder=3))
        dot(ax, place, colour)
    text(ax, (x1[0] - 62, x1[1] - 20), "body 1", BODY1)
    text(ax, (x2[0] + 58, x2[1] - 20), "body 2", BODY2)
    text(ax, (x1[0] - 12, x1[1] - 9), "$x_1$", BODY1)
    text(ax, (x2[0] + 10, x2[1] - 13), "$x_2$", BODY2)

    arrow(ax, x1, along(x1, n, metre), VECTOR, 3)
    text(ax, along(x1, n, 0.86 * metre, -17), "$n$", VECTOR, 14)
    v1, v2 = (x1[0] + 66, x1[1] - 14), (x2[0] + 72, x2[1] + 36)
    arrow(ax, x1, v1, BODY1)
    arrow(ax, x2, v2, BODY2)
    text(ax, (v1[0] + 14, v1[1] - 1), "$v_1$", BODY1, 13)
    text(ax, (v2[0] - 2, v2[1] + 17), "$v_2$", BODY2, 13)

    near, far = 45, 82  # how far aside the two measures stand
    for place in (x1, x2):
        line(ax, along(place, n, 0, 30), along(place, n, 0, far + 8), PALE, 0.8, (0, (3, 3)))
    end = along(x1, n, 1.5 * metre, near)
    measure(ax, along(x1, n, 0, near), end, INK)
    measure(ax, end, along(x2, n, 0, near), INK, 4)
    measure(ax, along(x1, n, 0, far), along(x2, n, 0, far), INK)
    text(ax, along(x1, n, 0.75 * metre, near + 14), "$d$", INK, 13, slant)
    text(ax, along(x1, n, 1.75 * metre, near + 16), "$C$", INK, 14, slant)
    text(ax, along(x1, n, metre, far + 15), "$|x_2 - x_1|$", INK, 13, slant)


def box(ax, centre, edges, turn, colour):
    """A turned rectangle. Returns the turn as a function from body space to the page."""
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))

    def place(x, y):
        return centre[0] + c * x - s * y, centre[1] + s * x + c * y

    a, b = edges[0] / 2, edges[1] / 2
    ax.add_patch(Polygon([place(-a, -b), place(a, -b), place(a, b), place(-a, b)], closed=True,
                         facecolor=tint(colour), edgecolor=colour, linewidth=2, zorder=1))
    return place


def anchor_to_anchor(ax):
    text(ax, (525, 355), "from any point to any point", size=11.5)
    x1, x2 = (448, 95), (603, 257)
    p1 = box(ax, x1, (136, 96), 18, BODY1)(44, -14)
    p2 = box(ax, x2, (140, 96), -20, BODY2)(-44, -6)
    text(ax, (x1[0] + 8, x1[1] - 71), "body 1", BODY1)
    text(ax, (x2[0] + 12, x2[1] + 72), "body 2", BODY2)

    arrow(ax, x1, p1, VECTOR)
    arrow(ax, x2, p2, VECTOR)
    arrow(ax, p1, p2, VECTOR, 3)
    for place, colour in ((x1, BODY1), (x2, BODY2), (p1, INK), (p2, INK)):
        dot(ax, place, colour)
    text(ax, (x1[0] - 15, x1[1] - 2), "$x_1$", BODY1)
    text(ax, (x2[0] + 15, x2[1] + 4), "$x_2$", BODY2)
    text(ax, along(x1, toward(x1, p1)[0], 23, 13), "$r_1$", VECTOR, 13)
    text(ax, along(x2, toward(x2, p2)[0], 24, -14), "$r_2$", VECTOR, 13)
    text(ax, (p1[0] + 2, p1[1] - 16), "$p_1$", INK, 13)
    text(ax, (p2[0] - 7, p2[1] + 16), "$p_2$", INK, 13)
    (a, b), size = toward(p1, p2)
    text(ax, along(p1, (a, b), size / 2, -16), "$u$", VECTOR, 15)


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit("usage: geometry_01.py OUT.svg")
    plt.rcParams.update({"svg.hashsalt": "geometry_01", "mathtext.fontset": "dejavusans"})
    figure = plt.figure(figsize=(WIDTH / 96, HEIGHT / 96))  # 96 pixels of a page are an inch
    ax = figure.add_axes([0, 0, 1, 1])
    ax.set(xlim=(0, WIDTH), ylim=(0, HEIGHT))
    ax.axis("off")
    ax.add_patch(FancyBboxPatch((14, 14), WIDTH - 28, HEIGHT - 28, boxstyle="round,pad=12",
                                facecolor=CARD, edgecolor="none", zorder=0))
    line(ax, (350, 24), (350, HEIGHT - 24), "#CCCCCC", 1)
    centre_to_centre(ax)
    anchor_to_anchor(ax)
    figure.savefig(sys.argv[1], transparent=True, metadata={"Date": None})


if __name__ == "__main__":
    main()
