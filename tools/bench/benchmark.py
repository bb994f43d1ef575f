"""Error against run time, and the cost of a joint as a scene grows: runs, draws, tells the best."""
import time

from base import house
from pictures import figures
from bench.measuring import read, run_bench, tell

PROGRAM = "bench/work_precision"
UNITS = {"gap_rms_m": ("gap RMS", 1000, "mm"), "gap_max_m": ("largest gap", 1000, "mm"),
         "tip_error_m": ("tip error", 1000, "mm"), "sideways_m": ("sideways", 1, "m")}
MOST_OF_A_FRONT = 4  # points that are printed of it


def scenes_of(rows):
    """The rows of every scene, size and kind of number, in the order of the table."""
    found = {}
    for row in rows:
        found.setdefault((row["scene"], row["chains"], row["real"]), []).append(row)
    return found


def called(row):
    iterations = row["iterations"] + (f" x {row['substeps']}" if row["substeps"] != "1" else "")
    return f"{row['solver']}, {row['setting']}, {iterations}"


def microseconds(row):
    return float(row["us_per_step"])


def print_fastest(scenes):
    """Of every scene the fastest run whose gaps stay below 1 % of a link, without more energy."""
    print("\nthe fastest that holds 1 % of a link (largest gap), and plain cold iterations beside "
          "it:")
    print(f"  {'scene':10} {'chains':>6} {'real':7} {'step [us]':>10} {'cold [us]':>10}  "
          "setting, iterations")
    for (scene, chains, real), rows in scenes.items():
        if len({(row["solver"], row["setting"]) for row in rows}) < 2:
            continue
        held = [row for row in rows if row["status"] == "ok"]
        cold = [row for row in held if row["setting"] == "cold"]
        best = min(held, key=microseconds, default=None)
        plain = f"{min(map(microseconds, cold)):10.1f}" if cold else f"{'-':>10}"
        print(f"  {scene:10} {chains:>6} {real:7} "
              + (f"{microseconds(best):10.1f} {plain}  {called(best)}" if best
                 else f"{'-':>10} {plain}  none"))


def print_fronts(scenes):
    """Of every scene what nothing beats in both: at most a few points, the ends among them."""
    print("\nthe front of every scene: nothing measured is both faster and better (float)")
    for (scene, chains, real), rows in scenes.items():
        for measure in rows[0]["measures"].split("+") if real == "float" else []:
            front = sorted((row for row in rows if measure in row["fronts"].split("+")),
                           key=microseconds)
            if len(rows) < 10 or not front:
                continue
            last, most = len(front) - 1, min(MOST_OF_A_FRONT, len(front))
            words, factor, unit = UNITS[measure]
            print(f"  {scene}, {chains} chain{'s' * (chains != '1')}, {words}:")
            for k in sorted({round(i * last / max(1, most - 1)) for i in range(most)}):
                size = factor * float(front[k][measure])
                print(f"    {microseconds(front[k]):9.1f} us a step {size:9.3g} {unit:2}  "
                      f"{called(front[k])}")


def print_scaling():
    """What a joint costs in a thousand and in a hundred thousand."""
    rows = [row for row in read(figures.SCALING) if row["iterations"] == "30"]
    sizes = sorted({int(row["joints"]) for row in rows})
    print("\ntime of a joint and step [ns], 30 iterations, float, by the number of "
          "joints;\ngrowth; memory of a joint [bytes]:")
    print(f"  {'solver':26}" + "".join(f"{size:>10,}" for size in sizes)
          + f"{'growth':>9}{'bytes':>8}")
    for solver, setting in dict.fromkeys((row["solver"], row["setting"]) for row in rows):
        line = {int(row["joints"]): row for row in rows
                if (row["solver"], row["setting"]) == (solver, setting)}
        cost = {size: float(row["ns_per_joint_step"]) for size, row in line.items()}
        print(f"  {solver + ', ' + setting:26}"
              + "".join(f"{cost[size]:10.0f}" if size in cost else f"{'-':>10}" for size in sizes)
              + f"{cost[sizes[-1]] / cost[sizes[1]]:9.2f}"
              + f"{float(line[sizes[-1]]['bytes_per_joint'] or 'nan'):8.0f}")
    print(f"  growth: a joint among {sizes[-1]:,} against one among {sizes[1]:,}")


def main(options):
    """With options the program's own table alone."""
    print("error against run time: about six minutes; leave the machine alone meanwhile",
          flush=True)
    began = time.time()
    house.must_build(["work_precision", "work_precision_float", "scaling_float"])
    run_bench("work_precision_float", options)
    run_bench("work_precision", ["--append", *options])
    if not options:
        run_bench("scaling_float", [], figures.SCALING)
    took = time.time() - began
    scenes = scenes_of(read(figures.TABLE))
    print_fastest(scenes)
    print_fronts(scenes)
    if not options:
        print_scaling()
    print()
    house.progress("drawing")
    made = figures.draw("work_precision.py", "--csv", figures.TABLE, "--peers", figures.PEERS)
    made += [] if options else figures.draw("scaling.py", "--csv", figures.SCALING)
    house.progress_done()
    print(f"measuring took {took / 60:.1f} minutes")
    return tell(made, *([figures.TABLE] if options else [figures.TABLE, figures.SCALING]))
