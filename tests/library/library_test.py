"""The library serves a program outside: library_test.py ROOT BUILD

Installs BUILD into a folder of its own, copies the consumer beside this file next to it, builds the
copy against the installed files and runs it, once in double and once in float. Nothing that is
compiled may come from ROOT, nothing that is installed may name it, and the program of a hinge may
carry no slider, no weld and no ground, that of a crate on the ground no hinge joint, that of two
shafts no slider either, that of a chain of ball joints none of all these. Exit status 0 when all of
that holds, 1 otherwise, 2 for a bad command line.
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

# Of each program: what it must carry, and what it must not.
OTHERS = r"Line|Slide|RotationLock|Weld|SliderJoint|FixedJoint"
PROGRAMS = {"door": ("Axis::error", rf"{OTHERS}|Corner|GroundContact"),
            "crate": ("Corner::error", rf"{OTHERS}|HingeJoint"),
            "shafts": ("Axis::error", rf"{OTHERS}|Corner|GroundContact"),
            "saved": ("restore", rf"{OTHERS}|Axis|HingeJoint|Corner|GroundContact|Scene")}


class Wrong(Exception):
    """One line that says what does not hold."""


def call(*command):
    """What a command prints; Wrong with all of its words if it fails."""
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        raise Wrong(" ".join(map(str, command)) + f"\n{result.stdout}{result.stderr}")
    return result.stdout


def look_at_installed(root, build, prefix):
    """The installed files name no file of ROOT or BUILD, and include only each other."""
    include = prefix / "include" / "joints"
    for path in sorted(p for p in prefix.rglob("*") if p.suffix in (".h", ".cmake")):
        text = path.read_text()
        if any(re.search(rf"(?<![\w/.]){re.escape(str(place))}/", text) for place in (root, build)):
            raise Wrong(f"{path.relative_to(prefix)} names the folder it was made in")
        for header in re.findall(r'^\s*#include "([^"]+)"', text, re.M):
            if not (include / header).is_file():
                raise Wrong(f"{path.relative_to(prefix)} includes {header}, not installed")
    outside = [p for p in (prefix / "include").rglob("*.h") if include not in p.parents]
    if outside:
        raise Wrong(f"{outside[0]} lies outside include/joints")


def look_at_build(root, area, folder):
    """The compiler was pointed at, and has read, nothing of ROOT but what lies in `area`."""
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        words = re.split(r"\s|(?<=-I)|(?<=-isystem)", entry["command"])
        read = re.findall(r"^    (.+)$", call("ninja", "-C", folder, "-t", "deps"), re.M)
        if not any("joints.h" in name for name in read):
            raise Wrong("ninja -t deps does not say which headers were read")
        for name in words + read:
            path = (folder / name).resolve()
            if path.is_relative_to(root) and not path.is_relative_to(area):
                raise Wrong(f"the program outside uses {path}")


def build_and_run(root, area, prefix, compiler, library):
    """Builds a copy of the programs with one of the two libraries; returns what they say."""
    source, folder = area / f"{library}_source", area / f"{library}_build"
    shutil.copytree(root / "tests" / "library" / "consumer", source)
    lists = source / "CMakeLists.txt"
    lists.write_text(lists.read_text().replace("joints::joints", f"joints::{library}"))
    call("cmake", "-S", source, "-B", folder, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
         f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Release",
         "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
         "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF")
    call("cmake", "--build", folder)
    look_at_build(root, area, folder)
    said = []
    for program, (used, foreign) in PROGRAMS.items():
        symbols = call("nm", "-C", folder / program)
        if f"joints::{used}" not in symbols:
            raise Wrong(f"{program}: nm shows no joints::{used}")
        if found := re.search(rf"joints::({foreign})\b", symbols):
            raise Wrong(f"{program} carries {found[0]}")
        said.append(call(folder / program).strip())
    return said


def main(arguments):
    if len(arguments) != 2 or not all(Path(argument).is_dir() for argument in arguments):
        print(__doc__.split("\n", maxsplit=1)[0], file=sys.stderr)
        return 2
    root, build = (Path(argument).resolve() for argument in arguments)
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$",
                         (build / "CMakeCache.txt").read_text(), re.M)[1]
    area = build / "library_test"
    shutil.rmtree(area, ignore_errors=True)
    area.mkdir()
    prefix = area / "installed"
    try:
        call("cmake", "--install", build, "--prefix", prefix)
        look_at_installed(root, build, prefix)
        page = (root / "docs" / "library.md").read_text()
        for library in ("joints", "joints_float"):
            for said in build_and_run(root, area, prefix, compiler, library):
                print(f"{library}: {said}")
                if said not in page:
                    raise Wrong("docs/library.md says that a program says something else")
    except Wrong as wrong:
        print(wrong, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
