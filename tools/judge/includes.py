"""The headers that an exercise file includes, read off its text."""
import re

# Comments; then texts, so that what stands in them is left out.
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|("(?:\\.|[^"\\\n])*")', re.S)
INCLUDE = re.compile(r'^\s*#\s*include\s*(?:<([^>\n]+)>|"([^"\n]+)"|(\S+))', re.M)
HEADERS = set("""algorithm any array assert.h bit bits/stdc++.h cassert ccomplex cfloat cinttypes
climits cmath compare complex concepts cstddef cstdint cstdio cstdlib cstring deque exception
execution float.h format forward_list functional initializer_list iomanip ios iosfwd iostream
istream iterator limits limits.h list map math.h memory memory_resource new numbers numeric optional
ostream queue random ranges ratio set span sstream stack stdexcept stdint.h stdio.h stdlib.h string
string.h string_view tuple type_traits typeinfo unordered_map unordered_set utility valarray variant
vector version""".split())


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
    """A sentence on the includes that no exercise needs, with their lines."""
    code, found = without_comments(text), {}
    for match in INCLUDE.finditer(code):
        name = match[1] or match[2] or match[3]
        if name not in HEADERS and not re.match(
                r"(engine|chapters|joints|contacts)/[\w/]+\.h$", name):
            found.setdefault(name, []).append(line_of(text, match))
    if not found:
        return []
    said = "; ".join(f"{name} (line {', '.join(map(str, dict.fromkeys(lines)))})"
                     for name, lines in found.items())
    return [f"It includes what no exercise needs: {said}."]


def line_of(text, match):
    """Lines stay where they were without the comments."""
    return text.count("\n", 0, match.end() - 1) + 1
