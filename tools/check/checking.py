"""The workbook's own tests: ./wb check [3 | joints | E26 | I15] [--quick] [--sanitize] [--long]."""
import os
import re
import resource
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

from base import house
from check import judging, proving

# What Python can see, and what it runs: script and topic.
PROOFS = {f"tests/{path}_test.py": path.split("/")[0] for path in (
    "workbook/programs", "workbook/exercises", "workbook/texts", "workbook/sources",
    "workbook/numbers", "workbook/pictures", "workbook/contacts", "workbook/direct_solver",
    "workbook/front_door", "workbook/grade",
    "live/module", "live/page", "bench/cost", "peers/packages",
    "library/library", "library/pkg_config")}


@dataclass
class Program:
    """A line of the list that CMake writes."""
    kind: str    # exercise, topic or answers
    topic: str   # 01_distance, joints
    number: str  # double, float or units; of answers: numbers or units
    target: str

    @property
    def path(self):
        return house.BUILD / "tests" / self.target


def programs():
    lines = (house.BUILD / "tests" / "programs.txt").read_text().split("\n")
    return [Program(*line.split(" ")) for line in lines if line]


@dataclass
class Choice:
    """What to build and to run."""
    words: list
    quick: bool = False
    sanitize: bool = False
    programs: list = field(default_factory=list)
    scripts: list = field(default_factory=list)
    runs: list = field(default_factory=list)  # chapters' programs, under the sanitizers
    only: str = ""                            # Catch2's filter

    @property
    def everything(self):
        return not (self.words or self.quick or self.sanitize)


def choice_of(args):
    """What the command line asks for."""
    choice = Choice(args.words, args.quick, args.sanitize)
    if args.long:
        os.environ["WORKBOOK_LONG"] = "1"  # read by tests/fuzz
    if choice.sanitize:
        house.use_build("sanitize")
    house.configure()
    every = programs()
    topics = sorted({one.topic for one in every} | set(PROOFS.values()))
    wanted, names = set(), []
    for word in choice.words:
        if re.fullmatch(r"[EIX]\d+", word):  # an erratum, an identity, a case: wherever it is
            names.append(f"[{word}]" if word[0] == "E" else f'"{word} *"')
            wanted |= topics_with(word)
        else:
            wanted.add(topic_of(word, topics))
    choice.only = ",".join(names)
    choice.programs = [one for one in every if (not wanted or one.topic in wanted)
                       and not (names and one.kind == "answers")
                       and not ((choice.quick or choice.sanitize) and one.number != "double")]
    if not names and not choice.sanitize:
        choice.scripts = [path for path, topic in PROOFS.items() if not wanted or topic in wanted]
    if choice.sanitize and not choice.words:
        choice.runs = [f"{chapter.folder}_run" for chapter in house.chapters()]
    return choice


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
    targets += ["check_scripts"] if choice.scripts else []
    if choice.everything:
        targets = ["check_programs"]
    topics = {one.topic for one in choice.programs}
    chapters = [chapter for chapter in house.chapters() if chapter.folder in topics]
    judging.ask_again(chapters)
    log = house.build(targets, "building the tests") if targets else ""
    while log and judging.leave_out_refused(chapters, log):
        log = house.build(targets, "building without the answers that do not compile")
    return log


def jobs_of(choice, report):
    """Everything that there is to run, the long ones first."""
    for path in choice.scripts:
        yield proving.run_script, path, PROOFS[path], report
    for name in choice.runs:
        yield proving.run_chapter, name, report
    there = [one for one in choice.programs if one.path.exists()]
    for one in there:
        if one.kind != "answers":
            yield proving.run_catch, one, choice.only, report
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
    if choice.quick:
        print("  left out by --quick: float, units and the known answers")
    if choice.sanitize:
        print("  under address and undefined-behaviour checks: double alone, no known answers")
    print(f"processor time: {built:.0f} s to build, {processor_time() - built:.0f} s to run; "
          f"{(time.time() - began) / 60:.1f} minutes by the clock")
    print(f"{sum(report.passed.values())} passed, {len(report.failed)} failed"
          + (f", {len(report.skipped)} skipped" if report.skipped else ""))
    return 1 if report.failed or not report.passed else 0


def processor_time():
    """What all that this command has started has used so far [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime
