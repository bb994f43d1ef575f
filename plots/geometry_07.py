#!/usr/bin/env python3
"""Chapter 7's drawings: colours of joints (geometry), records turned into columns (columns), the
errors of an order (order, by order_07.py) and the loop beside the machine (roofline, by
roofline_07.py).

    python3 plots/geometry_07.py geometry.svg|columns.svg|order.svg|roofline.svg
"""
import pathlib
import sys

import matplotlib
import numpy as np
from drawing import CARD, EDGE, FAINT, INK, arrow, below, body, direction, draw, title, words
from matplotlib.patches import Circle, Rectangle
from order_07 import joint

LANES = [matplotlib.colormaps["viridis"](k / 7) for k in range(8)]
CELL = 22.0


def colours(ax):
    """Two chains need two colours, a hub with five joints needs five."""
    title(ax, 320, "joints of one colour share no body: they are solved together")
    wall, apart = 54.0, 66.0
    for y in (286.0, 226.0):
        ax.add_patch(Rectangle((wall - 12, y - 21), 12, 42, facecolor=EDGE, edgecolor=FAINT,
                               linewidth=1.4, zorder=2))
        for k in range(5):
            body(ax, (wall + 43 + apart * k, y), (38, 38), 0, FAINT)
            joint(ax, (wall + 10 + apart * k, y), k % 2)
    words(ax, (205, 172), "a chain: two colours, however long", INK, 12)
    hub = np.array([510.0, 228.0])
    ax.add_patch(Circle(hub, 28, facecolor=FAINT + "26", edgecolor=FAINT, linewidth=2, zorder=2))
    for k in range(5):
        degrees = 90 - 72 * k
        body(ax, hub + 66 * direction(degrees), (36, 36), degrees, FAINT)
        joint(ax, hub + 38 * direction(degrees), k)
    words(ax, (510, 116), "a hub: five colours", INK, 12)


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


def columns(ax):
    """Eight records of eight numbers become eight columns."""
    title(ax, 300, "eight records become eight columns")
    names = ("$v_x$", "$v_y$", "$v_z$", "$1/m$", "$\\omega_x$", "$\\omega_y$", "$\\omega_z$", "-")
    left, right = np.array([70.0, 296.0]), np.array([390.0, 296.0])
    side = 8 * CELL
    cells(ax, left, 8, 8, lambda i, j: LANES[i])
    cells(ax, right, 8, 8, lambda i, j: LANES[j])
    frame(ax, left, 1, 8)
    frame(ax, right, 1, 8)
    for k, name in enumerate(names):
        words(ax, (left[0] - 9, left[1] - CELL * (k + 0.5)), str(k), INK, 9.5)
        words(ax, (left[0] + CELL * (k + 0.5), left[1] + 10), name, INK, 9)
        words(ax, (right[0] + CELL * (k + 0.5), right[1] + 10), str(k), INK, 9.5)
        words(ax, (right[0] - 7, right[1] - CELL * (k + 0.5)), name, INK, 10, ha="right")
    words(ax, (left[0] - 28, left[1] - side / 2), "body", FAINT, 11, rotation=90)
    words(ax, (right[0] + side / 2, right[1] + 28), "body", FAINT, 11)
    arrow(ax, (left[0] + side + 12, 210), (right[0] - 44, 210), INK, 2.6)
    words(ax, (left[0] + side / 2, 94), "one load:\nall numbers of one body", INK, 11)
    words(ax, (right[0] + side / 2, 94), "one instruction:\none number of eight bodies", INK, 11)
    below(ax, 300, "a colour: one body", 50)


if __name__ == "__main__":
    match pathlib.Path(sys.argv[-1]).name:
        case "order.svg":
            import order_07
            order_07.picture(__doc__)
        case "roofline.svg":
            import roofline_07
            roofline_07.picture(pathlib.Path(sys.argv[-1]))
        case _:
            draw(__doc__, "geometry_07", geometry=((colours,), (0, 640, 92, 376)),
                 columns=((columns,), (0, 600, 30, 376)))
