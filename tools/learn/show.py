"""The commands that show something: run, plot, see."""
import csv
import os
import re
import signal
import subprocess
import sys
import webbrowser

from base import exercises
from judge import crashes
from pictures import figures
from website import gallery
from judge import grade as grading
from learn import own_numbers
from base import house
from judge import reading
from pictures import motion
from base.talk import bad, faint, folded

SOLUTIONS, MINE = house.OUT / "solutions", house.OUT / "mine"
TOO_LITTLE = "the solution alone: too little of yours is written yet"


# ---- programs ------------------------------------------------------------------------------------

def run_solution(chapter, quiet=True):
    """Runs a chapter's programs on the solution; their tables go to out/solutions/NN_name."""
    house.must_build(chapter.programs, "building")
    call_programs(chapter.programs, SOLUTIONS / chapter.folder, [], quiet)


def call_programs(names, folder, options, quiet):
    """Runs programs of a chapter. Removes the files that only an earlier run wrote."""
    before = {old: old.stat().st_mtime_ns
              for pattern in ("*.csv", "*.motion.json") for old in folder.glob(pattern)}
    for name in names:
        call_program(name, folder, options, quiet)
    for old, written in before.items():
        if old.stat().st_mtime_ns == written:
            old.unlink()


def call_program(name, folder, options, quiet):
    result = subprocess.run([house.BUILD / name, "--out", folder, *options],
                            stdout=subprocess.PIPE if quiet else None,
                            stderr=subprocess.PIPE, text=True)
    if result.returncode == -signal.SIGPIPE:  # whoever listened has had enough
        raise BrokenPipeError
    if result.returncode < 0:
        raise Crash(crashes.plainly(f"{name} was ended by {signal_name(-result.returncode)}"))
    if result.returncode != 0:
        words = re.sub(r"exercise (\d+\.\d+) is not written yet", r"\g<0>\nNext: ./wb test \1",
                       result.stderr.strip().removeprefix("error: "))
        raise house.Trouble(words or f"{name} ended with {result.returncode}")


class Crash(house.Trouble):
    """A program was ended by a signal."""


def call_and_blame(chapter, written, program, folder, options, quiet):
    """Runs the reader's program; a crash is said together with the exercise it may come from."""
    try:
        call_programs([program], folder, options, quiet)
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
    """Which of the reader's exercises may be to blame for a run that went wrong, and the remedy."""
    if wrong := red(chapter, written or []):
        return f"Likely cause: {wrong}"
    words = "No test finds a mistake in your code." if written else "The code is the solution's."
    if options:
        return (f"{words} Some options make even right code fail. Without them: "
                f"./wb run {chapter.number}")
    return f"{words} Next: ./wb test {chapter.number}"


def far_off(mine, solution):
    """The first error of a run that is more than ten times the solution's, in a sentence; "" where
    none is. Both are summary.csv of the same scenes."""
    for one, other in zip(*(csv.DictReader(path.read_text().splitlines())
                            for path in (mine, solution))):
        for name in one:
            if name in ("scene", "setting", "us_per_step") or not (one[name] and other[name]):
                continue
            yours, right = float(one[name]), float(other[name])
            if abs(yours) > 10 * abs(right) + 1e-4:
                return (f"{one['scene']}, {one['setting']}: {name} is {yours:.3g}, with the "
                        f"solution's code {right:.3g}.")
    return ""


def red(chapter, written):
    """Which exercises in use are wrong, in a sentence; "" where none is. One that does not end
    would not end in the program either."""
    grades = grading.grade(chapter, written) if written else []
    wrong = [one.id for one in grades if one.status == grading.WRONG]
    if endless := [one.id for one in grades if not one.ends]:
        raise house.Trouble(f"{endless[0]} does not end, nor would the program: "
                            f"./wb test {endless[0]}")
    if not wrong:
        return ""
    return (f"{', '.join(wrong)} {'is' if len(wrong) == 1 else 'are'} not right yet: "
            f"./wb test {wrong[0]}")


def prepare_mine(chapter):
    """Builds the program on the reader's file, what is not written yet taken from the solution,
    and says which of the reader's exercises are wrong.

    Returns the list of exercises that are the reader's own, or None where nothing is.
    """
    look = reading.look(chapter)
    look.refuse()
    written = look.written()
    left = [id_ for id_ in chapter.ids() if id_ not in written]
    if left and chapter.sealed:
        raise house.Trouble(f"the program of chapter {chapter.number} needs all of its exercises, "
                            f"and {' '.join(left)} {'are' if len(left) > 1 else 'is'} not written "
                            f"yet\nNext: ./wb test {left[0]}")
    if not written:
        return None
    if grading.build(chapter):
        raise house.Trouble(f"{house.short(chapter.mine)} does not compile. "
                            f"Next: ./wb test {chapter.number}")
    if wrong := red(chapter, written):
        print(f"{bad('Beware')}: {wrong}", flush=True)
    write_mixed(chapter, written)
    house.must_build([f"{chapter.folder}_run_mine"])
    return written


def mixed_file(chapter):
    """The reader's file, completed from the solution where it is not written yet."""
    return house.BUILD / "mixed" / chapter.folder / f"{chapter.name}.cpp"


def write_mixed(chapter, written):
    waiting = [id_ for id_ in chapter.ids() if id_ not in written]
    exercises.write_if_new(mixed_file(chapter), exercises.fill(
        chapter.mine_text(), exercises.read(chapter.solution), waiting))


def run(chapter, options):
    """The chapter's program, on the reader's code where it is written."""
    if "--help" in options or "-h" in options:
        house.tell_options(f"{chapter.folder}_run")
        print("  --for NAME     numbers of your own, drawn from a name\n"
              "  --compare      every method on the scene of its live page (./wb compare --help)")
        return 0
    if "--for" in options:
        options = of_name(chapter, options)
    if any(option.startswith("--out") for option in options):
        raise house.Trouble("run --out: ./wb chooses the folder itself, under out/")
    written = prepare_mine(chapter)
    if written is None:
        print("the solution's code: no exercise of this chapter is written yet", flush=True)
        program = f"{chapter.folder}_run"
        house.must_build([program])
    else:
        tell_whose(chapter, written)
        program = f"{chapter.folder}_run_mine"
    folder = MINE / chapter.folder
    call_and_blame(chapter, written, program, folder, options, False)
    (folder / "options.txt").write_text(" ".join(options))  # for the solution to be run alike
    if not finite(folder / "summary.csv"):
        print(f"The motion did not stay finite (nan or inf above).\n"
              f"{likely_cause(chapter, written, options)}")
        return 1
    if written and not chapter.sealed:
        alike = house.OUT / "solutions_alike" / chapter.folder
        house.must_build([f"{chapter.folder}_run"])
        call_programs([f"{chapter.folder}_run"], alike, options, True)
        if words := far_off(folder / "summary.csv", alike / "summary.csv"):
            print(f"{bad('Far from the solution')}: {words}\n"
                  f"{likely_cause(chapter, written, options)}")
    print(faint(f"tables: {house.short(folder)}/   figures: ./wb plot {chapter.number}   "
                f"motion: ./wb see {chapter.number}"))
    return 0


def tell_whose(chapter, written):
    """Which exercises run with the reader's code, and which with the solution's."""
    rest = [id_ for id_ in chapter.ids() if id_ not in written]
    print(f"your code: {' '.join(written)}"
          + (f"   the solution's: {' '.join(rest)}" if rest else ""), flush=True)


def of_name(chapter, words):
    """The options that are drawn from the name after --for, and the others; those that are there
    are not drawn."""
    at = words.index("--for") + 1
    end = next((k for k in range(at, len(words)) if words[k].startswith("--")), len(words))
    if at == end:
        raise house.Trouble("run: --for needs a name, such as --for ada")
    others, name = words[:at - 1] + words[end:], " ".join(words[at:end])
    options, factors = own_numbers.drawn(name, chapter, house.options_of(f"{chapter.folder}_run"))
    pairs = zip(options[::2], options[1::2])
    options = [word for pair in pairs if pair[0] not in others for word in pair]
    own_numbers.tell(name, options, factors)
    return options + others


def stale(folder, programs):
    """True when one of these programs has not been run since it was last built."""
    summary = folder / "summary.csv"
    return not summary.exists() or summary.stat().st_mtime < max(
        (house.BUILD / program).stat().st_mtime for program in programs)


def recorded(chapter):
    """The folder with the recordings of the solution, in an edition without it."""
    return chapter.solution.parent / "run"


def both_runs(chapter):
    """Sees to it that both recorded runs are there: (solution's folder, reader's or None).

    What ./wb run recorded is kept, with the options it was given: the reader wants to
    see. The solution it is laid over has run with the same options.
    """
    solution, mine = SOLUTIONS / chapter.folder, MINE / chapter.folder
    if chapter.sealed:
        solution = recorded(chapter)
        if len(reading.look(chapter).written()) < len(chapter.ids()):
            return solution, None
    written = prepare_mine(chapter)
    house.progress(f"running chapter {chapter.number}")
    if not chapter.sealed:
        house.must_build(chapter.programs)
        if stale(solution, chapter.programs):
            run_solution(chapter)
    note = mine / "options.txt"
    options = note.read_text().split() if note.exists() else []
    if written is None:
        if not (mine / "summary.csv").exists():
            return solution, None
    elif stale(mine, [f"{chapter.folder}_run_mine"]):
        call_and_blame(chapter, written, f"{chapter.folder}_run_mine", mine, options, True)
    if options and chapter.sealed:
        house.progress_done()
        print(folded(f"your run alone, with {' '.join(options)}: the recorded run of the solution "
                     f"has no options. For both: ./wb run {chapter.number}"))
        return mine, None
    if options:
        solution = house.OUT / "solutions_alike" / chapter.folder
        call_programs([f"{chapter.folder}_run"], solution, options, True)
        house.progress_done()
        print(f"with {' '.join(options)}, as ./wb run {chapter.number} was called last")
    house.progress_done()
    return solution, mine


# ---- figures and pages ---------------------------------------------------------------------------

def plot(chapter):
    """The figures of one chapter, or all of them."""
    if not chapter:
        print("the figures of all chapters, which takes a minute or more; ./wb plot 1 draws those "
              "of one", flush=True)
    alone = []
    with house.talking():
        jobs = []
        for one in [chapter] if chapter else house.chapters():
            solution, mine = both_runs(one)
            alone += [] if mine or solution == MINE / one.folder else [str(one.number)]
            jobs.append(figures.of_chapter(one, solution, mine))
    if not chapter and figures.TABLE.exists():
        jobs.append(("work_precision.py", "--csv", figures.TABLE, "--peers", figures.PEERS))
    if not chapter and figures.SCALING.exists():
        jobs.append(("scaling.py", "--csv", figures.SCALING))
    if not chapter and figures.STABILITY.exists():
        jobs.append(("stability.py", "--csv", figures.STABILITY))
    made = figures.draw_all(jobs)
    if not chapter and figures.LOOP.exists():
        made += figures.draw_loop()
    if not chapter and figures.METHODS.exists():
        made += figures.draw_methods()
    house.progress_done()
    for path in made:
        print(house.short(path))
    if alone:
        print(folded(f"Of chapter {' '.join(alone)} {TOO_LITTLE}"))
    return 0


def make_page(chapter, solution, mine, more=""):
    page = house.OUT / "see" / f"{chapter.folder}{more}.html"
    page.parent.mkdir(parents=True, exist_ok=True)
    try:
        motion.write_page(page, f"Chapter {chapter.number}: {chapter.name}", solution, mine,
                          watch=gallery.watch(chapter.folder))
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
    if mine and mine != solution:
        tell_whose(chapter, reading.look(chapter).written() or [])
    print(f"{house.short(page)}" + ("" if mine or solution == MINE / chapter.folder else
                                    f"   ({TOO_LITTLE})"))
    open_page(page)
    return 0


def open_page(page):
    """In a browser, where there is a screen for one."""
    if house.TERMINAL and ("DISPLAY" in os.environ or "WAYLAND_DISPLAY" in os.environ
                           or sys.platform == "darwin"):
        webbrowser.open(page.as_uri())
    else:
        print("open it in a browser: it needs no network")
