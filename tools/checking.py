"""The workbook's own tests: ./wb check [3 | joints | E26 | I15] [--quick] [--sanitize]."""
import os
import re
import resource
import subprocess
import sys
import tempfile
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field

import answers
import catch
import house
import judge

# What Python can see, and what it runs: script and topic.
PROOFS = {f"tests/{path}_test.py": path.split("/")[0] for path in (
    "workbook/programs", "workbook/exercises", "workbook/texts", "workbook/sources",
    "workbook/contacts", "bench/cost", "library/library")}
SKIPPED = 77  # the exit status of a script that cannot prove anything here


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


@dataclass
class Report:
    """What was found, for the summary at the end."""
    passed: Counter = field(default_factory=Counter)   # by kind of thing
    failed: list = field(default_factory=list)         # (title, words, command)
    skipped: list = field(default_factory=list)
    proved: Counter = field(default_factory=Counter)   # counted by the checker itself
    names: set = field(default_factory=set)            # of errata and identities
    done: int = 0                                      # cases, for the progress

    def fail(self, title, words, command):
        self.failed.append((title, words, command))
        house.progress_done()
        print(f"{house.bad('FAILED')} {title}\n{indented(words)}\n    repeat: {command}\n",
              flush=True)


def indented(words):
    lines = words.replace(str(house.ROOT) + "/", "").split("\n")
    return "\n".join("    " + line for line in lines)


def programs():
    lines = (house.BUILD / "tests" / "programs.txt").read_text().split("\n")
    return [Program(*line.split(" ")) for line in lines if line]


def chosen(words, quick, sanitize):
    """The programs and scripts that were asked for."""
    found, scripts = programs(), dict(PROOFS)
    for word in words:
        if marked(word):  # an erratum, an identity, a case: wherever its tests are
            folders = {path.parent.name for path in (house.ROOT / "tests").glob("*/*_test.cpp")
                       if marked(word) in path.read_text()}
            if not folders:
                raise house.Trouble(f"check {word}: no test has this name")
            found = [one for one in found if one.topic in folders and one.kind == "topic"]
            scripts = {}
            continue
        topics = sorted({one.topic for one in programs()} | set(PROOFS.values()))
        topic = word if word in topics else house.chapter_of(word).folder \
            if re.match(r"\d", word) else None
        if topic is None:
            raise house.Trouble(f"check {word}: there is no such topic; there are the chapters and "
                                + ", ".join(t for t in topics if not t[0].isdigit()))
        found = [one for one in found if one.topic == topic]
        scripts = {path: about for path, about in scripts.items() if about == topic}
    if quick or sanitize:
        found = [one for one in found if one.number == "double"]
        scripts = {} if sanitize else scripts
    return found, scripts


def marked(word):
    """How the tests of E26, I15 or X1 are marked in their source; "" for other words."""
    if not re.fullmatch(r"[EIX]\d+", word):
        return ""
    return f"[{word}]" if word[0] == "E" else f'TEST_CASE("{word} '


def filter_of(words):
    """Catch2's filter for what was asked for."""
    return "".join(f"[{word}]" if word[0] == "E" else f'"{word} *"'
                   for word in words if marked(word))


def build(found, scripts, everything):
    """Builds what was asked for. Known answers that do not compile are left out and told later."""
    targets = ["check_programs"] if everything else [one.target for one in found]
    if scripts and not everything:
        targets += ["check_scripts"]
    log = house.build(targets, "building the tests") if targets else ""
    chapters = [c for c in house.chapters() if c.folder in {one.topic for one in found}]
    while log and judge.leave_out_refused(chapters, log):
        log = house.build(targets, "building without the answers that do not compile")
    return log


# ---- jobs ----------------------------------------------------------------------------------------

def run_catch(program, only, report):
    """All cases of a program."""
    with tempfile.NamedTemporaryFile("r", prefix="joints_") as counts:
        env = dict(os.environ, WORKBOOK_COUNTS=counts.name)

        def each(name):
            report.done += 1
            house.progress(f"{report.done} tests done: {program.topic}, {name}")
        outcome = catch.run(program.path, only, env, each)
        for line in counts:
            what, number = line.rsplit(" ", 1)
            report.proved[what] += int(number)
    if not outcome.cases:
        outcome.failed.append(("", "no test ran"))
    report.passed[program.kind, program.topic, program.number] += \
        len(outcome.cases) - len(outcome.failed)
    for name, tags in outcome.cases:
        report.names |= set(re.findall(r"\[(E\d+)\]", tags))
        report.names |= set(re.findall(r"^(?:[IX]\d+(?:,? (?:and )?(?=[IX]\d))?)+", name)) and \
            set(re.findall(r"\b([IX]\d+)\b", name))
    for name, words in outcome.failed:
        report.fail(f"{program.target}: {name}", words,
                    f'{house.short(program.path)} "{name}"')


def judge_answer(answer, program, chapter, report):
    report.done += 1
    house.progress(f"{report.done} tests done: answer {answer.name}")
    refused = answers.refused_of(judge.source_of(chapter, program.number)).get(answer.key())
    faults = answer.faults or (refused and [tuple(refused)]) \
        or judge.faults_of(answer, program.path, chapter)
    if not faults:
        report.passed["answers", chapter.folder, answer.kind] += 1
    for line, words in faults[:1]:
        report.fail(f"{house.short(answer.file)}:{line}: {answer.name}", words,
                    f'WORKBOOK_ANSWER="{answer.name}" {house.short(program.path)} "[{answer.id}]"')


def judge_stub(program, chapter, report):
    faults = list(judge.stub_faults(program.path, chapter))
    report.passed["answers", chapter.folder, "stub"] += len(chapter.ids()) - len(faults)
    for words in faults:
        report.fail(f"{house.short(chapter.solution)}: its stub", words,
                    f'WORKBOOK_ANSWER=stub {house.short(program.path)}')


def run_script(path, report):
    house.progress(f"{path}")
    result = subprocess.run([sys.executable, "-B", house.ROOT / path, house.ROOT, house.BUILD],
                            capture_output=True, text=True)
    if result.returncode == SKIPPED:
        report.skipped.append(f"{path}: {result.stdout.strip()}")
    elif result.returncode:
        report.fail(path, (result.stdout + result.stderr).strip(),
                    f"python3 {path} . {house.short(house.BUILD)}")
    else:
        report.passed["script", PROOFS[path], path] += max(
            1, len(re.findall(r"^holds", result.stdout, re.M)))


def jobs_of(found, scripts, only, report):
    """Everything that there is to run, the long ones first."""
    jobs = [lambda path=path: run_script(path, report) for path in scripts]
    for one in found:
        if one.kind != "answers" and one.path.exists():
            jobs.append(lambda one=one: run_catch(one, only, report))
    for one in (one for one in found if one.kind == "answers" and one.path.exists()):
        chapter = house.chapter_of(one.topic)
        if one.number == "numbers":
            jobs.append(lambda one=one, c=chapter: judge_stub(one, c, report))
        for answer in judge.known(chapter, one.number == "units"):
            jobs.append(lambda a=answer, one=one, c=chapter: judge_answer(a, one, c, report))
    return jobs


# ---- the command ---------------------------------------------------------------------------------

def check(arguments):
    """The workbook's own tests, or some of them."""
    quick, sanitize = "--quick" in arguments, "--sanitize" in arguments
    words = [a for a in arguments if a not in ("--quick", "--sanitize")]
    if unknown := [a for a in words if a.startswith("-")]:
        raise house.Trouble(f"check {unknown[0]}: it takes --quick and --sanitize")
    began = time.time()
    if sanitize:
        house.use_build("sanitize")
    house.configure()
    found, scripts = chosen(words, quick, sanitize)
    missing = [one for one in found if not one.path.exists()]
    print(f"{len(found)} test programs" + (f", {len(missing)} of them to be built: about "
          f"{1 + len(missing) // 8} minutes on two processors" if missing else ""), flush=True)
    log = build(found, scripts, not (words or quick or sanitize))
    built = processor_time()
    report = Report()
    if log:
        report.fail("the build", house.compiler_words(log), "ninja -C " + house.short(house.BUILD))
    with house.talking(), ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for done in [pool.submit(job) for job in jobs_of(found, scripts, filter_of(words), report)]:
            done.result()
    house.progress_done()
    summary(report, quick, sanitize, words)
    print(f"processor time: {built:.0f} s to build, {processor_time() - built:.0f} s to run; "
          f"{(time.time() - began) / 60:.1f} minutes by the clock")
    print(f"{sum(report.passed.values())} passed, {len(report.failed)} failed"
          + (f", {len(report.skipped)} skipped" if report.skipped else ""))
    return 1 if report.failed or not report.passed else 0


def processor_time():
    """What all that this command has started has used so far [s]."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def total(report, kind, *more):
    return sum(count for key, count in report.passed.items() if (key[0], *key[2:]) == (kind, *more))


def summary(report, quick, sanitize, words):
    """What was proved, by topic."""
    topics = sorted({key[1] for key in report.passed if key[0] != "answers"})
    print(house.bold("what was proved"))
    for topic in topics:
        parts = [f"{count} {'proofs' if key[0] == 'script' else 'in ' + key[2]}"
                 for key, count in sorted(report.passed.items())
                 if key[1] == topic and key[0] != "answers"]
        print(f"  {topic:16} {', '.join(parts)}")
    if kinds := {key[2] for key in report.passed if key[0] == "answers"}:
        said = {"wrong": "wrong answers found out in the promised words", "wrong units":
                "wrong units found out", "right": "other right answers accepted",
                "stub": "unwritten exercises called so"}
        print("  " + f"{'answers':16} " + ", ".join(
            f"{total(report, 'answers', kind)} {words}" for kind, words in said.items()
            if kind in kinds))
    counted = [f"{number} {what}" for what, number in sorted(report.proved.items())]
    for letter, what in (("E", "errata of the thesis"), ("I", "identities"),
                         ("X", "stiff or extreme cases")):
        if number := sum(name[0] == letter for name in report.names):
            counted.append(f"{number} {what}")
    if counted:
        print(f"  {'among them':16} {', '.join(counted)}")
    for line in report.skipped:
        print(f"  skipped: {line}")
    if quick:
        print("  left out by --quick: float, units and the known answers")
    if sanitize:
        print("  with address and undefined-behaviour checks: double alone, no known answers")
    for title, _, command in report.failed:
        print(f"{house.bad('FAILED')} {title}\n    {command}")
