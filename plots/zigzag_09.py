"""Chapter 9's zigzag: a taut chain whose links turn about their centres.

geometry_09.py draws it, zigzag.svg.
"""
import numpy as np
from drawing import ARROW, BODY1, FAINT, INK, arrow, body, direction, dot, draw, line, title, words

LINKS, LENGTH, TILT = 5, 100.0, 18.0  # of the chain [px, degrees]


def chain(ax):
    """The joints leave the line by turns, the centres stay on it."""
    title(ax, 330, "a taut chain: its joints oscillate by turns, its centres stay")
    across, y = LENGTH * np.cos(np.radians(TILT)), 206.0
    line(ax, (40, y), (620, y), FAINT, (0, (4, 3)), 1.2)
    pins = []
    for k in range(LINKS):
        for way in (-1, 1):  # as it is, and half a period later
            centre = np.array((330 + across * (k - (LINKS - 1) / 2), y))
            tilt = way * TILT * (-1) ** k
            body(ax, centre, (LENGTH + 18, 18), tilt, BODY1 if way > 0 else FAINT, way < 0, 9)
        pins += [centre - LENGTH / 2 * direction(tilt), centre + LENGTH / 2 * direction(tilt)]
        dot(ax, centre, BODY1, 8)
        words(ax, centre + (0, 52), ("$\\varphi$", "$-\\varphi$")[k % 2], BODY1, 14)
    for pin in pins:
        dot(ax, pin, INK, 8)
    for pin in pins[1:-1:2]:
        up = np.sign(y - pin[1])
        arrow(ax, pin + (0, 14 * up), pin + (0, 44 * up), INK, 1.6)
    for pin, way in ((pins[0], -1), (pins[-1], 1)):
        arrow(ax, pin + (12 * way, 0), pin + (58 * way, 0), ARROW, 3)
        words(ax, pin + (42 * way, 18 * way), "$F$", ARROW, 14)
    words(ax, (330, 122), "dashed: half a period later", FAINT, 12)


def picture(usage):
    """To the path on the command line."""
    draw(usage, "zigzag_09", zigzag=((chain,), (0, 660, 100, 376)))
