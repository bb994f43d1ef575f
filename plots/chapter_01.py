#!/usr/bin/env python3
"""Draws the figures of chapter 1: gaps and energy of both scenes, and the text's figure.

chapter_01.py --solution DIR [--mine DIR] --out DIR
chapter_01.py --solution DIR --result FILE.svg
"""
import numpy as np

import style
from style import COLOURS, INK, PALE, label_ends, runs, visible

COLUMNS = ["iterations", "time_s", "gap_rms_m", "gap_max_m", "energy_change_j"]
FIRST_SWING = 2.0  # [s]; later the bridge's runs have little in common
PREDICTED = (9.81 * 2) / 60**2 / 2 / 0.2  # [m], of the pendulum: (v h)^2/(2L) over beta


def common_count(mine, solution):
    """The number of iterations to compare at: 30, else the largest that both have."""
    both = set(mine) & set(solution)
    if not both:
        style.trouble("yours and the solution's tables have no number of iterations in common")
    return 30 if 30 in both else max(both)


def tables(folder, command):
    both = {scene: style.read_csv(folder / f"{scene}.csv", COLUMNS, command=command)
            for scene in ("bridge", "pendulum")}
    return both["bridge"], both, both


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
    """Gaps over time: one curve per number of iterations, or yours over the solution's."""
    curves = millimetres(solution)
    if mine:
        own = millimetres(mine)
        count = common_count(own, curves)
        figure, ax = style.figure(f"{place}, {count} iterations: "
                                  + style.verdict(own[count], curves[count], "mm"))
        ax.set_yscale("log")
        shown = [own[count], curves[count]]
        style.overlay(ax, *((t, visible(values)) for t, values in shown))
    else:
        few, best = min(curves), min(curves, key=lambda count: mean_square(curves[count]))
        title = f"{place}: gaps of {mean_square(curves[few]):.1f} mm with {few} iterations"
        title += f", of {mean_square(curves[best]):.1f} mm with {best}" * (best > few)
        figure, ax = style.figure(title + "; more do not help" * (best < max(curves)))
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
        count, count2 = common_count(own, bridge), common_count(own2, pendulum)
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


# ---- the figure of the text ----------------------------------------------------------------------

def first_swing(table):
    """{iterations: (times, largest gap [mm])} until FIRST_SWING."""
    return {count: (time[time <= FIRST_SWING], 1000 * gap[time <= FIRST_SWING])
            for count, (time, gap) in runs(table, "gap_max_m").items()}


def largest(curve):
    return f"{curve[1].max():.3g} mm"


def gaps_and_iterations(solution, mine, out):
    """One row needs one iteration; rows that share bodies need more."""
    rod, ropes = first_swing(solution["pendulum"]), first_swing(solution["bridge"])
    few, many = min(ropes), max(ropes)
    figure, (left, right) = style.figure(
        f"One rod: {largest(rod[few])} with any number of iterations.\n"
        f"Nine ropes, first {FIRST_SWING:g} s: {largest(ropes[few])} with {few} iterations, "
        f"{largest(ropes[many])} with {many}" if not mine
        else "The largest gap: yours and the solution's", 2)
    for ax, curves, scene in ((left, rod, "pendulum"), (right, ropes, "bridge")):
        if mine:
            own = first_swing(mine[scene])
            count = common_count(own, curves)
            style.overlay(ax, own[count], curves[count])
            ax.set_title(f"{scene}, {count} iterations")
        ax.set(xlabel="time  [s]", ylabel="largest gap  [mm]",
               xlim=(0, FIRST_SWING), xticks=np.linspace(0, FIRST_SWING, 5))
    if not mine:
        left.plot(*rod[few], color=COLOURS[1])
        left.axhline(1000 * PREDICTED, color=INK, linewidth=1, dashes=(4, 2))
        left.text(0.02, 1000 * PREDICTED + 0.25, f"predicted: {1000 * PREDICTED:.3g} mm",
                  fontsize=8.5)
        left.set(title="pendulum: 1 row", ylim=(0, 1200 * PREDICTED))
        left.text(0.93, 1, f"{few} to {many} iterations:\none curve", fontsize=8.5,
                  color=COLOURS[1], ha="center")
        for (count, curve), colour in zip(ropes.items(), COLOURS):
            right.plot(*curve, color=colour, label=f"{count}: {largest(curve)}")
        right.legend(title="iterations", loc="upper left", frameon=False, fontsize=8.5,
                     labelcolor="linecolor", handlelength=0.7, alignment="left")
        right.set(title="bridge: 9 rows", ylim=(0, None))
    else:
        label_ends(left)
        label_ends(right)
    style.save(figure, out / "01_gaps_and_iterations")


def bridge_gap(solution, mine, out):
    style.save(gap_figure("The bridge", "ropes", solution, mine), out / "01_gap")


if __name__ == "__main__":
    style.run(lambda: style.chapter(1, tables, (bridge_gap, energy, gaps_and_iterations),
                                    result=gaps_and_iterations))
