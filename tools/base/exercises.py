"""Exercises: the regions of a source file, the stubs made from them, and other bodies put in.

A region opens with `// begin [exercise 2.1]`, then comment lines that state the task, then the
answer, and ends with `// end [exercise 2.1]`. The solution is the source; everything else is made.
"""
import re
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

BEGIN = re.compile(r"^(\s*)// begin \[exercise (\d+\.\d+)\]\s*$")
END = re.compile(r"^\s*// end \[exercise (\d+\.\d+)\]\s*$")


class Broken(Exception):
    """The markers of a file do not make sense."""


@dataclass
class Region:
    """One region: its exercise, and the lines between its markers."""
    id: str
    begin: int  # index of the line after the begin marker
    end: int    # index of the end marker
    indent: str
    lines: list

    def task(self):
        """The leading comment lines: they stay in the stub."""
        kept = []
        for line in self.lines:
            if not line.strip().startswith("//"):
                break
            kept.append(line)
        return kept

    def answer(self):
        return self.lines[len(self.task()):]


def scan(text):
    """(the regions that are whole, what is wrong with the markers: [(line, id, words)])."""
    found, faults, open_at = [], [], None
    lines = text.split("\n")

    def never_ended():
        line, id_, _ = open_at
        faults.append((line, id_, f"the line '// end [exercise {id_}]' is missing after it"))
    for number, line in enumerate(lines):
        if match := BEGIN.match(line):
            if open_at:
                never_ended()
            open_at = (number + 1, match[2], match[1])
        elif match := END.match(line):
            if open_at and open_at[1] == match[1]:
                begin, id_, indent = open_at
                found.append(Region(id_, begin, number, indent, lines[begin:number]))
            else:
                faults.append((number + 1, match[1],
                               f"the line '// begin [exercise {match[1]}]' is missing before it"))
                if open_at:
                    never_ended()
            open_at = None
    if open_at:
        never_ended()
    return found, faults


def regions(text, name="this file"):
    """All regions of a text in their order. Raises Broken where markers do not match."""
    found, faults = scan(text)
    for line, _, words in faults:
        raise Broken(f"{name}:{line}: {words}")
    return found


def replace(text, change):
    """The text with every region's lines replaced by change(region, place), or kept for None.

    `place` counts the regions that share an id, from 1.
    """
    lines = text.split("\n")
    count = {}
    todo = []
    for region in regions(text):
        count[region.id] = count.get(region.id, 0) + 1
        new = change(region, count[region.id])
        if new is not None:
            todo.append((region, new))
    for region, new in reversed(todo):
        lines[region.begin:region.end] = new
    return "\n".join(lines)


def stub(text):
    """The exercise file made from a solution."""
    return replace(text, lambda r, _: r.task() + [f'{r.indent}todo("{r.id}");'])


def is_open(region):
    """True while the region still says todo(...)."""
    return any(re.search(r'\btodo\("', line.split("//")[0]) for line in region.lines)


def fill(mine, solution, ids):
    """The learner's text with the regions of `ids` taken from the solution."""
    answers = {}
    count = {}
    for region in regions(solution):
        count[region.id] = count.get(region.id, 0) + 1
        answers[region.id, count[region.id]] = region.lines
    return replace(mine, lambda r, n: answers.get((r.id, n)) if r.id in ids else None)


def transplant(fresh, mine, but=()):
    """A fresh stub with the learner's regions put into it, apart from those of `but` and those
    whose markers are not as they were."""
    found = {}
    for region in scan(mine)[0]:
        found.setdefault(region.id, []).append(region.lines)
    count = Counter(region.id for region in regions(fresh))
    return replace(fresh, lambda r, n: found[r.id][n - 1] if r.id not in but
                   and len(found.get(r.id, [])) == count[r.id] else None)


def outside(text):
    """The text with every region emptied: what a learner is not asked to change."""
    return replace(text, lambda r, _: [])


def read(path):
    """A text as a learner may have saved it: letters that are not UTF-8 come back as they were."""
    return Path(path).read_text(encoding="utf-8", errors="surrogateescape")


def write(path, text):
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text(text, encoding="utf-8", errors="surrogateescape")


def write_if_new(path, text):
    """Writes a file only when it would change, so that nothing is built again for nothing."""
    path = Path(path)
    if path.exists() and read(path) == text:
        return False
    write(path, text)
    return True


def main(arguments):
    """exercises.py SOLUTION STUB"""
    if len(arguments) != 2:
        print(main.__doc__, file=sys.stderr)
        return 2
    try:
        solution, out = map(Path, arguments)
        out.parent.mkdir(parents=True, exist_ok=True)
        out.write_text(stub(solution.read_text()))
    except (Broken, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
