#!/usr/bin/env python3
"""Chapter 6's drawings: a step off the circle (geometry), two cures of a gap (cures), the angular
velocity that is left (left).

    python3 plots/geometry_06.py geometry.svg|cures.svg|left.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, FAINT, INK, arrow, below, body, direction, dot, draw,
                     line, title, turn, words)
from matplotlib.patches import Arc

BETA = 0.3  # of the drawing, large enough to be seen


def leave(ax):
    """One step of a bar along the tangent, and how far it ends outside the circle."""
    title(ax, 210, "a step is straight: it leaves the circle")
    pivot, r, first, angle = np.array([74.0, 92.0]), 136.0, 4.0, 0.74  # angle of the step [rad]
    before = pivot + r * direction(first)
    after = before + angle * r * direction(first + 90)
    outward = (after - pivot) / np.linalg.norm(after - pivot)
    anchor = after - r * direction(first + np.degrees(angle))
    ax.add_patch(Arc(pivot, 2 * r, 2 * r, theta1=-8, theta2=74, color=FAINT, linewidth=1.6,
                     linestyle=(0, (4, 3)), zorder=2))
    body(ax, before, (2 * r + 18, 26), first, BODY2, ghost=True, rounding=5)
    body(ax, after, (2 * r + 18, 26), first + np.degrees(angle), BODY2, rounding=5)
    arrow(ax, before, after, ARROW, 3)
    line(ax, pivot + r * outward, after, INK, "solid", 4, 4)
    line(ax, pivot, anchor, INK, "solid", 4, 4)
    dot(ax, pivot, BODY1, 10)
    for place in (before, after, anchor):
        dot(ax, place, BODY2)
    words(ax, before + (14, 56), "one step:\n$\\omega\\,r\\,h$, straight", ARROW, ha="left")
    words(ax, after + (-36, 4), "$\\delta$", INK, 16)
    words(ax, anchor + (-42, 22), "gap $C$", INK)
    words(ax, pivot + (-22, -28), "pivot", BODY1, 12)
    words(ax, pivot + (70, -24), "$r$", FAINT)
    words(ax, pivot + r * direction(78) + (-6, 8), "circle of the centre", FAINT, 11)
    below(ax, 210, "too far out by $\\delta = \\omega^2 r\\,h^2/2$, in every step")


def fed_back(ax):
    """Left: a gap is closed by velocities in many steps."""
    title(ax, 170, "fed back: a velocity in each step")
    wall, gap, size = 30.0, 190.0, 36.0
    line(ax, (wall, 62), (wall, 318), BODY1, "solid", 2.4)
    for k in range(4):
        y, place = 290 - 64 * k, wall + gap * (1 - BETA) ** k
        body(ax, (place + size / 2, y), (size, size), 0, BODY2, k < 3, 5)
        line(ax, (wall, y - 8), (place, y - 8), INK, "solid", 1.6)
        arrow(ax, (place, y + 7), (place - BETA * (place - wall), y + 7), ARROW, 2.6)
        dot(ax, (place, y - 8), BODY2, 6)
        dot(ax, (wall, y - 8), BODY1, 6)
        words(ax, (place + size + 8, y), ("$C_0$", "$(1-\\beta)\\,C_0$", "$(1-\\beta)^2\\,C_0$",
                                          "$(1-\\beta)^3\\,C_0$")[k], INK, 12, ha="left")
    for k, said in enumerate(("start", "step 1", "step 2", "step 3")):
        words(ax, (308, 290 - 64 * k), said, FAINT, 10)
    words(ax, (wall + gap / 2, 270), "gap", FAINT, 11)
    words(ax, (wall + gap - 30, 313), "velocity", ARROW, 11)
    below(ax, 170, "each step multiplies the gap by $1 - \\beta$")


def projected(ax):
    """Right: a gap is closed by a move."""
    title(ax, 510, "projected: one move, no velocity")
    wall, gap, size, y = 400.0, 150.0, 36.0, 210
    line(ax, (wall, y - 60), (wall, y + 60), BODY1, "solid", 2.4)
    body(ax, (wall + gap + size / 2, y), (size, size), 0, BODY2, True, 5)
    body(ax, (wall + size / 2, y), (size, size), 0, BODY2, rounding=5)
    line(ax, (wall + size, y - 8), (wall + gap, y - 8), INK, "solid", 1.6)
    arrow(ax, (wall + gap - 2, y + 7), (wall + size + 4, y + 7), INK, 2.2, dashed=True)
    dot(ax, (wall + gap, y - 8), BODY2, 6)
    dot(ax, (wall, y - 8), BODY1, 8)
    dot(ax, (wall, y - 8), BODY2, 4)
    words(ax, (wall + size + 56, y + 22), "moved", INK, 11)
    words(ax, (wall + gap + size + 8, y), "$C_0$", INK, 12, ha="left")
    below(ax, 510, "the gap is closed after one step")


def free_axis(ax, pivot, tilt, gap):
    """A body on a lever beside its pivot, seen along the free axis; its anchor and its centre."""
    pivot = np.array(pivot)
    anchor = pivot + gap
    x = anchor + 120 * direction(tilt)
    body(ax, pivot, (52, 52), 0, BODY1, rounding=5)
    body(ax, x, (62, 62), tilt, BODY2, rounding=5)
    line(ax, x, anchor, BODY2, "solid", 2.4)
    dot(ax, pivot, BODY1)
    dot(ax, anchor, BODY2)
    return anchor, x


def closing(ax):
    """Left: the correction of a slanted gap rotates the body."""
    title(ax, 150, "a slanted pull also rotates")
    gap = np.array([48.0, 50.0])
    anchor, x = free_axis(ax, (60, 176), 0, gap)
    arrow(ax, (60, 176), anchor, INK, 2.8)
    arrow(ax, anchor + (-14, 14), anchor + (-14, 14) - 0.66 * gap, ARROW, 3)
    turn(ax, x, 48, -62, 62, BODY2, 2.8)
    words(ax, anchor - gap / 2 + (40, -10), "gap $C_0$")
    words(ax, (anchor + x) / 2 + (-14, 14), "lever $r$", FAINT)
    words(ax, anchor + (-30, 28), "$-\\beta\\,C_0/h$", ARROW, 13)
    below(ax, 150, "seen along the axis of a hinge", 72)


def closed(ax):
    """Right: the gap is closed, and an angular velocity stays."""
    title(ax, 450, "closed: it keeps spinning")
    _, x = free_axis(ax, (370, 176), 22, (0, 0))
    turn(ax, x, 48, -40, 84, BODY2, 2.8)
    words(ax, x + (16, 66), "$\\omega$ remains", BODY2, 13)
    below(ax, 450, "a hinge does not resist this spin", 72)


if __name__ == "__main__":
    draw(__doc__, "geometry_06", geometry=((leave,), (0, 420, 6, 376)),
         cures=((fed_back, projected), (0, 680, 6, 376), 340),
         left=((closing, closed), (0, 600, 50, 376), 300))
