#!/usr/bin/env python3
"""Draws the figures of chapter 2: three rows against a block, the blow, and the swinging chain.

chapter_02.py --solution DIR [--mine DIR] --out DIR
chapter_02.py --solution DIR --result FILE.svg
"""
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm

import style
from chapter_01 import gap_figure
from style import COLOURS, INK, PALE, visible

ROWS = 3         # of a ball joint
SOLVED = 1e-10   # [m/s]; below it an iteration has nothing left to do
FAINTEST = 1e-3  # [m/s], end of the colour bar
COLOUR = {"rows": COLOURS[0], "block": COLOURS[1]}
NAME = {"rows": "three rows, one by one", "block": "one 3x3 block per joint"}


def tables(folder, command):
    def read(name, *columns):
        return style.read_csv(folder / f"{name}.csv", *columns, command=command)
    solve = {"iterations": read("iterations", ["iteration", "error_m_s"], ["method"]),
             "system": read("system", ["row", "column", "value"])}
    return (solve, read("blow", ["iteration", "joint", "error_m_s"], ["order"]),
            read("chain", ["iterations", "time_s", "gap_rms_m"]))


# ---- rows against a block ------------------------------------------------------------------------

def matrix(system):
    """A = J M^-1 J^T from its table of entries."""
    n = int(max(system["row"].max(), system["column"].max())) + 1
    A = np.full((n, n), np.nan)
    A[system["row"].astype(int), system["column"].astype(int)] = system["value"]
    if n % ROWS or not np.isfinite(A).all():
        raise style.Trouble("system.csv does not hold a whole matrix of finite numbers, "
                            f"{ROWS} rows a joint: ./wb plot 2 makes it anew")
    return A


def predicted_rate(A, block):
    """Spectral radius of Gauss-Seidel's iteration matrix -(D+L)^-1 U, D in blocks of this size."""
    group = np.arange(len(A)) // block
    lower = np.where(group[:, None] >= group[None, :], A, 0)
    try:
        return float(np.abs(np.linalg.eigvals(np.linalg.solve(lower, lower - A))).max())
    except np.linalg.LinAlgError:
        raise style.Trouble("system.csv: a diagonal block has no inverse") from None


def errors(table, method):
    chosen = np.array(table["method"]) == method
    return table["iteration"][chosen], table["error_m_s"][chosen]


def decay(curve):
    """The curve until it is solved, and the factor of an iteration over the last third of it."""
    iteration, error = curve
    error = visible(error)
    floor = max(SOLVED, 300 * style.extent(error)[0])  # above rounding, in float too
    solved = np.flatnonzero(error < floor)
    end = int(solved[0]) if len(solved) and floor < error[0] else len(error) - 1
    first = 2 * end // 3
    ratio = (error[end] / error[first]) ** (1 / max(end - first, 1))
    return iteration[:end + 1], error[:end + 1], float(ratio)


def rows_or_block(solution, mine, out):
    A = matrix(solution["system"])
    found = {}
    for method, block in (("rows", 1), ("block", ROWS)):
        rate = predicted_rate(A, block)
        curve = decay(errors(solution["iterations"], method))
        found[method] = (curve, rate, decay(errors(mine["iterations"], method)) if mine else None)
        print(f"{method:6} predicted rho {rate:.6f}   measured {curve[2]:.6f}"
              + (f"   yours {found[method][2][2]:.6f}" if mine else ""))
    rows, block = found["rows"][0], found["block"][0]
    title = (f"After an iteration {100 * rows[2]:.0f} % of the error remain row by row, "
             f"{100 * block[2]:.0f} % with a block"
             if not mine else "Rows against a block: yours over the solution")
    figure, ax = style.figure(title)
    ax.set_yscale("log")
    ax.text(0.98, 0.96, "dashed: the solution" if mine else
            "$\\rho$: factor of an iteration\ndashed: predicted from $J M^{-1} J^T$",
            ha="right", va="top", color=PALE, transform=ax.transAxes)
    slower = max(found, key=lambda method: len(found[method][0][0]))
    for method, (curve, rate, own) in found.items():
        draw_decay(ax, method, curve, rate, own, method == slower)
    ax.set(xlabel="iteration", ylabel="error $|J V + b|$, RMS over the joints  [m/s]",
           xlim=(0, 1.15 * max(len(curve[0]) for curve in (rows, block))),
           ylim=np.multiply(style.extent(rows[1], block[1]), (0.3, 6)))
    style.save(figure, out / "02_rows_or_block")


def draw_decay(ax, method, curve, rate, own, above):
    """A measured curve, the predicted line through its end, and both numbers beside it."""
    iteration, error, ratio = curve
    colour = COLOUR[method]
    numbers = f"predicted $\\rho$ = {rate:.4f}\n"
    numbers += (f"the solution {ratio:.4f}\nyours {own[2]:.4f}" if own else
                f"measured $\\rho$ = {ratio:.4f}")
    if own:
        ax.plot(own[0], own[1], color=colour, linewidth=3.2, alpha=0.7)
        ax.plot(iteration, error, color=INK, linewidth=1.1, dashes=(4, 2))
    else:
        ax.plot(iteration, error, color=colour, linewidth=3.2, alpha=0.7)
        line = np.array([0, 1.03 * iteration[-1]])
        ax.plot(line, error[-1] * rate ** (line - iteration[-1]), color=INK, linewidth=1,
                dashes=(4, 2))
    place = int((0.45 if above else 0.72) * len(iteration))
    ax.annotate(f"{NAME[method]}\n{numbers}", (iteration[place], error[place]), color=colour,
                xytext=(10, 4) if above else (-10, -4), textcoords="offset points", fontsize=9,
                ha="left" if above else "right", va="bottom" if above else "top")


# ---- the blow ------------------------------------------------------------------------------------

def strip(table, order):
    """Errors of one order as an array [joint, iteration]."""
    chosen = np.array(table["order"]) == order
    iteration, joint = table["iteration"][chosen].astype(int), table["joint"][chosen].astype(int)
    out = np.zeros((joint.max(), iteration.max() + 1))
    out[joint - 1, iteration] = table["error_m_s"][chosen]
    return np.where(np.isfinite(out), out, 1e300)


def reached(errors_of):
    """Which joints the blow has reached at each iteration."""
    return np.maximum.accumulate(errors_of > 0, axis=1)


def crossing(errors_of):
    """Iterations until the blow has reached as many joints as it ever moves at once."""
    count = reached(errors_of).sum(axis=0)
    return int(np.argmax(count >= len(errors_of) - 1))


def blow(solution, mine, out):
    orders = list(dict.fromkeys(solution["order"]))
    sources = [("the solution", solution)] if not mine else [("yours", mine),
                                                              ("the solution", solution)]
    strips = {(who, order): strip(table, order) for who, table in sources
              for order in orders}
    needs = [crossing(strips["the solution", order]) for order in orders]
    title = "The blow is at joint 2 after " + ", after ".join(
        f"{need} iteration{'s' * (need != 1)} {order}" for need, order in zip(needs, orders))
    figure, axes = style.figure(title, len(orders), len(sources), sharex=True, sharey=True,
                                squeeze=False)
    last = max(np.nonzero((values >= FAINTEST).any(axis=0))[0].max(initial=0)
               for (who, _), values in strips.items() if who == "the solution")
    for row, (who, _) in zip(axes, sources):
        for ax, order in zip(row, orders):
            scale = draw_strip(ax, strips[who, order])
            way = f"from the {order.replace(' to ', ' to the ')}"
            ax.set_title(f"{way}: {who}" if mine else f"iterations {way}")
        row[0].set_ylabel("joint  (1 at the wall)")
    for ax in axes[-1]:
        ax.set(xlabel="iteration", xlim=(-0.5, last + 0.5))
    bar = figure.colorbar(scale, ax=axes, extend="min", aspect=25, pad=0.02)
    bar.set_label("remaining error of the joint  [m/s]")
    bar.outline.set(edgecolor=PALE, linewidth=0.7)
    style.save(figure, out / "02_blow")


def draw_strip(ax, values):
    joints, iterations = values.shape
    touched = reached(values)
    colours = style.plt.get_cmap("viridis").copy()
    colours.set_bad(style.EMPTY)
    colours.set_under("white")
    scale = ScalarMappable(LogNorm(FAINTEST, 1), colours)
    shown = np.ma.masked_array(np.clip(values, FAINTEST / 10, 1), ~touched)
    ax.imshow(colours(scale.norm(shown)), origin="lower", aspect="auto", interpolation="nearest",
              extent=(-0.5, iterations - 0.5, 0.5, joints + 0.5))
    ax.grid(False)
    ax.set(ylim=(0.5, joints + 0.5), yticks=[1, *range(5, joints + 1, 5)])
    describe(ax, values, touched)
    return scale


def describe(ax, values, touched):
    """Writes into the strip how far the blow gets in its iterations."""
    joints = len(touched)
    count = touched.sum(axis=0)
    if len(count) < 3 or count[1] == count[0] or count.max() < joints - 1:
        return
    first, need = count[1] - count[0], int(np.argmax(count >= joints - 1))
    if need > 2:  # a front: along it, in the part not reached
        ax.text(need / 2 - 0.4, joints / 2 - 0.4, rotation=-45, rotation_mode="anchor",
                s=f"{(count[need] - count[0]) / need:.2g} joint per iteration", ha="center",
                va="top",
                fontsize=9, transform_rotates_text=True)
        ax.text(0, joints * 0.1, "not reached yet:\nexactly 0", color=PALE, fontsize=8)
    else:
        ax.annotate("", (0, joints - first), (0, joints - 0.4),
                    arrowprops={"arrowstyle": "->", "color": INK, "linewidth": 1.2})
        ax.text(0.9, 0.2, "the first iteration\nreaches the wall", ha="right", fontsize=9,
                color="white", transform=ax.transAxes)
    for joint in (0, joints - 1):
        if (values[joint, 1:3] < FAINTEST).all() and touched[joint, 2]:
            ax.text(2, joint + 1, "solved last: exact", va="center", color=PALE, fontsize=8)


def chain(solution, mine, out):
    style.save(gap_figure("The chain", "joints", solution, mine), out / "02_chain")


if __name__ == "__main__":
    style.run(lambda: style.chapter(2, tables, (rows_or_block, blow, chain), result=rows_or_block))
