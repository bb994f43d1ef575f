"""What students are handed out: hand_out_test.py ROOT BUILD"""
import contextlib
import io
import re
import shutil
import subprocess
import sys

from door import CHAPTER, Door
from front_door_test import typed
import solution_lines
import texts_test
from proofs import exercises, house, main, notes

from classroom import hand_out
from course import packing
from learn import own_numbers as own_numbers_, show

FILE = "distance.cpp"


def students_can_work_without_solutions(root, build):
    """an edition for students has no solution in it, and a student can work there"""
    with Door(root, build) as door:
        door.lend_build()
        yield from typed(door, "show 1.1 --yes", 0, "return {-n", wide=True)
        shutil.rmtree(door.root / "solutions")
        for words in ("", "test 1.1", "list", "run 1"):
            yield from typed(door, words, 2, "solutions/ is missing", wide=True)
        if not (root / ".git").exists():
            notes.append("no git here: no edition for students was made")
            return
        door.root = door.root.with_name("edition")
        door.file = door.root / "chapters" / CHAPTER / FILE
        show.SOLUTIONS = door.root.with_name("recorded")
        show.run_solution = lambda chapter: exercises.write(
            show.SOLUTIONS / chapter.folder / "summary.csv", "recorded")
        with contextlib.redirect_stdout(io.StringIO()):
            hand_out.hand_out(door.root)
        yield from solutions_in(door)
        yield from work_stays(door)
        yield from texts_test.links_lead_somewhere(door.root, build)
        yield from targets_of_edition(door)
        door.lend_build()
        yield from typed(door, "", 0, "Next: exercise 1.1", wide=True)
        yield from typed(door, "test 1.1", 1, "not written yet")
        yield from typed(door, "show 1.1 --yes", 2, "are not in this edition")
        yield from typed(door, "hint 1.1 3", 0, "Hint 3 of 3", hidden=["./wb show"])
        yield from typed(door, "tour", 2, "needs the solutions", "./wb see 1 show")
        yield from typed(door, "help", 0, "./wb test 2.1", hidden=["./wb tour", "./wb show"])
        door.write(e1_1=True, e1_2="return 0;")
        yield from typed(door, "test 1.1", 0, "6 tests passed")
        yield from typed(door, "test 1.2", 1, "Exercise 1.2", wide=True)
        yield from typed(door, "run 1", 2, "1.3 1.4 1.5 1.6 are not written yet", "./wb test 1.3",
                         wide=True)
        yield from typed(door, "reset 1.2 --yes", 0, "the stub is back", "reset/distance.cpp")
        door.write(e1_1=True)
        yield from typed(door, "reset 1 --yes", 0, "the stub is back", "reset/distance1.cpp")
        exercises.write(door.file, door.solution)
        yield from typed(door, "test 1", 0, "tests passed")
        yield from typed(door, "run 1", 0, "your code: 1.1 1.2 1.3 1.4 1.5 1.6", "rises 0.1 mm")
        yield from own_numbers(door)
        door.change("sum = glm::max(before + dlambda", "sum = before + glm::max(dlambda")
        yield from typed(door, "run 1", 0, "1.5 is not right yet", "rises 58.6 mm")


def work_stays(door):
    """An update renews a text and leaves exercises and solutions that are handed out."""
    written, solved = "// mine", door.root / "solutions" / CHAPTER / FILE
    text = door.root / "chapters" / CHAPTER / "README.md"
    stub, before = exercises.read(door.file), exercises.read(text)
    for path, words in ((door.file, written), (solved, door.solution), (text, "old"),
                        (door.root / "notes.txt", written)):
        exercises.write(path, words)
    with contextlib.redirect_stdout(io.StringIO()):
        hand_out.update(door.root)
    for path, words in ((door.file, written), (solved, door.solution), (text, before),
                        (door.root / "notes.txt", written)):
        if exercises.read(path) != words:
            yield f"after an update {path.name} is {exercises.read(path)[:60]}"
    exercises.write(door.file, stub)
    exercises.write(solved, exercises.stub(door.solution))
    (door.root / "notes.txt").unlink()
    try:
        hand_out.update(door.root.parent)
        yield "a folder that is no edition was renewed"
    except house.Trouble:
        pass


def own_numbers(door):
    """Two students have other numbers, each the same in every run; the tables of their code and of
    the solution agree to the last digit."""
    tables = {}
    for name in ("ada", "bob", " ADA"):
        yield from typed(door, f"run 1 --for {name}", 0, "numbers of", "on paper")
        tables[name] = (door.root / "out" / "mine" / CHAPTER / "pendulum.csv").read_text()
        options, _ = own_numbers_.drawn(name, house.chapters()[0], house.options_of(
            f"{CHAPTER}_run"))
        subprocess.run([house.BUILD / f"{CHAPTER}_run", "--out", door.root / "solved", *options],
                       capture_output=True, check=True)
        if tables[name] != (door.root / "solved" / "pendulum.csv").read_text():
            yield f"{name}: right code prints another table than the solution"
    yield from typed(door, "run 1 --iterations 5 --for ada", 0, "numbers of ada: --beta")
    yield from typed(door, "plot 1", 0, "your run alone, with --beta")
    if tables["ada"] != tables[" ADA"] or tables["ada"] == tables["bob"]:
        yield "ada and bob have the same numbers, or ada has others the second time"


def solutions_in(door):
    """Lines of solutions in any text file of the edition. A line that is put there is found, also
    with other names, and so is a solution."""
    answers = solution_lines.known()
    for name, id_, line in solution_lines.found(door.root, answers):
        yield f"{name} has a line of the solution of {id_}: {line}"
    said = packing.about(house.chapters()[0], students=True)
    exercises.write(door.root.with_name("browser") / "words.txt", "\n".join(
        words for words in said.values() if isinstance(words, str)))
    yield from (f"the course of students has a line of {id_}: {line}" for _, id_, line in
                solution_lines.found(door.root.with_name("browser"), answers))
    folder = door.root.with_name("planted")
    exercises.write(folder / "cases.h", """const Row mine{-d,
                   -cross(arm, d), d, cross(other, d)};""")
    exercises.write(folder / "pair.h", "vec3 a = direction(pair.body2.x - pair.body1.x);")
    for chapter in house.chapters():
        shutil.copy(chapter.solution, folder)
    seen = solution_lines.found(folder, answers)
    if not {"cases.h", "pair.h"} <= {name for name, _, _ in seen}:
        yield "the row of a rod is not found where its vectors or bodies have other names"
    if lost := set(answers.values()) - {one[1:] for one in seen}:
        yield f"of a solution these lines are not found: {lost}"


def targets_of_edition(door):
    """In the edition a chapter is built on the student's earlier ones, until their solutions are
    handed out; every target of a student's can be made."""
    def links(target):
        said = subprocess.run(["ninja", "-C", build, "-t", "inputs", target], capture_output=True,
                              text=True).stdout
        return set(re.findall(r"\blib01_distance(?:_units|)(?:_mine|)(?:_file|)\.a$", said, re.M))
    build = door.root.with_name("configured")
    names = [f"{chapter.folder}_{kind}_mine" for chapter in house.chapters()
             for kind in ("test", "run", "units")]
    for released, kind in ((False, "_mine"), (True, "")):
        if released:
            exercises.write(door.root / "solutions" / CHAPTER / FILE, door.solution)
        made = subprocess.run(["cmake", "-S", door.root, "-B", build, "-G", "Ninja"],
                              capture_output=True, text=True)
        made = made if made.returncode else subprocess.run(
            ["ninja", "-C", build, "-n", *names], capture_output=True, text=True)
        if made.returncode:
            yield f"the edition cannot be built: {(made.stdout + made.stderr)[-600:]}"
        for target, wanted in (("test", f"{kind}.a"), ("run", f"{kind}.a"),
                               ("units", f"_units{kind}_file.a")):
            found = links(f"02_ball_{target}_mine")
            if found != {f"lib01_distance{wanted}"}:
                yield f"02_ball_{target}_mine is made with {found}, not {wanted}"
    exercises.write(door.root / "solutions" / CHAPTER / FILE, exercises.stub(door.solution))


PROOFS = [students_can_work_without_solutions]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
