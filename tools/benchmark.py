"""Error against run time: runs the benchmark in double and float, draws, and says what it costs."""
import csv
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import house
import show

JOINTS, STEPS, FEW, MANY = 99, 20, 10, 30  # of the run whose instructions are counted


def instructions(program):
    """Instructions of one joint and iteration: two counts of sweeps, their difference."""
    counts = []
    for iterations in (FEW, MANY):
        with tempfile.TemporaryDirectory() as folder:
            result = subprocess.run(
                ["valgrind", "--tool=callgrind", f"--callgrind-out-file={Path(folder) / 'out'}",
                 house.BUILD / "bench" / program, "--only-steps", str(STEPS),
                 "--iterations", str(iterations)], capture_output=True, text=True)
        match = re.search(r"Collected : (\d+)", result.stderr)
        if result.returncode != 0 or not match:
            raise house.Trouble("valgrind could not count: " + result.stderr.strip()[-300:])
        counts.append(int(match[1]))
    return (counts[1] - counts[0]) / (JOINTS * STEPS * (MANY - FEW))


def print_costs():
    """What one more iteration costs a joint, in time and where possible in instructions."""
    with open(show.TABLE, newline="") as file:
        rows = [r for r in csv.DictReader(file) if r["scene"] == "S1b" and r["warm"] == "0"]
    print("\none joint, one iteration (S1b, three rows, one block):")
    for real, program in (("double", "work_precision"), ("float", "work_precision_float")):
        times = sorted(float(r["ns_per_joint_iteration"]) for r in rows if r["real"] == real)
        line = f"  {real:7} {times[len(times) // 2]:6.1f} ns"
        if shutil.which("valgrind"):
            house.progress(f"counting instructions, {real}")
            line += f"   {instructions(program):6.1f} instructions"
            house.progress_done()
        print(line)
    if not shutil.which("valgrind"):
        print("  (no instruction counts: valgrind is not installed)")


def print_table():
    """The lines of the cubes' scene: error against run time."""
    with open(show.TABLE, newline="") as file:
        rows = list(csv.DictReader(file))
    print(f"{'scene':12} {'real':7} {'start':5} {'iter.':>5} {'us a step':>10} {'gap RMS mm':>11} "
          f"{'gap max mm':>11} {'tip error mm':>12} {'energy drift':>12}  status")
    for r in rows:
        print(f"{r['scene']:12} {r['real']:7} {'warm' if r['warm'] == '1' else 'cold':5} "
              f"{r['iterations']:>5} {float(r['us_per_step']):10.1f} "
              f"{1000 * float(r['gap_rms_m']):11.4g} {1000 * float(r['gap_max_m']):11.4g} "
              f"{1000 * float(r['tip_error_m']):12.4g} {float(r['energy_drift']):12.3g}  "
              f"{r['status']}")


def main():
    print("error against run time: about three minutes; leave the machine alone meanwhile",
          flush=True)
    house.must_build(["work_precision", "work_precision_float"])
    show.run_bench("work_precision", [])
    show.run_bench("work_precision_float", ["--append", "1"])
    print_table()
    print_costs()
    print()
    for path in show.draw("work_precision.py", "--csv", show.TABLE):
        print(house.short(path))
    print(f"the table: {house.short(show.TABLE)}")
    return 0
