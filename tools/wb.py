"""wb: the one command of the workbook. `./wb help` lists what it can do."""
import difflib
import os
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
from base import house  # noqa: E402

HELP = """The Joint Workbook

  ./wb                 where you are, and the next thing to do
  ./wb tour            run every chapter's program, draw every figure, summarise
  ./wb check           the workbook's own tests
                       ./wb check 3: of one chapter; --quick: without float,
                       units and known answers; --long: ten times as many
                       random worlds

  ./wb test 2.1        test one exercise (or a whole chapter: ./wb test 2)
  ./wb watch [2.1]     test again whenever you save
  ./wb hint 2.1 [1-3]  a hint: 1 is a nudge, 3 is nearly the answer
  ./wb show 2.1        the solution of an exercise
  ./wb reset 2.1       put the empty stub back (./wb reset 2: a whole chapter)
                       --keep: put back only what is not yours to change

  ./wb run 2 [...]     the chapter's program with your code; its options:
                       ./wb run 2 --help, such as ./wb run 8 --machine wheels
  ./wb plot [2]        draw the figures: your curve over the solution's
  ./wb see [2]         the page that plays the motion, beside the solution's
  ./wb live [2]        the page in which the engine runs, with your code beside
                       the solution's: change settings, drag, iterate singly

  ./wb bench           error against run time; a joint's cost in larger scenes
  ./wb bench --stability   what is stiff, extreme or redundant: what holds what
  ./wb bench --methods every method on every kind of scene
  ./wb bench --families    scenes drawn by seeds: how many each setting holds
                       (--seed N, --draws N)
  ./wb bench --peers   ours beside Bullet, ODE and MuJoCo of Debian (--quick)
  ./wb bench --loop    a joint and iteration, from the textbook's loop to lanes
  ./wb bench --cost    rows, bytes and instructions of every kind of joint
  ./wb docs            the documentation as a site, with every motion
  ./wb keep            after a change: brings numbers, listings and pictures of
                       the texts and the stubs up to date, and says what changed

  ./wb grade DIR       of a class: what is done in every submission, also as
                       out/grades.csv. DIR is a submission or a folder of them;
                       a submission: a folder with distance.cpp and so on
"""
ANY = None
CALLED_FROM = Path.cwd()
# Of each command: the fewest and the most words that it takes, what they are, and its options.
# Those of check, run and bench are read where they are known.
TAKES = {"": (0, 0, "", []), "tour": (0, 0, "no argument", []), "docs": (0, 0, "no argument", []),
         "check": (0, ANY, "", ANY), "keep": (0, ANY, "", []), "bench": (0, ANY, "", ANY),
         "run": (1, ANY, "a chapter and options: ./wb run 2 --help", ANY),
         "test": (1, 1, "one exercise or chapter: ./wb test 1.1", []),
         "watch": (0, 1, "one exercise or chapter or none: ./wb watch 1.1", []),
         "grade": (1, ANY, "folders of submissions: ./wb grade class", []),
         "hint": (1, 2, "an exercise and 1, 2 or 3: ./wb hint 1.1", []),
         "show": (1, 1, "one exercise: ./wb show 1.1 (--yes: do not ask)", ["--yes"]),
         "reset": (1, 1, "one exercise or chapter (--yes, --keep)",
                   ["--yes", "--keep"]),
         "plot": (0, 1, "one chapter or none: ./wb plot 1", []),
         "see": (0, 1, "one chapter or none: ./wb see 1", []),
         "live": (0, 1, "one chapter or none: ./wb live 1", [])}


def refuse_unknown(command):
    """A command that does not exist: what may have been meant."""
    known = [name for name in TAKES if name] + ["help"]
    if re.fullmatch(r"\d+(\.\d+)?", command):
        meant = f"./wb test {command}"
    else:
        meant = next((f"./wb {name}" for name in difflib.get_close_matches(
            command.lower().lstrip("-"), known, 1, 0.6)), None)
    raise house.Trouble(f"{command}: no such command; "
                        + (f"did you mean {meant}?" if meant else "./wb help lists them"))


def check_words(command, arguments):
    """Refuses, in a line, what the command does not take."""
    least, most, what, options = TAKES[command]
    words = [a for a in arguments if not a.startswith("-")]
    wrong = [a for a in arguments if a.startswith("-") and options is not ANY and a not in options]
    wrong += words[most:] if most is not ANY else []
    if wrong or len(words) < least:
        raise house.Trouble(f"{command} takes {what}"
                            + (f"; {wrong[0]} is too much" if wrong else ""))
    return words


def help_of(command):
    """The lines of the help that are about a command."""
    parts = re.split(r"\n(?=  \./wb)", HELP)
    own = [part.strip("\n") for part in parts if part.startswith(f"  ./wb {command}")]
    return "\n".join(own) if command and own else HELP.strip("\n")


def main(arguments):
    command, rest = (arguments[0], arguments[1:]) if arguments else ("", [])
    if command in ("help", "--help", "-h"):
        print(help_of(rest[0] if rest else ""))
        return 0
    if command not in TAKES:
        refuse_unknown(command)
    if command != "run" and {"--help", "-h"} & set(rest):
        print(help_of(command))
        return 0
    words = check_words(command, rest)
    return call(command, words, rest)


def bench(options):
    """Error against run time, or what the options name: a suite or a table of its own each."""
    match options:
        case []:
            from bench import benchmark
            return benchmark.main()
        case ["--stability"]:
            from bench import stability
            return stability.main()
        case ["--methods"]:
            from bench import methods
            return methods.main()
        case ["--families", *rest] if set(rest[::2]) <= {"--seed", "--draws"}:
            from bench import families
            return families.main(rest)
        case ["--peers", *rest] if set(rest) <= {"--quick", "--search"}:
            from bench import peers
            return peers.main("--quick" in rest, "--search" in rest)
        case ["--loop"]:
            from bench import loop
            return loop.main()
        case ["--cost"] | ["--cost", "--keep"]:
            from bench import cost
            return cost.main(keep="--keep" in options)
    raise house.Trouble(f"bench: {' '.join(options)}: it takes --stability, --methods, "
                        "--families, --peers, --loop or --cost")


def call(command, words, rest):
    """Each command loads no more than it needs: ./wb is to answer at once."""
    match command:
        case "":
            from learn import status
            return status.status()
        case "test" | "watch":
            from learn import testing
            return getattr(testing, command)(words[0] if words else None)
        case "hint" | "show" | "reset":
            from learn import aid
            if command == "hint":
                return aid.hint(words[0], words[1] if len(words) == 2 else "1")
            if command == "show":
                return aid.solution(words[0], "--yes" in rest)
            return aid.reset(words[0], "--yes" in rest, "--keep" in rest)
        case "check":
            from check import checking
            return checking.check(rest)
        case "keep":
            from keep import keeping
            return keeping.keep(words)
        case "grade":
            from classroom import grading
            return grading.grade([CALLED_FROM / word for word in words])
        case "tour":
            from learn import tour
            return tour.tour()
        case "docs":
            from website import docs
            return docs.command()
        case "bench":
            return bench(rest)
        case "live":
            from website import live
            return live.live(house.chapter_of(words[0]) if words else None)
    from learn import show
    if command == "run":
        return show.run(house.chapter_of(rest[0]), rest[1:])
    return getattr(show, command)(house.chapter_of(words[0]) if words else None)


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
