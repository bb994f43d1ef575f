"""Chapter 7's errors of a chain pulled straight: an iteration in chain order, one by colours.

geometry_07.py draws it, order.svg.
"""
from drawing import (ARROW, BODY1, BODY2, CARD, FAINT, INK, LEVER, below, draw, named, title,
                     words)
from matplotlib.patches import Circle, Rectangle

JOINTS, CELL = 8, 34.0
SHADE = named("block")
COLOURS = (BODY1, BODY2, ARROW, LEVER, named("fifth"))  # of joints, each a number


def joint(ax, place, colour):
    """A joint: a disc in its colour, with the colour's number in it."""
    ax.add_patch(Circle(place, 10, facecolor=COLOURS[colour], edgecolor=CARD, linewidth=1,
                        zorder=5))
    words(ax, (place[0], place[1] - 0.5), str(colour), CARD, 10, weight="bold")


def solved(errors, chosen):
    """The errors after these joints of a long chain are solved, one after the other.

    Joint 0 hangs on the wall and passes all on; the others pass on half to each neighbour. The
    chain goes on behind the last joint that is shown.
    """
    errors = list(errors)
    for k in chosen:
        share = errors[k] if k == 0 else errors[k] / 2
        errors[k] = 0
        if k > 0:
            errors[k - 1] += share
        if k + 1 < len(errors):
            errors[k + 1] += share
    return errors


def table(ax, corner, rows, said):
    """Rows (label, errors, the joints just solved), from the top."""
    x, y = corner
    title(ax, x + JOINTS * CELL / 2, said)
    for i, (label, errors, now) in enumerate(rows):
        top = y - (CELL + 12) * i
        words(ax, (x - 10, top - CELL / 2), label, FAINT, 10.5, ha="right")
        for j, error in enumerate(errors[:JOINTS]):
            ax.add_patch(Rectangle((x + CELL * j, top - CELL), CELL, CELL, facecolor=SHADE,
                                   alpha=0.28 * error, edgecolor=CARD, linewidth=1.5, zorder=2))
            words(ax, (x + CELL * (j + 0.5), top - CELL / 2), f"{error:g}",
                  INK, 12, weight="bold" if j in now else "normal")
        for j in now:
            if j < JOINTS:
                ax.add_patch(Rectangle((x + CELL * j, top - CELL), CELL, CELL, facecolor="none",
                                       edgecolor=INK, linewidth=2, zorder=4))


def chain_order(ax):
    """Left: joint after joint from the wall."""
    errors = [1.0] * (JOINTS + 2)
    rows = [("before", errors, ())]
    for k in range(3):
        errors = solved(errors, (k,))
        rows.append((f"after {k + 1}", errors, (k,)))
    rows.append(("after all", solved(errors, range(3, JOINTS + 2)), ()))
    table(ax, (92.0, 282.0), rows, "chain order: 1 remains")
    for j in range(JOINTS):
        words(ax, (92 + CELL * (j + 0.5), 300), str(j + 1), FAINT, 10.5)
    words(ax, (40, 300), "joint", FAINT, 10.5)
    below(ax, 92 + JOINTS * CELL / 2, "framed: just solved; the wall is on the left")


def by_colours(ax):
    """Right: the middle of a long chain, colour after colour."""
    x, behind = 516.0, 6
    errors = [1.0] * (JOINTS + 2 * behind)
    chosen = [[k for k in range(1, len(errors) - 1) if (k - behind) % 2 == colour]
              for colour in (0, 1)]
    rows = [("before", errors, ())]
    for colour in (0, 1):
        errors = solved(errors, chosen[colour])
        rows.append((f"after colour {colour}", errors, [k - behind for k in chosen[colour]]))
    rows = [(label, errors[behind:], [k for k in now if 0 <= k < JOINTS])
            for label, errors, now in rows]
    table(ax, (x, 282.0), rows, "by colours: 2 and 0 remain")
    for j in range(JOINTS):
        joint(ax, (x + CELL * (j + 0.5), 301), j % 2)
    words(ax, (x + JOINTS * CELL / 2, 120), "the mean is 1 in both,", FAINT, 11)
    words(ax, (x + JOINTS * CELL / 2, 98), "the RMS is $\\sqrt{2}$ times as large", FAINT, 11)
    below(ax, x + JOINTS * CELL / 2, "the middle of a long chain")


def picture(usage):
    """To the path on the command line."""
    draw(usage, "order_07", order=((chain_order, by_colours), (0, 810, 0, 380), 386))
