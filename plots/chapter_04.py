#!/usr/bin/env python3
"""Draws the figures of chapter 4: the piston, the cannon, and a motor without levers.

chapter_04.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from style import COLOURS, INK, PALE, label_ends

LIMITS, BOUND = (0, 0.4), 80  # [m], [N]: of chapters/04_slider/program/piston.h


def whole(table):
    """The rows of the whole joint only."""
    return style.rows(table, blocks="whole joint")


def draw_piston(solution, mine, out):
    first = {name: np.asarray(column)[np.asarray((mine or solution)["time_s"]) < 3.01]
             for name, column in (mine or solution).items()}
    table = whole(first)
    t = table["time_s"]
    figure, (left, right) = style.figure(
        f"A piston: the motor stays within {abs(table['motor_n']).max():.0f} N, and the limits do "
        "the stopping", 2)
    left.plot(t, table["displacement_m"], color=COLOURS[0 if mine else 1],
              label="_", linewidth=3 if mine else 1.8)
    if mine:
        theirs = whole(solution)
        left.plot(theirs["time_s"][:len(t)], theirs["displacement_m"][:len(t)], color=INK,
                  linewidth=1.1, dashes=(4, 2), label="_")
    for limit, words in zip(LIMITS, ("lower", "upper")):
        left.axhline(limit, color=PALE, linewidth=0.8)
        left.text(0.98, limit + 0.004, f"{words} limit, {limit:g} m", ha="right",
                  va="bottom", fontsize=8.5, color=PALE, transform=left.get_yaxis_transform())
    left.set(xlabel="time  [s]", ylabel="displacement  [m]", xlim=(0, 3), ylim=(-0.03, 0.45),
             title="up and down once" + (": yours (thick), the solution's" if mine else ""))
    for column, colour, label in (("limit_n", COLOURS[1], "limit"),
                                  ("motor_n", COLOURS[0], "motor")):
        right.step(t[1:], table[column][1:], color=colour, label=label, linewidth=1.3)
    for force in (-BOUND, BOUND):
        right.axhline(force, color=PALE, linewidth=0.8, dashes=(4, 2))
    for place, force, side, said in ((0.98, BOUND + 6, "right", f"bound, {BOUND} N"),
                                     (0.2, -BOUND - 24, "left", f"bound, −{BOUND} N")):
        right.text(place, force, said, fontsize=8.5, color=PALE, ha=side,
                   transform=right.get_yaxis_transform())
    for stop, words, side in ((np.argmin(table["limit_n"]), "stops it at the top", -1),
                              (np.argmax(table["limit_n"]), "stops it at the bottom", 1)):
        right.text(t[stop] - 0.08 * side, table["limit_n"][stop], words, va="center",
                   ha="right" if side > 0 else "left", fontsize=8.5, color=COLOURS[1])
    right.set(xlabel="time  [s]", ylabel="force along the axis  [N]", xlim=(0, 3),
              title="forces on the piston, upwards positive")
    label_ends(right)
    style.save(figure, out / "04_piston")


def draw_cannon(solution, mine, out):
    table = whole(mine or solution)
    t, flying = table["time_s"], table["flying"] > 0
    exit_speed = table["shot_m_s"][~flying][-1]
    acceleration = 5000 / 60 - 9.81 * np.sqrt(0.5)
    muzzle = table["displacement_m"][-1]
    figure, (left, right) = style.figure(
        f"The carriage of the cannon stops at the muzzle, the shot leaves with {exit_speed:.1f} "
        "m/s", 2)
    short = t <= 0.8
    left.plot(t[short], -1 + acceleration / 2 * t[short] ** 2, color=INK, linewidth=1,
              dashes=(4, 2), label="_")
    left.plot(t[short], table["displacement_m"][short], color=COLOURS[1], linewidth=2.5)
    left.axhline(muzzle, color=PALE, linewidth=0.8)
    left.text(0.02, muzzle + 0.2, f"muzzle: limit at {muzzle:.0f} m", fontsize=8.5, color=PALE,
              transform=left.get_yaxis_transform())
    left.text(0.62, 12.6, "by hand, 5000 N,\nwithout a limit", fontsize=8.5, va="center")
    left.text(0.38, 3.5, "carriage", fontsize=8.5, color=COLOURS[1])
    left.set(xlabel="time  [s]", ylabel="displacement of the carriage  [m]", ylim=(-2, 14),
             xlim=(0, 0.8), title="in the barrel" + (", yours" if mine else ""))
    for part, colour, words in ((~flying, COLOURS[1], "in the barrel"),
                                (flying, COLOURS[0], "in free flight")):
        x, y = table["shot_x_m"][part], table["shot_y_m"][part]
        right.plot(x, y, color=colour, linewidth=3 if words == "in the barrel" else 1.6)
        middle = len(x) // 2
        right.text(x[middle] + 2, y[middle] - 2, words, color=colour, va="top", fontsize=8.5)
    if mine:
        theirs = whole(solution)
        right.plot(theirs["shot_x_m"], theirs["shot_y_m"], color=INK, linewidth=1, dashes=(4, 2))
    right.set(xlabel="x  [m]", ylabel="height  [m]", aspect="equal",
              title="the shot's path" + ("; dashed: the solution's" if mine else ""))
    style.save(figure, out / "04_cannon")


def draw_momentum(solution, mine, out):
    table = mine or solution
    figure, (left, right) = style.figure(
        "Two free bodies: a motor without levers creates angular momentum", 2)
    if mine:
        chosen = np.asarray(solution["row"]) == "levers"
        for ax, column in ((left, "angular_momentum"), (right, "turn_rad_s")):
            ax.plot(solution["time_s"][chosen], solution[column][chosen], color=INK, linewidth=1.1,
                    dashes=(4, 2), label="the solution", zorder=5)
    for row, colour, words in (("levers", COLOURS[1], "with levers" + (", yours" if mine else "")),
                               ("centres", COLOURS[0], "without")):
        chosen = np.asarray(table["row"]) == row
        left.plot(table["time_s"][chosen], table["angular_momentum"][chosen], color=colour,
                  label=words)
        right.plot(table["time_s"][chosen], table["turn_rad_s"][chosen], color=colour, label=words)
    left.set(xlabel="time  [s]", ylabel="angular momentum of both  [N m s]",
             title="it must not change" + (": yours" if mine else ""))
    right.set(xlabel="time  [s]", ylabel="angular velocity of the pair  [rad/s]",
              title="so the pair must rotate while it separates")
    label_ends(left)
    label_ends(right)
    style.save(figure, out / "04_momentum")


def tables(folder, command):
    return (style.read_csv(folder / "piston.csv",
                           ["time_s", "displacement_m", "motor_n", "limit_n"], ["blocks"], command),
            style.read_csv(folder / "cannon.csv", ["time_s", "displacement_m", "shot_x_m",
                                                   "shot_y_m", "shot_m_s", "flying"], ["blocks"],
                           command),
            style.read_csv(folder / "momentum.csv", ["time_s", "angular_momentum", "turn_rad_s"],
                           ["row"], command))


if __name__ == "__main__":
    style.run(lambda: style.chapter(4, tables, (draw_piston, draw_cannon, draw_momentum),
                                    result=draw_piston))
