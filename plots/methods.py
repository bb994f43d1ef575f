#!/usr/bin/env python3
"""Draws a map of every method on every scene: its colour the largest gap, its words gap and time.

methods.py --csv out/methods.csv --out DIR
"""
import numpy as np

import style
from style import EMPTY, INK

NUMBERS = ["us_per_step", "gap_max_m", "held", "of"]
WORDS = ["scene", "real", "method", "status"]
ORDER = ["si30", "beta1", "4x8", "16x2", "warm", "projection", "split", "relax",
         "omega", "velocity", "shake",
         "stiff", "rk4"]
TITLES = {"si30": "30\niterations", "beta1": "beta 1", "4x8": "4 substeps\nof 8",
          "16x2": "16 substeps\nof 2", "warm": "warm and\nprojection", "projection": "projection",
          "split": "split\nimpulse", "relax": "soft and\nrelax",
          "omega": "over-relaxed\n1.9", "velocity": "direct", "shake": "direct,\npositions",
          "stiff": "direct,\nstiffness", "rk4": "Runge-\nKutta"}
LEAST, MOST = 1e-3, 1e3  # of the colours [mm]


def short(value):
    """Three digits at most."""
    return f"{value:.0f}" if value >= 99.5 else f"{value:.2g}"


def main():
    given = style.arguments("Draws a map of every method on every scene.",
                            csv="the table that ./wb bench --methods writes",
                            out="folder of the figures")
    table = style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --methods"),
                       real="double")
    methods = [name for name in ORDER if name in table["method"]]
    scenes = [name for name in dict.fromkeys(table["scene"])
              if np.sum(table["scene"] == name) > 3]
    figure, ax = style.figure("No iteration holds everywhere; all joints at once hold nearly "
                              "everywhere")
    figure.set_size_inches(style.WIDTH + 1.5, 0.31 * len(scenes) + 1.1)
    colours = style.plt.cm.viridis_r.copy()
    colours.set_bad(EMPTY)
    gaps = np.full((len(scenes), len(methods)), np.nan)
    for scene, method, gap, us, status in zip(*(table[name] for name in (
            "scene", "method", "gap_max_m", "us_per_step", "status"))):
        if scene not in scenes or method not in methods:
            continue
        at = scenes.index(scene), methods.index(method)
        gap = 1000 * gap
        gaps[at] = np.clip(gap, LEAST, MOST) if np.isfinite(gap) else MOST
        lost = not np.isfinite(gap) or gap > MOST or status in ("energy+", "exploded", "nan")
        words = "lost" if lost else "0" if gap < LEAST else short(gap)
        dark = gaps[at] > 3
        ax.text(at[1], at[0] - 0.17, words, ha="center", va="center", fontsize=7.5,
                color="white" if dark else INK, fontweight="bold")
        ax.text(at[1], at[0] + 0.24, f"{short(us)} us", ha="center", va="center", fontsize=6.5,
                color="white" if dark else INK)
    ax.imshow(np.log10(gaps), cmap=colours, aspect="auto", vmin=np.log10(LEAST),
              vmax=np.log10(MOST))
    ax.set_xticks(range(len(methods)), [TITLES[name] for name in methods], fontsize=7.5)
    ax.set_yticks(range(len(scenes)), scenes, fontsize=8)
    ax.xaxis.tick_top()
    ax.tick_params(length=0)
    ax.grid(False)
    for spine in ax.spines.values():
        spine.set_visible(False)
    ax.set_xlabel("above: largest gap of a joint [mm], the darker the wider; lost: above 1 m, or "
                  "energy gained\nbelow: time of a step; of random families the worst of all",
                  fontsize=8)
    style.save(figure, given.out / "methods")


if __name__ == "__main__":
    style.run(main)
