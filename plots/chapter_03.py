#!/usr/bin/env python3
"""Draws the figures of chapter 3: doors, a limit, a motor's bound, a chain that curls, and S7.

chapter_03.py --solution DIR [--mine DIR] --out DIR, or --result FILE in place of --out
"""
import numpy as np

import style
from style import COLOURS, INK, PALE, label_ends

APART, WHOLE = "blocks apart", "whole joint"


def pick(table, column, **where):
    """(time, column) of the rows where the other columns have these values."""
    chosen = np.ones(len(table[column]), bool)
    for name, value in where.items():
        chosen &= np.asarray(table[name]) == value
    return table["time_s"][chosen], table[column][chosen]


def door(folder, command):
    return style.read_csv(folder / "door.csv", ["iterations", "speed_rad_s", "time_s", "angle_deg"],
                          ["blocks"], command)


def draw_door(solution, mine, out):
    """The doors of the whole joint over time: the slow ones, and the first steps of the fast."""
    table, own = solution, mine
    speeds = np.unique(table["speed_rad_s"])
    farthest = max(pick(own or table, "angle_deg", blocks=WHOLE, speed_rad_s=speed)[1].max()
                   for speed in speeds)
    figure, axes = style.figure(
        f"Slammed with {speeds.min():g} to {speeds.max():g} rad/s, "
        + (f"{'your doors stop' if own else 'the doors stop'} at their limit, at {farthest:.2f}°"
           if farthest < 111 else f"a door goes to {farthest:.0f}° and not to 110°"), 2)
    slow, fast = np.array_split(speeds, 2)
    for ax, few, longest, words in ((axes[0], slow, 2.5, "slow doors"),
                                    (axes[1], fast, 0.2, "fast doors, a dot per step")):
        for speed in few:
            colour = COLOURS[list(speeds).index(speed)]
            for given, looks in ((own, {"linewidth": 3.2, "alpha": 0.5}),
                                 (table, {"dashes": (4, 2) if own else (None, None)})):
                if given:
                    t, angle = pick(given, "angle_deg", blocks=WHOLE, speed_rad_s=speed)
                    ax.plot(t[t <= longest], angle[t <= longest], color=colour, label="_",
                            marker="." if ax is axes[1] else None, **looks)
            at = 90 if speed == few[-1] else 50
            some = np.searchsorted(angle, at) + 1
            ax.text(np.interp(at, angle[:some], t[:some]) + 0.03 * longest, at,
                    f"{speed:g} rad/s", color=colour, va="top")
        ax.axhline(110, color=PALE, linewidth=0.8)
        ax.text(0.98, 112, "limit, 110°", ha="right", color=PALE, fontsize=8.5,
                transform=ax.get_yaxis_transform())
        ax.set(xlabel="time  [s]", xlim=(0, longest), ylim=(0, max(125, 1.05 * farthest)),
               xticks=np.linspace(0, longest, 5 if longest < 1 else 6),
               title=words + (": yours (thick)" if own else ""))
    axes[0].set_ylabel("opening angle  [°]")
    style.save(figure, out / "03_door")


def draw_limit(solution, mine, out):
    """How far a falling cube passes its limit, by the number of iterations."""
    table = style.rows(mine or solution, scene="S4l")
    past = {way: style.rows(table, blocks=way)["overshoot_deg"] for way in (APART, WHOLE)}
    figure, ax = style.figure(
        f"A cube that falls onto its limit passes it by {past[APART].max():.1f}° at most with "
        f"blocks apart, by {past[WHOLE].max():.2f}° as a whole joint")
    counts = np.unique(table["iterations"])
    for way, colour, aside in ((APART, COLOURS[0], -0.2), (WHOLE, COLOURS[1], 0.2)):
        places = np.arange(len(counts)) + aside
        ax.bar(places, past[way], 0.36, color=colour, label=way)
        for place, angle in zip(places, past[way]):
            ax.annotate(f"{angle:.3g}°" if angle > 1e-4 else "0°", (place, max(angle, 0)),
                        xytext=(0, 3), textcoords="offset points", ha="center", color=colour)
    ax.set_xticks(range(len(counts)), [f"{count:g}" for count in counts])
    ax.grid(axis="x", visible=False)
    ax.legend(frameon=False, labelcolor="linecolor", fontsize=10)
    ax.set(xlabel="iterations per step", ylabel="past the limit  [°]",
           title="yours" if mine else "")
    style.save(figure, out / "03_limit")


def draw_motor(solution, mine, out):
    ideal = np.array([0, 2.5, 4])
    right_way = pick(solution, "speed_rad_s", clamped="sum", solves=1)
    title = "A motor of 2 N m on 1 kg m²: clamp the sum, and the number of solves does not matter"
    if mine:
        title = "A motor of 2 N m on 1 kg m², 100 solves: " + style.verdict(
            pick(mine, "speed_rad_s", clamped="sum", solves=100), right_way, "rad/s")
    figure, (left, right) = style.figure(title, 2, sharey=True)
    for ax, clamped, words in ((left, "sum", "the sum of a step is clamped"),
                               (right, "solve", "each solve is clamped separately")):
        for solves, colour in zip((1, 10, 100), COLOURS):
            t, speed = pick(mine or solution, "speed_rad_s", clamped=clamped, solves=solves)
            ax.plot(t, speed, color=colour, label=f"{solves} solve" + "s" * (solves > 1),
                    linewidth={1: 5, 10: 3, 100: 1.2}[solves] if clamped == "sum" else 1.8)
        ax.plot(ideal, np.minimum(2 * ideal, 5), color=INK, linewidth=1, dashes=(4, 2),
                label="2 N m, 5 rad/s" if clamped == "solve" else "_")
        ax.set(xlabel="time  [s]", xlim=(0, 4), ylim=(-0.3, 5.6),
               title=words + (", yours" if mine else ""))
    left.set_ylabel("speed  [rad/s]")
    if not mine:
        left.text(0.97, 0.1, "1, 10 and 100 solves", ha="right", fontsize=8.5, color=PALE,
                  transform=left.transAxes)
    label_ends(right)
    style.save(figure, out / "03_motor")


def draw_curl(solution, mine, out):
    table, limit, bound = mine or solution, 40, 20
    joints = np.unique(table["joint"])
    arrived = [joint for joint in joints
               if pick(table, "angle_deg", joint=joint)[1][-1] > limit - 0.5]
    figure, (left, right) = style.figure(
        f"{'Your seven' if mine else 'Seven'} motors bend a hanging chain: {len(arrived)} hinges "
        f"reach {limit}°; the top one does not, although its motor is not at its bound", 2)
    for joint in joints[[0, 2, 3, 4, -1]]:
        end = {joints[0]: " (top)", joints[-1]: " (end)"}.get(joint, "")
        left.plot(*pick(table, "angle_deg", joint=joint), color=shade(joint / joints.max()),
                  label=f"hinge {joint:g}{end}")
        if mine:
            left.plot(*pick(solution, "angle_deg", joint=joint), color=INK, linewidth=0.9,
                      dashes=(4, 2), label="_")
    left.axhline(limit, color=PALE, linewidth=0.8)
    left.text(0.02, limit + 0.5, "limit", color=PALE, fontsize=8.5,
              transform=left.get_yaxis_transform())
    left.set(xlabel="time  [s]", ylabel="angle  [°]",
             title="five of the hinges" + ("; dashed: the solution" if mine else ""))
    means = [np.mean(torque[t >= 4]) / 1000 for t, torque in
             (pick(table, "motor_nm", joint=joint) for joint in joints)]
    right.bar(joints, means, color=[shade(joint / joints.max()) for joint in joints])
    right.axhline(bound, color=PALE, linewidth=0.8)
    right.text(0.98, bound - 0.4, f"bound of each motor, {bound} kN m", ha="right", va="top",
               color=PALE, fontsize=8.5, transform=right.get_yaxis_transform())
    right.grid(axis="x", visible=False)
    right.set(xlabel="hinge, from the top", ylabel="torque  [kN m]", ylim=(0, 1.08 * bound),
              title="mean torque of the last second", xticks=joints)
    label_ends(left)
    style.save(figure, out / "03_curl")


def shade(share):
    """From dark blue to orange, with different lightness, too."""
    dark, light = np.array([0.05, 0.1, 0.35]), np.array([0.95, 0.6, 0.1])
    return tuple(dark + (light - dark) * share)


def tables(folder, command):
    return (door(folder, command),
            style.read_csv(folder / "driven.csv", ["iterations", "overshoot_deg"],
                           ["scene", "blocks"], command),
            style.read_csv(folder / "motor.csv", ["solves", "time_s", "speed_rad_s"], ["clamped"],
                           command),
            style.read_csv(folder / "curl.csv", ["time_s", "joint", "angle_deg", "motor_nm"], (),
                           command))


if __name__ == "__main__":
    style.run(lambda: style.chapter(
        3, tables, (draw_door, draw_limit, draw_motor, draw_curl), result=draw_limit))
