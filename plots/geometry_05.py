#!/usr/bin/env python3
"""Chapter 5's drawing: what a wall gives to a welded beam; the two shares of a push at an anchor.

    python3 plots/geometry_05.py OUT.svg
"""
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.patches import Arc, FancyBboxPatch, Rectangle  # noqa: E402

CARD, INK, FAINT = "#f7f5ef", "#222222", "#6b6b6b"
BODY1, BODY2, ARROW = "#0072B2", "#D55E00", "#009E73"
WIDTH, HEIGHT = 700, 380  # [px]

plt.rcParams.update({"svg.hashsalt": "geometry_05", "font.family": "DejaVu Sans",
                     "mathtext.fontset": "dejavusans"})


def box(ax, centre, size, colour):
    """A cube, seen from the side."""
    corner = (centre[0] - size / 2, centre[1] - size / 2)
    ax.add_patch(FancyBboxPatch(corner, size, size, boxstyle="round,pad=0,rounding_size=6",
                                facecolor=colour + "26", edgecolor=colour, linewidth=2))


def wall(ax, right, low, high):
    """What does not move: a strip that ends at x = right."""
    ax.add_patch(Rectangle((right - 18, low), 18, high - low, facecolor=BODY1 + "26", linewidth=0))
    ax.plot((right, right), (low, high), color=BODY1, linewidth=2)


def arrow(ax, start, end, colour=ARROW, width=2.2):
    ax.annotate("", xy=end, xytext=start, zorder=4,
                arrowprops={"arrowstyle": "-|>,head_width=0.3,head_length=0.6", "color": colour,
                            "linewidth": width, "shrinkA": 0, "shrinkB": 0})


def turn(ax, centre, radius, start, end, colour):
    """A bent arrow round a centre from start to end [degrees], either way round."""
    ax.add_patch(Arc(centre, 2 * radius, 2 * radius, theta1=min(start, end),
                     theta2=max(start, end), color=colour, linewidth=2.2, zorder=4))
    angle = np.radians(end)
    tip = np.array(centre) + radius * np.array([np.cos(angle), np.sin(angle)])
    along = np.sign(end - start) * np.array([-np.sin(angle), np.cos(angle)])
    arrow(ax, tip - along, tip + 9 * along, colour)


def dot(ax, place, colour, size=7):
    ax.plot(*place, "o", color=colour, markersize=size, markeredgecolor=CARD, zorder=5)


def words(ax, place, text, colour=INK, size=13, **more):
    more = {"ha": "center", "va": "center", "zorder": 6} | more
    ax.text(*place, text, color=colour, fontsize=size, **more)


def measure(ax, left, right, y, text):
    """A length between two marks, with its name in the middle."""
    ax.plot((left, right), (y, y), color=FAINT, linewidth=1.2)
    for x in (left, right):
        ax.plot((x, x), (y - 5, y + 5), color=FAINT, linewidth=1.2)
    words(ax, ((left + right) / 2, y - 13), text, FAINT)


def load(ax):
    """Left: a beam, its weight, and what the wall puts on it."""
    words(ax, (180, 350), "what a weld carries", size=12.5, weight="bold")
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
    words(ax, (180, 32), "$F$ and $\\tau_p$: what the first cube gets", FAINT, 11)


def shares(ax):
    """Right: a push at a far anchor moves the body a little and turns it a lot."""
    words(ax, (520, 350), "two that fight", size=12.5, weight="bold")
    p, x = np.array([388.0, 140.0]), np.array([628.0, 140.0])
    moving, turning = np.array([0, 34.0]), np.array([0, 100.0])  # shares of the anchor's speed
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
    words(ax, p + moving + turning / 2 + (10, 12), "$P\\,r^2/i$ turns it", BODY2, 11.5, ha="left")
    words(ax, p + moving + turning / 2 + (10, -8), "and the lock takes that back", BODY2, 10,
          ha="left")
    words(ax, x - (0, 60), "body 2", BODY2, 12)
    words(ax, (520, 32), "a push $P$ at the anchor, and the speed it gives", FAINT, 11)


def main(path):
    figure = plt.figure(figsize=(WIDTH / 96, HEIGHT / 96))
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set_xlim(0, WIDTH)
    ax.set_ylim(0, HEIGHT)
    ax.set_axis_off()
    ax.add_patch(FancyBboxPatch((1, 1), WIDTH - 2, HEIGHT - 2, facecolor=CARD, edgecolor="#d9d5c8",
                                linewidth=1, boxstyle="round,pad=0,rounding_size=12", zorder=0))
    ax.plot((338, 338), (45, 330), color="#d9d5c8", linewidth=1.2)
    load(ax)
    shares(ax)
    metadata = {"Date": None} if path.endswith(".svg") else None
    figure.savefig(path, transparent=True, metadata=metadata)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
