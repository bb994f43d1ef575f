#!/usr/bin/env python3
"""Draws the stability suite: four maps of methods against values, and where rounding begins.

stability.py --csv out/stability.csv --out DIR
"""
import matplotlib.pyplot as plt
import numpy as np

import style
from style import COLOURS, INK, PALE, named

NUMBERS = ["value", "expected", "measured", "gap_rms_m", "gap_max_m", "criterion"]
WORDS = ["case", "method", "real", "parameter", "status"]
# Light, so that dark words stand on them; what is lost is dark.
FILL = {"ok": named("ok"), "soft": named("soft"), "torn": named("torn"),
        "energy+": named("gained"), "exploded": named("vermilion"), "nan": INK}
WORD = {"exploded": "white", "nan": "white"}
HOLDS = ("ok", "soft")
GAINS = ("energy+", "exploded", "nan")
EPSILON = {"double": 2.0 ** -52, "float": 2.0 ** -23}


def chosen(rows, parameter, real="double"):
    """The lines of one parameter: {(method, value): row}, methods and values in their order."""
    found = {(r["method"], r["value"]): r for r in rows
             if r["parameter"] == parameter and r["real"] == real}
    return (found, list(dict.fromkeys(method for method, _ in found)),
            sorted({value for _, value in found}))


def size(metres):
    """A gap in words."""
    if not np.isfinite(metres):
        return ""
    if metres < 1:
        thousandths = 1000 * metres
        return f"{thousandths:.0f} mm" if thousandths >= 10 else f"{thousandths:.2g} mm"
    return f"{metres:.0f} m" if 10 <= metres < 1e4 else f"{metres:.2g} m".replace("e+", "e")


def fraction(h):
    return f"1/{round(1 / h)}"


def furthest(table, method, values, good):
    """The last of the values up to which a method is good throughout, or None."""
    last = None
    for value in values:
        if table[method, value]["status"] not in good:
            break
        last = value
    return last


# ---- the maps ------------------------------------------------------------------------------------

def draw_cell(ax, column, line, row, other):
    """Colour, word and gap of one run; where float comes to another word, that too."""
    status = row["status"]
    ax.add_patch(plt.Rectangle((column - 0.5, line - 0.5), 1, 1, facecolor=FILL[status],
                               edgecolor="white", linewidth=2))
    words = f"{status}\n{size(row['gap_max_m'])}".strip()
    if other and other["status"] != status:
        words += f"\nf: {other['status']}"
    ax.text(column, line, words, ha="center", va="center", fontsize=7.5, linespacing=1.15,
            color=WORD.get(status, INK))
    if row["criterion"] == 0:
        ax.add_patch(plt.Polygon([(column + 0.47, line - 0.45), (column + 0.47, line - 0.17),
                                  (column + 0.35, line - 0.45)],
                                 color=WORD.get(status, INK), linewidth=0))


def draw_map(rows, parameter, link, label, title, path,
             value_words=lambda value: f"{value:g}"):
    """Methods down, values across; a link is so many metres long."""
    table, methods, values = chosen(rows, parameter)
    in_float = chosen(rows, parameter, "float")[0]
    figure, ax = plt.subplots(figsize=(style.WIDTH, 1.3 + 0.43 * len(methods)),
                              layout="constrained")
    style.entitle(figure, title)
    for line, method in enumerate(methods):
        for column, value in enumerate(values):
            if (method, value) in table:
                draw_cell(ax, column, line, table[method, value], in_float.get((method, value)))
    ax.set(xlim=(-0.5, len(values) - 0.5), ylim=(len(methods) - 0.5, -0.5), xlabel=label)
    ax.set_xticks(range(len(values)), [value_words(value) for value in values])
    ax.set_yticks(range(len(methods)), methods)
    ax.tick_params(length=0)
    ax.grid(False)
    for side in ("left", "bottom"):
        ax.spines[side].set_visible(False)
    note = (f"largest gap; ok: below 1 % of a link ({size(link / 100)}), soft: below half, "
            "torn: above")
    more = ["energy+: over 2 % of energy gained, exploded: over 100 %"]
    if any(row["criterion"] == 0 for row in table.values()):
        more.append(r"corner: warm and $\rho^k (1+\beta) \geq 1$")
    if any(in_float[key]["status"] != row["status"] for key, row in table.items()
           if key in in_float):
        more.append("f: float, where it comes to another word than double")
    ax.set_title("\n".join([note] + ["; ".join(more)] * bool(more)), color=PALE, fontsize=8.2,
                 loc="right", multialignment="left")
    style.save(figure, path)


def mass_ratio(rows, out):
    parameter = "end mass / link mass"
    table, methods, values = chosen(rows, parameter)
    holds = {method: furthest(table, method, values, HOLDS) or 0 for method in methods}
    best = max(methods, key=holds.get)
    others = max(holds[method] for method in methods if "substeps" not in method)
    draw_map(rows, parameter, 0.5, "mass of the end / mass of a link (20 links on balls let go "
             "level, h = 1/60 s, 5 s)",
             f"Mass ratio: of these, nothing without substeps holds beyond {others:g} to 1, "
             f"{best} up to {holds[best]:g} to 1", out / "stability_mass_ratio",
             lambda value: rf"$10^{{{np.log10(value):.0f}}}$" if value >= 1e4 else f"{value:g}")


def step(rows, out):
    parameter = "step [s]"
    table, methods, values = chosen(rows, parameter)

    def coarsest(method):
        return furthest(table, method, values, ("ok",)) or 0
    best = max(methods, key=coarsest)
    plain = "cold 30" if "cold 30" in methods else methods[0]
    said = [f"{method} from {fraction(coarsest(method))} s on" if coarsest(method) else
            f"{method} never" for method in (plain, best)]
    draw_map(rows, parameter, 1.5, "step h [s] (chain of 20 hinges let go level, 5 s)",
             f"Step: gaps below 1 % of a link with {said[0]}, with {said[1]}",
             out / "stability_step", fraction)


def beta(rows, out):
    parameter = "beta, chain of 20 hinges"
    table, methods, values = chosen(rows, parameter)

    def without_gain(method):
        last = None
        for value in values:
            if table[method, value]["status"] in GAINS:
                break
            last = value
        return f"up to {last:g}" if last else "nowhere"
    pair = [method for method in ("cold 30", "warm 30", "warm 3") if method in methods]
    said = ", ".join(f"{method} {without_gain(method)}" for method in pair)
    draw_map(rows, parameter, 1.5, r"$\beta$ (chain of 20 hinges let go level, h = 1/60 s, 5 s)",
             f"Beta without a gain of energy: {said}", out / "stability_beta")


def length(rows, out):
    parameter = "links of the chain"
    table, methods, values = chosen(rows, parameter)
    gains = [value for value in values if table["warm 30", value]["status"] in GAINS]
    warm = f"warm 30 gains energy from {gains[0]:g} links on" if gains else "warm 30 holds all"
    at_end = table["cold 30", values[-1]]
    best = min(methods, key=lambda method: table[method, values[-1]]["gap_max_m"])
    draw_map(rows, parameter, 1.5, "links of the chain (hinges, let go level, h = 1/60 s, 5 s: "
             "from 100 on it is still falling then)",
             f"Length: {warm}; at {values[-1]:g} cold 30 leaves {size(at_end['gap_max_m'])}, "
             f"{best} {size(table[best, values[-1]]['gap_max_m'])}", out / "stability_length")


# ---- where rounding begins -----------------------------------------------------------------------

def draw_steps(ax, rows):
    """Gap against step: one hinge with its formula, and the chain with substeps."""
    least = {}
    for real, dashes, colour in (("double", (None, None), COLOURS[1]), ("float", (4, 2),
                                                                         COLOURS[0])):
        table, methods, values = chosen(rows, "step of one hinge [s]", real)
        if not table:
            continue
        values = values[::-1]
        gaps = [table[methods[0], value]["measured"] for value in values]
        least[real] = min(gaps)
        ax.plot(values, style.visible(gaps), "o-", color=colour, dashes=dashes, markersize=4,
                label=f"one hinge, {real}")
        if real == "double":
            ax.plot(values, [table[methods[0], value]["expected"] for value in values],
                    color=INK, linewidth=1, dashes=(1, 2),
                    label=r"$\omega^2 r h^2 / (2\beta)$", zorder=5)
        table, _, values = chosen(rows, "step [s]", real)
        values = values[::-1]
        name = "16 substeps of 2"
        ax.plot(values, [table[name, value]["gap_max_m"] for value in values], "s-",
                color=COLOURS[2], dashes=dashes, markersize=3.5,
                label=f"20 hinges, 16\nsubsteps of 2, {real}")
    ax.set(xscale="log", yscale="log", xlabel="step h  [s], finer to the right",
           ylabel="largest gap  [m]")
    ax.invert_xaxis()
    style.label_ends(ax, size=8)
    return least


def draw_hanging(ax, rows):
    """Gap at rest against the lever, and four last digits of the lever."""
    ends = []
    for real, marker, colour in (("double", "o", COLOURS[1]), ("float", "s", COLOURS[0])):
        found = sorted((r["value"], r["measured"]) for r in rows if r["real"] == real
                       and r["parameter"] == "lever [m]" and r["method"] == "hanging")
        if not found:
            continue
        levers, gaps = np.array(found).T
        bound = 4 * EPSILON[real] * levers
        ax.plot(levers, bound, color=colour, linewidth=1, dashes=(1, 2), label=f"4 ε r, {real}")
        ax.plot(levers, style.visible(gaps), marker, color=colour, markersize=5, label="_")
        ends.append((real, levers, gaps, colour))
    ax.set(xscale="log", yscale="log", xlabel="lever r from joint to centre  [m]",
           ylabel="largest gap while it hangs  [m]")
    low = ax.get_ylim()[0] / 300
    ax.set_ylim(bottom=low)
    for real, levers, gaps, colour in ends:
        zero = [lever for lever, gap in zip(levers, gaps) if gap == 0]
        if zero:
            ax.plot(zero, [8 * low] * len(zero), "o", color=colour, markerfacecolor="white",
                    clip_on=False, label="_")
            ax.annotate(f"{real}: exactly 0", (zero[0], 8 * low), xytext=(0, 7), ha="left",
                        textcoords="offset points", fontsize=8, color=colour)
    style.label_ends(ax, size=8)


def floor(rows, out):
    figure, axes = style.figure("", 2)
    least = draw_steps(axes[0], rows)
    draw_hanging(axes[1], rows)
    title = "The gap follows the square of the step"
    if "float" in least:
        title = (f"Rounding: float ends at a gap of {1e6 * least['float']:.1f} µm, double still "
                 f"follows the square of the step at {1e6 * least['double']:.2g} µm")
    style.entitle(figure, title)
    axes[0].set_title("let go level", color=PALE, fontsize=8.5)
    axes[1].set_title("one ball joint, hanging for 10 s", color=PALE, fontsize=8.5)
    style.save(figure, out / "stability_floor")


def main():
    given = style.arguments("Draws the stability suite.",
                            csv="the table that ./wb bench --stability writes",
                            out="folder of the figures")
    table = style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench --stability")
    rows = [dict(zip(table, values)) for values in zip(*table.values())]
    try:
        for draw in (mass_ratio, step, beta, length, floor):
            draw(rows, given.out)
    except (KeyError, IndexError, ValueError) as problem:
        style.trouble(f"{given.csv} lacks a part of the maps ({problem}): "
                      "./wb bench --stability makes it anew")


if __name__ == "__main__":
    style.run(main)
