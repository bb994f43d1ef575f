#!/usr/bin/env python3
"""Draws the error of a tip against processor time, for steps from 1/30 to 1/1920 s.

sweeps.py --csv bench/measured/sweeps.csv --out docs/beside.svg
"""
import textwrap

import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["steps_per_s", "us_per_step", "spread", "tip_error_m"]
WORDS = ["real", "scene", "engine", "version", "setting", "status", "machine"]
LARGE = "triple pendulum"
REFERENCE = 1e-9  # [m]: the references agree to this, so smaller errors mean nothing
LOST = ("nan", "refused", "exploded", "torn")
DRIVEN = "driven arm"  # its motors do work, so to gain energy is no failure
BENCH = "rk4"  # Runge-Kutta on rows belongs to the bench: no library has it
ENGINE = {"ours, on rows": style.named("as-printed"), "ours, reduced": COLOURS[0],
          "Bullet": COLOURS[1], "ODE": COLOURS[2], "MuJoCo": COLOURS[3], "Simbody": COLOURS[5]}
# A family of methods: its line and marker.
KIND = {"iterations": (":", "o"), "one solve": ("-", "s"), "reduced": ("--", "^"),
        "Runge-Kutta": ("-", "D"), "bench only": ("-.", "D")}
# The curves: engine, setting, family, and words. Those of the direct solver have markers of their
# own.
MARKER = {"velocity": "v", "shake": "P"}
CURVES = (
    ("ours", "beta1:30", "iterations", "30 iterations, beta 1"),
    ("ours", "velocity", "one solve", "direct, velocities only"),
    ("ours", "shake", "one solve", "direct, positions"),
    ("ours", "inertia", "one solve", "direct, the default"),
    ("ours", BENCH, "bench only", "rows, Runge-Kutta (bench only)"),
    ("ours", "tree", "reduced", "reduced"),
    ("ours", "tree-rk4", "Runge-Kutta", "reduced, Runge-Kutta"),
    ("Bullet", "60 iterations", "iterations", "60 iterations"),
    ("Bullet", "multibody", "reduced", "multibody"),
    ("Bullet", "multibody Runge-Kutta", "Runge-Kutta", "multibody, Runge-Kutta"),
    ("ODE", "60 iterations", "iterations", "60 iterations"),
    ("ODE", "dense erp 1", "one solve", "dense, erp 1"),
    ("MuJoCo", "Euler (its default)", "reduced", "Euler"),
    ("MuJoCo", "implicit", "reduced", "implicit"),
    ("MuJoCo", "Runge-Kutta", "Runge-Kutta", "Runge-Kutta"),
    ("Simbody", "Verlet", "reduced", "Verlet"),
    ("Simbody", "Runge-Kutta-Merson", "Runge-Kutta", "Runge-Kutta-Merson"))
# What a small panel shows only if it is on the front: most are beside another of their engine.
LARGE_ALONE = ("beta1:30", "shake", "60 iterations", "implicit")
LEVELS = (1e-2, 1e-3, 1e-6)  # [m], of the title


def points(table):
    """(time [ms] per simulated second, error [m], whether it counts) of rows: what came apart or
    gained energy does not."""
    x = 1e-3 * table["us_per_step"] * table["steps_per_s"]
    y = table["tip_error_m"]
    lost = np.isin(table["status"], LOST) | (
        (table["status"] == "energy+") & (table["scene"] != DRIVEN))
    return x, np.maximum(y, REFERENCE), np.isfinite(x) & np.isfinite(y) & ~lost


def kept(table):
    """(time, error) of a library's rows, infinite in a row of the bench alone: no finer step of
    the same setting has a larger error, nor is it lost."""
    x, y, good = points(table)
    y = np.where(good & (table["setting"] != BENCH), y, np.inf)
    finer = table["steps_per_s"] >= table["steps_per_s"][:, None]
    for name in ("engine", "setting"):
        finer &= table[name] == table[name][:, None]
    return x, np.max(np.where(finer, y, 0), axis=1)


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
    """The engine that reaches an error [m] first and keeps it, if its time with the spread is below
    that of all others; otherwise all engines that cannot be told apart from it."""
    x, y = kept(table)
    low, high = (x * (1 + side * table["spread"] / 2) for side in (-1, 1))
    reach = y <= level
    if not reach.any():
        return set()
    first = np.argmin(np.where(reach, x, np.inf))
    return {engine for engine, least in zip(table["engine"][reach], low[reach])
            if least <= high[first]}


def draw_curve(ax, table, **look):
    """Joins the points that count, and draws crosses for the others; returns those that count."""
    x, y, good = points(table)
    if not good.all():
        ax.plot(x[~good], y[~good], "x", color=look["color"], markersize=4, label="_lost")
    good &= np.cumsum(y <= REFERENCE) <= 1  # one point at the floor shows that it is reached
    ax.plot(x, np.where(good, y, np.nan), **look)
    return x, y, good


def draw_scene(ax, table, large):
    drawn = {curve[:2] for curve in CURVES}
    names = list(zip(table["engine"], table["setting"]))
    x, y = kept(table)
    line = front(x, np.where([name in drawn for name in names], y, np.inf))
    ax.step(x[line], y[line], where="post", color=PALE, linewidth=4 if large else 3, alpha=0.35,
            zorder=1, label="_front")
    bars, best = [], y.min()
    for engine, setting, kind, words in CURVES:
        curve = style.rows(table, engine=engine, setting=setting)
        if not len(curve["scene"]) or not large and setting in LARGE_ALONE and (
                engine, setting) not in [names[k] for k in line]:
            continue
        ours = engine == "ours"
        way, marker = KIND[kind]
        road = "reduced" if "tree" in setting else "on rows"
        colour = ENGINE[f"ours, {road}" if ours else engine]
        x, y, good = draw_curve(
            ax, curve, color=colour, linestyle=way,
            marker=MARKER.get(setting, marker) if ours else marker, markersize=4 if large else 3,
            linewidth=1.3 if large else 1, markerfacecolor=colour if ours else "white",
            label=f"{'' if ours else engine + ', '}{words}", zorder=4 if ours else 3)
        half = curve["spread"] / 2 * x
        bars += [(y[k], x[k] - half[k], x[k] + half[k], colour) for k in np.flatnonzero(good)]
        beside = ""
        if (engine, kind) == ("MuJoCo", "Runge-Kutta") and y[-1] > max(1e-3, 0.99 * y[-2]):
            beside = f"soft constraint:\n{style.metres(y[-1])}"
        if setting == BENCH and y[-1] < 0.1 * best:
            beside = words.replace(" (", "\n(")
        if beside:
            ax.annotate(beside, (x[good][-1], y[-1]), xytext=(6, 2), textcoords="offset points",
                        fontsize=7.5, color=colour)
    heights, begins, ends, colours = zip(*bars)
    ax.hlines(heights, begins, ends, color=colours, linewidth=2.2 if large else 1.6)
    ax.axhline(REFERENCE, color=INK, linewidth=1, dashes=(2, 2), label="_floor")
    ax.set(xscale="log", yscale="log", ylim=(REFERENCE / 3, 3))
    ax.minorticks_off()
    style.metres_log(ax.yaxis)
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")


def draw_slopes(ax):
    """Triangles: how fast an error falls where half the step takes twice the time."""
    right, corners = ax.get_xlim()[1], []
    for order, share in ((1, 0.012), (2, 0.05), (4, 0.2)):
        x, high, wide = right * share, 1.0, 2.5
        low = high / wide ** order
        corners += [(x, high), (wide * x, low), (x, low), (x, high), (np.nan, np.nan)]
        ax.annotate(f"order {order}", (x, low), xytext=(0, -3), va="top", fontsize=7.5,
                    textcoords="offset points")
    ax.plot(*zip(*corners), color=INK, linewidth=0.8, label="_slopes")


def headline(table):
    """At each level the number of scenes that ours reach first, and who else is as fast or faster
    in the others."""
    scenes = list(dict.fromkeys(table["scene"]))
    parts = []
    for level in LEVELS:
        found = [fastest(style.rows(table, scene=scene), level) for scene in scenes]
        words = f"{style.metres(level)} in {sum(one == {'ours'} for one in found)}"
        others = [", ".join(sorted(one - {"ours"})) + (" as fast" if "ours" in one else "")
                  for one in found if one != {"ours"}]
        named = [f"{who or 'no library'} in {others.count(who)}" for who in dict.fromkeys(others)]
        parts.append(words + (f" ({'; '.join(named)})" if named else ""))
    return (f"Of {len(scenes)} scenes ours reach and keep an error in the least time: "
            + ", ".join(parts))


def legend(ax):
    """What lines and markers mean, in the place of a panel."""
    ax.set_axis_off()
    for k, (kind, (line, marker)) in enumerate(KIND.items()):
        ax.plot([0, 0.26], [k, k], color=INK, linestyle=line, marker=marker, markersize=3.5,
                markerfacecolor="white", linewidth=1)
        ax.text(0.34, k, kind, va="center", fontsize=8)
    for k, (engine, colour) in enumerate(ENGINE.items(), start=len(KIND)):
        ax.plot([0, 0.26], [k, k], color=colour, linewidth=2.5)
        ax.text(0.34, k, engine, va="center", fontsize=8)
    k = len(KIND) + len(ENGINE)
    ax.plot([0, 0.26], [k, k], color=PALE, linewidth=4, alpha=0.35)
    ax.text(0.34, k, "front of libraries", va="center", fontsize=8)
    ax.plot([0, 0.26], [k + 1, k + 1], color=INK, linewidth=1, dashes=(2, 2))
    ax.text(0.34, k + 1, "reference, 1 nm", va="center", fontsize=8)
    ax.plot(0.13, k + 2, "x", color=INK, markersize=4)
    ax.text(0.34, k + 2, "came apart or gained energy", va="center", fontsize=8)
    ax.set(xlim=(-0.05, 1), ylim=(k + 2.7, -0.7))


def draw(table, path):
    scenes = [scene for scene in dict.fromkeys(table["scene"]) if scene != LARGE]
    made = style.plt.figure(figsize=(style.WIDTH, 14.4), layout="constrained")
    style.entitle(made, headline(table))
    above, below, under = made.subfigures(3, 1, height_ratios=(4.2, 8.4, 0.5))
    large = above.subplots()
    panels = below.subplots(4, 2, sharex=True, sharey=True)
    draw_scene(large, style.rows(table, scene=LARGE), True)
    draw_slopes(large)
    large.set(title=f"{LARGE}: steps of 1/30 to 1/1920 s along each curve",
              ylabel="error of the tip", xlabel="processor time per simulated second  [ms]")
    large.annotate("the references agree to 1 nm", (large.get_xlim()[0], REFERENCE), xytext=(3, 3),
                   fontsize=8, textcoords="offset points")
    for k, ax in enumerate(panels.flat[:len(scenes)]):
        mine = style.rows(table, scene=scenes[k])
        draw_scene(ax, mine, False)
        ax.set_title("three hinges (S5)" if scenes[k] == "S5" else scenes[k], fontsize=9)
        ax.tick_params(labelsize=8, bottom=False, left=False)
        if k >= len(scenes) - 2:
            ax.set_xlabel("ms per second", fontsize=8.5)
            ax.tick_params(labelbottom=True)
    panels.flat[-1].remove()
    legend(below.add_subplot(4, 2, 8))
    under.text(0.02, 0.5, textwrap.fill(machine(table), 122), fontsize=7.5, va="center", color=INK)
    style.label_ends(large, size=8)
    style.save(made, path / "sweeps")


def machine(table):
    """The processor and what everything was compiled with."""
    words = table["machine"][0].split("; ")
    engines = ", ".join(dict.fromkeys(f"{engine} {version}" for engine, version in
                                      zip(table["engine"], table["version"]) if version))
    return (f"{', '.join(words[:-1])}; one core, double. Ours: {words[-1]}. {engines}: Debian's "
            "packages, -O2, any x86-64. Bars: from quartile to quartile of the times; without one "
            "it is shorter than the mark. All start with half a step of the forces. Iterations, "
            "and settings beside another of their engine, are in the large panel, elsewhere only "
            "on the front.")


def main():
    given = style.arguments("Draws error against processor time over the length of the step.",
                            csv="the table that ./wb bench --sweeps writes",
                            out="the drawing, an SVG, or its folder")
    draw(style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --sweeps")), given.out)


if __name__ == "__main__":
    style.run(main)
