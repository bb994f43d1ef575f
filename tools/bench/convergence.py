"""How many iterations a chain's first step takes until its velocities are right to a millionth."""
from base import house
from bench.measuring import read, run_bench, tell

PROGRAM = "bench/convergence"
TABLE = house.OUT / "convergence.csv"


def main(options):
    house.must_build(["convergence"])
    run_bench("convergence", options, TABLE)
    print(f"{'gravity':10}{'hinges':>8}{'rows':>8}  {'method':14}{'iterations':>11}{'us each':>9}")
    for row in read(TABLE):
        print(f"{row['gravity']:10}{row['hinges']:>8}{row['rows']:>8}  {row['method']:14}"
              f"{row['iterations']:>11}{float(row['us_per_iteration']):9.2f}")
    print("inf: more than --most. us each: time of the processor for one iteration")
    return tell([], TABLE)
