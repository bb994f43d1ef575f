"""./wb grade: what a class has handed in, exercise by exercise."""
import csv
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
from collections import Counter
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field
from pathlib import Path

from base import exercises
from check import checking
from classroom import fence
from judge import grade as grading
from base import house
from classroom import lend
from learn.status import COLOURS
from base.talk import WIDTH, bold, faint, folded, indented

MISSING = "not handed in"
# What stands in the table, where it is not the same.
SHORT = {grading.OPEN: "-", grading.WAITS: "waits", grading.BROKEN: "broken", MISSING: ""}
LEGEND = {grading.OPEN: "-: not written yet", grading.BROKEN: "broken: does not compile",
          grading.WAITS: "waits: it calls an exercise that is not written yet"}
SUMMED = {grading.WAITS: "waiting for another", grading.BROKEN: "not compiling"}
LIMIT = 180     # for one exercise file, compiler and tests [s]
LARGEST = 1e6   # exercise file [bytes]; they have some ten thousand
EXPECTED = ("A submission is a folder with exercise files such as distance.cpp, in it or in "
            "01_distance/ or chapters/01_distance/ of it. Name submissions, or a folder of them: "
            "./wb grade class")


@dataclass
class Submission:
    """What one of the class has handed in."""
    name: str
    files: dict                                 # folder of a chapter: exercise file
    grades: dict = field(default_factory=dict)  # exercise: Grade

    def words(self, id_):
        return self.grades[id_].words() if id_ in self.grades else MISSING

    def done(self, ids):
        return sum(self.words(id_) == grading.DONE for id_ in ids)


# ---- what was handed in --------------------------------------------------------------------------

def files_in(folder):
    """{folder of a chapter: exercise file} of a submission. What leads out of it does not count."""
    found = {}
    for chapter in house.chapters():
        name = f"{chapter.name}.cpp"
        for inner in (Path("chapters", chapter.folder), chapter.folder, ""):
            path = folder / inner / name
            if path.is_file() and path.resolve().is_relative_to(folder.resolve()):
                found.setdefault(chapter.folder, path)
    return found


def submissions_in(folders):
    """Each folder is a submission, or each of its folders is."""
    places = []
    for folder in folders:
        if not folder.is_dir():
            raise house.Trouble(f"grade: {folder}: there is no such folder")
        inner = [place for place in sorted(folder.iterdir())
                 if place.is_dir() and not place.name.startswith((".", "__"))]
        if files_in(folder):
            places.append(folder)
        elif any(map(files_in, inner)):
            places += inner
        else:
            raise house.Trouble(f"grade: {folder}: there is no exercise file\n{folded(EXPECTED)}")
    count = Counter(place.name for place in places)
    return [Submission(printable(place.name if count[place.name] == 1
                                 else f"{place.parent.name}/{place.name}"), files_in(place))
            for place in places]


def printable(name):
    return "".join(letter if letter.isprintable() else "?" for letter in name)


# ---- grading -------------------------------------------------------------------------------------

def grade_file(path, chapter, line):
    """The grades of one exercise file. `line`: the commands that make the tests of the reader's."""
    if path.stat().st_size > LARGEST:
        return broken(chapter, f"the file is larger than {LARGEST:.0f} bytes")
    with tempfile.TemporaryDirectory(prefix="grade_", ignore_cleanup_errors=True) as folder:
        folder = Path(folder).resolve()
        file = folder / "chapters" / chapter.folder / path.name
        file.parent.mkdir(parents=True)
        file.write_bytes(path.read_bytes())
        target = f"{chapter.folder}_test_mine"
        lend.lend(house.BUILD, folder / "build", house.ROOT, [
            (target, f"tests/{target}", file, line.replace(str(chapter.mine), str(file)))])
        said = ask(folder, chapter)
    verdicts = [line for line in said.split("\n") if line.startswith("[")]  # not of the progress
    if not verdicts:
        return broken(chapter, "the file cannot be read")
    return [grading.Grade(**one) for one in json.loads(verdicts[-1])]


def broken(chapter, words):
    return [grading.Grade(id_, grading.BROKEN, words) for id_ in chapter.ids()]


def ask(folder, chapter):
    """What tools/classroom/submission.py says of the file in the folder, so far as it comes."""
    env = dict(os.environ, TMPDIR=str(folder), HOME=str(folder))
    env.pop("WORKBOOK_ANSWER", None)
    process = subprocess.Popen(
        [sys.executable, "-B", house.ROOT / "tools/classroom/submission.py", folder,
         chapter.folder],
        cwd=folder, env=env, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL, text=True, start_new_session=True)

    def end():  # with all that it has started; it has not been waited for, so the number is its own
        os.killpg(process.pid, signal.SIGKILL)
    alarm = threading.Timer(LIMIT, end)
    alarm.start()
    said = process.stdout.read()
    alarm.cancel()
    end()
    process.wait()
    process.stdout.close()
    return said


def grade_all(submissions, chapters):
    """Grades what was handed in. What is as the stubs are need not be compiled."""
    jobs, lines = [], {}
    for chapter in chapters:
        fresh = exercises.stub(exercises.read(chapter.solution))
        for one in submissions:
            path = one.files.get(chapter.folder)
            if path and path.stat().st_size < LARGEST and exercises.read(path) == fresh:
                one.grades |= {id_: grading.Grade(id_, grading.OPEN) for id_ in chapter.ids()}
            elif path:
                jobs.append((one, chapter))
    house.configure()
    for chapter in {chapter.folder: chapter for _, chapter in jobs}.values():
        lines[chapter.folder] = lend.commands(house.BUILD, f"{chapter.folder}_test_mine",
                                              chapter.name)
    if needs := sorted({path for line in lines.values() for path in lend.needs(line)}):
        house.must_build(needs, "building the tests")
    with house.talking(), ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        running = {pool.submit(grade_file, one.files[chapter.folder], chapter,
                               lines[chapter.folder]): one for one, chapter in jobs}
        for count, done in enumerate(as_completed(running), 1):
            running[done].grades |= {one.id: one for one in done.result()}
            house.progress(f"{count} of {len(jobs)} files graded")
    house.progress_done()


# ---- what is said --------------------------------------------------------------------------------

def tell_chapter(chapter, submissions):
    """A table: a line for each submission."""
    ids = chapter.ids()
    title = f"Chapter {chapter.number}: {chapter.name}"
    room = WIDTH - 2 - 7 * len(ids) - len(f"{99} of {99}")
    width = min(room, max(len(name) for name in [title, *(one.name for one in submissions)]))

    def line(name, words, last, colours=()):
        name = name if len(name) <= width else name[:width - 2] + ".."
        cells = [f"{word:7}" for word in words]
        for place, colour in enumerate(colours):
            cells[place] = colour(cells[place])
        print(f"{name:{width}}  {''.join(cells)}{last}".rstrip())
    line(title, ids, "done", [bold] * len(ids))
    for one in submissions:
        states = [MISSING if id_ not in one.grades else one.grades[id_].status for id_ in ids]
        line(one.name, [SHORT.get(state, state) for state in states],
             f"{one.done(ids)} of {len(ids)}" if chapter.folder in one.files else MISSING,
             [COLOURS.get(state, str) for state in states])
    if len(submissions) > 1:
        total = [str(sum(one.done([id_]) for one in submissions)) for id_ in ids]
        line("done in all", total,
             f"{sum(map(int, total))} of {len(ids) * len(submissions)}")
    print()


def tell_why(submission):
    """The first report of every exercise that is wrong, and what the compiler says, once."""
    told = set()
    for id_, one in submission.grades.items():
        report = one.failures[0][1] if one.failures else \
            one.detail if one.status == grading.BROKEN else ""
        if report and report not in told:
            told.add(report)
            print(f"{bold(id_)}  {COLOURS[one.status](one.words())}\n{indented(report)}\n")


def write(path, submissions, ids):
    """The table of all as comma separated values; the last line says how many have done each."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["submission", *ids, "done"])
        for one in submissions:
            table.writerow([one.name, *map(one.words, ids), one.done(ids)])
        total = [sum(one.done([id_]) for one in submissions) for id_ in ids]
        table.writerow(["done in all", *total, sum(total)])


def grade(folders):
    """Grades submissions, or folders of them."""
    submissions = submissions_in(folders)
    chapters = [chapter for chapter in house.chapters()
                if any(chapter.folder in one.files for one in submissions)]
    if not fence.version():
        print(folded("Note: this system has no Landlock (Linux 5.13 and newer have it), so that "
                     "nothing keeps a submission from writing where you may write. Grade only what "
                     "you trust, or grade in a container.") + "\n")
    grade_all(submissions, chapters)
    for chapter in chapters:
        tell_chapter(chapter, submissions)
    ids = [id_ for chapter in chapters for id_ in chapter.ids()]
    states = Counter(one.grades[id_].status for one in submissions for id_ in one.grades)
    if legend := [words for state, words in LEGEND.items() if state in states]:
        print(faint("\n".join(legend)) + "\n")
    if len(submissions) == 1:
        tell_why(submissions[0])
    table = house.OUT / "grades.csv"
    write(table, submissions, ids)
    print(f"{len(submissions)} submission{'s' * (len(submissions) > 1)}: "
          + ", ".join(f"{states[state]} {SUMMED.get(state, state)}"
                      for state in grading.ORDER if states[state]))
    print(f"the table: {house.short(table)}; processor time: {checking.processor_time():.0f} s")
    if len(submissions) > 1 and states[grading.WRONG] + states[grading.BROKEN]:
        print("Why: ./wb grade with the folder of one submission prints its reports.")
    return 0
