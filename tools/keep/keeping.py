"""./wb keep [numbers] [listings] [stubs] [pictures]: brings all that is kept up to date.

Each kind says what would change. The workbook's proofs ask the same: they hold where nothing would.
"""
import os
import re
from dataclasses import dataclass, field
from pathlib import Path

from base import house
from keep import copied, drawn, exported, tabled, tied
from keep.values import Tables, Wrong

MOST_LINES = 6  # of one file that are listed


@dataclass
class Kept:
    """A file: what it should be, what changes, what only a person can mend, what is to be said."""
    path: Path
    text: str = None
    changes: list = field(default_factory=list)  # lines of words
    faults: list = field(default_factory=list)
    notes: list = field(default_factory=list)


def texts(root):
    """Every text, and the chapter that it belongs to (0: none)."""
    for path in house.files(root, ".md"):
        chapter = re.match(r"(?:chapters|solutions)/(\d\d)_", str(path.relative_to(root)))
        yield path, int(chapter[1]) if chapter else 0


def in_texts(root, steps):
    """What steps, (text, chapter) -> (text, changes, faults), make of every text."""
    for path, chapter in texts(root):
        one = Kept(path, path.read_text(encoding="utf-8"))
        for step in steps:
            one.text, changes, faults = step(one.text, chapter)
            one.changes += [f"line {line}: {words}" for line, words in changes]
            one.faults += [f"line {line}: {words}" for line, words in faults]
        yield one


def numbers(root, tables):
    """The numbers of the texts that come from runs: in sentences and in tables."""
    return in_texts(root, [lambda text, chapter: tied.renewed(text, chapter, tables),
                           lambda text, chapter: tabled.renewed(text, chapter, tables)])


def listings(root, tables):
    """The code that texts quote, and the names that the library exports."""
    yield from in_texts(root, [lambda text, _: copied.quoted(text, root)])
    path, text = root / exported.LIST, exported.listed(root)
    new, old = set(text.split()), set(path.read_text().split())
    yield Kept(path, text, [f"new: {name}" for name in sorted(new - old)] +
                           [f"gone: {name}" for name in sorted(old - new)])


def stubs(root, tables):
    """The files that readers edit; what is written in them stays."""
    for chapter in house.chapters():
        mine = chapter.mine_text()
        text = copied.stub(chapter.solution.read_text(encoding="utf-8"), mine)
        stale = ["differs from the stub of its solution"] if text != mine else []
        yield Kept(chapter.mine, text, stale)


def pictures(root, tables):
    """The drawings of the texts."""
    try:
        for path, text, words in drawn.redrawn(root, tables):
            yield Kept(path, text, [words]) if text else Kept(path, notes=[words])
    except Wrong as wrong:
        yield Kept(root / "plots", faults=[str(wrong)])


KINDS = {"numbers": numbers, "listings": listings, "stubs": stubs, "pictures": pictures}


def build():
    """The programs whose tables are asked for."""
    house.must_build([*house.programs(), "live_digits"])


def keep(words):
    """The command."""
    for word in words:
        if word not in KINDS:
            raise house.Trouble(f"keep {word}: it takes {', '.join(KINDS)}, or nothing for all")
    asked = [kind for kind in KINDS if not words or kind in words]
    if {"numbers", "pictures"} & set(asked):
        build()
    tables, changed, faults, notes = Tables(house.ROOT, house.BUILD), 0, 0, {}
    for kind in asked:
        house.progress(f"{kind}")
        for one in KINDS[kind](house.ROOT, tables):
            changed += bool(one.changes)
            faults += len(one.faults)
            for note in one.notes:
                notes.setdefault(note, []).append(house.short(one.path))
            if one.changes:
                one.path.write_text(one.text, encoding="utf-8")
                say(one.path, one.changes)
            say(one.path, [f"{house.bad('mend by hand')}: {fault}" for fault in one.faults])
    house.progress_done()
    for note, paths in notes.items():
        print(f"left as they are, {note}; delete one to have it drawn: {' '.join(paths)}")
    if not changed and not faults:
        print("nothing to change")
    return 1 if faults else 0


def say(path, lines):
    if not lines:
        return
    house.progress_done()
    name = house.short(path) if path.is_relative_to(house.ROOT) else os.fspath(path)
    print(name + "".join(f"\n  {line}" for line in lines[:MOST_LINES])
          + (f"\n  and {len(lines) - MOST_LINES} more" if len(lines) > MOST_LINES else ""),
          flush=True)
