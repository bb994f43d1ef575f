"""The commands with which a reader's file, and nothing else, is compiled elsewhere: as a build
would compile it, and linked with the files there."""
import re
import shlex
import subprocess
from pathlib import Path


def commands(lender, target, name):
    """The commands that make a target from the exercise file of this name alone: compile it, put it
    into a library, link."""
    own = re.compile(rf"/({name}|where)\.cpp'?$| qc \S+_(mine|mixed)\.a | -o \S+_mine ")
    said = subprocess.run(["ninja", "-C", lender, "-t", "commands", target],
                          capture_output=True, text=True, check=True).stdout
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.*)$|\Z",
                         (Path(lender) / "CMakeCache.txt").read_text(), re.M)[1]

    def plain(part):  # without what another launches the compiler by, and quoted in one way
        words = shlex.split(part)
        return shlex.join(words[words.index(compiler) if compiler in words else 0:])
    every = [[plain(part) for part in command.split(" && ") if part != ":"]
             for command in said.splitlines()]
    return " && ".join(command for command in map(" && ".join, every) if own.search(command))


def made(line):
    """What a line of commands makes."""
    return re.findall(r" (?:-o|-MF|qc) (\S+)", line)


def needs(line):
    """The objects, libraries and precompiled headers that the lender must have built."""
    return [path for path in re.findall(r"(?<=\s)(?!/)[\w./]+\.[oa](?=\s|$)", line)
            if path not in made(line)] + [
        f"{path}.gch" for path in re.findall(r"-include '?/[^']*?/(CMakeFiles/[^\s']+)", line)]


def moved(line, lender, build):
    """A line of commands for the new folder: what it does not make itself lies in the lender's."""
    own = made(line)
    for path in own:
        (build / path).parent.mkdir(parents=True, exist_ok=True)

    def where(word):
        there = lender / word[0].replace("_run_mine.dir", "_run.dir")
        known = word[0] not in own and there.is_file()
        return shlex.quote(str(there)) if known else word[0]
    return re.sub(r"(?<=\s)[\w./]+(?=\s|$)", where, line)
