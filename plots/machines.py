"""The figures of chapter 8's machines, and what they share with its other figures."""
import numpy as np

import style
from chapter_06 import FORMULA, metres, whose
from style import COLOURS, INK, rows, visible

LOOKS = {"cold": 0, "warm": 1, "turned": 1, "fixed": 0, "interleaved": 1, "joints first": 0,
         "contacts first": 5, "no ground": 2, "gravity": 2, "collision": 1, "contact last": 0}
NAMES = {"gravity": "no ground", "collision": "hits the ground",
         "contact last": "hits it,\ncontact solved\nafter the joint"}


def parts(table, column):
    """(value, its rows, colour, marker) for every value of a column, in the table's order."""
    return [(value, rows(table, **{column: value}), COLOURS[look], "os^Dvp"[look])
            for n, value in enumerate(dict.fromkeys(table[column]))
            for look in [LOOKS.get(value, n % 6)]]


def over_time(ax, solution, mine, column, by=None, clean=np.asarray, decades=3, **looks):
    """A column over time, a line for every value of `by`: yours thick, the solution's dashed."""
    def groups(table):
        return parts(table, by) if by else [("_", table, looks.get("color", COLOURS[1]), "")]
    for name, part, colour, _ in groups(mine or solution):
        ax.plot(part["time_s"], clean(part[column]), linewidth=3 if mine else 1.4,
                alpha=0.6 if mine else 1, label=looks.get("label", NAMES.get(name, name)),
                color=colour)
    if mine:
        for _, part, _, _ in groups(solution):
            ax.plot(part["time_s"], clean(part[column]), label="_", **FORMULA)
        style.hold(ax, clean(mine[column]), clean(solution[column]), decades)
    ax.set_xlabel("time  [s]")


def draw_machines(solution, mine, out):
    table = mine or solution
    names = list(dict.fromkeys(table["machine"]))
    counts = np.unique(table["iterations"])
    parted = {name: rows(table, machine=name) for name in names}
    sizes = {name: np.nan_to_num(part["gap_rms_m"][np.argmax(part["iterations"])], nan=np.inf)
             for name, part in parted.items()}
    low, high = min(sizes, key=sizes.get), max(sizes, key=sizes.get)
    words = f"{metres(sizes[low])} ({low})" if low == high else \
        f"{metres(sizes[low])} ({low}) to {metres(sizes[high])} ({high})"
    figure, (left, right) = style.figure(
        f"Gaps of the machines, RMS, each with its most iterations: {words}", 2)

    def place(name, count):
        """A line for every machine, and on it one above the other each count of iterations."""
        own = sorted(parted[name]["iterations"])
        return -names.index(name) + 0.2 * ((own.index(count) if count in own else 0)
                                           - (len(own) - 1) / 2)
    for ax, columns in ((left, ("gap_rms_m", "gap_max_m")), (right, ("penetration_max_m",))):
        for n, count in enumerate(counts):
            part = rows(table, iterations=count)
            colour, marker = COLOURS[n % len(COLOURS)], "os^Dvp"[n % 6]
            y = np.array([place(name, count) for name in part["machine"]])
            if len(columns) > 1:
                ax.hlines(y, visible(part[columns[0]]), visible(part[columns[1]]), color=colour,
                          linewidth=1.2)
                ax.plot(visible(part[columns[1]]), y, color=colour, marker="|", markersize=9,
                        markeredgewidth=1.6, linestyle="none", label="_")
            ax.plot(visible(part[columns[0]]), y, color=colour, marker=marker, markersize=5,
                    linestyle="none", label=f"{count:g} iterations")
            if mine and count in solution["iterations"]:
                theirs = rows(solution, iterations=count)
                shown = np.isin(theirs["machine"], names)
                ax.plot(visible(theirs[columns[-1]][shown]),
                        [place(name, count) for name in theirs["machine"][shown]],
                        color=INK, marker="x", markersize=4, linestyle="none", label="_")
        ax.set(xscale="log", ylim=(0.6 - len(names), 0.6))
        ax.grid(axis="y", visible=False)
        ax.tick_params(axis="y", length=0)
    left.set_yticks([-n for n in range(len(names))], names)
    right.set_yticks([])
    left.set(xlabel="gap of the joints  [m]", title="gap: mark RMS, bar the largest"
             + ("; x: the solution's" if mine else ""))
    right.set(xlabel="deepest corner in the ground  [m]", title="penetration, the largest")
    left.legend(frameon=False, labelcolor="linecolor", fontsize=8.5, loc="lower left",
                bbox_to_anchor=(0, 1.06), ncol=len(counts), borderaxespad=0, handletextpad=0.1)
    style.save(figure, out / "08_machines")


def draw_wheels(solution, mine, out):
    table = mine or solution
    way, rolled = (np.abs(table[column] - table[column][0]) for column in ("place_m", "rolled_m"))
    figure, (left, right) = style.figure(
        f"Wheels drive out and back: at most {np.max(way):.3g} m away, by their turns "
        f"{np.max(rolled):.3g} m", 2)
    left.plot(table["time_s"], way, color=COLOURS[1], linewidth=3, alpha=0.6, label="way")
    left.plot(table["time_s"], rolled, color=COLOURS[0], linewidth=1.2,
              label="turns ×\nrolling\nradius")
    if mine:
        left.plot(solution["time_s"], np.abs(solution["place_m"] - solution["place_m"][0]),
                  label="_", **FORMULA)
    left.set(xlabel="time  [s]", ylabel="way  [m]",
             title="way" + ("; dashed: the solution's" if mine else ""))
    over_time(right, solution, mine, "motor_nm", color=COLOURS[0], label="_")
    right.set(ylabel="torque, mean of both motors  [N m]",
              title=f"motors; joints at most {metres(np.max(table['gap_m']))} apart")
    style.label_ends(left)
    style.save(figure, out / "08_wheels")


def draw_ragdoll(solution, mine, out):
    table = mine or solution
    late = table["time_s"] > table["time_s"][-1] - 1
    figure, (left, right) = style.figure(
        f"The ragdoll falls at {np.max(table['fastest_m_s']):.2g} m/s and comes to rest: "
        f"{np.max(table['fastest_m_s'][late]):.2g} m/s in the last second", 2)
    for ax, columns in ((left, (("fastest_m_s", "fastest centre\n[m/s]"),
                                ("fastest_rad_s", "fastest rotation\n[rad/s]"))),
                        (right, (("gap_m", "widest gap"), ("penetration_m", "deepest\ncorner")))):
        ax.set_yscale("log")
        for k, (column, words) in enumerate(columns):
            over_time(ax, solution, mine, column, None, visible, color=COLOURS[1 - k],
                      label=words)
        low, high = style.extent(*(solution[column] for column, _ in columns))
        ax.set_ylim(max(low, 1e-6 * high) / 1.5, 2 * high)
    left.set(ylabel="speed  [m/s]  or  [rad/s]", title="how fast" + whose(mine))
    right.set(ylabel="error  [m]", title="gaps and corners in the ground")
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "08_ragdoll")
