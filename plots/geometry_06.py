#!/usr/bin/env python3
"""Chapter 6's drawing: a step off the circle, two cures of a gap, the angular velocity left.

    python3 plots/geometry_06.py OUT.svg
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, FAINT, INK, arrow, dot, draw, words
from matplotlib.patches import Arc, FancyBboxPatch
from matplotlib.transforms import Affine2D

BETA = 0.3  # of the drawing, large enough to be seen


def direction(degrees):
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def box(ax, centre, size, degrees, colour, ghost=False):
    """A body seen from the side; a ghost is only its dashed outline."""
    w, h = size
    style = {"facecolor": "none", "linewidth": 1.4, "linestyle": (0, (4, 3))}
    shape = FancyBboxPatch((-w / 2, -h / 2), w, h, boxstyle="round,pad=0,rounding_size=5",
                           edgecolor=colour,
                           **(style if ghost else {"facecolor": colour + "26", "linewidth": 2}))
    shape.set_transform(Affine2D().rotate_deg(degrees).translate(*centre) + ax.transData)
    ax.add_patch(shape)


def turn(ax, centre, radius, start, end, colour, width):
    """A bent arrow round a centre, counter-clockwise from start to end [degrees]."""
    ax.add_patch(Arc(centre, 2 * radius, 2 * radius, theta1=start, theta2=end, color=colour,
                     linewidth=width, zorder=4))
    tip, along = centre + radius * direction(end), direction(end + 90)
    arrow(ax, tip - along, tip + 9 * along, colour, width)


def leave(ax):
    """Left: one step of a bar along the tangent, and how far it ends outside the circle."""
    words(ax, (140, 352), "a step is straight", size=12.5, weight="bold")
    pivot, r, first, angle = np.array([46.0, 84.0]), 112.0, 6.0, 0.78  # angle of the step [rad]
    before = pivot + r * direction(first)
    after = before + angle * r * direction(first + 90)
    now = first + np.degrees(angle)
    anchor = after - r * direction(now)
    outward = (after - pivot) / np.linalg.norm(after - pivot)
    ax.add_patch(Arc(pivot, 2 * r, 2 * r, theta1=-14, theta2=86, color=FAINT, linewidth=1.4,
                     linestyle=(0, (4, 3)), zorder=2))
    box(ax, before, (2 * r + 14, 26), first, BODY2, ghost=True)
    box(ax, after, (2 * r + 14, 26), now, BODY2)
    arrow(ax, before, after, ARROW, 3)
    arrow(ax, pivot, anchor, INK, 2.4)
    ax.plot(*zip(pivot + r * outward, after), color=INK, linewidth=3.4, zorder=4)
    dot(ax, pivot, BODY1, 9)
    for place in (before, after, anchor):
        dot(ax, place, BODY2)
    words(ax, (before + after) / 2 + (26, 3), "$\\omega\\,r\\,h$", ARROW)
    words(ax, (pivot + r * outward + after) / 2 + (-13, 11), "$\\delta$", INK, 15)
    words(ax, anchor + (-24, 10), "$C$", INK, 15)
    words(ax, pivot + (2, -22), "pivot", BODY1, 12)
    words(ax, pivot + r * direction(first) / 2 + (8, -4), "$r$", FAINT)
    words(ax, (142, 28), "it ends $\\delta = \\omega^2 r\\,h^2/2$ too far out", FAINT, 11)


def cures(ax):
    """Middle: a gap is closed by velocities in many steps, or by a move."""
    words(ax, (420, 352), "two cures of one gap", size=12.5, weight="bold")
    wall, gap, size = 306.0, 152.0, 32.0
    names = ("$C_0$", "$(1-\\beta)\\,C_0$", "$(1-\\beta)^2\\,C_0$")
    ax.plot((wall, wall), (196, 324), color=BODY1, linewidth=2.4)
    words(ax, (wall + 4, 180), "fed back: a velocity each step", ARROW, 11, ha="left")
    for k, name in enumerate(names):
        y, place = 304 - 44 * k, wall + gap * (1 - BETA) ** k
        box(ax, (place + size / 2, y), (size, size), 0, BODY2, ghost=k > 0)
        ax.plot((wall, place), (y - 8, y - 8), color=INK, linewidth=1.6, zorder=3)
        arrow(ax, (place, y + 6), (place - BETA * (place - wall), y + 6), ARROW, 2.6)
        dot(ax, (place, y - 8), BODY2, 6)
        dot(ax, (wall, y - 8), BODY1, 6)
        words(ax, (place + size + 8, y), name, INK, 12, ha="left")
    y = 106
    ax.plot((wall, wall), (y - 30, y + 30), color=BODY1, linewidth=2.4)
    box(ax, (wall + gap + size / 2, y), (size, size), 0, BODY2, ghost=True)
    box(ax, (wall + size / 2, y), (size, size), 0, BODY2)
    arrow(ax, (wall + gap - 2, y), (wall + size + 4, y), INK, 2.2, dashed=True)
    dot(ax, (wall, y - 8), BODY1, 6)
    words(ax, (wall + size + (gap - size) / 2, y + 15), "a move", INK, 11)
    words(ax, (wall + gap + size + 8, y), "$C_0$", INK, 12, ha="left")
    words(ax, (wall + 4, 62), "projected: at once, no velocity", INK, 11, ha="left")
    words(ax, (420, 28), "$\\beta$ of it in a step, or all of it", FAINT, 11)


def rotation(ax):
    """Right: the correction of a slanted gap turns the body, and an angular velocity stays."""
    words(ax, (700, 352), "the free axis", size=12.5, weight="bold")
    r, gap = 112.0, np.array([44.0, 46.0])
    pivot = np.array([606.0, 226.0])
    anchor = pivot + gap
    x = anchor + (r, 0)
    box(ax, pivot, (48, 48), 0, BODY1)
    box(ax, x, (58, 58), 0, BODY2)
    arrow(ax, x, anchor, FAINT, 1.8)
    arrow(ax, pivot, anchor, INK, 2.6)
    aside = np.array([-15.0, 14.0])
    arrow(ax, anchor + aside, anchor + aside - 0.62 * gap, ARROW, 2.8)
    turn(ax, x, 45, -62, 62, BODY2, 2.8)
    dot(ax, pivot, BODY1)
    dot(ax, anchor, BODY2)
    dot(ax, x, BODY2)
    words(ax, pivot + gap / 2 + (16, -8), "$C_0$")
    words(ax, (anchor + x) / 2 + (-8, 13), "$r$", FAINT)
    words(ax, anchor + aside + (-34, 13), "$-\\beta\\,C_0/h$", ARROW, 12)
    words(ax, (826, 212), "the first velocity rotates it", BODY2, 11, ha="right")

    pivot = np.array([606.0, 96.0])
    tilt = 22  # what it has turned by
    x = pivot + r * direction(tilt)
    box(ax, pivot, (48, 48), 0, BODY1)
    box(ax, x, (58, 58), tilt, BODY2)
    arrow(ax, x, pivot, FAINT, 1.8)
    turn(ax, x, 45, tilt - 18, tilt + 16, BODY2, 2.8)
    dot(ax, pivot, BODY1)
    dot(ax, x, BODY2)
    words(ax, x + (59, 14), "$\\omega_{\\mathrm{left}}$", BODY2, 14, ha="left")
    words(ax, (826, 58), "the gap is closed, $\\omega$ remains", BODY2, 11, ha="right")
    words(ax, (700, 28), "seen along the axis", FAINT, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_06", (leave, cures, rotation), (280, 560), width=840)
