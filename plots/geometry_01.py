#!/usr/bin/env python3
"""Chapter 1's drawings: the rod and its error; an impulse pair, and a rope's sum of impulses.

    python3 plots/geometry_01.py geometry.svg|impulses.svg
"""
import math

from drawing import (ARROW, BODY1, BODY2, CARD, FAINT, INK, arrow, below, body, dot, draw, line,
                     measure, title, words)
from matplotlib.patches import Circle, Rectangle


def along(start, direction, distance, aside=0.0):
    """The point `distance` further in a direction and `aside` to the left of it."""
    (x, y), (a, b) = start, direction
    return x + distance * a - aside * b, y + distance * b + aside * a


def toward(start, end):
    """Unit direction and distance from one point to another."""
    x, y = end[0] - start[0], end[1] - start[1]
    size = math.hypot(x, y)
    return (x / size, y / size), size


def ball(ax, centre, radius, colour):
    ax.add_patch(Circle(centre, radius, facecolor=CARD, edgecolor="none", zorder=2.5))
    ax.add_patch(Circle(centre, radius, facecolor=colour + "26", edgecolor=colour, linewidth=2,
                        zorder=3))
    dot(ax, centre, colour)


# ---- geometry.svg --------------------------------------------------------------------------------

def centre_to_centre(ax):
    metre, n = 112, (0.6, 0.8)
    x1 = (120, 64)
    x2 = along(x1, n, 2 * metre)
    slant = {"rotation": math.degrees(math.atan2(n[1], n[0])), "rotation_mode": "anchor"}
    title(ax, 172, "from centre to centre")

    line(ax, x1, x2, FAINT, "solid", 5, 1)
    ball(ax, x1, 28, BODY1)
    ball(ax, x2, 28, BODY2)
    words(ax, (x1[0] - 62, x1[1] - 20), "body 1", BODY1, 12)
    words(ax, (x2[0] + 58, x2[1] - 20), "body 2", BODY2, 12)
    words(ax, (x1[0] - 12, x1[1] - 12), "$x_1$", BODY1, 12)
    words(ax, (x2[0] + 10, x2[1] - 15), "$x_2$", BODY2, 12)

    arrow(ax, x1, along(x1, n, metre), width=3)
    words(ax, along(x1, n, 0.86 * metre, -17), "$n$", ARROW, 14)
    v1, v2 = (x1[0] + 66, x1[1] - 14), (x2[0] + 72, x2[1] + 36)
    arrow(ax, x1, v1, BODY1)
    arrow(ax, x2, v2, BODY2)
    words(ax, (v1[0] + 14, v1[1] - 1), "$v_1$", BODY1)
    words(ax, (v2[0] - 2, v2[1] + 17), "$v_2$", BODY2)

    near, far = 45, 82  # how far aside the two measures stand
    for place in (x1, x2):
        line(ax, along(place, n, 0, 30), along(place, n, 0, far + 8), FAINT, (0, (3, 3)), 0.8)
    end = along(x1, n, 1.5 * metre, near)
    measure(ax, along(x1, n, 0, near), end)
    measure(ax, end, along(x2, n, 0, near), width=4)
    measure(ax, along(x1, n, 0, far), along(x2, n, 0, far))
    words(ax, along(x1, n, 0.75 * metre, near + 14), "$d$", INK, 13, **slant)
    words(ax, along(x1, n, 1.75 * metre, near + 16), "$C$", INK, 14, **slant)
    words(ax, along(x1, n, metre, far + 15), "$|x_2 - x_1|$", INK, 13, **slant)


def turned(centre, degrees, lever):
    """Where the end of a lever is when its body is turned."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return centre[0] + c * lever[0] - s * lever[1], centre[1] + s * lever[0] + c * lever[1]


def anchor_to_anchor(ax):
    title(ax, 525, "from any point to any point")
    x1, x2 = (448, 95), (603, 250)
    body(ax, x1, (136, 96), 18, BODY1)
    body(ax, x2, (140, 96), -20, BODY2)
    p1, p2 = turned(x1, 18, (44, -14)), turned(x2, -20, (-44, -6))
    words(ax, (x1[0] - 44, x1[1] + 66), "body 1", BODY1, 12)
    words(ax, (x2[0] + 40, x2[1] - 76), "body 2", BODY2, 12)

    arrow(ax, x1, p1)
    arrow(ax, x2, p2)
    arrow(ax, p1, p2, INK, 3)
    for place, colour in ((x1, BODY1), (x2, BODY2), (p1, BODY1), (p2, BODY2)):
        dot(ax, place, colour)
    words(ax, (x1[0] - 16, x1[1] - 2), "$x_1$", BODY1, 12)
    words(ax, (x2[0] + 16, x2[1] + 4), "$x_2$", BODY2, 12)
    words(ax, along(x1, toward(x1, p1)[0], 23, 14), "$r_1$", ARROW)
    words(ax, along(x2, toward(x2, p2)[0], 24, -16), "$r_2$", ARROW)
    words(ax, (p1[0] + 2, p1[1] - 17), "$p_1$", BODY1)
    words(ax, (p2[0] - 7, p2[1] + 17), "$p_2$", BODY2)
    direction, size = toward(p1, p2)
    words(ax, along(p1, direction, size / 2, -16), "$u$", INK, 15)


# ---- impulses.svg --------------------------------------------------------------------------------

def pair(ax):
    """Left: one impulse and its opposite, and how much of K each body is."""
    title(ax, 176, "one impulse: which body yields?")
    x1, x2, size = (110, 262), (242, 262), 62
    line(ax, x1, x2, FAINT, "solid", 5, 1)
    ball(ax, x1, 24, BODY1)
    ball(ax, x2, 29, BODY2)
    arrow(ax, x1, (x1[0] - size, x1[1]), width=3)
    arrow(ax, x2, (x2[0] + size, x2[1]), width=3)
    words(ax, (x1[0] - 46, x1[1] + 20), "$-\\lambda n$", ARROW)
    words(ax, (x2[0] + 50, x2[1] + 20), "$+\\lambda n$", ARROW)
    words(ax, (x1[0], x1[1] - 42), "body 1: 2 kg", BODY1, 12)
    words(ax, (x2[0], x2[1] - 46), "body 2: 3 kg", BODY2, 12)

    left, foot, height, one = 42, 104, 30, 312  # [px]; `one` for 1 m/s
    words(ax, (left, 166), "change of $J V$ by 1 N s", INK, 11, ha="left")
    for start, share, colour, text in ((0, 1 / 2, BODY1, "$1/m_1 = 1/2$"),
                                       (1 / 2, 1 / 3, BODY2, "$1/m_2 = 1/3$")):
        ax.add_patch(Rectangle((left + one * start, foot), one * share, height,
                               facecolor=colour + "26", edgecolor=colour, linewidth=2, zorder=3))
        words(ax, (left + one * (start + share / 2), foot + height / 2), text, colour, 12)
    measure(ax, (left, foot - 20), (left + one * 5 / 6, foot - 20))
    words(ax, (left + one * 5 / 12, foot - 40), "$K = 5/6$ per kg", INK, 13)
    below(ax, 176, "the lighter body yields more")


def staircase(ax, place, sums, colour, width, dashes="-"):
    """A sum that each iteration changes."""
    points = [place(0, sums[0])]
    for iteration, value in enumerate(sums[1:], 1):
        points += [place(iteration, sums[iteration - 1]), place(iteration, value)]
    points.append(place(len(sums), sums[-1]))
    ax.plot(*zip(*points), color=colour, linewidth=width, linestyle=dashes, zorder=4,
            solid_joinstyle="miter")


def rope_sum(ax):
    """Right: +5, -3 and -4 are required; the clamped sum ends at 0, clamped impulses at 5."""
    title(ax, 528, "a rope: clamp the sum, at 0")

    def place(iteration, newton_seconds):
        return 402 + 60 * iteration, 138 + 30 * newton_seconds

    ax.add_patch(Rectangle(place(0, -2.6), 60 * 4.5, 2.6 * 30, facecolor=FAINT + "22",
                           edgecolor="none"))
    words(ax, place(1.4, -1.3), "a rope does not push", FAINT, 11)
    arrow(ax, place(0, -2.6), place(0, 6.4), FAINT, 1.2)
    line(ax, place(0, 0), place(4.5, 0), FAINT, "solid", 1.2)
    for value in (0, 2, 5):
        words(ax, (place(0, 0)[0] - 14, place(0, value)[1]), str(value), INK, 11)
    words(ax, place(0.1, 6.3), "sum of its impulses [N s]", INK, 11, ha="left")
    staircase(ax, place, (0, 5, 5, 5), BODY2, 2, (0, (4, 2)))
    words(ax, (place(3, 5)[0] + 10, place(3, 5)[1] - 14), "each clamped: 5", BODY2, 11)
    staircase(ax, place, (0, 5, 2, 0), ARROW, 3)
    words(ax, (place(3, 0)[0] + 6, place(3, 0)[1] + 24), "the sum\nclamped: 0", ARROW, 11,
          ha="left")
    arrow(ax, place(3, 0), place(3, -2), FAINT, 1.6, dashed=True)
    for iteration, asked, high in ((1, "+5", 2.5), (2, "$-$3", 3.5), (3, "$-$4", 1.1)):
        x, y = place(iteration, high)
        words(ax, (x - 17, y), asked, INK, 12)
        words(ax, place(iteration, -3.05), str(iteration), INK, 11)
    words(ax, place(3.12, -1.2), "$-$2 refused", FAINT, 11, ha="left")
    words(ax, (528, 28), "iteration", INK, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_01",
         geometry=((centre_to_centre, anchor_to_anchor), (0, 700, 0, 380), 350),
         impulses=((pair, rope_sum), (0, 700, 0, 380), 365))
