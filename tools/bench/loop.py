"""The inner loop in its variants, all in one run: what a joint and iteration costs in each."""
import csv

from base import house
from bench import instructions
from pictures import figures
from bench.measuring import read, run_bench, tell

PROGRAM = "bench/loop"
PER_ITERATION, PER_STEP = "instructions_per_joint_iteration", "instructions_per_joint_step"


def add_instructions():
    """Fills in the counts: of a joint and iteration, of a joint and step where it is known."""
    rows = read(figures.LOOP)
    counts = {(row["variant"], row["chains"]): row for row in instructions.table(
        house.BUILD / "bench" / "loop_float", "--count", "1")}
    for row in rows:
        if row["real"] != "float":
            continue
        count = counts[row["variant"], row["chains"]]
        row[PER_ITERATION] = f"{count['per_iteration']:.1f}"
        for iterations, at in (("few", "at_few"), ("many", "at_many")):
            if row["iterations"] == count[iterations]:
                row[PER_STEP] = f"{count[at]:.1f}"
    with open(figures.LOOP, "w", newline="") as file:
        writer = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def print_table():
    """A line a variant; the ratio is against the textbook's in the same run."""
    rows = [row for row in read(figures.LOOP) if row["iterations"] == "30"]
    print(f"{'':35}{'30 iterations':>13} {'one joint, one iteration':^34}")
    print(f"{'variant':22} {'real':7} {'chains':>6} {'a step [us]':>11} {'[ns]':>7} "
          f"{'textbook / this':>16} {'instructions':>13} {'gap RMS [mm]':>12}")
    for row in rows:
        base = next(float(other["ns_per_joint_iteration"]) for other in rows
                    if other["variant"] == "textbook" and other["real"] == row["real"]
                    and other["chains"] == row["chains"])
        ns = float(row["ns_per_joint_iteration"])
        print(f"{row['variant']:22} {row['real']:7} {row['chains']:>6} "
              f"{float(row['us_per_step']):11.1f} {ns:7.2f} {base / ns:16.2f} "
              f"{row[PER_ITERATION] or '-':>13} {1000 * float(row['gap_rms_m']):12.2f}")


def main(options):
    print("the inner loop in its variants: about three and a half minutes; leave the machine alone "
          "meanwhile", flush=True)
    house.must_build(["loop", "loop_float"])
    run_bench("loop_float", options, figures.LOOP)
    run_bench("loop", ["--append", "--rounds", "3", "--all-counts", "0", *options], figures.LOOP)
    if instructions.there():
        house.progress("counting instructions (float)")
        add_instructions()
        house.progress_done()
    print_table()
    if not instructions.there():
        print(f"\n{instructions.MISSING}")
    print()
    return tell(figures.draw_loop(), figures.LOOP)
