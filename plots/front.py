"""The picture of the front page: a recorded chain, and error against run time.

    front.py --motion chain.motion.json --csv work_precision.csv --out DIR

`./wb tour` and `./wb bench` make the two inputs; the result is kept as plots/front.svg.
"""
import json

import numpy as np
import style


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
    ax.set_title(f"chapter 2: a chain let go, drawn every {every * run['dt']:.2g} s")


def draw_cost(ax, path):
    """Gap against time of the scene with a thousand bodies."""
    table = style.read_csv(path, ["iterations", "warm", "us_per_step", "gap_rms_m"],
                           ["scene", "real"], "./wb bench")
    scene, real = np.array(table["scene"]), np.array(table["real"])
    chosen = (scene == "S1b") & (real == "double") & (table["warm"] == 0)
    if not chosen.any():
        style.trouble(f"{path} has no scene S1b: ./wb bench makes it anew")
    x, y = table["us_per_step"][chosen] / 1000, table["gap_rms_m"][chosen] * 1000
    ax.loglog(x, y, "o-", color=style.COLOURS[1])
    for a, b, count in zip(x, y, table["iterations"][chosen]):
        ax.annotate(f"{count:.0f} iterations" if count in (10, 200) else f"{count:.0f}", (a, b),
                    xytext=(6, 4), textcoords="offset points", fontsize=8.5)
    ax.set_xlim(right=x.max() * 1.9)
    ax.set_xlabel("milliseconds a step, 990 ball joints, one core")
    ax.set_ylabel("gap of the joints, RMS [mm]")
    ax.set_title("what a step costs and what it buys")
    style.plain_log(ax.xaxis)
    style.plain_log(ax.yaxis)


def main():
    asked = style.arguments(__doc__.split("\n")[0], motion="a recorded chain",
                            csv="work_precision.csv", out="folder of the picture")
    made, (left, right) = style.figure("Joints you derive, check, and then measure", panels=2)
    draw_chain(left, asked.motion)
    draw_cost(right, asked.csv)
    style.save(made, asked.out / "front")


style.run(main)
