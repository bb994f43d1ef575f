"""The exercises' tests say the same in the browser as natively: reports_test.py ROOT BUILD

The known answers of one chapter, another every day (WORKBOOK_COURSE=all: of all chapters), in
WebAssembly as the page runs them, and natively: status and reports, text by text. Skipped, with
exit status 77, where node or the packages that make WebAssembly are missing.
"""
import datetime
import json
import os
import re
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).absolute().parents[1] / "workbook"))
from proofs import DRAWING, house, main, notes, other_cases  # noqa: E402

from check import judging  # noqa: E402
from course import packing, parts  # noqa: E402
from judge import grade as grading, runs  # noqa: E402
from website import live  # noqa: E402

HERE = Path(__file__).parent
VAGUE = "an index outside"  # which array it was is known to g++ alone
UNSET = "#never-set"  # a huge number to g++, none to clang: another test may be the first to fail
# What they do is undefined: they read beyond the end of a std::vector<bool>, whose words have 32
# bits there, or change a set while a loop runs over it.
UNDEFINED = ("7.3 wrong: the program crashed", "7.3 wrong: four-spare-colours",
             "7.3 wrong: body-that-not-there", "9.3 wrong: 6 nodes where there are 5")
DRAWN = "cases drawn with seed"
# In a drawn case at the threshold itself a rounding error decides: the two libraries' arc cosine,
# or power of ten.
AT_THRESHOLD = ("3.3 mistake: the sine alone", "9.7 wrong: threshold-rate")


def chosen():
    """The chapters whose answers are compared."""
    every = house.chapters()
    if os.environ.get("WORKBOOK_COURSE") == "all":
        return every
    return [every[datetime.date.today().toordinal() % len(every)]]


def objects_of(chapter):
    return (f"tests_{chapter.folder}", f"where_{chapter.folder}", f"mistakes_{chapter.folder}",
            "checker", "module")


def module(chapter):
    """The tests with all known answers of a chapter."""
    source = judging.source_of(chapter, "numbers")
    made, out = (parts.BUILD / f"answers_{chapter.folder}{end}" for end in (".o", ".wasm"))
    flags = [*live.FLAGS, *live.LENIENT, "-O0", "-isystem", house.BUILD / "live" / "include",
             f"-I{house.ROOT}"]
    subprocess.run(["clang++", *flags, "-c", source, "-o", made], check=True)
    others = [house.BUILD / "live" / f"{name}.o" for name in
              ("engine", "given", *(one.folder for one in house.chapters() if one != chapter))]
    tests = [parts.BUILD / f"{name}.o" for name in objects_of(chapter)]
    subprocess.run(["clang++", *live.LINK, "-Wl,--export=__stack_pointer", "-Wl,--stack-first",
                    "-Wl,-z,stack-size=1048576", made, *tests, *others, "-o", out], check=True)
    return out


def in_the_browser(chapter, jobs):
    """What the tests print of their drawn cases, and the grades of these (answer, id), as the page
    finds them."""
    job = {"wasm": str(module(chapter)), "chapter": packing.about(chapter), "drawing":
           [f"{name}={value}" for name, value in DRAWING.items()],
           "jobs": [{"answer": name, "id": id_} for name, id_ in jobs]}
    result = subprocess.run(["node", HERE / "reports.js"], input=json.dumps(job), text=True,
                            capture_output=True, check=True)
    drawn, *grades = [json.loads(line) for line in result.stdout.splitlines()]
    return drawn, grades


def natively(chapter, name, id_):
    one = grading.Grade(id_)
    run = runs.run(house.BUILD / "tests" / f"{chapter.folder}_answers", [id_], answer=name)
    grading.read(run, {id_: one}, chapter)
    return one


def lines_of(text):
    return [line.rstrip() for line in text.strip().split("\n")]


def alike(mine, its):
    """Do two reports say the same? Numbers may differ that rounding decides; of drawn cases
    none do."""
    if mine == its:
        return True
    if all(VAGUE in " ".join(report) for report in (mine, its)):
        return True
    words = [re.sub(r"-?\d+(\.\d+)?(e[-+]\d+)?", "0", " ".join(" ".join(report).split()))
             for report in (mine, its)]
    if any(DRAWN in one for one in words):
        return False
    return words[0] == words[1]


def differs(one, other):
    """Where the page's grade is not the native one; "" where they are alike."""
    if one.status != other["status"]:
        return f"is '{one.status}' natively and '{other['status']}' in the browser"
    mine = [(name, lines_of(report)) for name, report in one.failures]
    its = [(each["name"], lines_of(each["report"])) for each in other["failures"]]
    if UNSET in str(its):
        return ""
    first = next((pair for pair in zip(mine, its) if pair[0][0] != pair[1][0] or not
                  alike(pair[0][1], pair[1][1])), None)
    if not first and (len(mine) == len(its) or VAGUE in str(mine)):
        return ""
    if not first:
        return f"{len(mine)} of its tests fail natively and {len(its)} in the browser"
    return "\n".join(["is told natively", *first[0][1], "and in the browser", *first[1][1]])


def every_report_is_the_native_one(*_):
    """every known answer is told in the browser what it is told natively"""
    for chapter in chosen():
        parts.build_objects(objects_of(chapter))
        house.must_build([f"{chapter.folder}_answers"])
        answers = judging.known(chapter, False)
        refused = judging.answers.refused_of(judging.source_of(chapter, "numbers"))
        jobs = [(one.name, one.id) for one in answers
                if not one.faults and one.key() not in refused
                and not one.name.startswith(UNDEFINED)]
        (drawn, found), same = in_the_browser(chapter, jobs), 0
        yield from other_cases("in the browser", chapter, drawn)
        for (name, id_), other in zip(jobs, found, strict=True):
            one = natively(chapter, name, id_)
            if (words := differs(one, other)) and not name.startswith(AT_THRESHOLD):
                yield f"{name}: {words}"
            same += [lines_of(report) for _, report in one.failures] == [
                lines_of(each["report"]) for each in other["failures"]]
        notes.append(f"course: chapter {chapter.number}: {same} of {len(jobs)} known answers are "
                     "told the same, letter by letter; the others but for numbers or compilers")


if __name__ == "__main__":
    if lacking := parts.missing(npm=False):
        print(f"the exercises in a browser: {' '.join(lacking)} missing (Debian packages)")
        sys.exit(77)
    sys.exit(main(__doc__, [every_report_is_the_native_one], sys.argv[1:]))
