#!/usr/bin/env python3
"""Draws error against run time of all methods on a scene, with the one that is recommended.

comparison.py --csv out/compare/chain.csv --out out/compare/chain.svg
"""
import textwrap

import numpy as np

import style
from style import COLOURS, INK, PALE
from work_precision import Room, limits

NUMBERS = ["us_per_step", "spread", "gap_m", "distance_m", "wish_gap_m", "reference_s",
           "reference_m", "meets", "recommended"]
ERRORS = {  # of a column: words at the axis, the column of the dashed line and its words
    "gap_m": ("largest gap of a joint", "wish_gap_m", "the wish: {}"),
    "distance_m": ("distance of a body from the reference", "reference_m",
                   "the reference is right to {}")}
FLOOR = 1e-6  # of the wish: what is closer than this stands at the lower edge


def draw_error(ax, table, name):
    """Every method a point with its name: full if it meets the wish, ringed if recommended."""
    wish = table["wish_gap_m"][0]
    words, column, _ = ERRORS[name]
    line = max(table[column][0], FLOOR * wish)
    seen = np.isfinite(table[name]) & (table["us_per_step"] > 0) & (table["failed"] == "")
    x, y = table["us_per_step"][seen], np.maximum(table[name][seen], FLOOR * wish)
    bars = table["spread"][seen] / 2 * x
    ends = np.append(np.maximum(x - bars, 0.2 * x), x + bars)
    ax.set(xscale="log", yscale="log", xlim=limits(ends, 1.6),
           ylim=limits(np.append(y, line), 4), ylabel=words, xlabel="time of a step, one core")
    ax.axhline(line, color=INK, linewidth=1, dashes=(2, 2))
    for k, (a, b, bar) in enumerate(zip(x, y, bars)):
        meets, best = table["meets"][seen][k] == 1, table["recommended"][seen][k] == 1
        colour = COLOURS[2] if meets else PALE
        ax.hlines(b, max(a - bar, 0.2 * a), a + bar, color=colour, linewidth=1.5)
        ax.plot(a, b, "v" if b <= FLOOR * wish else "o", color=colour, markersize=6,
                markerfacecolor=colour if meets else "white")
        if best:
            ax.plot(a, b, "o", color=COLOURS[0], markersize=13, markerfacecolor="none",
                    markeredgewidth=2)
    style.plain_log(ax.xaxis, lambda us: style.metres(1e-6 * us, "s"), 100)
    style.metres_log(ax.yaxis, 3 if np.ptp(np.log10(ax.get_ylim())) > 5 else 1)
    return seen, x, y, line


def label(ax, table, name, seen, x, y, height):
    """The names of the methods and of the line, where there is room."""
    room = Room(ax)
    to_pixels = ax.transData.transform
    at = to_pixels(np.column_stack([x, y]))
    for point in at:
        room.ink(np.array([point]), 1.5, 4)
    line = to_pixels([(end, height) for end in ax.get_xlim()])
    room.ink(line, 1)
    room.place(ERRORS[name][2].format(style.metres(height)), INK,
               [line[0] + (45, 0), line[1] - (60, 0)])
    for k in np.argsort(-table["recommended"][seen]):
        meets, best = table["meets"][seen][k] == 1, table["recommended"][seen][k] == 1
        room.place(textwrap.fill(table["method"][seen][k], 16),
                   COLOURS[0] if best else COLOURS[2] if meets else INK, [at[k]])


def headline(table, name):
    best = table["recommended"] == 1
    if not best.any():
        return f"{name}: no method meets the wish"
    return (f"{name}: the fastest that meets the wish is \u201c{table['method'][best][0]}\u201d, "
            f"{style.metres(1e-6 * table['us_per_step'][best][0], 's')} a step")


def draw(table, path, name):
    known = table["reference_s"][0]
    columns = ["gap_m"] + (["distance_m"] if known > 0 else [])
    made, axes = style.figure(headline(table, name), len(columns), squeeze=False)
    made.set_size_inches(style.WIDTH, 4.6)
    drawn = [(ax, column, *draw_error(ax, table, column)) for ax, column in zip(axes[0], columns)]
    axes[0, 0].set_title("full: meets the wish; ring: recommended")
    if known > 0:
        axes[0, 1].set_title(f"in the first {known:.2g} s, which have a reference")
    style.arrange(made)
    made.set_layout_engine("none")
    for ax, *points in drawn:
        label(ax, table, *points)
    style.save(made, path / "comparison")


def main():
    given = style.arguments(__doc__.split("\n")[0], csv="the table that ./wb compare writes",
                            out="the drawing, an SVG")
    table = style.read_csv(given.csv, NUMBERS, ["method", "failed"], "./wb compare")
    draw(style.rows(table), given.out, given.csv.stem)


if __name__ == "__main__":
    style.run(main)
