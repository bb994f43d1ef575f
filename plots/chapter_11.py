#!/usr/bin/env python3
"""Draws the figures of chapter 11: the weight of a chain at its end, the error by the step.

chapter_11.py --solution DIR [--mine DIR] --out DIR
"""
import style
from style import COLOURS, INK, label_ends, rows

METHODS = (("Runge-Kutta", COLOURS[0], "angles, Runge-Kutta"),
           ("Euler", COLOURS[2], "angles, Euler"), ("rows", COLOURS[1], "rows, iterated"))


def draw_weight(solution, mine, out):
    table = mine or solution
    last = len(table["bars"]) - 1
    figure, ax = style.figure(
        f"A chain of {table['bars'][last]:.0f} bars of 1 kg feels like "
        f"{table['along_kg'][last]:.3g} kg along, {table['across_kg'][last]:.2g} kg across")
    for column, colour, label in (("along_kg", COLOURS[0], "along the chain"),
                                  ("across_kg", COLOURS[1], "across it")):
        mass = style.visible(table[column])
        ax.plot(table["bars"], mass, color=colour, marker="o", markersize=3, label=label)
        for k, side in ((0, "left"), (last, "right")):
            if mass[k] > 0:
                ax.annotate(f"{mass[k]:.2g}", (table["bars"][k], mass[k]), xytext=(0, 7), ha=side,
                            textcoords="offset points", fontsize=8.5, color=colour)
    ax.set(xlabel="bars of the chain", ylabel="mass that the hand at its end feels  [kg]",
           xscale="log", yscale="log")
    for axis in (ax.xaxis, ax.yaxis):
        style.plain_log(axis)
    label_ends(ax)
    style.save(figure, out / "11_weight")


def draw_order(solution, mine, out):
    table = mine or solution
    at60 = [rows(table, method=method, steps=60)["error_m"][0] for method, _, _ in METHODS]
    figure, ax = style.figure("A second in 60 steps, {}the free end is {:.2g} m off by angles and "
                              "Runge-Kutta, {:.2g} by Euler, {:.2g} on rows".format(
                                  "yours: " if mine else "", *at60))
    for method, colour, label in METHODS:
        part = rows(table, method=method)
        ax.plot(part["steps"], part["error_m"], color=colour, marker="o", markersize=3.5,
                label=label)
    ax.set(xlabel="steps a second", ylabel="distance from where it should be  [m]", xscale="log",
           yscale="log", xlim=(25, 2300), xticks=(30, 120, 480, 1920))
    ax.set_xticklabels((30, 120, 480, 1920))
    ax.minorticks_off()
    for order, at in ((1, 0.02), (4, 2e-8)):
        ax.plot((480, 1920), (at, at / 4 ** order), color=INK, linewidth=0.8, dashes=(3, 2),
                label="_")
        ax.text(960, at / 2 ** order * 1.6, f"slope {order}", fontsize=8.5, color=INK)
    label_ends(ax)
    style.save(figure, out / "11_order")


def tables(folder, command):
    weight = style.read_csv(folder / "weight.csv", ["bars", "along_kg", "across_kg"], (), command)
    order = style.read_csv(folder / "order.csv", ["steps", "error_m"], ["method"], command)
    return weight, order


if __name__ == "__main__":
    style.run(lambda: style.chapter(11, tables, (draw_weight, draw_order), result=draw_weight))
