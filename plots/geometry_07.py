#!/usr/bin/env python3
"""Chapter 7's drawings: geometry.svg with colours of joints, records turned into columns and one
product on eight lanes; order.svg (order_07.py) and roofline.svg (roofline_07.py). The file's name
chooses.

    python3 plots/geometry_07.py OUT.svg
"""
import pathlib
import sys

import matplotlib
import numpy as np
from drawing import CARD, EDGE, FAINT, INK, arrow, body, draw, named, words
from matplotlib.patches import Circle, Rectangle
from order_07 import joint

LANES = [matplotlib.colormaps["viridis"](k / 7) for k in range(8)]
CELL = 17.0


def colours(ax):
    """Left: two chains need two colours, a hub with five joints needs five."""
    words(ax, (172, 352), "one colour: solved together", size=12.5, weight="bold")
    wall, apart = 30.0, 58.0
    for y in (308.0, 258.0):
        ax.add_patch(Rectangle((wall - 12, y - 19), 12, 38, facecolor=EDGE, edgecolor=FAINT,
                               linewidth=1.4, zorder=2))
        for k in range(5):
            body(ax, (wall + 38 + apart * k, y), (32, 32), 0, FAINT)
            joint(ax, (wall + 9 + apart * k, y), k % 2)
    words(ax, (172, 221), "chains: two colours, however long", FAINT, 11)

    hub = np.array([92.0, 122.0])
    ax.add_patch(Circle(hub, 26, facecolor=FAINT + "26", edgecolor=FAINT, linewidth=2, zorder=2))
    for k in range(5):
        angle = np.radians(90 - 72 * k)
        out = np.array([np.cos(angle), np.sin(angle)])
        body(ax, hub + 59 * out, (30, 30), 90 - 72 * k, FAINT)
        joint(ax, hub + 35 * out, k)
    words(ax, (180, 142), "five joints on a hub:", FAINT, 11, ha="left")
    words(ax, (180, 122), "five colours, with", FAINT, 11, ha="left")
    words(ax, (180, 102), "one joint in each", FAINT, 11, ha="left")
    words(ax, (172, 28), "in one colour no moving body occurs twice", FAINT, 11)


def cells(ax, corner, rows, columns, colour_of):
    """A table of numbers, each in the colour of its lane; the corner is the upper left one."""
    for i in range(rows):
        for j in range(columns):
            ax.add_patch(Rectangle((corner[0] + CELL * j, corner[1] - CELL * (i + 1)), CELL, CELL,
                                   facecolor=colour_of(i, j), alpha=0.55, edgecolor=CARD,
                                   linewidth=1.2, zorder=2))


def frame(ax, corner, rows, columns):
    """What is picked out of a table."""
    ax.add_patch(Rectangle((corner[0], corner[1] - CELL * rows), CELL * columns, CELL * rows,
                           facecolor="none", edgecolor=INK, linewidth=2.2, zorder=4))


def turned_round(ax):
    """Right, above: eight records of eight numbers become eight columns."""
    words(ax, (594, 352), "eight records become columns", size=12.5, weight="bold")
    names = ("$v_x$", "$v_y$", "$v_z$", "$1/m$", "$\\omega_x$", "$\\omega_y$", "$\\omega_z$",
             "unused")
    left, right = np.array([404.0, 310.0]), np.array([644.0, 310.0])
    side = 8 * CELL
    cells(ax, left, 8, 8, lambda i, j: LANES[i])
    cells(ax, right, 8, 8, lambda i, j: LANES[j])
    frame(ax, left, 8, 1)
    frame(ax, right, 1, 8)
    for k in range(8):
        words(ax, (left[0] - 9, left[1] - CELL * (k + 0.5)), str(k), INK, 9.5)
        words(ax, (right[0] + CELL * (k + 0.5), right[1] + 9), str(k), INK, 9.5)
    for k, name in enumerate(names):
        words(ax, (right[0] - 7, right[1] - CELL * (k + 0.5)), name, INK, 10, ha="right")
    for place, name in ((1.5, "$v$"), (3.5, "$1/m$"), (5.5, "$\\omega$")):
        words(ax, (left[0] + CELL * place, left[1] + 10), name, INK, 10)
    words(ax, (left[0] - 25, left[1] - side / 2), "joint", FAINT, 11, rotation=90)
    words(ax, (right[0] + side + 22, right[1] + 9), "lane", FAINT, 11)
    arrow(ax, (left[0] + side + 10, 242), (right[0] - 42, 242), INK, 2.6)
    words(ax, (left[0] + side / 2, 160), "a row: one body", FAINT, 11)
    words(ax, (right[0] + side / 2, 160), "a row: one number of eight", FAINT, 11)


def lanes(ax):
    """Right, below: one product of the solve, for eight joints at once."""
    width, y = 8 * CELL, 98.0
    starts = (368.0, 526.0, 684.0)
    signs = ("$\\times$", "$=$")
    names = ("$(K^{-1})_{ij}$", "$e_j$", "term of $-\\lambda_i$")
    for x, name in zip(starts, names):
        cells(ax, (x, y), 1, 8, lambda i, j: LANES[j])
        frame(ax, (x, y), 1, 8)
        words(ax, (x + width / 2, y + 17), name, INK, 12)
    for x, sign in zip(starts[1:], signs):
        words(ax, (x - 12, y - CELL / 2), sign, INK, 15)
    words(ax, (594, 56), "one instruction, eight joints", INK, 11)
    words(ax, (594, 28), "only if no body is in two lanes", FAINT, 11)


if __name__ == "__main__":
    match pathlib.Path(sys.argv[-1]).name:
        case "order.svg":
            import order_07
            order_07.picture(__doc__)
        case "roofline.svg":
            import roofline_07
            roofline_07.picture(pathlib.Path(sys.argv[-1]))
        case _:
            draw(__doc__, "geometry_07", (colours, turned_round, lanes), (345,),
                 width=840)
