"""The workbook's own tests, in two parts: ./wb check and ./wb check --rest."""
import os
import re
import resource
import subprocess
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

from base import house
from check import dearest, judging, proving

# The proofs that are scripts. What costs much and tells little to those who edit a chapter belongs
# to the rest, as the tests do that are tagged [slow].
SLOW = "[slow]"
PROOFS = ("workbook/exercises", "workbook/texts", "workbook/sources")
PROOFS_OF_THE_REST = ("workbook/numbers", "workbook/claims", "workbook/programs",
                      "workbook/contacts", "workbook/direct_solver", "workbook/front_door",
                      "workbook/pictures",
                      "workbook/lanes", "workbook/grade", "workbook/attempts",
                      "workbook/hand_out", "workbook/doors",
                      "live/module", "live/page", "live/picture", "course/reports",
                      "course/page", "course/firefox", "bench/cost", "peers/packages",
                      "library/library", "library/guest", "library/pkg_config", "library/package")
# What runs once more under the sanitizers: where memory is moved about. The judging of exercises
# moves none.
SANITIZED = ("engine", "joints", "lanes", "direct", "reduced", "fuzz")
LEFT_OUT = ("float, slow tests, random worlds, the chapters' programs, numbers in the texts,\n"
            "  pictures, pages in a browser, the commands, grading, counted instructions,\n"
            "  benches, published engines, the library seen from outside")


@dataclass
class Program:
    """A line of the list that CMake writes."""
    kind: str    # exercise, topic or answers
    topic: str   # 01_distance, joints
    number: str  # double, float or units; of answers: numbers or units
    target: str
    part: str    # first or rest

    @property
    def path(self):
        return house.BUILD / "tests" / self.target


@dataclass
class Script:
    """A proof that is a script."""
    name: str  # workbook/texts
    part: str

    @property
    def path(self):
        return f"tests/{self.name}_test.py"

    @property
    def topic(self):
        return self.name.split("/")[0]


SCRIPTS = [Script(name, part) for part, names in (("first", PROOFS), ("rest", PROOFS_OF_THE_REST))
           for name in names]


def programs():
    """The list that CMake writes, as new as its sources."""
    subprocess.run(["cmake", "--build", house.BUILD, "--target", "build.ninja"], check=False,
                   capture_output=True)
    lines = (house.BUILD / "tests" / "programs.txt").read_text().split("\n")
    return [Program(*line.split(" ")) for line in lines if line]


@dataclass
class Choice:
    """What to build and to run."""
    args: object  # of the command line, see tools/wb.py
    programs: list = field(default_factory=list)
    scripts: list = field(default_factory=list)
    runs: list = field(default_factory=list)  # chapters' programs, under the sanitizers
    only: str = ""                            # Catch2's filter

    @property
    def parts(self):
        """What is named is checked whole, and all the rest of a check in two parts."""
        if self.args.rest:
            return {"rest"}
        return {"first"} if self.only_first else {"first", "rest"}

    def only_of(self, program):
        """Catch2's filter for a program: what is named, or the tests of this part."""
        if self.args.sanitize and not self.only:
            return f"~{SLOW}"
        if self.only or self.parts == {"first", "rest"} or program.part == "rest":
            return self.only
        return f"~{SLOW}" if self.parts == {"first"} else SLOW

    @property
    def only_first(self):
        return not (self.args.words or self.args.rest or self.args.all or self.args.sanitize)


def choice_of(args):
    """What the command line asks for."""
    choice = Choice(args)
    if args.long:
        os.environ["WORKBOOK_LONG"] = "1"  # read by tests/fuzz
    if args.sanitize:
        house.use_build("sanitize")
    house.configure()
    every = programs()
    topics = sorted({one.topic for one in [*every, *SCRIPTS]})
    wanted, names = set(), []
    for word in args.words:
        if re.fullmatch(r"[EIX]\d+", word):  # an erratum, an identity, a case: wherever it is
            names.append(f"[{word}]" if word[0] == "E" else f'"{word} *"')
            wanted |= topics_with(word)
        else:
            wanted.add(topic_of(word, topics))
    choice.only, slow = ",".join(names), slow_topics()
    choice.programs = [one for one in every if (not wanted or one.topic in wanted)
                       and (one.part in choice.parts
                            or "rest" in choice.parts and one.topic in slow)
                       and not (names and one.kind == "answers")
                       and not ((args.quick or args.sanitize) and one.number != "double")
                       and not (args.sanitize and not wanted and one.topic not in SANITIZED)]
    if not names and not args.sanitize:
        choice.scripts = [one for one in SCRIPTS if (not wanted or one.topic in wanted)
                          and one.part in choice.parts]
    if args.sanitize and not args.words:
        choice.runs = house.programs()
    return choice


def slow_topics():
    return {path.parent.name for path in (house.ROOT / "tests").glob("*/*_test.cpp")
            if SLOW in path.read_text()}


def topics_with(word):
    """The topics whose tests are named E26, I15 or X1."""
    mark = f"[{word}]" if word[0] == "E" else f'TEST_CASE("{word} '
    found = {path.parent.name for path in (house.ROOT / "tests").glob("*/*test.cpp")
             if mark in path.read_text()}
    if not found:
        raise house.Trouble(f"check {word}: no test has this name")
    return found


def topic_of(word, topics):
    if word in topics:
        return word
    if re.match(r"\d", word):
        return house.chapter_of(word).folder
    raise house.Trouble(f"check {word}: there is no such topic; there are the chapters, by number, "
                        "and " + ", ".join(topic for topic in topics if not topic[0].isdigit()))


def build(choice):
    """Builds what was asked for. Known answers that do not compile are left out and told later."""
    targets = [one.target for one in choice.programs] + choice.runs
    targets += sorted({f"check_scripts_{one.part}" for one in choice.scripts})
    topics = {one.topic for one in choice.programs}
    chapters = [chapter for chapter in house.chapters() if chapter.folder in topics]
    judging.ask_again(chapters)
    log = house.build(targets, "building the tests") if targets else ""
    while log and judging.leave_out_refused(chapters, log):
        log = house.build(targets, "building without the answers that do not compile")
    return log


def jobs_of(choice, report):
    """Everything that there is to run, the long ones first."""
    for one in choice.scripts:
        yield proving.run_script, one, report
    for name in choice.runs:
        yield proving.run_chapter, name, report
    there = [one for one in choice.programs if one.path.exists()]
    for one in there:
        if one.kind != "answers":
            yield proving.run_catch, one, choice.only_of(one), report, bool(choice.only)
    for one in there:
        if one.kind == "answers":
            chapter = house.chapter_of(one.topic)
            if one.number == "numbers":
                yield proving.judge_stub, one, chapter, report
            for answer in judging.known(chapter, one.number == "units"):
                yield proving.judge_answer, answer, one, chapter, report


def check(args):
    """The workbook's own tests, or some of them."""
    began = time.time()
    choice = choice_of(args)
    missing = sum(not one.path.exists() for one in choice.programs)
    print(f"{len(choice.programs)} test programs" + (f", {missing} of them to be built: about "
          f"{1 + missing // 12} minutes on two processors" if missing else ""), flush=True)
    log = build(choice)
    built = processor_time()
    report = proving.Report()
    if log:
        report.fail("the build", house.compiler_words(log), f"ninja -C {house.short(house.BUILD)}")
    with house.talking(), ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for done in [pool.submit(*job) for job in jobs_of(choice, report)]:
            done.result()
    house.progress_done()
    proving.summary(report)
    if args.quick:
        print("  left out by --quick: float, units and the known answers")
    if args.sanitize:
        print("  under address and undefined-behaviour checks: double alone, no "
              "exercises, no slow tests")
    print(f"processor time: {built:.0f} s to build, {processor_time() - built:.0f} s to run; "
          f"{(time.time() - began) / 60:.1f} minutes by the clock")
    dearest.tell(began, built, processor_time() - built, report.scripts)
    if choice.only_first:
        print(f"left out: {LEFT_OUT}: ./wb check --rest")
    print(f"{sum(report.passed.values())} passed, {len(report.failed)} failed"
          + (f", {len(report.skipped)} skipped" if report.skipped else ""))
    return 1 if report.failed or not report.passed else 0


def processor_time():
    """What all that this command has started has used so far [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
