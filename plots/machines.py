"""The figures of chapter 8's machines, and code common to them and its other figures."""
import numpy as np

import style
from chapter_06 import FORMULA
from style import COLOURS, PALE, rows

LOOKS = {"cold": 0, "warm": 1, "turned": 1, "fixed": 0, "interleaved": 0, "joints first": 1,
         "contacts first": 2, "no ground": 3, "gravity": 2, "collision": 1, "contact last": 0}
NAMES = {"interleaved": "one loop", "joints first": "joints\nfirst",
         "contacts first": "contacts\nfirst", "gravity": "no ground",
         "collision": "hits the ground",
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


def draw_wheels(table, _, out):
    way, rolled = (table[column] - table[column][0] for column in ("place_m", "rolled_m"))
    slip = 100 * (np.abs(way) - np.abs(rolled))
    figure, (left, right) = style.figure(
        f"Wheels drive {np.max(np.abs(way)):.3g} m out and back on friction alone, at most "
        f"{np.max(np.abs(slip)):.0f} cm off pure rolling", 2)
    left.plot(table["time_s"], np.abs(way), color=COLOURS[1], linewidth=2)
    left.set(xlabel="time  [s]", ylabel="distance from the start  [m]",
             title="where they are")
    right.plot(table["time_s"], slip, color=COLOURS[0], linewidth=1.2)
    right.axhline(0, color=PALE, linewidth=0.8)
    right.set(xlabel="time  [s]", ylabel="distance − turns × rolling radius  [cm]",
              title="0 is pure rolling")
    style.save(figure, out / "08_wheels")


def draw_ragdoll(table, _, out):
    moving = np.flatnonzero(table["fastest_m_s"] > 0.01)
    rest = table["time_s"][moving[-1]] if len(moving) else 0
    figure, (left, right) = style.figure(
        f"The ragdoll falls at up to {np.max(table['fastest_m_s']):.2g} m/s; after {rest:.1f} s "
        "nothing moves faster than 1 cm/s", 2)
    shown = {name: column[table["time_s"] < rest + 1.5] for name, column in table.items()}
    over_time(left, shown, None, "fastest_m_s", color=COLOURS[1], label="_")
    for column, colour, words in (("gap_m", COLOURS[1], "widest gap\nof a joint"),
                                  ("penetration_m", COLOURS[0], "deepest\ncorner")):
        over_time(right, shown, None, column, None, lambda size: 1000 * size, color=colour,
                  label=words)
    left.set(ylabel="fastest centre  [m/s]", title="speed")
    right.set(ylabel="error  [mm]", title="joints and ground")
    style.label_ends(right)
    style.save(figure, out / "08_ragdoll")
