"""wb: the one command of the workbook. `./wb help` lists what it can do."""
import os
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import checking  # noqa: E402
import docs   # noqa: E402
import house  # noqa: E402
import learn  # noqa: E402
import show   # noqa: E402

HELP = """The Joint Workbook

  ./wb                 where am I: every exercise, and the next thing to do
  ./wb tour            build, run every chapter's program, draw every figure, print the summary
  ./wb check           the workbook's own tests (./wb check 3: of one chapter; --quick: without
                       float, units and known answers)

  ./wb test 2.1        test one exercise (or a whole chapter: ./wb test 2)
  ./wb watch [2.1]     test again whenever you save
  ./wb hint 2.1 [1-3]  a hint: 1 is a nudge, 3 is nearly the answer
  ./wb show 2.1        the solution of an exercise
  ./wb reset 2.1       put the empty stub back (or a whole chapter: ./wb reset 2)

  ./wb run 2 [...]     the chapter's program with your code (--help lists its options)
                       such as ./wb run 8 --machine wheels: one machine alone
  ./wb plot [2]        draw the figures: your curve over the solution's
  ./wb see [2]         the page that plays the motion: yours beside the solution's

  ./wb bench           error against run time, and what a joint costs in larger scenes
  ./wb bench --stability   what is stiff, extreme or redundant: which method holds what
  ./wb bench --loop    what a joint and sweep costs, from the textbook's loop to lanes
  ./wb bench --cost    rows, bytes and instructions of every kind of joint
  ./wb docs            the documentation as a site, with a gallery of every motion
"""


def one_argument(arguments, what):
    if len(arguments) != 1:
        raise house.Trouble(f"say which {what}, for example 2.1 or 2")
    return arguments[0]


def one_at_most(command, arguments):
    if len(arguments) > 1:
        raise house.Trouble(f"{command} takes one chapter at most; "
                            f"{' '.join(arguments[1:])} is too many")
    return arguments[0] if arguments else None


def main(arguments):
    yes = "--yes" in arguments
    arguments = [a for a in arguments if a != "--yes"]
    command, rest = (arguments[0], arguments[1:]) if arguments else ("", [])
    takes_none = {"": learn.status, "tour": show.tour, "bench": None,
                  "docs": docs.command}
    if command in takes_none and rest and command != "bench":
        raise house.Trouble(f"{command} takes no argument; {' '.join(rest)} is one too many")
    match command:
        case "help" | "--help" | "-h":
            print(HELP, end="")
        case "" | "tour" | "docs":
            return takes_none[command]()
        case "check":
            return checking.check(rest)
        case "bench":
            return show.bench(rest)
        case "test":
            return learn.test(one_argument(rest, "exercise or chapter"))
        case "watch":
            return learn.watch(one_at_most(command, rest))
        case "hint":
            if not rest or len(rest) > 2:
                raise house.Trouble("say which exercise, for example ./wb hint 2.1")
            return learn.hint(rest[0], rest[1] if len(rest) == 2 else "1")
        case "show":
            return learn.solution(one_argument(rest, "exercise"), yes)
        case "reset":
            return learn.reset(one_argument(rest, "exercise or chapter"), yes)
        case "run":
            if not rest:
                raise house.Trouble("say which chapter, for example ./wb run 2")
            return show.run(house.chapter_of(rest[0]), rest[1:])
        case "plot" | "see":
            number = one_at_most(command, rest)
            return getattr(show, command)(house.chapter_of(number) if number else None)
        case _:
            raise house.Trouble(f"{command}: no such command; ./wb help lists them")
    return 0


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
