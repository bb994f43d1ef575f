#!/usr/bin/env python3
"""Chapter 4's drawings: the line, the displacement and the lever p2 - x1; the excess rotation. And
couple.svg: the impulses of an open ball joint act along two lines, those of a slider along one.

    python3 plots/geometry_04.py geometry.svg|couple.svg
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, FAINT, INK, arrow, body, dot, draw, named, words
from matplotlib.patches import Arc, FancyBboxPatch
from matplotlib.transforms import Affine2D

LEVER = named("lever")
TILT = 12  # of body 1 [degrees]


def direction(degrees):
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def ghost(ax, centre, size, degrees, colour):
    """Where a body ought to be: its dashed outline."""
    w, h = size
    box = FancyBboxPatch((-w / 2, -h / 2), w, h, boxstyle="round,pad=0,rounding_size=10",
                         facecolor="none", edgecolor=colour, linewidth=1.4, linestyle=(0, (4, 3)))
    box.set_transform(Affine2D().rotate_deg(degrees).translate(*centre) + ax.transData)
    ax.add_patch(box)


def line(ax):
    """Left: the line rides on body 1; u has a part along it and a part across."""
    words(ax, (212, 352), "a point on a line of body 1", size=12.5, weight="bold")
    a, n = direction(TILT), direction(TILT + 90)
    x1 = np.array([100.0, 99.0])
    p1 = x1 + 14 * a + 74 * n
    foot = p1 + 190 * a
    p2 = foot + 46 * n
    x2 = p2 + np.array([36.0, 28.0])
    body(ax, x1, (148, 80), TILT, BODY1)
    body(ax, x2, (112, 74), TILT + 8, BODY2)
    foot_of_post, end = p1 - 46 * a - 34 * n, p1 + 252 * a
    ax.plot(*zip(foot_of_post, p1 - 46 * a, end), color=BODY1, linewidth=2.6, zorder=2)
    arrow(ax, x1, p2, LEVER, 2.6)
    arrow(ax, x1, p1)
    arrow(ax, x2, p2)
    arrow(ax, p1, p2, INK, 3)
    arrow(ax, p1, p1 + 44 * n, BODY1, 2)
    ax.plot(*zip(foot, p2), color=FAINT, linewidth=1.4, linestyle=":", zorder=3)
    for place, colour in ((x1, BODY1), (p1, BODY1), (x2, BODY2), (p2, BODY2)):
        dot(ax, place, colour)
    below = -17 * n
    ax.annotate("", xy=foot + below, xytext=p1 + below, zorder=4,
                arrowprops={"arrowstyle": "<|-|>,head_width=0.2,head_length=0.4", "color": FAINT,
                            "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0})
    words(ax, (p1 + foot) / 2 + 46 * a - 31 * n, "displacement $u \\cdot a$", FAINT, 11,
          rotation=TILT)
    words(ax, foot + 15 * n + 26 * a, "$u \\cdot n_1$", FAINT, 11)
    words(ax, x1 - 13 * n - 13 * a, "$x_1$", BODY1)
    words(ax, p1 - 19 * a + 14 * n, "$p_1$", BODY1)
    words(ax, p1 + 44 * n + 15 * a, "$n_1$", BODY1)
    words(ax, end + 12 * a, "$a$", BODY1)
    words(ax, p2 - 27 * a + 22 * n, "$p_2$", BODY2)
    words(ax, x2 + np.array([19, 6]), "$x_2$", BODY2)
    words(ax, (x1 + p1) / 2 - 14 * a + 14 * n, "$r_1$", ARROW)
    words(ax, (x2 + p2) / 2 + 10 * a - 12 * n, "$r_2$", ARROW)
    words(ax, p1 + 95 * a + 36 * n, "$u$", INK, 15)
    words(ax, (288, 135), "lever $r_1 + u = p_2 - x_1$", LEVER, 12)
    words(ax, (144, 88), "body 1", BODY1, 12, rotation=TILT)
    words(ax, x2 + 23 * n, "body 2", BODY2, 12, rotation=TILT + 8)
    words(ax, (212, 28), "$n_2$ points out of the page, at you", FAINT, 11)


def lock(ax):
    """Right: the required orientation of body 2, and its rotation beyond that."""
    words(ax, (562, 352), "the excess rotation", size=12.5, weight="bold")
    x1, x2 = np.array([540.0, 92.0]), np.array([566.0, 228.0])
    meant, now = TILT + 6, TILT + 38
    size = (136, 66)
    body(ax, x1, (148, 66), TILT, BODY1)
    ghost(ax, x2, size, meant, BODY2)
    body(ax, x2, size, now, BODY2)
    for degrees, dashes in ((meant, (4, 3)), (now, (1, 0))):
        ax.plot(*zip(x2, x2 + 92 * direction(degrees)), color=BODY2, linewidth=1.4, zorder=3,
                linestyle=(0, dashes))
    ax.add_patch(Arc(x2, 168, 168, theta1=meant, theta2=now - 4, color=LEVER, linewidth=2.6,
                     zorder=4))
    tip = x2 + 84 * direction(now)
    along = direction(now + 90)
    arrow(ax, tip - 9 * along, tip, LEVER, 2.6)
    dot(ax, x2, BODY2)
    dot(ax, x1, BODY1)
    words(ax, x2 + 104 * direction((meant + now) / 2), "$q_e$", LEVER, 15)
    words(ax, (626, 182), "as required", BODY2, 10.5)
    words(ax, (560, 314), "as it is", BODY2, 10.5)
    words(ax, x1 + 37 * direction(TILT), "body 1", BODY1, 12, rotation=TILT)
    words(ax, (562, 28), "the axis of $q_e$, and $C$, point at you", FAINT, 11)


def pushed(ax, place, across, colour, text, side):
    """An impulse at a place, with its name beside its tip."""
    arrow(ax, place, place + across, colour, 3)
    words(ax, place + 0.86 * across + np.array([side, 0]), text, colour, 14)


def two_lines(ax):
    """Left: the gap of a ball joint is open, and its two impulses are a couple."""
    words(ax, (178, 352), "an open ball joint: two lines", size=12.5, weight="bold")
    p1, p2, up = np.array([118.0, 168.0]), np.array([228.0, 204.0]), np.array([0, 92.0])
    body(ax, p1 - (36, 26), (132, 82), 8, BODY1)
    body(ax, p2 + (34, 10), (124, 76), -6, BODY2)
    for place in (p1, p2):
        ax.plot((place[0], place[0]), (64, 318), color=FAINT, linewidth=1.2, linestyle=":")
    arrow(ax, p1, p2, INK, 3)
    pushed(ax, p2, up, BODY2, "$\\lambda$", 18)
    pushed(ax, p1, -up, BODY1, "$-\\lambda$", 26)
    for place, colour in ((p1, BODY1), (p2, BODY2)):
        dot(ax, place, colour)
    words(ax, p1 + (-17, 8), "$p_1$", BODY1)
    words(ax, p2 + (18, -10), "$p_2$", BODY2)
    words(ax, (p1 + p2) / 2 + (-6, 16), "$u$", INK, 15)
    words(ax, p1 + (-60, -34), "body 1", BODY1, 12)
    words(ax, p2 + (58, 28), "body 2", BODY2, 12)
    words(ax, (178, 28), "added angular momentum: $u \\times \\lambda$", FAINT, 11)


def one_line(ax):
    """Right: the lever of a slider's body 1 ends where body 2 touches the line."""
    words(ax, (530, 352), "a slider: one line", size=12.5, weight="bold")
    p1, p2, up = np.array([430.0, 190.0]), np.array([570.0, 190.0]), np.array([0, 92.0])
    x1 = p1 + (18, -62)
    body(ax, x1, (132, 72), 0, BODY1)
    body(ax, p2 + (18, 16), (124, 72), 0, BODY2)
    ax.plot((p1[0] - 32, p1[0] - 32), (x1[1] + 36, p1[1]), color=BODY1, linewidth=2.6)
    ax.plot((p1[0] - 32, 672), (p1[1], p1[1]), color=BODY1, linewidth=2.6, zorder=3)
    ax.plot((p2[0], p2[0]), (64, 318), color=FAINT, linewidth=1.2, linestyle=":")
    arrow(ax, x1, p2, LEVER, 2.6)
    arrow(ax, p1, p2, INK, 3)
    pushed(ax, p2, up, BODY2, "$\\lambda\\, n$", 26)
    pushed(ax, p2, -up, BODY1, "$-\\lambda\\, n$", 34)
    for place, colour in ((p1, BODY1), (x1, BODY1), (p2, BODY2)):
        dot(ax, place, colour)
    words(ax, p1 + (-4, 15), "$p_1$", BODY1)
    words(ax, p2 + (17, -31), "$p_2$", BODY2)
    words(ax, (p1 + p2) / 2 + (-8, 14), "$u$", INK, 15)
    words(ax, x1 + (-15, 0), "$x_1$", BODY1)
    words(ax, x1 + (30, -18), "body 1", BODY1, 12)
    words(ax, p2 + (48, 28), "body 2", BODY2, 12)
    words(ax, (530, 28), "both impulses act at $p_2$: they cancel", FAINT, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_04", (line, lock), (423,),
         more={"couple": ((two_lines, one_line), (356,))})
