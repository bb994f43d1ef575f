"""The commands that show something: run, plot, see, tour, check, bench."""
import csv
import os
import re
import signal
import subprocess
import sys
import webbrowser

import exercises
import grade as grading
import house
import motion
from house import bold, faint

SOLUTIONS, MINE = house.OUT / "solutions", house.OUT / "mine"
TABLE, STABILITY = house.OUT / "work_precision.csv", house.OUT / "stability.csv"
LOOP, SCALING = house.OUT / "loop.csv", house.OUT / "scaling.csv"
PEERS = house.ROOT / "bench" / "peers.csv"


# ---- programs ------------------------------------------------------------------------------------

def run_solution(chapter, quiet=True):
    """Runs a chapter's program on the solution; its tables go to out/solutions/NN_name."""
    house.must_build([f"{chapter.folder}_run"], "building")
    call_program(f"{chapter.folder}_run", SOLUTIONS / chapter.folder, [], quiet)


def call_program(name, folder, options, quiet):
    """Runs a program of a chapter. What an earlier run made and this one did not is taken away."""
    before = {old: old.stat().st_mtime_ns
              for pattern in ("*.csv", "*.motion.json") for old in folder.glob(pattern)}
    result = subprocess.run([house.BUILD / name, "--out", folder, *options],
                            stdout=subprocess.PIPE if quiet else None,
                            stderr=subprocess.PIPE, text=True)
    if result.returncode < 0:
        raise Crash(f"{name} crashed ({signal_name(-result.returncode)})")
    if result.returncode != 0:
        raise house.Trouble(result.stderr.strip() or f"{name} ended with {result.returncode}")
    for old, written in before.items():
        if old.stat().st_mtime_ns == written:
            old.unlink()


class Crash(house.Trouble):
    """A program was ended by a signal."""


def call_and_blame(chapter, written, program, folder, options, quiet):
    """Runs the reader's program; a crash is said together with the exercise it may come from."""
    try:
        call_program(program, folder, options, quiet)
    except Crash as crash:
        raise house.Trouble(f"{crash}\n{likely_cause(chapter, written, options)}")


def signal_name(number):
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def finite(table):
    """True when a table has no number that is nan or infinite."""
    return not re.search(r"(^|,)-?(nan|inf)(,|$)", table.read_text(), re.M | re.I)


def likely_cause(chapter, written, options):
    """Which of the reader's exercises may be to blame for a run that went wrong, and what to do."""
    wrong = [one.id for one in grading.grade(chapter, written)
             if one.status in (grading.WRONG, grading.BROKEN)] if written else []
    if wrong:
        others = f" (wrong, too: {' '.join(wrong[1:])})" if wrong[1:] else ""
        return f"The tests say: exercise {wrong[0]} is wrong{others}. Next: ./wb test {wrong[0]}"
    words = "No test finds a mistake in your code." if written else "The code is the solution's."
    if options:
        return (f"{words} Right code cannot bear every option. Without them: "
                f"./wb run {chapter.number}")
    return f"{words} Next: ./wb test {chapter.number}"


def prepare_mine(chapter):
    """Builds the program on the reader's file, what is not written yet taken from the solution.

    Returns the list of exercises that are the reader's own, or None where nothing is.
    """
    written = chapter.written()
    if not written:
        return None
    waiting = [id_ for id_ in chapter.ids() if id_ not in written]
    mixed = house.BUILD / "mixed" / chapter.folder / f"{chapter.name}.cpp"
    house.configure()
    exercises.write_if_new(mixed, exercises.fill(chapter.mine.read_text(),
                                                 chapter.solution.read_text(), waiting))
    log = house.build([f"{chapter.folder}_run_mine"], "building")
    if log and f"{chapter.folder}/{chapter.name}.cpp" in house.compiler_words(log):
        raise house.Trouble(f"{house.short(chapter.mine)} does not compile: "
                            f"./wb test {chapter.number}")
    if log:
        raise house.Trouble("the build failed:\n" + house.compiler_words(log))
    return written


def run(chapter, options):
    """The chapter's program, on the reader's code where it is written."""
    if "--help" in options or "-h" in options:
        house.must_build([f"{chapter.folder}_run"])
        return subprocess.run([house.BUILD / f"{chapter.folder}_run", "--help"]).returncode
    if "--out" in options:
        raise house.Trouble("--out: ./wb chooses the folder itself, under out/")
    written = prepare_mine(chapter)
    if written is None:
        print("the solution's code: no exercise of this chapter is written yet", flush=True)
        program = f"{chapter.folder}_run"
        house.must_build([program])
    else:
        rest = [id_ for id_ in chapter.ids() if id_ not in written]
        print(f"your code: {' '.join(written)}"
              + (f"   the solution's: {' '.join(rest)}" if rest else ""), flush=True)
        program = f"{chapter.folder}_run_mine"
    folder = MINE / chapter.folder
    call_and_blame(chapter, written, program, folder, options, False)
    (folder / "options.txt").write_text(" ".join(options))  # for the solution to be run alike
    if not finite(folder / "summary.csv"):
        print(f"The motion did not stay finite (nan or inf above).\n"
              f"{likely_cause(chapter, written, options)}")
        return 1
    print(faint(f"tables: {house.short(folder)}/   figures: ./wb plot {chapter.number}   "
                f"motion: ./wb see {chapter.number}"))
    return 0


def stale(folder, program):
    """True when a program has not been run since it was last built."""
    summary = folder / "summary.csv"
    return not summary.exists() or summary.stat().st_mtime < program.stat().st_mtime


def both_runs(chapter):
    """Sees to it that both recorded runs are there: (solution's folder, reader's or None).

    What ./wb run recorded is kept, with the options it was given: it is what the reader wants to
    see. The solution it is laid over has run with the same options.
    """
    house.must_build([f"{chapter.folder}_run"])
    solution, mine = SOLUTIONS / chapter.folder, MINE / chapter.folder
    if stale(solution, house.BUILD / f"{chapter.folder}_run"):
        run_solution(chapter)
    note = mine / "options.txt"
    options = note.read_text().split() if note.exists() else []
    written = prepare_mine(chapter)
    if written is None:
        if not (mine / "summary.csv").exists():
            return solution, None
    elif stale(mine, house.BUILD / f"{chapter.folder}_run_mine"):
        call_and_blame(chapter, written, f"{chapter.folder}_run_mine", mine, options, True)
    if options:
        solution = house.OUT / "solutions_alike" / chapter.folder
        call_program(f"{chapter.folder}_run", solution, options, True)
        print(f"with {' '.join(options)}, as ./wb run {chapter.number} was called last")
    return solution, mine


# ---- figures and pages ---------------------------------------------------------------------------

def draw(script, *arguments, figures=house.OUT / "plots"):
    """Runs one script of plots/; returns the PNG files that it made."""
    before = {p: p.stat().st_mtime_ns for p in figures.glob("*.png")}
    result = subprocess.run([sys.executable, "-B", house.ROOT / "plots" / script, *arguments,
                             "--out", figures], capture_output=True, text=True)
    if result.returncode != 0:
        raise house.Trouble(result.stderr.strip() or f"plots/{script} failed")
    return sorted(p for p in figures.glob("*.png") if p.stat().st_mtime_ns != before.get(p))


def plot_chapter(chapter, with_mine=True):
    solution, mine = both_runs(chapter) if with_mine else (SOLUTIONS / chapter.folder, None)
    arguments = ["--solution", solution]
    if mine:
        arguments += ["--mine", mine]
    return draw(f"chapter_{chapter.number:02}.py", *arguments)


def plot(chapter):
    """The figures of one chapter, or all of them."""
    made = []
    for one in [chapter] if chapter else house.chapters():
        house.progress(f"drawing chapter {one.number}")
        made += plot_chapter(one)
    if not chapter and TABLE.exists():
        made += draw("work_precision.py", "--csv", TABLE, "--peers", PEERS)
    if not chapter and SCALING.exists():
        made += draw("scaling.py", "--csv", SCALING)
    if not chapter and STABILITY.exists():
        made += draw("stability.py", "--csv", STABILITY)
    if not chapter and LOOP.exists():
        import loop
        made += loop.draw()
    house.progress_done()
    for path in made:
        print(house.short(path))
    return 0


def make_page(chapter, solution, mine):
    page = house.OUT / "see" / f"{chapter.folder}.html"
    page.parent.mkdir(parents=True, exist_ok=True)
    try:
        motion.write_page(page, f"Chapter {chapter.number}: {chapter.name}", solution, mine)
    except motion.MotionError as error:
        raise house.Trouble(str(error))
    return page


def see(chapter):
    """The page that plays the motion of one chapter; without one, all pages, and opens none."""
    for one in [] if chapter else house.chapters():
        solution, mine = both_runs(one)
        print(house.short(make_page(one, solution, mine)), flush=True)
    if not chapter:
        print("open them in a browser: they need no network")
        return 0
    solution, mine = both_runs(chapter)
    page = make_page(chapter, solution, mine)
    print(f"{house.short(page)}" + ("" if mine else "   (the solution; yours is not written yet)"))
    if house.TERMINAL and ("DISPLAY" in os.environ or "WAYLAND_DISPLAY" in os.environ
                           or sys.platform == "darwin"):
        webbrowser.open(page.as_uri())
    else:
        print("open it in a browser: it needs no network")
    return 0


# ---- the whole workbook --------------------------------------------------------------------------

def summary_table(chapters):
    print(f"{'scene':12} {'setting':26} {'us a step':>10} {'gap RMS mm':>11} {'gap max mm':>11} "
          f"{'energy drift':>13}")
    for chapter in chapters:
        with open(SOLUTIONS / chapter.folder / "summary.csv", newline="") as file:
            for row in csv.DictReader(file):
                print(f"{row['scene']:12} {row['setting']:26} {float(row['us_per_step']):10.2f} "
                      f"{1000 * float(row['gap_rms_m']):11.4g} "
                      f"{1000 * float(row['gap_max_m']):11.4g} "
                      f"{float(row['energy_drift']):13.3g}")


def tour():
    """The main job: everything computed, drawn, moving and summarised, from the solutions."""
    chapters = house.chapters()
    new = not (house.BUILD / "build.ninja").exists()
    print(f"{len(chapters)} chapters: build, run, draw. "
          + ("The first time takes about two minutes." if new
             else "Less than a minute when nothing has to be built."), flush=True)
    house.must_build([f"{c.folder}_run" for c in chapters] + ["work_precision"], "building")
    figures, pages = [], []
    for chapter in chapters:
        house.progress(f"chapter {chapter.number}: running")
        run_solution(chapter)
        house.progress(f"chapter {chapter.number}: drawing")
        figures += plot_chapter(chapter, with_mine=False)
        pages.append(make_page(chapter, SOLUTIONS / chapter.folder, None))
    house.progress("error against run time, the short form")
    run_bench("work_precision", ["--quick", "1"])
    figures += draw("work_precision.py", "--csv", TABLE, "--peers", PEERS)
    house.progress_done()
    print()
    summary_table(chapters)
    print("\nenergy drift: change of energy over the run, as a share of the energy to hand. Ropes\n"
          "that become taut and limits that stop a body take some, as in nature, motors add their\n"
          "work, and what sags has come to rest lower; what is lost else, the method loses.")
    print("\n" + bold("pictures"))
    for path in dict.fromkeys(figures):
        print(f"  {house.short(path)}")
    print(bold("motion, open in a browser"))
    for page in pages:
        print(f"  {house.short(page)}")
    print("\nYour turn: ./wb leads you to the first exercise.")
    return 0


def run_bench(program, options, table=TABLE):
    """One run of a benchmark program; its progress is shown."""
    house.OUT.mkdir(exist_ok=True)
    process = subprocess.Popen([house.BUILD / "bench" / program, "--csv", table, *options],
                               stderr=subprocess.PIPE, text=True)
    said = ""
    for line in process.stderr:
        said = line.strip()
        if house.TERMINAL:
            house.progress(f"{program}: {said}")
    if process.wait() != 0:
        raise house.Trouble(said)
    house.progress_done()


def bench(options):
    """Error against run time, and what the options name: a suite or a table of its own each."""
    if options == ["--stability"]:
        import stability
        return stability.main()
    if options == ["--loop"]:
        import loop
        return loop.main()
    if options in (["--cost"], ["--cost", "--keep"]):
        import cost
        return cost.main(keep="--keep" in options)
    if options:
        raise house.Trouble(f"bench: {' '.join(options)}: it takes --stability, --loop or --cost")
    import benchmark
    return benchmark.main()
