"""How far the reader is: the exercises' tests, run and read. Their results are kept in
build/verdicts for as long as neither the exercise file nor the program changes."""
import hashlib
import json
import re
import textwrap
from dataclasses import asdict, dataclass, field
from pathlib import Path

from base import exercises, house
from judge import crashes, runs
from judge.crashes import plainly  # noqa: F401

DONE, OPEN, WAITS = "done", "not written yet", "waits for"
WRONG, BROKEN = "wrong", "broken"  # broken: the compiler or what reads the file refuses it
ORDER = [DONE, WAITS, OPEN, WRONG, BROKEN]


@dataclass
class Grade:
    """Where one exercise stands: the worst of its tests."""
    id: str
    status: str = DONE
    detail: str = ""  # the exercise it waits for, or what the compiler said
    tests: int = 0
    passed: int = 0   # of them
    failures: list = field(default_factory=list)  # (test name, report)
    printed: str = ""   # what its code writes itself
    ends: bool = True   # false where it had to be stopped

    def words(self):
        return f"{self.status} {self.detail}" if self.status == WAITS else self.status


def worse(grade, status, detail=""):
    if ORDER.index(status) > ORDER.index(grade.status):
        grade.status, grade.detail = status, detail


# ---- what the tests say --------------------------------------------------------------------------

def named(report):
    """The mistake that a report names; "" if none."""
    found = re.search(r"Likely mistake: (.*?)(?=\n\s*\n|\nWhere: |\Z)", report, re.S)
    return " ".join(found[1].split()) if found else ""


def second_mistake(failures):
    """A sentence on another mistake: one that a later test names, in another region than the first
    report, or where that names none. "" if there is none."""
    where = [report.partition("Where: ")[2].split("\n")[0] for _, report in failures]
    first = named(failures[0][1])
    for place, (_, report) in zip(where[1:], failures[1:]):
        words = named(report)
        if words and (place != where[0] or not first):
            return f"Another test names a mistake at {place}: {words}"
    return ""


def with_place(words, chapter, id_):
    """A report that no test has written: where the exercise is, and the next command. Of several
    regions it is the one with an index or a clamp in its function, where that is the trouble."""
    place, text = chapter.place(id_), exercises.read(chapter.mine)
    lines = text.split("\n")

    def function(region):
        head = next((k for k in range(region.begin, 0, -1) if re.match(r"\w", lines[k])), 0)
        return "\n".join(lines[head:region.begin] + region.answer())
    all_ = [region for region in exercises.scan(text)[0] if region.id == id_]
    for beginning, clue in crashes.CLUES.items():
        found = [region for region in all_ if re.search(clue, function(region))]
        if re.match(beginning, words) and len(found) == 1:
            place = f"{house.short(chapter.mine)}:{found[0].begin}"
            break
    else:  # a crash may come from any of the exercise's regions
        place += "".join(f" or :{region.begin}" for region in all_[1:])
    return f"{textwrap.fill(words, 76)}\n\nWhere: {place}\nNext:  ./wb hint {id_}"


def read_case(grade, case, chapter):
    """One test case of Catch's XML."""
    name = case.get("name")
    grade.tests += 1
    result = case.find("OverallResult")
    if result is not None and result.get("success") == "true":
        grade.passed += 1
        return
    words, says_where = [], True
    for element in case.iter():
        text = (element.text or "").strip()
        if element.tag == "Exception":
            words.append(runs.thrown(text))
            says_where = False
        elif element.tag in ("Failure", "Info") and text:
            words.append(text)
            says_where |= element.tag == "Failure"
        elif element.tag == "Expression" and element.get("success") == "false" and \
                "{Unknown expression" not in element.findtext("Original", ""):
            words.append(f"{element.findtext('Original', '').strip()} is not true: "
                         f"{element.findtext('Expanded', '').strip()}")
    text = "\n".join(words)
    if match := re.search(r"exercise (\d+\.\d+) is not written yet", text):
        return worse(grade, *((OPEN,) if match[1] == grade.id else (WAITS, match[1])))
    worse(grade, WRONG)
    text = text or "it failed without a word"
    grade.failures.append((name, text if says_where else with_place(text, chapter, grade.id)))


def read(run, grades, chapter):
    """Fills the grades of a chapter's exercises from a run. Returns those in which it ended badly:
    of the others it says nothing then."""
    for case in run.cases:
        asked = [tag for tag in re.findall(r"\[(\d+\.\d+)\]", case.get("tags", ""))
                 if tag in grades]
        about = re.search(r"^\s*Exercise (\d+\.\d+): ", "".join(case.itertext()), re.M)
        for tag in [about[1]] if about and about[1] in asked else asked:  # of several: which it is
            read_case(grades[tag], case, chapter)
    if not run.fault:
        return []
    blamed = [id_ for id_ in re.findall(r"\[(\d+\.\d+)\]", run.tags) if id_ in grades]
    for id_ in blamed or grades:
        worse(grades[id_], WRONG)
        grades[id_].tests += 1
        grades[id_].ends = not run.fault.startswith("it did not end")
        grades[id_].failures.append((run.name, with_place(run.fault, chapter, id_)))
    return blamed or list(grades)


# ---- building and running ------------------------------------------------------------------------

def program_of(chapter, kind="test"):
    return house.BUILD / "tests" / f"{chapter.folder}_{kind}_mine"


def build(chapter):
    """Builds the tests with the reader's file. Returns "" or what the compiler says of it."""
    log = house.build([f"{chapter.folder}_test_mine"], f"building chapter {chapter.number}")
    if not log:
        return ""
    words = house.compiler_words(log)
    if not re.search(rf"chapters/{chapter.folder}/|undefined reference|Undefined symbols", words):
        raise house.Trouble(f"the build failed:\n{words}")
    return words


def refused_in(chapter, words):
    """[(exercise, line)] of the compiler's errors, or else of its warnings."""
    line = rf"{re.escape(chapter.mine.name)}:(\d+):"
    errors = re.findall(rf"{line}.*\berror:", words)  # a template's error begins with its user
    return [(region.id, number) for number in map(int, errors or re.findall(line, words))
            for region in exercises.scan(chapter.mine_text())[0]
            if region.begin <= number <= region.end + 2]  # the closing brace, too


def beside_refused(chapter, broken):
    """Of a file that the compiler refuses: only those exercises are broken that it names, the
    others are as they were when they were tested last, or wait."""
    guilty = [id_ for id_, _ in refused_in(chapter, broken[0].detail)]
    before = recall(chapter, as_texts_are=True) if guilty else {}
    return [one if not guilty or one.id in guilty else
            before.get(one.id) or Grade(one.id, WAITS, guilty[0]) for one in broken]


def grade(chapter, ids=None, limit=runs.LIMIT, fresh=False):
    """Grades exercises of the reader's file, in order. With `fresh` they run again even where it is
    known what they say; `limit` is how long they may take together [s]."""
    ids = ids or chapter.ids()
    if log := build(chapter):
        return [Grade(id_, BROKEN, log) for id_ in ids]
    known = {} if fresh else recall(chapter)
    found = {id_: known[id_] for id_ in ids if id_ in known}
    found |= tested(chapter, [id_ for id_ in ids if id_ not in found], program_of(chapter), limit)
    house.progress_done()
    keep(chapter, found)
    return [found[id_] for id_ in ids]


def tested(chapter, waiting, program, limit=runs.LIMIT):
    """{exercise: what the program of the tests says of it}."""
    found = {}
    while waiting:
        part = {id_: Grade(id_) for id_ in waiting}
        house.progress(f"testing {' '.join(waiting)}")
        with house.talking():
            run = runs.run(program, waiting, limit)
        ended = read(run, part, chapter) or waiting
        for id_ in ended:
            if part[id_].tests == 0 and not run.fault:
                raise house.Trouble(f"exercise {id_} has no test")
            if len(ended) == 1 and limit == runs.LIMIT and program == program_of(chapter):
                part[id_].printed = printed(program, part[id_], run)
            found[id_] = part[id_]
        waiting = [id_ for id_ in waiting if id_ not in ended]
    return found


def printed(program, grade, run):
    """What the code of an exercise prints: of a wrong one in the test that is told, else in the
    first."""
    name = next((name for name, _ in grade.failures), run.cases[0].get("name") if run.cases else "")
    if not name or not (run.printed or run.fault):
        return run.printed
    return runs.said_in(program, name) or run.printed


def units(chapter, id_):
    """What the units say to a wrong exercise, in a sentence; "" where they have nothing to say or
    cannot follow the answer. An exercise whose numbers are right is not asked for its units."""
    if house.build([f"{chapter.folder}_units_mine"],
                   "no known mistake fits; checking the units (half a minute, once)"):
        return ""
    return units_of(runs.run(program_of(chapter, "units"), [id_]))


def units_of(run):
    """The sentence on units in a run; "" where there is none."""
    found = [element.text or "" for case in run.cases for element in case.iter("Failure")]
    said = next((" ".join(words.split()) for words in found if "Units: " in words), "")
    if re.search(r"\^-?\d{2}", said):  # no product of anything: memory that nobody has written
        return "Units: none that make sense: a variable is read that was never set."
    return said


# ---- what is known already -----------------------------------------------------------------------

def stamp(chapter):
    """Differs as soon as the exercise file, the program that was built with it, or the words of
    this module do."""
    digest = hashlib.sha256()
    for path in (program_of(chapter), chapter.mine, *map(Path, (
            __file__, crashes.__file__, runs.__file__))):
        digest.update(path.read_bytes())
    return digest.hexdigest()


def shelf(chapter):
    return house.BUILD / "verdicts" / f"{chapter.folder}.json"


def texts(chapter):
    """{exercise: a digest of its lines in the reader's file}."""
    lines = {}
    for region in exercises.scan(chapter.mine_text())[0]:
        lines.setdefault(region.id, []).extend(region.lines)
    return {id_: hashlib.sha256("\n".join(lines[id_]).encode(errors="replace")).hexdigest()
            for id_ in lines}


def recall(chapter, as_texts_are=False):
    """The grades that are known of this file and this program; or of exercises whose text is still
    the same."""
    try:
        kept, now = json.loads(shelf(chapter).read_text()), texts(chapter)
        if as_texts_are or kept["stamp"] == stamp(chapter):
            return {id_: Grade(**one) for id_, one in kept["grades"].items()
                    if not as_texts_are or kept["texts"].get(id_) == now.get(id_)}
    except (OSError, ValueError, KeyError, TypeError):
        pass
    return {}


def keep(chapter, grades):
    known = recall(chapter) | grades
    exercises.write(shelf(chapter), json.dumps(
        {"stamp": stamp(chapter), "texts": texts(chapter),
         "grades": {id_: asdict(one) for id_, one in known.items()}}))
