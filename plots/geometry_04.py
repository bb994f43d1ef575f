#!/usr/bin/env python3
"""Chapter 4's drawings: the line, the displacement and the lever p2 - x1; the excess rotation. And
couple.svg: the impulses of an open ball joint act along two lines, those of a slider along one.

    python3 plots/geometry_04.py geometry.svg|couple.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, FAINT, INK, LEVER, arrow, below, body, direction, dot,
                     draw, line, title, turn, words)
from matplotlib.patches import Arc

TILT = 12  # of body 1 [degrees]


def rail(ax):
    """Left: the line rides on body 1; u has a part along it and a part across."""
    title(ax, 212, "a point on a line of body 1")
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
    under = -17 * n
    ax.annotate("", xy=foot + under, xytext=p1 + under, zorder=4,
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
    below(ax, 212, "$n_2$ points out of the page, at you")


def lock(ax):
    """Right: the required orientation of body 2, and its rotation beyond that."""
    title(ax, 562, "the excess rotation")
    x1, x2 = np.array([540.0, 92.0]), np.array([566.0, 228.0])
    meant, now = TILT + 6, TILT + 38
    size = (136, 66)
    body(ax, x1, (148, 66), TILT, BODY1)
    body(ax, x2, size, meant, BODY2, ghost=True)
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
    below(ax, 562, "the axis of $q_e$, and $C$, point at you")


def pushed(ax, place, across, colour, text, side):
    """An impulse along its dotted line, with its name beside its tip."""
    line(ax, (place[0], 72), (place[0], 312), dashes=":")
    arrow(ax, place, place + across, colour, 3)
    words(ax, place + 0.86 * across + np.array([side, 0]), text, colour, 14)


def two_lines(ax):
    """Left: the gap of a ball joint is open, and its two impulses are a couple."""
    title(ax, 178, "an open ball joint: the pair turns")
    p1, p2, up = np.array([118.0, 178.0]), np.array([238.0, 208.0]), np.array([0, 88.0])
    body(ax, p1 - (36, 26), (132, 82), 8, BODY1)
    body(ax, p2 + (34, 10), (124, 76), -6, BODY2)
    arrow(ax, p1, p2, INK, 3)
    pushed(ax, p2, up, BODY2, "$\\lambda$", 18)
    pushed(ax, p1, -up, BODY1, "$-\\lambda$", -24)
    turn(ax, (p1 + p2) / 2, 92, 62, 116, LEVER, 3)
    turn(ax, (p1 + p2) / 2, 92, 242, 296, LEVER, 3)
    for place, colour in ((p1, BODY1), (p2, BODY2)):
        dot(ax, place, colour)
    words(ax, p1 + (-17, 8), "$p_1$", BODY1)
    words(ax, p2 + (18, -10), "$p_2$", BODY2)
    words(ax, (p1 + p2) / 2 + (-6, 16), "$u$", INK, 15)
    words(ax, p1 + (-56, -40), "body 1", BODY1, 12)
    words(ax, p2 + (58, 28), "body 2", BODY2, 12)
    below(ax, 178, "two lines, $u$ apart: a couple")


def one_line(ax):
    """Right: the lever of a slider's body 1 ends where body 2 touches the line."""
    title(ax, 530, "a slider: nothing turns")
    rail, p2, up = np.array([398.0, 190.0]), np.array([570.0, 190.0]), np.array([0, 88.0])
    x1 = rail + (50, -62)
    body(ax, x1, (132, 72), 0, BODY1)
    body(ax, p2 + (18, 16), (124, 72), 0, BODY2)
    line(ax, rail - (0, 26), rail, BODY1, "solid", 2.6)
    line(ax, rail, (672, rail[1]), BODY1, "solid", 2.6)
    arrow(ax, x1, p2, LEVER, 2.6)
    pushed(ax, p2, up, BODY2, "$\\lambda\\, n$", 26)
    pushed(ax, p2, -up, BODY1, "$-\\lambda\\, n$", 34)
    for place, colour in ((x1, BODY1), (p2, BODY2)):
        dot(ax, place, colour)
    words(ax, p2 + (-17, 14), "$p_2$", BODY2)
    words(ax, x1 + (-15, 0), "$x_1$", BODY1)
    words(ax, x1 + (30, -20), "body 1", BODY1, 12)
    words(ax, p2 + (48, 34), "body 2", BODY2, 12)
    words(ax, (x1 + p2) / 2 + (30, -14), "lever", LEVER, 12)
    below(ax, 530, "one line, through $p_2$: they cancel")


if __name__ == "__main__":
    draw(__doc__, "geometry_04", geometry=((rail, lock), (0, 700, 0, 380), 423),
         couple=((two_lines, one_line), (0, 700, 6, 376), 356))
