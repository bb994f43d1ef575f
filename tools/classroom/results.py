"""What is handed back: points, the table of a class, and for everyone a text and the forms that
other systems read."""
import configparser
import csv
import hashlib
import json
import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from base import house
from classroom.collecting import MISSING
from judge import grade as grading

RULES = "points.ini"
LONGEST = 100  # name of a file, without its ending [bytes]
OF_RULES = """[points]  weights of exercises, such as 1.6 = 2 (without: 1)
[rules]   partial = 0.5: the tests that a wrong exercise passes earn up to half of its points
          waits = 1: what is right but for another exercise earns all of them"""


@dataclass
class Rules:
    """What exercises are worth."""
    weights: dict = field(default_factory=dict)
    partial: float = 0
    waits: float = 1

    def points(self, one):
        """Of a grade, or of None: (points, most)."""
        most = self.weights.get(one.id, 1)
        share = 0
        if one.status == grading.DONE:
            share = 1
        elif one.status == grading.WAITS:
            share = self.waits
        elif one.status == grading.WRONG and one.tests:
            share = self.partial * one.passed / one.tests
        return round(share * most, 2), most


def rules_of(path):
    """The rules in a file; what is in it and means nothing is said."""
    if not path.is_file():
        return Rules()
    parser = configparser.ConfigParser()
    parser.read_dict({"points": {}, "rules": {}})
    known = {id_ for chapter in house.chapters() for id_ in chapter.ids()}
    try:
        parser.read_string(path.read_text(encoding="utf-8"))
        found = Rules({name: float(value) for name, value in parser["points"].items()},
                      **{name: float(value) for name, value in parser["rules"].items()})
    except (configparser.Error, ValueError, TypeError) as error:
        raise house.Trouble(f"grade: {path.name}: {error}\n{OF_RULES}")
    if odd := sorted(set(found.weights) - known):
        raise house.Trouble(f"grade: {path.name}: there is no exercise {', '.join(odd)}\n"
                            + OF_RULES)
    return found


def count_tests(chapter):
    """{exercise: how many tests it has}, from their source: a crash hides the rest of them."""
    text = (house.ROOT / "tests" / chapter.folder / "test.cpp").read_text(encoding="utf-8")
    tags = re.findall(r'TEST_CASE\((?:\s*"(?:[^"\\]|\\.)*")+,\s*"((?:\[[\w.]+\])+)"', text)
    return {id_: sum(f"[{id_}]" in tag for tag in tags) for id_ in chapter.ids()}


def total(lines):
    return round(sum(line.points for line in lines), 2)


def most(lines):
    return round(sum(line.most for line in lines), 2)


def reports(one):
    """What is said of an exercise, all of it."""
    if one.status == grading.BROKEN:
        return one.detail
    if one.status == grading.WAITS:
        return (f"Right with the workbook's version of {one.detail}, which it calls and which is "
                "not right or not written yet.")
    first = {report: name for name, report in reversed(one.failures)}
    said = "\n\n".join(f"{name}\n\n{report}".strip() for name, report in one.failures
                       if first[report] == name)
    seed = re.search(r"drawn with seed (\d+)", said)
    return said + (f"\n\nThe same cases again: WORKBOOK_SEED={seed[1]} ./wb test {one.id}"
                   if seed else "")


@dataclass
class Line:
    """An exercise of a submission, as the forms below show it."""
    id: str
    title: str
    grade: grading.Grade
    points: float
    most: float

    @property
    def name(self):
        return f"{self.id} {self.title}".strip()

    @property
    def full(self):
        return self.points == self.most

    @property
    def words(self):
        return "\n".join(filter(None, [self.grade.words(), reports(self.grade)]))


def lines_of(one, ids, rules):
    titles = {id_: title for chapter in house.chapters() for id_, title in chapter.titles().items()}
    return [Line(grade.id, titles.get(grade.id, ""), grade, *rules.points(grade))
            for grade in map(one.grade, ids)]


def cell(words):
    """As a table shows it: a name that begins like a formula is none."""
    return f"'{words}" if words[:1] in tuple("=+-@\t\r") else words


def write_table(path, submissions, ids, rules):
    """A line for each; the last one says how many have done each exercise."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["submission", *ids, "done", "points", "alike", "notes"])
        for one in submissions:
            table.writerow([cell(one.name), *(one.grade(id_).words() for id_ in ids), one.done(ids),
                            total(lines_of(one, ids, rules)), one.alike, cell(" ".join(one.notes))])
        count = [sum(one.done([id_]) for one in submissions) for id_ in ids]
        table.writerow(["done in all", *count, sum(count), "", "", ""])


# ---- the forms: each is made of a submission and its lines ---------------------------------------

def text(one, lines):
    """The feedback in words. Nothing of the others is in it."""
    count = sum(line.grade.status == grading.DONE for line in lines)
    said = [f"# {one.name}", "", f"{count} of {len(lines)} exercises done, {total(lines):g} of "
            f"{most(lines):g} points", "", "| Exercise | | Tests passed | Points |",
            "|---|---|---|---|"]
    for line in lines:
        tests = f"{line.grade.passed} of {line.grade.tests}" if line.grade.tests else ""
        said.append(f"| {line.id} {line.title} | {line.grade.words()} | {tests} | "
                    f"{line.points:g} of {line.most:g} |")
    said += ["", *(f"* {note}" for note in one.notes)]
    for line in lines:
        if words := reports(line.grade).replace("```", "'''"):
            said += ["", f"## {line.id}: {line.grade.words()}", "", "```", words, "```"]
    return "\n".join(said)


def gradescope(one, lines):
    """results.json of Gradescope."""
    tests = [{"number": line.id, "name": line.title or line.id, "score": line.points,
              "max_score": line.most, "status": "passed" if line.full else "failed",
              "output": line.words} for line in lines]
    return json.dumps({"score": total(lines), "output": "\n".join(one.notes), "tests": tests},
                      indent=1)


def classroom(_, lines):
    """What a grader of GitHub Classroom hands to the reporter, which reads it in base64."""
    tests = [{"name": line.name, "score": line.points, "message": line.words,
              "status": "pass" if line.full else
              "error" if line.grade.status == grading.BROKEN else "fail"} for line in lines]
    return json.dumps({"version": 1, "status": "pass" if all(line.full for line in lines) else
                       "fail", "tests": tests, "max_score": most(lines)}, indent=1)


def autolab(_, lines):
    """The last line of what a grader of Autolab prints."""
    return json.dumps({"scores": {line.id: line.points for line in lines}})


def junit(one, lines):
    """A suite in JUnit's XML. What is not handed in or not written is skipped."""
    kinds = {grading.WRONG: "failure", grading.BROKEN: "error", grading.OPEN: "skipped",
             MISSING: "skipped"}
    count = Counter(kinds.get(line.grade.status) for line in lines)
    root = ElementTree.Element("testsuites")
    suite = ElementTree.SubElement(
        root, "testsuite", name=plain(one.name), time="0", tests=str(len(lines)),
        failures=str(count["failure"]), errors=str(count["error"]), skipped=str(count["skipped"]))
    for line in lines:
        case = ElementTree.SubElement(suite, "testcase", time="0", name=plain(line.name),
                                      classname=f"chapter {line.id.partition('.')[0]}")
        if kind := kinds.get(line.grade.status):
            words = plain(line.words)
            ElementTree.SubElement(case, kind, message=words.partition("\n")[0]).text = words
    ElementTree.SubElement(suite, "system-out").text = plain("\n".join(one.notes))
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True)


def plain(words):
    """Without the characters that XML does not know."""
    return re.sub("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "?", words)


FORMS = {".md": text, ".json": gradescope, ".classroom.json": classroom, ".autolab.json": autolab,
         ".xml": junit}


def write_forms(path, one, ids, rules):
    """The result of one submission, to be read and for the systems that classes use."""
    lines = lines_of(one, ids, rules)
    path.parent.mkdir(parents=True, exist_ok=True)
    for ending, form in FORMS.items():
        Path(f"{path}{ending}").write_text(form(one, lines) + "\n", encoding="utf-8",
                                           errors="replace")


def file_name(name):
    """One that every disk takes: names of people and of files may be long."""
    name = name.replace("/", "_")
    if len(name.encode()) <= LONGEST:
        return name
    digest = hashlib.sha256(name.encode()).hexdigest()[:8]
    return name.encode()[:LONGEST - 9].decode(errors="ignore") + "_" + digest
