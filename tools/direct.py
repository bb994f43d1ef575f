"""The direct solver against thirty iterations, on every scene, all in one run."""
import csv

import figures
import house
from measuring import run_bench


def print_table():
    """A line a scene and method; times are told against thirty iterations in the same run."""
    with open(figures.DIRECT, newline="") as file:
        rows = list(csv.DictReader(file))
    print(f"{'scene':18} {'real':7} {'method':9} {'us a step':>10} {'of si30':>8} {'gap m':>9} "
          f"{'tip m':>9} {'energy':>9} {'held':>6}  status")
    before = ""
    for row in rows:
        name = "" if row["scene"] == before else row["scene"]
        before = row["scene"]
        tip = f"{float(row['tip_error_m']):9.2g}" if row["tip_error_m"] else f"{'-':>9}"
        print(f"{name:18} {row['real']:7} {row['method']:9} {float(row['us_per_step']):10.1f} "
              f"{float(row['ratio_to_si30']):8.2f} {float(row['gap_max_m']):9.1e} {tip} "
              f"{float(row['energy_drift']):9.1e} {row['held']:>3}/{row['of']:2}  {row['status']}")
    print("\nvelocity: one exact solve a step; shake: positions too; stiff: shake, stiffness 8;"
          "\nrk4: Runge-Kutta; si30: Sequential Impulses, 30 iterations; chapter7: its loop on"
          "\nlanes, 20 iterations, omega 1.9. A line tells the worst of its runs, and the time of "
          "the first.")


def main():
    print("the direct solver: about four minutes; leave the machine alone meanwhile", flush=True)
    house.must_build(["direct", "direct_float"])
    run_bench("direct", [], figures.DIRECT)
    run_bench("direct_float", ["--append", "1"], figures.DIRECT)
    print_table()
    print()
    for path in figures.draw_direct():
        print(house.short(path))
    print(f"the table: {house.short(figures.DIRECT)}")
    return 0
