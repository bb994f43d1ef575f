"""Chapter 6's figure of one budget of iterations, cut into substeps: called by chapter_06.py."""
import numpy as np

import style
from style import COLOURS, rows


def draw_budget(solution, mine, out):
    table = mine or solution
    gap = {name: style.metres(size)
           for name, size in zip(*(rows(table, substeps=16)[column]
                                   for column in ("method", "gap_rms_m")))}
    figure, axes = style.figure(
        f"{table['iterations'][0]:g} iterations per 1/60 s in 16 parts: {gap['beta 1']} with "
        f"beta 1, {gap['split impulse']} with a cold split impulse", 2)
    figure.supxlabel("substeps that share them; solid: cold, dashed: warm", fontsize=9)
    names = list(dict.fromkeys(name.removesuffix(" warm") for name in table["method"]))
    cuts = np.unique(table["substeps"])
    for ax, column, scale in zip(axes, ("gap_rms_m", "energy_drift"), (1000, 100)):
        for name in dict.fromkeys(table["method"]):
            part, cold = rows(table, method=name), name.removesuffix(" warm")
            ax.plot(part["substeps"], scale * part[column], color=COLOURS[names.index(cold)],
                    linestyle="-" if name == cold else "--",
                    label=cold.replace(" + ", "\n+ ") if name == cold else "_")
        ax.set_xscale("log", base=2)
        ax.set_xticks(cuts, [f"{cut:g}" for cut in cuts])
    axes[0].set(ylabel="gap, RMS  [mm]", yscale="log", ylim=(0.03, 200))
    axes[1].set_yscale("symlog", linthresh=0.1)
    axes[1].set(ylabel="change of energy  [%]", ylim=(-150, 1500))
    for ax in axes:
        ax.minorticks_off()
    style.plain_log(axes[0].yaxis)
    style.label_ends(axes[1])
    style.save(figure, out / "06_budget")
