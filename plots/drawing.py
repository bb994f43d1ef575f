"""What the chapters' drawings share: the card, its colours, bodies, arrows, dots and words."""
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.patches import FancyBboxPatch  # noqa: E402
from matplotlib.transforms import Affine2D  # noqa: E402

import files  # noqa: E402

sys.path.append(str(Path(__file__).absolute().parents[1] / "tools"))
from base.palette import named  # noqa: E402

CARD, EDGE = named("card"), named("card-edge")
INK, FAINT = named("figure-ink"), named("figure-pale")
BODY1, BODY2, ARROW = named("body1"), named("body2"), named("arrow")
HEIGHT = 380  # [px]


def body(ax, centre, size, degrees, colour):
    """A box with rounded corners, seen from the side."""
    w, h = size
    box = FancyBboxPatch((-w / 2, -h / 2), w, h, boxstyle="round,pad=0,rounding_size=10",
                         facecolor=colour + "26", edgecolor=colour, linewidth=2)
    box.set_transform(Affine2D().rotate_deg(degrees).translate(*centre) + ax.transData)
    ax.add_patch(box)


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


def draw(usage, name, panels, dividers, width=700, more=None):
    """Draws the panels on a card, with a line at each divider, to the path on the command line.

    The same bytes every time, if the path ends in .svg. `more` has the panels, dividers and, if it
    is another, width of a script's other pictures, by the name of their file without .svg.
    """
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(usage)
    path = Path(sys.argv[1])
    panels, dividers, width = (*(more or {}).get(path.stem, (panels, dividers)), width)[:3]
    plt.rcdefaults()  # whatever was drawn before in this process
    plt.rcParams.update({"svg.hashsalt": name, "font.family": "DejaVu Sans",
                         "mathtext.fontset": "dejavusans"})
    figure = plt.figure(figsize=(width / 96, HEIGHT / 96))
    ax = figure.add_axes((0, 0, 1, 1))
    ax.set_xlim(0, width)
    ax.set_ylim(0, HEIGHT)
    ax.set_axis_off()
    ax.add_patch(FancyBboxPatch((1, 1), width - 2, HEIGHT - 2, facecolor=CARD, edgecolor=EDGE,
                                linewidth=1, boxstyle="round,pad=0,rounding_size=12", zorder=0))
    for x in dividers:
        ax.plot((x, x), (45, 330), color=EDGE, linewidth=1.2)
    for panel in panels:
        panel(ax)
    save = files.save_svg if path.suffix == ".svg" else plt.Figure.savefig
    save(figure, path, transparent=True)
