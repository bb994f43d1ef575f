"""The picture of the front page: a recorded chain, and error against run time of some methods.

    front.py --motion chain.motion.json --csv bench/measured/sweeps.csv --result FILE.svg

Chapter 2's program records the chain; the result is kept as plots/front.svg.
"""
import json

import numpy as np
import style
import sweeps

SCENE = "whip"


CURVES = (("beta1:30", "30 iterations"), ("inertia", "direct (default)"), ("tree", "reduced"),
          ("tree-rk4", "reduced,\nRunge-Kutta"))


def draw_chain(ax, path):
    """The chain's joints at several moments: every pose is one of the recording."""
    run = json.loads(path.read_text())
    frames = np.array(run["frames"]).reshape(len(run["frames"]), -1, 7)
    every = max(1, round(0.1 / run["dt"]))
    last = min(len(frames), round(1.5 / run["dt"]) + 1)
    colours = style.plt.cm.Greys(np.linspace(0.3, 0.9, len(range(0, last, every))))
    for frame, colour in zip(frames[0:last:every], colours):
        points = []
        for (x, y, _, w, qx, qy, qz), body in zip(frame[1:], run["bodies"][1:]):
            along = np.array([1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy + w * qz)])  # R(q) e_x
            half = along * body["size"][0] / 2
            points += [np.array([x, y]) - half, np.array([x, y]) + half]
        ax.plot(*np.array(points).T, color=colour, linewidth=2, solid_capstyle="round")
        at = round(run["dt"] * every * len(ax.lines[1:]), 1)
        if at in (0, 0.5, 1, 1.5):
            ax.annotate(f"{at:g} s", points[-1], xytext=(4, -3), textcoords="offset points",
                        fontsize=8.5)
    ax.plot(0, 0, "s", color=style.PALE, markersize=7)
    ax.set_aspect("equal")
    ax.set(xlabel="metres", ylabel="metres", title="your joints move: twelve rods, released")


def draw_cost(ax, path):
    """Error against processor time of one scene, over the length of the step."""
    table = style.rows(style.read_csv(path, sweeps.NUMBERS, sweeps.WORDS, "./wb bench --sweeps"),
                       scene=SCENE, engine="ours")
    for (setting, words), colour in zip(CURVES, style.COLOURS):
        x, y, good = sweeps.points(style.rows(table, setting=setting))
        ax.plot(x, np.where(good, y, np.nan), "o-", color=colour, markersize=3, label=words)
        ax.plot(x[~good], y[~good], "x", color=colour, markersize=4, label="_lost")
    ax.set(xscale="log", yscale="log", ylim=(sweeps.REFERENCE / 2, 1),
           xlabel="milliseconds per simulated second, one core\ncross: came apart or gained energy",
           ylabel="error of the tip",
           title=f"and you see what it costs: a {SCENE} of eight rods")
    ax.annotate("better", (0.06, 0.06), (0.2, 0.2), xycoords="axes fraction", fontsize=8.5,
                arrowprops={"arrowstyle": "->", "color": style.INK})
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    ax.minorticks_off()
    style.metres_log(ax.yaxis)
    style.label_ends(ax)


def main():
    asked = style.arguments(__doc__.split("\n")[0], motion="a recorded chain",
                            csv="sweeps.csv", result="file of the picture")
    made, (left, right) = style.figure(
        "Derive a joint, check it against numbers, measure error against run time", panels=2)
    draw_chain(left, asked.motion)
    draw_cost(right, asked.csv)
    style.save(made, asked.result / "front")


style.run(main)
