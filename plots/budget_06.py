"""Chapter 6's figure of a budget of iterations, divided into substeps: called by chapter_06.py."""
import numpy as np

import style
from style import COLOURS, metres, rows

SHOWN = {"split impulse": (COLOURS[3], "split impulse,\nprojection"),
         "soft + relax": (COLOURS[5], "soft + relax"), "beta 0.2": (COLOURS[0], "beta 0.2"),
         "relax": (COLOURS[4], "beta 1 + relax"), "beta 1": (COLOURS[2], "beta 1")}


def draw_budget(table, _, out):
    """Of projection and split impulse, which are one from 4 substeps on, the second is drawn."""
    gap = {name: metres(size) for name, size in zip(*(rows(table, substeps=16)[column]
                                                      for column in ("method", "gap_rms_m")))}
    figure, axes = style.figure(
        f"{table['iterations'][0]:g} iterations per 1/60 s, divided into 16 substeps: beta 1 gives "
        f"{gap['beta 1']} if it starts cold, a split impulse {gap['split impulse warm']} if it "
        "starts warm", 2, sharey=True)
    cuts = np.unique(table["substeps"])
    for ax, end, words in zip(axes, ("", " warm"), ("cold", "warm; a cross: energy grows")):
        for name, (colour, label) in SHOWN.items():
            part = rows(table, method=name + end)
            ax.plot(part["substeps"], 1000 * part["gap_rms_m"], color=colour, label=label)
            for grows, marker in ((False, "o"), (True, "x")):
                chosen = (part["energy_drift"] > 0.01) == grows
                ax.plot(part["substeps"][chosen], 1000 * part["gap_rms_m"][chosen], marker,
                        color=colour, markersize=4 + 3 * grows, markeredgewidth=1 + grows)
        ax.set_xscale("log", base=2)
        ax.set(xlabel="number of substeps", yscale="log", ylim=(0.03, 200),
               title=words)
        ax.set_xticks(cuts, [f"{cut:g}" for cut in cuts])
        style.plain_log(ax.yaxis)
        ax.minorticks_off()
        style.label_ends(ax)
    axes[0].set_ylabel("gap of the joints, RMS  [mm]")
    style.save(figure, out / "06_budget")
