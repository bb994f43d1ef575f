#!/usr/bin/env python3
"""Draws the figures of chapter 1: the gaps of the bridge, and what both scenes do to the energy.

chapter_01.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from style import COLOURS, PALE, label_ends, runs, visible

COLUMNS = ["iterations", "time_s", "gap_rms_m", "energy_change_j"]


def tables(folder, command):
    return {scene: style.read_csv(folder / f"{scene}.csv", COLUMNS, command=command)
            for scene in ("bridge", "pendulum")}


def mean_square(curve):
    """Root of the mean of the squares over the whole run."""
    return float(np.sqrt(np.mean(curve[1] ** 2)))


def millimetres(table):
    return {count: (t, 1000 * gap) for count, (t, gap) in runs(table, "gap_rms_m").items()}


def slack_until(ax, curves):
    """Marks the time before the first rope is taut: there is no gap that a log axis could show."""
    starts = [t[gap > 0][0] for t, gap in curves if (gap > 0).any()]
    if not starts or min(starts) < 0.1:
        return
    ax.axvspan(0, min(starts), color=style.EMPTY, linewidth=0)
    ax.text(min(starts) / 2, 0.5, "the ropes are slack: no gap", rotation=90, ha="center",
            va="center", color=PALE, fontsize=8.5, transform=ax.get_xaxis_transform())


def gap_figure(place, joints, solution, mine):
    """Gaps over time: one curve a number of iterations, or yours over the solution's."""
    curves = millimetres(solution)
    if mine:
        own = millimetres(mine)
        count = style.common_count(own, curves)
        figure, ax = style.figure(f"{place}, {count} iterations: "
                                  + style.verdict(own[count], curves[count], "mm"))
        ax.set_yscale("log")
        shown = [own[count], curves[count]]
        style.overlay(ax, *((t, visible(values)) for t, values in shown))
    else:
        few, best = min(curves), min(curves, key=lambda count: mean_square(curves[count]))
        title = f"{place}: {few} iterations leave gaps of {mean_square(curves[few]):.1f} mm"
        title += f", {best} leave {mean_square(curves[best]):.1f} mm" * (best > few)
        figure, ax = style.figure(title + ", more do not help" * (best < max(curves)))
        ax.set_yscale("log")
        shown = list(curves.values())
        for (number, (t, values)), colour in zip(curves.items(), COLOURS):
            ax.plot(t, visible(values), color=colour, linewidth=1.2,
                    label=f"{number} iterations\n{mean_square((t, values)):.1f} mm RMS")
        ax.set_xlim(0, max(t.max() for t, _ in shown))
        low, high = style.extent(*(values for _, values in shown))
        ax.set_ylim(max(low, high / 1000) / 1.3, high * 1.3)
    ax.set(xlabel="time  [s]", ylabel=f"gap, RMS over the {joints}  [mm]")
    style.plain_log(ax.yaxis)
    slack_until(ax, shown)
    label_ends(ax)
    return figure


def change(curves):
    """The energy at the end of the run with most iterations, in words."""
    end = curves[max(curves)][1][-1]
    return f"{'loses' if end < 0 else 'gains'} {abs(end):.2g}"


def energy(solution, mine, out):
    bridge = {n: (t, e / 1000) for n, (t, e) in runs(solution["bridge"], "energy_change_j").items()}
    pendulum = runs(solution["pendulum"], "energy_change_j")
    if mine:
        own = {n: (t, e / 1000) for n, (t, e) in runs(mine["bridge"], "energy_change_j").items()}
        own2 = runs(mine["pendulum"], "energy_change_j")
        count, count2 = style.common_count(own, bridge), style.common_count(own2, pendulum)
        figure, (left, right) = style.figure("Energy: yours and the solution's", 2)
        for ax, name, pair, unit in ((left, "bridge", (own[count], bridge[count]), "kJ"),
                                     (right, "pendulum", (own2[count2], pendulum[count2]), "J")):
            style.overlay(ax, *pair)
            ax.set_title(f"{name}, {count} iterations:\n{style.verdict(*pair, unit)}")
    else:
        taut = bool((solution["bridge"]["gap_rms_m"] > 0).any())
        figure, (left, right) = style.figure(
            f"The bridge {change(bridge)} kJ" + ", in steps as ropes become taut" * taut
            + f"; the pendulum {change(pendulum)} J", 2)
        for (number, curve), colour in zip(bridge.items(), COLOURS):
            left.plot(*curve, color=colour, label=f"{number}")
        left.set_title("bridge, by the number of iterations")
        draw_pendulum(right, pendulum)
    for ax, unit in ((left, "kJ"), (right, "J")):
        ax.set(xlabel="time  [s]", ylabel=f"energy since the start  [{unit}]")
        label_ends(ax)
    style.save(figure, out / "01_energy")


def draw_pendulum(ax, pendulum):
    """One row is solved exactly by one iteration: one curve, if the table says so too."""
    first = pendulum[min(pendulum)]
    same = all(style.difference(curve, first) <= 1e-9 * np.abs(first[1]).max()
               for curve in pendulum.values())
    names = ", ".join(str(count) for count in pendulum)
    if same:
        ax.plot(*first, color=COLOURS[1], label="_")
        ax.set_title("pendulum")
        ax.set_ylim(top=ax.get_ylim()[1] + 0.2 * np.ptp(ax.get_ylim()))
        ax.text(0.98, 0.98, f"{names} iterations: one curve,\na single row is solved by the first",
                ha="right", va="top", fontsize=8.5, color=PALE, transform=ax.transAxes)
        return
    for (number, curve), colour in zip(pendulum.items(), COLOURS):
        ax.plot(*curve, color=colour, label=f"{number}")
    ax.set_title("pendulum, by the number of iterations")


def main():
    given = style.arguments("Draws the figures of chapter 1.",
                            solution="folder of the solution's tables",
                            mine="optional: folder of your tables", out="folder of the figures")
    solution = tables(given.solution, "./wb plot 1")
    mine = tables(given.mine, "./wb run 1") if given.mine else None
    style.save(gap_figure("The bridge", "ropes", solution["bridge"], mine and mine["bridge"]),
               given.out / "01_gap")
    energy(solution, mine, given.out)


if __name__ == "__main__":
    style.run(main)
