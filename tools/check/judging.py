"""Judges known answers: each runs in a process of its own and is read as a reader's would be."""
import re
from pathlib import Path

from check import answers
from judge import grade as grading
from base import house
from judge import runs


def fold(words):
    return " ".join(words.split())


def faults_of(answer, program, chapter):
    """What of an answer is not as promised: [(line of its file, words)]."""
    if answer.kind == "wrong units":
        run = runs.run(program, [answer.id], answer=answer.name)
        sentence = grading.units_of(run)
        if not sentence:
            return [(answer.line, run.fault or "the units find nothing wrong with this answer")]
        return broken_promises(answer, [sentence])
    one, trouble = graded(answer, answer.id, program, chapter)
    if answer.tests and not trouble:
        if one.status != grading.DONE:
            return [(answer.line, f"the tests of {answer.id} find this answer out, so that "
                                  f"'// tests: {answer.tests}' is not needed")]
        one, trouble = graded(answer, answer.tests, program, chapter)
    if trouble:
        return [(answer.line, trouble)]
    reports = [report for _, report in one.failures]
    if answer.kind == "right":
        right = one.status == grading.DONE
        return [] if right else [(answer.line, "this right answer is called wrong:\n"
                                  + (reports[0] if reports else one.words()))]
    if one.status == grading.DONE:
        return [(answer.line, f"this wrong answer passes every test of {one.id}")]
    return broken_promises(answer, reports)


def graded(answer, id_, program, chapter):
    """What the tests of an exercise make of an answer, and why they cannot judge it, "" if they
    can."""
    one = grading.Grade(id_)
    # A right one ends, however slow the machine. Of a wrong one the first report counts, unless
    # others are promised.
    limit = runs.LIMIT * (10 if answer.kind == "right" else 1)
    whole = answer.kind == "right" or bool(answer.promises)
    grading.read(runs.run(program, [id_], limit, answer.name, whole), {id_: one}, chapter)
    if not one.tests:
        return one, f"exercise {id_} has no test"
    said = fold(" ".join(report for _, report in one.failures))
    bad = re.search("the answer ends without a return|no such answer", said)
    return one, bad[0] if bad else ""


def broken_promises(answer, reports):
    """The promises that no report keeps. Diagnoses that the heading names, no more and no fewer,
    must be in the first report, which is the one that a reader sees."""
    flat = [fold(report) for report in reports]
    said = re.findall(r"#([a-z0-9-]+) ", flat[0])
    if ids := answer.ids():
        told = ids == list(dict.fromkeys(said))
        poses = answers.NAMED.match(answer.told)[2]
        told = told and (not poses or f"({fold(poses)})" in flat[0].partition("#")[2])
    else:
        words = fold(answer.told.strip('"'))
        ends = (" Where:", " (") if answer.kind == "mistake" else ("",)  # in brackets the poses
        told = any(f"Likely mistake: {words}{end}" in answers.without_ids(flat[0]) or
                   "Likely mistake: " not in flat[0] and words + end in flat[0] for end in ends)
    if answer.told and not told:
        return [(answer.line, f"the first report does not tell {answer.told} but\n{reports[0]}")]
    for number, words in answer.promises:
        if not any(fold(words) in answers.without_ids(report) for report in flat):
            return [(number, f"the reports do not say '{words}' but\n" + "\n\n".join(reports))]
    return []


def stub_faults(program, chapter):
    """The exercises of a fresh stub that do not say that they are not written yet."""
    for id_ in chapter.ids():
        one = grading.Grade(id_)
        grading.read(runs.run(program, [id_], answer=answers.STUB), {id_: one}, chapter)
        if one.status != grading.OPEN:
            yield (f"the stub of {id_} is '{one.words()}', not '{grading.OPEN}'"
                   + "".join(f"\n{report}" for _, report in one.failures[:1]))


def known(chapter, units):
    """The answers of a chapter that belong to numbers, or to units."""
    found = answers.read_all(answers.files_of(chapter.folder, house.ROOT),
                             chapter.solution.read_text())
    return [one for one in found if (one.kind == "wrong units") == units]


def source_of(chapter, kind):
    return house.BUILD / "answers" / f"{chapter.folder}_{kind}.cpp"


def ask_again(chapters):
    """Forgets which answers the compiler has refused: what they call may have changed since."""
    for chapter in chapters:
        for kind in ("numbers", "units"):
            source = source_of(chapter, kind)
            if answers.refused_of(source):
                Path(f"{source}.refused.json").write_text("{}")


def leave_out_refused(chapters, log):
    """Notes the answers that do not compile, so that the others can be. True if there are any."""
    new = 0
    for chapter in chapters:
        for kind in ("numbers", "units"):
            new += answers.refuse(source_of(chapter, kind), known(chapter, kind == "units"), log)
    return new > 0
