#!/usr/bin/env python3
"""Draws the figures of chapter 6: drift, Baumgarte and its price, warm start, projection.

chapter_06.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from budget_06 import draw_budget
from style import COLOURS, INK, PALE, metres, rows, visible

FORMULA = {"color": INK, "linewidth": 1, "dashes": (4, 2)}
SIDE = COLOURS[3], COLOURS[0], COLOURS[2], COLOURS[4], COLOURS[1]
LOOKS = {"beta 0.2": 0, "beta 0.2 + projection": 1, "beta 1": 2, "projection": 3,
         "beta 1 + projection": 4, "beta 0.05": 5}


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
    widest = [f"{metres(np.max(part['gap_m']))} with {name}"
              for name, part, _, _ in parts(table, "method")]
    figure, (left, right) = style.figure(
        f"A swinging bar: in {table['time_s'].max():g} s its joint opens by up to "
        + ", ".join(widest), 2)

    def swings(whole):
        return whole and style.peaks(whole, "method", 30)
    left.set_yscale("log")
    over_time(left, swings(solution), swings(mine), "gap_m", "method", visible)
    over_time(right, solution, mine, "energy_change", "method")
    left.set(ylabel="gap of the joint", title="widest gap of each half second" + whose(mine))
    style.metres_log(left.yaxis)
    right.axhline(0, color=PALE, linewidth=0.8)
    right.set(ylabel=r"change of energy  [$m\,g\,l/2$]", title="energy: 0 would be right")
    finish(figure, out / "06_pendulums", left, right)


def draw_drift(tables, _, out):
    drift, decay = tables
    share = (decay["expected_m"][decay["step"] == 1] / decay["start_m"][decay["step"] == 0])[0]
    figure, (left, right) = style.figure(
        f"Uncorrected, a hinge opens by {metres(drift['gap_m'][-1])} in {drift['time_s'][-1]:g} s; "
        f"beta {1 - share:.3g} removes {100 * (1 - share):.3g} % of a gap per step", 2)
    left.plot(drift["time_s"], drift["gap_m"], color=COLOURS[0], linewidth=2.5)
    left.plot(drift["time_s"], drift["predicted_m"], **FORMULA)
    left.set(xlabel="time  [s]", ylabel="gap of the hinge  [m]",
             title=r"beta 0; dashed: every step's $\omega^2 r\,h^2/2$, added")
    for start, part, colour, marker in parts(decay, "start_m"):
        right.plot(part["step"], visible(part["gap_m"]), color=colour, marker=marker, markersize=3,
                   linewidth=0.8, label=f"from {metres(start)}")
        right.plot(part["step"], np.abs(part["expected_m"]), label="_", **FORMULA)
        if part["gap_m"][-1] > max(1e-6, 3 * np.abs(part["expected_m"][-1])):
            right.annotate("the cube keeps rotating:\na new error every step",
                           (part["step"][-10], part["gap_m"][-10]), fontsize=8, color=colour,
                           xytext=(part["step"][-1], 30 * part["gap_m"][-1]), ha="right",
                           arrowprops={"arrowstyle": "-", "color": colour, "linewidth": 0.8})
    right.set(xlabel="step", ylabel="gap  [m]", yscale="log",
              title=f"no gravity; dashed: {abs(share):.3g}" r"$^n$ of the start")
    finish(figure, out / "06_drift", right)


def draw_correction(both, _, out):
    kept = max(table[column][table["time_s"] < 0.501][-1] / table[column][0]
               for table in both for column in ("translation_m", "rotation_rad"))
    figure, axes = style.figure("Position and rotation are corrected together: after half a second "
                                f"{100 * kept:.3g} % of the error remains", 2, sharey=True)
    for ax, table, name in zip(axes, both, ("slider", "hinge")):
        ax.plot(table["time_s"], table["translation_m"], color=COLOURS[1], marker="o", markersize=6,
                markerfacecolor="white", linewidth=0.8, label="translation  [m]")
        ax.plot(table["time_s"], table["rotation_rad"], color=COLOURS[0], marker="s", markersize=3,
                linewidth=0.8, label="rotation  [rad]")
        ax.set(xlabel="time, a dot a step  [s]", title=name)
        ax.legend(frameon=False, labelcolor="linecolor", fontsize=8.5)
    axes[0].set_ylabel("error  [m]  or  [rad]")
    style.save(figure, out / "06_correction")


def draw_energy_and_spin(tables, _, out):
    energy, spin, thesis = tables
    one = rows(energy, beta=min(energy["beta"], key=lambda beta: np.abs(beta - 0.15)))
    most = np.argmax(one["gap_m"])
    figure, (left, right) = style.figure(
        f"Correcting {one['gap_m'][most]:.2f} m with beta {one['beta'][0]:g} adds "
        f"{one['measured_j'][most]:.0f} J, of which {one['left_j'][most]:.0f} J remain", 2)
    left.plot(one["gap_m"], one["predicted_j"], label="_", **FORMULA)
    for column, colour, words in (("measured_j", COLOURS[1], "added by\nthe first step"),
                                  ("left_j", COLOURS[0], "remaining at\nthe end")):
        left.plot(one["gap_m"], visible(one[column]), color=colour, marker="o", label=words,
                  linestyle="none" if column == "measured_j" else "-")
    left.set(ylabel="energy", title=f"beta {one['beta'][0]:g}; dashed: Eq. 6-6")
    for beta, part, colour, marker in parts(spin, "beta"):
        right.plot(part["gap_m"], visible(part["measured_rad_s"]), color=colour, marker=marker,
                   markersize=4, linestyle="none", label=f"beta {beta:g}")
        right.plot(part["gap_m"], part["predicted_rad_s"], label="_", **FORMULA)
    gap, speed = np.sqrt(2) * np.abs(thesis["offset_m"][0]), np.abs(thesis["wy_rad_s"][0])
    right.plot(gap, speed, color=INK, marker="*", markersize=11, label="_")
    right.annotate(f"thesis, beta 0.15:\n{speed:.2f} rad/s", (gap, speed), xytext=(-28, 10),
                   ha="right", textcoords="offset points", fontsize=8.5,
                   arrowprops={"arrowstyle": "-", "color": INK, "linewidth": 0.8})
    right.set(ylabel="remaining angular velocity", title="at the end; dashed: Eq. 6-7")
    for ax, unit in ((left, "J"), (right, "rad/s")):
        ax.set(xscale="log", yscale="log", xlabel="gap at the start")
        style.metres_log(ax.xaxis, 1)
        style.metres_log(ax.yaxis, unit=unit)
    finish(figure, out / "06_energy_and_spin", left, right)


def draw_beta(table, _, out):
    (_, one, _, _), *chains = parts(table, "scene")
    ends = min(one["beta"][np.abs(one["measured"]) > 0.999], default=np.inf)
    few, best = chains[0][0], np.min(np.abs(chains[0][1]["measured"]))
    figure, (left, right) = style.figure(
        f"One joint is stable up to beta {ends:g}; a chain with {few[11:]} reduces "
        f"its error to {100 * best:.0f} % per step at best", 2, sharey=True)
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
        ax.set_xlabel("beta, fraction fed back per step")
        ax.text(0.02, 1.015, "above: it grows", fontsize=8.5, color=PALE,
                transform=ax.get_yaxis_transform())
    finish(figure, out / "06_beta", right)


def draw_warm(solution, mine, out):
    table, warm = mine or solution
    few, many = table["iterations"].min(), table["iterations"].max()
    least, most = 1e-9, 1e3
    held = np.clip(np.nan_to_num(np.abs(warm["warm_sag_m"]), nan=np.inf), least, most)

    def end(start, count):
        return metres(np.max(rows(table, start=start, iterations=count)["size_m"][-60:]))

    def swings(given):
        return given and style.peaks({name: given[0][name] for name in
                                      ("setting", "time_s", "size_m")}, "setting", 15)
    figure, (left, right) = style.figure(
        f"With {many:g} iterations the chain sags by {end('cold', many)} cold, by "
        f"{end('warm', many)} warm; warm with {few:g} it oscillates by {end('warm', few)}", 2)
    left.set_yscale("log")
    over_time(left, swings(solution), swings(mine), "size_m", "setting", visible, decades=12)
    left.set(ylabel="displacement of the last cube", title="ten cubes, maximum of each half second")
    for edge, colour, words, at in ((0, COLOURS[2], "predicted to settle", 0.03),
                                    (1, COLOURS[0], "to grow", 0.97)):
        right.axvspan(edge, 1 + 0.55 * edge, color=colour, alpha=0.1, linewidth=0)
        right.text(at, 0.93, words, color=colour, transform=right.transAxes,
                   ha=("left", "right")[edge], fontsize=8.5)
        chosen = warm["safe"] != edge
        right.plot(warm["kept"][chosen], held[chosen], color=colour, marker="o^"[edge],
                   markersize=5, linestyle="none", clip_on=False, zorder=3)
    right.set(yscale="log", xlim=(0, 1.55), ylim=(least, most),
              ylabel="displacement of the last cube",
              xlabel=r"factor per warm step, $\rho^k(1+\beta)$",
              title=f"warm, {warm['links'].min():g} to {warm['links'].max():g} cubes, at the end")
    style.metres_log(left.yaxis, 2)
    style.metres_log(right.yaxis)
    right.set_yticks(right.get_yticks(), ["≤ 1 nm",
                     *(words.get_text() for words in right.get_yticklabels()[1:-1]),
                     "≥ 1 km"])
    finish(figure, out / "06_warm", left)


def draw_rods(table, _, out):
    peaks = [(np.max(part["peak_speed_m_s"]), name) for name, part, _, _ in parts(table, "method")]
    figure, (left, right) = style.figure(
        f"Rods too long for their place: a body reaches {max(peaks)[0]:.0f} m/s with "
        f"{max(peaks)[1]}, {min(peaks)[0]:.0f} m/s with {min(peaks)[1]}", 2)
    for name, part, colour, marker in parts(table, "method"):
        for ax, column in ((left, "peak_speed_m_s"), (right, "gap_max_m")):
            ax.plot(part["iterations"], part[column], color=colour, marker=marker, label=name)
    left.set(yscale="log", ylabel="fastest body  [m/s]", title="speed")
    right.set(ylabel="largest gap  [m]",
              title=f"gap in the last second: {table['gap_max_m'].min():.2g} m or more")
    for ax in (left, right):
        counts(ax, table)
    style.plain_log(left.yaxis)
    right.set_ylim(bottom=0)
    finish(figure, out / "06_rods", left, right)


def draw_side_by_side(table, _, out):
    shown = {"projection": "projection\nalone", "beta 0.2": "beta 0.2", "beta 1": "beta 1",
             "beta 1 + 4 substeps": "beta 1,\n4 substeps",
             "beta 1 + 16 substeps": "beta 1,\n16 substeps"}
    gap = {name: metres(size) for name, count, size in zip(
        table["method"], table["iterations"], table["gap_rms_m"]) if count in (30, 32)}
    figure, (left, right) = style.figure(
        f"Gaps after 30 iterations: {gap['projection']} with projection alone, {gap['beta 0.2']} "
        f"with beta 0.2, {gap['beta 1']} with beta 1; in 16 substeps {gap[list(shown)[-1]]}", 2)
    for (name, words), colour in zip(shown.items(), SIDE):
        part = rows(table, method=name)
        for ax, column, scale in ((left, "gap_rms_m", 1000), (right, "energy_drift", -100)):
            ax.plot(part["iterations"], visible(scale * part[column]), label=words, color=colour,
                    marker="o", markersize=4)
            torn = part["energy_drift"] < -1  # more than the chain can lose while it hangs together
            for x, y in zip(part["iterations"][torn], scale * part[column][torn]):
                ax.plot(x, y, "x", color=INK, markersize=9, label="_")
                ax.annotate("torn", (x, y), xytext=(7, 5), textcoords="offset points", fontsize=8.5)
    left.set(ylabel="gap of the joints, RMS  [mm]", title="gap")
    right.set(ylabel="energy lost  [%]", title="energy")
    for ax in (left, right):
        ax.set(xscale="log", yscale="log", xlabel="iterations per step")
        ax.set_xticks((5, 10, 30, 100), ("5", "10", "30", "100"))
        style.plain_log(ax.yaxis)
        ax.minorticks_off()
    finish(figure, out / "06_side_by_side", left, right)


def draw_rope(table, _, out):
    ends = [f"{name} gives it {np.max(part['speed_m_s']):.2g} m/s"
            for name, part, _, _ in parts(table, "method")]
    figure, (left, right) = style.figure("A ball too far out on its rope: " + ", ".join(ends), 2)
    over_time(left, table, None, "length_m", "method")
    over_time(right, table, None, "speed_m_s", "method")
    left.set(ylabel="distance  [m]", title="from hook to ball")
    right.set(ylabel="speed of the ball  [m/s]", title="speed")
    finish(figure, out / "06_rope", left, right)


def tables(folder, command):
    read = style.reader(folder, command)
    hanging = read("hanging", "iterations time_s sag_m", "start")
    if hanging:
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
            read("side_by_side", "iterations gap_rms_m energy_drift", "method"),
            read("budget", "substeps iterations gap_rms_m gap_max_m energy_drift", "method"),
            read("rope", "time_s length_m speed_m_s", "method"))


if __name__ == "__main__":
    style.run(lambda: style.chapter(6, tables, (
        draw_pendulums, draw_drift, draw_correction, draw_energy_and_spin, draw_beta, draw_warm,
        draw_rods, draw_side_by_side, draw_budget, draw_rope),
        result=draw_side_by_side))
