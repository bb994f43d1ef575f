"""Our contacts beside those of Bullet and ODE: stacks, ragdolls, bodies that fall on each other."""
from base import house
from bench import measuring, peers

PROGRAM = "bench/peers/heaps"


def main(options):
    peers.programs()  # configures again if a package has been installed
    if f"{PROGRAM}:" not in peers.ninja():
        raise house.Trouble("bench --contacts: libbullet-dev is not installed")
    return measuring.prints("contacts", PROGRAM)(options)
