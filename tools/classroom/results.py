"""What is handed back: points, the table of a class, and for everyone a text and the forms that
other systems read."""
import configparser
import csv
import json
import re
import xml.etree.ElementTree as ElementTree
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from base import house
from judge import grade as grading

MISSING = "not handed in"
RULES = "points.ini"
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
    known = {id_ for chapter in house.chapters() for id_ in chapter.ids()}
    try:
        parser.read_string(path.read_text(encoding="utf-8"))
        found = Rules({name: float(value) for name, value in
                       (parser["points"] if "points" in parser else {}).items()},
                      **{name: float(value) for name, value in
                         (parser["rules"] if "rules" in parser else {}).items()})
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


def words_of(one, id_):
    return one.grades[id_].words() if id_ in one.grades else MISSING


def total(lines):
    return round(sum(points for _, _, _, points, _, _ in lines), 2)


def done(one, ids):
    return sum(words_of(one, id_) == grading.DONE for id_ in ids)


def tests(one):
    return f"{one.passed} of {one.tests}" if one.tests else ""


def reports(one):
    """What is said of an exercise, all of it."""
    if one.status == grading.BROKEN:
        return one.detail
    if one.status == grading.WAITS:
        return (f"Right with the workbook's version of {one.detail}, which it calls and which is "
                "not right or not written yet.")
    return "\n\n".join(f"{name}\n\n{report}".strip() for name, report in one.failures)


def write_table(path, submissions, ids, rules):
    """A line for each; the last one says how many have done each exercise."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["submission", *ids, "done", "points", "alike", "notes"])
        for one in submissions:
            table.writerow([one.name, *(words_of(one, id_) for id_ in ids), done(one, ids),
                            total(list(lines_of(one, ids, {}, rules))), one.alike,
                            " ".join(one.notes)])
        count = [sum(words_of(one, id_) == grading.DONE for one in submissions) for id_ in ids]
        table.writerow(["done in all", *count, sum(count), "", "", ""])


def write_text(path, one, ids, titles, rules):
    """The feedback of one submission. Nothing of the others is in it."""
    lines = list(lines_of(one, ids, titles, rules))
    said = [f"# {one.name}", "", f"{done(one, ids)} of {len(ids)} exercises done, {total(lines):g} "
            f"of {sum(most for *_, most, _ in lines):g} points", "",
            "| Exercise | | Tests passed | Points |", "|---|---|---|---|"]
    for id_, title, grade, points, most, _ in lines:
        said.append(f"| {id_} {title} | {words_of(one, id_)} | {tests(grade)} | "
                    f"{points:g} of {most:g} |")
    said += ["", *(f"* {note}" for note in one.notes)]
    for id_, _, grade, _, _, _ in lines:
        if words := reports(grade):
            words = words.replace("```", "'''")
            said += ["", f"## {id_}: {grade.words()}", "", "```", words, "```"]
    write(path, "\n".join(said) + "\n")


def lines_of(one, ids, titles, rules):
    """What the forms below are made of: (exercise, title, grade, points, most, words)."""
    for id_ in ids:
        grade = one.grades.get(id_) or grading.Grade(id_, MISSING)
        points, most = rules.points(grade)
        yield (id_, titles.get(id_, ""), grade, points, most,
               "\n".join(filter(None, [words_of(one, id_), reports(grade)])))


def gradescope(one, lines):
    """results.json of Gradescope."""
    tests = [{"number": id_, "name": title or id_, "score": points, "max_score": most,
              "status": "passed" if points == most else "failed", "output": words}
             for id_, title, _, points, most, words in lines]
    return json.dumps({"score": total(lines), "output": "\n".join(one.notes), "tests": tests},
                      indent=1)


def classroom(one, lines):
    """What a grader of GitHub Classroom hands to the reporter, which reads it in base64."""
    tests = [{"name": f"{id_} {title}".strip(), "score": points, "message": words,
              "status": "pass" if points == most else
              "error" if grade.status == grading.BROKEN else "fail"}
             for id_, title, grade, points, most, words in lines]
    status = "pass" if all(test["status"] == "pass" for test in tests) else "fail"
    return json.dumps({"version": 1, "status": status, "tests": tests,
                       "max_score": round(sum(most for *_, most, _ in lines), 2)}, indent=1)


def autolab(one, lines):
    """The last line of what a grader of Autolab prints."""
    return json.dumps({"scores": {id_: points for id_, _, _, points, _, _ in lines}})


def junit(one, lines):
    """A suite in JUnit's XML. What is not handed in or not written is skipped."""
    suite, count = ElementTree.Element("testsuite", name=plain(one.name)), Counter()
    for id_, title, grade, _, _, words in lines:
        case = ElementTree.SubElement(suite, "testcase", time="0", name=plain(
            f"{id_} {title}".strip()), classname=f"chapter {id_.partition('.')[0]}")
        kind = {grading.WRONG: "failure", grading.BROKEN: "error", grading.OPEN: "skipped",
                MISSING: "skipped"}.get(grade.status)
        if kind:
            count[kind] += 1
            words = plain(words)
            ElementTree.SubElement(case, kind, message=words.partition("\n")[0]).text = words
    for name, kind in (("tests", None), ("failures", "failure"), ("errors", "error"),
                       ("skipped", "skipped")):
        suite.set(name, str(count[kind] if kind else len(lines)))
    suite.set("time", "0")
    ElementTree.SubElement(suite, "system-out").text = plain("\n".join(one.notes))
    root = ElementTree.Element("testsuites")
    root.append(suite)
    return ElementTree.tostring(root, encoding="unicode", xml_declaration=True)


def plain(words):
    """Without the characters that XML does not know."""
    return re.sub("[^\t\n\r\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]", "?", words)


FORMS = {".json": gradescope, ".classroom.json": classroom, ".autolab.json": autolab,
         ".xml": junit}


def write_forms(path, one, ids, titles, rules):
    """The result of one submission for the systems that classes use."""
    lines = list(lines_of(one, ids, titles, rules))
    for ending, form in FORMS.items():
        write(Path(f"{path}{ending}"), form(one, lines) + "\n")


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", errors="replace")


def file_name(name):
    return name.replace("/", "_")
