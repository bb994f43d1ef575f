"""Counts of instructions, by valgrind's callgrind: the same whatever else the machine does."""
import csv
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from base import house

FUNCTION = "workbook_counted"  # bench/counted.cpp
MISSING = ("no instruction counts: valgrind is not installed"
           " (on Debian and Ubuntu: apt-get install valgrind)")


def there():
    """Can instructions be counted here?"""
    return shutil.which("valgrind") is not None


def run(command):
    """What a program prints: a table, as a list of rows."""
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        raise house.Trouble(f"{Path(str(command[0])).name}: {result.stderr.strip()[-300:]}")
    return list(csv.DictReader(result.stdout.splitlines()))


def table(program, *options):
    """The rows that a program prints, two counts each: what a joint costs a step and an iteration.

    The counts are added as `at_few`, `at_many` (instructions of a joint and step with as many
    iterations) and `per_iteration` (of a joint and iteration). Without valgrind they are None.
    """
    if not program.exists():
        raise house.Trouble(f"{house.short(program)} is not built")
    if not there():
        return [{**row, "at_few": None, "at_many": None, "per_iteration": None}
                for row in run([program, *options])]
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "counts"
        rows = run(["valgrind", "--tool=callgrind", f"--toggle-collect={FUNCTION}",
                    f"--dump-after={FUNCTION}", f"--callgrind-out-file={out}", program, *options])
        counts = []
        for row in rows:
            pair = [summary(out.with_name(f"{out.name}.{len(counts) * 2 + k}")) for k in (1, 2)]
            counts.append(pair)
    for row, (few, many) in zip(rows, counts):
        joints, steps = int(row["joints"]), int(row["steps"])
        row["at_few"], row["at_many"] = few / (joints * steps), many / (joints * steps)
        iterations = int(row["many"]) - int(row["few"])
        row["per_iteration"] = (many - few) / (joints * steps * iterations)
    return rows


def summary(path):
    """The instructions of one dump of callgrind."""
    match = re.search(r"^summary: (\d+)", path.read_text() if path.exists() else "", re.M)
    if not match:
        raise house.Trouble("valgrind could not count: a dump of callgrind is missing")
    return int(match[1])
