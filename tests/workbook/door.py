"""A copy of the workbook, as fresh as a reader's, in which tests type commands.

What a reader's file is linked with is taken from a build that is there: only the file itself is
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

CHAPTER = "01_distance"
# What is built in the copy, and where it lies in the build folder.
TARGETS = {f"{CHAPTER}_test_mine": f"tests/{CHAPTER}_test_mine",
           f"{CHAPTER}_run_mine": f"{CHAPTER}_run_mine"}
# The commands that make them from the reader's file: compile it, put it into a library, link.
OWN = re.compile(r"/distance\.cpp$|/where\.cpp$| qc \S+_(mine|mixed)\.a | -o \S+_mine ")


class Door:
    """The copy; it is gone when the `with` ends."""

    def __init__(self, root, build):
        self.source, self.source_build = root, build

    def __enter__(self):
        self.folder = tempfile.TemporaryDirectory(prefix="door_")
        self.root = Path(self.folder.name) / "workbook"
        self.file = self.root / "chapters" / CHAPTER / "distance.cpp"
        self.solution = exercises.read(self.source / "solutions" / CHAPTER / "distance.cpp")
        skip = shutil.ignore_patterns("build", "out", ".git", "__pycache__", "tests", "docs")
        shutil.copytree(self.source, self.root, ignore=skip)
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
                                env=dict(os.environ, WORKBOOK_PYTHON=sys.executable), timeout=60)
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

    # ---- a build folder that links with what is there --------------------------------------------

    def lend_build(self):
        """A build folder in which the reader's file, and nothing else, is compiled."""
        build = self.root / "build"
        build.mkdir()
        (build / "CMakeCache.txt").write_text(f"CMAKE_HOME_DIRECTORY:INTERNAL={self.root}\n")
        lines = ["rule make", "  command = $line", "  description = $out"]
        for target, product in TARGETS.items():
            commands = subprocess.run(["ninja", "-C", self.source_build, "-t", "commands", target],
                                      capture_output=True, text=True, check=True).stdout
            own = [command.removeprefix(": && ").removesuffix(" && :")
                   for command in commands.splitlines() if OWN.search(command)]
            line = self.moved(" && ".join(own)).replace("$", "$$")
            of = "mixed" if "run" in target else "../chapters"
            lines += [f"build {product}: make {of}/{CHAPTER}/distance.cpp", f"  line = {line}"]
            lines += [f"build {target}: phony {product}"] if product != target else []
        (build / "build.ninja").write_text("\n".join(lines) + "\n")
        for folder in re.findall(r"--dependency-file=(\S+)/", "\n".join(lines)):
            (build / folder).mkdir(parents=True, exist_ok=True)  # where a linker writes of itself

    def moved(self, line):
        """A command line for the copy: what it does not make itself lies in the source's build."""
        made = re.findall(r" (?:-o|qc) (\S+)", line)
        for path in made:
            (self.root / "build" / path).parent.mkdir(parents=True, exist_ok=True)

        def where(word):
            there = self.source_build / word[0].replace("_run_mine.dir", "_run.dir")
            return str(there) if word[0] not in made and there.is_file() else word[0]
        line = re.sub(r"(?<=\s)[\w./]+(?=\s|$)", where, line)
        return line.replace(f"{self.source_build}/mixed", f"{self.root}/build/mixed").replace(
            f"-I{self.source}", f"-I{self.root}").replace(
            f"{self.source}/chapters", f"{self.root}/chapters")
