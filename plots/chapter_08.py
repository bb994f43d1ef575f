#!/usr/bin/env python3
"""Draws the figures of chapter 8: rest, friction, slope, bounce, order, drift and the machines.

chapter_08.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from chapter_06 import FORMULA, counts, metres, whose
from machines import NAMES, draw_ragdoll, draw_wheels, over_time, parts
from style import COLOURS, INK, rows

# ---- one body ----------------------------------------------------------------------------------

ROUNDING = 1e-9  # of a displacement [m]: what is below it is drawn there


def draw_rest(table, _, out):
    few = 4 if 4 in table["iterations"] else table["iterations"].min()
    ends = [f"{metres(np.max(rows(table, start=name, iterations=few)['farthest_m']))} {name}"
            for name in dict.fromkeys(table["start"])]
    figure, ax = style.figure(
        f"In a minute at rest, with {few:g} iterations per step, a box creeps {', '.join(ends)}")
    for name, part, colour, marker in parts(table, "start"):
        ax.plot(part["iterations"], np.maximum(part["farthest_m"], ROUNDING), color=colour,
                marker=marker, markersize=5, label=name)
    ax.set(yscale="log", ylabel="displacement of a corner in a minute")
    ax.axhspan(ROUNDING / 3, 2 * ROUNDING, color=COLOURS[2], alpha=0.15, linewidth=0)
    ax.text(0.02, 1.2 * ROUNDING, "1 nm and less: it rests", va="center", fontsize=8.5,
            transform=ax.get_yaxis_transform(), color=COLOURS[2])
    style.metres_log(ax.yaxis)
    counts(ax, table)
    style.label_ends(ax)
    style.save(figure, out / "08_rest")


def draw_friction(solution, mine, out):
    slide, hand = (mine or solution)[0], solution[1]
    fast = rows(slide, speed_m_s=np.max(slide["speed_m_s"]))
    straight = rows(fast, tangents="turned")["expected_m"]
    share = {name: 100 * (part["way_m"] / straight)[part["direction_deg"] == 45][0]
             for name, part, _, _ in parts(fast, "tangents")}
    figure, panels = style.plt.subplot_mosaic(
        "as;af", figsize=(style.WIDTH, style.HEIGHT), layout="constrained")
    left, upper, lower = (panels[name] for name in "asf")
    style.entitle(figure, f"At 45° a box slides {share['turned']:.0f} % of "
                  f"$v^2/2\\mu g$ if its tangents turn, {share['fixed']:.0f} % if they are fixed")
    for name, part, colour, marker in parts(fast, "tangents"):
        left.plot(part["direction_deg"], 100 * part["way_m"] / straight, color=colour,
                  marker=marker, linestyle="none", label=name + "\ntangents")
        left.plot(part["direction_deg"], 100 * part["stepped_m"] / straight, label="_", **FORMULA)
    left.set(xlabel="direction of sliding, from x  [°]", xticks=range(0, 91, 15), ylim=(0, 108),
             ylabel=r"distance, of $v^2/2\mu g$  [%]",
             title=f"from {fast['speed_m_s'][0]:g} m/s; dashed: predicted")
    over_time(upper, hand, None, "speed_m_s", color=COLOURS[1])
    over_time(lower, hand, None, "bound_ns", color=INK, label="bound,\nµ × normal")
    over_time(lower, hand, None, "friction_ns", color=COLOURS[0], label="friction")
    lower.lines[0].set(linewidth=1.2, linestyle=":")
    upper.set(ylabel="speed  [m/s]", xlabel="", xticklabels=[],
              title=f"loop by hand, {metres(np.max(hand['off_engine_m']))} off the engine")
    lower.set(ylabel="impulse  [N s]", ylim=(0, 1.2 * np.max(hand["bound_ns"])))
    style.label_ends(left)
    style.label_ends(lower)
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
        f"{near:.1g}° below arctan µ a box moves by {metres(held)} in 10 s, "
        f"{near:.1g}° above it by {metres(slid)} (µ = {middle:g})", 2)
    left.axvspan(-6, 0, color=COLOURS[2], alpha=0.1, linewidth=0)
    for n, mu in enumerate(mus):
        part = rows(table, mu=mu)
        angle = np.radians(part["angle_deg"])
        fall = 0.5 * 9.81 * (np.sin(angle) - mu * np.cos(angle)) * 100
        left.plot(part["beyond"], np.maximum(fall, 0), label="_", **FORMULA)
        left.plot(part["beyond"], part["way_m"], color=COLOURS[n], marker="os^"[n], markersize=5,
                  linestyle="none", label=f"µ = {mu:g}")
    left.set(xlim=(-6, 6), xlabel="slope minus arctan µ  [°]", ylabel="distance in 10 s  [m]",
             title=r"dashed: $\frac{1}{2}g\,(\sin\alpha-\mu\cos\alpha)\,t^2$")
    line = np.linspace(0, 1.15 * mus[-1], 100)
    right.plot(line, np.degrees(np.arctan(line)), label="_", **FORMULA)
    for holds, marker, colour in ((True, "o", COLOURS[2]), (False, "^", COLOURS[0])):
        chosen = (table["way_m"] < 1e-3) == holds
        right.plot(table["mu"][chosen], table["angle_deg"][chosen], marker=marker, color=colour,
                   linestyle="none", markersize=4, markerfacecolor="white")
    right.set(xlabel="coefficient of friction µ", ylabel="slope  [°]",
              title=r"dashed: $\tan\alpha=\mu$", xlim=(0, line[-1]), ylim=(0, None))
    for ax, stays, slides in ((left, (0.25, 0.93), (0.6, 0.93)),
                              (right, (0.65, 0.25), (0.3, 0.75))):
        for (x, y), words, colour in ((stays, "stays", COLOURS[2]), (slides, "slides", COLOURS[0])):
            ax.text(x, y, words, color=colour, ha="center", transform=ax.transAxes)
    style.label_ends(left)
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

def draw_order(solution, ends, out):
    """What draw_result shows, over the iterations, for the whole run."""
    given = ends or solution
    most = given["iterations"].max()

    def end(order, column):
        return metres(rows(given, order=order, iterations=most)[column][0])
    figure, axes = style.figure(
        f"{most:g} iterations do not help: joints first leaves gaps of "
        f"{end('joints first', 'gap_rms_m')}, contacts first corners "
        f"{end('contacts first', 'penetration_max_m')} deep", 2)
    for ax, column, words in zip(axes, ("gap_rms_m", "penetration_max_m"),
                                 ("gap of the joints, RMS  [mm]", "deepest corner  [mm]")):
        for name, part, colour, marker in parts(given, "order"):
            if name != "no ground":
                ax.plot(part["iterations"], 1000 * part[column], color=colour, marker=marker,
                        markersize=5, label=NAMES[name])
        if ends:
            for name, part, _, _ in parts(solution, "order"):
                if name != "no ground":
                    ax.plot(part["iterations"], 1000 * part[column], label="_", **FORMULA)
            style.hold(ax, 1000 * ends[column], 1000 * solution[column])
        ax.set(ylabel=words, ylim=(0, None))
        counts(ax, given)
        style.label_ends(ax)
    axes[0].set_title("a chain lands" + whose(ends))
    style.save(figure, out / "08_order")


def draw_result(solution, mine, out):
    """For the text alone: gaps and depths at the landing, by the order."""
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
        for n, (name, part, colour, _) in enumerate(parts(
                {key: np.asarray(column)[shown] for key, column in table.items()}, "order")):
            if name != "no ground":
                ax.plot(part["time_s"], np.round(1000 * part[column], 2), color=colour,
                        linestyle=(0, (4, 2)) if name == "contacts first" else "-", zorder=3 - n,
                        label=NAMES[name])
        ax.set(xlabel="time  [s]", ylabel=words, xlim=(0, 2.5), ylim=(-1, 65),
               xticks=(0, 1, 2), yticks=(0, 20, 40, 60))
        style.label_ends(ax)
    axes[0].set_title("a chain lands")
    style.save(figure, out / "08_result")


def draw_drift(table, _, out):
    ends = {name: part["gap_m"][-1] for name, part, _, _ in parts(table, "scene")}
    figure, axes = style.figure(
        f"Uncorrected, a hinge opens by {metres(ends['gravity'])} in 10 s, by "
        f"{metres(ends['collision'])} if it hits the ground, by {metres(ends['contact last'])} if "
        "the contact is solved last", 2, sharey=True)
    for name, part, colour, _ in parts(table, "scene"):
        ax = axes[int(name == "contact last")]
        ax.plot(part["time_s"], part["gap_m"], color=colour, linewidth=2.5, alpha=0.8,
                label=NAMES.get(name, name))
        ax.plot(part["time_s"], part["predicted_m"], color=INK, linewidth=1, dashes=(4, 2),
                label="_" if ax is axes[0] else "predicted")
    for ax, words in zip(axes, ("as Eq. 6-1 predicts (dashed)", "contact after the joint: more")):
        ax.set(xlabel="time  [s]", title=words)
        style.label_ends(ax)
    axes[0].set(ylabel="gap of the hinge  [m]", ylim=(0, 1.1 * np.max(table["gap_m"])))
    style.save(figure, out / "08_drift")


# ---- tables --------------------------------------------------------------------------------------

def tables(folder, command):
    read = style.reader(folder, command)
    return (read("rest", "iterations farthest_m fastest_m_s", "start"),
            (read("slide", "direction_deg speed_m_s way_m expected_m stepped_m", "tangents"),
             read("by_hand", "time_s way_m speed_m_s normal_ns friction_ns bound_ns "
                  "off_engine_m")),
            read("tilt", "mu angle_deg way_m"),
            (read("bounce", "restitution drop_m rebound_m expected_m"),
             read("bounce_path", "restitution time_s height_m")),
            read("order_summary", "iterations gap_rms_m gap_max_m penetration_max_m", "order"),
            read("drift", "time_s gap_m predicted_m touching", "scene"),
            read("wheels", "time_s place_m turned_rad rolled_m motor_nm gap_m"),
            read("ragdoll", "time_s fastest_m_s fastest_rad_s gap_m penetration_m"),
            read("order", "iterations time_s gap_m penetration_m", "order"))


if __name__ == "__main__":
    style.run(lambda: style.chapter(8, tables, (
        draw_rest, draw_friction, draw_slope, draw_bounce, draw_order, draw_drift,
        draw_wheels, draw_ragdoll, draw_result), result=draw_result))
