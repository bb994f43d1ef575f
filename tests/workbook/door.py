"""A copy of the workbook, as fresh as a reader's, in which tests type commands.

The libraries of a reader's file are taken from a build that is there: only the file itself is
compiled, as that build would compile it.
"""
import os
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from proofs import exercises, house

from classroom import lend

CHAPTER = "01_distance"
# What is built in the copy, and where it lies in the build folder.
TARGETS = {f"{CHAPTER}_test_mine": f"tests/{CHAPTER}_test_mine",
           f"{CHAPTER}_run_mine": f"{CHAPTER}_run_mine",
           f"{CHAPTER}_answer_mine": f"tests/{CHAPTER}_answer_mine"}
# What is taken from the other build as it is.
MADE = {"as_lent": f"{CHAPTER}_run",  # beside which ./wb run puts the reader's
        f"{CHAPTER}_judge": f"tests/{CHAPTER}_judge",
        f"{CHAPTER}_spare": f"tests/CMakeFiles/{CHAPTER}_spare.dir/__/solutions/{CHAPTER}/"
                            "distance.cpp.o"}


def write_build(lender, build, root, makes):
    """Writes the build folder of the workbook at `root`. `makes`: (target, what it makes, the file
    it makes that from, its commands)."""
    build.mkdir(parents=True)
    (build / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={root}\n")
    lines = ["rule make", "  command = $line", "  description = $out"]
    for target, product, file, line in makes:
        line = lend.moved(line, lender, build)
        source = re.sub(r"([ :$])", r"$\1", str(file))
        lines += [f"build {product}: make {source}", f"  line = {line.replace('$', '$$')}"]
        lines += [f"build {target}: phony {product}"] if product != target else []
    (build / "build.ninja").write_text("\n".join(lines) + "\n")
    for folder in re.findall(r"--dependency-file=(\S+)/", "\n".join(lines)):
        (build / folder).mkdir(parents=True, exist_ok=True)  # where a linker writes of itself


class Door:
    """The copy; it is gone when the `with` ends."""
    limit = "1"  # processor time of an exercise's tests [s]: an endless loop is soon found

    def __init__(self, root, build):
        self.source, self.source_build = root, build

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="door_", dir=self.source_build)
        self.root = Path(self.folder.name) / "workbook"
        self.file = self.root / "chapters" / CHAPTER / "distance.cpp"
        self.solution = exercises.read(self.source / "solutions" / CHAPTER / "distance.cpp")
        skip = shutil.ignore_patterns("build", "out", ".git", "__pycache__", "tests", "docs")
        shutil.copytree(self.source, self.root, ignore=skip)
        tests = Path("tests", CHAPTER, "test.cpp")  # ./wb grade counts them
        (self.root / tests).parent.mkdir(parents=True)
        shutil.copy(self.source / tests, self.root / tests)
        (self.root / "docs").mkdir()
        shutil.copy(self.source / "docs" / "palette.css", self.root / "docs")
        for chapter in house.chapters():  # the stubs, whatever somebody has written in the source
            mine = self.root / chapter.mine.relative_to(self.source)
            exercises.write(mine, exercises.stub(exercises.read(chapter.solution)))
        return self

    def __exit__(self, *error):
        self.folder.cleanup()

    def type(self, words, command=None):
        """(exit status, standard output, standard error, processor time [s]) of ./wb with words."""
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        command = command or [sys.executable, "-B", "tools/wb.py"]
        result = subprocess.run([*command, *words.split()], cwd=self.root, capture_output=True,
                                text=True, errors="replace", stdin=subprocess.DEVNULL,
                                env=dict(os.environ, WORKBOOK_PYTHON=sys.executable,
                                         WORKBOOK_LIMIT=self.limit), timeout=1200)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        used = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return result.returncode, result.stdout, result.stderr, used

    # ---- the exercise file -----------------------------------------------------------------------

    def write(self, **answers):
        """A fresh file with these answers: e1_1="return 3;", True for the solution's."""
        ids = {name[1:].replace("_", "."): answer for name, answer in answers.items()}
        text = exercises.fill(exercises.stub(self.solution), self.solution,
                              [id_ for id_, answer in ids.items() if answer is True])
        exercises.write(self.file, exercises.replace(text, lambda region, place: [
            *region.task(), ids[region.id]] if isinstance(ids.get(region.id), str) else None))

    def change(self, old, new, count=1):
        """Puts new in the place of a line or a part of one; it must be there."""
        text = exercises.read(self.file)
        assert old in text, f"{old} is not in {self.file}"
        exercises.write(self.file, text.replace(old, new, count))

    # ---- a build folder that links with an existing build ----------------------------------------

    def lend_build(self, folder="build", targets=TARGETS):
        """A build folder in which the reader's file, and nothing else, is compiled."""
        write_build(self.source_build, self.root / folder, self.root, [
            (target, product, self.root / ("build/mixed" if "run" in target else "chapters")
             / CHAPTER / "distance.cpp",
             self.moved(lend.commands(self.source_build, target, "distance")))
            for target, product in targets.items()])
        with open(self.root / folder / "build.ninja", "a") as lines:
            for name, path in MADE.items():
                if not (self.source_build / path).is_file():
                    continue  # and ./wb grade will miss it
                (self.root / folder / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(self.source_build / path, self.root / folder / path)
                lines.write(f"build {name}: phony {path}\n")

    def moved(self, line):
        """A line of commands for the files of the copy."""
        return line.replace(f"{self.source_build}/mixed", f"{self.root}/build/mixed").replace(
            f"-I{self.source}", f"-I{self.root}").replace(
            f"{self.source}/chapters", f"{self.root}/chapters")
