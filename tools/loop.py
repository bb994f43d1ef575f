"""The inner loop in its variants, all in one run: what a joint and sweep costs in each."""
import csv

import house
import show

LOOP = house.OUT / "loop.csv"


def print_table():
    """A line a variant; the ratio is against the textbook's in the same run."""
    with open(LOOP, newline="") as file:
        rows = [row for row in csv.DictReader(file) if row["iterations"] == "30"]
    print(f"{'variant':18} {'real':7} {'chains':>6} {'us a step':>10} {'ns a joint and sweep':>21} "
          f"{'textbook / this':>16} {'gap RMS mm':>11}")
    for row in rows:
        base = next(float(other["ns_per_joint_iteration"]) for other in rows
                    if other["variant"] == "textbook" and other["real"] == row["real"]
                    and other["chains"] == row["chains"])
        ns = float(row["ns_per_joint_iteration"])
        print(f"{row['variant']:18} {row['real']:7} {row['chains']:>6} "
              f"{float(row['us_per_step']):10.1f} {ns:21.2f} {base / ns:16.2f} "
              f"{1000 * float(row['gap_rms_m']):11.2f}")


def main():
    print("the inner loop in its variants: about a minute; leave the machine alone meanwhile",
          flush=True)
    house.must_build(["loop", "loop_float"])
    show.run_bench("loop_float", [], LOOP)
    show.run_bench("loop", ["--append", "1"], LOOP)
    print_table()
    print(f"\nthe table: {house.short(LOOP)}")
    return 0
