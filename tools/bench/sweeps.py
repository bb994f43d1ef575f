"""Error against run time over the length of the step, with the published engines where they are
installed."""
from base import house
from pictures import figures
from bench.measuring import read, run_bench, tell
from bench.peers import machine

PROGRAM = "bench/sweeps"
TABLE = house.OUT / "sweeps.csv"
LEVELS = (1e-3, 1e-6)  # [m]


def soonest(rows, level):
    """The row that reaches this error in the shortest time."""
    reach = [row for row in rows if row["us_per_step"] and float(row["tip_error_m"]) <= level]
    return min(reach, key=cost, default=None)


def cost(row):
    """Processor time [ms] for a second of the scene."""
    return 1e-3 * float(row["us_per_step"]) * int(row["steps_per_s"])


def print_table():
    """For every scene and error the first engine and, if it is not ours, ours."""
    rows = read(TABLE)
    print(f"{'scene':18}{'error':>8}{'ms a second':>13}  engine, setting, steps per second")
    for scene in dict.fromkeys(row["scene"] for row in rows):
        mine = [row for row in rows if row["scene"] == scene]
        for level in LEVELS:
            for row in filter(None, (soonest(mine, level), soonest(
                    [row for row in mine if row["engine"] == "ours"], level))):
                print(f"{scene:18}{level:8.0e}{cost(row):13.3f}  {row['engine']}, "
                      f"{row['setting']}, {row['steps_per_s']}")


def main(options):
    print("error against run time over the length of the step: about five minutes; leave the "
          "machine alone meanwhile", flush=True)
    house.must_build(["sweeps"])
    run_bench("sweeps", ["--machine", machine(), *options], TABLE)
    print_table()
    return tell(figures.draw("sweeps.py", "--csv", TABLE, figures=house.OUT), TABLE)
