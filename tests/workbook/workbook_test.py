"""The workbook proves itself: workbook_test.py ROOT BUILD

One function a proof; it yields a line for everything that is wrong. Exit status 1 when something is
wrong, 2 for a bad command line. With CI=true the committed stubs must be fresh; in a reader's
checkout they may hold the reader's work.
"""
import csv
import os
import re
import subprocess
import sys
import tempfile
from collections import Counter
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tools"))
import exercises  # noqa: E402
import grade  # noqa: E402
import house  # noqa: E402

HEADINGS = ["Goal", "Derivation", "Numbers", "Code", "Exercises", "Check", "Predict", "See it",
            "A printed formula that is wrong: find it", "Questions", "Further reading"]
OPTIONAL = {"A printed formula that is wrong: find it"}
# Every program: a symbol that it uses, and those that it must not carry. Chapters 1 and 2 run on
# the reader's own loop, so on no solver and no joint of the engine.
OWN_LOOP = r"SequentialImpulses|\w*Joint"
LATER = {3: r"Axis::|HingeAngle|HingeJoint|Limit<", 4: r"Line::|Slide::|RotationLock|SliderJoint",
         5: r"Weld|FixedJoint|cross_K|carried",
         6: r"limit_bias|beta_for|warm_start\(|projection_sweep|project\(",
         7: r"colours_of|whole_K|hoist|LanesFor|WideImpulses",
         8: r"GroundContact|Corner::|friction_impulse|impact_speed"}
ALL = "|".join(LATER.values())
PROGRAMS = {
    "01_distance_run": ("apply_impulse", rf"Point::|block_impulse|turned\(|{OWN_LOOP}|{ALL}"),
    "02_ball_run": ("block_impulse", f"{OWN_LOOP}|{ALL}"),
    "03_hinge_run": ("Axis::", "|".join(LATER[k] for k in range(4, 9))),
    "04_slider_run": ("Line::", rf"{LATER[5]}|{LATER[6]}|{LATER[8]}|HingeJoint|HingeAngle"),
    "05_fixed_run": ("Weld::", rf"{LATER[6]}|{LATER[7]}|{LATER[8]}"),
    "06_baumgarte_run": ("projection_sweep", rf"{LATER[5]}|{LATER[7]}|{LATER[8]}"),
    "07_performance_run": ("colours_of", "|".join([OWN_LOOP, *(LATER[k] for k in (4, 5, 6, 8))])),
    "08_ground_run": ("GroundContact", rf"{LATER[6].replace('limit_bias|', '')}|{LATER[7]}")}
QUOTED = {"docs/library.md": ["CMakeLists.txt", "main.cpp", "crate.cpp"]}  # of its consumer
LONG_FILES = {"tests/01_distance/test.cpp": "the tests of six exercises",
              "tests/workbook/workbook_test.py": "many short proofs"}
MOST_LINES, MOST_COLUMNS = 330, 100
notes = []


# ---- reading -------------------------------------------------------------------------------------

def read(path):
    """The text of a file; "" where there is none (a proof of its own says so)."""
    return path.read_text(encoding="utf-8") if path.is_file() else ""


def regions(chapter):
    return exercises.regions(read(chapter.solution), chapter.solution.name)


def files(root, *endings):
    """All files of the workbook with these endings: nothing that was built, drawn or is hidden."""
    for path in sorted(root.rglob("*")):
        parts = path.relative_to(root).parts
        made = parts[0] == "out" or parts[0].startswith("build")
        if path.is_file() and path.suffix in endings and not made and not any(
                part.startswith(".") or part == "__pycache__" for part in parts):
            yield path


def prose(text):
    """A Markdown text without fenced and inline code; formulas stay."""
    kept, fence = [], None
    for line in text.split("\n"):
        if line.lstrip().startswith("```"):
            fence = line.strip() if fence is None else None
        elif fence in (None, "```math"):
            kept.append(re.sub(r"`[^`]*`", "", line))
    return "\n".join(kept)


def sections(text, mark):
    """The parts of a Markdown text by their headings, which begin with mark: (heading, body)."""
    parts = re.split(rf"^{mark} (.+)$", text, flags=re.M)[1:]
    return list(zip([heading.strip() for heading in parts[::2]], parts[1::2]))


def section(chapter, heading):
    """One section of a chapter's text."""
    return dict(sections(prose(read(chapter.text)), "##")).get(heading, "")


def folded(text):
    return " ".join(text.split())


# ---- exercises -----------------------------------------------------------------------------------

def stubs_are_fresh(root, build):
    """the committed stubs are what the solutions make of them"""
    for chapter in house.chapters():
        fresh, mine = exercises.stub(read(chapter.solution)), read(chapter.mine)
        where = chapter.mine.relative_to(root)
        if fresh != mine and os.environ.get("CI") == "true":
            yield f"{where} differs from the stub of the solution"
        elif fresh != mine:
            try:
                same = exercises.outside(fresh) == exercises.outside(mine)
                notes.append(f"{where} " + ("holds work" if same else "differs from the stub "
                                            "outside the exercises, too"))
            except exercises.Broken as error:
                notes.append(str(error).replace("this file", str(where)))


def every_region_has_a_task(root, build):
    """every exercise states its task, has an answer, and is numbered by its chapter"""
    for chapter in house.chapters():
        for region in regions(chapter):
            if not region.task() or not "".join(region.answer()).strip():
                yield f"{chapter.solution.name}: {region.id} lacks its task or its answer"
        wanted = [f"{chapter.number}.{n + 1}" for n in range(len(chapter.ids()))]
        if chapter.ids() != wanted:
            yield f"{chapter.folder}: the exercises are {chapter.ids()}, not {wanted}"


def every_exercise_has_hints(root, build):
    """every exercise has three hints, and no hint belongs to nothing"""
    for chapter in house.chapters():
        found = sections(prose(read(chapter.hints)), "##")
        yield from differ(f"{chapter.folder}/hints.md", [id_ for id_, _ in found], chapter.ids())
        for id_, body in found:
            hints = sections(body, "###")
            if [number for number, text in hints if text.strip()] != ["1", "2", "3"]:
                yield f"{chapter.folder}/hints.md: {id_} has not the hints 1, 2, 3"


def every_exercise_stands_in_the_table(root, build):
    """every exercise has a row in the table of its chapter's text"""
    for chapter in house.chapters():
        rows = re.findall(r"^\|\s*(\d+\.\d+)\s*\|", section(chapter, "Exercises"), re.M)
        yield from differ(f"{chapter.folder}/README.md, Exercises", rows, chapter.ids())


def every_exercise_has_tests(root, build):
    """every exercise has a test, and no test belongs to no exercise"""
    for chapter in house.chapters():
        file = root / "tests" / f"{chapter.folder}_test.cpp"
        cases = re.findall(r"TEST_CASE\((.*?)\)\s*\{", read(file), re.S)
        tags = [tag for case in cases for tag in re.findall(r"\[(\d+\.\d+)\]", case)]
        yield from differ(file.name, list(dict.fromkeys(tags)), chapter.ids())


def every_exercise_has_wrong_answers(root, build):
    """every exercise has two known wrong answers, and no answer belongs to no exercise"""
    places = Counter(region.id for chapter in house.chapters() for region in regions(chapter))
    count = Counter()
    for path in files(root / "tests", ".cpp"):
        kind = path.parent.name
        if kind not in ("wrong", "right"):
            continue
        id_, place, promise, body = exercises.read_answer(path)
        if not 1 <= place <= places[id_] or not body.strip():
            yield f"tests/{kind}/{path.name} is empty, or there is no region {place} of {id_}"
        if (kind == "wrong") != bool(promise):
            yield f"tests/{kind}/{path.name}: every wrong answer and no right one has '// expects:'"
        count[id_] += kind == "wrong" and path.parent.parent == root / "tests"
    yield from (f"{id_} has {count[id_]} wrong answers: at least two are wanted"
                for id_ in places if count[id_] < 2)


def differ(where, found, wanted):
    yield from (f"{where}: {id_} is missing" for id_ in wanted if id_ not in found)
    yield from (f"{where}: {id_} is no exercise" for id_ in found if id_ not in wanted)
    if set(found) == set(wanted) and found != wanted:
        yield f"{where}: {' '.join(found)} where {' '.join(wanted)} is wanted"


# ---- texts ---------------------------------------------------------------------------------------

def texts_have_their_headings(root, build):
    """every chapter's text has the headings that all chapters have, in their order"""
    for chapter in house.chapters():
        found = [heading for heading, _ in sections(prose(read(chapter.text)), "##")]
        wanted = [h for h in HEADINGS if h not in OPTIONAL or h in found]
        if found != wanted:
            yield f"{chapter.folder}/README.md: {found} where {wanted} is wanted"


def questions_have_answers(root, build):
    """every chapter asks three or four questions, and each has an answer"""
    for chapter in house.chapters():
        asked = re.findall(r"^(\d+)\. ", section(chapter, "Questions"), re.M)
        answers = prose(read(chapter.solution.parent / "answers.md"))
        answered = [heading.removeprefix("Question ") for heading, _ in sections(answers, "##")]
        if asked not in (list("123"), list("1234")) or answered != asked:
            yield f"{chapter.folder}: README.md asks {asked}, answers.md answers {answered}"


def equations_exist(root, build):
    """every equation is numbered once, in order, and every number that is used exists"""
    tags = {c.number: re.findall(r"\\tag\{([^}]*)\}", read(c.text)) for c in house.chapters()}
    for number, found in tags.items():
        wanted = [f"{number}-{n + 1}" for n in range(len(found))]
        if found != wanted or not found:
            yield f"chapter {number}: the equations are {found}"
    known = {tag for found in tags.values() for tag in found}
    used = re.compile(r"\bEqs?\. (\d+-\d+(?:(?:,| and| or| to|, and) \d+-\d+)*)")
    for path in files(root, ".cpp", ".h", ".md", ".py"):
        text = prose(read(path)) if path.suffix == ".md" else read(path)
        for match in used.finditer(folded(text)):
            for tag in set(re.findall(r"\d+-\d+", match[1])) - known:
                yield f"{path.relative_to(root)}: there is no Eq. {tag}"


def texts_keep_the_solution(root, build):
    """no line of a solution stands in a chapter's text or in a first or second hint"""
    for chapter in house.chapters():
        hints = [hint for _, body in sections(read(chapter.hints), "##")
                 for number, hint in sections(body, "###") if number in "12"]
        public = folded(read(chapter.text) + " ".join(hints))
        for region in regions(chapter):
            for line in region.answer():
                code = folded(line.split("//")[0])
                if len(code) > 25 and code in public:
                    yield f"{chapter.folder}: the answer of {region.id} stands in the text: {code}"


def links_lead_somewhere(root, build):
    """every link and picture of a text leads to a file"""
    link = re.compile(r"\]\(\s*<?([^)\s>]+)[^)]*\)|<[^>]+(?:src|href)=\"([^\"]+)\"")
    for path in files(root, ".md"):
        for match in link.finditer(re.sub(r"\$[^$\n]*\$", "", prose(read(path)))):
            target = (match[1] or match[2]).split("#")[0].split("?")[0]
            if not target or re.match(r"[a-z]+:", target):
                continue
            if not (path.parent / target).exists():
                yield f"{path.relative_to(root)}: {target} does not exist"


def errata_are_shown(root, build):
    """every test that the list of errata names exists"""
    tests = "".join(read(path) for path in files(root / "tests" / "own", ".cpp"))
    for word in sorted(set(re.findall(r"`(\[E\d+\]|[IX]\d+)`", read(root / "docs/errata.md")))):
        if (word if word[0] == "[" else f'TEST_CASE("{word} ') not in tests:
            yield f"docs/errata.md names the test {word}: there is none"


def quotations_are_exact(root, build):
    """a file that a text quotes stands there as it is"""
    for text, sources in QUOTED.items():
        blocks = re.findall(r"^```\w+\n(.*?)^```$", read(root / text), re.M | re.S)
        for source in sources:
            if read(root / "tests/library/consumer" / source) not in filter(None, blocks):
                yield f"{text} does not quote {source} as it is"


# ---- sources -------------------------------------------------------------------------------------

def may_include(name):
    """The folders from which a file may include, by the file's place."""
    chapter = re.match(r"(?:chapters|solutions)/(\d\d)_", name)
    last = int(chapter[1]) if chapter else 0 if name.startswith("engine/") else 99
    allowed = ["engine/"] + [f"chapters/{n:02}_" for n in range(1, last + 1)]
    return allowed + {"bench": ["bench/"], "tests": ["bench/", "tests/"]}.get(name[:5], [])


def layers_hold(root, build):
    """everybody includes only what lies below: engine, chapters in their order, bench, tests"""
    measuring = re.compile(r"engine/(measure|record|plan|program|stage|summary)\.")
    for path in files(root, ".cpp", ".h"):
        name = str(path.relative_to(root))
        engine = name.startswith("engine/") and not measuring.match(name)
        for header in re.findall(r'^\s*#include "([^"]+)"', read(path), re.M):
            if header.endswith(".cpp") or not header.startswith(tuple(may_include(name))):
                yield f"{name} must not include {header}"
            elif engine and measuring.match(header):
                yield f"{name} must not include {header}: the engine does not measure"


def sources_are_short(root, build):
    """no line is longer than 100 columns, no source longer than 330 lines"""
    for path in files(root, ".cpp", ".h", ".py"):
        name, lines = str(path.relative_to(root)), read(path).splitlines()
        for number, line in enumerate(lines, 1):
            if len(line) > MOST_COLUMNS:
                yield f"{name}:{number} has {len(line)} columns"
        if len(lines) > MOST_LINES and name in LONG_FILES:
            notes.append(f"{name} has {len(lines)} lines: {LONG_FILES[name]}")
        elif len(lines) > MOST_LINES:
            yield f"{name} has {len(lines)} lines"


# ---- programs ------------------------------------------------------------------------------------

def run(program, *arguments, **more):
    return subprocess.run([str(program), *arguments], capture_output=True, text=True, timeout=60,
                          **more)


def programs_carry_what_they_use(root, build):
    """a program carries no symbol of what it does not use"""
    for program, (used, foreign) in PROGRAMS.items():
        symbols = run("nm", "-C", str(build / program)).stdout
        if f"joints::{used}" not in symbols:
            yield f"{program}: nm shows no symbols"
        for symbol in sorted(set(re.findall(rf"joints::(?:{foreign})\w*", symbols))):
            yield f"{program} carries {symbol}"


def lanes_stay_at_home(root, build):
    """what is compiled for one kind of processor shares no function with the rest"""
    for kind in ("wide", "wide_float"):
        for path in (build / "CMakeFiles" / f"{kind}.dir" / "engine").glob("*avx2*.o"):
            lines = run("nm", "-C", str(path)).stdout.splitlines()
            if not any("sweep_lanes_avx2" in line for line in lines):
                yield f"{path.name}: nm shows no symbols"
            for line in lines:  # W, V, u: one definition of several, whichever the linker takes
                if re.match(r"[0-9a-f]* ?[WVu] ", line.strip()) and "LanesFor<2>" not in line:
                    yield f"{kind}, {path.name}: {line.strip()}"


def bad_words_are_refused(root, build):
    """a bad command line gets one line that names the option, and exit status 2"""
    bad = ["--nonsense", "--iterations 0", "--iterations x", "--iterations", "--seconds -1",
           "--beta nan", "nonsense", "--seconds 0.1 --out file/below"]
    for program in PROGRAMS:
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "file").write_text("")
            for words in bad:
                result = run(build / program, *words.split(), cwd=folder)
                name = "out" if "--out" in words else words.split()[0]
                if result.returncode != 2:
                    yield f"{program} {words}: exit status {result.returncode}, not 2"
                elif result.stderr.count("\n") != 1 or name not in result.stderr:
                    yield f"{program} {words}: says {result.stderr!r}"
                if os.listdir(folder) != ["file"]:
                    yield f"{program} {words}: writes something all the same"
            help_ = run(build / program, "--help", cwd=folder)
            if help_.returncode != 0 or help_.stderr or "--iterations" not in help_.stdout:
                yield f"{program} --help: exit status {help_.returncode}, {help_.stderr!r}"


def crashes_are_placed(root, build):
    """a crash is told in plain words, at the one region of its exercise that it can come from"""
    chapter, id_ = house.exercise_of("8.2")
    clamps = [r for r in regions(chapter) if r.id == id_ and "clamp(" in "".join(r.answer())]
    crash = grade.plainly("std::clamp(...): Assertion '!(__hi < __lo)' failed.")
    told = grade.with_place(crash, SolutionOf(chapter), id_)
    for words in ("clamp(a, low, high)", f"{chapter.solution.name}:{clamps[0].begin}\n"):
        if words not in told:
            yield f"a crash of {id_} is told without '{words.strip()}': {told}"


class SolutionOf:
    """A chapter whose solution stands in the place of the reader's file."""
    def __init__(self, chapter):
        self.mine, self.place = chapter.solution, chapter.place


def programs_repeat_themselves(root, build):
    """a program that runs twice writes the same tables and motions, apart from times"""
    for program in PROGRAMS:
        with tempfile.TemporaryDirectory() as folder:
            one, two = Path(folder) / "one", Path(folder) / "two"
            for out in (one, two):
                result = run(build / program, "--seconds", "0.5", "--out", str(out))
                if result.returncode != 0:
                    yield f"{program}: exit status {result.returncode}: {result.stderr.strip()}"
            if not (one / "summary.csv").is_file():
                yield f"{program} writes no summary.csv"
            for path in sorted(one.glob("*")):
                if untimed(path) != untimed(two / path.name):
                    yield f"{program}: {path.name} differs from run to run"
                if path.suffix == ".csv" and len({len(row) for row in table(path)}) != 1:
                    yield f"{program}: {path.name} has rows that are longer than its header"


def table(path):
    return list(csv.reader(read(path).splitlines()))


def untimed(path):
    """What a file says, without the columns that hold times."""
    if path.suffix != ".csv":
        return read(path)
    rows = table(path)
    timed = [k for k, column in enumerate(rows[0]) if re.match(r"(us|ns)_", column)]
    return [[word for k, word in enumerate(row) if k not in timed] for row in rows]


PROOFS = [stubs_are_fresh, every_region_has_a_task, every_exercise_has_hints,
          every_exercise_stands_in_the_table, every_exercise_has_tests,
          every_exercise_has_wrong_answers, texts_have_their_headings, questions_have_answers,
          equations_exist, texts_keep_the_solution, links_lead_somewhere, errata_are_shown,
          quotations_are_exact, layers_hold, sources_are_short, programs_carry_what_they_use,
          lanes_stay_at_home, bad_words_are_refused, crashes_are_placed,
          programs_repeat_themselves]


def main(arguments):
    if len(arguments) != 2 or not all(Path(argument).is_dir() for argument in arguments):
        print("workbook_test.py ROOT BUILD", file=sys.stderr)
        return 2
    root, build = (Path(argument).resolve() for argument in arguments)
    house.ROOT = root
    broken = 0
    for proof in PROOFS:
        wrong = list(proof(root, build))
        broken += bool(wrong)
        print(f"{'WRONG' if wrong else 'holds'}  {proof.__doc__}")
        for line in wrong:
            print(f"         {line}")
    for note in notes:
        print(f"note   {note}")
    print(f"{len(PROOFS) - broken} of {len(PROOFS)} proofs hold")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
