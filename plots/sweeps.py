#!/usr/bin/env python3
"""Draws the least error of a tip that an engine reaches in a time, over all its settings and steps
from 1/30 to 1/1920 s.

sweeps.py --csv bench/measured/sweeps.csv --out docs/beside.svg
"""
import textwrap

import numpy as np
from matplotlib.lines import Line2D

import style
from style import COLOURS, INK, PALE

NUMBERS = ["steps_per_s", "us_per_step", "spread", "tip_error_m"]
WORDS = ["real", "scene", "engine", "version", "setting", "status", "machine"]
REFERENCE = 1e-9  # [m]: the references agree to this, so smaller errors mean nothing
LOST = ("nan", "refused", "exploded", "torn")
DRIVEN = "driven arm"  # its motors do work, so to gain energy is no failure
BENCH = "rk4"  # Runge-Kutta on rows belongs to the bench: no library has it
GROUPS_OF_OURS = ("ours, reduced", "ours, on rows")
GROUPS = {"ours, on rows": style.named("as-printed"), "ours, reduced": COLOURS[0],
          "Bullet": COLOURS[1], "ODE": COLOURS[2], "MuJoCo": COLOURS[3], "Simbody": COLOURS[5]}
LEVELS = (1e-2, 1e-3, 1e-6)  # [m]
NAMES = {"S5": "three hinges"}


def points(table):
    """(time [ms] per simulated second, error [m], whether it counts) of rows: what came apart or
    gained energy does not."""
    x = 1e-3 * table["us_per_step"] * table["steps_per_s"]
    y = table["tip_error_m"]
    lost = np.isin(table["status"], LOST) | (
        (table["status"] == "energy+") & (table["scene"] != DRIVEN))
    return x, np.maximum(y, REFERENCE), np.isfinite(x) & np.isfinite(y) & ~lost


def kept(table):
    """(time, error) of rows, infinite in a row of the bench alone: no finer step of the same
    setting has a larger error, nor is it lost."""
    x, y, good = points(table)
    y = np.where(good & (table["setting"] != BENCH), y, np.inf)
    finer = table["steps_per_s"] >= table["steps_per_s"][:, None]
    for name in ("engine", "setting"):
        finer &= table[name] == table[name][:, None]
    return x, np.max(np.where(finer, y, 0), axis=1)


def groups_of(table):
    """The group of each row: an engine, or of ours the kind of coordinates."""
    ours = np.where(np.char.startswith(table["setting"], "tree"), *GROUPS_OF_OURS)
    return np.where(table["engine"] == "ours", ours, table["engine"])


def front(x, y):
    """The points to which no other is superior in both, fastest first; the references cannot tell
    errors near their own apart."""
    y = np.maximum(y, 2 * REFERENCE)
    order, best, out = np.lexsort((y, x)), np.inf, []
    for k in order:
        if y[k] < 0.999 * best:  # so never what is infinite
            best = y[k]
            out.append(k)
    return out


def fastest(table, level):
    """The groups that reach an error [m] first and keep it: one if its time with the spread is
    below that of all others, else all that cannot be told apart from it."""
    x, y = kept(table)
    low, high = (x * (1 + side * table["spread"] / 2) for side in (-1, 1))
    reach = y <= level
    if not reach.any():
        return []
    first = np.argmin(np.where(reach, x, np.inf))
    return list(dict.fromkeys(groups_of(table)[reach & (low <= high[first])]))


def draw_scene(ax, table):
    x, y = kept(table)
    groups = groups_of(table)
    for group, colour in GROUPS.items():
        mine = np.flatnonzero(groups == group)
        best = mine[front(x[mine], y[mine])]
        ax.step(x[best], y[best], where="post", color=colour, marker="o", markersize=3,
                linewidth=2 if group in GROUPS_OF_OURS else 1.2, zorder=4 if group == "ODE" else 3)
    ax.axhspan(REFERENCE / 2, 2 * REFERENCE, color=style.GRID, linewidth=0, zorder=0)
    first = [fastest(table, level) for level in LEVELS]
    said = [" = ".join(one) or "nobody reaches it" for one in first]
    if len(set(said)) == 1:
        said = ["", f"{said[0]},\nat all three levels", ""]
    for level, one, words in zip(LEVELS, first, said):
        ax.axhline(level, color=PALE, linewidth=0.6, dashes=(1, 2), zorder=1)
        ax.annotate(words, (1.02, level), va="center", fontsize=7.5, annotation_clip=False,
                    xycoords=("axes fraction", "data"),
                    color=GROUPS[one[0]] if len(one) == 1 else INK,
                    fontweight="bold" if len(one) == 1 else "normal")
    if absent := [group for group in GROUPS if group not in groups]:
        ax.text(0.03, 0.1, "not on a closed loop:\n" + " and ".join(absent), fontsize=8,
                transform=ax.transAxes)
    ax.set(xscale="log", yscale="log", ylim=(REFERENCE / 2, 3))
    ax.minorticks_off()
    ax.yaxis.set_ticks([1, *LEVELS, REFERENCE], map(style.metres, (1, *LEVELS, REFERENCE)))
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")


def headline(table):
    """On how many trees reduced coordinates are the first at every level, and on how many linkages
    somebody is at any."""
    first = {scene: [fastest(style.rows(table, scene=scene), level) for level in LEVELS]
             for scene in dict.fromkeys(table["scene"])}
    trees = {name for name, group in zip(table["scene"], groups_of(table))
             if group == GROUPS_OF_OURS[0]}
    won = sum(all(one == [GROUPS_OF_OURS[0]] for one in first[name]) for name in trees)
    decided = [name for name in first if name not in trees
               and any(len(one) == 1 for one in first[name])]
    loops = len(first) - len(trees)
    levels = " and ".join(", ".join(map(style.metres, LEVELS)).rsplit(", ", 1))
    return (f"Trees: ours, reduced, is first at {levels} on {won} of {len(trees)}. Closed loops: "
            f"nobody is first alone on {loops - len(decided)} of {loops}")


def draw(table, path):
    scenes = list(dict.fromkeys(table["scene"]))
    made = style.plt.figure(figsize=(style.WIDTH, 10.4), layout="constrained")
    style.entitle(made, headline(table))
    key, below, under = made.subfigures(3, 1, height_ratios=(0.45, 9.3, 0.75))
    lines = [Line2D([], [], color=colour, marker="o", markersize=3) for colour in GROUPS.values()]
    key.legend(lines, GROUPS, loc="upper left", bbox_to_anchor=(0.01, 1), ncol=6, frameon=False,
               fontsize=8.5, columnspacing=1.2, borderaxespad=0)
    key.text(0.012, 0.0, "each line: an engine's best error for a given time, of all settings "
             "tried. Right: the fastest at each dotted level (=: a tie)", fontsize=8)
    panels = below.subplots(-(-len(scenes) // 2), 2, sharex=True, sharey=True)
    for ax, scene in zip(panels.flat, scenes):
        draw_scene(ax, style.rows(table, scene=scene))
        ax.set_title(NAMES.get(scene, scene), fontsize=9)
        ax.tick_params(labelsize=8, bottom=False, left=False)
    panels.flat[0].annotate("better", (0.02, 0.07), (0.06, 0.19), xycoords="axes fraction",
                            fontsize=8, arrowprops={"arrowstyle": "->", "color": INK})
    panels.flat[-1].text(0.03, 1.15 * REFERENCE, "below the reference's accuracy", fontsize=7,
                        va="center", transform=panels.flat[-1].get_yaxis_transform())
    below.supylabel("error of the tip at the end", fontsize=9)
    below.supxlabel("processor time per simulated second  [ms]", fontsize=9)
    under.text(0.012, 0.5, textwrap.fill(machine(table), 122), fontsize=7.5, va="center",
               color=INK)
    style.save(made, path / "sweeps")


def machine(table):
    """The processor and what everything was compiled with."""
    words = table["machine"][0].split("; ")
    engines = ", ".join(dict.fromkeys(f"{engine} {version}" for engine, version in
                                      zip(table["engine"], table["version"]) if version))
    return (f"{', '.join(words[:-1])}; one core, double. Ours: {words[-1]}. {engines}: Debian's "
            "packages, -O2, any x86-64. All start with half a step of the forces. A tie: times "
            "that their spread does not tell apart.")


def main():
    given = style.arguments("Draws error against processor time over the length of the step.",
                            csv="the table that ./wb bench --sweeps writes",
                            out="the drawing, an SVG, or its folder")
    draw(style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --sweeps")), given.out)


if __name__ == "__main__":
    style.run(main)
