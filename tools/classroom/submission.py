"""Grades one exercise file that somebody has handed in, in a process of its own that ./wb grade
starts and may end: submission.py FOLDER NN_name FENCE

FOLDER is laid out as the workbook is: chapters/NN_name/name.cpp, compiled/name.cpp, which is made
of it, and build/, which links with the workbook's. Only what is compiled and run of the file is
within a fence: FENCE is the compiler's, in JSON. A line of the output that begins with [ is the
grades and the notes in JSON; the last one counts.
"""
import json
import re
import resource
import sys
from collections import Counter
from dataclasses import asdict, dataclass, replace
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from base import exercises  # noqa: E402
from classroom import asking, fence  # noqa: E402
from judge import grade as grading  # noqa: E402
from base import house  # noqa: E402
from judge import reading  # noqa: E402

# Of every process: processor time [s], a file, memory [bytes]. Tests have less, see runs.py.
LIMITS = {resource.RLIMIT_CPU: 60, resource.RLIMIT_FSIZE: 64 << 20, resource.RLIMIT_AS: 4 << 30,
          resource.RLIMIT_CORE: 0}
# The lines outside the exercises: as handed in, the given ones with the includes that were handed
# in, the given ones alone.
OWN, GIVEN, ONLY_GIVEN = range(3)


@dataclass
class HandedIn(house.Chapter):
    """A chapter of the workbook, with somebody else's exercise file."""
    home: Path = Path()

    @property
    def mine(self):
        return self.home / "chapters" / self.folder / f"{self.name}.cpp"


@dataclass
class Within:
    """Puts what runs within a fence: the compiler within its own, and tests within one in which
    they write nothing but their report."""
    folder: Path
    compiler: fence.Fence

    def around(self, command, report):
        return (self.compiler if report is None else fence.Fence(
            str(self.folder), [str(self.folder / "chapters"), str(self.folder / "build" / "tests")],
            [report])).around(command)

    def end(self):
        return fence.end_children()


class Judge:
    """Grades the exercises. A wrong one is replaced by its solution, so that it costs
    the others nothing: those that are right then wait for it."""

    def __init__(self, chapter):
        self.chapter, self.text = chapter, chapter.mine_text()
        self.solution = exercises.read(chapter.solution)
        self.look = reading.look(chapter)
        self.outside = reading.changed_outside(exercises.stub(self.solution), self.text)
        self.frame, self.taken = OWN, set()
        self.settled, self.notes = {}, asking.notes(self.text)

    def say(self):
        """What is known so far, without the folder's name."""
        left = [grading.Grade(id_, grading.OPEN) if id_ not in self.look.written() else
                grading.Grade(id_, grading.WRONG, failures=[("", "its tests did not end in time")])
                for id_ in self.chapter.ids() if id_ not in self.settled]
        grades = [*self.settled.values(), *left]
        print(json.dumps([[asdict(one) for one in grades], self.notes]).replace(
            f"{self.chapter.home}/", ""), flush=True)

    def settle(self, id_, status, detail):
        self.settled[id_] = grading.Grade(id_, status, detail)
        self.taken.add(id_)

    def judge(self):
        for id_, words, _ in self.look.faults:
            if id_ and id_ not in self.settled:
                self.settle(id_, grading.BROKEN, words)
        if words := asking.refused(self.text):
            self.notes.append(words[0].upper() + words[1:])
        if not self.text.strip():
            words = "the file is empty"
        if words or len(self.settled) < len(self.chapter.ids()) and not self.build():
            for id_ in self.chapter.ids():
                if id_ not in self.settled or words:
                    self.settle(id_, grading.BROKEN, words or self.log)
            return
        written = [id_ for id_ in self.look.written() if id_ not in self.settled]
        self.say()
        grades = grading.grade(self.chapter, written, fresh=True) if written else []
        grades = self.with_given_lines(grades)
        if self.outside:
            self.notes.append(f"Outside the exercises line{self.outside} "
                              f"{'have' if self.outside.startswith('s') else 'has'} changed"
                              + ("; what counts are the given lines." if self.frame else "."))
        self.peel(grades)

    # ---- compiling -----------------------------------------------------------------------------

    def build(self):
        """Builds the tests with as much of the file as compiles. False: with nothing of it."""
        if any(broken for _, broken in map(marker_fault, self.look.faults)):
            self.frame = GIVEN
        while True:
            self.log = self.compile()
            if not self.log:
                return True
            if id_ := self.first_to_fail():
                self.settle(id_, grading.BROKEN, self.log)
            elif self.frame == ONLY_GIVEN:
                return False
            else:
                self.frame += 1
                if self.frame == GIVEN:
                    self.notes.append("What is outside the exercises does not compile; the given "
                                      f"lines were put in its place. {first_error(self.log)}")

    def compile(self):
        exercises.write(self.chapter.home / "compiled" / self.chapter.mine.name, self.composed())
        try:
            return grading.build(self.chapter)
        except house.Trouble as trouble:  # an error without a place in the file
            return str(trouble)

    def first_to_fail(self):
        """The exercise in which the compiler's first error lies."""
        place = re.search(rf"^{re.escape(self.chapter.mine.name)}:(\d+):\d+: (?:fatal )?error",
                          self.log.replace(f"{self.chapter.mine.parent}/", ""), re.M)
        return next((region.id for region in exercises.scan(self.text)[0] if place and
                     region.begin <= int(place[1]) <= region.end + 2
                     and region.id not in self.taken), None)

    def composed(self):
        """The file with the solution of those that are taken from it. Every line keeps its number
        for the compiler."""
        base = self.text if self.frame == OWN else self.solution
        own = {}
        for region in exercises.scan(self.text)[0]:
            own.setdefault(region.id, []).append(region)
        solved = {}
        for region in exercises.regions(self.solution):
            solved.setdefault(region.id, []).append(region)
        lines, said, at, count = base.split("\n"), [], 0, Counter()
        frame = self.chapter.mine if self.frame == OWN else "given_lines.cpp"
        if self.frame == GIVEN:
            said += [f'#line 1 "{self.chapter.mine}"', *extra_includes(self.text, self.solution)]
        for region in exercises.scan(base)[0]:
            said += [f'#line {at + 1} "{frame}"', *lines[at:region.begin]]
            place, at = count[region.id], region.end
            count[region.id] += 1
            mine = own.get(region.id, [])
            if region.id not in self.taken and len(mine) == len(solved.get(region.id, [])):
                said += [f'#line {mine[place].begin + 1} "{self.chapter.mine}"',
                         *mine[place].lines]
            elif place < len(solved.get(region.id, [])):
                said += ['#line 1 "solution.cpp"', *solved[region.id][place].lines]
        return "\n".join([*said, f'#line {at + 1} "{frame}"', *lines[at:]])

    # ---- which exercise is to blame --------------------------------------------------------------

    def with_given_lines(self, grades):
        """Where lines outside the exercises have changed and something is wrong: the grades with
        the given lines, if they are better."""
        wrong = [one.id for one in grades if one.status == grading.WRONG]
        if not (self.outside and wrong and self.frame == OWN):
            return grades
        self.frame = GIVEN
        better = [] if self.compile() else \
            grading.grade(self.chapter, [one.id for one in grades], fresh=True)
        if better and sum(one.status == grading.WRONG for one in better) < len(wrong):
            return better
        self.frame = OWN
        return grades

    def peel(self, grades):
        """Settles the grades. The first that is wrong is to blame for itself; the others are tried
        again with the solution's version of it, and of those that are not written."""
        blamed = []
        while grades:
            for one in grades:
                if one.status == grading.DONE and blamed:
                    one = replace(one, status=grading.WAITS, detail=", ".join(blamed))
                if one.status in (grading.DONE, grading.WAITS) and one.detail not in self.open():
                    self.settled[one.id] = one
            left = [one for one in grades if one.id not in self.settled]
            missing = {one.detail for one in left if one.status == grading.WAITS}
            first = next((one for one in left if one.status == grading.WRONG), None)
            if first:
                self.settled[first.id] = first
            new = sorted((missing | ({first.id} if first else set())) - self.taken)
            blamed += new
            self.taken |= set(new)
            self.say()
            left = [one for one in left if one.id not in self.settled]
            if not left or not new or self.compile():
                for one in left:
                    self.settled[one.id] = one
                break
            grades = grading.grade(self.chapter, [one.id for one in left], fresh=True)

    def open(self):
        """What is not written yet."""
        return {id_ for id_ in self.chapter.ids() if id_ not in self.look.written()} - self.taken


def marker_fault(fault):
    """(exercise, whether its markers are at fault and not its braces)."""
    id_, words, cure = fault
    return id_, "mend it" not in cure


def extra_includes(mine, solution):
    """The includes of the standard library that the given lines do not have."""
    def of(text):
        return re.findall(r"^#include <[\w./+]+>", text, re.M)
    return [line for line in dict.fromkeys(of(mine)) if line not in of(solution)]


def first_error(log):
    return next((line for line in log.split("\n") if "error" in line.lower()), "")


def main(folder, chapter, compiler):
    for limit, most in LIMITS.items():
        resource.setrlimit(limit, (most, most))
    house.BUILD = folder / "build"
    house.fence = Within(folder, compiler)
    fence.adopt()
    judge = Judge(HandedIn(chapter.number, chapter.folder, chapter.name, folder))
    try:
        judge.judge()
    except house.Trouble as trouble:
        for id_ in judge.look.written():
            judge.settled.setdefault(id_, grading.Grade(id_, grading.BROKEN, str(trouble)))
    judge.say()


if __name__ == "__main__":
    main(Path(sys.argv[1]), house.chapter_of(sys.argv[2]), fence.Fence(**json.loads(sys.argv[3])))
