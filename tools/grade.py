"""How far the reader is: the exercises' tests, run and read."""
import html
import os
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

import exercises
import house

DONE, OPEN, WAITS = "done", "not written yet", "waits for"
WRONG, BROKEN = "wrong", "does not compile"


@dataclass
class Grade:
    """Where one exercise stands: the worst of its tests."""
    id: str
    status: str = DONE
    detail: str = ""  # the exercise it waits for, or what the compiler said
    tests: int = 0
    failures: list = field(default_factory=list)  # (test name, report)

    def words(self):
        return f"{self.status} {self.detail}" if self.status == WAITS else self.status


ORDER = [DONE, WAITS, OPEN, WRONG, BROKEN]


def worse(grade, status, detail=""):
    if ORDER.index(status) > ORDER.index(grade.status):
        grade.status, grade.detail = status, detail


# What the standard library says of an index that is not there: operator[], front(), back(), at().
OUTSIDE = re.compile(
    r"Assertion '(__n < this->size\(\)|!this->empty\(\))'|_M_range_check|array::at")


ARRAY = re.compile(r"std::array<.*_Tp = ([\w:]+)[;,].*_Nm = (\d+)")  # of what, and of how many
SWAPPED = re.compile(r"Assertion '!\(__hi < __lo\)'")  # and of std::clamp
# What the beginning of such words tells of the function they come from: its head and its lines.
CLUES = {r"an index outside an array of \d+ rows": r"\bJacobian\b",
         r"an index outside an array of \d+ numbers": r"\bVector\b",
         "an index": r"\w\[|\.at\(|\.back\(|\.front\(", "std::clamp": r"\bclamp\("}


def plainly(words):
    """What was thrown, or said by a crash, in plain words."""
    if SWAPPED.search(words):
        return ("std::clamp(a, low, high) was given a high that is below low: are the ends "
                "exchanged, has a\nbound the wrong sign, or was it never set?")
    if OUTSIDE.search(words):
        if array := ARRAY.search(words):
            kind = {"joints::Row": " rows", "double": " numbers"}.get(array[1], "")
            return (f"an index outside an array of {array[2]}{kind}: its places run from 0 to "
                    f"{int(array[2]) - 1}")
        return "an index outside a vector or an array: places run from 0 to size() - 1"
    if re.search(r"SIGSEGV|exit status -11\b", words):
        return ("the program crashed: it reached for memory that is not its own. An index gone "
                "astray (a\nstd::vector<bool> does not check its own), a pointer or number that "
                "was never set, or a\nfunction that calls itself without end?")
    if re.search(r"SIGABRT|exit status -6\b", words) and "Assertion" not in words:
        return ("the program was stopped: something has been written over the memory beside a "
                "vector. An\nindex gone astray (a std::vector<bool> does not check its own)?")
    return words


def with_place(words, chapter, id_):
    """A report that no test has written: where the exercise is, and the next command. Of several
    regions it is the one that has an index or a clamp in it, where that is the trouble."""
    place, text = chapter.place(id_), chapter.mine.read_text()
    lines = text.split("\n")

    def function(region):
        head = next((k for k in range(region.begin, 0, -1) if re.match(r"\w", lines[k])), 0)
        return "\n".join(lines[head:region.begin] + region.answer())
    for beginning, clue in CLUES.items():
        found = [region for region in exercises.regions(text) if region.id == id_
                 and re.search(clue, function(region))]
        if re.match(beginning, words) and len(found) == 1:
            place = f"{house.short(chapter.mine)}:{found[0].begin}"
            break
    return f"{words}\n\nWhere: {place}\nNext:  ./wb hint {id_}"


def read_case(grade, case, chapter):
    """One test case of Catch's XML."""
    name = case.get("name")
    grade.tests += 1
    result = case.find("OverallResult")
    if result is not None and result.get("success") == "true":
        return
    words, says_where = [], True
    for element in case.iter():
        if element.tag == "FatalErrorCondition":
            words.append(plainly(f"the program crashed: {(element.text or '').strip()}"))
            says_where = False
        elif element.tag in ("Exception", "Failure") and element.text:
            words.append(plainly(element.text.strip()))
            says_where = element.tag == "Failure"
        elif element.tag == "Expression" and element.get("success") == "false":
            if element.find("FatalErrorCondition") is not None:
                continue  # it was right: the crash came after it
            words.append(f"{element.findtext('Original', '').strip()} is not true: "
                         f"{element.findtext('Expanded', '').strip()}")
        elif element.tag == "Info":
            words.append((element.text or "").strip())
    text = "\n".join(words)
    if match := re.search(r"exercise (\d+\.\d+) is not written yet", text):
        if match[1] == grade.id:
            worse(grade, OPEN)
        else:
            worse(grade, WAITS, match[1])
        return
    worse(grade, WRONG)
    text = text or "it failed without a word"
    grade.failures.append((name, text if says_where else with_place(text, chapter, grade.id)))


def run(program, ids, timeout=10, answer=None):
    """Runs the tests of these exercises in one process: Catch's XML, or words if it did not end
    well. `answer` is the known answer to run (tools/answers.py), if it is one."""
    filter_ = ",".join(f"[{id_}]" for id_ in ids)
    env = dict(os.environ, WORKBOOK_ANSWER=answer) if answer else None
    try:
        result = subprocess.run([program, filter_, "-r", "xml"], capture_output=True, text=True,
                                errors="replace", timeout=timeout, env=env)
    except subprocess.TimeoutExpired as late:
        said = late.stdout or b""
        said = said.decode(errors="replace") if isinstance(said, bytes) else said
        begun = re.findall(r'<TestCase name="([^"]*)"', said)
        return ("it did not end within ten seconds: a loop without an end?"
                + (f"\nThe test was: {html.unescape(begun[-1])}" if begun else ""))
    try:
        tree = ElementTree.fromstring(result.stdout)
    except ElementTree.ParseError:
        return plainly(f"the program crashed (exit status {result.returncode})\n{result.stderr}")
    for crash in tree.iter("FatalErrorCondition"):  # the library's reason stands beside the report
        crash.text = f"{(crash.text or '').strip()}\n{result.stderr}".strip()
    return tree


def read(tree, grades, chapter, only=None):
    """Fills the grades of a chapter's exercises from what run() returned."""
    for case in tree.iter("TestCase"):
        for tag in re.findall(r"\[(\d+\.\d+)\]", case.get("tags", "")):
            if tag in grades and only in (None, tag):
                read_case(grades[tag], case, chapter)


def program_of(chapter, kind="test"):
    return house.BUILD / "tests" / f"{chapter.folder}_{kind}_mine"


def grade(chapter, ids=None):
    """Builds the reader's file and grades its exercises, in order."""
    ids = ids or chapter.ids()
    grades = {id_: Grade(id_) for id_ in ids}
    log = house.build([f"{chapter.folder}_test_mine"], f"building chapter {chapter.number}")
    if log:
        for one in grades.values():
            worse(one, BROKEN, house.compiler_words(log))
        return list(grades.values())
    program = program_of(chapter)
    tree = run(program, ids)
    ended_well = not isinstance(tree, str) and tree.find(".//FatalErrorCondition") is None
    trees = {None: tree} if ended_well else {ids[0]: tree} if len(ids) == 1 else {
        id_: run(program, [id_]) for id_ in ids}  # one by one: which of them was it?
    for id_, part in trees.items():
        if isinstance(part, str):
            worse(grades[id_], WRONG)
            grades[id_].failures.append(("", with_place(part, chapter, id_)))
            continue
        read(part, grades, chapter, id_)
    for one in grades.values():
        if one.tests == 0 and one.status == DONE:
            raise house.Trouble(f"exercise {one.id} has no test")
    return list(grades.values())


def units(chapter, id_):
    """What the units say to a wrong exercise, in a sentence; "" where they have nothing to say or
    cannot follow the answer. An exercise whose numbers are right is not asked for its units."""
    if house.build([f"{chapter.folder}_units_mine"], "asking the units"):
        return ""
    return units_of(run(program_of(chapter, "units"), [id_]))


def units_of(tree):
    """The sentence on units in what run() returned; "" where there is none."""
    found = [] if isinstance(tree, str) else [e.text or "" for e in tree.iter("Failure")]
    return next((" ".join(words.split()) for words in found if "Units: " in words), "")
