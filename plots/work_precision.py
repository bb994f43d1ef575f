#!/usr/bin/env python3
"""Draws error against run time, one figure a scene and kind of number, with every setting on it.

work_precision.py --csv out/work_precision.csv [--peers bench/peers.csv] --out DIR
"""
import re

import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["chains", "iterations", "substeps", "warm", "us_per_step", "gap_rms_m", "gap_max_m",
           "tip_error_m", "sideways_m"]
WORDS = ["scene", "solver", "setting", "real", "status", "measures", "fronts"]
PEER_NUMBERS = ["us_per_step", "gap_rms_m", "gap_max_m", "tip_error_m"]
PEER_WORDS = ["engine", "setting", "scene", "source"]
FAMILY = {"sequential impulses": COLOURS[1], "packed": COLOURS[2], "lanes": COLOURS[0],
          "chapter 7": COLOURS[5], "direct": COLOURS[4], "textbook": INK}
PEER = COLOURS[3]
LOOKS = {  # of a status: marker, full or hollow, words
    "ok": ("o", True, "large: gap max. below 1 % of a link"), "soft": ("o", True, ""),
    "torn": ("o", False, "hollow: torn"), "energy+": ("^", False, "triangle: energy gained"),
    "exploded": ("x", False, "cross: exploded"), "nan": ("x", False, "cross: exploded")}
LOST = ("nan", "exploded")      # their size says nothing: drawn at the upper edge
AT_ONCE = "direct"  # the solver without iterations
EXACT = {"mm": 1e-4, "m": 1e-6}  # what is better than this stands at the lower edge
FLOOR = 9.81 / 60 * 1.0 / 2     # g h t / 2 [m], h = 1/60 s, t = 1 s: semi-implicit Euler's own
MEASURES = {  # of a column: words at the axis, factor, unit, end of the file's name
    "gap_rms_m": ("gap of the joints, RMS  [mm]", 1000, "mm", ""),
    "gap_max_m": ("largest gap of a joint  [mm]", 1000, "mm", ""),
    "tip_error_m": ("error of the tip after 1 s  [mm]", 1000, "mm", "_tip"),
    "sideways_m": ("furthest way in the forbidden direction  [m]", 1, "m", "")}
SCENES = {"S1": "{chains} chains of 100 cubes on hinges",
          "S2": "20 cubes of 1 kg on ball joints, at their end {ratio} kg",
          "S3": "hanging bridge of 40 boxes on hinges, 100 kg in its middle",
          "S3b": "the bridge on ball joints", "S5": "a chain of 4 cubes on hinges",
          "S6": "a chain of 11 cubes, axes loaded",
          "S7": "{chains} chains of 100 cubes, gravity sideways"}


def title_of(row):
    name, _, ratio = row["scene"].partition(" R=")
    return SCENES.get(name, name).format(chains=f"{row['chains']:g}", ratio=ratio)


def groups(rows, *by):
    """Rows by some of their fields, in the order in which they appear."""
    out = {}
    for row in rows:
        out.setdefault(tuple(row[name] for name in by), []).append(row)
    return out


def limits(values, room):
    """What a log axis has to show of these values: at least a factor of four."""
    low, high = np.multiply(style.extent(values), (1 / room, room))
    wider = max(1.0, np.sqrt(4 * low / high))
    return low / wider, high * wider


def number(value):
    return f"{value:.0f}" if 100 <= value < 1e6 else f"{value:.2g}"


# ---- labels --------------------------------------------------------------------------------------

class Room:
    """What of a panel is taken, in cells of two pixels: where a label costs nothing."""

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

    def place(self, words, colour, anchors, size=7.0):
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

def heights(rows, name, factor, low, high):
    """What is drawn of each row: what exploded stands at the upper edge, no gap at the lower."""
    lost = [row.get("status") in LOST or not np.isfinite(row[name]) for row in rows]
    return np.array([high if gone else np.clip(factor * row[name], low, high)
                     for row, gone in zip(rows, lost)]), np.array(lost)


def draw_setting(ax, group, name, factor):
    """One setting: a thin line, and at each count of iterations a marker that says how it went."""
    colour, (low, high) = FAMILY[group[0]["solver"]], ax.get_ylim()
    x = np.array([row["us_per_step"] for row in group])
    y, lost = heights(group, name, factor, low, high)
    ax.plot(x, np.where(lost, np.nan, y), color=colour, linewidth=1.0, alpha=0.75)
    for a, b, row in zip(x, y, group):
        shape, full, _ = LOOKS[row["status"]]
        if factor * row[name] < low:
            shape = "v"
        ax.plot(a, b, shape, color=colour, clip_on=False, zorder=4, markeredgewidth=1,
                markersize=5.5 if row["status"] == "ok" else 3.5,
                markerfacecolor=colour if full else "white")
    return np.column_stack([x, y])


def draw_peers(ax, peers, name, factor):
    """Points that were measured elsewhere: dots join those of one engine, nothing joins ours."""
    low, high = ax.get_ylim()
    out = []
    for (engine,), group in groups(peers, "engine").items():
        group = [row for row in group if np.isfinite(row[name])]
        if not group:
            continue
        x = np.array([row["us_per_step"] for row in group])
        y, _ = heights(group, name, factor, low, high)
        ax.plot(x, y, ":", color=PEER, linewidth=0.8)
        none = np.array([factor * row[name] < low for row in group])  # below the picture
        ax.plot(x[~none], y[~none], "D", color=PEER, markersize=4, zorder=3)
        if none.any():
            ax.plot(x[none], y[none], "v", color=PEER, markersize=5, zorder=3, clip_on=False)
        out.append((engine, np.column_stack([x, y])))
    return out


def draw(rows, measure, peers, out):
    words, factor, unit, suffix = MEASURES[measure]
    real, scene = rows[0]["real"], rows[0]["scene"]
    figure, ax = style.figure(headline(rows, measure, factor, unit))
    figure.set_size_inches(style.WIDTH, 6.4)
    kept = [row for row in rows if row["status"] not in LOST]
    floor = [1000 * FLOOR] if measure == "tip_error_m" else []
    seen = [max(factor * row[measure], EXACT[unit]) for row in kept] \
        + [factor * row[measure] for row in peers if row[measure] > 1e-4]
    ax.set(xscale="log", yscale="log", ylabel=words, ylim=limits(seen + floor, 1.5),
           xlabel=f"time of a step, one core, {real}  [µs]",
           xlim=limits([row["us_per_step"] for row in rows + peers], 1.4))
    front = sorted((row for row in rows if measure in row["fronts"].split("+")),
                   key=lambda row: row["us_per_step"])
    at_front = np.array([(row["us_per_step"], max(factor * row[measure], EXACT[unit]))
                         for row in front])
    if len(front):
        ax.plot(*at_front.T, color=COLOURS[5], linewidth=7, alpha=0.45, zorder=1,
                solid_capstyle="round", solid_joinstyle="round")
    lines = [(group[0], draw_setting(ax, group, measure, factor))
             for group in groups(rows, "solver", "setting", "substeps").values()]
    others = draw_peers(ax, peers, measure, factor)
    if floor:
        ax.axhline(floor[0], color=INK, linewidth=1, dashes=(2, 2))
    style.plain_log(ax.xaxis)
    style.plain_log(ax.yaxis)
    explain(ax, rows, bool(peers))
    figure.get_layout_engine().execute(figure)
    figure.set_layout_engine("none")
    label(ax, lines, others, at_front, floor)
    style.save(figure, out / (slug(rows[0]) + suffix + "_" + real))


def explain(ax, rows, peers):
    """The families in their colours, and what the markers say: above the panel."""
    states = list(dict.fromkeys(LOOKS[row["status"]][2] for row in rows))
    states += ["v: below this picture"]
    most = max(row["iterations"] for row in rows if row["substeps"] == 1)
    ax.set_title(f"{title_of(rows[0])}; along a line: 10 to {most:g} iterations a step\n"
                 + "; ".join(word for word in states if word) + "\n", fontsize=8, color=PALE)
    at = 0.0
    families = [(name, colour) for name, colour in FAMILY.items()
                if any(row["solver"] == name for row in rows)]
    for name, colour in [*families, *[("measured elsewhere, another machine", PEER)] * peers]:
        shape = "◆ " if colour == PEER else "● "
        ax.text(at, 1.012, shape + name, transform=ax.transAxes, color=colour, fontsize=8,
                in_layout=False)
        at += 0.0105 * len(name) + 0.035


def label(ax, lines, others, at_front, floor):
    """Every line its name, the front and the floor theirs, where there is room."""
    room = Room(ax)
    to_pixels = ax.transData.transform
    drawn = [(name, colour, to_pixels(points)) for name, colour, points in
             [(row["setting"], FAMILY[row["solver"]], points) for row, points in lines]
             + [(name, PEER, points) for name, points in others]]
    for _, _, points in drawn:
        room.ink(points)
        for point in points:
            room.ink(np.array([point]), 1.5, 2)
    if floor:
        edge = to_pixels([(ax.get_xlim()[1], floor[0])])[0]
        room.ink(to_pixels([(x, floor[0]) for x in ax.get_xlim()]), 2)
        room.place(f"g h t/2 = {floor[0]:.0f} mm: what the step of 1/60 s itself\nis off "
                   "in free fall", INK, [edge - (130, 0)], 7.5)
    if len(at_front):
        room.place("front: nothing measured here is\nboth faster and better", "#8A5F00",
                   list(to_pixels(at_front)[[-1, len(at_front) // 2]]), 7.5)
    for name, colour, points in sorted(drawn, key=lambda one: one[2][-1][1]):
        ends = [points[-1], points[0], points[len(points) // 2]]
        room.place(name, colour, [p for p in ends if np.isfinite(p).all()])


# ---- what the title says -------------------------------------------------------------------------

def fastest(rows):
    return min(rows, key=lambda row: row["us_per_step"], default=None)


def called(row):
    if row["solver"] == AT_ONCE:
        return f"{row['solver']}, {row['setting']}"
    iterations = f"{row['iterations']:g}"
    iterations += f" x {row['substeps']:g}" if row["substeps"] > 1 else ""
    return f"{row['solver']}, {row['setting']}, {iterations} iterations"


def headline(rows, measure, factor, unit):
    scene = rows[0]["scene"]
    good = [row for row in rows if row["status"] in ("ok", "soft", "torn")]
    if not good:
        return f"{scene}: nothing that was tried keeps its energy"
    best = min(good, key=lambda row: row[measure])
    least = f"{number(factor * best[measure])} {unit}"
    if measure == "sideways_m":
        iterated = min((row for row in good if row["solver"] != AT_ONCE),
                       key=lambda row: row[measure])
        exact = fastest([row for row in good if factor * row[measure] < EXACT[unit]])
        rest = f";\nbelow {EXACT[unit]:g} {unit} is {called(exact)}, in " \
               f"{number(exact['us_per_step'])} µs" if exact else ""
        return (f"{scene}: the exact answer is 0; iterations come to "
                f"{number(factor * iterated[measure])} {unit} at best{rest}")
    if measure == "tip_error_m":
        iterated = min((row for row in good if row["solver"] != AT_ONCE),
                       key=lambda row: row[measure])
        return (f"{scene}: the tip is {least} off with {called(best)};\nwith iterations "
                f"{number(factor * iterated[measure])} {unit} at best ({called(iterated)})")
    held = [row for row in rows if row["status"] == "ok"]
    if not held:
        kind = "RMS gap" if measure == "gap_rms_m" else "largest gap"
        return (f"{scene}: nothing tried keeps every gap below 1 % of a link;\n"
                f"at best the {kind} is {least} ({called(best)})")
    first = fastest(held)
    most = max([row["iterations"] for row in rows if row["setting"] == "cold"], default=0)
    plain = fastest([row for row in held if row["setting"] == "cold"])
    rest = f"plain cold iterations in {number(plain['us_per_step'])} µs" if plain else \
        f"plain cold iterations never, up to {most:g}"
    return (f"{scene}: every gap stays below 1 % of a link in {number(first['us_per_step'])} µs\n"
            f"by {called(first)}; by {rest}")


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
