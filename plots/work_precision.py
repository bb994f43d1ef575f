#!/usr/bin/env python3
"""Draws error against run time, one figure a scene, and one over all variants of a scene.

work_precision.py --csv out/work_precision.csv --out DIR
"""
import re

import numpy as np

import style
from style import COLOURS, INK, PALE

NUMBERS = ["chains", "iterations", "substeps", "warm", "us_per_step", "gap_rms_m", "tip_error_m"]
WORDS = ["scene", "solver", "setting", "real", "status"]
WELL = ("ok", "soft")           # full markers; all else is hollow and named
LOST = ("nan", "exploded")      # their size says nothing: drawn at the upper edge
FLOOR = 9.81 / 60 * 1.0 / 2     # g h t / 2 [m], h = 1/60 s, t = 1 s: semi-implicit Euler's own
PANELS = (("gap_rms_m", "gap, RMS over the joints  [mm]"),
          ("tip_error_m", "error of the tip after 1 s  [mm]"))
AROUND = [(0, 9), (0, -9), (1, 6), (-1, -6), (1, -6), (-1, 6), (1, 0), (-1, 0), (0, 16), (0, -16),
          (1, 14), (-1, -14), (1, -14), (-1, 14)]  # side that a label stands on, height [points]


def lines_of(rows, by):
    """Rows grouped by some of their fields, each group sorted by iterations and substeps."""
    groups = {}
    for row in rows:
        groups.setdefault(tuple(row[name] for name in by), []).append(row)
    return {key: sorted(group, key=lambda row: (row["substeps"], row["iterations"]))
            for key, group in groups.items()}


def settings_of(rows):
    """The lines of a figure: label and rows; what all share is left out of the label."""
    by = ("solver", "setting", "chains", "warm", "real")
    varies = [name for name in ("solver", "setting", "chains")
              if len({row[name] for row in rows}) > 1]
    out = []
    for group in lines_of(rows, by).values():
        row = group[0]
        said = [f"{row[name]:g} chains" if name == "chains" else row[name] for name in varies]
        out.append((", ".join([*said, "warm" if row["warm"] else "cold", row["real"]]), group))
    return out


def limits(values):
    """What a log axis has to show of these values: at least a decade."""
    low, high = np.multiply(style.extent(values), (1 / 1.6, 1.8))
    wider = max(1.0, np.sqrt(10 * low / high))
    return low / wider, high * wider


def draw_line(ax, name, label, group, colour, dashed):
    """One setting: full markers where it holds, hollow ones where it does not."""
    low, high = ax.get_ylim()
    lost = [row["status"] in LOST or not np.isfinite(row[name]) for row in group]
    x = np.array([row["us_per_step"] for row in group])
    y = np.clip([high if gone else 1000 * row[name] for row, gone in zip(group, lost)], low, high)
    line, = ax.plot(x, np.where(lost, np.nan, y), color=colour, label=label,
                    linewidth=1.2 if dashed else 1.6, dashes=(4, 2) if dashed else (None, None))
    points = []
    for i, row in enumerate(group):
        well = row["status"] in WELL
        ax.plot(x[i], y[i], "s" if dashed else "o", label="_", clip_on=False, color=colour,
                zorder=3 if dashed else 4, markersize=6.5 if dashed else 5.5,
                markerfacecolor=colour if well else "white",
                markeredgecolor="white" if well and not dashed else colour)
        new = i == 0 or group[i - 1]["status"] != row["status"]
        count = f"{row['iterations']:g}" + (f"x{row['substeps']:g}" if row["substeps"] > 1 else "")
        points.append((x[i], y[i], count, row["status"] if new and not well else "", colour))
    return line, points


def drawn_already(ax):
    """Places that a label should leave free: lines, markers, leaders [pixels]."""
    ink = []
    for line in ax.lines:
        at = ax.transData.transform(line.get_xydata())
        for a, b in zip(at, at[1:]):
            ink += list(a + (b - a) * np.linspace(0, 1, 60)[:, None])
        if line.get_marker() != "None":
            ink += [at[0] + (dx, dy) for dx in (-5, 0, 5) for dy in (-5, 0, 5)]
    for text in ax.texts:
        a, b = ax.transAxes.transform([text.xy, text.xyann])
        ink += list(a + (b - a) * np.linspace(0, 1, 60)[:, None])
    ink = np.array(ink)
    return ink[np.isfinite(ink).all(axis=1)]


def label_points(ax, points, name_status):
    """Writes the iterations beside the points wherever there is room, the named ones first."""
    ax.figure.canvas.draw()
    renderer, inside, ink = ax.figure.canvas.get_renderer(), ax.bbox, drawn_already(ax)
    taken, done = [], []
    for x, y, count, status, colour in sorted(points, key=lambda point: not point[3]):
        at = ax.transData.transform((x, y))
        if any(key == (count, colour) and np.hypot(*(at - other)) < 16 for key, other in done):
            continue  # double and float at one place
        words = f"{count} {status}" if status and name_status else count
        text = ax.annotate(words, (x, y), xytext=(0, 0), textcoords="offset points", va="center",
                           ha="center", color=colour, fontsize=8)
        aside = text.get_window_extent(renderer).width / 2 / ax.figure.dpi * 72 + 5
        for side, height in AROUND:
            text.set_position((side * aside, height))
            box = text.get_window_extent(renderer)
            covered = ((ink > box.min) & (ink < box.max)).all(axis=1).any()
            if not covered and not any(box.overlaps(other) for other in taken) and \
                    (inside.min <= box.min).all() and (box.max <= inside.max).all():
                taken.append(box)
                done.append(((count, colour), at))
                break
        else:
            text.remove()


def draw_figure(title, series, path):
    """Two panels, gap and tip; `series` is a list of label, rows, colour, dashed."""
    rows = [row for _, group, _, _ in series for row in group]
    panels = [panel for panel in PANELS
              if panel[0] == "gap_rms_m" or any(np.isfinite(row[panel[0]]) for row in rows)]
    figure, axes = style.figure(title, len(panels), squeeze=False)
    states = {row["status"] for row in rows}
    drawn = []
    for ax, (name, words) in zip(axes[0], panels):
        floor = [1000 * FLOOR] if name == "tip_error_m" else []
        sizes = [1000 * row[name] for row in rows if row["status"] not in LOST]
        ax.set(xscale="log", yscale="log", xlabel="time of a step  [µs]", ylabel=words,
               xlim=limits([row["us_per_step"] for row in rows]), ylim=limits(sizes + floor))
        drawn.append([draw_line(ax, name, *one) for one in series])
        if floor:
            ax.plot(ax.get_xlim(), floor * 2, color=INK, linewidth=1, dashes=(2, 2),
                    label=f"floor of the step:\ng h t / 2 = {floor[0]:.0f} mm")
        style.plain_log(ax.xaxis)
        style.plain_log(ax.yaxis)
    bad = ", ".join(sorted(states - set(WELL)))
    axes[0, 0].set_title("numbers: iterations" + f"; hollow: {bad}" * bool(bad), color=PALE,
                         fontsize=8.5)
    style.label_ends(axes[0, -1], size=8)
    for ax, lines in zip(axes[0], drawn):
        label_points(ax, [point for _, points in lines for point in points], len(states) > 1)
    style.save(figure, path)


# ---- what the figures are of ---------------------------------------------------------------------

def size(row):
    """The gap in words."""
    gap = 1000 * row["gap_rms_m"]
    return f"{gap:.0f}" if 100 <= gap < 1e6 else f"{gap:.3g}"


def slug(scene):
    return "work_precision_" + re.sub(r"[^A-Za-z0-9]+", "_", scene).strip("_")


def one_scene(scene, rows, out):
    """Every setting of one scene."""
    settings = settings_of(rows)
    colours, series = {}, []
    for label, group in settings:
        row = group[0]
        colour = colours.setdefault((row["solver"], row["setting"], row["chains"], row["warm"]),
                                    COLOURS[len(colours) % len(COLOURS)])
        series.append((label, group, colour, row["real"] == "float"))
    label, group = settings[0]
    first, last = group[0], group[-1]
    draw_figure(f"{scene}: {first['iterations']:g} to {last['iterations']:g} iterations take "
                f"{last['us_per_step'] / first['us_per_step']:.0f} times as long, gap "
                f"{size(first)} to {size(last)} mm ({label})",
                series, out / slug(scene))


def all_variants(name, scenes, out):
    """One setting, the first of the table, on every variant of a scene."""
    series, label = [], ""
    for i, (scene, rows) in enumerate(scenes.items()):
        label, group = settings_of(rows)[0]
        series.append((scene[len(name):].strip(), group, COLOURS[i % len(COLOURS)], False))
    (one, first, _, _), (other, last, _, _) = series[0], series[-1]
    count = first[-1]["iterations"]
    same = next((row for row in last if row["iterations"] == count), last[-1])
    draw_figure(f"{name} ({label}): {count:g} iterations leave {size(first[-1])} mm at {one}, "
                f"{size(same)} mm at {other}", series, out / slug(name))


def main():
    given = style.arguments("Draws error against run time.",
                            csv="the table that ./wb bench writes", out="folder of the figures")
    table = style.read_csv(given.csv, NUMBERS, WORDS, "./wb bench")
    rows = [dict(zip(table, values)) for values in zip(*table.values())]
    if not all(row["us_per_step"] > 0 for row in rows):
        style.trouble(f"{given.csv}: a time of a step is not above 0: ./wb bench makes it anew")
    scenes, families = {}, {}
    for row in rows:
        scenes.setdefault(row["scene"], []).append(row)
        families.setdefault(row["scene"].split()[0], {})[row["scene"]] = scenes[row["scene"]]
    for scene, chosen in scenes.items():
        one_scene(scene, chosen, given.out)
    for name, variants in families.items():
        if len(variants) > 1:
            all_variants(name, variants, given.out)


if __name__ == "__main__":
    style.run(main)
