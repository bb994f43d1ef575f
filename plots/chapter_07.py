#!/usr/bin/env python3
"""Draws the figures of chapter 7: the steps of the loop, order, over-relaxation, colours, and how
many iterations an error takes.

chapter_07.py --solution DIR [--mine DIR] --out DIR | --result FILE
"""
import numpy as np

import style
from style import COLOURS, INK, MINE, PALE, rows, visible

ORDERS = {"chain": (COLOURS[1], "o"), "from the end": (COLOURS[2], "s"),
          "colours": (COLOURS[0], "^"), "random": (COLOURS[3], "x")}
LINES = {"from the end": ":", "random": "none"}  # ten draws at each number of iterations


def look(order):
    return ORDERS.get(order, (COLOURS[3], "D"))


def parts(table, column):
    """(value, its rows) for every value of a column, in the table's order."""
    return [(value, rows(table, **{column: value})) for value in dict.fromkeys(table[column])]


def length(size):
    """A length in words, with its unit."""
    return f"{size:.3g} m" if size >= 1 else f"{1000 * size:.3g} mm"


# ---- the steps of the loop ---------------------------------------------------------------------

def draw_steps(solution, mine, out):
    table = mine or solution
    table = rows(table, iterations=table["iterations"].max())
    names, ns = list(table["step"]), table["ns_per_hinge_and_iteration"]
    good = np.where(np.isfinite(ns) & (ns > 0), ns, np.nan)
    first, least = good[0], int(np.argmin(np.nan_to_num(good, nan=np.inf)))
    figure, ax = style.figure(
        f"Per hinge and iteration: {first:.3g} ns {names[0]}, "
        f"{good[least]:.3g} ns with {names[least]}" + (": yours" if mine else ""))
    places = np.arange(len(names))[::-1]
    ax.barh(places, good, height=0.62, color=[COLOURS[1 if count == 1 else 2]
                                              for count in table["lanes"]])
    right = np.nanmax(np.append(good, 1.0))
    for k, place in enumerate(places):
        words = f"{good[k]:.3g} ns"
        if k > 0 and np.isfinite(good[k] * good[k - 1]):
            gain = good[k - 1] / good[k]
            words += (f"    {gain:.3g} times as fast as the one above" if gain >= 1
                      else f"    {1 / gain:.3g} times as slow as the one above")
        inside = good[k] > 0.6 * right
        ax.text(good[k] + (-0.012 if inside else 0.012) * right, place, words, va="center",
                ha="right" if inside else "left", color="white" if inside else INK, fontsize=8.5)
    if mine:
        given = rows(solution, iterations=solution["iterations"].max())
        ax.plot(given["ns_per_hinge_and_iteration"], places[:len(given["step"])], linestyle="none",
                marker="|", markersize=22, markeredgewidth=1.4, color=MINE)
    ax.set_yticks(places, [
        f"{name}\n{count:g} {'lane' if count == 1 else 'lanes'}, gap {length(gap)}"
        for name, count, gap in zip(names, table["lanes"], table["gap_rms_m"])])
    ax.tick_params(axis="y", length=0)
    ax.grid(axis="y", visible=False)
    far = np.max(np.nan_to_num(table["off_m"], nan=np.inf))
    ax.set(xlabel="time per hinge and iteration, a linear axis  [ns]", xlim=(0, 1.03 * right),
           title=("|: the solution's" if mine
                  else f"gap: RMS, with {table['iterations'][0]:g} iterations")
           + f"; off one lane in the same order by {length(far)}")
    style.save(figure, out / "07_steps")


# ---- the order of the joints -------------------------------------------------------------------

def draw_order(table, _, out):
    chain = rows(table, order="chain")
    colours = rows(table, order="colours")
    low, high = style.extent(colours["gap_rms_m"] / chain["gap_rms_m"])
    figure, (left, right) = style.figure(
        f"By colours the gap is {low:.2f} to {high:.2f} times "
        "that of chain order", 2)
    for ax, column, words in ((left, "gap_rms_m", "gap, RMS"), (right, "gap_max_m", "largest gap")):
        for order, part in parts(table, "order"):
            colour, marker = look(order)
            ax.plot(part["iterations"], 1000 * visible(part[column]), color=colour, marker=marker,
                    markersize=5, label=order, linestyle=LINES.get(order, "-"))
        ax.set(xscale="log", yscale="log", xlabel="iterations per step", ylabel=f"{words}  [mm]",
               title=words)
        ax.set_xticks(np.unique(table["iterations"]))
        ax.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
        ax.set_xticks([], minor=True)
        style.plain_log(ax.yaxis)
    k = len(chain["iterations"]) // 2
    for ax, column in ((left, "gap_rms_m"), (right, "gap_max_m")):
        count, low, high = chain["iterations"][k], chain[column][k], colours[column][k]
        ax.annotate("", (count, 1000 * high), (count, 1000 * low),
                    arrowprops={"arrowstyle": "<->", "color": INK, "linewidth": 0.9,
                                "shrinkA": 3, "shrinkB": 3})
        ax.annotate(f"{high / low:.2f} times", (count, 1000 * high), xytext=(4, 6),
                    textcoords="offset points", fontsize=8.5)
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "07_order")


# ---- over-relaxation ---------------------------------------------------------------------------

def holds(table):
    """Where the run has not diverged."""
    return ~np.isin(table["status"], ("exploded", "nan", "energy+"))


def draw_relaxation(table, _, out):
    table["held"], most = holds(table), table["iterations"].max()
    chain = rows(table, order="chain", iterations=most)
    burst = min(chain["omega"][~chain["held"]], default=np.inf)
    gaps = np.where(chain["held"], chain["gap_rms_m"], np.inf)
    best, plain = int(np.argmin(gaps)), gaps[np.argmin(np.abs(chain["omega"] - 1))]
    figure, ax = style.figure(
        f"Chain order, {most:g} iterations: omega {chain['omega'][best]:g} gives a gap of "
        f"{length(gaps[best])} in place of {length(plain)}"
        + (f"; from {burst:g} on it diverges" if np.isfinite(burst) else ""))
    for order, of_order in parts(table, "order"):
        colour, marker = look(order)
        for count, part in parts(of_order, "iterations"):
            gaps = np.where(part["held"], 1000 * part["gap_rms_m"], np.nan)
            ax.plot(part["omega"], visible(gaps), color=colour, marker=marker, markersize=4.5,
                    linestyle="-" if count == most else ":", label=f"{order}, {count:g} iterations",
                    markerfacecolor=colour if count == most else "white")
    last = table["omega"].max()
    if np.isfinite(burst):
        ax.axvspan(burst, last + 0.05, color=COLOURS[0], alpha=0.13, linewidth=0)
        ax.text((burst + last + 0.05) / 2, 0.41, "explodes", rotation=90, color=COLOURS[0],
                fontsize=9, ha="center", va="center", transform=ax.get_xaxis_transform())
    ax.axvline(1, color=PALE, linewidth=0.8)
    ax.text(1.01, 0.03, "1: plain iterations", fontsize=8.5, color=PALE,
            transform=ax.get_xaxis_transform())
    ax.set(yscale="log", xlabel=r"$\omega$, factor of every impulse", ylabel="gap, RMS  [mm]",
           xlim=(table["omega"].min() - 0.03, last + 0.05),
           title="one chain of 100 cubes")
    style.plain_log(ax.yaxis)
    style.label_ends(ax)
    style.save(figure, out / "07_relaxation")


# ---- inside a step -----------------------------------------------------------------------------

def draw_inside(table, _, out):
    last = table["iteration"].max()

    def end(order, omega):
        return rows(table, order=order, omega=omega, iteration=last)["largest_e"][0]
    omegas = np.unique(table["omega"])
    figure, axes = style.figure(
        f"Chain order: the largest error after {last:g} iterations is "
        f"{end('chain', omegas[0]):.2g} m/s with omega {omegas[0]:g}, "
        f"{end('chain', omegas[-1]):.2g} with {omegas[-1]:g}",
        2, sharey=True)
    for ax, order in zip(axes, ("chain", "colours")):
        for k, (omega, part) in enumerate(parts(rows(table, order=order), "omega")):
            ax.plot(part["iteration"], visible(part["largest_e"]), color=COLOURS[(1, 2, 0)[k % 3]],
                    label=rf"$\omega$ {omega:g}")
        ax.set(yscale="log", xlabel="iterations of one step, after 1 s",
               title="chain order" if order == "chain" else "colour after colour")
        style.plain_log(ax.yaxis)
    axes[0].set_ylabel("largest |e| of any row  [m/s]")
    for ax in axes:
        style.label_ends(ax)
    style.save(figure, out / "07_inside_a_step")


# ---- colours -----------------------------------------------------------------------------------

def draw_colours(table, _, out):
    scenes = parts(table, "scene")
    figure, grid = style.figure(
        "Colours by first fit: " + ", ".join(f"the {name} {len(np.unique(part['colour']))}"
                                             for name, part in scenes), 2, width_ratios=(1.45, 1))
    halves = grid[0].get_subplotspec().subgridspec(2, 1, height_ratios=(1, 1.7))
    grid[0].remove()
    axes = [figure.add_subplot(halves[0]), figure.add_subplot(halves[1]), grid[1]]
    for ax, (name, part), size in zip(axes, scenes, (5, 2.5, 7)):
        x = np.array([part["body1_x"], part["body2_x"]])
        y = np.array([part["body1_y"], part["body2_y"]])
        seen, twice = set(), []
        for colour in np.unique(part["colour"]):
            chosen = part["colour"] == colour
            ink = COLOURS[int(colour) % len(COLOURS)]
            ax.plot(x[:, chosen], y[:, chosen], color=ink, linewidth=3, solid_capstyle="butt")
            ax.plot([], [], color=ink, linewidth=3,
                    label=f"{colour:g}: {np.count_nonzero(chosen)}")
            for place in zip(x[:, chosen].ravel(), y[:, chosen].ravel()):
                if (place, colour) in seen:
                    twice.append(place)
                seen.add((place, colour))
        ax.plot(x.ravel(), y.ravel(), linestyle="none", marker="s", color=INK, markersize=size)
        if twice:
            ax.plot(*np.array(twice).T, linestyle="none", marker="s", color=INK, markersize=size,
                    markerfacecolor="white")
            ax.set_title(f"{name}; hollow: one colour twice (static)", pad=20)
        else:
            ax.set_title(f"{name}; colour: how many joints", pad=20)
        ax.set(aspect="equal", xlabel="x  [m]", ylabel="y  [m]")
        ax.margins(0.05)
        if np.ptp(y) == 0:
            ax.set(ylim=(-1, 1), yticks=(-1, 0, 1))
        ax.legend(frameon=False, labelcolor="linecolor", fontsize=8.5, handlelength=1.2, ncol=4,
                  loc="lower left", bbox_to_anchor=(-0.02, 0.99), borderaxespad=0,
                  columnspacing=1.2, handletextpad=0.4)
    style.save(figure, out / "07_colours")


# ---- iterations to an error --------------------------------------------------------------------

def draw_needed(table, _, out):
    said = [f"{part['iterations'][0]:.0f} to {np.nanmin(part['iterations']):.0f} "
            + ("in chain order" if order == "chain" else "by colours")
            for order, part in parts(table, "order")]
    figure, ax = style.figure("Over-relaxation saves iterations: from " + ", from ".join(said))
    for order, part in parts(table, "order"):
        colour, marker = look(order)
        ax.plot(part["omega"], visible(part["iterations"]), color=colour, marker=marker,
                markersize=6, label="chain order" if order == "chain" else "by colours")
        for k in (0, np.nanargmin(part["iterations"])):
            ax.annotate(f"{part['iterations'][k]:g}", (part["omega"][k], part["iterations"][k]),
                        xytext=(0, 8), textcoords="offset points", ha="center", fontsize=10,
                        color=colour)
    ax.set(xlabel=r"$\omega_{\mathrm{SOR}}$, factor of every impulse", ylim=(0, 180),
           xlim=(0.95, 2), ylabel=f"iterations to an RMS gap of {length(table['gap_rms_m'][0])}",
           title="one chain of 100 cubes")
    style.label_ends(ax)
    style.save(figure, out / "07_needed")


def tables(folder, command):
    read = style.reader(folder, command)
    return (read("steps", "lanes iterations ns_per_hinge_and_iteration gap_rms_m off_m", "step"),
            read("order", "iterations gap_rms_m gap_max_m", "order"),
            read("relaxation", "omega iterations gap_rms_m energy_change", "order", "status"),
            read("inside_a_step", "omega iteration largest_e", "order"),
            read("colours", "body1_x body1_y body2_x body2_y colour", "scene"),
            read("needed", "omega gap_rms_m iterations", "order"))


if __name__ == "__main__":
    style.run(lambda: style.chapter(7, tables, (
        draw_steps, draw_order, draw_relaxation, draw_inside, draw_colours, draw_needed),
        result=draw_needed))
