"""What ./wb grade makes of what a class has handed in: grade_test.py ROOT BUILD"""
import csv
import hashlib
import sys

from door import CHAPTER, Door
from front_door_test import typed
from proofs import exercises, main, notes

from classroom import fence

FILE = "distance.cpp"
IDS = [f"1.{n}" for n in range(1, 7)]
DONE, OPEN, WRONG, BROKEN = "done", "not written yet", "wrong", "does not compile"


def answer(door, id_, code):
    """The solution with other code in the first region of an exercise."""
    return exercises.replace(door.solution, lambda region, place: [*region.task(), code]
                             if (region.id, place) == (id_, 1) else None)


def at_start(door, code):
    """The solution, and code that runs before the tests do."""
    return f"{door.solution}\nnamespace {{ [[maybe_unused]] const int early = {code}; }}\n"


def hand_in(door, name, text, place=FILE):
    exercises.write(door.root.parent / "class" / name / place, text)


def table(door):
    """{submission: what the table of comma separated values says of it}, without its heading."""
    with open(door.root / "out" / "grades.csv", newline="") as file:
        heading, *rows = csv.reader(file)
    assert heading == ["submission", *IDS, "done"], heading
    return {row[0]: row[1:] for row in rows}


def tree(door):
    """What every file of the copy holds, but for what grading makes."""
    return {path: hashlib.sha1(path.read_bytes()).hexdigest() for path in door.root.rglob("*")
            if path.is_file() and path.parent.name != "out"}


def graded(door, expected):
    """What is wrong with the grades of the class: {submission: the states of 1.1 to 1.6}."""
    before = tree(door)
    yield from typed(door, f"grade {door.root.parent}/class", 0, f"{len(expected)} submission",
                     "the table: out/grades.csv")
    found = table(door)
    for name, states in expected.items():
        count = states.count(DONE)
        if found.get(name) != [*states, str(count)]:
            yield f"{name}: {found.get(name)}, not {states}"
    total = [sum(states[n] == DONE for states in expected.values()) for n in range(len(IDS))]
    if found.get("done in all") != [str(n) for n in (*total, sum(total))]:
        yield f"in all: {found.get('done in all')}, not {total}"
    if set(found) != {*expected, "done in all"}:
        yield f"the table has {sorted(found)}"
    after = tree(door)
    yield from (f"{path} has changed" for path in sorted(set(before) | set(after))
                if before.get(path) != after.get(path))


def only_the_exercise_file_counts(root, build):
    """finished, untouched and wrong files are told apart, wherever they lie in a submission"""
    with Door(root, build) as door:
        door.lend_build()
        hand_in(door, "finished", door.solution)
        for other in ("distance.h", "CMakeLists.txt", "tests/test.cpp", "engine/body.h"):
            hand_in(door, "finished", "#error not ours", other)
        hand_in(door, "untouched", exercises.stub(door.solution), f"chapters/{CHAPTER}/{FILE}")
        hand_in(door, "begun", exercises.fill(exercises.stub(door.solution), door.solution,
                                              ["1.1", "1.2"]), f"{CHAPTER}/{FILE}")
        hand_in(door, "incorrect", answer(door, "1.6", "return {};"))
        hand_in(door, "no_compiler", answer(door, "1.6", "return nonsense;"))
        hand_in(door, "no_marker", door.solution.replace("// end [exercise 1.2]", ""))
        hand_in(door, "nothing", "Sorry.", "letter.txt")
        hand_in(door, ".hidden", door.solution)
        yield from graded(door, {
            "finished": [DONE] * 6, "untouched": [OPEN] * 6, "begun": [DONE] * 2 + [OPEN] * 4,
            "incorrect": [DONE] * 5 + [WRONG], "no_compiler": [BROKEN] * 6,
            "no_marker": [BROKEN] * 6, "nothing": ["not handed in"] * 6})
        where = door.root.parent / "class"
        yield from typed(door, f"grade {where}/incorrect", 0, "1 submission: 5 done, 1 wrong",
                         "Exercise 1.6", f"Where: chapters/{CHAPTER}/{FILE}:")
        yield from typed(door, f"grade {where}/no_compiler", 0, "6 not compiling",
                         "‘nonsense’ was not declared", wide=True)
        yield from typed(door, f"grade {where}/begun {where}/finished", 0, "2 submissions: 8 done")


def none_harms_the_others(root, build):
    """a loop without end, a crash, exit(), greed: none harms the others, none is called done"""
    with Door(root, build) as door:
        door.lend_build()
        hand_in(door, "endless", answer(door, "1.6", "for (volatile bool on = true; on;) {}\n"
                                                     "  return {};"))
        hand_in(door, "crash", answer(door, "1.6", "*(volatile int*)nullptr = 0;\n  return {};"))
        hand_in(door, "exit_inside", "#include <cstdlib>\n" + answer(door, "1.6", "std::exit(0);"))
        hand_in(door, "exit_early", "#include <cstdlib>\n" + at_start(door, "(std::exit(0), 1)"))
        hand_in(door, "greedy", "#include <vector>\n" + answer(
            door, "1.6", "std::vector<double> all(1);\n"
                         "  for (;;) all.resize(2 * all.size());\n  return {};"))
        hand_in(door, "background", "#include <unistd.h>\n" + at_start(
            door, "fork() == 0 ? sleep(1000) : 0"))
        expected = {name: [DONE] * 5 + [WRONG]
                    for name in ("endless", "crash", "exit_inside", "greedy")}
        expected |= {"background": [DONE] * 6, "exit_early": [WRONG] * 6}
        if fence.version() >= 6:
            hand_in(door, "killer", "#include <csignal>\n" + at_start(door, "kill(-1, SIGKILL)"))
            expected["killer"] = [WRONG] * 6
        yield from graded(door, expected)


def none_writes_into_the_tree(root, build):
    """a submission that writes beside itself or into the workbook changes nothing there"""
    with Door(root, build) as door:
        door.lend_build()
        places = [f"chapters/{CHAPTER}/distance.h", "README.md", f"../chapters/{CHAPTER}/{FILE}"]
        if fence.version():
            places += [f"{door.root}/{path}" for path in (
                places[0], "tools/judge/grade.py", "new_file", "build/build.ninja",
                "out/grades.csv")]
        else:
            notes.append("no Landlock here: writing to absolute paths was not tried")
        code = " && ".join(f'!(std::ofstream("{path}") << 1)' for path in places[2:])
        hand_in(door, "writer", "#include <fstream>\n" + at_start(
            door, f'(std::ofstream("{places[0]}"), std::ofstream("{places[1]}"), {code}, 1)'))
        hand_in(door, "neighbour", door.solution)
        yield from graded(door, {"writer": [DONE] * 6, "neighbour": [DONE] * 6})


def what_is_expected_is_said(root, build):
    """a command line without a submission says what one is"""
    with Door(root, build) as door:
        (door.root / "empty").mkdir()
        yield from typed(door, "grade", 2, "required: DIR (./wb grade --help)")
        yield from typed(door, "grade nowhere", 2, "nowhere: there is no such folder")
        yield from typed(door, "grade empty", 2, "there is no exercise file",
                         "exercise files such as distance.cpp", "./wb grade class", wide=True)
        yield from typed(door, "grade empty --fast", 2, "arguments: --fast")
        yield from typed(door, "help grade", 0, "./wb grade class", hidden=["./wb tour"])


PROOFS = [only_the_exercise_file_counts, none_harms_the_others, none_writes_into_the_tree,
          what_is_expected_is_said]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
