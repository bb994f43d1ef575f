#!/usr/bin/env python3
"""Draws maps of every method: once over all scenes, with gap and time in each cell, and over mass
ratio, m r^2/I, step, length and stiffness, one of the gap, one of the energy and one of the motion.

methods.py --csv out/methods.csv --out DIR
methods.py --csv bench/measured/methods.csv --maps docs/maps.svg
methods.py --csv bench/measured/trajectories.csv --maps docs/maps_motion.svg
"""
import numpy as np
from matplotlib.collections import LineCollection, PatchCollection
from matplotlib.patches import Rectangle

import style
from style import EMPTY, INK, named

NUMBERS = ["us_per_step", "gap_max_m", "expected", "found", "energy_drift"]
WORDS = ["scene", "real", "method", "status"]
ORDER = ["si30", "beta1", "4x8", "16x2", "warm", "projection", "split", "relax",
         "omega", "velocity", "shake",
         "inertia", "velocity/8", "shake/8", "inertia/8", "rk4"]
TITLES = {"si30": "30\niterations", "beta1": "beta 1", "4x8": "4 substeps\nof 8",
          "16x2": "16 substeps\nof 2", "warm": "warm and\nprojection", "projection": "projection",
          "split": "split\nimpulse", "relax": "soft and\nrelax",
          "omega": "over-relaxed\n1.9", "velocity": "direct", "shake": "direct,\npositions",
          "inertia": "direct,\nthe default", "velocity/8": "direct,\n8 substeps",
          "shake/8": "positions,\n8 substeps",
          "inertia/8": "the default,\n8 substeps", "rk4": "Runge-\nKutta",
          "tree": "reduced", "tree-rk4": "reduced,\nRunge-Kutta"}
MAPS = {"heavy end": ("mass of\nthe end", "gap_max_m"),
        "m r^2/I": ("smaller beads:\n$m r^2/I$", "gap_max_m"),
        "steps per s": ("steps per\nsecond", "gap_max_m"),
        "links": ("hinges of\na chain", "gap_max_m"),
        "springs in Hz": ("wrong sag of\nsprings [Hz]", "found")}
LOOKS = {kind: {"facecolor": named(name), "edgecolor": "white", "linewidth": 0.8}
         for kind, name in enumerate(("green", "ok", "torn", "orange"))} | {
    -1: {"facecolor": EMPTY, "edgecolor": named("behind"), "linewidth": 0, "hatch": "////"}}
LEAST, MOST = 1e-3, 1e3  # of the colours [mm]


def short(value):
    """Three digits at most."""
    return f"{value:.0f}" if value >= 99.5 else f"{value:.2g}"


def colours():
    map_of = style.plt.cm.viridis_r.copy()
    map_of.set_bad(EMPTY)
    return map_of


def paint(ax, cells, width, height):
    """Cells {(column, row): (error [mm] or nan for failed, words below)}; yellow is exact."""
    errors = np.full((height, width), np.nan)
    for (column, row), (error, below) in cells.items():
        errors[row, column] = np.clip(error, LEAST, MOST) if np.isfinite(error) else MOST
        words = "failed" if not error <= MOST else "0" if error < LEAST else short(error)
        colour = "white" if errors[row, column] > 0.6 else INK
        lines = below.split("\n") if error <= MOST else []
        for k, (line, size) in enumerate([(words, 7.5), *((line, 6.5) for line in lines)]):
            ax.text(column, row + (k - 0.5 * len(lines)) / (1.15 * (len(lines) + 1)), line,
                    ha="center", va="center", fontsize=size, color=colour,
                    fontweight="normal" if k else "bold")
    ax.pcolormesh(np.arange(width + 1) - 0.5, np.arange(height + 1) - 0.5, np.log10(errors),
                  cmap=colours(), vmin=np.log10(LEAST), vmax=np.log10(MOST))
    ax.set_ylim(height - 0.5, -0.5)
    ax.xaxis.tick_top()
    ax.tick_params(length=0)
    ax.grid(False)
    for spine in ax.spines.values():
        spine.set_visible(False)


def error_of(row, what="gap_max_m"):
    """The error in a cell [mm]: NaN where the run failed or gained energy."""
    if row["status"] in ("energy+", "exploded", "nan"):
        return np.nan
    return abs(row["found"] - row["expected"]) if what == "found" else 1000 * row["gap_max_m"]


def draw_scenes(rows, methods, path):
    """Every scene a row, every method a column."""
    scenes = [name for name in dict.fromkeys(row["scene"] for row in rows)
              if ": " not in name and sum(row["scene"] == name for row in rows) > 3]
    held = {name: [row["status"] in ("ok", "soft") for row in rows
                   if row["scene"] in scenes and row["method"] == name] for name in methods}
    figure, ax = style.figure("Scenes without failure: " + ", ".join(
        f"{sum(held[name])} of {len(held[name])} with {words}" for name, words in (
            ("si30", "30 iterations"), ("16x2", "16 substeps of 2"), ("velocity", "direct"),
            ("inertia", "the default")) if name in methods))
    figure.set_size_inches(0.72 * len(methods) + 1.2, 0.31 * len(scenes) + 1.1)
    paint(ax, {(methods.index(row["method"]), scenes.index(row["scene"])):
               (error_of(row), f"{short(row['us_per_step'])} us")
               for row in rows if row["scene"] in scenes and row["method"] in methods},
          len(methods), len(scenes))
    ax.set_xticks(range(len(methods)), [TITLES[name] for name in methods], fontsize=7.5)
    ax.set_yticks(range(len(scenes)), scenes, fontsize=8)
    ax.set_xlabel("above: largest gap of a joint [mm], the darker the wider; failed: above 1 m, or "
                  "energy gained\nbelow: time of a step; of random families the worst of all",
                  fontsize=8)
    style.save(figure, path)


def held(row):
    return row["status"] in ("ok", "soft")


def draw_map(rows, methods, path, what, limits, title, words):
    """A panel for each number that changes: its values are the columns, the methods the rows.
    `what` of a row is in one of four classes, up to each of the limits; a cell without class has
    failed, and a line is drawn around these."""
    columns = {family: list(dict.fromkeys(row["scene"].partition(": ")[2] for row in rows
                                          if row["scene"].startswith(family + ": ")))
               for family in MAPS}
    columns = {family: values for family, values in columns.items() if any(
        held(row) for row in rows if row["scene"].startswith(family + ": "))}
    figure, axes = style.figure(title, len(columns), sharey=True,
                                width_ratios=[len(values) for values in columns.values()])
    for ax, (family, values) in zip(axes, columns.items()):
        kinds = np.full((len(methods), len(values)), -1)
        for row in rows:
            if row["scene"].startswith(family + ": ") and row["method"] in methods and held(row):
                kinds[methods.index(row["method"]), values.index(row["scene"].partition(": ")[2])] \
                    = np.searchsorted(limits, what(row, MAPS[family][1]))
        for kind, look in LOOKS.items():
            ax.add_collection(PatchCollection([Rectangle((x - 0.5, y - 0.5), 1, 1) for y, x in
                                               np.argwhere(kinds == kind)], **look))
        ax.add_collection(LineCollection(
            [np.add((x, y), ends) for y, x in np.ndindex(kinds.shape) for to, ends in (
                ((y, x + 1), ((0.5, -0.5), (0.5, 0.5))), ((y + 1, x), ((-0.5, 0.5), (0.5, 0.5))))
             if to in np.ndindex(kinds.shape) and (kinds[to] < 0) != (kinds[y, x] < 0)],
            colors=INK, linewidths=2.2, zorder=5))
        ax.set(xlim=(-0.5, len(values) - 0.5), ylim=(len(methods) - 0.5, -0.5))
        ax.set_xticks(range(len(values)), [f"$10^{value[2:]}$" if value.startswith("1e") else value
                                           for value in values], fontsize=8, rotation=90)
        ax.set_title(MAPS[family][0], fontsize=8.5)
        ax.tick_params(length=0)
        ax.grid(False)
        ax.spines[:].set_visible(False)
    axes[0].set_yticks(range(len(methods)), [TITLES[name].replace("\n", " ") for name in methods])
    figure.supxlabel(" ")  # the room of the legend
    figure.legend([Rectangle((0, 0), 1, 1, **look) for look in LOOKS.values()], [*words, "failed"],
                  loc="lower center", ncol=5, frameon=False, fontsize=9)
    style.save(figure, path)


def draw_maps(rows, methods, path):
    """The map of the gaps, or that of the energy that it costs if the path says so; those first
    that hold most."""
    rows = [row for row in rows if ": " in row["scene"] and row["method"] in methods]
    of = {name: [row for row in rows if row["method"] == name] for name in methods}
    of = {name: of[name] for name in sorted(filter(of.get, of), key=lambda name: sum(
        not held(row) for row in of[name]))}
    always = [name for name, mine in of.items() if all(held(row) for row in mine)]

    def price(name):
        return 100 * max(-row["energy_drift"] for row in of[name])
    if "energy" not in path.name:
        draw_map(rows, list(of), path, error_of, (1, 10, 100),
                 f"{len(always)} of {len(of)} methods hold all {len(of[always[0]])} cases",
                 ("gap below 1 mm", "to 10 mm", "to 100 mm", "above"))
        return
    draw_map([row for row in rows if np.isfinite(row["energy_drift"]) or not held(row)], list(of),
             path, lambda row, _: -100 * row["energy_drift"], (1, 10, 50),
             "Largest part of the energy that it costs to hold all: " + "; ".join(
                 f"{price(name):.0f} % with {TITLES[name]}".replace("\n", " ")
                 for name in sorted(always, key=price, reverse=True)
                 if name in (max(always, key=price), "inertia", min(always, key=price))),
             ("energy lost: below 1 %", "to 10 %", "to 50 %", "above"))


def draw_motion(rows, path):
    """The map of how far a body is from its place in the first second; lost is what is 10 m away,
    as in the table of docs/measurements.md. Those first that are near most often."""
    for row in rows:
        row["status"] = "ok" if row["first_second_m"] < 10 else "lost"
    rows = [row for row in rows if ": " in row["scene"] and row["method"] in TITLES
            and not row["scene"].startswith("springs")]
    methods = list(dict.fromkeys(row["method"] for row in rows))
    near = {name: sum(row["first_second_m"] < 0.01 for row in rows if row["method"] == name)
            for name in methods}
    methods.sort(key=near.get, reverse=True)
    draw_map(rows, methods, path, lambda row, _: 1000 * row["first_second_m"], (1, 10, 100),
             f"Cases of {len({row['scene'] for row in rows})} in which no body is 10 mm from its "
             "place in the first second: " + ", ".join(
                 f"{near[name]} with {TITLES[name]}".replace("\n", " ") for name in methods[:3]),
             ("within 1 mm", "10 mm", "100 mm", "10 m"))


def main():
    given = style.arguments("Draws a map of every method on every scene.",
                            csv="the table that ./wb bench --methods writes",
                            maps="optional: the maps over one number each, an SVG: of the "
                                 "energy or of the motion if its name says so",
                            out="optional: folder of the figures")
    motion = given.maps and "motion" in given.maps.name
    table = style.rows(style.read_csv(given.csv, *(
        (["first_second_m"], WORDS[:-1]) if motion else (NUMBERS, WORDS)), "./wb bench --methods"),
                       real="double")
    rows = [dict(zip(table, cells)) for cells in zip(*table.values())]
    methods = [name for name in ORDER if name in table["method"]]
    if motion:
        draw_motion(rows, given.maps / given.maps.stem)
    elif given.maps:
        draw_maps(rows, methods, given.maps / given.maps.stem)
    if given.out:
        draw_scenes(rows, methods, given.out / "methods")
        if any(": " in row["scene"] for row in rows):
            for name in ("maps", "energy"):
                draw_maps(rows, methods, given.out / f"methods_{name}")


if __name__ == "__main__":
    style.run(main)
