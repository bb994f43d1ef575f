#!/usr/bin/env python3
"""Draws the loop's variants: what a joint and iteration costs, and the thesis' tables 5.1 and 5.2.

loop.py --csv out/loop.csv --thesis bench/thesis_frames.csv --out DIR
"""
import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["chains", "iterations", "us_per_step", "ns_per_joint_iteration"]
WORDS = ["variant", "real"]
ORANGE, BLUE, GREEN, PINK, SKY, YELLOW = COLOURS
# Each variant: in words, its colour, and for the engine's dashes.
VARIANTS = {
    "recomputed": ("set up in every solve", PALE, False),
    "textbook": ("set up once a step, virtual calls", INK, False),
    "flat": ("by value in an array, no calls", ORANGE, False),
    "whole-joint": ("one block of five rows", YELLOW, False),
    "interleaved": ("no neighbours one after the other", PINK, False),
    "lanes": ("a chain a lane", BLUE, False),
    "lanes coloured": ("a colour after the other", GREEN, False),
    "engine rows": ("plain Sequential Impulses", INK, True),
    "engine packed": ("packed, one at a time", YELLOW, True),
    "engine lanes": ("a chain a lane", BLUE, True),
    "engine lanes coloured": ("a colour after the other", GREEN, True)}
AS_PRINTED = "printed in the thesis,\nanother machine"


def of(table, variant, chains):
    """The rows of one variant, in the order of their iterations; none are there of some."""
    found = style.rows(table, variant=variant, chains=chains)
    order = np.argsort(found["iterations"])
    return {name: column[order] for name, column in found.items()}


def per_iteration(table, variant, chains):
    """ns per joint and iteration, NaN where a variant is not in the table."""
    found = of(table, variant, chains)["ns_per_joint_iteration"]
    return found[0] if len(found) else np.nan


# ---- what a joint and iteration costs ----------------------------------------------------------

def draw_bars(ax, table, chains, names, places, most):
    """A bar a variant; behind it, pale, what it saves against the one above it."""
    base, before = per_iteration(table, "textbook", chains), np.nan
    for name, place in zip(names, places):
        ns = per_iteration(table, name, chains)
        _, colour, engine = VARIANTS[name]
        if not engine and before > ns:
            ax.barh(place, before - ns, left=ns, height=0.66, color=style.EMPTY)
        ax.barh(place, ns, height=0.66, color="white" if engine else colour,
                edgecolor=colour, linewidth=1.2)
        ratio = f"   {base / ns:.{1 if base > ns else 2}f} x" if name != "textbook" else ""
        cut = bool(ns > most)  # the bar leaves the panel: its number stands inside
        ax.annotate(f"{ns:.1f} ns{ratio}" + "  \N{RIGHTWARDS ARROW}" * cut,
                    (most if cut else ns, place), xytext=(-4 if cut else 4, 0),
                    textcoords="offset points", va="center", ha="right" if cut else "left",
                    fontsize=8, color="white" if cut else INK)
        before = ns
    ax.set_title(f"{chains:g} chains of 99 hinges", color=PALE)


def per_joint(table, out):
    names = [name for name in VARIANTS if name in table["variant"]]
    ours = [name for name in names if not VARIANTS[name][2]]
    places = [i + (0.9 if VARIANTS[name][2] else 0) for i, name in enumerate(names)]
    counts = np.unique(table["chains"])
    best = [min(ours, key=lambda name, c=chains: per_iteration(table, name, c))
            for chains in counts]
    said = [f"{per_iteration(table, 'textbook', c) / per_iteration(table, name, c):.1f}"
            for c, name in zip(counts, best)]
    figure, axes = style.figure(
        f"{' or '.join(dict.fromkeys(best)).capitalize()}: {' and '.join(said)} times as fast an "
        "iteration as the textbook's loop", len(counts), sharey=True, squeeze=False)
    figure.set_size_inches(style.WIDTH, 4.6)
    most = 1.6 * max(per_iteration(table, name, c) for name in names for c in counts
                      if name != "recomputed")
    for ax, chains in zip(axes[0], counts):
        draw_bars(ax, table, chains, names, places, most)
        ax.set(xlabel="ns per joint and iteration", xlim=(0, most),
               ylim=(places[-1] + 0.6, -0.6))
        ax.grid(axis="y", visible=False)
        ax.tick_params(axis="y", length=0)
        ax.axhline(len(ours) - 0.05, color=style.GRID, linewidth=0.8)
    axes[0, 0].set_yticks(places, [f"{name}\n{VARIANTS[name][0]}" for name in names],
                          linespacing=1.1, fontsize=7.6)
    figure.text(0.012, 0.012, "x: textbook / this; hollow:\nthe engine's, for any joint",
                color=PALE, fontsize=7.6)
    style.save(figure, out / "loop")


# ---- the thesis' two tables ----------------------------------------------------------------------

def thesis(frames, chains):
    """(iterations, us a step) of a table in frames a second.

    F frames and 60 steps fill a second, and paused only frames do: a step takes (1 - F/paused)/60.
    """
    found = style.rows(frames, chains=chains)
    paused = found["frames_per_second"][found["iterations"] == 0][0]
    run = found["iterations"] > 0
    return (found["iterations"][run],
            1e6 / 60 * (1 - found["frames_per_second"][run] / paused))


def steps(table, frames, out):
    counts = np.unique(table["chains"])
    first, last = (of(table, name, counts[0]) for name in ("textbook", "lanes"))
    at = last["iterations"] == 200 if 200 in last["iterations"] else np.arange(
        len(last["iterations"])) == len(last["iterations"]) - 1
    many = last["iterations"][at][0]
    times = [f"{rows['us_per_step'][rows['iterations'] == many][0] / 1000:.2g} ms"
             for rows in (first, last)]
    figure, axes = style.figure(
        f"{many:g} iterations over {99 * counts[0]:g} hinges take the textbook's loop {times[0]}, "
        f"lanes {times[1]}", len(counts), sharey=True, squeeze=False)
    figure.set_size_inches(style.WIDTH, 5.2)
    for ax, chains in zip(axes[0], counts):
        for name, (_, colour, engine) in VARIANTS.items():
            rows = of(table, name, chains)
            x, y = rows["iterations"], rows["us_per_step"]
            if not len(x):
                continue
            short = bool(x[-1] < table["iterations"].max())  # its label stands at its own end
            ax.plot(x, y, "o-", color=colour, label="_" * short + name, markersize=3.2,
                    linewidth=1.1 if engine else 1.6, zorder=3,
                    dashes=(4, 2) if engine else (None, None),
                    markerfacecolor="white" if engine else colour)
            if short:
                ax.annotate(name, (x[-1], y[-1]), xytext=(0, 5), textcoords="offset points",
                            ha="center", color=colour, fontsize=8)
        if chains in frames["chains"]:
            ax.plot(*thesis(frames, chains), "s:", color=style.named("as-printed"),
                    label=AS_PRINTED, markersize=4, linewidth=1.1, zorder=4)
        ax.set(xscale="log", yscale="log", xlabel="iterations per step")
        ax.set_title(f"{chains:g} chains: {100 * chains:g} cubes, {99 * chains:g} hinges",
                     color=PALE)
        ax.set_xticks(np.unique(table["iterations"]))
        ax.xaxis.set_minor_locator(style.matplotlib.ticker.NullLocator())
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        style.plain_log(ax.yaxis)
    axes[0, 0].set_ylabel("time of a step  [µs]")
    style.label_ends(axes[0, -1], size=8)
    axes[0, -1].annotate("thesis: F frames/s\nrunning, P paused,\na step takes\n(1 - F/P)/60 s",
                         (1.035, 0.02), xycoords="axes fraction", color=PALE, fontsize=7.5,
                         annotation_clip=False)
    style.save(figure, out / "loop_table")


def main():
    given = style.arguments("Draws the loop's variants.",
                            csv="the table that ./wb bench --loop writes",
                            thesis="the thesis' tables 5.1 and 5.2, in frames a second",
                            out="folder of the figures")
    table = style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --loop")
    table = style.rows(table, real="float")
    frames = style.read_csv(given.thesis, ["chains", "iterations", "frames_per_second"])
    if "textbook" not in table["variant"] or "lanes" not in table["variant"]:
        style.trouble(f"{given.csv} has no textbook or no lanes: ./wb bench --loop makes it anew")
    per_joint(table, given.out)
    steps(table, frames, given.out)


if __name__ == "__main__":
    style.run(main)
