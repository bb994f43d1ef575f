#!/usr/bin/env python3
"""Chapter 8's drawings: a corner over the ground (geometry); the wedge of friction (wedge); a
rebound in two steps (rebound).

    python3 plots/geometry_08.py geometry.svg|wedge.svg|rebound.svg
"""
import numpy as np
from drawing import (ARROW, BODY1, BODY2, FAINT, INK, arrow, below, body, direction, dot, draw,
                     ground, into_page, line, measure, title, words)
from matplotlib.patches import Circle, Polygon


def corner(ax):
    """The lowest corner of a tilted box, its levers and its three directions."""
    title(ax, 230, "the gap $C$ under a corner, and three directions")
    top, half, tilt = 140.0, (80, 46), -30
    x1, x2 = np.array([120.0, 76.0]), np.array([200.0, 260.0])
    ground(ax, 30, 430, top, 88)
    body(ax, x2, 2 * np.array(half), tilt, BODY2, rounding=1)
    p = x2 + half[0] * direction(tilt) - half[1] * direction(tilt + 90)
    arrow(ax, x1, p, FAINT)
    arrow(ax, x2, p, FAINT)
    arrow(ax, p, p + (0, 74), width=3)
    arrow(ax, p, p + (90, 0), width=3)
    for x, low, high, name in ((p[0] - 34, top, p[1], "$C$"), (62, x1[1], top, "height")):
        measure(ax, (x, low), (x, high), name, (-8, 0), ha="right",
                size=14 if name == "$C$" else 11)
    line(ax, p - (42, 0), p)
    line(ax, (54, x1[1]), x1)
    dot(ax, p, INK)
    dot(ax, x1, BODY1)
    dot(ax, x2, BODY2)
    t2 = p + (44, -24)
    into_page(ax, t2, ARROW)
    words(ax, p + (12, 62), "$n$", ARROW, 14)
    words(ax, p + (102, 0), "$t_1$", ARROW, 14)
    words(ax, t2 + (20, -1), "$t_2$", ARROW, 14)
    below(ax, 230, "$n$: up.  $t_1$: the way it slides.  $t_2$: into the page", 26)
    words(ax, p + (11, -13), "$p$", INK)
    words(ax, (x1 + p) / 2 + (22, -18), "$r_1$", FAINT)
    words(ax, (x2 + p) / 2 + (10, 16), "$r_2$", FAINT)
    words(ax, x1 + (2, -14), "$x_1$", BODY1)
    words(ax, x2 + (-14, 9), "$x_2$", BODY2)
    words(ax, (390, 66), "body 1", BODY1, 12)
    words(ax, x2 + (110, 36), "body 2", BODY2, 12)


def wedge(ax):
    """Normal impulse and friction impulse of a corner, before and after a solve."""
    title(ax, 230, "friction is clamped to a wedge")
    origin, right, slope = np.array([50.0, 190.0]), 330.0, 0.42
    ends = [origin + (right, sign * slope * right) for sign in (1, -1)]
    ax.add_patch(Polygon([origin, *ends], closed=True, facecolor=BODY1 + "1c", linewidth=0))
    for end in ends:
        line(ax, origin, end, BODY1, "solid", 2)
    arrow(ax, origin, origin + (right + 26, 0), INK, 1.5)
    arrow(ax, origin - (0, 138), origin + (0, 136), INK, 1.5)
    words(ax, origin + (right + 10, 18), "normal impulse $\\lambda_n$", INK, 12)
    words(ax, origin + (10, 130), "friction impulse", INK, 12, ha="left")
    words(ax, ends[0] + (14, 0), "$+\\mu\\,\\lambda_n$", BODY1, ha="left")
    words(ax, ends[1] + (14, 0), "$-\\mu\\,\\lambda_n$", BODY1, ha="left")
    wanted = origin + (150, -126)
    kept = origin + (150, -slope * 150)
    arrow(ax, wanted, kept + (0, -4), BODY2, 3)
    dot(ax, wanted, BODY2)
    dot(ax, kept, INK, 8)
    words(ax, wanted + (12, 0), "wanted", BODY2, 12, ha="left")
    words(ax, kept + (12, 6), "clamped: it slides", INK, 12, ha="left")
    held = origin + (190, 40)
    dot(ax, held, ARROW, 8)
    words(ax, held + (12, 0), "inside: it holds", ARROW, 12, ha="left")


def rebound(ax):
    """A ball before and after the two steps that a rebound takes."""
    title(ax, 230, "a rebound takes two steps")
    top, radius, places = 118.0, 19.0, (80.0, 230.0, 380.0)
    ground(ax, 20, 440, top)
    for x, bottom in zip(places, (top + 100, top, top + 130)):
        ax.add_patch(Circle((x, bottom + radius), radius, facecolor=BODY2 + "26", edgecolor=BODY2,
                            linewidth=2, zorder=3))
    arrow(ax, (places[0], top + 100), (places[0], top + 1), BODY2, 3)
    measure(ax, (places[0] - 30, top), (places[0] - 30, top + 100), "$C$", (-12, 0))
    words(ax, (places[0] + 10, top + 66), "$v_{\\mathrm{hit}}$", BODY2, ha="left")
    arrow(ax, (places[1], top + 2 * radius + 2), (places[1], top + 140), ARROW, 3)
    words(ax, (places[1] + 10, top + 122), "$e\\,v_{\\mathrm{hit}}$", ARROW, ha="left")
    arrow(ax, (places[2], top), (places[2], top + 128), ARROW, 3)
    for left, said in ((0, "step 1: down to\nthe ground"), (1, "step 2: up")):
        arrow(ax, (places[left] + 32, 308), (places[left + 1] - 32, 308), INK, 1.4)
        words(ax, ((places[left] + places[left + 1]) / 2, 288 - 8 * (left == 0)), said, INK, 12)
    below(ax, 230, "$e$: restitution, the speed after over the speed before", 34)


if __name__ == "__main__":
    draw(__doc__, "geometry_08", geometry=((corner,), (0, 460, 4, 376)),
         wedge=((wedge,), (0, 470, 34, 376)), rebound=((rebound,), (0, 460, 12, 376)))
