"""The picture of the front page: a recorded chain, and error against run time of some methods.

    front.py --motion chain.motion.json --csv bench/measured/sweeps.csv --result FILE.svg

Chapter 2's program records the chain; the result is kept as plots/front.svg.
"""
import json

import numpy as np
import style
import sweeps

SCENE = "whip"


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
    """Error against processor time of one scene, over the length of the step."""
    table = style.rows(style.read_csv(path, sweeps.NUMBERS, sweeps.WORDS, "./wb bench --sweeps"),
                       scene=SCENE, engine="ours")
    ours = [(setting, words) for engine, setting, _, words in sweeps.CURVES if engine == "ours"]
    for (setting, words), colour in zip(ours, (*style.COLOURS, style.INK)):
        sweeps.draw_curve(ax, style.rows(table, setting=setting), marker="o", markersize=3,
                          color=colour, label=words.replace(" (", "\n("))
    ax.axhline(sweeps.REFERENCE, color=style.INK, linewidth=1, dashes=(2, 2), label="_floor")
    ax.set(xscale="log", yscale="log", ylim=(sweeps.REFERENCE / 3, 1))
    ax.annotate("the references agree to 1 nm", (ax.get_xlim()[0], sweeps.REFERENCE),
                xytext=(3, -9), fontsize=7.5, textcoords="offset points")
    ax.set_xlabel("milliseconds per simulated second, one core\ncross: came apart or gained energy")
    ax.set_ylabel("error of the tip")
    ax.set_title(f"a {SCENE} of eight rods: error against time")
    style.plain_log(ax.xaxis)
    style.metres_log(ax.yaxis)
    style.label_ends(ax)


def main():
    asked = style.arguments(__doc__.split("\n")[0], motion="a recorded chain",
                            csv="sweeps.csv", result="file of the picture")
    made, (left, right) = style.figure("Joints you derive, check, and then measure", panels=2)
    draw_chain(left, asked.motion)
    draw_cost(right, asked.csv)
    style.save(made, asked.result / "front")


style.run(main)
