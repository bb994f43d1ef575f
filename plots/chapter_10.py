#!/usr/bin/env python3
"""Draws the figures of chapter 10: a universal joint over a turn, a cone struck in all directions.

chapter_10.py --solution DIR [--mine DIR] --out DIR
"""
import numpy as np

import style
from style import COLOURS, INK, PALE, label_ends, rows

BENDS = (15, 30, 45, 60)


def draw_universal(solution, mine, out):
    table = mine or solution
    worst = np.abs(table["measured"] - table["formula"]).max()
    right = "as the formula says" if worst < 1e-6 else f"up to {worst:.2g} from the formula"
    figure, ax = style.figure("Universal joint: the second shaft turns unevenly, " + right)
    for bend, colour in zip(BENDS, COLOURS):
        part = rows(table, bend_deg=bend)
        turn = np.radians(np.linspace(0, 360, 145))
        b = np.radians(bend)
        ax.plot(np.degrees(turn), np.cos(b) / (1 - (np.sin(b) * np.sin(turn)) ** 2), color=INK,
                linewidth=1, dashes=(4, 2), label="_")
        ax.plot(part["angle_deg"][::2], part["measured"][::2], color=colour, marker="o",
                markersize=3.5, linestyle="none", label="_")
        at = np.argmax(part["measured"])
        ax.text(part["angle_deg"][at], part["measured"][at] + 0.04, f"{bend}°", ha="center",
                color=colour, fontsize=9)
    ax.set(xlabel="angle of the first shaft  [degrees]",
           ylabel="speed of the second shaft over that of the first", xlim=(0, 360),
           xticks=range(0, 361, 90), ylim=(0.3, 2.2))
    ax.text(0.985, 0.03, "dots: measured" + (", yours" if mine else "") + "; dashed: Eq. 10-3",
            ha="right", fontsize=8.5, color=PALE, transform=ax.transAxes)
    style.save(figure, out / "10_universal")


def draw_cone(solution, mine, out):
    table = mine or solution
    figure, ax = style.figure(
        f"Cone of 45°, 100 rad/s: an arm swings {table['blind_deg'].max():.0f}° without a row on "
        f"the axis, {table['swing_deg'].max():.0f}° with one, {table['late_deg'].max():.1f}° with "
        "late rows")
    for column, colour, label in (("blind_deg", COLOURS[1], "zero on the axis"),
                                  ("swing_deg", COLOURS[0], "one row"),
                                  ("late_deg", COLOURS[2], "and late rows")):
        ax.plot(table["direction_deg"], table[column], color=colour, label=label)
    ax.axhline(45, color=PALE, linewidth=0.8, dashes=(4, 2))
    ax.set(xlabel="direction in which the arm is struck  [degrees]",
           ylabel="greatest swing  [degrees]", xlim=(0, 350), ylim=(0, 105),
           xticks=range(0, 361, 90))
    label_ends(ax)
    style.save(figure, out / "10_cone")


def tables(folder, command):
    universal = style.read_csv(folder / "universal.csv",
                               ["bend_deg", "angle_deg", "measured", "formula"], (), command)
    cone = style.read_csv(folder / "cone.csv",
                          ["direction_deg", "late_deg", "swing_deg", "blind_deg"], (), command)
    return universal, cone


if __name__ == "__main__":
    style.run(lambda: style.chapter(10, tables, (draw_universal, draw_cone),
                                    result=draw_universal))
