#!/usr/bin/env python3
"""Draws the figures of chapter 3: doors, a limit, a motor's bound, a chain that curls, and S7.

chapter_03.py --solution DIR [--mine DIR] --out DIR, or --result FILE in place of --out
"""
import numpy as np
from matplotlib.ticker import NullLocator

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
    """The doors of the whole joint over time."""
    table, own = solution, mine
    speeds = np.unique(table["speed_rad_s"])
    farthest = max(pick(own or table, "angle_deg", blocks=WHOLE, speed_rad_s=speed)[1].max()
                   for speed in speeds)
    figure, ax = style.figure(
        f"Slammed at up to {speeds.max():g} rad/s, {'your' if own else 'the'} door "
        + (f"stops at {farthest:.2f}°" if farthest < 111 else f"goes to {farthest:.0f}°, not 110°"))
    for speed, colour in zip(speeds, COLOURS):
        t, angle = pick(table, "angle_deg", blocks=WHOLE, speed_rad_s=speed)
        short = (t > 0) & (t <= 3)
        if own:
            ax.plot(*(values[short] for values in
                      pick(own, "angle_deg", blocks=WHOLE, speed_rad_s=speed)),
                    color=colour, linewidth=3.2, alpha=0.5, label="_")
        ax.plot(t[short], angle[short], color=colour, label=f"{speed:g} rad/s", marker=".",
                markersize=4, linewidth=1, dashes=(4, 2) if own else (None, None))
    ax.axhline(110, color=PALE, linewidth=0.8)
    ax.set(xlabel="time, one dot per step  [s]", ylabel="opening angle  [°]", xscale="log",
           title="doors, whole joint" + (": yours (thick), the solution's" if own else ""))
    style.plain_log(ax.xaxis)
    label_ends(ax)
    style.save(figure, out / "03_door")


def draw_limit(solution, mine, out):
    """How far a cube passes its limit, over the number of iterations."""
    table = mine or solution
    blocks = np.asarray(table["blocks"])
    whole = np.abs(table["overshoot_deg"][blocks == WHOLE]).max()
    figure, ax = style.figure("With blocks apart a cube passes its limit; as a whole joint "
                              + ("it stops there" if whole < 0.005 else f"by {whole:.2f}°, too"))
    for scene, colour, words in (("S4l", COLOURS[0], "falls into it"),
                                 ("S4ml", COLOURS[1], "driven by\na motor")):
        chosen = (np.asarray(table["scene"]) == scene) & (blocks == APART)
        ax.plot(table["iterations"][chosen], style.visible(table["overshoot_deg"][chosen]),
                color=colour, marker="o", label=words)
    ax.set(xscale="log", yscale="log", xlabel="iterations per step", ylabel="past the limit  [°]",
           title="a cube of 100 kg, blocks apart" + (", yours" if mine else ""))
    for axis, places in ((ax.xaxis, np.unique(table["iterations"])),
                         (ax.yaxis, (0.001, 0.01, 0.1, 1, 10))):
        axis.set_ticks(places)
        axis.set_minor_locator(NullLocator())
        style.plain_log(axis)
    ax.text(0.03, 0.05, f"whole joint: {whole:.2f}° at any number of iterations", fontsize=8.5,
            color=PALE, transform=ax.transAxes)
    label_ends(ax)
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
                               (right, "solve", "each solve is clamped by itself")):
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
    table = mine or solution
    joints = np.unique(table["joint"])
    limit = 40
    arrived = [joint for joint in joints
               if pick(table, "angle_deg", joint=joint)[1][-1] > limit - 0.5]
    figure, (left, right) = style.figure(
        f"{'Your seven' if mine else 'Seven'} motors bend a hanging chain: {len(arrived)} hinges "
        "arrive, the lightest end first", 2)
    for joint in joints:
        colour = shade(joint / joints.max())
        t, angle = pick(table, "angle_deg", joint=joint)
        left.plot(t, angle, color=colour, label=f"{joint:g}")
        t, torque = pick(table, "motor_nm", joint=joint)
        right.plot(t, torque / 1000, color=colour, label=f"{joint:g}", linewidth=1)
        if mine:
            left.plot(*pick(solution, "angle_deg", joint=joint), color=INK, linewidth=0.9,
                      dashes=(4, 2), label="_")
    left.axhline(limit, color=PALE, linewidth=0.8)
    left.text(0.02, limit + 0.5, "limit", color=PALE, fontsize=8.5,
              transform=left.get_yaxis_transform())
    left.set(xlabel="time  [s]", ylabel="angle  [°]",
             title="angle of the hinges, 1 at the top" + ("; dashed: the solution" if mine else ""))
    right.set(xlabel="time  [s]", ylabel="torque  [kN m]", title="torque of the motors")
    label_ends(left)
    label_ends(right)
    style.save(figure, out / "03_curl")


def shade(share):
    """From dark blue to orange, told apart by lightness, too."""
    dark, light = np.array([0.05, 0.1, 0.35]), np.array([0.95, 0.6, 0.1])
    return tuple(dark + (light - dark) * share)


def draw_sideways(solution, mine, out):
    table = mine or solution
    figure, ax = style.figure("Gravity across the hinges: no number of iterations keeps the chain "
                              "in its plane")
    for blocks, colour, marker in ((APART, COLOURS[0], "o"), (WHOLE, COLOURS[1], "s")):
        chosen = np.asarray(table["blocks"]) == blocks
        ax.plot(table["iterations"][chosen], table["sideways_m"][chosen], color=colour,
                marker=marker, label=blocks)
    ax.set_xscale("log")
    style.plain_log(ax.xaxis)
    ax.set_ylim(0, 1.15 * table["sideways_m"].max())
    ax.axhline(0, color=INK, linewidth=1.2)
    ax.text(0.02, 0.02, "exact: 0 m, for ever", color=INK, fontsize=8.5, transform=ax.transAxes)
    ax.set(xlabel="iterations per step", ylabel="farthest out of the plane in 5 s  [m]")
    label_ends(ax)
    style.save(figure, out / "03_sideways")


def tables(folder, command):
    return (door(folder, command),
            style.read_csv(folder / "driven.csv", ["iterations", "overshoot_deg"],
                           ["scene", "blocks"], command),
            style.read_csv(folder / "motor.csv", ["solves", "time_s", "speed_rad_s"], ["clamped"],
                           command),
            style.read_csv(folder / "curl.csv", ["time_s", "joint", "angle_deg", "motor_nm"], (),
                           command),
            style.read_csv(folder / "sideways.csv", ["iterations", "sideways_m"], ["blocks"],
                           command))


if __name__ == "__main__":
    style.run(lambda: style.chapter(
        3, tables, (draw_door, draw_limit, draw_motor, draw_curl, draw_sideways),
        result=draw_limit))
