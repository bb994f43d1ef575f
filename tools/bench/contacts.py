"""Our contacts beside those of Bullet and ODE: stacks, ragdolls, bodies that fall on each other."""
import subprocess

from base import house
from bench import peers

PROGRAM = "bench/peers/heaps"
TABLE = house.OUT / "contacts.csv"


def main(options):
    """The program prints the table, and writes it."""
    peers.programs()  # configures again if a package has been installed
    if f"{PROGRAM}:" not in peers.ninja():
        raise house.Trouble("bench --contacts: libbullet-dev is not installed")
    house.must_build(["heaps"])
    house.OUT.mkdir(exist_ok=True)
    if subprocess.run([house.BUILD / PROGRAM, "--csv", TABLE, *options]).returncode != 0:
        return 1
    print(f"the table: {house.short(TABLE)}")
    return 0
