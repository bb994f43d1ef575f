"""What the chapters' drawings share: the card, its colours, bodies, arrows, dots and words."""
import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patches import Arc, Circle, FancyBboxPatch, Rectangle  # noqa: E402
from matplotlib.transforms import Affine2D  # noqa: E402

import files  # noqa: E402

sys.path.append(str(Path(__file__).absolute().parents[1] / "tools"))
from base.palette import named  # noqa: E402

CARD, EDGE = named("card"), named("card-edge")
INK, FAINT = named("figure-ink"), named("figure-pale")
BODY1, BODY2, ARROW, LEVER = (named(name) for name in ("body1", "body2", "arrow", "lever"))


def direction(degrees):
    return np.array([np.cos(np.radians(degrees)), np.sin(np.radians(degrees))])


def body(ax, centre, size, degrees, colour, ghost=False, rounding=10):
    """A box with rounded corners, seen from the side; a ghost is only its dashed outline."""
    w, h = size
    look = {"facecolor": "none", "linewidth": 1.4, "linestyle": (0, (4, 3))} if ghost else {
        "facecolor": colour + "26", "linewidth": 2}
    box = FancyBboxPatch((-w / 2, -h / 2), w, h, edgecolor=colour, **look,
                         boxstyle=f"round,pad=0,rounding_size={rounding}")
    box.set_transform(Affine2D().rotate_deg(degrees).translate(*centre) + ax.transData)
    ax.add_patch(box)


def ground(ax, left, right, top, depth=56):
    """What does not move, seen from the side."""
    ax.add_patch(Rectangle((left, top - depth), right - left, depth, facecolor=BODY1 + "26",
                           linewidth=0))
    line(ax, (left, top), (right, top), BODY1, "solid", 2)


def wall(ax, right, low, high):
    """What does not move: a strip that ends at x = right."""
    ax.add_patch(Rectangle((right - 18, low), 18, high - low, facecolor=BODY1 + "26", linewidth=0))
    line(ax, (right, low), (right, high), BODY1, "solid", 2)


def line(ax, start, end, colour=FAINT, dashes=(0, (2, 2)), width=1.1, layer=3):
    ax.plot(*zip(start, end), color=colour, linewidth=width, linestyle=dashes, zorder=layer)


def measure(ax, start, end, text="", aside=(0, 0), width=1.2, **look):
    """A length between two marks, with its name `aside` of the middle."""
    start, end = np.array(start), np.array(end)
    along = (end - start) / np.linalg.norm(end - start)
    across = 5 * np.array([-along[1], along[0]])
    line(ax, start, end, INK, "solid", width, 4)
    for place in (start, end):
        line(ax, place - across, place + across, INK, "solid", 1.2, 4)
    words(ax, (start + end) / 2 + aside, text, **look)


def into_page(ax, place, colour):
    """An arrow that points away from the reader: its feathers."""
    ax.add_patch(Circle(place, 7, facecolor=CARD, edgecolor=colour, linewidth=2, zorder=6))
    for degrees in (45, 135):
        line(ax, place - 5.6 * direction(degrees), place + 5.6 * direction(degrees), colour,
             "solid", 1.6, 7)


def turn(ax, centre, radius, start, end, colour, width=2.2):
    """A bent arrow round a centre from start to end [degrees], either way round."""
    sign = np.sign(end - start)
    ax.add_patch(Arc(centre, 2 * radius, 2 * radius, theta1=min(start, end), zorder=4,
                     theta2=max(start, end), color=colour, linewidth=width))
    tip, along = np.array(centre) + radius * direction(end), sign * direction(end + 90)
    arrow(ax, tip - along, tip + 9 * along, colour, width)


def arrow(ax, start, end, colour=ARROW, width=2.2, dashed=False):
    ax.annotate("", xy=end, xytext=start, zorder=4,
                arrowprops={"arrowstyle": "-|>,head_width=0.3,head_length=0.6", "color": colour,
                            "linewidth": width, "shrinkA": 0, "shrinkB": 0,
                            "linestyle": (0, (3, 2)) if dashed else "solid"})


def dot(ax, place, colour, size=7):
    ax.plot(*place, "o", color=colour, markersize=size, markeredgecolor=CARD, zorder=5)


def words(ax, place, text, colour=INK, size=13, **more):
    ax.text(*place, text, color=colour, fontsize=size, ha=more.pop("ha", "center"), va="center",
            zorder=6, **more)


def title(ax, x, text, y=352):
    words(ax, (x, y), text, size=12.5, weight="bold")


def below(ax, x, text, y=28, colour=FAINT):
    """What a panel says under its drawing."""
    words(ax, (x, y), text, colour, 11)


def draw(usage, salt, **pictures):
    """Draws a picture on a card, the same bytes every time, to the path on the command line.

    `pictures` has each by the name of its file without .svg: its panels; its left and right,
    lower and upper end [px]; then the places of lines between the panels.
    """
    path = Path(sys.argv[-1])
    if len(sys.argv) != 2 or path.stem not in pictures:
        sys.exit(usage)
    panels, (left, right, low, high), *dividers = pictures[path.stem]
    plt.rcdefaults()  # whatever was drawn before in this process
    plt.rcParams.update({"svg.hashsalt": salt, "font.family": "DejaVu Sans",
                         "mathtext.fontset": "dejavusans"})
    figure = plt.figure(figsize=((right - left) / 96, (high - low) / 96))
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set_xlim(left, right)
    ax.set_ylim(low, high)
    ax.set_axis_off()
    ax.add_patch(FancyBboxPatch((left + 1, low + 1), right - left - 2, high - low - 2,
                                facecolor=CARD, edgecolor=EDGE, linewidth=1, zorder=0,
                                boxstyle="round,pad=0,rounding_size=12"))
    for x in dividers:
        line(ax, (x, low + 45), (x, high - 50), EDGE, "solid", 1.2, 2)
    for panel in panels:
        panel(ax)
    files.save_svg(figure, path, transparent=True)
