"""What is handed back: points, the table of a class, a text and a results.json for everyone."""
import configparser
import csv
import json
import re
from dataclasses import dataclass, field

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


def tally(one, ids, rules):
    """(points, most) of a submission."""
    all_ = [rules.points(one.grades.get(id_) or grading.Grade(id_, grading.OPEN)) for id_ in ids]
    return round(sum(points for points, _ in all_), 2), round(sum(most for _, most in all_), 2)


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
                            tally(one, ids, rules)[0], one.alike, " ".join(one.notes)])
        total = [sum(words_of(one, id_) == grading.DONE for one in submissions) for id_ in ids]
        table.writerow(["done in all", *total, sum(total), "", "", ""])


def write_text(path, one, ids, titles, rules):
    """The feedback of one submission. Nothing of the others is in it."""
    points, most = tally(one, ids, rules)
    said = [f"# {one.name}", "", f"{done(one, ids)} of {len(ids)} exercises done, "
            f"{points:g} of {most:g} points", "", "| Exercise | | Tests passed | Points |",
            "|---|---|---|---|"]
    for id_ in ids:
        grade = one.grades.get(id_) or grading.Grade(id_, MISSING)
        points, most = rules.points(grade)
        said.append(f"| {id_} {titles.get(id_, '')} | {words_of(one, id_)} | {tests(grade)} | "
                    f"{points:g} of {most:g} |")
    said += ["", *(f"* {note}" for note in one.notes)]
    for id_, grade in one.grades.items():
        if words := reports(grade):
            words = words.replace("```", "'''")
            said += ["", f"## {id_}: {grade.words()}", "", "```", words, "```"]
    write(path, "\n".join(said) + "\n")


def write_json(path, one, ids, titles, rules):
    """The same as Gradescope reads it."""
    found = []
    for id_ in ids:
        grade = one.grades.get(id_) or grading.Grade(id_, MISSING)
        points, most = rules.points(grade)
        found.append({"name": f"{id_} {titles.get(id_, '')}".strip(), "score": points,
                      "max_score": most, "status": "passed" if points == most else "failed",
                      "output": "\n".join(filter(None, [words_of(one, id_), reports(grade)]))})
    write(path, json.dumps({"score": tally(one, ids, rules)[0], "output": "\n".join(one.notes),
                            "tests": found}, indent=1) + "\n")


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8", errors="replace")


def file_name(name):
    return name.replace("/", "_")
