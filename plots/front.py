"""The picture of the front page: a recorded chain, and error against run time of some methods.

    front.py --motion chain.motion.json --csv bench/measured/methods.csv --result FILE.svg

Chapter 2's program records the chain; the result is kept as plots/front.svg.
"""
import json

import numpy as np
import style

# Of a method its words, and whether they begin or end at its point.
METHODS = {"si30": ("30 iterations", "right"), "beta1": ("30, beta = 1", "right"),
           "4x8": ("4 substeps of 8", "left"), "16x2": ("16 substeps of 2", "left"),
           "lanes": ("over-relaxed, lanes", "right"), "velocity": ("direct, plain", "right"),
           "velocity/8": ("direct, 8 substeps", "left"), "shake": ("direct, newton = 8", "left")}


def draw_chain(ax, path):
    """The chain's joints at several moments: every pose is one of the recording."""
    run = json.loads(path.read_text())
    frames = np.array(run["frames"]).reshape(len(run["frames"]), -1, 7)
    every = max(1, round(0.1 / run["dt"]))
    last = min(len(frames), round(1.5 / run["dt"]) + 1)
    colours = style.plt.cm.viridis(np.linspace(0.95, 0.1, len(range(0, last, every))))
    for frame, colour in zip(frames[0:last:every], colours):
        points = []
        for (x, y, _, w, qx, qy, qz), body in zip(frame[1:], run["bodies"][1:]):
            along = np.array([1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy + w * qz)])  # R(q) e_x
            half = along * body["size"][0] / 2
            points += [np.array([x, y]) - half, np.array([x, y]) + half]
        ax.plot(*np.array(points).T, color=colour, linewidth=2, solid_capstyle="round")
    ax.plot(0, 0, "s", color=style.PALE, markersize=7)
    ax.set_aspect("equal")
    ax.set_xlabel("metres")
    ax.set_title(f"chapter 2: a released chain, every {every * run['dt']:.2g} s")


def draw_cost(ax, path):
    """Gap against time of ten chains of 99 hinges, for some methods."""
    table = style.read_csv(path, ["us_per_step", "gap_rms_m"], ["scene", "real", "method"],
                           "./wb bench --methods")
    for name, (words, place) in METHODS.items():
        row = style.rows(table, scene="S1", real="double", method=name)
        x, y = row["us_per_step"] / 1000, row["gap_rms_m"]
        colour = style.COLOURS[1 if "direct" in words else 0]
        ax.loglog(x, y, "o", color=colour)
        ax.annotate(words, (x[0], y[0]), xytext=(6 if place == "left" else -6, 3), fontsize=8.5,
                    textcoords="offset points", ha=place, color=colour)
    ax.set_xlim(0.015, 60)
    ax.set_ylim(1e-11, 0.3)
    ax.set_xlabel("milliseconds a step, 990 hinges, one core")
    ax.set_ylabel("gap of the joints, RMS")
    ax.set_title("error against cost of a step")
    style.plain_log(ax.xaxis)
    style.metres_log(ax.yaxis)


def main():
    asked = style.arguments(__doc__.split("\n")[0], motion="a recorded chain",
                            csv="methods.csv", result="file of the picture")
    made, (left, right) = style.figure("Joints you derive, check, and then measure", panels=2)
    draw_chain(left, asked.motion)
    draw_cost(right, asked.csv)
    style.save(made, asked.result / "front")


style.run(main)
