#!/usr/bin/env python3
"""Draws the figures of chapter 6: drift, Baumgarte and its price, warm start, projection.

chapter_06.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from budget_06 import draw_budget
from style import COLOURS, INK, PALE, metres, rows, visible

FORMULA = {"color": INK, "linewidth": 1, "dashes": (4, 2)}
LOOKS = {"beta 0.2": 0, "beta 0.2 + projection": 1, "beta 1": 2, "projection": 3,
         "beta 1 + projection": 4, "beta 0.05": 5, "beta 0.2 + bent 0.2 rad": 4}


def parts(table, column):
    """(value, its rows, colour, marker) for every value of a column, in the table's order."""
    return [(value, rows(table, **{column: value}), COLOURS[look], "os^Dvp"[look])
            for n, value in enumerate(dict.fromkeys(table[column]))
            for look in [LOOKS.get(value, n % 6)]]


def over_time(ax, solution, mine, column, by, clean=np.asarray, decades=16):
    """A column over time, a line for every value of `by`: yours thick, the solution's dashed."""
    for name, part, colour, _ in parts(mine or solution, by):
        ax.plot(part["time_s"], clean(part[column]), color=colour, label=name,
                linewidth=3 if mine else 1.4, alpha=0.6 if mine else 1)
    if mine:
        for _, part, _, _ in parts(solution, by):
            ax.plot(part["time_s"], clean(part[column]), label="_", **FORMULA)
        style.hold(ax, clean(mine[column]), clean(solution[column]), decades)
    ax.set_xlabel("time  [s]")


def counts(ax, table):
    """An axis of iterations: those of the table, at even distances on a log scale."""
    ax.set(xscale="log", xlabel="iterations")
    ax.set_xticks(np.unique(table["iterations"]))
    ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    ax.set_xticks([], minor=True)


def finish(figure, path, *named):
    """Labels the lines of the panels `named` at their ends, long names on two lines, and saves."""
    for ax in named:
        for line in ax.lines:
            line.set_label(line.get_label().replace(", ", ",\n").replace(" + ", "\n+ "))
        style.label_ends(ax)
    style.save(figure, path)


def whose(mine):
    return ": yours (thick), the solution's" if mine else ""


def draw_pendulums(solution, mine, out):
    table = mine or solution
    widest = [(name, np.max(part["gap_m"])) for name, part, _, _ in parts(table, "method")]
    figure, (left, right) = style.figure(
        f"In {table['time_s'].max():g} s the joint opens by "
        + ", ".join(f"{metres(gap)} with {name}" for name, gap in widest), 2)
    left.set_yscale("log")
    over_time(left, solution, mine, "gap_m", "method", visible)
    over_time(right, solution, mine, "energy_change", "method")
    left.set(ylabel="gap of the joint  [m]", title="gap" + whose(mine))
    right.axhline(0, color=PALE, linewidth=0.8)
    right.set(ylabel="change of energy over $m\\,g\\,l/2$", title="energy, which may not change")
    right.text(0.03, 0.03, "this loop and the\nengine: bars at most\n"
               f"{metres(np.max(table['off_engine_m']))} apart", fontsize=8, color=PALE,
               transform=right.transAxes)
    finish(figure, out / "06_pendulums", left, right)


def draw_drift(solution, mine, out):
    drift, decay = mine or solution
    share = (decay["expected_m"][decay["step"] == 1] / decay["start_m"][decay["step"] == 0])[0]
    figure, (left, right) = style.figure(
        f"Uncorrected, a hinge opens by {metres(drift['gap_m'][-1])} in {drift['time_s'][-1]:g} s; "
        f"beta {1 - share:.3g} takes {100 * (1 - share):.3g} % of a gap each step", 2)
    left.plot(drift["time_s"], drift["gap_m"], color=COLOURS[0], linewidth=2.5)
    left.plot(drift["time_s"], drift["predicted_m"], **FORMULA)
    left.set(xlabel="time  [s]", ylabel="gap of the hinge  [m]",
             title=r"beta 0; dashed: every step's $\omega^2 r\,h^2/2$, added")
    for start, part, colour, marker in parts(decay, "start_m"):
        right.plot(part["step"], visible(part["gap_m"]), color=colour, marker=marker, markersize=3,
                   linewidth=0.8, label=f"from {metres(start)}")
        right.plot(part["step"], np.abs(part["expected_m"]), label="_", **FORMULA)
        if part["gap_m"][-1] > max(1e-6, 3 * np.abs(part["expected_m"][-1])):
            right.annotate("the cube keeps turning:\na new error every step",
                           (part["step"][-10], part["gap_m"][-10]), fontsize=8, color=colour,
                           xytext=(part["step"][-1], 30 * part["gap_m"][-1]), ha="right",
                           arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.8})
    right.set(xlabel="step", ylabel="gap  [m]", yscale="log",
              title=f"no gravity; dashed: {abs(share):.3g}" r"$^n$ of the start")
    finish(figure, out / "06_drift", right)


def draw_correction(solution, mine, out):
    both = mine or solution
    kept = max(table[column][table["time_s"] < 0.501][-1] / table[column][0]
               for table in both for column in ("translation_m", "rotation_rad"))
    figure, axes = style.figure("Position and rotation come right together: after half a second "
                                f"{100 * kept:.3g} % of the error is left", 2, sharey=True)
    for ax, table, name in zip(axes, both, ("slider", "hinge")):
        ax.plot(table["time_s"], table["translation_m"], color=COLOURS[1], marker="o", markersize=6,
                markerfacecolor="white", linewidth=0.8, label="translation  [m]")
        ax.plot(table["time_s"], table["rotation_rad"], color=COLOURS[0], marker="s", markersize=3,
                linewidth=0.8, label="rotation  [rad]")
        ax.set(xlabel="time, a dot a step  [s]", title=name)
        ax.legend(frameon=False, labelcolor="linecolor", fontsize=8.5)
    axes[0].set_ylabel("error  [m]  or  [rad]")
    style.save(figure, out / "06_correction")


def draw_energy_and_spin(solution, mine, out):
    energy, spin, thesis = mine or solution
    most = np.argmax(energy["measured_j"] * (np.abs(energy["beta"] - 0.15) < 1e-6))
    figure, (left, right) = style.figure(
        f"Correcting {energy['gap_m'][most]:.2f} m with beta {energy['beta'][most]:g} brings in "
        f"{energy['measured_j'][most]:.0f} J, and {energy['left_j'][most]:.0f} J stay", 2)
    for beta, part, colour, marker in parts(energy, "beta"):
        left.plot(part["gap_m"], part["measured_j"], color=colour, marker=marker, linestyle="none",
                  label=f"beta {beta:g}")
        left.plot(part["gap_m"], part["predicted_j"], label="_", **FORMULA)
        left.plot(part["gap_m"], visible(part["left_j"]), color=colour, marker=marker,
                  markerfacecolor="white", linewidth=0.8, label="_")
    left.set(xscale="log", yscale="log", xlabel="gap at the start  [m]", ylabel="energy  [J]",
             title="first step (dashed: formula); hollow: the end")
    inset = right.inset_axes((0.6, 0.09, 0.38, 0.31))
    for beta, part, colour, marker in parts(spin, "beta"):
        right.plot(part["gap_m"], visible(part["measured_rad_s"]), color=colour, marker=marker,
                   markersize=4, linestyle="none", label=f"beta {beta:g}")
        right.plot(part["gap_m"], part["predicted_rad_s"], label="_", **FORMULA)
        inset.plot(part["gap_m"], part["measured_rad_s"] / part["predicted_rad_s"], color=colour,
                   marker=marker, markersize=2.5, linewidth=0.8)
    gap, speed = np.sqrt(2) * np.abs(thesis["offset_m"][0]), np.abs(thesis["wy_rad_s"][0])
    right.plot(gap, speed, color=INK, marker="*", markersize=11, label="_")
    right.annotate(f"thesis: {speed:g} rad/s", (gap, speed), xytext=(-8, 26), ha="right",
                   textcoords="offset points", fontsize=8.5,
                   arrowprops={"arrowstyle": "-", "color": INK, "linewidth": 0.8})
    inset.plot(gap, speed / np.abs(thesis["predicted_rad_s"][0]), color=INK, marker="*")
    inset.axhline(1, **FORMULA)
    inset.set(xscale="log", ylim=(0, 1.8), yticks=(0, 0.5, 1, 1.5))
    inset.set_title("measured / formula", fontsize=7.5, pad=2)
    inset.tick_params(labelsize=7)
    right.set(xscale="log", yscale="log", xlabel="gap at the start  [m]",
              ylabel="angular velocity left  [rad/s]", title="at the end; dashed: second order")
    finish(figure, out / "06_energy_and_spin", left, right)


def draw_beta(solution, mine, out):
    (_, one, _, _), *chains = parts(mine or solution, "scene")
    ends = min(one["beta"][np.abs(one["measured"]) > 0.999], default=np.inf)
    few, best = chains[0][0], np.min(np.abs(chains[0][1]["measured"]))
    figure, (left, right) = style.figure(
        f"One joint is stable up to beta {ends:g}; a chain with {few[11:]} keeps "
        f"{best:.2f} of its error per step at best", 2, sharey=True)
    left.axvspan(0, min(ends, 2), color=COLOURS[2], alpha=0.1, linewidth=0)
    left.text(min(ends, 2) / 2, 0.94, "stable", ha="center", color=COLOURS[2], fontsize=8.5,
              transform=left.get_xaxis_transform())
    left.plot(one["beta"], np.abs(one["predicted"]), **FORMULA)
    left.plot(one["beta"], np.abs(one["measured"]), color=COLOURS[1], marker="o", linestyle="none")
    left.set(ylabel="error after a step over error before it",
             title=r"one joint; dashed: $|1-\beta|$")
    for name, part, colour, marker in chains:
        right.plot(part["beta"], np.abs(part["measured"]), color=colour, marker=marker,
                   linestyle="none", markersize=5, label=name[11:])
        right.plot(part["beta"], part["predicted"], label="_", **FORMULA)
    right.set_title("chain of ten, cold; dashed: predicted")
    for ax in (left, right):
        ax.axhline(1, color=PALE, linewidth=0.8)
        ax.set_xlabel("beta, share fed back in a step")
        ax.text(0.02, 1.015, "above: it grows", fontsize=8.5, color=PALE,
                transform=ax.get_yaxis_transform())
    finish(figure, out / "06_beta", right)


def draw_warm(solution, mine, out):
    table, warm = mine or solution
    few, many = table["iterations"].min(), table["iterations"].max()
    links, cold = warm["links"], visible(warm["cold_sag_m"])
    held = np.nan_to_num(np.abs(warm["warm_sag_m"]), nan=np.inf)
    held = np.clip(held, 1e-16, 1e4 * style.extent(cold)[1])

    def end(start, count):
        return metres(np.max(rows(table, start=start, iterations=count)["size_m"][-60:]))
    figure, (left, right) = style.figure(
        f"With {many:g} iterations a warm start takes the sag from {end('cold', many)} to "
        f"{end('warm', many)}; with {few:g} it swings by {end('warm', few)}", 2)
    left.set_yscale("log")
    over_time(left, solution[0], mine and mine[0], "size_m", "setting", decades=12)
    left.set(ylabel="last cube out of place  [m]", title="ten cubes" + whose(mine))
    right.plot(warm["kept"], cold, color=COLOURS[1], marker="o", linestyle="none",
               markerfacecolor="white", markersize=6, label="cold; cross: predicted")
    right.plot(warm["kept"], visible(warm["predicted_cold_sag_m"]), color=INK, marker="x",
               linestyle="none", markersize=3.5, markeredgewidth=0.8, label="_")
    for safe, colour, marker, words in ((1, COLOURS[2], "s", "warm, called safe"),
                                        (0, COLOURS[0], "^", "warm, called unsafe")):
        chosen = warm["safe"] == safe
        right.plot(warm["kept"][chosen], held[chosen], color=colour, marker=marker,
                   linestyle="none", markersize=5, label=words)
    right.axvline(1, color=PALE, linewidth=0.8)
    right.text(1.02, 0.03, "beyond 1\nit grows", fontsize=8.5, color=PALE,
               transform=right.get_xaxis_transform())
    right.set(yscale="log", xlabel=r"$\rho^k(1+\beta)$", ylabel="last cube out of place  [m]",
              title=f"{links.min():g} to {links.max():g} cubes (top: beyond, bottom: 0)")
    right.legend(frameon=False, labelcolor="linecolor", fontsize=8.5, loc=(0, 0.2),
                 handlelength=1, handletextpad=0.4)
    finish(figure, out / "06_warm", left)


def draw_rods(solution, mine, out):
    table = mine or solution
    peaks = [(np.max(part["peak_speed_m_s"]), name) for name, part, _, _ in parts(table, "method")]
    figure, (left, right) = style.figure(
        f"Rods too long for their place: a body reaches {max(peaks)[0]:.0f} m/s with "
        f"{max(peaks)[1]}, {min(peaks)[0]:.0f} m/s with {min(peaks)[1]}", 2)
    for name, part, colour, marker in parts(table, "method"):
        for ax, column in ((left, "peak_speed_m_s"), (right, "gap_max_m")):
            ax.plot(part["iterations"], part[column], color=colour, marker=marker, label=name)
    left.set(yscale="log", ylabel="fastest body  [m/s]", title="speed")
    right.set(ylabel="largest gap  [m]", title="gap, in the last second")
    for ax in (left, right):
        counts(ax, table)
    style.plain_log(left.yaxis)
    right.set_ylim(bottom=0)
    finish(figure, out / "06_rods", left, right)


def draw_between(solution, mine, out):
    table, rate = mine or solution
    table = style.peaks(table, "method")
    calm = [(np.max(part["speed_m_s"][part["time_s"] > part["time_s"].max() - 1]), name)
            for name, part, _, _ in parts(table, "method")]
    figure, (left, right) = style.figure(
        f"Kicked between two walls: in the last second {max(calm)[1]} still reaches "
        f"{max(calm)[0]:.1f} m/s, {min(calm)[1]} {min(calm)[0]:.2f} m/s", 2)
    over_time(left, table, None, "gap_max_m", "method", visible)
    over_time(right, table, None, "speed_m_s", "method")
    left.set(yscale="log", ylabel="largest gap  [m]", title="gap, peaks of a third of a second")
    right.set(ylabel="fastest link  [m/s]", title="speed")
    inset = right.inset_axes((0.5, 0.64, 0.48, 0.28))
    inset.plot(rate["bend_rad"], rate["rho"], color=INK, marker="o", markersize=3, linewidth=0.8)
    stuck = rate["rank"] < rate["rank"].max()
    inset.plot(rate["bend_rad"][stuck], rate["rho"][stuck], color=COLOURS[0], marker="o",
               linestyle="none", markersize=4.5)
    for bend, rho, rank in zip(*(rate[name][stuck] for name in ("bend_rad", "rho", "rank"))):
        inset.annotate(f"rank\n{rank:g} of {rate['rank'].max():g}", (bend, rho), fontsize=7,
                       xytext=(-2, -28), textcoords="offset points", color=COLOURS[0])
    inset.set_title("share left per iteration", fontsize=7.5, pad=3)
    inset.set_xlabel("bend of the links  [rad]", fontsize=7.5, labelpad=1)
    inset.tick_params(labelsize=7)
    finish(figure, out / "06_between", left, right)


def draw_side_by_side(solution, mine, out):
    table = mine or solution
    gap = {name: size for name, count, size in zip(table["method"], table["iterations"],
                                                   table["gap_rms_m"]) if count in (30, 32)}
    worst = max(gap, key=gap.get)
    figure, (left, right) = style.figure(
        f"30 iterations leave {metres(gap[worst])} with {worst}, {metres(gap['beta 0.2'])} with "
        f"beta 0.2, {metres(gap['beta 1'])} with beta 1", 2)
    figure.supxlabel("iterations per step", fontsize=9)
    for name, part, _, _ in parts(table, "method"):
        alone, _, beside = name.partition(" + ")
        for ax, column, scale in ((left, "gap_rms_m", 1000), (right, "energy_drift", -100)):
            ax.plot(part["iterations"], visible(scale * part[column]), label=name,
                    color=COLOURS[LOOKS.get(alone, 1)],
                    linestyle="--" if beside == "projection" else ":" if beside else "-")
    left.set(ylabel="gap, RMS  [mm]")
    right.set(ylabel="energy lost  [%]")
    for ax in (left, right):
        ax.set(xscale="log", yscale="log")
        ax.set_xticks((5, 10, 30, 100), ("5", "10", "30", "100"))
        style.plain_log(ax.yaxis)
        ax.minorticks_off()
    finish(figure, out / "06_side_by_side", right)


def draw_rope(solution, mine, out):
    ends = [f"{name} gives it {np.max(part['speed_m_s']):.2g} m/s"
            for name, part, _, _ in parts(mine or solution, "method")]
    figure, (left, right) = style.figure("A ball too far out on its rope: " + ", ".join(ends), 2)
    over_time(left, solution, mine, "length_m", "method")
    over_time(right, solution, mine, "speed_m_s", "method")
    left.set(ylabel="distance  [m]", title="from hook to ball" + whose(mine))
    right.set(ylabel="speed of the ball  [m/s]", title="speed")
    finish(figure, out / "06_rope", left, right)


def tables(folder, command):
    def read(name, numbers, *words):
        return style.read_csv(folder / f"{name}.csv", numbers.split(), words, command)
    hanging = read("hanging", "iterations time_s sag_m", "start")
    hanging["setting"] = [f"{start}, {count:g} iterations"
                          for start, count in zip(hanging["start"], hanging["iterations"])]
    hanging["size_m"] = visible(np.abs(hanging["sag_m"]))
    return (read("pendulums", "time_s gap_m energy_change off_engine_m", "method"),
            (read("drift", "time_s gap_m predicted_m"),
             read("decay", "start_m step gap_m expected_m")),
            (read("slider", "time_s translation_m rotation_rad"),
             read("hinge", "time_s translation_m rotation_rad")),
            (read("energy", "beta gap_m predicted_j measured_j left_j"),
             read("spin", "beta gap_m predicted_rad_s measured_rad_s"),
             read("thesis_spin", "offset_m wy_rad_s predicted_rad_s")),
            read("beta", "beta predicted measured", "scene"),
            (hanging, read("warm", "links kept safe warm_sag_m cold_sag_m predicted_cold_sag_m")),
            read("rods", "iterations peak_speed_m_s gap_max_m", "method"),
            (read("between", "time_s gap_max_m speed_m_s", "method"),
             read("between_rate", "bend_rad rho rank")),
            read("side_by_side", "iterations gap_rms_m energy_drift", "method"),
            read("budget", "substeps iterations gap_rms_m gap_max_m energy_drift", "method"),
            read("rope", "time_s length_m speed_m_s", "method"))


if __name__ == "__main__":
    style.run(lambda: style.chapter(6, tables, (
        draw_pendulums, draw_drift, draw_correction, draw_energy_and_spin, draw_beta, draw_warm,
        draw_rods, draw_between, draw_side_by_side, draw_budget, draw_rope),
        result=draw_side_by_side))
