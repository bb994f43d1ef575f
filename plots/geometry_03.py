#!/usr/bin/env python3
"""Chapter 3's drawings, one of three by the name of OUT.svg:

    python3 plots/geometry_03.py OUT.svg

geometry: the shadow of an axis, the vector of the angle's rate, a door's limits; twist: a rotation
as a twist and a swing; couple: what a motor gives to both bodies.
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, CARD, FAINT, INK, arrow, draw, named, words
from matplotlib.patches import Arc, Ellipse, FancyBboxPatch, Polygon, Wedge
from matplotlib.transforms import Affine2D


def line(ax, start, end, colour=FAINT, dashes=(0, (2, 2)), width=1.1):
    ax.plot(*zip(start, end), color=colour, linewidth=width, linestyle=dashes, zorder=3)


def at_angle(centre, radius, degrees):
    angle = np.radians(degrees)
    return np.asarray(centre) + radius * np.array([np.cos(angle), np.sin(angle)])


def from_above(right, away, up):
    """Where a point of space is on the page, seen from 30 degrees above."""
    return np.array([right, 0.5 * away + 0.87 * up])


def shadow(ax):
    """Left: a1 above the plane of b and c, and its shadow there, which is C."""
    words(ax, (142, 350), "the error: a shadow", size=12.5, weight="bold")
    middle, length = np.array([134.0, 156.0]), 112.0

    def place(b, c, up):  # body 2's axis points up
        return middle + length * from_above(0.9 * c - 0.44 * b, -0.9 * b - 0.44 * c, up)

    ax.add_patch(Ellipse(middle, 2 * length, length, facecolor=BODY2 + "1c",
                         edgecolor=BODY2, linewidth=1.5))
    C_b, C_c = 0.35, 0.6
    up = np.sqrt(1 - C_b ** 2 - C_c ** 2)
    tip, foot = place(C_b, C_c, up), place(C_b, C_c, 0)
    for end in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
        arrow(ax, middle, place(*end), BODY2)
    line(ax, tip, foot)
    line(ax, foot, place(C_b, 0, 0))
    line(ax, foot, place(0, C_c, 0))
    arrow(ax, middle, foot, INK, 3)
    arrow(ax, middle, tip, BODY1, 2.6)
    words(ax, place(0, 0, 1) + (-15, -4), "$a_2$", BODY2)
    words(ax, place(1, 0, 0) + (-14, -4), "$b$", BODY2)
    words(ax, place(0, 1, 0) + (15, -4), "$c$", BODY2)
    words(ax, tip + (14, 8), "$a_1$", BODY1)
    words(ax, foot + (4, -15), "$C$", INK, 15)
    words(ax, place(C_b, 0, 0) + (-25, 5), "$a_1\\cdot b$", INK, 11)
    words(ax, place(0, C_c, 0) + (10, 13), "$a_1\\cdot c$", INK, 11)
    words(ax, (142, 32), "$b$, $c$ and $a_2$ ride on body 2", FAINT, 11)


def rate(ax):
    """Middle: g lies between the axes and has the component 1 along both."""
    words(ax, (420, 350), "the angle's rate: $g$", size=12.5, weight="bold")
    root, length, half = np.array([420.0, 92.0]), 165.0, 32.0
    tip1, tip2 = at_angle(root, length, 90 + half), at_angle(root, length, 90 - half)
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
    words(ax, tip + (0, 17), "$g$", ARROW, 15)
    words(ax, (338, 160), "length 1", BODY1, 11)
    words(ax, (503, 160), "length 1", BODY2, 11)
    words(ax, (420, 32), "on either axis its shadow is 1 long", FAINT, 11)


def door(ax):
    """Right: a door from above, with its angle x, its two limits and the gap to the nearer one."""
    words(ax, (698, 350), "limits", size=12.5, weight="bold")
    pin, length, x, upper = np.array([640.0, 118.0]), 132.0, 58.0, 110.0
    ax.add_patch(Wedge(pin, length, 0, upper, facecolor=BODY2 + "12", edgecolor="none", zorder=1))
    ax.add_patch(Polygon([(586, 100), (640, 100), (640, 136), (586, 136)], facecolor=BODY1 + "26",
                         edgecolor=BODY1, linewidth=2))
    for degrees in (0, upper):
        line(ax, pin, at_angle(pin, length + 14, degrees), INK, (0, (4, 3)), 1.4)
    leaf = FancyBboxPatch((0, -6), length, 12, boxstyle="round,pad=0,rounding_size=5",
                          facecolor=named("leaf"), edgecolor=BODY2, linewidth=2, zorder=4)
    leaf.set_transform(Affine2D().rotate_deg(x).translate(*pin) + ax.transData)
    ax.add_patch(leaf)
    for start, end, radius, colour in ((0, x - 8, 64, BODY2), (x + 7, upper - 4, 92, INK)):
        ax.add_patch(Arc(pin, 2 * radius, 2 * radius, theta1=start, theta2=end, color=colour,
                         linewidth=2, zorder=4))
        last, before = at_angle(pin, radius, end + 4), at_angle(pin, radius, end - 3)
        arrow(ax, before, last, colour, 2)
    ax.plot(*pin, "o", color=INK, markersize=9, markeredgecolor=CARD, zorder=7)
    words(ax, at_angle(pin, 84, 26), "$x$", BODY2, 15)
    words(ax, at_angle(pin, 108, 86), "$C$", INK, 15)
    words(ax, (596, 86), "body 1", BODY1, 12)
    words(ax, at_angle(pin, length + 30, 58) + (6, 0), "body 2", BODY2, 12)
    words(ax, (762, 100), "lower", INK, 11)
    words(ax, (590, 268), "upper", INK, 11)
    words(ax, (698, 32), "$C$ is the remaining gap", FAINT, 11)


SWING_AXIS = np.array([0.57, -0.82, 0]) / np.hypot(0.57, 0.82)  # right, away, up
THETA, ALPHA = np.radians(75), np.radians(32)


def rotated(vector, axis, angle):
    """A vector, rotated about a unit vector."""
    along = axis * np.dot(axis, vector)
    return (along + (vector - along) * np.cos(angle)
            + np.cross(axis, vector) * np.sin(angle))


def body_with_axis(ax, middle, swing, twist, colour, name):
    """A disc across its axis, with a mark on it, after a twist and then a swing."""
    def place(vector):
        return middle + 105.0 * from_above(*rotated(vector, SWING_AXIS, swing))

    def rim(angle):
        return 0.85 * np.array([np.cos(angle), np.sin(angle), 0])

    ax.add_patch(Polygon([place(rim(angle)) for angle in np.linspace(0, 2 * np.pi, 73)],
                         facecolor=colour + "1c", edgecolor=colour, linewidth=1.5, zorder=2))
    start = np.radians(-60)
    arrow(ax, place(np.zeros(3)), place(np.array([0, 0, 1.25])), colour, 2.6)
    line(ax, place(np.zeros(3)), place(rim(start + twist)), colour, "solid", 2.6)
    words(ax, place(np.array([0, 0, 1.36])), name, colour, 14)
    return lambda angle, radius: place(radius * rim(start + angle))


def curved(ax, points, colour):
    """A curve with a head at its end."""
    ax.plot(*np.array(points).T, color=colour, linewidth=2, zorder=4)
    arrow(ax, points[-2], points[-1] + 3 * (points[-1] - points[-2]), colour, 2)


def twist(ax):
    """Left: a rotation about the axis, which stays."""
    words(ax, (150, 350), "first the twist", size=12.5, weight="bold")
    middle = np.array([150.0, 140.0])
    on_rim = body_with_axis(ax, middle, 0, THETA, BODY2, "$a_1$")
    line(ax, middle, on_rim(0, 1))
    curved(ax, [on_rim(angle, 0.72) for angle in np.linspace(0.06, THETA - 0.22, 30)], INK)
    words(ax, on_rim(0.5 * THETA, 0.42), "$\\theta$", INK, 14)
    words(ax, (150, 32), "by $\\theta$ about the axis, which stays", FAINT, 11)


def swing(ax):
    """Right: the shortest rotation that tips the axis."""
    words(ax, (450, 350), "then the swing", size=12.5, weight="bold")
    middle = np.array([450.0, 140.0])
    body_with_axis(ax, middle, ALPHA, THETA, BODY2, "$a_2$")

    def place(vector):
        return middle + 105.0 * from_above(*vector)

    up = np.array([0, 0, 1.25])
    arrow(ax, middle, place(up), FAINT, 1.6, dashed=True)
    words(ax, place(1.1 * up) + (4, 0), "$a_1$", FAINT, 14)
    curved(ax, [place(0.85 * rotated(up, SWING_AXIS, angle))
                for angle in np.linspace(0.02, ALPHA - 0.1, 30)], INK)
    words(ax, place(0.66 * rotated(up, SWING_AXIS, 0.5 * ALPHA)), "$\\alpha$", INK, 14)
    arrow(ax, middle, place(1.3 * SWING_AXIS), ARROW, 2.2)
    words(ax, place(1.46 * SWING_AXIS), "$n$", ARROW, 14)
    words(ax, (450, 32), "by $\\alpha$ about $n$, at right angles to both", FAINT, 11)


def couple(ax):
    """A motor between a ring and a wheel, seen along the axle."""
    words(ax, (210, 350), "a motor's couple", size=12.5, weight="bold")
    middle = np.array([210.0, 190.0])
    for radius, colour in ((112, BODY1), (78, CARD), (70, BODY2)):
        ax.add_patch(Ellipse(middle, 2 * radius, 2 * radius, zorder=1,
                             facecolor=CARD, edgecolor=BODY1 if colour == CARD else colour,
                             linewidth=2))
        if colour != CARD:
            ax.add_patch(Ellipse(middle, 2 * radius, 2 * radius, zorder=1, edgecolor="none",
                                 facecolor=colour + "26"))
    ax.plot(*middle, "o", color=INK, markersize=9, markeredgecolor=CARD, zorder=7)
    curved(ax, [at_angle(middle, 46, d) for d in np.linspace(20, 145, 40)], BODY2)
    curved(ax, [at_angle(middle, 126, d) for d in np.linspace(145, 20, 60)], BODY1)
    words(ax, at_angle(middle, 28, 82), "$\\tau$", BODY2, 15)
    words(ax, at_angle(middle, 143, 35) + (8, 0), "$-\\tau$", BODY1, 15)
    words(ax, middle + (0, -40), "body 2", BODY2, 12)
    words(ax, middle + (0, -95), "body 1", BODY1, 12)
    words(ax, (210, 32), "equal and opposite: the motor pushes no centre", FAINT, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_03", (shadow, rate, door), (280, 560), width=840,
         more={"twist": ((twist, swing), (300,), 600), "couple": ((couple,), (), 420)})
