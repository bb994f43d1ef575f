"""How far the reader is: the exercises' tests, run and read."""
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

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


def read_case(grade, case):
    """One test case of Catch's XML."""
    name = case.get("name")
    grade.tests += 1
    result = case.find("OverallResult")
    if result is not None and result.get("success") == "true":
        return
    words = []
    for element in case.iter():
        if element.tag == "FatalErrorCondition":
            words.append(f"the program crashed: {(element.text or '').strip()}")
        elif element.tag in ("Exception", "Failure") and element.text:
            words.append(element.text.strip())
        elif element.tag == "Expression" and element.get("success") == "false":
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
    grade.failures.append((name, text or "it failed without a word"))


def run(chapter, ids, kind="test", timeout=10):
    """Runs the tests of these exercises in one process; words if it did not end well."""
    program = house.BUILD / "tests" / f"{chapter.folder}_{kind}_mine"
    filter_ = ",".join(f"[{id_}]" for id_ in ids)
    try:
        result = subprocess.run([program, filter_, "-r", "xml"],
                                capture_output=True, text=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        return "it did not end within ten seconds: a loop without an end?"
    try:
        return ElementTree.fromstring(result.stdout)
    except ElementTree.ParseError:
        return f"the program crashed (exit status {result.returncode})"


def grade(chapter, ids=None):
    """Builds the reader's file and grades its exercises, in order."""
    ids = ids or chapter.ids()
    grades = {id_: Grade(id_) for id_ in ids}
    log = house.build([f"{chapter.folder}_test_mine"], f"building chapter {chapter.number}")
    if log:
        for one in grades.values():
            worse(one, BROKEN, house.compiler_words(log))
        return list(grades.values())
    tree = run(chapter, ids)
    ended_well = not isinstance(tree, str) and tree.find(".//FatalErrorCondition") is None
    trees = {None: tree} if ended_well else {ids[0]: tree} if len(ids) == 1 else {
        id_: run(chapter, [id_]) for id_ in ids}  # one by one: which of them was it?
    for id_, part in trees.items():
        if isinstance(part, str):
            worse(grades[id_], WRONG)
            grades[id_].failures.append(("", part))
            continue
        for case in part.iter("TestCase"):
            for tag in re.findall(r"\[(\d+\.\d+)\]", case.get("tags", "")):
                if tag in grades and (id_ is None or tag == id_):
                    read_case(grades[tag], case)
    for one in grades.values():
        if one.tests == 0 and one.status == DONE:
            raise house.Trouble(f"exercise {one.id} has no test")
    return list(grades.values())


def units(chapter, id_):
    """What the units say to a wrong exercise, in a sentence; "" where they have nothing to say or
    cannot follow the answer. An exercise whose numbers are right is not asked for its units."""
    if house.build([f"{chapter.folder}_units_mine"], "asking the units"):
        return ""
    tree = run(chapter, [id_], "units")
    found = [] if isinstance(tree, str) else [e.text or "" for e in tree.iter("Failure")]
    return next((" ".join(words.split()) for words in found if "Units: " in words), "")
