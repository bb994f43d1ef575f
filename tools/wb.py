"""wb: the one command of the workbook. `./wb help` lists what it can do."""
import argparse
import difflib
import errno
import importlib
import os
import re
import sys
import textwrap
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).absolute().parent))
from base import house  # noqa: E402

MARGIN, WIDTH = 23, 79  # of the overview, in columns
COMMANDS = {}  # by name, in the order of the overview
# What others call a command, where the letters alone do not lead to it.
MEANT = {"solve": "show", "solution": "show", "answer": "show", "verify": "check", "build": "test",
         "draw": "plot", "view": "see", "play": "see"}
# What needs the solutions, and what a student's edition has instead.
NEED_SOLUTIONS = {"tour": "./wb run 1, ./wb plot 1 and ./wb see 1 show a finished chapter",
                  "check": "./wb test 1 tests a chapter", "grade": "./wb test 1 tests a chapter",
                  "docs": "the texts are chapters/*/README.md and docs/*.md",
                  "course": "./wb leads through the same exercises",
                  "bench": "docs/measurements.md shows what it measured; ./wb plot and ./wb see "
                           "show the experiments of a chapter, as they were recorded",
                  "compare": "docs/which_method.md says which method to take",
                  "keep": "nothing has to be kept here: it renews texts after changes of solutions",
                  "hand-out": "copy this folder: it is an edition without solutions"}
TABLES = {"stability": "stiff, extreme and redundant scenes: which setting holds them",
          "methods": "every method on every kind of scene",
          "sweeps": "error against run time over the length of the step",
          "families": "scenes drawn by seeds: how many each setting holds",
          "stacks": "boxes on each other: which of them stand for a minute",
          "peers": "ours beside Bullet, ODE, MuJoCo and Simbody of Debian",
          "contacts": "our contacts beside those of Bullet and ODE",
          "convergence": "iterations until a chain is right, method by method",
          "loop": "a joint and iteration, from the textbook's loop to lanes",
          "cost": "rows, bytes and instructions of every kind of joint"}


# ---- how a command line is read ------------------------------------------------------------------

class Parser(argparse.ArgumentParser):
    """Reads the words of one command; what is wrong with them is told in one line."""

    def error(self, message):
        message = message.replace("the following arguments are ", "")
        unknown = re.match(r"unrecognized arguments: (--\S+)", message)
        near = difflib.get_close_matches(unknown[1], re.findall(r"--\w+", self.format_help()), 1) \
            if unknown else []
        raise house.Trouble(f"{self.prog.removeprefix('./wb ')}: {message} "
                            + (f"(did you mean {near[0]}?)" if near else f"({self.prog} --help)"))


def layout(prog):
    return argparse.HelpFormatter(prog, max_help_position=MARGIN, width=WIDTH)


def argument(*names, **how):
    return names, how


def command(shown, words, *arguments, lines=(), **how):
    """A command: the line of the overview, more lines of it, and its arguments for argparse."""
    def add(call):
        name = call.__name__.rstrip("_").replace("_", "-")
        parser = Parser(prog=f"./wb {name}", description=words, formatter_class=layout,
                        allow_abbrev=False, **how)
        for names, more in arguments:
            parser.add_argument(*names, **more)
        COMMANDS[name] = parser, call, [(f"./wb {shown}".strip(), words), *lines]
        return call
    return add


def overview():
    """Every command in a line or two; blank lines between the groups."""
    said = ["The Joint Workbook"]
    sealed = any(chapter.sealed for chapter in house.chapters())
    for name, (_, _, lines) in COMMANDS.items():
        if sealed and name in {*NEED_SOLUTIONS, "show"}:
            continue
        said += [""] if name in FIRST else []
        for shown, words in lines:
            first, *rest = textwrap.wrap(words.replace("./wb ", "./wb\xa0"), WIDTH - MARGIN)
            said.append(f"  {shown:{MARGIN - 3}} {first}")
            said += [" " * MARGIN + line for line in rest]
    return "\n".join(said).replace("\xa0", " ")


def refuse_unknown(word):
    """A command that does not exist: what may have been meant."""
    if re.fullmatch(r"\d+(\.\d+)?", word):
        meant = [f"test {word}"]
    else:
        plain = word.lower().lstrip("-")
        meant = [MEANT[plain]] if plain in MEANT else \
            difflib.get_close_matches(plain, [*COMMANDS, "help"], 1)
    raise house.Trouble(f"{word}: no such command; "
                        + (f"did you mean ./wb {meant[0]}?" if meant else "./wb help lists them"))


def main(words):
    name, rest = (words[0], words[1:]) if words else ("status", [])
    if name in ("help", "--help", "-h"):
        if not rest:
            print(overview())
            return 0
        name, rest = rest[0], ["--help"]
    if name == "--version":
        print(f"The Joint Workbook {house.version()}")
        return 0
    if name not in COMMANDS:
        refuse_unknown(name)
    need_solutions(name)
    parser, call, _ = COMMANDS[name]
    if name == "bench":  # what it does not know is the program's
        return call(*parser.parse_known_args(rest))
    return call(parser.parse_args(rest))


def need_solutions(name):
    if name in NEED_SOLUTIONS and any(chapter.sealed for chapter in house.chapters()):
        raise house.Trouble(f"{name} needs the solutions, which this edition does not have; "
                            f"instead:\n{NEED_SOLUTIONS[name]}")


# ---- the commands: each loads no more than it needs, since ./wb is to answer at once -------------

YES = argument("--yes", action="store_true", help="do not ask")
ONE = argument("exercise", help="such as 2.1")
SOME = argument("what", help="an exercise or a chapter, such as 2.1 or 2, a file or file:line")
CHAPTER = argument("chapter", nargs="?", help="such as 2; without one, all")


def chapters_of(words):
    """The chapters that "1-3" or "2,4" names."""
    found = []
    for part in filter(None, words.split(",")):
        first, last = (house.chapter_of(word).number for word in
                       (part.split("-") if part.count("-") == 1 else (part, part)))
        found += [one for one in house.chapters() if first <= one.number <= last]
    return found


def chapter_of(args):
    return house.chapter_of(args.chapter) if args.chapter else None


@command("", "where you are, and the next thing to do (./wb status)")
def status(_):
    from learn import status as learn
    return learn.status()


@command("next", "the next thing to do, alone")
def next_(_):
    from learn import status as learn
    return learn.status(chapters=False)


@command("list", "every exercise, and where it stands")
def list_(_):
    from learn import status as learn
    return learn.status(every=True)


@command("setup", "install what is missing (Debian, Ubuntu)")
def setup(_):
    """Was done before Python was called, by the script ./wb."""


@command("tour", "run every program, draw every figure, summarise")
def tour(_):
    from learn import tour as learn
    return learn.tour()


@command("check", "the workbook's own tests (./wb check 3: of one chapter)",
         argument("words", nargs="*", metavar="what",
                  help="a chapter (3), a topic (joints), an erratum (E26), a case (X4) or an "
                       "identity (I15)"),
         argument("--rest", action="store_true",
                  help="the tests that ./wb check omits: float, pictures, the library outside ..."),
         argument("--all", action="store_true", help="both"),
         argument("--quick", action="store_true", help="without float, units and known answers"),
         argument("--long", action="store_true", help="ten times as many random worlds"),
         argument("--sanitize", action="store_true",
                  help="under address and undefined-behaviour checks"))
def check(args):
    from check import checking
    return checking.check(args)


@command("test 2.1", "test one exercise (or a whole chapter: ./wb test 2); with --debug only built "
         "for a debugger", SOME,
         argument("--debug", action="store_true",
                  help="build it for a debugger, and say how to call one"))
def test(args):
    if args.debug:
        from learn import debugging
        return debugging.debug(args.what)
    from learn import testing
    return testing.test(args.what)


@command("watch [2.1]", "test again whenever you save",
         argument("what", nargs="?", help="an exercise or a chapter; without one, what is saved"))
def watch(args):
    from learn import testing
    return testing.watch(args.what)


@command("hint 2.1 [1-3]", "a hint: 1 is a nudge, 3 is nearly the answer", ONE,
         argument("step", nargs="?", default="1", help="1, 2 or 3 (1)"))
def hint(args):
    from learn import aid
    return aid.hint(args.exercise, args.step)


@command("show 2.1", "the solution of an exercise", ONE, YES)
def show(args):
    from learn import aid
    return aid.solution(args.exercise, args.yes)


@command("reset 2.1", "put the stub back (./wb reset 2: a whole chapter); with --keep only what is "
         "not yours to change", SOME, YES,
         argument("--keep", action="store_true", help="leave your answers as they are"))
def reset(args):
    from learn import aid
    return aid.reset(args.what, args.yes, args.keep)


@command("run 2 [...]", "the chapter's program with your code; ./wb run 2 --help lists its "
         "options, such as --chains 16 of chapter 7; ./wb run 2 --compare: every method on its "
         "scene", argument("chapter", help="such as 2"),
         argument("options", nargs=argparse.REMAINDER, help="the program's: ./wb run 2 --help"))
def run(args):
    if "--compare" in args.options:
        need_solutions("compare")
        from bench import compare as methods
        return methods.of_chapter(house.chapter_of(args.chapter),
                                  [word for word in args.options if word != "--compare"])
    from learn import show as learn
    return learn.run(house.chapter_of(args.chapter), args.options)


@command("plot [2]", "draw the figures: your curve over the solution's", CHAPTER)
def plot(args):
    from learn import show as learn
    return learn.plot(chapter_of(args))


@command("see [2]", "the page that plays the motion, beside the solution's", CHAPTER)
def see(args):
    from learn import show as learn
    return learn.see(chapter_of(args))


@command("live [2]", "the page in which the engine runs, with your code beside the solution's: "
         "change settings, drag, iterate singly", CHAPTER)
def live(args):
    from website import live as page
    return page.live(chapter_of(args))


@command("course", "the whole course in a browser: write, check, see it move (--no-serve: only "
         "writes out/course)",
         argument("--no-serve", action="store_true", help="write out/course and end"),
         argument("--one-file", action="store_true", help="also out/joint_workbook.html, which a "
                  "browser opens from a disk"),
         argument("--students", action="store_true", help="without the solutions"))
def course(args):
    from course import packing
    return packing.command(not args.no_serve, args.one_file, args.students)


@command("bench [...]", "error against run time; a joint's cost in larger scenes",
         argument("-h", "--help", action="store_true", help="this; after a table its options"),
         *(argument(f"--{name}", dest="table", action="append_const", const=name, help=words)
           for name, words in TABLES.items()),
         lines=[*((f"  --{name}", words) for name, words in TABLES.items()),
                ("  --methods --help", "the options of a table, such as --scene S1"),
                ("bench 8 [...]", "more experiments of a chapter, on the solution; ./wb bench 8 "
                 "--help lists their options, such as --machine wheels")],
         add_help=False,
         usage="./wb bench [--TABLE | CHAPTER] [options of its program]")
def bench(args, options):
    if options and options[0].isdigit() and not args.table:
        from bench import experiments
        more = ["--help"] if args.help else []
        return experiments.main(house.chapter_of(options[0]), options[1:] + more)
    tables = args.table or ["benchmark"]
    if args.help and not args.table:
        COMMANDS["bench"][0].print_help()
        return 0
    if len(tables) > 1:
        COMMANDS["bench"][0].error(f"--{tables[0]} and --{tables[1]}: one table at a time")
    table = importlib.import_module(f"bench.{tables[0]}")
    if args.help:
        return house.tell_options(table.PROGRAM, "csv", "append", "machine")
    return table.main(options)


@command("compare FILE", "every method on a scene of yours: error, time, and which one to take",
         argument("file", metavar="FILE", help="C++ with one function: World make_world() {...}"),
         argument("options", nargs=argparse.REMAINDER,
                  help="those above; --budget is the most time of a step [us], --depth how "
                       "far limits and contacts may be passed [m]"),
         lines=[("  --seconds 5 --hz 60", "of the scene; --gap 0.001 [m] is what you want of it")],
         usage="./wb compare FILE [--seconds S] [--hz N] [--gap M] [--csv OUT]")
def compare(args):
    from bench import compare as methods
    return methods.main(args.file, args.options)


@command("docs", "the documentation as a site, with every motion")
def docs(_):
    from website import docs as site
    return site.command()


@command("keep", "after a change: updates numbers, listings and pictures of the texts and the "
         "stubs, and lists the changes",
         argument("kinds", nargs="*", metavar="kind", help="one kind alone, such as numbers"))
def keep(args):
    from keep import keeping
    return keeping.keep(args.kinds)


@command("grade DIR", "of a class: the state of every submission, a table and feedback for "
         "everyone in out/grades/",
         argument("folder", metavar="DIR", nargs="+",
                  help="a folder of submissions, such as ./wb grade class, or one of them: a "
                       "folder, a zip or a file"),
         argument("--chapters", metavar="N-M", default="",
                  help="these alone, such as 1-3 or 2,4; without it, all that are handed in"))
def grade(args):
    from classroom import grading
    if len(args.folder) > 1:
        raise house.Trouble("grade takes one folder and grades every chapter that is in it: "
                            f"./wb grade {args.folder[-1]}")
    return grading.grade(house.CALLED_FROM / args.folder[0], chapters_of(args.chapters))


@command("hand-out DIR", "for a class: the workbook without solutions and known answers",
         argument("folder", metavar="DIR", help="a new folder"),
         argument("--update", action="store_true",
                  help="it is an older edition: renew it, except for exercise files and for "
                       "solutions that are handed out"))
def hand_out(args):
    from classroom import hand_out as edition
    return (edition.update if args.update else edition.hand_out)(house.CALLED_FROM / args.folder)


FIRST = {"status", "test", "run", "bench", "grade"}  # of their groups in the overview

NOT_HERE = {errno.EROFS, errno.EACCES, errno.EPERM, errno.ENOSPC, errno.EDQUOT}

if __name__ == "__main__":
    os.chdir(house.ROOT)
    try:
        sys.exit(main(sys.argv[1:]))
    except (house.Trouble, house.exercises.Broken) as trouble:
        house.progress_done()
        sys.stdout.flush()
        print(f"wb: {trouble}", file=sys.stderr)
        sys.exit(2)
    except KeyboardInterrupt:
        print()
        sys.exit(130)
    except BrokenPipeError:
        os._exit(1)
    except OSError as error:
        if error.errno not in NOT_HERE:
            raise
        house.progress_done()
        print(f"wb: {house.short(error.filename or 'a file')} cannot be written "
              f"({error.strerror}):\nwork in a copy of the workbook that is yours, on a disk with "
              "space", file=sys.stderr)
        sys.exit(2)
