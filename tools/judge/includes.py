"""The headers that an exercise file includes, read off its text."""
import re

# Comments; then texts, so that what stands in them is left out.
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\\n])*")', re.S)
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:<([^>\n]+)>|"([^"\n]+)"|(\S+))', re.M)


def without_comments(text):
    """The code, line by line as it was."""
    return COMMENT.sub(lambda match: match[1] or "\n" * match[0].count("\n"), text)


def refused(text):
    """Why the file is not compiled at all, in a sentence; "": it is."""
    for match in INCLUDE.finditer(without_comments(text)):
        name = match[1] or match[2] or ""
        if re.search(r"(^|/)(solutions|answers|tests|\.\.)/|^/", name):
            return (f"line {line_of(text, match)} includes {name}, which is no part of an "
                    "exercise: the file was not compiled.")
    return ""


def notes(text):
    """A sentence on includes of a student's own headers, with their lines."""
    left = dict.fromkeys(f"{match[2] or match[3]} (line {line_of(text, match)})"
                         for match in INCLUDE.finditer(without_comments(text)) if not match[1]
                         and not re.match(r"(engine|chapters)/[\w/]+\.h$", match[2] or ""))
    return [f"It includes what no exercise needs: {', '.join(left)}."] if left else []


def line_of(text, match):
    """Lines stay where they were without the comments."""
    return text.count("\n", 0, match.end() - 1) + 1
