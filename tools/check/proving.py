"""The parts of ./wb check, one thing each, and its words at the end."""
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from dataclasses import dataclass, field

from base import house
from check import answers, catch, judging

SKIPPED = 77  # the exit status of a script that cannot prove anything here


@dataclass
class Report:
    """What was found, for the summary at the end."""
    passed: Counter = field(default_factory=Counter)   # by kind of thing
    failed: list = field(default_factory=list)         # (title, words, command)
    skipped: list = field(default_factory=list)
    notes: list = field(default_factory=list)          # aims that are missed, and counts
    proved: Counter = field(default_factory=Counter)   # counted by the checker itself
    names: set = field(default_factory=set)            # of errata and identities
    scripts: dict = field(default_factory=dict)        # processor time of each [s]
    done: int = 0                                      # cases, for the progress

    def fail(self, title, words, command):
        self.failed.append((title, words, command))
        house.progress_done()
        print(f"{house.bad('FAILED')} {title}\n{indented(words)}\n    repeat: {command}\n",
              flush=True)


def indented(words):
    lines = words.replace(str(house.ROOT) + "/", "").split("\n")
    return "\n".join("    " + line for line in lines)


def run_catch(program, only, report, named):
    """All cases of a program, or some; those that are `named` may be in others."""
    with tempfile.NamedTemporaryFile("r", prefix="joints_") as counts:
        env = dict(os.environ, WORKBOOK_COUNTS=counts.name)

        def each(name):
            report.done += 1
            house.progress(f"{report.done} tests done: {program.topic}, {name}")
        outcome = catch.run(program.path, only, env, each)
        for line in counts:
            what, number = line.rsplit(" ", 1)
            report.proved[what] += int(number)
    if not outcome.cases and not named:
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
    refused = answers.refused_of(judging.source_of(chapter, program.number)).get(answer.key())
    left_out = answer.faults or refused and [(refused[0], f"it does not compile: {refused[1]}")]
    faults = left_out or judging.faults_of(answer, program.path, chapter)
    if not faults:
        report.passed["answers", chapter.folder, answer.kind] += 1
    else:
        place = house.short(answer.file)
        others = "".join(f"\n{place}:{line}: {words}" for line, words in faults[1:])
        report.fail(f"{place}:{faults[0][0]}: {answer.name}", faults[0][1] + others,
                    f"./wb check {chapter.number}" if left_out else
                    f'WORKBOOK_ANSWER="{answer.name}" {house.short(program.path)} '
                    f'"[{answer.tests or answer.id}]"')


def judge_stub(program, chapter, report):
    faults = list(judging.stub_faults(program.path, chapter))
    report.passed["answers", chapter.folder, "stub"] += len(chapter.ids()) - len(faults)
    for words in faults:
        report.fail(f"{house.short(chapter.solution)}: its stub", words,
                    f'WORKBOOK_ANSWER=stub {house.short(program.path)}')


def run_script(script, report):
    house.progress(script.path)
    process = subprocess.Popen([sys.executable, "-B", house.ROOT / script.path, house.ROOT,
                                house.BUILD], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, errors="replace")
    said = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    report.scripts[script.name] = used.ru_utime + used.ru_stime
    if process.returncode == SKIPPED:
        report.skipped.append(f"{script.path}: {said.strip()}")
    elif process.returncode:
        report.fail(script.path, said.strip(),
                    f"{house.python()} {script.path} . {house.short(house.BUILD)}")
    else:
        report.passed["script", script.topic, "proofs"] += max(
            1, len(re.findall(r"^holds", said, re.M)))
        report.notes += re.findall(r"^note +(.*)", said, re.M)


def run_chapter(program, report):
    """A second of a chapter's program, under the sanitizers."""
    house.progress(program)
    command = [house.BUILD / program, "--seconds", "1", "--out", house.BUILD / "out"]
    result = subprocess.run(command, capture_output=True, text=True)
    if result.returncode:
        report.fail(program, result.stderr.strip() or f"exit status {result.returncode}",
                    " ".join([house.short(command[0]), *command[1:3], "--out /tmp/out"]))
    else:
        report.passed["run", program.removesuffix("_run"), "the program"] += 1


# ---- the summary ---------------------------------------------------------------------------------

def total(report, kind, *more):
    return sum(count for key, count in report.passed.items() if (key[0], *key[2:]) == (kind, *more))


def summary(report):
    """What was proved, by topic."""
    print(house.bold("what was proved"))
    for topic in sorted({key[1] for key in report.passed if key[0] != "answers"}):
        parts = [f"{count} " + (key[2] if key[0] in ("script", "run") else f"in {key[2]}")
                 for key, count in sorted(report.passed.items())
                 if key[1] == topic and key[0] != "answers"]
        print(f"  {topic:15} {', '.join(parts)}")
    lines = [("known answers", words, total(report, "answers", kind)) for kind, words in
             (("mistake", "mistakes that a check knows, each told by its sentence"),
              ("wrong", "other wrong answers, each found out in the promised words"),
              ("wrong units", "wrong units found out"), ("right", "unusual right answers accepted"),
              ("stub", "unwritten exercises called so"))]
    for what in ("Jacobians", "effective masses"):
        lines.append(("among them", f"{what} against differences, at "
                      f"{report.proved['poses of ' + what]} poses", report.proved[what]))
    lines += [("among them", what, sum(name[0] == letter for name in report.names))
              for letter, what in (("E", "errata of the thesis"), ("I", "identities"),
                                   ("X", "stiff or extreme cases"))]
    before = ""
    for group, words, number in lines:
        if number:
            print(f"  {'' if group == before else group:15} {number} {words}")
            before = group
    for line in report.skipped:
        print(f"  skipped: {line}")
    for line in report.notes:
        print(f"  note: {line}")
    for title, _, command in report.failed:
        print(f"{house.bad('FAILED')} {title}\n    {command}")
