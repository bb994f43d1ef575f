#!/usr/bin/env python3
"""Draws the iterations that a chain needs over its length, method by method.

convergence.py --csv bench/measured/convergence.csv --out docs/convergence.svg
"""
import numpy as np

import style
from style import COLOURS, PALE

# Of every method its label, colour and marker, and how many iterations the bench tries.
LOOKS = {"gauss-seidel": ("Gauss-Seidel", COLOURS[1], "o", 1e6),
         "over-relaxed": ("over-relaxed\nby 1.9", COLOURS[2], "s", 1e6),
         "nncg": ("NNCG", COLOURS[3], "^", 5e3), "cg": ("CG", COLOURS[0], "D", 5e3)}
TITLES = {"along": "gravity along the chain", "sideways": "gravity partly along the axes"}


def draw(table, path):
    most = style.rows(table, method="cg")["iterations"].max()
    figure, axes = style.figure("Iterations until the velocities of the first step are right to a "
                                f"millionth: CG needs at most {most:g}", 2, sharey=True)
    for ax, (gravity, title) in zip(axes, TITLES.items()):
        part = style.rows(table, gravity=gravity)
        rows = style.rows(part, method="cg")
        ax.plot(rows["hinges"], rows["rows"], color=PALE, linewidth=1, linestyle=":",
                label="rows")
        for method, (words, colour, marker, tried) in LOOKS.items():
            of = style.rows(part, method=method)
            found = np.isfinite(of["iterations"])
            ax.plot(of["hinges"], np.where(found, of["iterations"], tried), color=colour,
                    linewidth=1, linestyle=(0, (3, 3)), label=words)
            ax.plot(of["hinges"][found], of["iterations"][found], color=colour, marker=marker,
                    markersize=5, label="_found")
            ax.plot(of["hinges"][~found], np.full(np.count_nonzero(~found), tried), color=colour,
                    marker="$\\uparrow$", markersize=9, linestyle="none", label="_more")
        ax.set(xscale="log", yscale="log", xlabel="hinges of the chain; arrow: more iterations",
               title=title)
        ax.set_xticks(np.unique(table["hinges"]))
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        ax.set_xticks([], minor=True)
    axes[0].set_ylabel("iterations")
    for ax in axes:
        style.label_ends(ax)
    style.save(figure, path / path.stem)


def main():
    given = style.arguments("Draws the iterations that a chain needs over its length.",
                            csv="the table that ./wb bench --convergence writes",
                            out="the drawing, an SVG")
    draw(style.read_csv(given.csv, ["hinges", "rows", "iterations"], ["gravity", "method"],
                        "./wb bench --convergence"), given.out)


if __name__ == "__main__":
    style.run(main)
