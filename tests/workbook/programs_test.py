"""The programs: what they carry, refuse and repeat: programs_test.py ROOT BUILD"""
import csv
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from proofs import house, main, read, regions

from judge import grade


# Every program: a symbol that it uses, and those that it must not carry. Chapters 1 and 2 run on
# the reader's own loop, so on no solver and no joint of the engine.
OWN_LOOP = r"SequentialImpulses|\w*Joint"
LATER = {3: r"Axis::|HingeAngle|HingeJoint|Limit<", 4: r"Line::|Slide::|RotationLock|SliderJoint",
         5: r"Weld|FixedJoint|cross_K|carried",
         6: r"limit_bias|beta_for|warm_start\(|projection_iteration|project\(",
         7: r"colours_of|whole_K|hoist|LanesFor|PackedImpulses",
         8: r"GroundContact|Corner::|friction_impulse|impact_speed",
         9: r"JointMatrix|DirectSolver|elimination_order|second_order_step|stiffened"}
ALL, LAST = "|".join(LATER.values()), f"{LATER[8]}|{LATER[9]}"
PROGRAMS = {
    "01_distance_run": ("step(std::vector", rf"Point::|block_impulse|turned\(|{OWN_LOOP}|{ALL}"),
    "02_ball_run": ("block_impulse", f"{OWN_LOOP}|{ALL}"),
    "03_hinge_run": ("Axis::", "|".join(LATER[k] for k in range(4, 10))),
    "04_slider_run": ("Line::", rf"{LATER[5]}|{LATER[6]}|{LAST}|HingeJoint|HingeAngle"),
    "05_fixed_run": ("FixedJoint::", rf"{LATER[6]}|{LATER[7]}|{LAST}"),
    "06_baumgarte_run": ("projection_iteration", rf"{LATER[5]}|{LATER[7]}|{LAST}"),
    "07_performance_run": ("colours_of",
                           "|".join([OWN_LOOP, LAST, *(LATER[k] for k in (4, 5, 6))])),
    "08_ground_run": ("GroundContact", "|".join([LATER[6].replace("limit_bias|", ""), LATER[7],
                                                 LATER[9]])),
    "09_direct_run": ("DirectSolver", "|".join(LATER[k] for k in (6, 7, 8)))}
ALL_OF_THEM = [*PROGRAMS, *(program for program in house.programs() if program not in PROGRAMS)]


def run(program, *arguments, **more):
    return subprocess.run([str(program), *arguments], capture_output=True, text=True, timeout=60,
                          **more)


def programs_carry_what_they_use(root, build):
    """a program carries no symbol of joints that it does not use"""
    for program, (used, foreign) in PROGRAMS.items():
        symbols = run("nm", "-C", str(build / program)).stdout
        if f"joints::{used}" not in symbols:
            yield f"{program}: nm shows no symbols"
        for symbol in sorted(set(re.findall(rf"joints::(?:{foreign})\w*", symbols))):
            yield f"{program} carries {symbol}"


def bad_words_are_refused(root, build):
    """a bad command line gets one line that names the option, and exit status 2"""
    bad = ["--nonsense", "--iterations 0", "--iterations x", "--iterations", "--seconds -1",
           "--beta nan", "nonsense", "--seconds 0.1 --out file/below"]
    for program in ALL_OF_THEM:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "file").write_text("")
            for words in bad:
                result = run(build / program, *words.split(), cwd=folder)
                name = "out" if "--out" in words else words.split()[0]
                if result.returncode != 2:
                    yield f"{program} {words}: exit status {result.returncode}, not 2"
                elif result.stderr.count("\n") != 1 or name not in result.stderr:
                    yield f"{program} {words}: says {result.stderr!r}"
                if os.listdir(folder) != ["file"]:
                    yield f"{program} {words}: writes something all the same"
            help_ = run(build / program, "--help", cwd=folder)
            if help_.returncode != 0 or help_.stderr or "--iterations" not in help_.stdout:
                yield f"{program} --help: exit status {help_.returncode}, {help_.stderr!r}"


def crashes_are_placed(root, build):
    """a crash is told in plain words, at the one region of its exercise that it can come from"""
    def place_of(said, id_, clue, others):
        chapter, _ = house.exercise_of(id_)
        found = [r for r in regions(chapter) if r.id == id_ and clue in "".join(r.answer())]
        told = grade.with_place(grade.plainly(said), SolutionOf(chapter), id_)
        for words in (*others, f"{chapter.solution.name}:{found[0].begin}\n"):
            if words not in told:
                yield f"a crash of {id_} is told without '{words.strip()}': {told}"
    yield from place_of("std::clamp(...): Assertion '!(__hi < __lo)' failed.", "8.2", "clamp(",
                        ["clamp(a, low, high)"])
    yield from place_of("/usr/include/c++/12/array:208: constexpr std::array<_Tp, _Nm>::value_type&"
                        " std::array<_Tp, _Nm>::operator[](size_type) [with _Tp = joints::Row; long"
                        " unsigned int _Nm = 2; reference = joints::Row&; size_type = long unsigned"
                        " int]: Assertion '__n < this->size()' failed.", "4.1", "Jacobian<2> J",
                        ["an array of 2 rows: its places run from 0 to 1"])


class SolutionOf:
    """A chapter whose solution stands in the place of the reader's file."""
    def __init__(self, chapter):
        self.mine, self.place = chapter.solution, chapter.place


def programs_repeat_themselves(root, build):
    """a program that runs twice writes the same tables and motions, apart from times"""
    for program in ALL_OF_THEM:
        with tempfile.TemporaryDirectory() as folder:
            one, two = Path(folder) / "one", Path(folder) / "two"
            for out in (one, two):
                result = run(build / program, "--seconds", "0.1", "--out", str(out))
                if result.returncode != 0:
                    yield f"{program}: exit status {result.returncode}: {result.stderr.strip()}"
            if program in PROGRAMS and not (one / "summary.csv").is_file():
                yield f"{program} writes no summary.csv"
            for path in sorted(one.glob("*.*")):
                if untimed(path) != untimed(two / path.name):
                    yield f"{program}: {path.name} differs from run to run"
                if path.suffix == ".csv" and len({len(row) for row in table(path)}) != 1:
                    yield f"{program}: {path.name} has rows that are longer than its header"


def table(path):
    return list(csv.reader(read(path).splitlines()))


def untimed(path):
    """What a file says, without the columns that hold times."""
    if path.suffix != ".csv":
        return read(path)
    rows = table(path)
    timed = [k for k, column in enumerate(rows[0]) if re.match(r"(us|ns)_", column)]
    return [[word for k, word in enumerate(row) if k not in timed] for row in rows]


def chapters_compare_methods(root, build):
    """`./wb run N --compare` has a scene of every chapter, and refuses an option in one line"""
    for chapter in house.chapters():
        result = run(build / "tests" / "compare_chapter", str(chapter.number), "--seconds", "0.1",
                     "--gap", "0.1")
        if result.returncode or not re.search("The fastest that|None meets", result.stdout):
            yield f"chapter {chapter.number}: {result.returncode}, {result.stdout[-80:]!r}"
    for words in ("12", "3 --nonsense 1", "3 --gap x", "3 --seconds 0"):
        result = run(build / "tests" / "compare_chapter", *words.split())
        if result.returncode != 2 or result.stderr.count("\n") != 1:
            yield f"{words}: {result.returncode}, {result.stderr!r}"


PROOFS = [programs_carry_what_they_use, bad_words_are_refused, crashes_are_placed,
          programs_repeat_themselves, chapters_compare_methods]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
