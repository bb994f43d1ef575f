"""The results of ./wb grade for the submissions of a class: grade_test.py ROOT BUILD"""
import contextlib
import csv
import hashlib
import io
import json
import lzma
import sys
import tarfile
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path
from unittest import mock

from door import CHAPTER, Door
from front_door_test import typed
from proofs import exercises, house, main

from classroom import collecting, grading, results, submission
from judge import runs

FILE = "distance.cpp"
LIMIT = "5"  # processor time of an exercise [s]: numbers through a pipe take about a second
IDS = [f"1.{n}" for n in range(1, 7)]
STATES = {"D": "done", "-": "not written yet", "W": "wrong", "B": "broken", "N": "not handed in",
          "b": "waits for 1.1, 1.5", **{n: f"waits for 1.{n}" for n in "1235"}}
# An answer, right, that none of the workbook's files has.
OTHER_K = """  real sum = 0;
  for (const Body* one : {&body1, &body2}) {
    if (one->is_static()) continue;
    const real share = one->inverse_mass;
    sum = share + sum;
  }
  return sum;"""
RENAMED = OTHER_K.replace("sum", "total").replace("one", "b").replace("share", "part  ")


class Class:
    """What is handed in, in a copy of the workbook."""

    def __init__(self, door):
        self.door, self.solution = door, door.solution
        door.limit = LIMIT
        self.folder = door.root.parent / "class"
        self.folder.mkdir()

    def answer(self, id_, code, text=None, own=""):
        """The solution with other code in the first region of an exercise; own is put before the
        solution's in its place."""
        return exercises.replace(text or self.solution, lambda region, place: [
            *region.task(), *([own, *region.answer()] if own else [code])]
            if (region.id, place) == (id_, 1) else None)

    def open(self, *ids):
        fresh = exercises.stub(self.solution)
        return exercises.fill(fresh, self.solution, [id_ for id_ in IDS if id_ not in ids])

    def put(self, path, text):
        path = self.folder / path
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())

    def grade(self, where="", status=1, *expected):
        yield from typed(self.door, f"grade {self.folder}{where}", status, *expected, wide=True)

    def table(self):
        with open(self.door.root / "out" / "grades" / "class.csv", newline="") as file:
            return {row["submission"]: row for row in csv.DictReader(file)}

    def feedback(self, name):
        path = self.result(name, ".md")
        return " ".join(path.read_text().split()) if path.is_file() else "no feedback"

    def result(self, name, ending):
        """A file of feedback. In the table a name that begins like a formula has a sign before."""
        return (self.door.root / "out" / "grades" / "class"
                / (results.file_name(name.removeprefix("'")) + ending))


def zipped(files):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w") as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


def tarred(name, text):
    data = io.BytesIO()
    with tarfile.open(fileobj=data, mode="w:gz") as archive:
        one = tarfile.TarInfo(name)
        one.size = len(text.encode())
        archive.addfile(one, io.BytesIO(text.encode()))
    return data.getvalue()


def tree(folder):
    """The contents of every file of the copy, except the results of grading."""
    return {path: (hashlib.sha1(path.read_bytes()).hexdigest(), path.stat().st_mode)
            for path in folder.rglob("*") if path.is_file() and "out" not in path.parts
            and path.name != "wb.lock"}


# ---- forty submissions ---------------------------------------------------------------------------

def forms(c):
    """{what is handed in: (its bytes by place, the states of 1.1 to 1.6, words of its feedback)}:
    one answer in the forms in which classes hand in."""
    done, text = "DDDDDD", c.solution
    return {
        "plain": ({f"plain/{FILE}": text}, done, "| done | 7 of 7 | 3 of 3 |"),
        "numbered": ({f"numbered/{CHAPTER}/{FILE}": text}, done, ""),
        "placed": ({f"placed/chapters/{CHAPTER}/{FILE}": text}, done, ""),
        "deep": ({f"deep/hand in/week 1/{FILE}": text}, done, ""),
        "second": ({"second/distance (1).cpp": text}, done, "distance (1).cpp was taken"),
        "copy": ({"copy/Copy of distance_final.cpp": text}, done, "was taken for"),
        "capital": ({"capital/Distance.cpp": text}, done, "Distance.cpp was taken"),
        "shouted": ({"shouted/DISTANCE.CPP": text}, done, "was taken for"),
        "renamed": ({"renamed/my answers.cpp": text}, done, ""),
        "as_text": ({"as_text/distance.cpp.txt": text}, done, ""),
        "windows": ({f"windows/{FILE}": "\ufeff" + text.replace("\n", "\r\n")}, done, ""),
        "utf16": ({f"utf16/{FILE}": text.encode("utf-16")}, done, ""),
        "zip": ({"zip.zip": zipped({FILE: text})}, done, ""),
        "repository": ({"repository.zip": zipped({
            f"main/chapters/{CHAPTER}/{FILE}": text, f"main/solutions/{CHAPTER}/{FILE}": "no",
            f"__MACOSX/{FILE}": "no", f"main/build/stubs/{CHAPTER}/{FILE}": "no"})}, done, ""),
        "zip_inside": ({"zip_inside/week1.ZIP": zipped({f"a/{FILE}": text})}, done, ""),
        "tar": ({"tar.tar.gz": tarred(f"tar/{FILE}", text)}, done, ""),
        "mo_1234_distance": ({"mo_1234_distance.cpp": text}, done, ""),
        "with_others": ({f"with_others/{FILE}": text, "with_others/distance.h": "#error",
                         "with_others/CMakeLists.txt": "#error"}, done, ""),
        "two": ({f"two/{FILE}": text, "two/distance (2).cpp": "old " + text}, done,
                "distance (2).cpp was not graded"),
        "Builder Bob": ({f"Builder Bob/{FILE}": text}, done, ""),
        "tests": ({f"tests/{FILE}": text}, done, ""),
        "out": ({f"out/{CHAPTER}/{FILE}": text}, done, ""),
        "umlaut": ({f"umlaut/{FILE}": text, "umlaut/L\udcf6sung.pdf": "no text"}, done, ""),
        "alone": ({"alone/L\udcf6sung.pdf": "no text"}, "NNNNNN", "but L?sung.pdf"),
        "long" + 40 * " names": ({f"long{40 * ' names'}/{FILE}": text}, done, ""),
        "'=HYPERLINK(1)": ({f"=HYPERLINK(1)/{FILE}": text}, done, ""),
        "bomb": ({"bomb.tar.xz": lzma.compress(bytes(60_000_000))}, "NNNNNN",
                 "when it is unpacked"),
        "many": ({"many.zip": zipped({FILE: text, **dict.fromkeys(map(str, range(20_001)), "")})},
                 done, "more than 20000 files"),
        "letter": ({"letter/letter.docx": "Sorry."}, "NNNNNN", "but letter.docx"),
        "nothing": ({"nothing/.keep": ""}, "NNNNNN", ""),
        "rar": ({"rar/all.rar": "Rar!"}, "NNNNNN", "ask for a zip"),
        "torn": ({"torn.zip": "PK\3\4"}, "NNNNNN", "cannot be opened"),
        "large": ({f"large/{FILE}": text + " " * 1_000_001}, "NNNNNN", "larger than"),
    }


def answers(c):
    """The same of answers that are not right, or not only."""
    text, stub = c.solution, exercises.stub(c.solution)
    wrong = c.answer("1.1", "const vec3 n = direction(body2.x - body1.x);"
                            " return {n, vec3(0), -n, vec3(0)};")
    ball = exercises.read(c.door.root / "chapters" / "02_ball" / "ball.cpp")
    given = "settings.beta * C / settings.h"
    table = {
        "untouched": (stub, "------", ""),
        "begun": (c.open("1.3", "1.4", "1.5", "1.6"), "DD----", ""),
        "hole": (c.open("1.1"), "-DD11D", "Right with the workbook's version of 1.1"),
        "sign": (wrong, "WDD1DD", "Likely mistake"),
        "two_wrong": (c.answer("1.5", "return 0;", wrong), "WDDbWD", ""),
        "last": (c.answer("1.6", "return {};"), "DDDDDW", f"chapters/{CHAPTER}/{FILE}:"),
        "semicolon": (c.answer("1.2", "return body1.inverse_mass"), "DBD22D", "expected"),
        "two_broken": (c.answer("1.6", "return nonsense;", c.answer("1.2", "return nonsense;")),
                       "DBD22B", "nonsense"),
        "brace": (c.answer("1.3", "if (K == 0) { return 0;"), "DDB33D", "is never closed"),
        "marker": (text.replace("// end [exercise 1.2]", ""), "DBD22D", "is missing"),
        "no_markers": ("int main() {}\n", "BBBBBB", "are missing"),
        "empty": ("", "BBBBBB", "the file is empty"),
        "other_chapter": (ball, "NNNNNN", "holds exercises of 02_ball"),
        "given": (text.replace(given, f"-{given}"), "DDDDDD", "Outside the exercises line"),
        "helper": (text.replace("namespace joints {\n", "namespace joints {\n\nstatic real helper("
                                f"const Body& body1, const Body& body2) {{\n{OTHER_K}\n}}\n", 1),
                   "DDDDDD", "Outside the exercises lines"),
        "foreign": ("#include <windows.h>\n" + text, "DDDDDD", "windows.h"),
        "own_code": (c.answer("1.2", OTHER_K), "DDDDDD", ""),
        "renamed_code": (c.answer("1.2", RENAMED), "DDDDDD", ""),
        "endless_rope": (c.answer("1.5", "for (volatile bool on = true; on;) {}\n  return 0;"),
                         "DDDDWD", f"did not end within {LIMIT} seconds"),
        "crash_rope": (c.answer("1.5", "*(volatile int*)nullptr = 0;\n  return 0;"), "DDDDWD",
                       "memory that is not its own"),
        "endless": (c.answer("1.2", "for (volatile bool on = true; on;) {}\n  return 0;"),
                    "DWD2DD", f"did not end within {LIMIT} seconds"),
        "asleep": (c.answer("1.2", "for (;;) sleep(9);", "#include <unistd.h>\n" + text), "DWD2DD",
                   f"did not end within {LIMIT} seconds"),
        "blames": (c.answer("1.4", "", text, 'for (const Link& link : links)\n  if (link.rope) '
                            'throw std::runtime_error("Exercise 1.5: nonsense");'), "DDDWDD",
                   "it threw an exception: Exercise 1.5: nonsense"),
        "crash": (c.answer("1.6", "*(volatile int*)nullptr = 0;\n  return {};"), "DDDDDW",
                  "memory that is not its own"),
        "stack": (c.answer("1.6", "return (&body1 != &body2 ? jacobian(body1, body2) : Row{});"),
                  "DDDDDW", "the stack is full"),
        "exit": (c.answer("1.6", "std::exit(0);", "#include <cstdlib>\n" + text), "DDDDDW",
                 "does the code call exit()?"),
        "early": ("#include <cstdlib>\n" + text + "const int early = (std::exit(0), 1);\n",
                  "DDDDDD", "What is added outside the exercises was left out"),
        "spoiler": (c.answer("1.6", "return {};\n}\nint early = (std::exit(0), 1);\n"
                             "[[maybe_unused]] Row none(const Body&) {\n  return {};",
                             "#include <cstdlib>\n" + text), "DDDDDW", "code call exit()?"),
        "greedy": (c.answer("1.6", "std::vector<double> all(1);\n"
                            "  for (;;) all.resize(2 * all.size());\n  return {};"), "DDDDDW",
                   "more memory was requested than a test may have"),
    }
    return {name: ({f"{name}/{FILE}": text}, states, words)
            for name, (text, states, words) in table.items()}


def every_submission_is_judged(root, build):
    """forty submissions of twenty kinds and more: each has the verdict a teacher would give"""
    with Door(root, build) as door:
        door.lend_build()
        c = Class(door)
        expected = forms(c) | answers(c)
        if len(expected) < 40:
            yield f"there are {len(expected)} submissions"
        for files, _, _ in expected.values():
            for path, text in files.items():
                c.put(path, text)
        (c.folder / "linked").mkdir()
        (c.folder / "linked" / FILE).symlink_to(door.root / "solutions" / CHAPTER / FILE)
        expected["linked"] = {}, "NNNNNN", "leads out of the submission"
        c.put("points.ini", "[points]\n1.6 = 3\n[rules]\npartial = 0.5\n")
        before = tree(door.root)
        yield from c.grade("", 1, f"{len(expected)} submission", f"plain {'done ' * 6}6 8",
                           "the table: out/grades/class.csv")
        if changed := set(tree(door.root).items()) ^ set(before.items()):
            yield f"grading has changed {sorted(str(path) for path, _ in changed)}"
        yield from verdicts(c, expected)
        yield from points(c, expected)
        for name in expected:
            yield from forms_agree(c.result(name, ""))
        table = c.table()
        if sorted(name for name, row in table.items() if row["alike"]) != [
                "own_code", "renamed_code"]:
            yield f"alike: {[(name, row['alike']) for name, row in table.items() if row['alike']]}"
        written = (door.root / "out" / "grades" / "class.csv").read_bytes()
        yield from c.grade("/sign", 1, "1 submission: 4 done", "Exercise 1.1",
                           "the feedback: out/grades/class/sign.md")
        yield from c.grade("/zip.zip", 0, "1 submission: 6 done")
        yield from c.grade("/zip.zip --chapters 2-3", 1, "Chapter 3: hinge")
        yield from c.grade("/zip.zip --chapters 1", 0, "1 submission: 6 done")
        if (door.root / "out" / "grades" / "class.csv").read_bytes() != written:
            yield "the table of the class has changed"


def verdicts(c, expected):
    table = c.table()
    for name, (_, states, words) in expected.items():
        row = table.pop(name, {})
        wanted = [STATES[state] for state in states]
        if [row.get(id_) for id_ in IDS] != wanted:
            yield f"{name}: {[row.get(id_) for id_ in IDS]}, not {wanted}: {row.get('notes')}"
        if " ".join(words.split()) not in c.feedback(name):
            yield f"{name}: '{words}' is not in {c.feedback(name)[:900]}"
    if list(table) != ["done in all"]:
        yield f"the table has {sorted(table)}, too"


def points(c, expected):
    """Points of the table and of Gradescope's form: 1.6 counts three, what waits counts whole, the
    tests that a wrong exercise passes up to a half."""
    table = c.table()
    for name, (_, states, _) in expected.items():
        graded = json.loads(c.result(name, ".json").read_text())
        scores = [test["score"] for test in graded["tests"][:6]]
        least = sum(3 if k == 5 else 1 for k, state in enumerate(states) if state in "D1235b")
        most = least + sum((3 if k == 5 else 1) / 2 for k, state in enumerate(states)
                           if state == "W")
        if not least <= graded["score"] <= most or abs(sum(scores) - graded["score"]) > 1e-9:
            yield f"{name}: {graded['score']} points, not {least} to {most}"
        if float(table[name]["points"]) != graded["score"]:
            yield f"{name}: {table[name]['points']} points in the table"
    last = json.loads(c.result("last", ".json").read_text())
    if not 5 < last["score"] < 6.5:
        yield f"of 1.6 some tests pass, and it earns {last['score'] - 5}"


# What the systems' own pages say of their forms: the keys of a test, and which values they take.
JUNIT = {"failures": "failure", "errors": "error", "skipped": "skipped"}


def forms_agree(path):
    """Every form of a result holds the same points and states, in the form that is documented."""
    scope, room, lab = (json.loads(Path(f"{path}{ending}").read_text()) for ending in (
        ".json", ".classroom.json", ".autolab.json"))
    scores = {test["number"]: test["score"] for test in scope["tests"]}
    if lab != {"scores": scores} or "\n" in Path(f"{path}.autolab.json").read_text().strip():
        yield f"{path.name}: Autolab reads {lab}, not {scores}"
    if [test["score"] for test in room["tests"]] != list(scores.values()) or \
            room["max_score"] != sum(test["max_score"] for test in scope["tests"]) or \
            {test["status"] for test in room["tests"]} - {"pass", "fail", "error"} or \
            (room["status"] == "pass") != (scope["score"] == room["max_score"]) or \
            not all(isinstance(test[key], str) for test in room["tests"]
                    for key in ("name", "message")):
        yield f"{path.name}: GitHub Classroom reads {room}"
    suites = ElementTree.parse(f"{path}.xml").getroot()
    if suites.tag != "testsuites" or [suite.tag for suite in suites] != ["testsuite"]:
        return (yield f"{path.name}: {suites.tag} is no root of JUnit")
    cases = suites[0].findall("testcase")
    wrong = [kind for key, kind in JUNIT.items() if int(suites[0].get(key)) != len(
        suites[0].findall(f"testcase/{kind}"))]
    passed = [not any(case.find(kind) is not None for kind in JUNIT.values()) for case in cases]
    if wrong or int(suites[0].get("tests")) != len(cases) or passed != [
            test["status"] == "passed" for test in scope["tests"]] or not all(
            case.get("name") and case.get("classname") for case in cases):
        yield f"{path.name}: JUnit counts {suites[0].attrib}, {passed}"


def what_is_expected_is_said(root, build):
    """a command line without a submission says what one is"""
    with Door(root, build) as door:
        (door.root / "empty").mkdir()
        yield from typed(door, "grade", 2, "required: DIR (./wb grade --help)")
        yield from typed(door, "grade nowhere", 2, "nowhere: there is no such folder")
        yield from typed(door, "grade empty", 2, "there is no exercise file",
                         "distance.cpp", "./wb grade class", wide=True)
        yield from typed(door, "grade empty --fast", 2, "arguments: --fast")
        yield from typed(door, "help grade", 0, "./wb grade class", hidden=["./wb tour"])
        exercises.write(door.root / "c" / "a" / FILE, exercises.stub(door.solution))
        for rules, words in {"[points]\n1.9 = 1": "no exercise 1.9", "[rules]\nlate = 1": "late",
                             "[points]\n1.1 = much": "much", "1.1": "[points] weights"}.items():
            exercises.write(door.root / "c" / "points.ini", rules)
            yield from typed(door, "grade c", 2, words, wide=True)


def chapters_compiled_in_their_own_way_are_graded(root, build):
    """finished files of chapters 7 and 9, with own instructions and read headers, are done"""
    for chapter in map(house.chapter_of, ("7", "9")):
        grades, _ = grading.grade_text(exercises.read(chapter.solution), chapter,
                                       grading.plan_of(chapter))
        yield from (f"{one.id}: {one.words()} {one.detail} {one.failures}" for one in grades
                    if one.words() != "done")


class Early:
    """A clock whose first looks end everything at once."""

    def __init__(self, looks):
        self.looks = looks

    def __call__(self):
        self.looks -= 1
        return 1e-9 if self.looks >= 0 else 20


def graded_here(folder, chapter, plan, _):
    """What tools/classroom/submission.py would say, of this process."""
    with contextlib.redirect_stdout(io.StringIO()) as said:
        judge = submission.Judge(submission.HandedIn(
            chapter.number, chapter.folder, chapter.name, folder), plan)
        judge.judge()
        judge.say()
    return said.getvalue(), []


def what_is_late_by_the_clock_is_judged_again(root, build):
    """a file or an exercise that ends at a limit of the clock is judged again, alone"""
    chapter = house.chapter_of("1")
    text = exercises.read(chapter.solution)
    for where, ask, looks in (("file", grading.ask, 1), ("exercise", graded_here, 2)):
        one = collecting.Submission(where, {chapter.folder: collecting.File("", text, "")})
        with mock.patch.object(runs, "crowd", Early(looks)), \
                mock.patch.object(grading, "ask", ask):
            grading.grade_all([one], [chapter])
        yield from (f"{where}: {id_}: {grade.words()} {grade.detail} {grade.failures}"
                    for id_, grade in one.grades.items() if grade.words() != "done")


PROOFS = [every_submission_is_judged, what_is_expected_is_said,
          chapters_compiled_in_their_own_way_are_graded,
          what_is_late_by_the_clock_is_judged_again]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
