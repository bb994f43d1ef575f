#!/usr/bin/env python3
"""Draws the figures of chapter 8: rest, friction, slope, bounce, order, drift and the machines.

chapter_08.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from chapter_06 import FORMULA, counts, metres, whose
from machines import NAMES, draw_machines, draw_ragdoll, draw_wheels, over_time, parts
from style import COLOURS, INK, PALE, rows, visible

# ---- one body ----------------------------------------------------------------------------------

def draw_rest(solution, mine, out):
    table = mine or solution
    few = 4 if 4 in table["iterations"] else table["iterations"].min()
    ends = [f"{metres(np.max(rows(table, start=name, iterations=few)['farthest_m']))} {name}"
            for name in dict.fromkeys(table["start"])]
    figure, (left, right) = style.figure(
        f"In a minute at rest, with {few:g} iterations per step, a box creeps {', '.join(ends)}", 2)
    for ax, column, words in ((left, "farthest_m", "farthest from where it was put  [m]"),
                              (right, "fastest_m_s", "fastest corner of the minute  [m/s]")):
        for name, part, colour, marker in parts(table, "start"):
            ax.plot(part["iterations"], visible(part[column]), color=colour, marker=marker,
                    markersize=7 if name == "cold" else 4, label=name,
                    markerfacecolor="white" if name == "cold" else colour)
        ax.set(yscale="log", ylabel=words)
        if mine:
            for _, part, _, _ in parts(solution, "start"):
                ax.plot(part["iterations"], visible(part[column]), label="_", **FORMULA)
            style.hold(ax, mine[column], solution[column], 16)
        counts(ax, table)
    left.set_title("way of a corner" + ("; dashed: the solution's" if mine else ""))
    right.set_title("speed (in the first steps)")
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "08_rest")


def draw_friction(solution, mine, out):
    slide, hand = mine or solution
    speeds = np.unique(slide["speed_m_s"])
    fast = rows(slide, speed_m_s=speeds[-1], direction_deg=45)
    share = {name: way / rows(fast, tangents="turned")["expected_m"][0]
             for name, way in zip(fast["tangents"], fast["way_m"])}
    figure, (left, right) = style.figure(
        f"At 45° a box slides {share['turned']:.2f} of $v^2/2\\mu g$ with turned tangents, "
        f"{share['fixed']:.2f} with fixed ones", 2)
    for name, part, colour, _ in parts(slide, "tangents"):
        for speed, marker in zip(speeds, "v^o"):
            one = rows(part, speed_m_s=speed)
            straight = rows(slide, tangents="turned", speed_m_s=speed)["expected_m"]
            left.plot(one["direction_deg"], one["way_m"] / straight, color=colour, marker=marker,
                      markersize=5, linestyle="none", label="_")
            left.plot(one["direction_deg"], one["stepped_m"] / straight, label="_", **FORMULA)
            if speed == speeds[-1]:
                left.plot(one["direction_deg"], one["expected_m"] / straight, color=colour,
                          linewidth=1, label=f"{name},\n$h$ → 0")
    for speed, marker in zip(speeds, "v^o"):
        left.plot([], [], color=PALE, marker=marker, linestyle="none", label=f"_{speed:g}")
    left.legend([line for line in left.lines if line.get_label() in
                 {f"_{speed:g}" for speed in speeds}], [f"{speed:g} m/s" for speed in speeds],
                frameon=False, fontsize=8.5, loc="lower left", ncol=3, handletextpad=0.1,
                columnspacing=1)
    left.set(xlabel="direction of sliding, from x  [degrees]", xticks=range(0, 91, 15),
             ylabel=r"way over $v^2/2\mu g$", ylim=(0.5, 1.05),
             title=r"dashed: steps of $h$ take $v\,h/2$ less")
    over_time(right, hand, None, "bound_ns", color=INK, label=r"$\mu$ × normal")
    over_time(right, hand, None, "friction_ns", color=COLOURS[0], label="friction")
    over_time(right, hand, None, "speed_m_s", color=COLOURS[1], label="speed [m/s]")
    if mine:
        for column in ("friction_ns", "speed_m_s"):
            right.plot(solution[1]["time_s"], solution[1][column], label="_", **FORMULA)
        style.hold(right, hand["speed_m_s"], solution[1]["speed_m_s"])
    right.lines[0].set(linewidth=1, linestyle=":")
    right.set(ylabel="impulse of a step  [N s];  speed  [m/s]",
              title="loop by hand" + (", yours; dashed: the solution's" if mine else ""))
    right.text(0.97, 0.95, "this loop and the engine:\ncorners at most\n"
               f"{metres(np.max(hand['off_engine_m']))} apart", fontsize=8, color=PALE,
               ha="right", va="top", transform=right.transAxes)
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "08_friction")


def draw_slope(solution, mine, out):
    table = mine or solution
    mus = np.unique(table["mu"])
    table["beyond"] = table["angle_deg"] - np.degrees(np.arctan(table["mu"]))
    near = np.min(np.abs(table["beyond"]))
    close = np.abs(table["beyond"]) < 1.01 * near
    held = np.max(table["way_m"][close & (table["beyond"] < 0)])
    middle = mus[len(mus) // 2]
    slid = np.min(table["way_m"][close & (table["beyond"] > 0) & (table["mu"] == middle)])
    figure, (left, right) = style.figure(
        f"{near:.1g}° below arctan µ a box stays (within {metres(held)}), "
        f"{near:.1g}° above it slides {metres(slid)} (µ {middle:g})", 2, width_ratios=(1.5, 1))
    left.axvspan(-8, 0, color=COLOURS[2], alpha=0.1, linewidth=0)
    left.text(0.25, 0.94, "holds", ha="center", color=COLOURS[2], transform=left.transAxes)
    left.text(0.75, 0.94, "slides", ha="center", color=COLOURS[0], transform=left.transAxes)
    for n, mu in enumerate(mus):
        part = rows(table, mu=mu)
        left.plot(part["beyond"], np.maximum(part["way_m"], 1e-18), color=COLOURS[n],
                  marker="os^"[n], markersize=5, linestyle="none", label=f"µ {mu:g}")
        angle = np.radians(part["angle_deg"])
        fall = 0.5 * 9.81 * (np.sin(angle) - mu * np.cos(angle)) * 100
        left.plot(part["beyond"], visible(fall), label="_", **FORMULA)
    left.set_xscale("symlog", linthresh=0.1, linscale=0.5)
    left.set(yscale="log", xlim=(-8, 8), ylim=(1e-19, 1e4), xlabel="angle − arctan µ  [degrees]",
             ylabel="way in 10 s  [m]",
             title=r"dashed: $\frac{1}{2}g\,(\sin\alpha-\mu\cos\alpha)\,t^2$")
    left.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    left.legend(frameon=False, labelcolor="linecolor", fontsize=8.5, loc="center right",
                handletextpad=0.1)
    line = np.linspace(0, 1.15 * mus[-1], 100)
    right.plot(line, np.degrees(np.arctan(line)), label="_", **FORMULA)
    for holds, marker, colour, word in ((True, "o", COLOURS[2], "holds"),
                                        (False, "^", COLOURS[0], "slides")):
        chosen = (table["way_m"] < 1e-3) == holds
        right.plot(table["mu"][chosen], table["angle_deg"][chosen], marker=marker, color=colour,
                   linestyle="none", markersize=4, markerfacecolor="white", label=word)
    right.set(xlabel="coefficient of friction µ", ylabel="angle of the slope  [degrees]",
              title=r"dashed: $\tan\alpha=\mu$", xlim=(0, line[-1]), ylim=(0, None))
    right.legend(frameon=False, labelcolor="linecolor", fontsize=8.5, loc="lower right",
                 handletextpad=0.1)
    style.save(figure, out / "08_slope")


def draw_bounce(solution, mine, out):
    table, path = mine or solution
    one = rows(table, drop_m=1.0)
    middle = len(one["restitution"]) // 2
    figure, (left, right) = style.figure(
        f"Dropped from 1 m with restitution {one['restitution'][middle]:g} a ball comes back to "
        f"{one['rebound_m'][middle]:.3g} m, {one['expected_m'][middle]:.3g} m expected", 2)
    for n, e in enumerate(np.unique(path["restitution"])):
        part = rows(path, restitution=e)
        shown = part["time_s"] <= 2.5
        left.plot(part["time_s"][shown], part["height_m"][shown], color=COLOURS[n % 6],
                  label=f"e = {e:g}", linewidth=1.3)
        if mine:
            theirs = rows(solution[1], restitution=e)
            shown = theirs["time_s"] <= 2.5
            left.plot(theirs["time_s"][shown], theirs["height_m"][shown], label="_", **FORMULA)
    left.set(xlabel="time  [s]", ylabel="gap under the ball  [m]", ylim=(-0.05, 1.1),
             title="five balls" + (": yours; dashed: the solution's" if mine else ""))
    drops = np.unique(table["drop_m"])
    line = np.linspace(0, 1, 50)
    for n, drop in enumerate(drops):
        part = rows(table, drop_m=drop)
        right.plot(line, line**2 * drop, label="_", **FORMULA)
        right.plot(part["restitution"], part["rebound_m"], color=COLOURS[n], marker="os^Dvp"[n % 6],
                   markersize=5, linestyle="none", label=f"from {drop:g} m")
    right.set(xlabel="restitution e", ylabel="height of the first rebound  [m]",
              title=r"dashed: $e^2$ times the drop")
    if mine:
        style.hold(left, path["height_m"], solution[1]["height_m"])
        style.hold(right, table["rebound_m"], solution[0]["rebound_m"])
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "08_bounce")


# ---- joints and contacts -----------------------------------------------------------------------

def draw_order(solution, mine, out):
    table, ends = mine or solution
    count = 30 if 30 in ends["iterations"] else ends["iterations"].max()

    def end(order, column):
        return rows(ends, order=order, iterations=count)[column][0]
    figure, axes = style.figure(
        f"Gaps, RMS: interleaved {metres(end('interleaved', 'gap_rms_m'))}, joints first "
        f"{metres(end('joints first', 'gap_rms_m'))}; contacts first: "
        f"{metres(end('contacts first', 'penetration_max_m'))} deep", 2, 2)
    for ax, column, words in zip(axes[0], ("gap_m", "penetration_m"),
                                 ("widest gap of a joint  [m]", "deepest corner  [m]")):
        given = solution[0] if mine else table
        over_time(ax, rows(given, iterations=count), mine and rows(table, iterations=count),
                  column, "order", visible)
        ax.set(yscale="log", ylabel=words, ylim=(1e-6, None),
               title=f"{count:g} iterations per step" + whose(mine))
    for ax, column, words in zip(axes[1], ("gap_rms_m", "penetration_max_m"),
                                 ("gaps, RMS of the whole run  [m]", "deepest of the run  [m]")):
        for name, part, colour, marker in parts(ends, "order"):
            ax.plot(part["iterations"], visible(part[column]), color=colour, marker=marker,
                    markersize=5, label=name)
        if mine:
            for _, part, _, _ in parts(solution[1], "order"):
                ax.plot(part["iterations"], visible(part[column]), label="_", **FORMULA)
        ax.set(yscale="log", ylabel=words)
        counts(ax, ends)
    axes[1][0].set_title("gaps" + ("; dashed: the solution's" if mine else ""))
    axes[1][1].set_title("penetration")
    for ax in axes.ravel():
        style.label_ends(ax)
    style.save(figure, out / "08_order")


def draw_result(solution, mine, out):
    """For the text alone: what the landing opens and how deep it presses, by the order."""
    if out.suffix != ".svg":
        return
    table = rows(solution, iterations=30)
    shown = table["time_s"] < 2.51
    most = {(name, column): 1000 * np.max(part[column][part["time_s"] < 2.51])
            for name, part, _, _ in parts(table, "order") for column in ("gap_m", "penetration_m")}
    figure, axes = style.figure(
        f"Joints first: gaps of {most['joints first', 'gap_m']:.0f} mm. Contacts first: "
        f"{most['contacts first', 'penetration_m']:.0f} mm deep. One loop: neither", 2)
    for ax, column, words in zip(axes, ("gap_m", "penetration_m"), (
            "widest gap of a joint  [mm]", "deepest corner  [mm]")):
        for n, name in enumerate(("interleaved", "joints first", "contacts first")):
            part = rows({key: np.asarray(column)[shown] for key, column in table.items()},
                        order=name)
            ax.plot(part["time_s"], np.round(1000 * part[column], 2), color=COLOURS[n],
                    linestyle=("-", "-", (0, (4, 2)))[n], zorder=3 - n,
                    label=("one loop", "joints\nfirst", "contacts\nfirst")[n])
        ax.set(xlabel="time  [s]", ylabel=words, xlim=(0, 2.5), ylim=(-1, 65),
               xticks=(0, 1, 2), yticks=(0, 20, 40, 60))
        style.label_ends(ax)
    axes[0].set_title("a chain lands")
    style.save(figure, out / "08_result")


def draw_drift(solution, mine, out):
    table = mine or solution
    ends = {name: part["gap_m"][-1] for name, part, _, _ in parts(table, "scene")}
    figure, (left, right) = style.figure(
        f"Uncorrected hinge: open by {metres(ends['gravity'])}; when hit "
        f"{metres(ends['collision'])}, contact last {metres(ends['contact last'])}", 2)
    over_time(left, solution, mine, "gap_m", "scene")
    left.set(ylabel="gap of the hinge  [m]", title="beta 0" + whose(mine))
    for name, part, colour, marker in parts(table, "scene"):
        before = part["touching"] > 0
        hits = np.flatnonzero(before & ~np.roll(before, 1))
        if name != "contact last":
            left.plot(part["time_s"][hits], part["gap_m"][hits], color=colour, marker="o",
                      markersize=4, linestyle="none", label="_")
        grown = np.diff(part["gap_m"], prepend=0)
        told = np.diff(part["predicted_m"], prepend=0)
        right.plot(part["time_s"], visible(np.abs(grown - told)), color=colour, linewidth=1,
                   label=NAMES.get(name, name))
    right.set(yscale="log", xlabel="time  [s]", ylim=(1e-9, 1), xlim=(0, 4),
              ylabel="growth of a step, off the formula  [m]",
              title=r"what $\omega^2 r\,h^2/2$ does not explain")
    left.text(0.03, 0.97, "dots: hits", fontsize=8.5, color=COLOURS[1], va="top",
              transform=left.transAxes)
    style.label_ends(left)
    style.label_ends(right)
    style.save(figure, out / "08_drift")


# ---- tables --------------------------------------------------------------------------------------

def drawn(draw):
    """The same, left out where a run of one machine only has not written its tables."""
    def either(solution, mine, out):
        if solution is not None:
            draw(solution, mine, out)
    return either


def tables(folder, command):
    def read(name, numbers, *words):
        return style.read_csv(folder / f"{name}.csv", numbers.split(), words, command)

    def there(*wanted):
        missing = [name for name, *_ in wanted if not (folder / f"{name}.csv").is_file()]
        if missing and any(folder.glob("*.csv")):
            return None
        found = tuple(read(*want) for want in wanted)
        return found if len(found) > 1 else found[0]
    return (there(("rest", "iterations farthest_m fastest_m_s", "start")),
            there(("slide", "direction_deg speed_m_s way_m expected_m stepped_m", "tangents"),
                  ("by_hand", "time_s way_m speed_m_s normal_ns friction_ns bound_ns "
                   "off_engine_m")),
            there(("tilt", "mu angle_deg way_m")),
            there(("bounce", "restitution drop_m rebound_m expected_m"),
                  ("bounce_path", "restitution time_s height_m")),
            there(("order", "iterations time_s gap_m penetration_m", "order"),
                  ("order_summary", "iterations gap_rms_m gap_max_m penetration_max_m", "order")),
            there(("drift", "time_s gap_m predicted_m touching", "scene")),
            there(("machines", "iterations gap_rms_m gap_max_m penetration_max_m energy_drift",
                   "machine")),
            there(("wheels", "time_s place_m turned_rad rolled_m motor_nm gap_m")),
            there(("ragdoll", "time_s fastest_m_s fastest_rad_s gap_m penetration_m")),
            there(("order", "iterations time_s gap_m penetration_m", "order")))


if __name__ == "__main__":
    style.run(lambda: style.chapter(8, tables, (*map(drawn, (
        draw_rest, draw_friction, draw_slope, draw_bounce, draw_order, draw_drift,
        draw_machines, draw_wheels, draw_ragdoll)), draw_result), result=draw_result))
