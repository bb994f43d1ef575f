"""Copies of the workbook in all kinds of folders and on all kinds of machines, from ./wb to a green
exercise: doors_test.py ROOT BUILD

What the reader has not written is taken from the build that is there (borrow.py), so that a copy
costs what it takes to configure and to link.
"""
import contextlib
import os
import pty
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from door import CHAPTER
from proofs import exercises, main, notes

FILE = f"chapters/{CHAPTER}/distance.cpp"
WRONG = """  const vec3 n = direction(body2.x - body1.x);
  return {n, vec3(0), n, vec3(0)};"""
READ = "\"'`#;<>|&$*?^[]{}!"  # by a shell, CMake or Ninja
PLACES = {"spaces, an umlaut and two hundred letters": "Kurs Übung 1 " + "long " * 40,
          "what a shell, CMake and Ninja read": f"Anna's $HOME ${{x}} `id` (b) C#; \"1\" {READ}"}
NOBODY = 65534
HOUR, YEAR = 3600, 365 * 24 * 3600


class Copy:
    """A copy of the workbook in which a reader types."""

    def __init__(self, root, build, place, link=False):
        self.root, self.file = place, place / FILE
        shutil.copytree(root, place, symlinks=True, ignore=shutil.ignore_patterns(
            "build", "out", ".git", "__pycache__"))
        self.solution = exercises.read(root / "solutions" / CHAPTER / "distance.cpp")
        if link:
            self.root = place.with_name("link")
            self.root.symlink_to(place)
        self.write(None)
        self.env = {name: words for name, words in os.environ.items() if name != "CI"} | {
            "WORKBOOK_PYTHON": sys.executable, "TERM": "dumb", "WORKBOOK_LIMIT": "1",
            "XDG_CACHE_HOME": str(place.parent),
            "CMAKE_CXX_COMPILER_LAUNCHER": ";".join(map(str, (
                sys.executable, "-SB", root / "tests/workbook/borrow.py", root, build)))}

    def write(self, *answers):
        """The exercise file with these answers to 1.1, 1.2, ..."""
        given = dict(zip(("1.1", "1.2", "1.3"), answers))
        text = exercises.stub(self.solution)
        exercises.write(self.file, exercises.replace(text, lambda region, place: [
            *region.task(), given[region.id]] if given.get(region.id) else None))

    def right(self):
        exercises.write(self.file, exercises.fill(exercises.stub(self.solution), self.solution,
                                                  ["1.1"]))

    def type(self, words, **more):
        """(exit status, what is said) of ./wb with words."""
        result = subprocess.run(["./wb", *shlex.split(words)], cwd=self.root,
                                stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, errors="replace",
                                timeout=1200, **{"env": self.env, **more})
        return result.returncode, " ".join(result.stdout.split())

    def typed(self, words, status, *expected, hidden=("Traceback", "pkgRedirects"), **more):
        """What is wrong with the answer."""
        code, said = self.type(words, **more)
        if code != status:
            yield f"./wb {words}: exit status {code}, not {status}: {said[-700:]}"
        yield from (f"./wb {words} does not say '{part}' but: {said[-700:]}"
                    for part in expected if part not in said)
        yield from (f"./wb {words} says '{part}': {said[-700:]}" for part in hidden if part in said)

    def first_exercise(self, **more):
        """From ./wb to a green exercise."""
        self.write(None)
        yield from self.typed("", 0, "Next: exercise 1.1", f"edit {FILE}", **more)
        self.write(WRONG)
        yield from self.typed("test 1.1", 1, "the sign of the block v1", f"Where: {FILE}:", **more)
        self.right()
        yield from self.typed("test 1.1", 0, "1.1 CentreDistance::jacobian: done", **more)

    def program(self):
        return self.root / "build" / "tests" / f"{CHAPTER}_test_mine"


@contextlib.contextmanager
def copy(root, build, name="plain", link=False):
    # Not in the folder for temporary files, from which a machine may run nothing.
    with tempfile.TemporaryDirectory(prefix="doors_", dir=build) as folder:
        yield Copy(root, build, Path(folder) / name, link)


def any_path_leads_to_a_green_exercise(root, build):
    """in folders with any letters in their names the first exercise turns green"""
    yield from each_letter_is_seen(root, build)
    for what, name in PLACES.items():
        with copy(root, build, name) as here:
            yield from (f"{what}: {words}" for words in here.first_exercise())
            before = here.program().stat().st_mtime_ns
            yield from (f"{what}: {words}" for words in here.typed("test 1.1", 0, "done"))
            if here.program().stat().st_mtime_ns != before:
                yield f"{what}: the second ./wb test 1.1 builds again what has not changed"
    with copy(root, build, "a\\b") as here:
        yield from here.typed("", 2, "CMake reads \\ as /: rename")


def each_letter_is_seen(root, build):
    """A folder with one of them in its name is worked in through a link that has none."""
    with tempfile.TemporaryDirectory(prefix="doors_", dir=build) as folder:
        for letter in READ:
            place, links = Path(folder, f"a{letter}b"), Path(folder, "links")
            place.mkdir()
            shutil.copy(root / "wb", place)
            for name in ("tools", "CMakeLists.txt"):
                (place / name).symlink_to(root / name)
            subprocess.run([place / "wb", "--version"], stdout=subprocess.DEVNULL, check=True, env={
                **os.environ, "WORKBOOK_PYTHON": sys.executable, "XDG_CACHE_HOME": links})
            if not any(link.samefile(place) for link in links.glob("*")):
                yield f"a folder with {letter} in its name is worked in without a link"


def every_command_works_in_an_odd_place(root, build):
    """by a link to a folder with a space, all that a reader or a teacher types works"""
    with copy(root, build, "Kurs Übung 2", link=True) as here:
        yield from here.first_exercise()
        yield from here.typed("run 1 --seconds 0.2", 0, "your code: 1.1", "tables: out/mine/")
        yield from here.typed("plot 1", 0, "out/plots/01_gap.png")
        yield from here.typed("see 1", 0, "out/see/01_distance.html")
        if shutil.which("wasm-ld") and (build / "live" / "solution.wasm").exists():
            yield from here.typed("live 1", 0, "your 1.1; the solution's 1.2")
        else:
            notes.append("no live page was built here: ./wb live was not typed in an odd place")
        hidden = here.root / "class" / "anna b" / "distance.cpp"
        exercises.write(hidden, exercises.read(here.file))
        yield from here.typed("grade class", 1, "anna b", "done - - - - - 1")
        for words in ("init -q", "add -A"):
            subprocess.run(["git", *words.split()], cwd=here.root, check=True)
        edition = here.root.with_name("an edition")
        yield from here.typed(f"hand-out {shlex.quote(str(edition))}", 0, "without solutions")
        here.root, here.file = edition, edition / FILE
        yield from here.first_exercise()


def contents_decide_not_dates(root, build):
    """a file that comes back from a backup is tested as it is, whatever its date"""
    with copy(root, build) as here:
        for age in (HOUR, -HOUR):
            here.right()
            yield from here.typed("test 1.1", 0, "done")
            other = here.file.with_name("backup")
            other.write_text(exercises.read(here.file).replace("{-n", "{n"))
            os.utime(other, 2 * (time.time() - age,))
            other.replace(here.file)
            yield from (f"a wrong file {age} s old: {words}" for words in here.typed(
                "test 1.1", 1, "the sign of the block v1"))
            yield from here.typed("", 0, "Next: 1.1 is not right yet")
        for age in (YEAR, -YEAR):  # the whole of it, as from an archive or a wrong clock
            for path in here.root.rglob("*"):
                os.utime(path, 2 * (time.time() - age,), follow_symlinks=False)
            shutil.rmtree(here.root / "build")
            yield from here.first_exercise()
            before = here.program().stat().st_mtime_ns
            yield from here.typed("test 1.1", 0, "done")
            if here.program().stat().st_mtime_ns != before:
                yield f"sources {age} s old are built again and again"


def other_machines(root, build):
    """a compiler that speaks German, a dumb terminal, no HOME, strict rights, a full guard: the
    first exercise turns green, or a line says why not"""
    with copy(root, build) as here:
        german = here.root / "g++"
        german.write_text('#!/bin/sh\ncase "$LC_ALL${LANGUAGE:-}" in C | C.UTF-8) exec c++ "$@" ;; '
                          'esac\nc++ "$@" 2>&1 | sed "s/error:/Fehler:/" >&2\nexit 1\n')
        german.chmod(0o755)
        here.env |= {"CXX": str(german), "LC_ALL": "de_DE.UTF-8", "LANGUAGE": "de"}
        here.write("vec3 n; return {n, n, n, body1.mass};")
        yield from here.typed("test 1.1", 1, "Likely mistake: a Body has no mass")
        yield from here.typed("", 0, "1.1 CentreDistance::jacobian broken")
        del here.env["HOME"]
        yield from here.first_exercise(umask=0o077)
        yield from no_escapes(here)
        yield from a_neighbour_does_not_compile(here)
        yield from nothing_can_be_written(here)
    yield from nothing_may_run_in_the_temporary_folder(root, build)


def no_escapes(here):
    """On a terminal that understands none."""
    ours, its = pty.openpty()
    child = subprocess.Popen(["./wb", "test", "1.1"], cwd=here.root, env=here.env, stdout=its,
                             stderr=its, stdin=subprocess.DEVNULL)
    os.close(its)
    said = b""
    with contextlib.suppress(OSError):
        while part := os.read(ours, 1 << 16):
            said += part
    child.wait()
    os.close(ours)
    if b"\033" in said or b"done" not in said:
        yield f"TERM=dumb: ./wb test 1.1 prints {said[-300:]}"


def a_neighbour_does_not_compile(here):
    exercises.write(here.file, exercises.fill(exercises.stub(here.solution), here.solution,
                                              ["1.1", "1.3"]))
    yield from here.typed("", 0, "2 of 6 done")
    text = exercises.read(here.file)
    exercises.write(here.file, text.replace('todo("1.2");', "return nothing;"))
    yield from here.typed("", 0, "1.1 CentreDistance::jacobian done",
                          "1.2 CentreDistance::K broken", "1.3 row_impulse, apply_impulse done")


def nothing_can_be_written(here):
    here.right()
    user = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.getuid() == 0 else {}
    folders = [here.root, *(path for path in here.root.rglob("*") if path.is_dir())]
    for path in [*folders, here.file]:
        path.chmod(0o555)
    for path in here.root.parents:  # down to the copy everybody may go
        if path.stat().st_uid == os.getuid() and not path.stat().st_mode & 0o001:
            path.chmod(path.stat().st_mode | 0o111)
    for words in ("reset 1.1 --yes", "test 1.1", "see 1", ""):
        code, said = here.type(words, **user)
        if "Traceback" in said or "pkgRedirects" in said or code not in (0, 2) or \
                code == 2 and ("cannot be written" not in said or "a copy" not in said):
            yield f"./wb {words}, where nothing can be written: {code}, {said[-500:]}"
    for path in folders:
        path.chmod(0o755)


def nothing_may_run_in_the_temporary_folder(root, build):
    with tempfile.TemporaryDirectory() as folder, copy(root, build) as here:
        if os.getuid() or subprocess.run(["mount", "-t", "tmpfs", "-o", "noexec", "tmpfs", folder],
                                         capture_output=True).returncode:
            notes.append("nothing can be mounted here: TMPDIR was not without programs")
            return
        try:
            here.env["TMPDIR"] = folder
            yield from here.first_exercise()
            exercises.write(here.root / "class" / "anna" / "distance.cpp",
                            exercises.read(here.file))
            yield from here.typed("grade class", 1, "done - - - - - 1")
        finally:
            subprocess.run(["umount", "-l", folder], check=False)


PROOFS = [any_path_leads_to_a_green_exercise, every_command_works_in_an_odd_place,
          contents_decide_not_dates, other_machines]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
