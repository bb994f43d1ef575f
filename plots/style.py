"""The style sheet of all figures: colours, sizes, labels at line ends, tables in, pictures out."""
import argparse
import csv
import pathlib
import re
import sys
import textwrap

try:
    import matplotlib
    matplotlib.use("agg")
    import matplotlib.pyplot as plt
    import numpy as np

    import files
except ImportError as problem:
    print(f"{problem}: install python3-matplotlib", file=sys.stderr)
    sys.exit(2)

sys.path.append(str(pathlib.Path(__file__).absolute().parents[1] / "tools"))
from base.palette import named  # noqa: E402

# Yellow is left out: too pale for lines.
COLOURS = [named(name) for name in ("vermilion", "blue", "green", "purple", "sky", "orange")]
INK, PALE, GRID, EMPTY = (named(f"figure-{name}") for name in ("ink", "pale", "grid", "empty"))
MINE = COLOURS[0]
WIDTH, HEIGHT = 7.5, 4.0  # [inch], the size at which the page shows a figure

plt.rcParams.update({
    "font.family": "DejaVu Sans", "mathtext.fontset": "dejavusans", "font.size": 9,
    "axes.titlesize": 9.5, "axes.labelsize": 9, "xtick.labelsize": 8.5, "ytick.labelsize": 8.5,
    "figure.titlesize": 11, "figure.titleweight": "bold", "axes.titlelocation": "left",
    "text.color": INK, "axes.labelcolor": INK, "axes.edgecolor": PALE, "axes.linewidth": 0.8,
    "xtick.color": PALE, "ytick.color": PALE, "xtick.labelcolor": INK, "ytick.labelcolor": INK,
    "axes.spines.top": False, "axes.spines.right": False, "axes.axisbelow": True,
    "xtick.minor.pad": 5.0, "ytick.minor.pad": 5.0,
    "axes.grid": True, "grid.color": GRID, "grid.linewidth": 0.7, "lines.linewidth": 1.6,
    "figure.facecolor": "white", "savefig.facecolor": "white", "savefig.dpi": 144,
    "figure.constrained_layout.h_pad": 0.06, "figure.constrained_layout.w_pad": 0.08,
    "svg.hashsalt": "joint workbook", "svg.fonttype": "path",
})


class Trouble(Exception):
    """A message for the user, in one line."""


def run(main):
    """Runs a script: its trouble becomes one line on standard error and exit status 2."""
    try:
        with np.errstate(all="ignore"):  # what explodes is drawn as far as it goes
            main()
    except (Trouble, OSError) as problem:
        print(problem, file=sys.stderr)
        sys.exit(2)


def arguments(words, **known):
    """Reads the command line; `known` has the help of every option, `words` what the script does.

    An option whose help begins with "optional" may be left out.
    """
    parser = argparse.ArgumentParser(description=words, allow_abbrev=False)
    parser.error = lambda message: run(lambda: trouble(f"{parser.prog}: {message}"))
    for name, text in known.items():
        parser.add_argument(f"--{name}", type=pathlib.Path, help=text, metavar="PATH",
                            required=not text.startswith("optional"))
    return parser.parse_args()


def trouble(words):
    raise Trouble(words)


def read_csv(path, numbers, words=(), command=""):
    """A table as a dictionary of columns: arrays of the `numbers`, lists of the `words`.

    An empty field of a number is NaN; more columns may follow.
    """
    if not path.is_file():
        raise Trouble(f"{path} is missing: {command} makes it")
    with open(path, newline="", encoding="utf-8", errors="replace") as file:
        rows = [row for row in csv.reader(file) if row]
    header = rows[0] if rows else []
    lacking = [name for name in (*numbers, *words) if name not in header]
    if lacking:
        raise Trouble(f"{path} has no column {lacking[0]}: {command} makes it anew")
    if len(rows) < 2 or any(len(row) < len(header) for row in rows):
        raise Trouble(f"{path} is cut short: {command} makes it anew")
    table = {name: [row[header.index(name)] for row in rows[1:]] for name in words}
    for name in numbers:
        texts = [row[header.index(name)] for row in rows[1:]]
        try:
            table[name] = np.array([float(text or "nan") for text in texts])
        except ValueError as problem:
            raise Trouble(f"{path}, column {name}: {problem}: {command} makes it anew") from None
    return table


def reader(folder, command):
    """read(name, numbers, *words): a table of a chapter's run, as read_csv makes it; None where the
    run has written others only: a reader's has no experiments of bench/."""
    def read(name, numbers, *words):
        path = folder / f"{name}.csv"
        if not path.is_file() and any(folder.glob("*.csv")):
            return None
        return read_csv(path, numbers.split(), words, command)
    return read


def rows(table, **where):
    """The rows where the named columns have these values; every column becomes an array."""
    chosen = np.ones(len(next(iter(table.values()))), bool)
    for name, value in where.items():
        chosen &= np.asarray(table[name]) == value
    return {name: np.asarray(column)[chosen] for name, column in table.items()}


def chapter(number, tables, draws, result=None):
    """A chapter's script: reads its tables, the solution's and yours, and draws its figures.

    tables(folder, command) gives what each draw(solution, mine, out) is called with, in order.
    `result` is the one of them that the chapter's text shows: with --result it alone is drawn, of
    the solution, into that file.
    """
    given = arguments(f"Draws the figures of chapter {number}.",
                      solution="folder of the solution's tables",
                      mine="optional: folder of your tables", out="optional: folder of the figures",
                      result="optional: the file of the text's figure, alone")
    solution = tables(given.solution, f"./wb plot {number}")
    mine = tables(given.mine, f"./wb run {number}") if given.mine else (None,) * len(draws)
    if given.result and result not in draws:
        trouble(f"chapter {number} has no figure for its text")
    for draw, theirs, own in zip(draws, solution, mine):
        if incomplete(theirs):
            if draw is result:
                trouble(f"chapter {number}: a table is missing, of the figure for its text")
        elif given.result and draw is result:
            draw(theirs, None, given.result)
        elif not given.result:
            draw(theirs, completed(own, theirs), given.out)


def incomplete(tables):
    """True where a table of a figure is missing."""
    return None in (tables if isinstance(tables, tuple) else (tables,))


def completed(own, theirs):
    """The reader's tables of a figure, those that are missing from the solution; None: all are."""
    if not isinstance(own, tuple) or not incomplete(own):
        return own
    return None if own.count(None) == len(own) else tuple(
        table or other for table, other in zip(own, theirs))


def figure(title, panels=1, rows=1, **options):
    """A figure with its panels side by side; `title` says what is to be seen."""
    made, axes = plt.subplots(rows, panels, figsize=(WIDTH, HEIGHT * (1 + 0.7 * (rows - 1))),
                              layout="constrained", **options)
    entitle(made, title)
    return made, axes


def entitle(made, title):
    """The title, in one size in every figure: too long for a line, it is cut into even lines."""
    title = re.sub(r"(?<=\d) (?=(?:%|[mcµn]?[msJN])(?!\w))", "\u00a0", title)  # 1 mm on one line
    words, room, count = made.suptitle(title, x=0.012, ha="left"), 0.976 * made.bbox.width, 1
    while words.get_window_extent(made.canvas.get_renderer()).width > room:
        count += 1
        cuts = (textwrap.fill(title, width, break_on_hyphens=False)
                for width in range(len(title) // count, len(title)))
        words.set_text(next(cut for cut in cuts if cut.count("\n") < count))


def ink(colour):
    """A colour dark enough for words on white: a contrast of at least 4.5 (WCAG 2.2)."""
    rgb = np.array(matplotlib.colors.to_rgb(colour))

    def contrast():
        light = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
        return 1.05 / (light @ (0.2126, 0.7152, 0.0722) + 0.05)
    while contrast() < 4.5:
        rgb *= 0.97
    return tuple(rgb)


def save(made, path):
    """Writes path.png, or x.svg if path is x.svg/name: the same bytes for the same data."""
    kept = path.parent if path.parent.suffix == ".svg" else None
    (kept or path).parent.mkdir(parents=True, exist_ok=True)
    for text in made.findobj(matplotlib.text.Text):
        if text.get_color() != "white":  # on a dark field
            text.set_color(ink(text.get_color()))
    arrange(made)  # once more as it is drawn: by then labels have their sizes
    if kept:
        files.save_svg(made, kept, files.small)
    else:
        files.save_png(made, path.with_name(path.name + ".png"))
    plt.close(made)


def arrange(made):
    """Gives the panels their places and sizes, which drawing would do, too, but slowly."""
    made.get_layout_engine().execute(made)


def metres(size, unit="m"):
    """A length with its unit and prefix, or another size with its unit."""
    for prefix, scale, least in (("", 1, 1), ("m", 1e3, 1e-4), ("µ", 1e6, 1e-6), ("n", 1e9, 1e-9)):
        if size >= 0.9995 * least:
            return f"{float(f'{size * scale:.{3 if scale < 1e6 else 2}g}'):g} {prefix}{unit}"
    return f"less than 1 n{unit}" if size < 1 else f"{size} {unit}"


def metres_log(axis, every=3, unit="m"):
    """Writes 1 nm, 1 µm, 1 mm, 1 m on a log axis of lengths, or of another size."""
    low, high = np.nan_to_num(np.log10(axis.get_view_interval()))
    decades = [10.0**n for n in range(int(np.ceil(low)), int(high) + 1) if n % every == 0]
    axis.set_ticks(decades, [metres(size, unit) for size in decades])
    axis.set_ticks([], minor=True)


def visible(values):
    """For a log axis: NaN for values that are zero, negative or not finite."""
    values = np.asarray(values, float)
    return np.where(np.isfinite(values) & (values > 0), values, np.nan)


def extent(*arrays):
    """The least and the largest of the values that a log axis can show."""
    values = visible(np.concatenate([np.ravel(array) for array in arrays]))
    values = values[np.isfinite(values)]
    return (values.min(), values.max()) if len(values) else (0.1, 1.0)


def plain_log(axis, words=lambda value: f"{value:g}", most=1500):
    """Writes 2, 5, 10 instead of powers on a log axis, 10 alone where it has more than `most`."""
    low, high = axis.get_view_interval()
    axis.set_major_formatter(lambda value, _: words(value))
    if high / low < most:
        axis.set_minor_formatter(
            lambda value, _: words(value) if f"{value:.0e}"[0] in "25" else "")


def spread(places, heights):
    """Moves places (in 0..1) until labels of these heights at them do not overlap."""
    order = sorted(range(len(places)), key=lambda i: places[i])
    places = list(places)
    for _ in range(300):
        for low, high in zip(order, order[1:]):
            push = ((heights[low] + heights[high]) / 2 - (places[high] - places[low])) / 2
            if push > 0:
                places[low] -= push
                places[high] += push
        places = [min(max(place, 0.0), 1.0) for place in places]
    return places


def label_ends(ax, lines=None, size=8.5):
    """Writes every line's label at its right end, clear of each other, outside the axes."""
    lines = [line for line in (ax.lines if lines is None else lines)
             if not line.get_label().startswith("_") and np.isfinite(line.get_ydata()).any()]
    arrange(ax.figure.figure)  # of a part of a figure the whole
    ends = []
    for line in lines:
        points = ax.transAxes.inverted().transform(ax.transData.transform(line.get_xydata()))
        points = points[np.isfinite(points).all(axis=1)]
        ends.append(np.clip(points[-1], 0, 1))
    height = ax.get_window_extent().height / ax.figure.dpi * 72  # [points]
    places = spread([end[1] for end in ends],
                    [(line.get_label().count("\n") + 1.1) * 1.25 * size / height for line in lines])
    for line, end, place in zip(lines, ends, places):
        ax.annotate(line.get_label(), end, xytext=(1.035, place), va="center", fontsize=size,
                    color=line.get_color(), xycoords="axes fraction", textcoords="axes fraction",
                    annotation_clip=False, arrowprops={
                        "arrowstyle": "-", "color": line.get_color(), "linewidth": 0.8,
                        "relpos": (0, 0.5), "shrinkA": 0.5, "shrinkB": 1})


def overlay(ax, mine, solution, labels=("yours", "the solution")):
    """Yours thick and solid, the solution's thin and dashed on top; both are (x, y)."""
    ax.plot(*mine, color=MINE, linewidth=3.2, alpha=0.75, label=labels[0])
    ax.plot(*solution, color=INK, linewidth=1.1, dashes=(4, 2), label=labels[1])
    ax.set_xlim(0, max(mine[0].max(), solution[0].max()))
    hold(ax, mine[1], solution[1])


def peaks(table, by, steps=20):
    """The largest values of every so many rows, group by group: curves that swing, calmed."""
    out = {name: [] for name in table}
    for group in dict.fromkeys(table[by]):
        part = rows(table, **{by: group})
        for first in range(0, len(part[by]) - steps + 1, steps):
            for name in table:
                out[name].append(group if name == by else np.max(part[name][first:first + steps]))
    return {name: np.array(values) for name, values in out.items()}


def hold(ax, mine, solution, decades=3):
    """Limits a panel to the height of the solution, and to a little more for yours."""
    if ax.get_yscale() == "log":  # what explodes may leave the picture
        (low, high), both = extent(solution), extent(mine, solution)
        ax.set_ylim(max(both[0], low / 100, high / 10**decades) / 1.5,
                    min(both[1], high * 100) * 1.5)
        return
    finite = [y[np.isfinite(y)] for y in (solution, np.append(mine, solution))]
    if len(finite[0]):
        (low, high), both = ((y.min(), y.max()) for y in finite)
        span = 1.02 * (high - low) or 1.0
        ax.set_ylim(max(both[0], low - 3 * span) - span / 25,
                    min(both[1], high + 3 * span) + span / 25)


def difference(mine, solution):
    """The largest difference of two curves (x, y) where both have the same x."""
    _, i, j = np.intersect1d(np.round(mine[0], 6), np.round(solution[0], 6), return_indices=True)
    return float(np.max(np.abs(mine[1][i] - solution[1][j]), initial=0.0))


def verdict(mine, solution, unit):
    """The difference of two curves in words."""
    if not np.isfinite(mine[1]).all():
        return "yours does not stay finite"
    size = difference(mine, solution)
    if size <= 1e-6 * np.nanmax(np.abs(solution[1]), initial=0.0):
        return "yours and the solution are one curve"
    return f"yours is up to {size:.3g} {unit} off the solution"


def runs(table, column):
    """{iterations: (times, values)} of a program's table, fewest iterations first."""
    out = {}
    for count in np.unique(table["iterations"]):
        chosen = table["iterations"] == count
        out[int(count)] = (table["time_s"][chosen], table[column][chosen])
    return out
