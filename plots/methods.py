#!/usr/bin/env python3
"""Draws maps of every method: its colour the largest gap, its words gap and time; once over all
scenes, once over mass ratio, m r^2/I, step, length and stiffness.

methods.py --csv out/methods.csv --out DIR
methods.py --csv bench/measured/methods.csv --maps docs/maps.svg
"""
import numpy as np

import style
from style import EMPTY, INK

NUMBERS = ["us_per_step", "gap_max_m", "expected", "found", "energy_drift"]
WORDS = ["scene", "real", "method", "status"]
ORDER = ["si30", "beta1", "4x8", "16x2", "warm", "projection", "split", "relax",
         "omega", "velocity", "shake",
         "inertia", "velocity/8", "shake/8", "inertia/8", "rk4"]
TITLES = {"si30": "30\niterations", "beta1": "beta 1", "4x8": "4 substeps\nof 8",
          "16x2": "16 substeps\nof 2", "warm": "warm and\nprojection", "projection": "projection",
          "split": "split\nimpulse", "relax": "soft and\nrelax",
          "omega": "over-relaxed\n1.9", "velocity": "direct", "shake": "direct,\npositions",
          "inertia": "direct,\nadded inertia", "velocity/8": "direct,\n8 substeps",
          "shake/8": "positions,\n8 substeps",
          "inertia/8": "inertia,\n8 substeps", "rk4": "Runge-\nKutta"}
MAPS = {"heavy end": ("mass ratio of the end of 20 links", "gap_max_m"),
        "m r^2/I": ("$m r^2/I$ of 20 beads, an end of 10", "gap_max_m"),
        "steps per s": ("steps per second, the end 100 links heavy", "gap_max_m"),
        "links": ("hinges of a chain that swings", "gap_max_m"),
        "springs in Hz": ("springs in place of ten joints [Hz]", "found")}
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
            ("inertia", "direct, added inertia")) if name in methods))
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


def energy_of(row):
    """The change of the energy, as a line below the others; none where it is small."""
    drift = row["energy_drift"]
    return f"\n\u2212{-100 * drift:.0f} % energy" if drift < -0.005 else ""


def draw_maps(rows, methods, path):
    """A panel for each number that changes: its values are the columns, the methods the rows."""
    methods = [name for name in methods if any(
        row["method"] == name and ": " in row["scene"] for row in rows)]
    def price(method):  # of the worst cell, and none may have failed
        mine = [row for row in rows if row["method"] == method and ": " in row["scene"]]
        assert mine and all(row["status"] in ("ok", "soft") for row in mine), method
        return 100 * max(-row["energy_drift"] for row in mine)
    figure, axes = style.figure(
        "newton = 8 holds every mass ratio, step and spring; alone it loses up to "
        f"{price('shake'):.0f} % of the energy, with added inertia {price('inertia'):.0f} %",
        panels=2, rows=3, sharey=True)
    figure.set_size_inches(style.WIDTH + 2.2, 1.2 * len(methods) + 1.6)
    style.entitle(figure, figure._suptitle.get_text().replace("\n", " "))
    axes.flat[-1].set_axis_off()
    for ax, (family, (title, measure)) in zip(axes.flat, MAPS.items()):
        mine = [row for row in rows if row["scene"].startswith(family + ": ")]
        values = list(dict.fromkeys(row["scene"].partition(": ")[2] for row in mine))
        cells = {}
        for row in mine:
            value = row["scene"].partition(": ")[2]
            if row["method"] in methods:
                steps = float(value) / 60 if family == "steps per s" else 1
                cells[values.index(value), methods.index(row["method"])] = (
                    error_of(row, measure), f"{short(row['us_per_step'] * steps)} us"
                    + energy_of(row))
        paint(ax, cells, len(values), len(methods))
        names = [f"$10^{value[2:]}$" if value.startswith("1e") else value for value in values]
        ax.set_xticks(range(len(values)), names, fontsize=8)
        ax.set_yticks(range(len(methods)), [TITLES[name].replace("\n", " ") for name in methods],
                      fontsize=7.5)
        ax.set_title(title, fontsize=9, loc="left")
    figure.supxlabel("above: largest gap [mm], for the springs how far the load is off its place; "
                     "failed: above 1 m, or energy gained\nbelow: time for a sixtieth of a "
                     "second, and energy removed in the run", fontsize=8)
    style.save(figure, path)


def main():
    given = style.arguments("Draws a map of every method on every scene.",
                            csv="the table that ./wb bench --methods writes",
                            maps="optional: the maps over one number each, an SVG",
                            out="optional: folder of the figures")
    table = style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --methods"),
                       real="double")
    rows = [dict(zip(table, cells)) for cells in zip(*table.values())]
    methods = [name for name in ORDER if name in table["method"]]
    if given.maps:
        draw_maps(rows, methods, given.maps / given.maps.stem)
    if given.out:
        draw_scenes(rows, methods, given.out / "methods")
        if any(": " in row["scene"] for row in rows):
            draw_maps(rows, methods, given.out / "methods_maps")


if __name__ == "__main__":
    style.run(main)
