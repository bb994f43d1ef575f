#!/usr/bin/env python3
"""Chapter 5's drawing: the load of a welded beam; two effects of an impulse at an anchor.

    python3 plots/geometry_05.py OUT.svg
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, FAINT, INK, arrow, dot, draw, words
from matplotlib.patches import Arc, FancyBboxPatch, Rectangle


def box(ax, centre, size, colour):
    """A cube, seen from the side."""
    corner = (centre[0] - size / 2, centre[1] - size / 2)
    ax.add_patch(FancyBboxPatch(corner, size, size, boxstyle="round,pad=0,rounding_size=6",
                                facecolor=colour + "26", edgecolor=colour, linewidth=2))


def wall(ax, right, low, high):
    """What does not move: a strip that ends at x = right."""
    ax.add_patch(Rectangle((right - 18, low), 18, high - low, facecolor=BODY1 + "26", linewidth=0))
    ax.plot((right, right), (low, high), color=BODY1, linewidth=2)


def turn(ax, centre, radius, start, end, colour):
    """A bent arrow round a centre from start to end [degrees], either way round."""
    ax.add_patch(Arc(centre, 2 * radius, 2 * radius, theta1=min(start, end),
                     theta2=max(start, end), color=colour, linewidth=2.2, zorder=4))
    angle = np.radians(end)
    tip = np.array(centre) + radius * np.array([np.cos(angle), np.sin(angle)])
    along = np.sign(end - start) * np.array([-np.sin(angle), np.cos(angle)])
    arrow(ax, tip - along, tip + 9 * along, colour)


def measure(ax, left, right, y, text):
    """A length between two marks, with its name in the middle."""
    ax.plot((left, right), (y, y), color=FAINT, linewidth=1.2)
    for x in (left, right):
        ax.plot((x, x), (y - 5, y + 5), color=FAINT, linewidth=1.2)
    words(ax, ((left + right) / 2, y - 13), text, FAINT)


def load(ax):
    """Left: a beam, its weight, and the load at the wall."""
    words(ax, (180, 350), "the load of a weld", size=12.5, weight="bold")
    edge, left, y, cubes = 46, 72.0, 190.0, 5
    wall(ax, left, y - 75, y + 75)
    for k in range(cubes):
        box(ax, (left + (k + 0.5) * edge, y), edge - 3, BODY2)
    p, middle = (left, y), (left + cubes * edge / 2, y)
    arrow(ax, p, (left, y + 92), INK, 3)
    turn(ax, p, 38, -70, 55, INK)
    arrow(ax, middle, (middle[0], y - 92))
    dot(ax, p, INK)
    dot(ax, middle, ARROW)
    words(ax, (left + 14, y + 90), "$F = n\\,m\\,g$", ha="left")
    words(ax, (left + 44, y + 44), "$\\tau_p = n^2 m\\,g\\,L/2$", ha="left")
    words(ax, (middle[0] + 12, y - 84), "$n\\,m\\,g$", ARROW, ha="left")
    words(ax, (left + 14, y + 8), "$p$", size=12)
    measure(ax, left, middle[0], y - 42, "$nL/2$")
    words(ax, (180, 32), "$F$ and $\\tau_p$ act on the first cube", FAINT, 11)


def effects(ax):
    """Right: a push at a far anchor moves the body a little and turns it a lot."""
    words(ax, (520, 350), "two blocks that fight", size=12.5, weight="bold")
    p, x = np.array([388.0, 140.0]), np.array([628.0, 140.0])
    moving, turning = np.array([0, 34.0]), np.array([0, 100.0])  # parts of the anchor's speed
    wall(ax, p[0] - 12, 75, 305)
    box(ax, x, 84, BODY2)
    ax.plot(*zip(p, x), color=FAINT, linewidth=1.6)
    arrow(ax, p, p + moving, ARROW, 3)
    arrow(ax, p + moving, p + moving + turning, BODY2, 3)
    arrow(ax, x, x + moving, ARROW, 3)
    turn(ax, x, 62, 215, 150, BODY2)
    dot(ax, p, INK)
    dot(ax, x, BODY2)
    words(ax, p - (0, 16), "$p$", size=12)
    words(ax, (p + x) / 2 - (0, 14), "$r$", FAINT)
    words(ax, p + moving / 2 + (10, 2), "$P/m$ moves the body", ARROW, 11.5, ha="left")
    words(ax, p + moving + turning / 2 + (10, 12), "$P\\,r^2/i$ rotates it", BODY2, 11.5, ha="left")
    words(ax, p + moving + turning / 2 + (10, -8), "and the lock undoes that", BODY2, 10,
          ha="left")
    words(ax, x - (0, 60), "body 2", BODY2, 12)
    words(ax, (520, 32), "effect of an impulse $P$ at the anchor", FAINT, 11)


if __name__ == "__main__":
    draw(__doc__, "geometry_05", (load, effects), (338,))
