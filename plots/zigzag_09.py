"""Chapter 9's zigzag: a taut chain whose links turn about their centres, and one link of it.

geometry_09.py draws it, zigzag.svg.
"""
import numpy as np
from drawing import ARROW, BODY1, BODY2, FAINT, INK, arrow, body, dot, draw, words
from matplotlib.patches import Arc

LINKS, SPACING, LEVER, TILT = 5, 74.0, 37.0, 20.0  # of the chain [px, degrees]


def chain(ax):
    """Left: the centres stay on the line, the joints leave it by turns."""
    words(ax, (236, 352), "the fastest oscillation of a taut chain", size=12.5, weight="bold")
    first, height = 88.0, 200.0
    ax.plot((30, 442), (height, height), color=FAINT, linewidth=1.2, linestyle=(0, (4, 3)))
    shrink = np.cos(np.radians(TILT))
    for k in range(LINKS):
        centre = np.array((first + SPACING * k, height))
        tilt = TILT * (-1) ** k
        body(ax, centre, (2 * LEVER * shrink - 8, 26), tilt, BODY1)
        dot(ax, centre, BODY1, 6)
        end = LEVER * np.array((1, np.tan(np.radians(tilt))))
        if k == 0:
            dot(ax, centre - end, INK, 7)
        dot(ax, centre + end, INK, 7)
    low = height - LEVER * np.tan(np.radians(TILT))
    high = height + LEVER * np.tan(np.radians(TILT))
    arrow(ax, (first - LEVER - 6, low), (first - LEVER - 46, low))
    last = first + SPACING * (LINKS - 1) + LEVER
    arrow(ax, (last + 6, high), (last + 46, high))
    words(ax, (first - LEVER - 28, low + 20), "$F$", ARROW)
    words(ax, (last + 28, high + 20), "$F$", ARROW)
    words(ax, (236, 96), "centres: on the line, at rest", BODY1, 11.5)
    words(ax, (236, 72), "joints: off the line, by turns above and below", INK, 11.5)
    words(ax, (236, 28), "only the rotations have kinetic energy", FAINT, 11)


def link(ax):
    """Right: what one link loses along the line when it turns."""
    words(ax, (652, 352), "one link", size=12.5, weight="bold")
    centre, lever, tilt = np.array((652.0, 200.0)), 108.0, 26.0
    ax.plot((512, 792), (200, 200), color=FAINT, linewidth=1.2, linestyle=(0, (4, 3)))
    body(ax, centre, (2 * lever + 20, 44), tilt, BODY1)
    turn = np.radians(tilt)
    end = lever * np.array((np.cos(turn), np.sin(turn)))
    ax.plot(*np.array((centre, centre + end)).T, color=BODY2, linewidth=2, zorder=4)
    dot(ax, centre, BODY1)
    dot(ax, centre - end, INK)
    dot(ax, centre + end, INK)
    words(ax, centre + 0.5 * end + (-10, 15), "$r$", BODY2)
    ax.add_patch(Arc(centre, 120, 120, theta1=0, theta2=tilt, color=FAINT, linewidth=1.4))
    words(ax, centre + (76, 15), r"$\varphi$", FAINT)
    arrow(ax, centre + end + (8, 0), centre + end + (58, 0))
    arrow(ax, centre - end - (8, 0), centre - end - (58, 0))
    words(ax, centre + end + (36, 17), "$F$", ARROW)
    words(ax, centre - end - (36, -17), "$F$", ARROW)
    for x in (centre[0] + end[0], centre[0] + lever):
        ax.plot((x, x), (124, 200 if x > centre[0] + end[0] else 240), color=FAINT, linewidth=1)
    words(ax, (centre[0] + lever - 22, 108), r"$r(1-\cos\varphi)\approx r\varphi^2/2$", INK, 11.5)
    words(ax, (652, 28), r"shorter, against $F$: energy $|F||r|\varphi^2/2$ per joint", FAINT, 11)


def picture(usage):
    """To the path on the command line."""
    draw(usage, "zigzag_09", (chain, link), (474,), width=830)
