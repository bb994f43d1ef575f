#!/usr/bin/env python3
"""Draws the figures of chapter 4: the piston, the cannon, and a motor without levers.

chapter_04.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from style import COLOURS, INK, PALE, label_ends


def whole(table):
    """The rows of the whole joint only."""
    return style.rows(table, blocks="whole joint")


def draw_piston(solution, mine, out):
    table = whole(mine or solution)
    t = table["time_s"]
    figure, (left, right) = style.figure(
        "A piston: the motor gives 80 N at most, the limit the rest", 2)
    left.plot(t, table["displacement_m"], color=COLOURS[0 if mine else 1],
              label="_", linewidth=3 if mine else 1.6)
    if mine:
        left.plot(whole(solution)["time_s"], whole(solution)["displacement_m"], color=INK,
                  linewidth=1.1, dashes=(4, 2), label="_")
        left.set_title("displacement: yours (thick), the solution's")
    else:
        left.set_title("displacement")
    for limit in (0, 0.4):
        left.axhline(limit, color=PALE, linewidth=0.8)
    left.set(xlabel="time  [s]", ylabel="displacement  [m]")
    for column, colour, label in (("motor_n", COLOURS[0], "motor"),
                                  ("limit_n", COLOURS[1], "limit")):
        right.plot(t[1:], table[column][1:], color=colour, label=label, linewidth=1.3)
    right.axhline(5 * 9.81, color=PALE, linewidth=0.8)
    right.text(0.42, 5 * 9.81 + 5, "weight", ha="center", fontsize=8.5, color=PALE,
               transform=right.get_yaxis_transform())
    right.set(xlabel="time  [s]", ylabel="force along the line  [N]", title="forces")
    label_ends(right)
    style.save(figure, out / "04_piston")


def draw_cannon(solution, mine, out):
    table = whole(mine or solution)
    t, flying = table["time_s"], table["flying"] > 0
    exit_speed = table["shot_m_s"][~flying][-1]
    acceleration = 5000 / 60 - 9.81 * np.sqrt(0.5)
    figure, (left, right) = style.figure(
        f"The cannon: the carriage stops at the muzzle, the shot leaves with {exit_speed:.1f} m/s",
        2)
    short = t <= 1
    left.plot(t[short], table["displacement_m"][short], color=COLOURS[1], label="carriage")
    left.plot(t[short], -1 + acceleration / 2 * t[short] ** 2, color=INK, linewidth=1,
              dashes=(4, 2), label="5000 N,\nno limit")
    left.axhline(10, color=PALE, linewidth=0.8)
    left.set(xlabel="time  [s]", ylabel="displacement of the carriage  [m]", ylim=(-2, 14),
             xlim=(0, 1), title="in the barrel" + (", yours" if mine else ""))
    label_ends(left)
    right.plot(table["shot_x_m"][~flying], table["shot_y_m"][~flying], color=COLOURS[1],
               linewidth=3)
    right.plot(table["shot_x_m"][flying], table["shot_y_m"][flying], color=COLOURS[0], marker=".",
               markersize=2, linewidth=0.8)
    if mine:
        theirs = whole(solution)
        right.plot(theirs["shot_x_m"], theirs["shot_y_m"], color=INK, linewidth=1, dashes=(4, 2))
    right.set(xlabel="x  [m]", ylabel="y  [m]", aspect="equal",
              title="the shot's path" + ("; dashed: the solution's" if mine else ""))
    style.save(figure, out / "04_cannon")


def draw_momentum(solution, mine, out):
    table = mine or solution
    figure, (left, right) = style.figure(
        "Two free bodies: a motor without levers makes angular momentum from nothing", 2)
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
             title="it may not change" + (": yours" if mine else ""))
    right.set(xlabel="time  [s]", ylabel="how fast the pair rotates  [rad/s]",
              title="so they must rotate while they part")
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
