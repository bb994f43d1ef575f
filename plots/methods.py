#!/usr/bin/env python3
"""Draws maps of every method: once over all scenes, with gap and time in each cell, and over mass
ratio, m r^2/I, step, length and stiffness, one of the gap, one of the energy and one of the motion.

methods.py --csv out/methods.csv --out DIR
methods.py --csv bench/measured/methods.csv --maps docs/maps.svg
methods.py --csv bench/measured/trajectories.csv --maps docs/maps_motion.svg
"""
import numpy as np
from matplotlib.collections import PatchCollection
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
          "split": "split\nimpulse", "relax": "soft and\nrelax", "omega": "over-relaxed\n1.9",
          "velocity": "direct,\nvelocities", "shake": "direct,\npositions",
          "inertia": "direct\n(default)", "velocity/8": "direct, velocities,\n8 substeps",
          "shake/8": "direct, positions,\n8 substeps",
          "inertia/8": "direct (default),\n8 substeps", "rk4": "Runge-\nKutta",
          "tree": "reduced", "tree-rk4": "reduced,\nRunge-Kutta"}
# What changes in a map, from easy to hard.
MAPS = {"heavy end": ("mass of the end\nof a chain [links]", "heavier"),
        "m r^2/I": ("inertia of beads:\n$m r^2/I$", "smaller inertia"),
        "steps per s": ("steps\nper second", "coarser"),
        "links": ("hinges\nof a chain", "longer")}
HARDER_FIRST = "steps per s"  # its table begins with the hardest
FAILED = {"facecolor": EMPTY, "edgecolor": named("behind"), "linewidth": 0, "hatch": "////"}
GAPS = [named(name) for name in ("green", "ok", "torn", "orange")]
ENERGIES = [style.plt.cm.Purples(share) for share in (0.12, 0.35, 0.62, 0.92)]
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


def gap_of(row):
    """The gap in a cell [mm]: NaN where the run failed or gained energy."""
    return np.nan if row["status"] in ("energy+", "exploded", "nan") else 1000 * row["gap_max_m"]


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
               (gap_of(row), f"{short(row['us_per_step'])} us")
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


def title_of(method):
    return TITLES[method].replace("\n", " ")


def cases(rows):
    """The rows of the maps: of scenes in which one number changes."""
    return [row for row in rows if row["scene"].partition(": ")[0] in MAPS]


def draw_map(rows, ends, above_ends, path, what, colours, limits, title, words, lost):
    """A panel for each number that changes: its values are the columns, from easy to hard, the
    methods the rows. `what` of a row is in one of four classes, up to each of the limits; a cell
    without class has failed, which `lost` explains. `ends` has what stands at the right end of
    each method's row, under the words `above_ends`."""
    columns = {}
    for row in rows:
        family, _, value = row["scene"].partition(": ")
        columns.setdefault(family, {})[value] = None
    columns = {family: list(columns[family])[::-1 if family == HARDER_FIRST else 1]
               for family in MAPS}
    looks = {kind: {"facecolor": colour, "edgecolor": "white", "linewidth": 0.8}
             for kind, colour in enumerate(colours)} | {-1: FAILED}
    methods = list(ends)
    wide = [sum(1 + max(0, len(value) - 2) / 3 for value in values) for values in columns.values()]
    figure, axes = style.figure(title, len(columns), sharey=True, width_ratios=wide)
    figure.set_size_inches(style.WIDTH, 1.9 + 0.19 * len(methods))
    for ax, (family, values) in zip(axes, columns.items()):
        kinds = np.full((len(methods), len(values)), -1)
        for row in rows:
            mine, _, value = row["scene"].partition(": ")
            if mine == family and row["method"] in methods and held(row):
                kinds[methods.index(row["method"]), values.index(value)] \
                    = np.searchsorted(limits, what(row))
        for kind, look in looks.items():
            ax.add_collection(PatchCollection([Rectangle((x - 0.5, y - 0.5), 1, 1) for y, x in
                                               np.argwhere(kinds == kind)], **look))
        ax.set(xlim=(-0.5, len(values) - 0.5), ylim=(len(methods) - 0.5, -0.5))
        ax.set_xticks(range(len(values)), [f"$10^{value[2:]}$" if value.startswith("1e") else value
                                           for value in values], fontsize=6.8)
        ax.set_title(MAPS[family][0], fontsize=8.5)
        ax.set_xlabel(f"{MAPS[family][1]} \N{RIGHTWARDS ARROW}", fontsize=8)
        ax.tick_params(length=0)
        ax.grid(False)
        ax.spines[:].set_visible(False)
    axes[-1].annotate(above_ends, (1.03, 1.02), xycoords="axes fraction", fontsize=8.5)
    axes[0].set_yticks(range(len(methods)), [title_of(name) for name in methods])
    for line, name in enumerate(methods):
        axes[-1].annotate(ends[name], (1.03, line), xycoords=("axes fraction", "data"),
                          va="center", fontsize=8.5)
    figure.supxlabel(" ", fontsize=16)  # the room of the legend
    words += (lost,) * bool(lost)
    figure.legend([Rectangle((0, 0), 1, 1, **look) for look in looks.values()][:len(words)], words,
                  loc="lower center", ncol=5, frameon=False, fontsize=8, handlelength=1.5,
                  columnspacing=1.2)
    style.save(figure, path)


def draw_maps(rows, methods, path):
    """The map of the gaps, or that of the energy that it costs if the path says so; those first
    that hold most."""
    rows = [row for row in cases(rows) if row["method"] in methods]
    of = {name: [row for row in rows if row["method"] == name] for name in methods}
    counts = {name: sum(map(held, mine)) for name, mine in of.items() if mine}
    order = sorted(counts, key=counts.get, reverse=True)
    most = len(of[order[0]])
    always = [name for name in order if counts[name] == most]

    def worst(name):
        return max(map(gap_of, of[name]))
    if "energy" not in path.name:
        draw_map(rows, {name: f"{counts[name]} of {most}" for name in order}, "not failed", path,
                 gap_of, GAPS, (1, 10, 100),
                 f"{len(always)} of {len(order)} methods never fail in {most} cases, and keep "
                 f"every gap below {style.metres(1e-3 * max(map(worst, always)))}",
                 ("gap below 1 mm", "1 to 10 mm", "10 to 100 mm", "above 100 mm"),
                 "failed: half a link open, or +2 % energy")
        return

    def price(name):
        return 100 * max(-row["energy_drift"] for row in of[name])
    always.sort(key=price)
    draw_map(rows, {name: f"{price(name):.0f} %" for name in always}, "at worst", path,
             lambda row: -100 * row["energy_drift"], ENERGIES, (1, 10, 50),
             f"The {len(always)} methods that never fail lose energy in the run: at worst "
             f"{price(always[0]):.0f} to {price(always[-1]):.0f} %",
             ("below 1 % lost", "1 to 10 %", "10 to 50 %", "above 50 %"), "")


def draw_motion(rows, path):
    """The map of how far a body is from its place in the first second; lost is what is 10 m away,
    as in the table of docs/measurements.md. Those first that are near most often."""
    for row in rows:
        row["status"] = "ok" if row["first_second_m"] < 10 else "lost"
    rows = [row for row in cases(rows) if row["method"] in TITLES]
    methods = list(dict.fromkeys(row["method"] for row in rows))
    near = {name: sum(row["first_second_m"] < 0.01 for row in rows if row["method"] == name)
            for name in methods}
    methods.sort(key=near.get, reverse=True)
    count = len({row["scene"] for row in rows})
    draw_map(rows, {name: f"{near[name]} of {count}" for name in methods}, "within\n10 mm", path,
             lambda row: 1000 * row["first_second_m"], GAPS, (1, 10, 100),
             f"{title_of(methods[0]).capitalize()} stays within 10 mm of the true motion in "
             f"{near[methods[0]]} of {count} cases; the default in {near['inertia']}",
             ("off the reference by up to 1 mm", "1 to 10 mm", "10 to 100 mm", "0.1 to 10 m"),
             "farther, or gave up")


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
