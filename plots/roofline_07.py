"""Chapter 7's roofline: the loop's variants under what the machine can do, as it was measured.

geometry_07.py draws it, roofline.svg.
"""
import pathlib

import numpy as np
import style
from style import COLOURS, INK, PALE

MEASURED = pathlib.Path(__file__).absolute().parents[1] / "bench" / "measured"
OPERATIONS, BYTES = 171, 44 * 4  # of a solve: Eq. 7-6, and the numbers of a hinge in float
USED = 10 / 16  # of the lanes, one chain per lane: Eq. 7-7
ONE_LANE = (("whole-joint", "one hinge at a time", COLOURS[3]),
            ("interleaved", "interleaved", COLOURS[5]))
LANES = (("lanes coloured", "lanes and colours", COLOURS[2]),
         ("lanes", "one chain per lane", COLOURS[1]))


def rate(table, variant):
    """Operations per nanosecond, ten chains in float."""
    found = style.rows(table, variant=variant, chains=10, iterations=30, real="float")
    return OPERATIONS / found["ns_per_joint_iteration"][0]


def picture(path):
    """Writes it to the path. Not a drawing: it has the style of the figures."""
    loop = style.read_csv(MEASURED / "loop.csv", ("chains", "iterations", "ns_per_joint_iteration"),
                          ("variant", "real"))
    roofs = style.read_csv(MEASURED / "roofs.csv", ("lanes", "per_ns"), ("roof",))
    one, eight = (style.rows(roofs, roof="arithmetic", lanes=lanes)["per_ns"][0]
                  for lanes in (1, 8))
    cache = style.rows(roofs, roof="cache")["per_ns"][0]
    at, fast = OPERATIONS / BYTES, rate(loop, "lanes") / USED
    figure, ax = style.figure(
        f"With its empty lanes the loop does {fast:.0f} operations per ns of the "
        f"{min(eight, cache * at):.0f} for which the cache delivers the data")
    x = np.geomspace(0.1, 10, 100)
    ax.plot(x, np.minimum(cache * x, eight), color=INK)
    ax.plot(x, np.minimum(cache * x, one), color=PALE, linestyle="--")
    ax.text(0.14, cache * 0.14 * 1.25, f"cache: {cache:.0f} bytes per ns", rotation=38,
            rotation_mode="anchor", fontsize=8.5)
    ax.text(9.6, eight * 1.08, f"eight lanes: {eight:.0f} per ns", ha="right", fontsize=8.5)
    ax.text(9.6, one * 1.08, f"one lane: {one:.0f} per ns", ha="right", fontsize=8.5, color=PALE)
    for variant, words, colour in ONE_LANE + LANES:
        ax.plot(at, rate(loop, variant), "o", color=colour, markersize=7)
        down = -9 if words == "lanes and colours" else -3
        ax.annotate(f"{words}: {rate(loop, variant):.3g}", (at, rate(loop, variant)),
                    xytext=(9, down), textcoords="offset points", fontsize=8.5, color=colour)
    ax.plot([at, at], [fast, min(eight, cache * at)], color=LANES[1][2], linewidth=0.8,
            linestyle=":")
    ax.annotate(f"{min(eight, cache * at):.0f} = {at:.2f} operations per byte · {cache:.0f} bytes",
                (at, min(eight, cache * at)), xytext=(-8, 26), ha="right", fontsize=8.5,
                textcoords="offset points", color=LANES[1][2],
                arrowprops={"arrowstyle": "-", "color": LANES[1][2], "linewidth": 0.8})
    ax.plot(at, fast, "o", color=LANES[1][2], markersize=7, markerfacecolor="white")
    ax.annotate(f"the same with its empty lanes: {fast:.3g}", (at, fast), xytext=(9, -3),
                textcoords="offset points", fontsize=8.5, color=LANES[1][2])
    ax.set(xscale="log", yscale="log", xlim=(0.1, 10), ylim=(4, 200),
           xlabel="operations per byte of a hinge",
           ylabel="operations per ns", title="float, ten chains, one machine")
    style.plain_log(ax.xaxis)
    style.plain_log(ax.yaxis)
    style.save(figure, path / "figure")

