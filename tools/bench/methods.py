"""Every method on every kind of scene, all in one run."""
from base import house
from pictures import figures
from bench.measuring import MEASURED, cells, heading, read, run_bench, tell

PROGRAM = "bench/methods"
WORDS = {
    "si30": "Sequential Impulses, 30 iterations, cold, beta 0.2",
    "beta1": "the same with beta 1",
    "4x8": "4 substeps of 8 iterations, beta 1", "16x2": "16 substeps of 2, beta 1",
    "warm": "30 iterations, warm, beta 0, one of projection",
    "projection": "the same, cold",
    "split": "4 substeps of 4 iterations and 4 on split impulses, warm, beta 1",
    "relax": "16 substeps of 1 iteration and 1 to relax, warm, soft (60 Hz)",
    "omega": "30 iterations, over-relaxed by 1.9, beta 1",
    "lanes": "omega on lanes", "lanes10": "10 iterations on lanes, warm, beta 0.1",
    "rows10": "10 iterations, warm, beta 0.1",
    "chapter7": "chapter 7's loop on lanes, 20 iterations, over-relaxed by 1.9",
    "textbook": "a class a joint, 30 iterations",
    "velocity": "direct: one exact solve a step", "shake": "direct, positions too",
    "velocity/8": "velocity in 8 substeps", "shake/8": "shake in 8 substeps",
    "inertia/8": "inertia in 8 substeps", "plain": "velocity without leapfrog",
    "placed": "shake without leapfrog",
    "inertia": "direct, positions, more inertia (kappa 8)", "rk4": "direct, Runge-Kutta",
    "tree": "reduced coordinates, leapfrog", "tree-rk4": "reduced coordinates, Runge-Kutta",
    "xpbd": "XPBD, 20 substeps of 1 iteration",
    "nncg": "nonsmooth conjugate gradients, 30 iterations, beta 1",
    "cg": "conjugate gradients, 30 iterations, beta 1",
    "cg-exact": "the same, until nothing but rounding is left"}


COLUMNS = [*MEASURED[:2], ("by si30", "", "ratio_to_si30", 1, "9.2f"), *MEASURED[2:]]


def print_table():
    """A line per scene and method; times are told against thirty iterations in the same run."""
    rows = read(figures.METHODS)
    for scene, real in dict.fromkeys((row["scene"], row["real"]) for row in rows):
        mine = [row for row in rows if (row["scene"], row["real"]) == (scene, real)]
        name, titles, units = heading(mine, COLUMNS)
        print(f"\n{scene}, {real}{name}\n  {'method':11}{titles}  held\n  {'':11}{units}")
        for row in mine:
            print(f"  {row['method']:11}{cells(row, COLUMNS)}"
                  f"  {row['held']} of {row['of']}, {row['status']}")
    print("\nthe methods:")
    for word in dict.fromkeys(row["method"] for row in rows):
        print(f"  {word:11}{WORDS[word]}")
    print("gap: the largest of all joints in the last two thirds of a run; spread: between the "
          "quartiles of\nthe times, by their median; by si30: the time of a step by that of si30 "
          "in this run; energy: at\nthe end less that of the start, by the scene's own scale; of a "
          "random family the worst of its\nscenes; '-': has no meaning here.")


def main(options):
    print("every method on every kind of scene: about half an hour; leave the machine alone "
          "meanwhile", flush=True)
    house.must_build(["methods", "methods_float"])
    run_bench("methods", options, figures.METHODS)
    run_bench("methods_float", ["--scene", "S1", "--append", *options], figures.METHODS)
    print_table()
    print()
    return tell(figures.draw_methods(), figures.METHODS)
