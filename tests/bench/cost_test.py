"""Every kind of joint costs what the kept table says, within 3 percent: cost_test.py ROOT BUILD

Counts the instructions of every case of bench/cost.cpp and compares them, the rows and the bytes
with tests/bench/cost_table.csv. Only counts of the same compiler with the same flags can be
compared: with another, or where valgrind is missing, the test is skipped (exit status 77) and says
why. Exit status 0 when all agree, 1 otherwise, 2 for a bad command line.
"""
import csv
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).absolute().parents[2] / "tools"))
from base import house  # noqa: E402
from bench import cost, instructions  # noqa: E402

SKIPPED = 77
WITHIN = 0.03  # fraction of the table's value
FEW = 1.0      # what differs by less never counts: bodies without joints have next to nothing
NUMBERS = ["rows", "bytes_per_joint", "instructions_per_joint_step",
           "instructions_per_joint_iteration"]
NEW_TABLE = "If that is as it should be, ./wb bench --cost --keep writes the table anew."


def reason_to_skip(build, made_with):
    """Why these counts and the table's cannot be compared, or ""."""
    here = cost.compiled_with(build)
    if here != made_with:
        return f"the table is of {made_with}; this build is of {here}"
    return "" if instructions.there() else instructions.MISSING


def name(row):
    return f"{row['case']}, {row['solver']}, {row['real']}"


def differences(found, kept):
    """A line for everything that is not as the table says."""
    found, kept = ({name(row): row for row in rows} for rows in (found, kept))
    yield from (f"{one}: not in the table" for one in found if one not in kept)
    yield from (f"{one}: in the table only" for one in kept if one not in found)
    for one in found.keys() & kept.keys():
        for column in NUMBERS:
            now, then = float(found[one][column]), float(kept[one][column])
            if abs(now - then) > max(FEW, WITHIN * abs(then)):
                change = f" ({100 * (now / then - 1):+.1f} %)" if then else ""
                yield f"{one}: {column} {then:g} in the table, {now:g} now{change}"


def main(arguments):
    if len(arguments) != 2 or not all(Path(argument).is_dir() for argument in arguments):
        print(__doc__.split("\n", maxsplit=1)[0], file=sys.stderr)
        return 2
    root, build = (Path(argument).resolve() for argument in arguments)
    with open(root / "tests" / "bench" / "cost_table.csv", newline="", encoding="utf-8") as file:
        kept = list(csv.DictReader(file))
    if reason := reason_to_skip(build, kept[0]["made_with"]):
        print(f"skipped: {reason}")
        return SKIPPED
    try:
        found = cost.measure(build)
    except house.Trouble as trouble:
        print(trouble, file=sys.stderr)
        return 1
    wrong = sorted(differences(found, kept))
    for line in wrong:
        print(line)
    print(NEW_TABLE if wrong else f"{len(found)} cases cost what the table says")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
