"""What is copied: code that a text quotes, and the files that readers edit, of the solutions.

A quotation stands behind `<!-- from FILE -->`. It begins and ends with lines by which it is found
again: the first one stands once in the file, and the last one closes as many blocks as before.
"""
import re

from base import exercises

QUOTATION = re.compile(r"<!-- from (\S+) -->\n+```\w+\n(.*?)^```$", re.M | re.S)


def quoted(text, root):
    """(the text with its listings as their files have them, [(line, words)] of changes, faults)."""
    changes, faults, new = [], [], []
    for match in QUOTATION.finditer(text):
        line, file = text.count("\n", 0, match.start()) + 1, root / match[1]
        if not file.is_file():
            faults.append((line, f"there is no {match[1]} to quote"))
            continue
        source = file.read_text(encoding="utf-8")
        code = found_again(match[2], source)
        if code is None:
            faults.append((line, f"{match[2].splitlines()[0]} stands not once in {match[1]}"))
        elif code != match[2]:
            changes.append((line, f"the listing of {match[1]}"))
            new.append((match.span(2), code))
    for (begin, end), code in reversed(new):
        text = text[:begin] + code + text[end:]
    if text.count("<!-- from ") != len(QUOTATION.findall(text)):
        faults.append((1, "<!-- from FILE --> stands before no code"))
    return text, changes, faults


def found_again(quotation, source):
    """The lines of a source that a quotation shows, or None."""
    old, lines = quotation.rstrip("\n").split("\n"), source.split("\n")
    indents = {n: line.removesuffix(old[0]) for n, line in enumerate(lines)
               if line.endswith(old[0]) and not line.removesuffix(old[0]).strip()}
    for k, line in enumerate(old):  # as many of its first lines as it takes to find it
        same = {n: indent for n, indent in indents.items()
                if lines[n + k:n + k + 1] == [line and indent + line]}
        indents = same or indents
    if len(indents) != 1:
        return None
    (begin, indent), = indents.items()
    left = old.count(old[-1])
    for end in range(begin, len(lines)):
        left -= lines[end] == indent + old[-1]
        if left == 0:
            return "".join(line.removeprefix(indent) + "\n" for line in lines[begin:end + 1])
    return None


def stub(solution, mine):
    """The file that a reader edits: a fresh stub, with the exercises that are written kept."""
    fresh = exercises.stub(solution)
    empty, written = set(), set()
    for region in exercises.scan(mine)[0]:
        bare = [line.strip() for line in region.answer()] == [f'todo("{region.id}");']
        (empty if bare else written).add(region.id)
    return exercises.transplant(fresh, mine, empty - written)
