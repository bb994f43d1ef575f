"""Grades one exercise file that somebody has handed in, in a process of its own that ./wb grade
starts and may end: submission.py FOLDER NN_name PLAN

FOLDER is laid out as the workbook is: chapters/NN_name/name.cpp, compiled/name.cpp, which is made
of it, and build/, which links with the workbook's. PLAN is a Plan in JSON. What is compiled and run
of the file is within fences; the tests are not, and run nothing of it: they ask it for numbers, see
tests/remote/wire.h. A line of the output that begins with [ is the grades and the notes in JSON;
the last one counts.
"""
import difflib
import itertools
import json
import os
import re
import resource
import shlex
import subprocess
import sys
from collections import Counter
from dataclasses import asdict, dataclass, replace
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import exercises  # noqa: E402
from classroom import fence  # noqa: E402
from judge import grade as grading  # noqa: E402
from base import house  # noqa: E402
from judge import includes, reading, runs  # noqa: E402

# Of every process: processor time [s], a file, memory [bytes]. Tests have less, see runs.py.
LIMITS = {resource.RLIMIT_CPU: 60, resource.RLIMIT_FSIZE: 64 << 20, resource.RLIMIT_AS: 4 << 30,
          resource.RLIMIT_CORE: 0}
LEFT_OUT = "What is added outside the exercises was left out. "
NEVER_WAITS = "it throws that exercise {} is not written yet, which is not so"
NEEDS_NONE = "it calls exercise {}, which is not written yet and which it does not need"


@dataclass
class Plan:
    """How a chapter's files are graded."""
    line: str      # commands: the object of the exercise file, and the program of the answer
    spare: str     # the solution's object
    answer: str    # the program of the answer
    tests: str     # that of the tests
    symbols: dict  # exercise: its functions; "": what is given
    uses: dict     # exercise: the others that it needs
    reads: list    # what the compiler reads
    objects: list  # what the linker reads


@dataclass
class HandedIn(house.Chapter):
    """A chapter of the workbook, with somebody else's exercise file."""
    home: Path = Path()

    @property
    def mine(self):
        return self.home / "chapters" / self.folder / f"{self.name}.cpp"


class Judge:
    """Grades the exercises. Where one is wrong or missing, those that need it are tried again with
    the solution's: the linker takes its functions from there. The compiler sees no solution."""

    def __init__(self, chapter, plan):
        self.chapter, self.plan, self.text = chapter, plan, chapter.mine_text()
        self.stub = exercises.stub(exercises.read(chapter.solution))
        self.look = reading.look(chapter)
        self.outside = reading.changed_outside(self.stub, self.text)
        self.added, self.left_out = added(self.stub, self.text), set()
        self.settled, self.notes = {}, includes.notes(self.text)

    def say(self):
        """What is known so far, without the folder's name and without what steers a terminal."""
        left = [grading.Grade(id_, grading.OPEN) if id_ not in self.look.written() else
                grading.Grade(id_, grading.WRONG, failures=[("", "its tests did not end in time")])
                for id_ in self.chapter.ids() if id_ not in self.settled]
        grades = [*self.settled.values(), *left]
        said = json.dumps([[asdict(one) for one in grades], self.notes])
        for home in (self.chapter.home, house.short(self.chapter.home)):
            said = said.replace(json.dumps(f"{home}/")[1:-1], "")
        said = re.sub(r"(?<!\\)((?:\\\\)*)\\u(00[0189]\w|202[a-e]|206[6-9])", r"\1?", said)
        print(said, flush=True)

    def broken(self, id_, words):
        self.settled[id_] = grading.Grade(id_, grading.BROKEN, words)
        self.left_out.add(id_)

    def judge(self):
        for id_, words, _ in self.look.faults:
            if id_ and id_ not in self.settled:
                self.broken(id_, words)
        if words := includes.refused(self.text):
            self.notes = [words[0].upper() + words[1:]]
        if not self.text.strip():
            words = "the file is empty"
        if words or len(self.settled) < len(self.chapter.ids()) and not self.build():
            for id_ in self.chapter.ids():
                if id_ not in self.settled or words:
                    self.broken(id_, words or self.log)
            return
        written = [id_ for id_ in self.look.written() if id_ not in self.settled]
        self.say()
        grades = [self.tested([one.id])[0] if late(one) else one
                  for one in (self.tested(written) if written else [])]
        grades = self.without_spoilers(grades)
        if self.outside:
            self.notes.append(f"Outside the exercises line{self.outside} "
                              f"{'have' if self.outside.startswith('s') else 'has'} changed; "
                              "what counts are the given lines"
                              + " and what is added between them" * bool(self.added) + ".")
        self.blame(grades)

    # ---- compiling -----------------------------------------------------------------------------

    def build(self):
        """Compiles as much of the file as can be. False: nothing of it."""
        while self.compile():
            if id_ := self.first_to_fail():
                self.broken(id_, self.log)
            elif self.added and self.alone(None):
                self.added = {}
                self.notes.append(LEFT_OUT + first_error(self.log))
            elif not self.break_alone():
                return False
        return True

    def compile(self):
        """Returns "" or what the compiler says."""
        exercises.write(self.chapter.home / "compiled" / self.chapter.mine.name, self.composed())
        self.log = self.run(self.plan.line.partition(" && ")[0], self.plan.reads) or self.link()
        return self.log

    def link(self, taken=()):
        """Links the program of the answer, with the functions of some exercises of the solution:
        of each one the other definition is weak, and what is not called is left out."""
        names = {name for id_ in taken for name in self.plan.symbols[id_]}
        all_ = {name for of_one in self.plan.symbols.values() for name in of_one}
        compile_, _, line = self.plan.line.partition(" && ")
        mine, spare = re.search(r" -o (\S+\.o) ", compile_)[1], shlex.quote(self.plan.spare)
        for file, path, weak in [("mine", mine, names),
                                 ("spare", spare, all_ - names)] * bool(taken):
            exercises.write(self.chapter.home / "build" / f"{file}.weak", "\n".join(weak))
            line = (f"objcopy --weaken-symbols={file}.weak {path} {file}.o && "
                    + re.sub(r"( -o \S+_mine )", rf"\1{file}.o ", line))
        return self.run(line, self.plan.objects)

    def run(self, line, reads):
        """Runs commands in the build folder, which see what they read. "", or what they say."""
        folder = str(self.chapter.home / "build")
        within = fence.Fence(folder, reads, [folder], quiet=False)
        said = subprocess.run(within.around(["sh", "-c", line]), capture_output=True, text=True,
                              errors="replace", cwd=folder)
        return house.compiler_words(said.stdout + said.stderr) if said.returncode else ""

    def alone(self, id_):
        """What the compiler says of one exercise, or of none, without the others."""
        kept, self.left_out = self.left_out, set(self.chapter.ids()) - {id_}
        log = self.compile()
        self.left_out = kept
        return log

    def break_alone(self):
        """Settles the exercises that are to blame even alone. True: there are some."""
        left = [id_ for id_ in self.look.written() if id_ not in self.left_out]
        guilty = {id_: log for id_ in left if (log := self.alone(id_))}
        for id_, log in guilty.items():
            self.broken(id_, log)
        return bool(guilty)

    def first_to_fail(self):
        """The exercise in which the compiler's first error lies."""
        place = re.search(rf"^{re.escape(self.chapter.mine.name)}:(\d+):\d+: (?:fatal )?error",
                          self.log.replace(f"{self.chapter.mine.parent}/", ""), re.M)
        return next((region.id for region in exercises.scan(self.text)[0] if place and
                     region.begin <= int(place[1]) <= region.end + 2
                     and region.id not in self.left_out), None)

    def composed(self):
        """The given lines, with what is added between them and the exercises of the file, except
        those that are left out. The compiler counts the lines as the file does."""
        own, given_ = {}, {}
        for text, found in ((self.text, own), (self.stub, given_)):
            for region in exercises.scan(text)[0]:
                found.setdefault(region.id, []).append(region)
        lines, count, mine = self.stub.split("\n"), Counter(), f'"{self.chapter.mine}"'
        said, at, line = [f"#line 1 {mine}", *self.added.get(None, [])], 0, 1

        def given(until):
            for number in range(at, until):
                said.append(lines[number])
                if number + 1 in self.added:
                    place, block = self.added[number + 1]
                    said.extend([f"#line {place} {mine}", *block, f"#line {number + 2} {mine}"])
        for region in exercises.scan(self.stub)[0]:
            said.append(f"#line {line} {mine}")
            given(region.begin)
            place, at, line = count[region.id], region.end, region.end + 1
            count[region.id] += 1
            found = own.get(region.id, [])
            if len(found) == len(given_[region.id]):
                line = found[place].end + 1
            if region.id in self.left_out or len(found) != len(given_[region.id]):
                said += region.lines
            else:
                said += [f"#line {found[place].begin + 1} {mine}", *found[place].lines]
        said.append(f"#line {line} {mine}")
        given(len(lines))
        return "\n".join(said)

    # ---- which exercise is to blame --------------------------------------------------------------

    def tested(self, ids, taken=()):
        """The grades of exercises, some others taken from the solution."""
        if log := self.link(taken):
            return [grading.Grade(id_, grading.BROKEN, log) for id_ in ids]
        answer = self.chapter.home / "build" / self.plan.answer
        within = fence.Fence(str(self.chapter.home), [str(answer)])
        os.environ["WORKBOOK_ANSWERER"] = "exec " + shlex.join(within.around([answer]))
        os.environ["WORKBOOK_PATIENCE"] = str(int(2000 * runs.LIMIT * runs.crowd()))
        found = grading.tested(self.chapter, ids, self.plan.tests)
        return [found[id_] for id_ in ids]

    def without_spoilers(self, grades):
        """Where something is wrong: the grades without the added lines, if they are better. Where
        all is, in one way: without the exercise that spoils the others, if there is one."""
        wrong = [one for one in grades if one.status == grading.WRONG]
        ways = {one.failures[0][1].partition("\n")[0] for one in wrong}
        spoilers = wrong if len(ways) == 1 < len(wrong) == len(grades) else []
        for spoiler in [None] * bool(self.added and wrong) + spoilers:
            kept = self.added, set(self.left_out)
            if spoiler:
                self.left_out.add(spoiler.id)
            else:
                self.added = {}
            better = [] if self.compile() else self.tested([
                one.id for one in grades if one is not spoiler])
            if better and sum(one.status == grading.WRONG for one in better) < len(
                    wrong) - bool(spoiler):
                if spoiler:
                    self.settled[spoiler.id] = spoiler
                else:
                    self.notes.append(LEFT_OUT)
                return better
            self.added, self.left_out = kept
        if wrong:
            self.compile()
        return grades

    def blame(self, grades):
        """Settles the grades. What is not right is tried again with the solution's version of all
        that it needs and that is not right either; then it is to blame for itself."""
        self.settled |= {one.id: one for one in grades if one.status == grading.DONE}
        right = {id_ for id_, one in self.settled.items() if one.status == grading.DONE}
        missing, innocent = set(self.chapter.ids()) - set(self.look.written()) | self.left_out, {}
        for one in grades:
            if one.id in right:
                continue
            if taken := set(self.plan.uses[one.id]) - right:
                one = self.tested([one.id], taken)[0]
            if one.status == grading.DONE:
                innocent[one.id] = one
            elif one.status == grading.WAITS:
                words = NEEDS_NONE if one.detail in missing else NEVER_WAITS
                one = replace(one, status=grading.WRONG,
                              failures=[("", words.format(one.detail))])
            self.settled[one.id] = one
            self.say()
        for id_, one in innocent.items():
            guilty = sorted(set(self.plan.uses[id_]) - right - set(innocent))
            self.settled[id_] = replace(one, status=grading.WAITS, detail=", ".join(guilty)) \
                if guilty else one


def late(one):
    """True where the clock has ended its tests."""
    return any(runs.LATE in " ".join(words.split()) for _, words in one.failures)


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


def main(folder, chapter, plan):
    for limit, most in LIMITS.items():
        resource.setrlimit(limit, (most, most))
    judge = Judge(HandedIn(chapter.number, chapter.folder, chapter.name, folder), plan)
    judge.judge()
    judge.say()


if __name__ == "__main__":
    main(Path(sys.argv[1]), house.chapter_of(sys.argv[2]), Plan(**json.loads(sys.argv[3])))
