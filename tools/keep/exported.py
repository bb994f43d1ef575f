"""The names that the library brings into the namespace joints, read from preprocessed headers."""
import re
import subprocess
import textwrap

LIST = "tests/library/names.txt"

TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[A-Za-z_]\w*|\d[\w.\']*|::|\S')
OPENING = {"(": ")", "{": "}", "[": "]"}


def closing(tokens, at):
    """The place behind the bracket that closes the one at a place."""
    depth = 0
    for place in range(at, len(tokens)):
        depth += (tokens[place] in OPENING) - (tokens[place] in OPENING.values())
        if depth == 0:
            return place + 1
    raise ValueError("a bracket is never closed")


def behind_angles(tokens, at):
    """The place behind the template arguments that begin at a place."""
    depth = 0
    while True:
        if tokens[at] in OPENING:
            at = closing(tokens, at)
            continue
        depth += (tokens[at] == "<") - (tokens[at] == ">")
        at += 1
        if depth == 0:
            return at


def bare(tokens):
    """A declaration without template heads, attributes and the like: its own words."""
    out, at = [], 0
    while at < len(tokens):
        word = tokens[at]
        if word == "template" and tokens[at + 1] == "<":
            at = behind_angles(tokens, at + 1)
        elif word in ("alignas", "__attribute__", "decltype", "__declspec"):
            at = closing(tokens, at + 1)
        elif word == "[":
            at = closing(tokens, at)
        elif word == "requires":
            return out
        else:
            out.append(word)
            at += 1
    return out


def name_of(tokens):
    """The name that a declaration declares in its namespace, or None."""
    words = bare(tokens)
    if not words or words[0] in ("using", "concept", "typedef", "struct", "class", "enum", "union"):
        if words and words[0] == "typedef":
            return words[-1]
        names = [word for word in words[1:] if word not in ("class", "struct")]
        return names[0] if names and names[0] != "namespace" else None
    if "operator" in words or words[0] == "static_assert":
        return None
    at = next((k for k, word in enumerate(words) if word in ("=", "(")), len(words))
    if words[at:at + 2] == ["(", "*"]:  # a pointer to a function
        return words[words.index(")", at) - 1]
    if words[at - 1] == ">":  # a specialisation
        return None
    return None if at >= 2 and words[at - 2] == "::" else words[at - 1]


def names(text, namespace="joints"):
    """The names of a namespace in a preprocessed text; a nested one is a name itself."""
    tokens = TOKEN.findall(re.sub(r"^#.*$", "", text, flags=re.M))
    found, at = set(), 0
    while at < len(tokens):
        if tokens[at:at + 3] == ["namespace", namespace, "{"]:
            end = closing(tokens, at + 2) - 1
            found |= inside(tokens[at + 3:end])
            at = end
        at += 1
    return found


def inside(tokens):
    """The names that the declarations of a namespace declare."""
    found, at, begin = set(), 0, 0
    while at < len(tokens):
        if tokens[at] == ";":
            found.add(name_of(tokens[begin:at]))
            begin = at = at + 1
        elif tokens[at] == "{":
            head, end = tokens[begin:at], closing(tokens, at)
            if head[:1] == ["namespace"]:
                found.add(head[1] if len(head) > 1 else None)
                begin = end
            elif (end == len(tokens) or tokens[end] != ";") and "concept" not in head:
                found.add(name_of(head))
                begin = end
            at = end
        elif tokens[at] == "template" and tokens[at + 1] == "<":
            at = behind_angles(tokens, at + 1)
        else:
            at = closing(tokens, at) if tokens[at] in OPENING else at + 1
    return found - {None}


def listed(root):
    """The list of the names that joints.h exports."""
    flags = [flag for flag in (root / "compile_flags.txt").read_text().split() if flag != "-xc++"]
    text = subprocess.run(["c++", *flags, "-DJOINTS_LIBRARY", "-E", "-P", "-x", "c++",
                           "library/joints.h"], cwd=root, check=True, capture_output=True,
                          text=True).stdout
    return textwrap.fill(" ".join(sorted(names(text))), 98) + "\n"
