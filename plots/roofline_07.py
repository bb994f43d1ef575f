"""Chapter 7's roofline: the loop's variants, each as a share of what the machine can do.

geometry_07.py draws it, roofline.svg.
"""
import pathlib

import style
from style import COLOURS, INK

MEASURED = pathlib.Path(__file__).absolute().parents[1] / "bench" / "measured"
OPERATIONS, BYTES = 171, 44 * 4  # of a solve: Eq. 7-6, and the numbers of a hinge in float
USED = 10 / 16  # of the lanes, one chain per lane: Eq. 7-7
LOOKS = (("whole-joint", "one lane,\na hinge at a time"),
         ("interleaved", "one lane,\nchains interleaved"),
         ("lanes coloured", "eight lanes,\nby colours"), ("lanes", "eight lanes,\na chain in each"))


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
    cache = style.rows(roofs, roof="cache")["per_ns"][0] * OPERATIONS / BYTES
    top = min(eight, cache)
    shares = [100 * rate(loop, variant) / top for variant, _ in LOOKS]
    figure, ax = style.figure(
        f"One hinge at a time: {min(shares):.0f} % of what the cache can feed; eight lanes with a "
        f"chain in each: {max(shares):.0f} %")
    for place, (share, (variant, words)) in enumerate(zip(shares, LOOKS)):
        ax.barh(-place, share, 0.62, color=COLOURS[1 if "lane" in variant else 2])
        ax.text(share - 0.8, -place, f"{share:.0f} %", va="center", ha="right", fontsize=10,
                color="white")
        if variant == "lanes":  # every lane computes, and some have no hinge
            ax.barh(-place, share / USED - share, 0.62, share, facecolor="white",
                    edgecolor=COLOURS[1], hatch="///", linewidth=1)
            ax.text(share / USED + 1, -place, f"{share / USED - share:.0f} % wasted\nin idle lanes",
                    va="center", fontsize=9, color=COLOURS[1])
    for share, words in ((100, "what the cache can feed"),
                         (100 * one / top, f"one lane's limit, {100 * one / top:.0f} %")):
        low = 0.5 - len(LOOKS) if share == 100 else -1.5
        ax.plot((share, share), (low, 0.8), color=INK, linewidth=1.4,
                linestyle="-" if share == 100 else "--")
        ax.text(share + (-1 if share == 100 else 1), 0.62, words, va="center",
                ha="right" if share == 100 else "left", fontsize=9)
    ax.set_yticks(range(0, -len(LOOKS), -1), [words for _, words in LOOKS], fontsize=10)
    ax.tick_params(axis="y", length=0)
    ax.grid(axis="y", visible=False)
    ax.set(xlim=(0, 104), ylim=(0.5 - len(LOOKS), 0.8),
           xlabel=f"operations  [% of the {top:.0f} per ns that the cache can feed]")
    style.save(figure, path / "figure")
