#!/usr/bin/env python3
"""Draws the least error of a tip that an engine reaches in a time, over all its settings and steps
from 1/30 to 1/1920 s.

sweeps.py --csv bench/measured/sweeps.csv --out docs/beside.svg
"""
import textwrap

import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["steps_per_s", "us_per_step", "spread", "tip_error_m"]
WORDS = ["real", "scene", "engine", "version", "setting", "status", "machine"]
REFERENCE = 1e-9  # [m]: the references agree to this, so smaller errors mean nothing
LOST = ("nan", "refused", "exploded", "torn")
DRIVEN = "driven arm"  # its motors do work, so to gain energy is no failure
BENCH = "rk4"  # Runge-Kutta on rows belongs to the bench: no library has it
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


def group_of(engine, setting):
    return engine if engine != "ours" else (
        "ours, reduced" if setting.startswith("tree") else "ours, on rows")


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
    """The engines that reach an error [m] first and keep it: one if its time with the spread is
    below that of all others, else all that cannot be told apart from it."""
    x, y = kept(table)
    low, high = (x * (1 + side * table["spread"] / 2) for side in (-1, 1))
    reach = y <= level
    if not reach.any():
        return []
    first = np.argmin(np.where(reach, x, np.inf))
    return list(dict.fromkeys(engine for engine, least in zip(table["engine"][reach], low[reach])
                              if least <= high[first]))


def draw_scene(ax, table):
    x, y = kept(table)
    groups = np.array([group_of(*names) for names in zip(table["engine"], table["setting"])])
    for group, colour in GROUPS.items():
        mine = np.flatnonzero(groups == group)
        best = mine[front(x[mine], y[mine])]
        ours = group.startswith("ours")
        ax.step(x[best], y[best], where="post", color=colour, linewidth=2 if ours else 1.3,
                marker="o", markersize=3.5 if ours else 2.5, zorder=4 if ours else 3)
    for level in LEVELS:
        ax.axhline(level, color=PALE, linewidth=0.6, dashes=(1, 2), zorder=1)
        first = fastest(table, level)
        ax.annotate(" = ".join(first) or "nobody", (1.02, level), va="center", fontsize=7.5,
                    xycoords=("axes fraction", "data"), annotation_clip=False,
                    fontweight="bold" if first == ["ours"] else "normal")
    ax.set(xscale="log", yscale="log", ylim=(REFERENCE / 2, 1))
    ax.minorticks_off()
    style.metres_log(ax.yaxis)
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")


def headline(table):
    """At each level the number of scenes that ours reach first."""
    scenes = list(dict.fromkeys(table["scene"]))
    found = {level: sum(fastest(style.rows(table, scene=scene), level) == ["ours"]
                        for scene in scenes) for level in LEVELS}
    return (f"Of {len(scenes)} scenes ours is the first to reach " + ", ".join(
        f"{style.metres(level)} in {count}" for level, count in found.items()))


def draw(table, path):
    scenes = list(dict.fromkeys(table["scene"]))
    made = style.plt.figure(figsize=(style.WIDTH, 10.4), layout="constrained")
    style.entitle(made, headline(table))
    key, below, under = made.subfigures(3, 1, height_ratios=(0.45, 9.3, 0.75))
    for k, (group, colour) in enumerate(GROUPS.items()):
        key.text(0.012 + 0.168 * k, 0.7, group, color=colour, fontsize=9, fontweight="bold")
    key.text(0.012, 0.1, "each line: the least error in a time, of all settings; right: who is "
             "first at 10 mm, 1 mm and 1 µm", fontsize=8.5)
    panels = below.subplots(-(-len(scenes) // 2), 2, sharex=True, sharey=True)
    for ax, scene in zip(panels.flat, scenes):
        draw_scene(ax, style.rows(table, scene=scene))
        ax.set_title(NAMES.get(scene, scene), fontsize=9)
        ax.tick_params(labelsize=8, bottom=False, left=False)
    panels.flat[-1].annotate("better", (0.06, 0.1), (0.2, 0.34), xycoords="axes fraction",
                            fontsize=8, arrowprops={"arrowstyle": "->", "color": INK})
    below.supylabel("error of the tip", fontsize=9)
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
            "packages, -O2, any x86-64. All start with half a step of the forces. =: times that "
            "their spread does not tell apart. The references agree to 1 nm.")


def main():
    given = style.arguments("Draws error against processor time over the length of the step.",
                            csv="the table that ./wb bench --sweeps writes",
                            out="the drawing, an SVG, or its folder")
    draw(style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --sweeps")), given.out)


if __name__ == "__main__":
    style.run(main)
