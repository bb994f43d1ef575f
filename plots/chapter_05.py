#!/usr/bin/env python3
"""Draws the figures of chapter 5: a welded beam, a far anchor, a weld that breaks.

chapter_05.py --solution DIR [--mine DIR] --out DIR
"""
import pathlib

import numpy as np

import style
from style import COLOURS, INK, PALE, label_ends, rows

PEERS = pathlib.Path(__file__).absolute().parent.parent / "bench" / "peers.csv"


def draw_beam(solution, mine, out):
    cantilever, beam = mine or solution
    at = {blocks: rows(cantilever, blocks=blocks, start="cold", iterations=30)["sag_m"][0]
          for blocks in ("3+3", "6x6")}
    figure, (left, right) = style.figure(
        f"Ten welded cubes, 30 iterations: the centre of the last one sags {at['3+3']:.2f} m "
        f"solved as 3+3, {at['6x6']:.2f} m as 6x6", 2)
    for blocks, colour, marker in (("3+3", COLOURS[0], "o"), ("6x6", COLOURS[1], "s")):
        curve = rows(beam, blocks=blocks, iterations=30)
        left.plot(curve["time_s"], curve["sag_m"], color=colour, label=blocks, linewidth=1.2)
        if mine:
            theirs = rows(solution[1], blocks=blocks, iterations=30)
            left.plot(theirs["time_s"], theirs["sag_m"], color=INK, linewidth=0.9, dashes=(4, 2),
                      label="_")
        part = rows(cantilever, blocks=blocks, start="cold")
        right.plot(part["iterations"], part["sag_m"], color=colour, marker=marker, label=blocks)
    peers = rows(style.read_csv(PEERS, ["tip_error_m"], ["engine", "scene"]), scene="beam")
    for name, sag in zip(peers["engine"], peers["tip_error_m"]):
        right.axhline(sag, color=PALE, linewidth=0.8, dashes=(2, 2))
        right.text(0.98, sag * 1.04, f"{name}, its defaults", ha="right", fontsize=8, color=PALE,
                   transform=right.get_yaxis_transform())
    left.invert_yaxis()
    left.set(xlabel="time  [s]", ylabel="tip below its start  [m]",
             title="30 iterations, cold" + (", yours; dashed: the solution" if mine else ""))
    right.set(xscale="log", yscale="log", xlabel="iterations", ylabel="sag of the tip  [m]",
              title="by the number of iterations")
    style.plain_log(right.xaxis)
    style.plain_log(right.yaxis)
    label_ends(left)
    label_ends(right)
    style.save(figure, out / "05_beam")


def draw_anchor(solution, mine, out):
    table = mine or solution
    apart, whole = rows(table, blocks="3+3"), rows(table, blocks="6x6")
    far = apart["lever_m"].argmax(), whole["lever_m"].argmax()
    figure, ax = style.figure(
        "A fixed joint solved as one block of six rows leaves "
        f"{abs(100 * whole['measured'][far[1]]):.0f} % of the error, as two blocks of three up to "
        f"{100 * apart['measured'][far[0]]:.3g} %")
    lever = np.linspace(0, 10, 300)
    ax.plot(lever, lever ** 2 / (1 / 6 + lever ** 2), color=INK, linewidth=1, dashes=(4, 2),
            label="_")
    ax.text(1.35, 0.86, "dashed: derived, $m r^2/(i + m r^2)$", fontsize=8.5, va="top")
    ax.plot(apart["lever_m"], apart["measured"], color=COLOURS[0], marker="o", linestyle="none",
            label="two blocks,\none iteration")
    ax.plot(apart["lever_m"], apart["left_after_30"], color=COLOURS[2], marker="^", zorder=4,
            label="two blocks,\n31 iterations")
    ax.plot(whole["lever_m"], whole["measured"], color=COLOURS[1], marker="s",
            label="one block,\none iteration")
    ax.set(xlabel="distance of the anchor from the cube's centre  [m]",
           ylabel="what is left of the velocity error  [1]", ylim=(-0.04, 1.04), xlim=(0, 10.2))
    label_ends(ax)
    style.save(figure, out / "05_anchor")


def draw_break(solution, mine, out):
    table = mine or solution
    held = table["broken"] == 0
    pull = table["pull_n"][held]
    figure, ax = style.figure(
        f"The weld at the wall breaks at {pull.max():.0f} N: its load follows statics until then")
    ax.plot(pull, table["wall_nm"][held], color=COLOURS[0 if mine else 1], linewidth=3, alpha=0.8,
            label="measured" + (", yours" if mine else ""))
    ax.plot(pull, table["statics_nm"][held], color=INK, linewidth=1, dashes=(4, 2),
            label="statics")
    ax.axhline(table["strength_nm"][0], color=PALE, linewidth=0.8)
    ax.text(0.02, table["strength_nm"][0] + 2, "its strength", color=PALE, fontsize=8.5,
            transform=ax.get_yaxis_transform())
    ax.set(xlabel="pull at the tip  [N]", ylabel="torque at the wall  [N m]", ylim=(0, 175))
    label_ends(ax)
    style.save(figure, out / "05_break")


def tables(folder, command):
    cantilever = style.read_csv(folder / "cantilever.csv", ["iterations", "sag_m"],
                                ["blocks", "start"], command)
    beam = style.read_csv(folder / "beam.csv", ["iterations", "time_s", "sag_m"], ["blocks"],
                          command)
    anchor = style.read_csv(folder / "anchor.csv", ["lever_m", "measured", "left_after_30"],
                            ["blocks"], command)
    breaking = style.read_csv(folder / "breaking.csv", ["pull_n", "wall_nm", "statics_nm",
                                                        "strength_nm", "broken"], (), command)
    return (cantilever, beam), anchor, breaking


if __name__ == "__main__":
    style.run(lambda: style.chapter(5, tables, (draw_beam, draw_anchor, draw_break),
                                    result=draw_anchor))
