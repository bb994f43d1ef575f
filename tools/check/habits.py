"""Habits that plain English does without, counted in texts and sources: habits.py [-v: a list]"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import house  # noqa: E402

SUFFIXES = (".md", ".cpp", ".h", ".py")
# The comments and strings of a source.
SPOKEN = re.compile(r'//[^\n]*|#[^\n]*|"""(?:.*?)"""|"(?:[^"\\\n]|\\.)*"', re.S)
ASKED = r"(?!(?:[^.?!]|\.(?! ))*\?)"  # not in a question
HABITS = {
    "rows that want": re.compile(
        r"\b(?:rows?|joints?|limits?|motors?|solvers?|blocks?)(?: that| which)? "
        r"(?:asks?|wants?|says?|knows?|demands?|lacks?)\b", re.I),
    "'what' as a noun": re.compile(
        r"\b(?:of|with|from|to|by|for|in|on|than|is|are|at|and|as|but|all|not|after|before|beside"
        rf"|behind) what\b{ASKED}|(?:^|[.:;] )What\b{ASKED}", re.M),
    "'share' as a noun": re.compile(
        r"\b(?:the|a|an|its|their|this|largest|small|equal|each) shares?\b(?! (?:a|one|no)\b)",
        re.I),
    "'who' without a person": re.compile(rf"(?:^|[.;:,] )[Ww]ho\b{ASKED}", re.M)}


def spoken(path):
    """The words of a file: a text without its code, the comments and strings of a source."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        text = re.sub(r"<!--.*?-->|^```.*?^```$|`[^`\n]*`", "", text, flags=re.S | re.M)
        return re.sub(r"(?<!\n)\n(?!\n)", " ", text)
    text = "\n".join(SPOKEN.findall(text))
    return re.sub(r"\n\s*(?://+|#)?\s*(?=[a-z(])", " ", text)


def found(root):
    """{habit: [(path, its words)]} in the texts and in the sources."""
    out = {habit: [] for habit in HABITS}
    for path in house.files(root, *SUFFIXES):
        words = spoken(path)
        for habit, pattern in HABITS.items():
            for match in pattern.finditer(words):
                around = words[max(0, match.start() - 40):match.end() + 40]
                out[habit].append((path.relative_to(root), " ".join(around.split())))
    return out


def told(habit, places):
    """A habit and its numbers, in a line."""
    texts = sum(path.suffix == ".md" for path, _ in places)
    return f"{habit}: {texts} in texts, {len(places) - texts} in sources"


if __name__ == "__main__":
    for one, hits in found(house.ROOT).items():
        print(told(one, hits))
        for where, line in hits if "-v" in sys.argv else ():
            print(f"    {where}: {line}")
