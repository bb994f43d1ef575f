#!/usr/bin/env python3
"""Draws the direct solver against thirty iterations: time of a step and largest gap, by scene.

direct.py --csv out/direct.csv --out DIR
"""
import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["us_per_step", "ratio_to_si30", "gap_max_m", "held", "of"]
WORDS = ["scene", "real", "method", "status"]
ORANGE, BLUE, GREEN = COLOURS[:3]
METHODS = {"si30": ("30 iterations", INK, "o"), "velocity": ("velocities", BLUE, "s"),
           "shake": ("and positions (SHAKE)", GREEN, "D"),
           "stiff": ("SHAKE, stiffness 8", ORANGE, "^")}
LOST = 3.0  # a gap of this is as good as any larger one [m]


def main():
    given = style.arguments("Draws the direct solver against thirty iterations.",
                            csv="the table that ./wb bench --direct writes",
                            out="folder of the figures")
    table = style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --direct"),
                       real="double")
    scenes = [name for name in dict.fromkeys(table["scene"]) if "hinges" not in name]
    places = {name: len(scenes) - 1 - k for k, name in enumerate(scenes)}
    fast = [float(ratio) for ratio, method, scene in
            zip(table["ratio_to_si30"], table["method"], table["scene"])
            if method == "velocity" and scene in places and "star" not in scene]
    figure, (left, right) = style.figure(
        f"All joints at once, hubs apart: {min(fast):.2f} to {max(fast):.2f} of the time of "
        "30 iterations",
        panels=2, sharey=True)
    figure.set_figheight(0.22 * len(scenes) + 1.3)
    for method, (words, colour, marker) in METHODS.items():
        rows = style.rows(table, method=method)
        chosen = [k for k, name in enumerate(rows["scene"]) if name in places]
        heights = [places[rows["scene"][k]] for k in chosen]
        left.plot(rows["ratio_to_si30"][chosen], heights, marker, color=colour, markersize=5,
                  label=words)
        right.plot(np.clip(rows["gap_max_m"][chosen], 1e-12, LOST), heights, marker, color=colour,
                   markersize=5)
    left.axvline(1, color=PALE, linewidth=0.8)
    left.set(xscale="log", xlabel="time of a step / that of 30 iterations  [1]",
             yticks=list(places.values()), yticklabels=list(places))
    left.set_xlim(0.2, 6)
    left.set_xticks([0.25, 0.5, 1, 2, 4], ["0.25", "0.5", "1", "2", "4"])
    left.minorticks_off()
    right.set(xscale="log", xlabel=f"largest gap  [m], {LOST:g} and more at the edge")
    right.set_xlim(3e-13, 6)
    words = [method for method, _, _ in METHODS.values()]
    for ax, chosen in ((left, words[:2]), (right, words[2:])):
        for k, name in enumerate(chosen):
            _, colour, marker = next(one for one in METHODS.values() if one[0] == name)
            ax.annotate(name, (0.04 + 0.5 * k, 1.012), xycoords="axes fraction", color=colour,
                        fontsize=8.5)
            ax.plot(0.015 + 0.5 * k, 1.022, marker, color=colour, markersize=5, clip_on=False,
                    transform=ax.transAxes)
    style.save(figure, given.out / "direct")


if __name__ == "__main__":
    main()
