#!/usr/bin/env python3
"""Draws our settings and those of the published engines, error against time, one figure a scene.

peers.py --csv out/peers.csv [--stored bench/peers.csv] --out DIR
"""
import re

import numpy as np

import style
from style import COLOURS, PALE
from sweeps import front

NUMBERS = ["us_per_step", "gap_max_m", "tip_error_m", "expected", "found"]
WORDS = ["engine", "real", "scene", "setting", "status", "finding"]
STORED_NUMBERS = ["us_per_step", "gap_max_m", "tip_error_m"]
STORED_WORDS = ["engine", "setting", "scene"]
LOOKS = {"ours": (COLOURS[0], "o"), "Bullet": (COLOURS[1], "s"), "ODE": (COLOURS[2], "D"),
         "MuJoCo": (COLOURS[3], "^"), "Simbody": (COLOURS[5], "v")}
SHORT = {"velocity": "direct", "shake": "direct, positions", "inertia": "direct, added inertia",
         "si30": "30 iterations", "beta1": "beta 1", "4x8": "4 x 8", "omega": "over-relaxed",
         "16x2": "16 x 2", "split": "split impulse", "lanes": "lanes", "lanes10": "lanes",
         "rows10": "10 iterations", "tree": "reduced", "tree-rk4": "reduced, Runge-Kutta",
         "tree-rk4/4": "reduced, Runge-Kutta, 4 substeps",
         "chapter7": "chapter 7's loop", "rk4": "Runge-Kutta", "plain": "direct, no leapfrog",
         "placed": "positions, no leapfrog"}
LOST = ("nan", "refused", "exploded", "energy+")
LEAST = 1e-4  # [mm]: what is better stands at the lower edge


def errors(table, scene):
    """The error to compare in a scene: that of its tip if it has one, else its largest gap [mm]."""
    if np.isfinite(table["tip_error_m"]).any():
        return 1000 * table["tip_error_m"], "error of the tip after 1 s  [mm]"
    return 1000 * table["gap_max_m"], "largest gap of a joint  [mm]"


def draw(table, stored, scene, out):
    gaps, words = 1000 * table["gap_max_m"], "largest gap of a joint  [mm]"
    for name, values, words in (("gap", gaps, words), ("tip", *errors(table, scene))):
        if name == "tip" and not np.isfinite(table["tip_error_m"]).any():
            continue
        draw_one(table, values, words, stored, scene, out / f"{slug(scene)}_{name}", name)


def slug(scene):
    return re.sub(r"\W+", "_", scene).strip("_")


def draw_one(table, values, words, stored, scene, path, name):
    x = table["us_per_step"]
    lost = np.isin(table["status"], LOST) | ~np.isfinite(values)
    good = ~lost
    if not good.any():
        return
    top = 3 * max(values[good].max(), 10 * LEAST)
    y = np.where(lost, top, np.clip(values, LEAST, top))
    line = [k for k in front(np.where(good, x, np.inf), np.where(good, y, np.inf)) if good[k]]
    winners = list(dict.fromkeys(table["engine"][k] for k in line))
    figure, ax = style.figure(f"{scene}: " + (
        "ours is the fastest at every error" if winners == ["ours"]
        else f"{', '.join(winners)} on the front"))
    figure.set_size_inches(style.WIDTH + 1, style.HEIGHT + 1)
    ax.step(np.append(x[line], x.max() * 1.3), np.append(y[line], y[line[-1]]), where="post",
            color=PALE, linewidth=1.2, zorder=1, label="_front")
    for engine, (colour, marker) in LOOKS.items():
        for real, full in (("float", True), ("double", False)):
            at = (table["engine"] == engine) & (table["real"] == real)
            if at.any():
                ax.plot(x[at & good], y[at & good], marker, color=colour, markersize=6,
                        markerfacecolor=colour if full else "white", zorder=3,
                        label=f"{engine}, {real}")
            if (at & lost).any():
                ax.plot(x[at & lost], y[at & lost], "x", color=colour, markersize=5, zorder=2)
    if len(stored["scene"]):
        theirs = 1000 * stored["gap_max_m" if name == "gap" else "tip_error_m"]
        ax.plot(stored["us_per_step"], np.clip(theirs, LEAST, top), "+", color=PALE, markersize=6,
                zorder=1, label="not packaged, another machine")
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_ylim(LEAST / 2, top * 1.6)
    ax.set_xlabel("time of a step  [us]; grey line: nothing is both faster and better; cross: "
                  "lost or energy gained")
    ax.set_ylabel(words)
    name_front(ax, table, line, x, y)
    ax.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False, fontsize=8)
    style.save(figure, path)


def called(engine, setting):
    """The words beside a point: direct, 8 substeps."""
    if engine != "ours":
        return f"{engine}, {setting.replace(' (its default)', '')}"
    word, _, substeps = setting.partition("/")
    return SHORT[word] + (f", {substeps} substeps" if substeps else "")


def name_front(ax, table, line, x, y, gain=1.5):
    """Names the points of the front, except those that are hardly better than the last. The words
    stand below a point, or above it at the lower edge, on white."""
    last = np.inf
    for k in line:
        if y[k] > last / gain:
            continue
        last, middle = y[k], np.sqrt(x[line].min() * x.max())
        left = x[k] > middle
        ax.annotate(called(table["engine"][k], table["setting"][k]), (x[k], y[k]), zorder=5,
                    xytext=(6 if left else -2, 7 if y[k] < 10 * LEAST else -9),
                    ha="right" if left else "left", va="center",
                    fontsize=7, textcoords="offset points", color=LOOKS[table["engine"][k]][0],
                    bbox={"facecolor": "white", "edgecolor": "none", "pad": 0.4, "alpha": 0.85})


def main():
    given = style.arguments("Draws ours beside the published engines.",
                            csv="the table that ./wb bench --peers writes",
                            stored="optional: figures of engines that are not packaged",
                            out="optional: folder of the figures, one a scene")
    table = style.rows(style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --peers"))
    if not given.out:
        return
    stored = style.rows(style.read_csv(given.stored, STORED_NUMBERS, STORED_WORDS, "")) \
        if given.stored else None
    given.out.mkdir(parents=True, exist_ok=True)
    for scene in dict.fromkeys(table["scene"]):
        if scene.endswith(" hinges"):
            continue
        elsewhere = {name: np.array([]) for name in (*STORED_NUMBERS, *STORED_WORDS)}
        if stored:
            packaged = np.array([name.split()[0] in LOOKS for name in stored["engine"]])
            at = (np.asarray(stored["scene"]) == scene) & ~packaged
            elsewhere = {name: column[at] for name, column in stored.items()}
        draw(style.rows(table, scene=scene), elsewhere, scene, given.out)


if __name__ == "__main__":
    style.run(main)
