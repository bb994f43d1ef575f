"""Families of scenes drawn by seeds: how many of each every setting of the direct solver holds."""
import subprocess

from base import house

PROGRAM = "bench/families"
TABLE = house.OUT / "families.csv"


def main(options):
    """The program prints the table, and writes it."""
    house.must_build(["families", "families_float"])
    house.OUT.mkdir(exist_ok=True)
    for program, more in (("families", []), ("families_float", ["--append"])):
        print(f"\n{program}: a scene is held if no joint opens by 1 mm (float: 5 mm) and it gains "
              "no 10 %\nof its energy; it is lost beyond 2 cm", flush=True)
        if subprocess.run([house.BUILD / "bench" / program, "--csv", TABLE, *more,
                           *options]).returncode != 0:
            return 1
    print(f"the table: {house.short(TABLE)}")
    return 0
