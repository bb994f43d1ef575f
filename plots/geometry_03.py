#!/usr/bin/env python3
"""Chapter 3's drawings: a door and its limits (geometry), the shadow of an axis (shadow), the
vector of the angle's rate (rate), a twist and a swing (twist), what a motor gives (couple).

    python3 plots/geometry_03.py geometry.svg|shadow.svg|rate.svg|twist.svg|couple.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, CARD, FAINT, INK, arrow, below, body, direction, dot,
                     draw, line, named, title, turn, words)
from matplotlib.patches import Arc, Circle, Ellipse, Polygon, Wedge


def from_above(right, away, up):
    """Where a point of space is on the page, seen from 30 degrees above."""
    return np.array([right, 0.5 * away + 0.87 * up])


def door(ax):
    """A door from above, with its angle x, its two limits and the gap to the nearer one."""
    title(ax, 250, "a hinge leaves one angle, between two limits")
    pin, length, x, upper = np.array([206.0, 92.0]), 176.0, 52.0, 110.0
    ax.add_patch(Wedge(pin, length, 0, upper, facecolor=BODY2 + "12", edgecolor="none", zorder=1))
    body(ax, pin - (60, 0), (120, 44), 0, BODY1, rounding=4)
    for degrees in (0, upper):
        line(ax, pin, pin + (length + 14) * direction(degrees), INK, (0, (4, 3)), 1.4)
    body(ax, pin + length / 2 * direction(x), (length, 15), x, BODY2, rounding=6)
    turn(ax, pin, 84, 0, x - 9, BODY2)
    turn(ax, pin, 126, x + 6, upper - 6, INK)
    dot(ax, pin, INK, 10)
    words(ax, pin + 124 * direction(24), "angle $x$", BODY2)
    words(ax, pin + 142 * direction(83), "gap $C$", INK)
    words(ax, pin - (60, 0), "body 1", BODY1, 12)
    words(ax, pin + (length + 16) * direction(x) + (22, 0), "body 2", BODY2, 12)
    words(ax, pin + (length + 20, 0), "lower limit", INK, 12, ha="left")
    words(ax, pin + (length + 30) * direction(upper) + (-16, 2), "upper limit", INK, 12)
    below(ax, 250, "$C$: how far it can still turn")


def shadow(ax):
    """a1 above the plane of b and c, and its shadow there, which is C."""
    title(ax, 220, "the error of a hinge: the shadow of $a_1$")
    middle, size = np.array([200.0, 136.0]), 140.0

    def place(b, c, up):  # body 2's axis points up
        return middle + size * from_above(0.9 * c - 0.44 * b, -0.9 * b - 0.44 * c, up)

    ax.add_patch(Ellipse(middle, 2 * size, size, facecolor=BODY2 + "1c",
                         edgecolor=BODY2, linewidth=1.5))
    C_b, C_c = 0.3, 0.62
    up = np.sqrt(1 - C_b ** 2 - C_c ** 2)
    for end, name, aside in (((1, 0, 0), "$b$", (-14, -4)), ((0, 1, 0), "$c$", (15, -4)),
                             ((0, 0, 1), "$a_2$", (-16, 2))):
        arrow(ax, middle, place(*end), BODY2, 1.6 if aside[1] < 0 else 2.6)
        words(ax, place(*end) + aside, name, BODY2)
    for share in (0.4, 0.7, 1):
        tip, foot = place(share * C_b, share * C_c, share * up), place(share * C_b, share * C_c, 0)
        line(ax, (tip[0], 290), foot, named("orange"), "solid", 1.4)
        arrow(ax, (tip[0], 290), (tip[0], 262), named("orange"), 1.4)
    arrow(ax, middle, foot, INK, 4)
    arrow(ax, middle, tip, BODY1, 2.6)
    words(ax, tip + (18, -2), "$a_1$", BODY1)
    words(ax, (tip[0] + 12, 284), "light along $a_2$", named("fifth"), 12, ha="left")
    words(ax, foot + (8, -13), "$C$", INK, 16)
    below(ax, 220, "no shadow: the axes $a_1$ and $a_2$ are aligned", 36)


def rate(ax):
    """g lies between the axes and has the component 1 along both."""
    title(ax, 220, "$g$ has the component 1 along each axis")
    root, length, half = np.array([220.0, 80.0]), 190.0, 32.0
    tip1, tip2 = (root + length * direction(90 + sign * half) for sign in (1, -1))
    tip = root + (0, length / np.cos(np.radians(half)))
    ax.add_patch(Arc(root, 2 * length, 2 * length, theta1=48, theta2=132, color=FAINT,
                     linewidth=1, linestyle=(0, (2, 2)), zorder=2))
    for end in (tip1, tip2):
        line(ax, tip, end, INK, "solid")
        inward, across = (root - end) / length, (tip - end) / np.linalg.norm(tip - end)
        corner = np.array([end + 11 * inward, end + 11 * (inward + across), end + 11 * across])
        ax.plot(*corner.T, color=INK, linewidth=1, zorder=3)
    arrow(ax, root, tip1, BODY1, 2.6)
    arrow(ax, root, tip2, BODY2, 2.6)
    arrow(ax, root, tip, ARROW, 3)
    words(ax, tip1 + (-16, 4), "$a_1$", BODY1)
    words(ax, tip2 + (17, 4), "$a_2$", BODY2)
    words(ax, tip + (14, 8), "$g$", ARROW, 16)
    words(ax, root + (-92, 70), "length 1", BODY1, 12)
    words(ax, root + (92, 70), "length 1", BODY2, 12)
    below(ax, 220, "$g$ is longer than $a_1$ and $a_2$, the bodies' axes", 44)


THETA, ALPHA = 78, 24  # of the twist and of the swing [degrees]


def leaf(angle, tip=0):
    """place(out, up): points of a door that is open by an angle, its axis tipped in the page."""
    def place(out, up):
        right, away, high = (out * np.cos(np.radians(angle)), out * np.sin(np.radians(angle)), up)
        c, s = np.cos(np.radians(tip)), np.sin(np.radians(tip))
        return 150 * from_above(c * right - s * high, away, s * right + c * high)
    return place


def leaves(ax, foot, before, after, axis):
    """A door before, dashed, and after; with the axis that it has now."""
    corners = ((0, 0.1), (0.8, 0.1), (0.8, 1.1), (0, 1.1))
    for place, look in ((before, {"facecolor": "none", "linestyle": (0, (4, 3)), "linewidth": 1.3}),
                        (after, {"facecolor": BODY2 + "40", "linewidth": 2})):
        ax.add_patch(Polygon([foot + place(*corner) for corner in corners], edgecolor=BODY2,
                             zorder=2, **look))
    arrow(ax, foot + after(0, -0.08), foot + after(0, 1.42), *axis)
    dot(ax, foot + after(0, -0.08), INK)


def bent(ax, points, colour):
    """A curve with a head at its end."""
    ax.plot(*np.array(points).T, color=colour, linewidth=2, zorder=4)
    arrow(ax, points[-2], points[-1] + 3 * (points[-1] - points[-2]), colour, 2)


def twist(ax):
    """Left: a door opens about its axis, which stays."""
    title(ax, 165, "first the twist: it opens by $\\theta$")
    foot = np.array([110.0, 110.0])
    leaves(ax, foot, leaf(-12), leaf(THETA - 12), (BODY1, 3))
    bent(ax, [foot + leaf(angle)(0.8, 0.1) for angle in np.linspace(-10, THETA - 24, 30)], INK)
    words(ax, foot + leaf(THETA / 2 - 12)(0.8, 0.1) + (34, -14), "$\\theta$", INK, 16)
    words(ax, foot + leaf(0)(0, 1.5) + (-2, 4), "$a_1$", BODY1, 14)
    below(ax, 165, "its axis stays where it is")


def swing(ax):
    """Right: the axis is tipped, and the door with it."""
    title(ax, 495, "then the swing: its axis tips by $\\alpha$")
    foot = np.array([480.0, 110.0])
    leaves(ax, foot, leaf(THETA - 12), leaf(THETA - 12, ALPHA), (BODY2, 3))
    arrow(ax, foot, foot + leaf(0)(0, 1.42), BODY1, 1.6, dashed=True)
    bent(ax, [foot + leaf(0, tip)(0, 1.25) for tip in np.linspace(1, ALPHA - 6, 30)], INK)
    words(ax, foot + leaf(0, ALPHA / 2)(0, 1.1), "$\\alpha$", INK, 16)
    words(ax, foot + leaf(0)(0, 1.5) + (14, 2), "$a_1$", BODY1, 14)
    words(ax, foot + leaf(0, ALPHA)(0, 1.5) + (-4, 4), "$a_2$", BODY2, 14)
    below(ax, 495, "it sags, and is still open by $\\theta$")


def couple(ax):
    """A motor between a ring and a wheel, seen along the axle."""
    title(ax, 210, "a motor turns both, and pushes neither")
    middle = np.array([210.0, 190.0])
    for radius, colour in ((112, BODY1), (78, None), (70, BODY2)):
        ax.add_patch(Circle(middle, radius, edgecolor=colour or BODY1, linewidth=2, zorder=1,
                            facecolor=colour + "26" if colour else CARD))
    dot(ax, middle, INK, 9)
    turn(ax, middle, 46, 20, 145, BODY2)
    turn(ax, middle, 126, 145, 20, BODY1)
    words(ax, middle + 26 * direction(82), "$\\tau$", BODY2, 15)
    words(ax, middle + 143 * direction(35) + (8, 0), "$-\\tau$", BODY1, 15)
    words(ax, middle + (0, -40), "body 2", BODY2, 12)
    words(ax, middle + (0, -95), "body 1", BODY1, 12)
    below(ax, 210, "two torques, equal and opposite: a couple")


if __name__ == "__main__":
    draw(__doc__, "geometry_03", geometry=((door,), (0, 500, 10, 376)),
         shadow=((shadow,), (0, 440, 14, 376)), rate=((rate,), (0, 440, 26, 376)),
         twist=((twist, swing), (0, 660, 6, 376), 330), couple=((couple,), (0, 420, 6, 376)))
