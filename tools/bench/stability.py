"""The stability suite: runs it in double and float, draws the maps, and counts what came out."""
import subprocess

from base import house
from pictures import figures
from bench.measuring import read, run_bench, tell

PROGRAM = "bench/stability"
WORDS = ["ok", "soft", "torn", "energy+", "exploded", "nan", "off"]
BESIDE = "(for comparison)"  # what others would do, shown beside: counted nowhere


def what_cases_are():
    """{X1: in words}, as the program lists them."""
    listed = subprocess.run([house.BUILD / "bench" / "stability", "--list", "1"],
                            capture_output=True, text=True, check=True).stdout
    found = {}
    for line in listed.splitlines():
        id_, words = line.split(" ", 1)
        found[id_] = f"{found[id_]}; {words}" if id_ in found else words
    return found


def print_table():
    """A line a case: how many runs came to which word, in double and in float."""
    rows = [row for row in read(figures.STABILITY) if BESIDE not in row["method"]]
    print(f"{'case':5} {'real':7} " + " ".join(f"{word:>8}" for word in WORDS) + "  what")
    for id_, words in what_cases_are().items():
        for real in ("double", "float"):
            counts = [sum(row["case"] == id_ and row["real"] == real and row["status"] == word
                          for row in rows) for word in WORDS]
            print(f"{id_:5} {real:7} " + " ".join(f"{count or '.':>8}" for count in counts)
                  + (f"  {words}" if real == "double" else ""))
    print("\nA scene that was run is ok (gap below 1 % of a link), soft (below half), torn (above),"
          "\n"
          "energy+ (over 2 % gained), exploded (over 100 %) or nan. A number that is known\n"
          "comes out ok or off. What is off:")
    for row in rows:
        if row["status"] == "off" or (row["status"] == "nan" and row["expected"]):
            print(f"  {row['case']:4} {row['real']:6} {row['method']}: {row['parameter']} "
                  f"{row['value']}: expected {float(row['expected'] or 'nan'):.6g}, "
                  f"measured {float(row['measured'] or 'nan'):.6g}")


def main(options):
    print("the stability suite: about three and a half minutes", flush=True)
    house.must_build(["stability", "stability_float"])
    run_bench("stability", options, figures.STABILITY)
    run_bench("stability_float", ["--append", *options], figures.STABILITY)
    print_table()
    print()
    return tell(figures.draw("stability.py", "--csv", figures.STABILITY), figures.STABILITY)
