"""Where things are, how they are built, and how wb talks."""
import contextlib
import os
import re
import shutil
import subprocess
import sys
import threading
import time
from dataclasses import dataclass
from pathlib import Path

import exercises

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
OUT = ROOT / "out"


class Trouble(Exception):
    """Something the user can do something about: one line, exit status 2."""


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
    def hints(self):
        return ROOT / "chapters" / self.folder / "hints.md"

    @property
    def text(self):
        return ROOT / "chapters" / self.folder / "README.md"

    def ids(self):
        """The exercises in the order of their numbers."""
        found = {r.id for r in exercises.regions(self.solution.read_text(), self.solution.name)}
        return sorted(found, key=lambda id_: int(id_.split(".")[1]))

    def written(self):
        """The exercises in whose regions of the reader's file no todo is left."""
        regions = exercises.regions(self.mine.read_text(), short(self.mine))
        waiting = {r.id for r in regions if exercises.is_open(r)}
        return [id_ for id_ in self.ids() if id_ not in waiting]

    def titles(self):
        """What each exercise is about, from the table in the chapter's text."""
        found = {}
        for line in self.text.read_text().split("\n") if self.text.exists() else []:
            if match := re.match(r"\|\s*(\d+\.\d+)\s*\|\s*([^|]*?)\s*\|", line):
                found[match[1]] = match[2].replace("`", "")
        return found

    def place(self, id_):
        """file:line of the exercise in the reader's file: its first todo, else where it begins."""
        lines = self.mine.read_text().split("\n")
        for words in (f'todo("{id_}")', f"// begin [exercise {id_}]"):
            for number, line in enumerate(lines, 1):
                if words in line.split("//")[0] or line.strip() == words:
                    return f"{short(self.mine)}:{number}"
        return short(self.mine)


def chapters():
    """All chapters that have a solution, in order."""
    found = []
    for folder in sorted((ROOT / "solutions").iterdir()):
        if match := re.match(r"(\d\d)_(\w+)$", folder.name):
            found.append(Chapter(int(match[1]), folder.name, match[2]))
    return found


def chapter_of(word):
    """The chapter named by "2", "02", "02_ball", "ball" or by an exercise "2.1"."""
    for chapter in chapters():
        if word.split(".")[0].lstrip("0") == str(chapter.number) or word in (
                chapter.folder, chapter.name):
            return chapter
    raise Trouble(f"{word}: no such chapter; there are "
                  + ", ".join(f"{c.number} ({c.name})" for c in chapters()))


def exercise_of(word):
    """The chapter and id of an exercise such as "2.1"."""
    chapter = chapter_of(word)
    if word not in chapter.ids():
        raise Trouble(f"{word}: no such exercise; chapter {chapter.number} has "
                      + " ".join(chapter.ids()))
    return chapter, word


def short(path):
    """A path as seen from the root of the workbook."""
    path = Path(path)
    return str(path.relative_to(ROOT)) if path.is_relative_to(ROOT) else str(path)


# ---- talking -------------------------------------------------------------------------------------

TERMINAL = sys.stdout.isatty()


def coloured(words, code):
    return f"\033[{code}m{words}\033[0m" if TERMINAL and "NO_COLOR" not in os.environ else words


def good(words):
    return coloured(words, "32")


def bad(words):
    return coloured(words, "31")


def faint(words):
    return coloured(words, "2")


def bold(words):
    return coloured(words, "1")


QUIET = 9.0  # a log gets a line of progress at least this often [s], and not much oftener
_said = {"words": "", "at": 0.0}


def progress(words):
    """What is being done: a line that is overwritten by the next. A log gets only some of them."""
    _said["words"] = words
    if TERMINAL:
        width = shutil.get_terminal_size().columns - 1
        sys.stdout.write("\r\033[K" + words[:width])
        sys.stdout.flush()
    elif time.time() - _said["at"] > QUIET / 2:
        say_progress()


def say_progress():
    _said["at"] = time.time()
    sys.stdout.write(f"  {_said['words']}\n")
    sys.stdout.flush()


def progress_done():
    if TERMINAL:
        sys.stdout.write("\r\033[K")
        sys.stdout.flush()


@contextlib.contextmanager
def talking():
    """While it lasts, a log gets a line of progress even where one thing takes long."""
    ended = threading.Event()

    def talk():
        while not ended.wait(1):
            if _said["words"] and time.time() - _said["at"] > QUIET:
                say_progress()
    if not TERMINAL:
        threading.Thread(target=talk, daemon=True).start()
    try:
        yield
    finally:
        ended.set()


def ask(question, yes):
    """True when the user agrees, or said so on the command line."""
    if yes:
        return True
    if not sys.stdin.isatty():
        raise Trouble(f"{question} Nobody is here to ask: add --yes to agree.")
    return input(f"{question} [y/N] ").strip().lower().startswith("y")


# ---- building ------------------------------------------------------------------------------------

def use_build(preset):
    """From now on another preset's folder is built in and run from."""
    global BUILD
    BUILD, _settings["preset"] = ROOT / "build" / preset, preset


_settings = {"preset": "workbook"}


def configure():
    """Runs CMake when the build folder is new or was made for another place."""
    cache = BUILD / "CMakeCache.txt"
    if cache.exists() and (BUILD / "build.ninja").exists():
        if f"CMAKE_HOME_DIRECTORY:INTERNAL={ROOT}\n" in cache.read_text():
            return
        shutil.rmtree(BUILD)  # a copied build folder points at the place it was copied from
    progress("configuring")
    command = ["cmake", "-S", ROOT, "--preset", _settings["preset"],
               f"-DPython3_EXECUTABLE={sys.executable}"]
    if os.environ.get("CI") == "true":
        command.append("-DWORKBOOK_WARNINGS_AS_ERRORS=ON")
    result = subprocess.run(command, capture_output=True, text=True, cwd=ROOT)
    progress_done()
    if result.returncode != 0:
        raise Trouble("CMake failed:\n" + result.stdout[-1500:] + result.stderr[-3000:])


def build(targets, what="building"):
    """Builds targets; returns "" or what the compiler said."""
    configure()
    process = subprocess.Popen(["ninja", "-C", str(BUILD), "-k", "0", *targets],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    log = []
    with talking():
        for line in process.stdout:
            if match := re.match(r"\[(\d+)/(\d+)\] ", line):
                progress(f"{what} {match[1]} of {match[2]}{thing_built(line)}")
            log.append(line)
        process.wait()
    progress_done()
    return "" if process.returncode == 0 else "".join(log)


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


def compiler_words(log, most=25):
    """The compiler's errors without the command lines."""
    lines = [line for line in log.split("\n")
             if line and not re.match(r"\[\d+/\d+\]|ninja:|FAILED:|-- |/\S*c\+\+|\S*g\+\+ ", line)]
    lines = [line.replace(str(ROOT) + "/", "") for line in lines]
    return "\n".join(lines[:most] + (["..."] if len(lines) > most else []))
