"""Where things are, and how they are built. How wb talks (talk.py) comes with it."""
import contextlib
import fcntl
import hashlib
import json
import os
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

from base import exercises
from base.talk import (TERMINAL, Trouble, ask, bad, bold, faint, good, progress,  # noqa: F401
                  progress_done, talking)

ROOT = Path(__file__).absolute().parents[2]
CALLED_FROM = Path.cwd()
BUILD = ROOT / "build"
OUT = ROOT / "out"


@dataclass
class Chapter:
    """A chapter: its number and folder (1, 01_distance) and its files."""
    number: int
    folder: str
    name: str

    @property
    def mine(self):
        return ROOT / "chapters" / self.folder / f"{self.name}.cpp"

    @property
    def solution(self):
        return ROOT / "solutions" / self.folder / f"{self.name}.cpp"

    @property
    def programs(self):
        """What writes the tables of the solution: the chapter's program, and the experiments of
        bench/ where there are any (a student's edition has none)."""
        more = (ROOT / "bench" / "chapters" / self.folder).is_dir()
        return [f"{self.folder}_run"] + [f"{self.folder}_experiments"] * more

    @property
    def hints(self):
        return ROOT / "chapters" / self.folder / "hints.md"

    @property
    def text(self):
        return ROOT / "chapters" / self.folder / "README.md"

    def to_read(self, id_):
        """What to read before the exercise, in words: the text up to the line that says so, or its
        page of the site where ./wb docs has made one of it."""
        page = OUT / "docs" / "html" / self.page_name
        if page.is_file() and page.stat().st_mtime > self.text.stat().st_mtime:
            return f'{short(page)}, as far as "exercise {id_} now"'
        lines = exercises.read(self.text).split("\n") if self.text.is_file() else []
        for number, line in enumerate(lines, 1):
            if f"exercise {id_} now" in line:  # and what is said with it
                stop = next((k for k in range(number, len(lines)) if not lines[k]), len(lines))
                return f"{short(self.text)}, as far as line {stop}"
        return short(self.text)

    @property
    def page_name(self):
        """Of its text, in the site."""
        return f"chapters_{self.folder}_README.html"

    @property
    def sealed(self):
        """True in a student's edition, where the solution is not there but a stub."""
        return any(map(exercises.is_open, exercises.regions(exercises.read(self.solution))))

    def ids(self):
        """The exercises in the order of their numbers."""
        found = {r.id for r in exercises.regions(self.solution.read_text(), self.solution.name)}
        return sorted(found, key=lambda id_: int(id_.split(".")[1]))

    def mine_text(self):
        """The reader's file, whatever letters are in it; "" where there is none."""
        return exercises.read(self.mine) if self.mine.is_file() else ""

    def titles(self):
        """What each exercise is about, from the list in the chapter's text."""
        text = self.text.read_text(encoding="utf-8") if self.text.exists() else ""
        return {id_: about.replace("`", "") for id_, about in
                re.findall(r"^\* \[(\d+\.\d+)\]\(\S+\) (.*?):(?= |$)", text, re.M)}

    def place(self, id_):
        """file:line of the exercise in the reader's file: its first todo, else where it begins."""
        lines = self.mine_text().split("\n")
        for words in (f'todo("{id_}")', f"// begin [exercise {id_}]"):
            for number, line in enumerate(lines, 1):
                if words in line.split("//")[0] or line.strip() == words:
                    return f"{short(self.mine)}:{number}"
        return short(self.mine)


def chapters():
    """All chapters that have a solution, in order."""
    found = []
    if not (ROOT / "solutions").is_dir():
        raise Trouble("solutions/ is missing: stubs, tests and programs are made from it. An "
                      "edition without solutions is made by ./wb hand-out DIR")
    for folder in sorted((ROOT / "solutions").iterdir()):
        if match := re.match(r"(\d\d)_(\w+)$", folder.name):
            found.append(Chapter(int(match[1]), folder.name, match[2]))
    return found


def programs():
    """Those of all chapters."""
    return [program for chapter in chapters() for program in chapter.programs]


def chapter_of(word):
    """The chapter named by "2", "02", "02_ball", "ball", by an exercise "2.1" or by a file."""
    file = next((place / word for place in (CALLED_FROM, ROOT) if (place / word).is_file()), None)
    for chapter in chapters():
        if word.split(".")[0].lstrip("0") == str(chapter.number) or word == chapter.name \
                or chapter.folder in Path(file or word).resolve().parts:
            return chapter
    raise Trouble(f"{word}: no {'such chapter' if file or '.cpp' not in word else 'such file'}; "
                  f"there are chapters 1 to {len(chapters())}")


def asked(word):
    """The chapter and the exercise, or None for all of them, that are named by "2", "2.1", a file,
    or a line of the reader's file: "chapters/02_ball/ball.cpp:20", in an exercise or before it."""
    path, _, line = word.partition(":")
    chapter, id_ = chapter_of(path), None
    if re.match(r"\d+\.", word):
        id_ = word
        if id_ not in chapter.ids():
            raise Trouble(f"{word}: no such exercise; chapter {chapter.number} has "
                          + " ".join(chapter.ids()))
    elif line.isdigit() and Path(path).name == chapter.mine.name:
        id_ = next((region.id for region in exercises.scan(chapter.mine_text())[0]
                    if int(line) <= region.end + 2), None)
    return chapter, id_


def exercise_of(word):
    """The chapter and id of one exercise."""
    chapter, id_ = asked(word)
    if not id_:
        raise Trouble(f"{word}: an exercise is called by its number, such as {chapter.ids()[0]}")
    return chapter, id_


def sources(root):
    """All files below a folder: nothing that was built, drawn or is hidden."""
    for folder, folders, names in os.walk(root):
        folders[:] = [name for name in folders if name[0] != "." and name != "__pycache__"
                      and not (Path(folder) == root and re.match("out$|build", name))]
        yield from (Path(folder, name) for name in names if name[0] != ".")


def files(root, *endings):
    """All files of the workbook with these endings: nothing that was built, drawn or is hidden."""
    for path in sorted(sources(root)):
        if path.suffix in endings:
            yield path


def python():
    """The interpreter that runs this, as one types it."""
    return "python3" if shutil.which("python3") == sys.executable else sys.executable


def version():
    """The workbook's, which stands in CMakeLists.txt."""
    text = (ROOT / "CMakeLists.txt").read_text()
    return re.search(r"^project\(\w+ VERSION ([\d.]+)", text, re.M)[1]


def short(path):
    """A path as seen from the root of the workbook."""
    path = Path(path)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)


# ---- building ------------------------------------------------------------------------------------

def use_build(preset):
    """From now on another preset's folder is built in and run from."""
    global BUILD
    BUILD, _settings["preset"] = ROOT / "build" / preset, preset


_settings = {"preset": "workbook"}


def configure(again=False):
    """Runs CMake when the build folder is new or was made for another place, or again."""
    cache = BUILD / "CMakeCache.txt"
    if cache.exists() and (BUILD / "build.ninja").exists():
        home = re.search(r"^CMAKE_HOME_DIRECTORY:INTERNAL='?(.*?)'?$", cache.read_text(), re.M)
        if home and os.path.exists(home[1]) and os.path.samefile(home[1], ROOT):
            if not again:
                return
        else:
            shutil.rmtree(BUILD)  # a copied one points at the place it was copied from
    BUILD.mkdir(parents=True, exist_ok=True)
    (BUILD / "wb.lock").touch()  # CMake would say it less clearly if nothing can be written
    progress("configuring")
    command = ["cmake", "-S", ROOT, "--preset", _settings["preset"],
               f"-DPython3_EXECUTABLE={sys.executable}"]
    if os.environ.get("CI") == "true":
        command.append("-DWORKBOOK_WARNINGS_AS_ERRORS=ON")
    with talking():
        result = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
    progress_done()
    if result.returncode != 0:
        raise Trouble("CMake failed:\n" + result.stdout[-1500:] + result.stderr[-3000:])


@contextlib.contextmanager
def alone():
    """Two that build in one folder disturb each other: the second waits."""
    with open(BUILD / "wb.lock", "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            progress("waiting: another ./wb is building")
            fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def build(targets, what="building"):
    """Builds targets; returns "" or what the compiler said."""
    dates_in_the_past()
    configure()
    with alone(), contents_decide():
        return run_ninja(["ninja", "-C", str(BUILD), "-k", "0", *targets], what)


def run_ninja(command, what):
    """Tells its progress; returns "" or what the compiler said."""
    log = []
    with talking():
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   text=True, errors="replace")
        for line in process.stdout:
            if match := re.match(r"\[([1-9]\d*)/(\d+)\] ", line):  # from 1: 0 are its own checks
                progress(f"{what} {match[1]} of {match[2]}{thing_built(line)}")
            log.append(line)
        process.wait()
    progress_done()
    return "" if process.returncode == 0 else "".join(log)


def dates_in_the_past():
    """A source from a clock that is ahead would be built again for ever: its date becomes now."""
    now = time.time()
    for path in sources(ROOT):
        if path.lstat().st_mtime > now + 1:
            os.utime(path)


@contextlib.contextmanager
def contents_decide():
    """Ninja compares dates, and a file that comes back from a backup has an old one. An object of a
    reader's file is made anew unless a note beside it says that it was made of what is in the file
    now."""
    made = {BUILD / place / f"{chapter.folder}/{chapter.mine.name}.o": digest(chapter.mine)
            for chapter in chapters() for place in (
                f"CMakeFiles/{chapter.folder}_mine.dir/chapters",
                f"tests/CMakeFiles/{chapter.folder}_units_mine_file.dir/__/chapters")}
    for path, now in made.items():
        if path.exists() and noted(path) != [now, path.stat().st_mtime_ns]:
            path.unlink()
    yield
    for path, before in made.items():
        if path.exists():
            exercises.write_if_new(f"{path}.of", json.dumps([before, path.stat().st_mtime_ns]))


def digest(path):
    return hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else ""


def noted(path):
    try:
        return json.loads(Path(f"{path}.of").read_text())
    except (OSError, ValueError):
        return None


def thing_built(line):
    """": joints_test, reaction_test.cpp" of a line of ninja's."""
    if match := re.search(r"CMakeFiles/(\w+)\.dir/(?:\S*/)?([\w.]+)\.o$", line.strip()):
        return f": {match[1]}, {match[2]}"
    match = re.search(r"Linking .* (\S+)$", line.strip())
    return f": {match[1]}" if match else ""


def must_build(targets, what="building"):
    log = build(targets, what)
    if log:
        raise Trouble("the build failed:\n" + compiler_words(log))


def options_of(program):
    """What a program in the build folder says of its options."""
    must_build([Path(program).name])
    return subprocess.run([BUILD / program, "--help"], text=True, capture_output=True).stdout


def tell_options(program, *hidden):
    """Prints the options of a program in the build folder, but for those that ./wb chooses."""
    said = options_of(program)
    print(re.sub(rf"^ *--({'|'.join((*hidden, 'out'))}) .*\n", "", said, flags=re.M), end="")
    return 0


def compiler_words(log, most=25):
    """The compiler's errors without command lines, mere warnings and notes on other libraries."""
    aside = r"\[\d+/\d+\]|ninja:|FAILED:|-- |\S.* -o \S|In file included|\S+:\d+:\d+: warning:"
    lines, before, aside_now = [], False, False
    for line in re.sub(rf"{re.escape(str(ROOT))}/|^\.\./", "", log, flags=re.M).split("\n"):
        if re.match(r"\S+:\d+:\d+: note:", line):
            aside_now = before or line.startswith("/")
        elif not line.startswith(" "):  # else it belongs to the line before
            before = aside_now = bool(re.match(aside, line))
        if line and not aside_now:
            lines.append(line)
    return "\n".join(lines[:most] + (["..."] if len(lines) > most else []))
