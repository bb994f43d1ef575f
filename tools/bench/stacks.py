"""Stacks of boxes: which of them stand for a minute, with which solver and setting."""
import subprocess

from base import house

PROGRAM = "bench/stacks"
TABLE = house.OUT / "stacks.csv"


def main(options):
    """The program prints the table, and writes it."""
    house.must_build(["stacks"])
    house.OUT.mkdir(exist_ok=True)
    if subprocess.run([house.BUILD / PROGRAM, "--csv", TABLE, *options]).returncode != 0:
        return 1
    print(f"the table: {house.short(TABLE)}")
    return 0
