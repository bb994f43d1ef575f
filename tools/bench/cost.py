"""What a joint costs: rows, bytes and instructions of every kind of joint."""
import csv

from base import house
from bench import instructions

PROGRAM = "bench/cost"
COST = house.OUT / "cost.csv"
# What tests/bench/cost_test.py holds every build to.
KEPT = house.ROOT / "tests" / "bench" / "cost_table.csv"
COLUMNS = ["case", "rows", "bytes_per_joint", "instructions_per_joint_step", "solver", "real",
           "instructions_per_joint_iteration"]
PROGRAMS = ("cost_float", "cost")


def measure(build):
    """The table, as rows of texts: float first, every solver with every case."""
    rows = []
    for program in PROGRAMS:
        for row in instructions.table(build / "bench" / program):
            rows.append({**{name: row[name] for name in COLUMNS if name in row},
                         "instructions_per_joint_step": number(row["at_few"]),
                         "instructions_per_joint_iteration": number(row["per_iteration"])})
    return rows


def number(value):
    return "" if value is None else f"{value:.1f}"


def compiled_with(build):
    """Compiler, version, flags and processor of a build."""
    return (build / "compiled_with.txt").read_text().strip()


def write(path, rows, more=None):
    """`more`: columns that say the same in every row."""
    path.parent.mkdir(exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        writer = csv.DictWriter(file, [*COLUMNS, *(more or {})], lineterminator="\n")
        writer.writeheader()
        writer.writerows({**row, **(more or {})} for row in rows)


def print_table(rows):
    """A block for each solver and kind of number; the difference is to the plain hinge."""
    for key in dict.fromkeys((row["solver"], row["real"]) for row in rows):
        block = [row for row in rows if (row["solver"], row["real"]) == key]
        plain = next(row for row in block if row["case"] == "hinge")
        print(f"\n{key[0]}, {key[1]:17} {'rows':>4} {'bytes':>8} {'instructions a step':>20} "
              f"{'less the hinge':>15} {'an iteration':>12}")
        for row in block:
            a_step, base = row["instructions_per_joint_step"], plain["instructions_per_joint_step"]
            more = f"{float(a_step) - float(base):+.0f}" if a_step and row != plain else ""
            print(f"  {row['case']:26} {float(row['rows']):4.0f} "
                  f"{float(row['bytes_per_joint']):8.0f} {a_step:>20} {more:>15} "
                  f"{row['instructions_per_joint_iteration']:>12}")


def main(options):
    keep = options == ["--keep"]
    if options and not keep:
        raise house.Trouble(f"bench --cost {options[0]}: it takes --keep alone")
    house.must_build(list(PROGRAMS))
    if keep and not instructions.there():
        raise house.Trouble(f"{house.short(KEPT)} stays as it is; {instructions.MISSING}")
    house.progress("counting the instructions of every kind of joint")
    rows = measure(house.BUILD)
    house.progress_done()
    print("a chain of 99 joints, 10 iterations a step; bytes and instructions of a joint and step, "
          "with"
          "\nits share of all that a step does; the case none: bodies without joints. Reduced"
          "\ncoordinates do ten equal chains side by side with Runge-Kutta; without joints a body"
          "\nis a tree there, so that a joint saves memory. The ragdolls' joints include a contact"
          "\nper body; steps 41 to 44 are counted, in which many land. The bytes of these scenes"
          "\nare all that they hold.")
    print_table(rows)
    write(COST, rows)
    if not instructions.there():
        print(f"\n{instructions.MISSING}")
    print(f"\nthe table: {house.short(COST)}")
    if keep:
        write(KEPT, rows, {"made_with": compiled_with(house.BUILD)})
        print(f"kept, for the test that holds every build to it: {house.short(KEPT)}")
    return 0
