#!/usr/bin/env python3
"""Draws what a joint costs as a scene grows: time and memory over the number of joints.

scaling.py --csv out/scaling.csv --out DIR
"""
import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["joints", "us_per_step", "ns_per_joint_step", "bytes_per_joint", "iterations"]
WORDS = ["solver", "setting"]
LINES = {  # solver, setting: words, colour
    ("textbook", "one at a time"): ("textbook", INK),
    ("engine rows", "one at a time"): ("engine rows", COLOURS[1]),
    ("packed", "one at a time"): ("packed,\none at a time", COLOURS[2]),
    ("lanes", "islands"): ("lanes,\nan island each", COLOURS[0]),
    ("lanes", "colours"): ("lanes,\ncoloured", COLOURS[3])}
SMALL, LARGE = 1e3, 1e5  # between these the growth is told


def lines_of(table, iterations):
    """Of each solver its rows with so many iterations, fewest joints first."""
    kind = list(zip(table["solver"], table["setting"]))
    out = {}
    for key in LINES:
        chosen = [i for i, one in enumerate(kind)
                  if one == key and table["iterations"][i] == iterations]
        chosen.sort(key=lambda i: table["joints"][i])
        if chosen:
            out[key] = {name: table[name][chosen] for name in NUMBERS}
    return out


def growth(line):
    """The cost of a joint in the largest scene, relative to one of a thousand joints; or None."""
    near = [int(np.argmin(np.abs(np.log(line["joints"] / size)))) for size in (SMALL, LARGE)]
    sizes = line["joints"][near]
    if not 0.5 < sizes[0] / SMALL < 2 or not 0.5 < sizes[1] / LARGE < 2:
        return None
    return line["ns_per_joint_step"][near[1]] / line["ns_per_joint_step"][near[0]]


def main():
    given = style.arguments("Draws what a joint costs as a scene grows.",
                            csv="the table that ./wb bench writes", out="folder of the figures")
    table = style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench")
    counts = sorted(set(table["iterations"]))
    lines = lines_of(table, counts[-1])
    factors = {key: factor for key, line in lines.items() if (factor := growth(line))}
    title = "The cost of a joint as the scene grows"
    if factors:
        title = (f"From {SMALL:,.0f} to {LARGE:,.0f} joints a joint becomes "
                 f"{min(factors.values()):.1f} to {max(factors.values()):.1f} times as dear")
    figure, (left, right) = style.figure(title, panels=2)
    for key, line in lines.items():
        words, colour = LINES[key]
        if key in factors:
            words += f"  x {factors[key]:.1f}"
        left.plot(line["joints"], line["ns_per_joint_step"], "o-", color=colour, markersize=4,
                  label=words)
        right.plot(line["joints"], line["bytes_per_joint"], "o-", color=colour, markersize=4,
                   label=LINES[key][0])
    left.set(xscale="log", yscale="log", xlabel="joints", ylabel="time per step and joint  [ns]")
    left.set_ylim(style.extent(table["ns_per_joint_step"])[0] / 1.5,
                  style.extent(*[line["ns_per_joint_step"] for line in lines.values()])[1] * 1.3)
    left.set_title(f"{counts[-1]:g} iterations; x: dearer at {LARGE:,.0f} than at {SMALL:,.0f}",
                   color=PALE, fontsize=8.5)
    right.set(xscale="log", xlabel="joints", ylabel="memory per joint  [bytes]")
    right.set_ylim(0, 1.15 * style.extent(table["bytes_per_joint"])[1])
    right.set_title("bodies, joints, and the memory of the solver", color=PALE, fontsize=8.5)
    for ax in (left, right):
        ax.set_xlim(60, 1.6e5)
    style.plain_log(left.yaxis)
    style.label_ends(left, size=8)
    style.label_ends(right, size=8)
    style.save(figure, given.out / "scaling")


if __name__ == "__main__":
    style.run(main)
