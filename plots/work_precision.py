#!/usr/bin/env python3
"""Draws error against run time, one figure a scene and kind of number, with every setting on it.

work_precision.py --csv out/work_precision.csv [--peers bench/peers.csv] --out DIR
"""
import re
import textwrap

import numpy as np

import style
from style import COLOURS, INK, named

NUMBERS = ["chains", "iterations", "substeps", "warm", "us_per_step", "gap_rms_m", "gap_max_m",
           "tip_error_m", "sideways_m"]
WORDS = ["scene", "solver", "setting", "real", "status", "measures", "fronts"]
PEER_NUMBERS = ["us_per_step", "gap_rms_m", "gap_max_m", "tip_error_m"]
PEER_WORDS = ["engine", "setting", "scene", "source"]
FAMILY = {  # of a solver: colour, words
    "sequential impulses": (COLOURS[1], "sequential impulses"),
    "packed": (COLOURS[2], "packed rows"), "lanes": (COLOURS[0], "SIMD lanes"),
    "chapter 7": (COLOURS[5], "hinges of chapter 7"), "direct": (COLOURS[3], "direct solver"),
    "textbook": (INK, "textbook loop")}
SETTING = {"half a kick": "leapfrog", "omega": "over-relaxed", "islands": "islands,",
           "hinges alone": "", "list": "in list order", "velocities": "velocities only"}
FRONT, REST = named("front"), named("behind")
PEERS = [(colour, marker) for marker, colour in zip("DsPph*dX<>", COLOURS + COLOURS)]
LOOKS = {  # of a status: marker, full or hollow, words
    "ok": ("o", True, "large: gaps below 1 % of a link"), "soft": ("o", True, ""),
    "torn": ("o", False, "hollow: torn"), "energy+": ("^", False, "triangle: energy gained"),
    "exploded": ("x", False, "cross: exploded"), "nan": ("x", False, "cross: exploded")}
LOST = ("nan", "exploded")      # their size says nothing: drawn at the upper edge
AT_ONCE = "direct"  # the solver without iterations
EXACT = 1e-7  # [m], what is better than this stands at the lower edge
FLOOR = 9.81 / 60 * 1.0 / 2     # g h t / 2 [m], h = 1/60 s, t = 1 s: semi-implicit Euler's own
MEASURES = {  # of a column: words at the axis, end of the file's name
    "gap_rms_m": ("gap of the joints, RMS", ""), "gap_max_m": ("largest gap of a joint", ""),
    "tip_error_m": ("error of the tip after 1 s", "_tip"),
    "sideways_m": ("largest displacement in the forbidden direction", "")}
SCENES = {"S1": "{chains} chains of 100 cubes",
          "S1b": "{chains} chains of 100 cubes on ball joints",
          "S2": "20 cubes of 1 kg, {ratio} kg at their end",
          "S3": "A hanging bridge, 100 kg in its middle",
          "S3b": "The bridge on ball joints", "S5": "A chain of 4 cubes",
          "S6": "A chain of 11 cubes, its axes loaded",
          "S7": "{chains} chains of 100 cubes, gravity sideways"}


def title_of(row):
    name, _, ratio = row["scene"].partition(" R=")
    return SCENES.get(name, name).format(chains=f"{row['chains']:g}", ratio=ratio)


def named(row):
    """A solver and its setting in words."""
    setting = row["setting"]
    for key, word in SETTING.items():
        setting = setting.replace(key, word)
    return ", ".join(word for word in (FAMILY[row["solver"]][1], setting.strip(" ,")) if word)


def groups(rows, *by):
    """Rows by some of their fields, in the order in which they appear."""
    out = {}
    for row in rows:
        out.setdefault(tuple(row[name] for name in by), []).append(row)
    return out


def limits(values, room):
    """The range of a log axis for these values: at least a factor of four."""
    low, high = np.multiply(style.extent(values), (1 / room, room))
    wider = max(1.0, np.sqrt(4 * low / high))
    return low / wider, high * wider


# ---- labels --------------------------------------------------------------------------------------

class Room:
    """The occupied cells of two pixels in a panel, where a label has a cost."""

    def __init__(self, ax):
        style.arrange(ax.figure)
        self.ax, self.box = ax, ax.bbox
        self.cells = np.zeros((int(self.box.width / 2) + 2, int(self.box.height / 2) + 2))
        self.labels = []

    def ink(self, points, weight=1.0, wide=0):
        """Marks a line through these points [pixels]."""
        for a, b in zip(points, points[1:] if len(points) > 1 else points):
            if not np.isfinite([a, b]).all():
                continue
            count = max(2, int(np.hypot(*(b - a)) / 2))
            for x, y in (a + (b - a) * np.linspace(0, 1, count)[:, None] - self.box.min) / 2:
                i, j = int(x), int(y)
                self.cells[max(0, i - wide):i + wide + 1, max(0, j - wide):j + wide + 1] = weight

    def place(self, words, colour, anchors, size=8):
        """Writes words near one of the anchors, with a leader where that is not close."""
        text = self.ax.text(0, 0, words, transform=self.ax.transAxes, color=colour,
                            fontsize=size, ha="center", va="center", zorder=6)
        extent = text.get_window_extent(self.ax.figure.canvas.get_renderer())
        w, h = extent.width / 2 + 2, extent.height / 2 + 1
        total = self.cells.cumsum(0).cumsum(1)
        best = None
        for penalty, anchor in enumerate(anchors):
            for radius in (7, 14, 24, 38, 56, 80, 110, 150, 200):
                for angle in np.linspace(0, 2 * np.pi, 16, endpoint=False):
                    along = np.array([np.cos(angle), np.sin(angle)])
                    at = anchor + along * radius + along * (w, h)
                    low, high = at - (w, h), at + (w, h)
                    if (low < self.box.min).any() or (high > self.box.max).any():
                        continue
                    if any((low < b).all() and (high > a).all() for a, b in self.labels):
                        continue
                    (i, j), (k, l) = (((c - self.box.min) / 2).astype(int) for c in (low, high))
                    hit = total[k, l] - total[i, l] - total[k, j] + total[i, j]
                    cost = radius + 3 * penalty + 1.5 * hit
                    if best is None or cost < best[0]:
                        best = (cost, at, anchor, radius)
        if best is None:
            text.remove()
            return
        _, at, anchor, radius = best
        shares = self.ax.transAxes.inverted().transform  # pixels are others in the file
        text.set_position(shares(at))
        self.labels.append((at - (w, h), at + (w, h)))
        if radius > 14:
            end = np.clip(anchor, at - (w, h), at + (w, h))
            self.ax.plot(*np.transpose([shares(end), shares(anchor)]), color=colour, zorder=2,
                         transform=self.ax.transAxes, linewidth=0.6, scalex=False, scaley=False)
            self.ink(np.array([end, anchor]), 0.5)


# ---- a figure ------------------------------------------------------------------------------------

def heights(rows, name, low, high):
    """The points of the rows: exploded runs at the upper edge, runs without a gap at the lower."""
    lost = [row.get("status") in LOST or not np.isfinite(row[name]) for row in rows]
    return np.array([high if gone else np.clip(row[name], low, high)
                     for row, gone in zip(rows, lost)]), np.array(lost)


def draw_setting(ax, group, name, colour):
    """One setting: a thin line, and at each count of iterations a marker that says how it went."""
    low, high = ax.get_ylim()
    x = np.array([row["us_per_step"] for row in group])
    y, lost = heights(group, name, low, high)
    front = colour != REST
    ax.plot(x, np.where(lost, np.nan, y), color=colour, linewidth=1.4 if front else 0.7,
            zorder=3 if front else 1.5)
    for a, b, row in zip(x, y, group):
        shape, full, _ = LOOKS[row["status"]]
        ax.plot(a, b, "v" if row[name] < low else shape, color=colour, clip_on=False,
                zorder=4 if front else 2, markeredgewidth=1,
                markersize=(6 if row["status"] == "ok" else 4) if front else 3,
                markerfacecolor=colour if full else "white")
    return np.column_stack([x, y])


def draw_peers(ax, peers, name):
    """Points that were measured elsewhere: every engine its colour and its marker."""
    low, high = ax.get_ylim()
    for (engine,), (colour, marker) in zip(groups(peers, "engine"), PEERS):
        group = [row for row in peers if row["engine"] == engine and np.isfinite(row[name])]
        if not group:
            continue
        x = np.array([row["us_per_step"] for row in group])
        y, _ = heights(group, name, low, high)
        ax.plot(x, y, color=colour, linestyle=":", marker=marker, markersize=5, clip_on=False)
        yield engine, colour, np.column_stack([x, y])


def shown(rows, measure):
    """The settings with a colour and a name: plain iterations, the best of each solver that has a
    point at the front, and of the direct solver all that have one."""
    front = [row for row in rows if measure in row["fronts"].split("+")]
    best = [min(group, key=lambda row: (max(row[measure], EXACT), row["us_per_step"]))
            for group in groups(front, "solver").values()]
    named = [row for row in rows if row["solver"] == "sequential impulses"
             and row["setting"] == "cold" or row in front and row["solver"] == AT_ONCE]
    return set(groups(best + named, "solver", "setting", "substeps"))


def draw(rows, measure, peers, out):
    words, suffix = MEASURES[measure]
    real = rows[0]["real"]
    figure, axes = style.figure(headline(rows, measure), 1 + bool(peers), sharex=True, sharey=True,
                                squeeze=False)
    figure.set_size_inches(style.WIDTH, 5.0)
    ours, axes = axes[0, 0], axes[0]
    kept = [row for row in rows if row["status"] not in LOST]
    floor = [FLOOR] if measure == "tip_error_m" else []
    seen = [max(row[measure], EXACT) for row in kept] \
        + [row[measure] for row in peers if row[measure] > EXACT]
    ours.set(xscale="log", yscale="log", ylabel=words, ylim=limits(seen + floor, 1.5),
             xlim=limits([row["us_per_step"] for row in rows + peers], 1.4),
             title=explain(rows, measure, "\n" if peers else "; "))
    front = sorted((row for row in rows if measure in row["fronts"].split("+")),
                   key=lambda row: row["us_per_step"])
    at_front = np.array([(row["us_per_step"], max(row[measure], EXACT)) for row in front])
    coloured, lines = shown(rows, measure), []
    for key, group in groups(rows, "solver", "setting", "substeps").items():
        colour = FAMILY[key[0]][0] if key in coloured else REST
        points = draw_setting(ours, group, measure, colour)
        lines.append((named(group[0]) if key in coloured else "", colour, points))
    labels = [lines, list(draw_peers(axes[-1], peers, measure)) if peers else []]
    if len(front):  # a staircase: between two points no setting exists
        ours.step(*at_front.T, where="post", color=COLOURS[5], linewidth=5, alpha=0.45, zorder=1)
    for ax in axes:
        if floor:
            ax.axhline(floor[0], color=INK, linewidth=1, dashes=(2, 2))
        style.plain_log(ax.xaxis, lambda us: style.metres(1e-6 * us, "s"), 30 if peers else 300)
        style.plain_log(ax.yaxis, style.metres, 300)
        ax.set_xlabel(f"time of a step, one core, {real}")
    if peers:
        axes[1].set(title="other engines,\non another machine", xlabel="time of a step, one core")
    figure.get_layout_engine().execute(figure)
    figure.set_layout_engine("none")
    for ax, named_lines in zip(axes, labels):
        label(ax, named_lines, at_front if ax is ours else [],
              [] if ax is not axes[-1] and len(axes) > 1 else floor)
    style.save(figure, out / (slug(rows[0]) + suffix + "_" + real))


def explain(rows, measure, between):
    """The meaning of points, markers and grey, above the panel."""
    states = dict.fromkeys(LOOKS[row["status"]][2] for row in rows)
    most = max(row["iterations"] for row in rows if row["substeps"] == 1)
    more = groups(rows, "solver", "setting", "substeps").keys() - shown(rows, measure)
    return (f"this engine, 10 to {most:g} iterations per step\n"
            + between.join(filter(None, ["grey: more settings" if more else "", *states])))


def label(ax, lines, at_front, floor):
    """Every line its name, the front and the floor theirs, where there is room."""
    room = Room(ax)
    to_pixels = ax.transData.transform
    drawn = [(name, colour, to_pixels(points)) for name, colour, points in lines]
    for _, _, points in drawn:
        room.ink(points)
        for point in points:
            room.ink(np.array([point]), 1.5, 2)
    if len(at_front):
        room.ink(to_pixels(at_front), 0.5, 2)
    if floor:
        edge = to_pixels([(ax.get_xlim()[1], floor[0])])[0]
        room.ink(to_pixels([(x, floor[0]) for x in ax.get_xlim()]), 2)
        room.place(f"dashed: {style.metres(floor[0])}, the error of\na step of 1/60 s in free fall",
                   INK, [edge - (130, 0)])
    if len(at_front):
        room.place("front of this engine: none of its\nsettings is both faster and closer", FRONT,
                   list(to_pixels(at_front)[[-1, len(at_front) // 2]]))
    for name, colour, points in sorted(drawn, key=lambda one: one[2][-1][1]):
        ends = [points[-1], points[0], points[len(points) // 2]]
        if name:
            room.place(textwrap.fill(name, 24, break_on_hyphens=False), colour,
                       [p for p in ends if np.isfinite(p).all()])


# ---- what the title says -------------------------------------------------------------------------

def fastest(rows):
    return min(rows, key=lambda row: row["us_per_step"], default=None)


def called(row):
    if row["solver"] == AT_ONCE:
        return named(row)
    iterations = f"{row['iterations']:g}"
    iterations += f" x {row['substeps']:g}" if row["substeps"] > 1 else ""
    return f"{named(row)}, {iterations} iterations"


def headline(rows, measure):
    scene = title_of(rows[0])
    good = [row for row in rows if row["status"] in ("ok", "soft", "torn")]
    if not good:
        return f"{scene}: nothing that was tried keeps its energy"
    best = min(good, key=lambda row: row[measure])
    least = style.metres(best[measure])
    if measure in ("sideways_m", "tip_error_m"):
        iterated = min(row[measure] for row in good if row["solver"] != AT_ONCE)
        words = "after 1 s the tip is" if measure == "tip_error_m" else "they swing"
        return (f"{scene}: {words} {least} off ({called(best)}); with iterations at least "
                f"{style.metres(iterated)}")
    held = [row for row in rows if row["status"] == "ok"]
    if not held:
        return (f"{scene}: nothing tried keeps gaps below 1 % of a link; the best leaves {least} "
                f"({called(best)})")
    first = fastest(held)
    most = max([row["iterations"] for row in rows if row["setting"] == "cold"], default=0)
    plain = fastest([row for row in held if row["setting"] == "cold"])
    rest = f"plain cold iterations take {took(plain)}" if plain else \
        f"{most:g} plain cold iterations do not reach them"
    return f"{scene}: gaps below 1 % of a link take {took(first)} ({called(first)}); {rest}"


def took(row):
    return style.metres(1e-6 * row["us_per_step"], "s")


def slug(row):
    name = row["scene"] + (f" {row['chains']:g} chains" if row["chains"] > 10 else "")
    return "work_precision_" + re.sub(r"[^A-Za-z0-9]+", "_", name).strip("_")


def rows_of(table):
    return [dict(zip(table, values)) for values in zip(*table.values())]


def main():
    given = style.arguments("Draws error against run time.",
                            csv="the table that ./wb bench writes",
                            peers="optional: points of published engines, measured elsewhere",
                            out="folder of the figures")
    rows = rows_of(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench"))
    peers = rows_of(style.read_csv(given.peers, PEER_NUMBERS, PEER_WORDS)) if given.peers else []
    if not all(row["us_per_step"] > 0 for row in rows):
        style.trouble(f"{given.csv}: a time of a step is not above 0: ./wb bench makes it anew")
    for (scene, chains, _), chosen in groups(rows, "scene", "chains", "real").items():
        if len(groups(chosen, "solver", "setting")) < 2:
            continue  # nothing to compare
        known = [row for row in peers if row["scene"] == scene and chains == 10]
        for measure in chosen[0]["measures"].split("+"):
            draw(chosen, measure, known, given.out)


if __name__ == "__main__":
    style.run(main)
