"""Grades one exercise file that somebody has handed in, in a process of its own that ./wb grade
starts and may end: submission.py FOLDER NN_name FENCE

FOLDER is laid out as the workbook is: chapters/NN_name/name.cpp, compiled/name.cpp, which is made
of it, and build/, which links with the workbook's. Only what is compiled and run of the file is
within a fence: FENCE is the compiler's, in JSON. A line of the output that begins with [ is the
grades and the notes in JSON; the last one counts.
"""
import difflib
import itertools
import json
import re
import resource
import sys
from collections import Counter
from dataclasses import asdict, dataclass, replace
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import exercises  # noqa: E402
from classroom import fence, symbols  # noqa: E402
from judge import grade as grading  # noqa: E402
from base import house  # noqa: E402
from judge import includes, reading  # noqa: E402

# Of every process: processor time [s], a file, memory [bytes]. Tests have less, see runs.py.
LIMITS = {resource.RLIMIT_CPU: 60, resource.RLIMIT_FSIZE: 64 << 20, resource.RLIMIT_AS: 4 << 30,
          resource.RLIMIT_CORE: 0}
FORGED = "It was not run: it {}, which no exercise needs and by which a result can be forged."
NEVER_WAITS = "it throws that exercise {} is not written yet, which is not so"


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
        fence.end_children()


class Judge:
    """Grades the exercises. A wrong one is replaced by its solution, so that it costs
    the others nothing: those that are right then wait for it."""

    def __init__(self, chapter):
        self.chapter, self.text = chapter, chapter.mine_text()
        self.solution = exercises.read(chapter.solution)
        self.look = reading.look(chapter)
        self.outside = reading.changed_outside(exercises.stub(self.solution), self.text)
        self.added, self.taken = added(self.solution, self.text), set()
        self.settled, self.notes = {}, includes.notes(self.text)

    def say(self):
        """What is known so far, without the folder's name."""
        left = [grading.Grade(id_, grading.OPEN) if id_ not in self.look.written() else
                grading.Grade(id_, grading.WRONG, failures=[("", "its tests did not end in time")])
                for id_ in self.chapter.ids() if id_ not in self.settled]
        grades = [*self.settled.values(), *left]
        said = json.dumps([[asdict(one) for one in grades], self.notes])
        for home in (self.chapter.home, house.short(self.chapter.home)):
            said = said.replace(json.dumps(f"{home}/")[1:-1], "")
        print(said, flush=True)

    def settle(self, id_, status, words):
        self.settled[id_] = grading.Grade(id_, status, words) if status == grading.BROKEN else \
            grading.Grade(id_, status, failures=[("", words)])
        self.taken.add(id_)

    def judge(self):
        for id_, words, _ in self.look.faults:
            if id_ and id_ not in self.settled:
                self.settle(id_, grading.BROKEN, words)
        if words := includes.refused(self.text):
            self.notes = [words[0].upper() + words[1:]]
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
        grades = self.without_added(grades)
        if self.outside:
            self.notes.append(f"Outside the exercises line{self.outside} "
                              f"{'have' if self.outside.startswith('s') else 'has'} changed; "
                              "what counts are the given lines"
                              + " and what is added between them" * bool(self.added) + ".")
        self.peel(grades)

    # ---- compiling -----------------------------------------------------------------------------

    def build(self):
        """Builds the tests with as much of the file as compiles and reaches for nothing that is
        not its own. False: with nothing of it."""
        while True:
            self.log = self.compile()
            if not self.log and not self.forges():
                return True
            if id_ := self.log and self.first_to_fail():
                self.settle(id_, grading.BROKEN, self.log)
            elif self.added and (fault := self.alone(None)):
                self.added = {}
                self.notes.append("What is added outside the exercises was left out. "
                                  + (first_error(fault[1]) or fault[1]))
            elif not self.settle_alone():
                self.log = self.log or self.forges()
                return False

    def compile(self):
        exercises.write(self.chapter.home / "compiled" / self.chapter.mine.name, self.composed())
        try:
            return grading.build(self.chapter)
        except house.Trouble as trouble:  # an error without a place in the file
            return str(trouble)

    def forges(self):
        """What the object reaches for that no exercise needs, in a sentence; "": nothing."""
        words = symbols.unneeded(next((self.chapter.home / "build").rglob(
            f"{self.chapter.mine.name}.o")), lambda words: house.fenced(words, None))
        return FORGED.format(words) if words else ""

    def alone(self, id_):
        """(status, why) of one exercise, or of none, beside the solution of the others; None where
        nothing is wrong."""
        kept, self.taken = self.taken, set(self.chapter.ids()) - {id_}
        log = self.compile()
        words = log or self.forges()
        self.taken = kept
        return words and (grading.BROKEN if log else grading.WRONG, words)

    def settle_alone(self):
        """Settles the exercises that are to blame even alone. True: there are some."""
        left = [id_ for id_ in self.look.written() if id_ not in self.taken]
        guilty = {id_: fault for id_ in left if (fault := self.alone(id_))}
        for id_, fault in guilty.items():
            self.settle(id_, *fault)
        return bool(guilty)

    def first_to_fail(self):
        """The exercise in which the compiler's first error lies."""
        place = re.search(rf"^{re.escape(self.chapter.mine.name)}:(\d+):\d+: (?:fatal )?error",
                          self.log.replace(f"{self.chapter.mine.parent}/", ""), re.M)
        return next((region.id for region in exercises.scan(self.text)[0] if place and
                     region.begin <= int(place[1]) <= region.end + 2
                     and region.id not in self.taken), None)

    def composed(self):
        """The given lines, with what is added between them and the exercises of the file, those
        apart that are taken from the solution. The compiler counts the lines as the file does."""
        own, solved = {}, {}
        for text, found in ((self.text, own), (self.solution, solved)):
            for region in exercises.scan(text)[0]:
                found.setdefault(region.id, []).append(region)
        lines, count, mine = self.solution.split("\n"), Counter(), f'"{self.chapter.mine}"'
        said, at, line = [f"#line 1 {mine}", *self.added.get(None, [])], 0, 1

        def given(until):
            for number in range(at, until):
                said.append(lines[number])
                if number + 1 in self.added:
                    place, block = self.added[number + 1]
                    said.extend([f"#line {place} {mine}", *block, f"#line {number + 2} {mine}"])
        for region in exercises.scan(self.solution)[0]:
            said.append(f"#line {line} {mine}")
            given(region.begin)
            place, at, line = count[region.id], region.end, region.end + 1
            count[region.id] += 1
            found = own.get(region.id, [])
            if len(found) == len(solved[region.id]):
                line = found[place].end + 1
            if region.id in self.taken or len(found) != len(solved[region.id]):
                said += ['#line 1 "solution.cpp"', *region.lines]
            else:
                said += [f"#line {found[place].begin + 1} {mine}", *found[place].lines]
        said.append(f"#line {line} {mine}")
        given(len(lines))
        return "\n".join(said)

    # ---- which exercise is to blame --------------------------------------------------------------

    def without_added(self, grades):
        """Where something is wrong: the grades without the added lines, if they are better."""
        wrong = [one.id for one in grades if one.status == grading.WRONG]
        if not (self.added and wrong):
            return grades
        kept, self.added = self.added, {}
        better = [] if self.compile() else \
            grading.grade(self.chapter, [one.id for one in grades], fresh=True)
        if better and sum(one.status == grading.WRONG for one in better) < len(wrong):
            return better
        self.added = kept
        return grades

    def peel(self, grades):
        """Settles the grades. The first that is wrong is to blame for itself; the others are tried
        again with the solution's version of it, and of those that are not written."""
        blamed = []
        while grades:
            grades = [self.honest(one) for one in grades]
            for one in grades:
                if one.status == grading.DONE:
                    self.settled[one.id] = one if not blamed else replace(
                        one, status=grading.WAITS, detail=", ".join(blamed))
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

    def honest(self, one):
        """A grade; one that waits for nothing that is missing is wrong."""
        if one.status != grading.WAITS or one.detail in self.open():
            return one
        return replace(one, status=grading.WRONG,
                       failures=[("", NEVER_WAITS.format(one.detail))])

    def open(self):
        """What is not written yet."""
        return {id_ for id_ in self.chapter.ids() if id_ not in self.look.written()} - self.taken


def added(given, mine):
    """{line of the given text: (line of mine, the lines that follow it there)}: functions and
    constants that are added between the functions. Under None: includes."""
    include = r'^#include (?:<[\w./+]+>|"(?:engine|chapters)/[\w/]+\.h")'
    known = re.findall(include, given, re.M)
    lines, before, after = mine.split("\n"), reading.frame(given), reading.frame(mine)
    found = {None: [line for line in dict.fromkeys(re.findall(include, mine, re.M))
                    if line not in known]}
    for kind, old, _, first, last in difflib.SequenceMatcher(
            None, [code for _, code in before], [code for _, code in after],
            autojunk=False).get_opcodes():
        if kind in ("equal", "delete"):
            continue
        block = [line for line in lines[after[first][0] - 1:after[last - 1][0]]
                 if not line.startswith("#") or re.match(r"#define \w+ [-+\d.e]+$", line)]
        outer = depths([code for _, code in before[:old]])[-1]
        inner = depths(line.split("//")[0] for line in block)
        if outer <= 1 and inner[-1] == 0 and min(inner) == 0 and "[exercise" not in "".join(block):
            found[before[old - 1][0] if old else before[0][0] - 1] = after[first][0], block
    return {place: what for place, what in found.items() if what}


def depths(code):
    """How many braces are open, at the beginning and after each line."""
    return [0, *itertools.accumulate(line.count("{") - line.count("}") for line in code)]


def first_error(log):
    lines = log.split("\n")
    return next((line for word in ("multiple definition", "error") for line in lines
                 if word in line.lower()), "")


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
