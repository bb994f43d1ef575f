"""The sources: their includes and lengths: sources_test.py ROOT BUILD"""
import re
import sys

from proofs import beyond, files, house, main, read

import layers


LINES, MOST_COLUMNS, MOST_OF_HINGE = 330, 100, 12  # LINES is an aim


# Which folders a folder may include. The engine's core measures nothing, and knows no other way to
# step, no lanes and nothing that saves it.
BELOW = {"engine": [], "engine/kept": ["engine"], "engine/parts": ["engine"],
         "engine/rotation": ["engine"], "engine/simd": ["engine"],
         "engine/steps": ["engine", "engine/kept", "engine/rotation"],
         "checker": ["engine", "engine/parts"],
         "engine/instruments": ["engine", "engine/kept", "engine/steps"]}


def may_include(path):
    """The folders from which a file may include, by its own place."""
    folder = str(path.parent)
    if folder in BELOW:
        return lambda of: of in (*BELOW[folder], folder)
    chapter = re.match(r"(?:chapters|solutions)/(\d\d)_", str(path))
    last = int(chapter[1]) if chapter else 99
    folders = ["engine"] + [f"chapters/{n:02}_" for n in range(1, last + 1)]
    if not chapter or "program" in path.parts:
        folders += ["joints", "contacts", "direct", "reduced", "comparison"]
    folders += {"bench": ["bench"], "tests": ["bench", "checker", "tests", "docs",
                                              "library/examples"],
                "docs": ["bench", "docs"]}.get(path.parts[0], [])
    return lambda of: of.startswith(tuple(folders))


def layers_hold(root, build):
    """everybody includes only what lies below: engine, chapters in their order, joints, programs"""
    for path in files(root, ".cpp", ".h"):
        name = path.relative_to(root)
        if "examples" in name.parts:  # programs outside
            continue
        allowed = may_include(name)
        for header in re.findall(r'^\s*#include "([^"]+)"', read(path), re.M):
            if header.endswith(".cpp") or not allowed(header.rpartition("/")[0]):
                yield f"{name} must not include {header}"


def a_hinge_stays_light(root, build):
    """a user's hinge includes at most 12 other headers of the workbook, and the core no room"""
    found, ahead = set(), ["joints/hinge_joint.h"]
    while ahead:
        found.add(name := ahead.pop())
        ahead += set(re.findall(r'^#include "([^"]+)"', read(root / name), re.M)) - found
    if len(found) - 1 > MOST_OF_HINGE:
        yield f"joints/hinge_joint.h includes {len(found) - 1} headers: {', '.join(sorted(found))}"
    for path in (*(root / "engine").glob("*.h"), *(root / "engine").glob("*.cpp")):
        for room in re.findall(r'#include "engine/(\w+)/', read(path)):
            yield f"{path.relative_to(root)} includes engine/{room}: the core knows no room"


def sources_are_short(root, build):
    """no line is longer than 100 columns, no source far longer than the aim of 330 lines"""
    for path in files(root, ".cpp", ".h", ".py"):
        name, lines = str(path.relative_to(root)), read(path).splitlines()
        if path.parent.name == "answers":  # a list, short or long
            continue
        for number, line in enumerate(lines, 1):
            if len(line) > MOST_COLUMNS:
                yield f"{name}:{number} has {len(line)} columns"
        yield from beyond(name, len(lines), LINES, "lines")


def files_have_a_name(root, build):
    """every file says by its name what it is: a kind, or a name that tools look for"""
    for path in house.sources(root):
        if "." not in path.name and path.name not in {"wb", "LICENSE", "Dockerfile", "Doxyfile"}:
            yield f"{path.relative_to(root)}: what is it? Give it an ending, or remove it"


def drawing_is_true(root, build):
    """the drawing of docs/architecture.md has every folder on its level"""
    drawn = set(re.findall(r'id="(\w+ on level \d+)"', read(root / "docs/architecture.svg")))
    levels = {f"{name} on level {level}" for name, level in layers.levels(root).items()}
    for place in sorted(drawn ^ levels):
        yield (f"{place}: " + ("drawn, but not so" if place in drawn else "not drawn")
               + ": ./wb keep pictures")


def colours_stand_once(root, build):
    """every colour but white stands in docs/palette.css, and there alone"""
    colour = re.compile(r"(?<![&\w])#(?!f{3}(?:f{3})?\b)(?:[0-9a-f]{3}){1,2}\b", re.I)
    if not colour.search(read(root / "docs/palette.css")):
        yield "docs/palette.css has no colours"
    for path in files(root, ".py", ".css", ".js", ".html"):
        if path.name != "palette.css":
            for match in colour.finditer(read(path)):
                yield f"{path.relative_to(root)}: {match[0]}"


PROOFS = [layers_hold, a_hinge_stays_light, files_have_a_name, colours_stand_once, drawing_is_true,
          sources_are_short]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
