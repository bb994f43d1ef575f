#!/usr/bin/env python3
"""Chapter 10's drawing: the cross of a universal joint, two wheels that mesh, a cone.

    python3 plots/geometry_10.py OUT.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, FAINT, INK, LEVER, arrow, below, direction, dot, draw,
                     into_page, title, turn, words)
from matplotlib.patches import Arc, Circle, Polygon


def bar(ax, start, end, width, colour):
    """A shaft between two points, seen from the side."""
    start, end = np.array(start), np.array(end)
    along = (end - start) / np.linalg.norm(end - start)
    across = width / 2 * np.array([-along[1], along[0]])
    ax.add_patch(Polygon([start + across, end + across, end - across, start - across],
                         facecolor=colour + "26", edgecolor=colour, linewidth=2))


def cross(ax):
    """Left: two shafts, and a pin of the cross in each."""
    title(ax, 150, "a universal joint")
    centre, bend = np.array([142.0, 190.0]), 32
    bar(ax, centre - (112, 0), centre - (26, 0), 34, BODY1)
    bar(ax, centre + 26 * direction(bend), centre + 122 * direction(bend), 34, BODY2)
    for side in (1, -1):
        ax.plot(*zip(centre - (26, 0), centre + (0, 62 * side)), color=BODY1, linewidth=2)
    arrow(ax, centre - (0, 66), centre + (0, 82), BODY1, 3)
    pin = 74 * direction(bend - 78)
    for side in (-0.62, 0.78):
        ax.plot(*zip(centre + 26 * direction(bend), centre + side * pin), color=BODY2, linewidth=2)
    arrow(ax, centre - 0.7 * pin, centre + pin, BODY2, 3)
    dot(ax, centre, INK)
    ax.plot((centre[0] + 8, centre[0] + 112), (centre[1],) * 2, color=FAINT, linewidth=1.2,
            linestyle=":")
    ax.add_patch(Arc(centre, 164, 164, theta1=0, theta2=bend, color=FAINT, linewidth=1.4))
    words(ax, centre + 96 * direction(bend / 2), "$\\gamma$", FAINT)
    words(ax, centre + (-17, 78), "$a_1$", BODY1)
    words(ax, centre + pin + (12, -12), "$a_2$", BODY2)
    words(ax, centre + (-70, -32), "body 1", BODY1, 12)
    words(ax, centre + 84 * direction(bend) + (-22, 36), "body 2", BODY2, 12)
    turn(ax, centre - (78, 0), 30, 110, 215, INK)
    words(ax, centre + (-120, 30), "$\\alpha$", INK)
    words(ax, (150, 28), "$C = a_1 \\cdot a_2$", FAINT, 11.5)


def wheel(ax, centre, radius, teeth, colour):
    """A toothed wheel with its hub."""
    angles = np.linspace(0, 2 * np.pi, 4 * teeth, endpoint=False)
    radii = radius + 4 * np.sign(np.sin(angles * teeth + 0.1))
    ax.add_patch(Polygon([centre + r * np.array([np.cos(a), np.sin(a)])
                          for r, a in zip(radii, angles)], facecolor=colour + "26",
                         edgecolor=colour, linewidth=1.6))
    ax.add_patch(Circle(centre, 5, color=colour, zorder=5))


def gear(ax):
    """Middle: two wheels that mesh turn in opposite directions."""
    title(ax, 390, "a gear")
    one, two = np.array([356.0, 190.0]), np.array([455.0, 190.0])
    wheel(ax, one, 62, 24, BODY1)
    wheel(ax, two, 31, 12, BODY2)
    for centre, start, end, radius, colour in ((one, 0, 40, 46, BODY1), (two, 180, 100, 22, BODY2)):
        ax.plot(*zip(centre, centre + (radius + 4) * direction(start)), color=FAINT, linewidth=1.2)
        ax.plot(*zip(centre, centre + (radius + 4) * direction(end)), color=colour, linewidth=1.6)
        turn(ax, centre, radius, start, end, colour)
    words(ax, one + (14, -88), "body 1", BODY1, 12)
    words(ax, two + (8, -54), "body 2", BODY2, 12)
    words(ax, one + (24, 82), "$\\theta_1$", BODY1)
    words(ax, two + (6, 54), "$\\theta_2 = \\kappa\\, \\theta_1$", BODY2)
    words(ax, (390, 56), "here $\\kappa = -2$", FAINT, 11.5)
    words(ax, (390, 28), "$C = \\theta_2 - \\kappa\\, \\theta_1$", FAINT, 11.5)


def cone(ax):
    """Right: an axis inside a cone, and the vector about which it swings."""
    title(ax, 616, "a cone")
    tip, limit, swing = np.array([616.0, 84.0]), 34, 20
    for side in (1, -1):
        ax.plot(*zip(tip, tip + 180 * direction(90 + side * limit)), color=BODY1, linewidth=2)
    rim = tip + np.array([0, 180 * np.cos(np.radians(limit))])
    ax.add_patch(Arc(rim, 360 * np.sin(np.radians(limit)), 52, color=BODY1, linewidth=1.6))
    arrow(ax, tip, tip + (0, 178), BODY1, 3)
    arrow(ax, tip, tip + 186 * direction(90 - swing), BODY2, 3)
    turn(ax, tip, 128, 90, 90 - swing + 5, LEVER)
    ax.add_patch(Arc(tip, 148, 148, theta1=90, theta2=90 + limit, color=FAINT, linewidth=1.4))
    words(ax, tip + 90 * direction(90 + limit / 2), "$\\varphi$", FAINT)
    words(ax, tip + (-17, 118), "$a_1$", BODY1)
    words(ax, tip + 186 * direction(90 - swing) + (15, 8), "$a_2$", BODY2)
    words(ax, tip + 144 * direction(90 - swing / 2), "swing", LEVER, 11)
    into_page(ax, tip, ARROW)
    words(ax, tip + (24, -6), "$n$", ARROW)
    below(ax, 616, "$n$ points into the page")


if __name__ == "__main__":
    draw(__doc__, "geometry_10", geometry=((cross, gear, cone), (0, 726, 0, 380), 272, 508))
