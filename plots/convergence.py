#!/usr/bin/env python3
"""Draws the iterations that a chain needs over its length, method by method.

convergence.py --csv bench/measured/convergence.csv --out docs/convergence.svg
"""
import numpy as np

import style
from style import COLOURS

# Of some methods the label, colour and marker.
LOOKS = {"gauss-seidel": ("Gauss-Seidel", COLOURS[1], "o"),
         "over-relaxed": ("over-relaxed\nby 1.9", COLOURS[2], "s"),
         "cg": ("CG", COLOURS[0], "D")}


def draw(table, path):
    along = style.rows(table, gravity="along")
    longest = along["hinges"].max()
    last = style.rows(along, hinges=longest)
    last["time"] = last["iterations"] * last["us_per_iteration"]
    seidel, cg = (style.rows(last, method=method) for method in ("gauss-seidel", "cg"))
    figure, ax = style.figure(
        f"A straight chain of {longest:.0f} hinges: {seidel['iterations'][0]:,.0f} iterations of "
        f"Gauss-Seidel, {cg['iterations'][0]:.0f} of CG; the former take "
        f"{(seidel['time'] / cg['time'])[0]:.0f} times as long")
    for method, (words, colour, marker) in LOOKS.items():
        of = style.rows(along, method=method)
        ax.plot(of["hinges"], of["iterations"], color=colour, marker=marker, markersize=6,
                label=words)
    ax.set(xscale="log", yscale="log", xlabel="hinges of the chain",
           ylabel="iterations until the velocities\nof a step are right to a millionth")
    ax.set_xticks(np.unique(table["hinges"]))
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    ax.yaxis.set_major_formatter(lambda value, _: f"{value:,g}")
    ax.set_xticks([], minor=True)
    style.label_ends(ax)
    style.save(figure, path / path.stem)


def main():
    given = style.arguments("Draws the iterations that a chain needs over its length.",
                            csv="the table that ./wb bench --convergence writes",
                            out="the drawing, an SVG")
    draw(style.read_csv(given.csv, ["hinges", "iterations", "us_per_iteration"],
                        ["gravity", "method"], "./wb bench --convergence"), given.out)


if __name__ == "__main__":
    style.run(main)
