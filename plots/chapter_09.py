#!/usr/bin/env python3
"""Draws the figures of chapter 9: all at once, order, dependent rows, time, bounds, a heavy end.

chapter_09.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from chapter_06 import metres, over_time, parts, whose
from style import COLOURS, INK, PALE, rows, visible

DIRECT = COLOURS[2]


def last(table, column, **where):
    return rows(table, **where)[column][-1]


def over(ax, table, x, y, by, words=None):
    """y over x, a line with markers for every value of `by`."""
    ax.set(xscale="log", yscale="log")
    for name, part, colour, marker in parts(table, by):
        order = np.argsort(part[x])
        ax.plot(part[x][order], visible(part[y])[order], color=colour, marker=marker, markersize=5,
                label=(words or str)(name))


# ---- all rows at once --------------------------------------------------------------------------

def draw_together(solution, mine, out):
    chain, beam = mine or solution
    few = chain["method"][0]
    figure, (left, right) = style.figure(
        f"The chain moves sideways by {metres(last(chain, 'sideways_m', method=few))} with {few}, "
        f"by {metres(last(chain, 'sideways_m', method='direct'))} with the direct solver", 2)
    over_time(left, solution[0], mine and chain, "sideways_m", "method")
    over_time(right, solution[1], mine and beam, "sag_m", "method")
    left.set(ylabel="largest sideways displacement  [m]", title="100 hinges" + whose(mine))
    right.set(ylabel="sag of the tip  [m]", title="a beam of 20 welded cubes")
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "09_together")


def draw_result(chain, _, out):
    """For the text alone: the chain that is pulled sideways."""
    if out.suffix != ".svg":
        return
    few = chain["method"][0]
    figure, ax = style.figure(
        f"Pulled sideways for 5 s: {last(chain, 'sideways_m', method=few):.0f} m with {few}, "
        f"{last(chain, 'sideways_m', method='direct'):.0f} m with the direct solver")
    for name, part, colour, _ in parts(chain, "method"):
        ax.plot(part["time_s"], np.round(part["sideways_m"], 2), color=colour, linewidth=2,
                label=name)
    ax.set(xlabel="time  [s]", ylabel="sideways displacement  [m]", yticks=(0, 20, 40),
           title="a chain on 100 hinges, pulled along their axes")
    style.label_ends(ax)
    style.save(figure, out / "09_result")


# ---- the order of elimination ------------------------------------------------------------------

def draw_order(tables, _, out):
    pattern, table = tables
    costs = {name: last(table, "multiplications", graph="net", order=name)
             for name in ("shuffled", "fewest neighbours")}
    figure, axes = style.figure(
        f"A net of 60 joints: {costs['shuffled']:,.0f} multiplications in a shuffled order, "
        f"{costs['fewest neighbours']:,.0f} by fewest neighbours", 3, width_ratios=(1, 1, 1.25))
    for ax, name in zip(axes, costs):
        part = rows(pattern, graph="net", order=name)
        size = int(part["row"].max()) + 1
        ax.plot(range(size), range(size), color=INK, marker="s", markersize=2.2, linestyle="none")
        for filled, colour in ((0, INK), (1, COLOURS[0])):
            chosen = part["filled"] == filled
            ax.plot(part["column"][chosen], part["row"][chosen], color=colour, marker="s",
                    markersize=2.2, linestyle="none")
        ax.set(aspect="equal", xlim=(-1.5, size + 0.5), ylim=(size + 0.5, -1.5),
               xlabel="block", title=f"{name}:\n{np.count_nonzero(part['filled']):.0f} filled in")
        ax.grid(False)
    axes[0].set_ylabel("block, in the order of elimination")
    axes[1].text(0.97, 0.97, "black: of the net\ncoloured: filled in", fontsize=8, ha="right",
                 va="top", transform=axes[1].transAxes, color=PALE)
    ax = axes[2]
    graphs = list(dict.fromkeys(table["graph"]))
    for n, name in enumerate(dict.fromkeys(table["order"])):
        part = rows(table, order=name)
        colour = (PALE, COLOURS[0], DIRECT)[n % 3]
        ax.plot(part["multiplications"], -np.arange(len(graphs)) - 0.2 * (n - 1), marker="os^"[n],
                color=colour, linestyle="none", markersize=6, label=name)
    ax.set(xscale="log", xlabel="multiplications", title="one factor",
           ylim=(-len(graphs) - 0.35, 0.5))
    ax.set_yticks(-np.arange(len(graphs)), [
        f"{name},\n{last(table, 'joints', graph=name):g} joints" for name in graphs])
    ax.legend(frameon=False, labelcolor="linecolor", fontsize=8, loc="lower left",
              handletextpad=0.1, borderaxespad=0, labelspacing=0.3)
    ax.set_xticks((2e4, 5e4, 1e5, 2e5), ("20,000", "", "100,000", ""))
    ax.set_xticks([], minor=True)
    style.save(figure, out / "09_order")


# ---- rows that depend on others ----------------------------------------------------------------

def draw_dependent(table, _, out):
    gaps = {name: max(rows(table, method=name)["gap_m"]) for name in dict.fromkeys(table["method"])}
    figure, (left, right) = style.figure(
        f"Bricard's linkage: gaps up to {metres(gaps['softened'])} with softened rows, "
        f"{metres(gaps['neither'])} if none is softened or dropped", 2)
    over_time(left, table, None, "energy", "method")
    left.set(ylabel="change of energy, over that of a fall by 1 m", ylim=(-1.5, 0.5),
             title="energy")
    right.set_yscale("log")
    over_time(right, style.peaks(table, "method"), None, "gap_m", "method", visible)
    right.set(ylabel="largest gap of each 1/3 s  [m]", title="gap of the six hinges")
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "09_dependent")


# ---- time --------------------------------------------------------------------------------------

def draw_time(tables, _, out):
    convergence, bars, gaps, newton = tables
    orders = {name: last(convergence, "order", step=name)
              for name in dict.fromkeys(convergence["step"])}
    figure, ((a, b), (c, d)) = style.figure(
        f"Leapfrog: order {orders['leapfrog']:.2f}, the plain step: order {orders['plain']:.2f}",
        2, 2)
    over(a, convergence, "h_s", "error_m", "step")
    a.set(xlabel="step h  [s]", ylabel="error after 1 s  [m]", title="three slabs on hinges")
    over_time(b, bars, None, "energy", "method")
    b.set(ylabel="relative change of energy  [1]", title="six four-bars turn over")
    over(c, gaps, "h_s", "gap_m", "positions",
         lambda name: name.replace(" ", "\n"))
    c.set(xlabel="step h  [s]", ylabel="largest gap  [m]",
          title="the slabs' hinges")
    for n, h in enumerate(np.unique(rows(newton, scene="three slabs")["h_s"])[::-1]):
        part = rows(newton, scene="three slabs", h_s=h)
        d.plot(part["iteration"], visible(part["error"]), color=COLOURS[n % 6],
               marker="os^D"[n % 4], markersize=5, label=f"h = 1/{1 / h:.0f} s")
    d.set(yscale="log", xlabel="iteration on the positions", ylabel="largest |C|  [m or rad]",
          title="the slabs, one step")
    for ax in (a, b, c, d):
        style.label_ends(ax)
    style.save(figure, out / "09_time")


# ---- bounds ------------------------------------------------------------------------------------

def draw_bounds(motor, _, out):
    figure, (above, below) = style.figure(
        f"At the limit a motor of {motor['motor_nm'][-1]:.3g} N m is answered with "
        f"{motor['limit_nm'][-1]:.3g} N m", rows=2, sharex=True)
    figure.set_size_inches(style.WIDTH, style.HEIGHT)
    above.plot(motor["time_s"], motor["angle_rad"], color=INK, label="angle")
    above.axhline(motor["angle_rad"].max(), color=PALE, linewidth=0.8, dashes=(4, 2))
    above.text(0, motor["angle_rad"].max() * 1.03, "limit", color=PALE, fontsize=8.5)
    above.set(ylabel="angle  [rad]", ylim=(0, 1.25 * motor["angle_rad"].max()))
    for column, words, colour in (("motor_nm", "motor", COLOURS[1]),
                                  ("limit_nm", "limit", COLOURS[0])):
        below.plot(motor["time_s"], motor[column], color=colour, label=words)
    hit = np.argmin(motor["limit_nm"])
    below.annotate(f"the bar hits it: {motor['limit_nm'][hit]:.0f} N m", fontsize=8.5,
                   xy=(motor["time_s"][hit], -38), xytext=(-8, 0), textcoords="offset points",
                   color=COLOURS[0], ha="right", va="center")
    below.set(xlabel="time  [s]", ylabel="torque  [N m]", ylim=(-45, 30))
    for ax in (above, below):
        style.label_ends(ax)
    style.save(figure, out / "09_bounds")


# ---- a heavy end -------------------------------------------------------------------------------

def draw_heavy(tables, _, out):
    table, energy = tables
    change = {factor: 100 * last(table, "energy_change_2s", factor=factor, ratio=1000.0)
              for factor in (0, 1, 8)}
    figure, (left, right) = style.figure(
        f"An end of 1,000 kg: without added inertia {-change[0]:.0f} % of the energy is lost in "
        f"2 s, with it the energy is right to {max(abs(change[1]), abs(change[8])):.1f} %", 2)
    for factor, part, colour, marker in parts(table, "factor"):
        left.plot(part["ratio"], part["energy_change_2s"], color=colour, marker=marker,
                  markersize=5, label=rf"$\kappa$ = {factor:g}")
    left.set(xscale="log", xlabel="end  [kg], after ten links of 1 kg",
             ylabel="relative change of energy in 2 s  [1]",
             title="h = 1/60 s")
    factors = list(dict.fromkeys(table["factor"]))  # of one colour in both panels
    for factor, h in dict.fromkeys(zip(energy["factor"], energy["h_s"])):
        part, few = rows(energy, factor=factor, h_s=h), h == energy["h_s"].max()
        right.plot(part["time_s"], part["energy_change"], color=COLOURS[factors.index(factor) % 6],
                   label=rf"$\kappa$ = {factor:g}" + ("" if few else f",\nh = 1/{1 / h:.0f} s"),
                   linestyle="-" if few else ":")
    right.axhline(0, color=PALE, linewidth=0.8)
    right.set(xlabel="time  [s]", ylabel="relative change of energy  [1]",
              title="the cost with an end of 100 kg")
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "09_heavy")


def tables(folder, command):
    read = style.reader(folder, command)
    bricard = read("bricard", "time_s gap_m energy", "method")
    return ((read("sideways", "time_s sideways_m gap_m", "method"),
             read("beam", "time_s sag_m", "method")),
            (read("pattern", "row column filled", "graph", "order"),
             read("order", "joints rows fill multiplications", "graph", "order")),
            bricard,
            (read("convergence", "h_s error_m order", "step"),
             read("four_bars", "time_s height_m gap_m energy", "method"),
             read("gap_over_h", "h_s gap_m", "positions"),
             read("newton", "h_s iteration error", "scene")),
            read("motor", "time_s angle_rad motor_nm limit_nm passes"),
            (read("heavy", "factor ratio gap_m energy_change_2s tip_error_1s_m"),
             read("heavy_energy", "factor h_s time_s energy_change")),
            read("sideways", "time_s sideways_m gap_m", "method"))


if __name__ == "__main__":
    style.run(lambda: style.chapter(9, tables, (
        draw_together, draw_order, draw_dependent, draw_time, draw_bounds, draw_heavy,
        draw_result), result=draw_result))
