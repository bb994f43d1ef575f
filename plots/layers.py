"""The includes between the groups of the sources, read from their #include lines."""
import re
from pathlib import Path

FOLDERS = ("engine", "chapters", "joints", "contacts", "direct", "reduced", "comparison", "checker",
           "library", "solutions", "bench", "docs", "tests")


def group_of(path):
    """The group to which a source or an included header belongs."""
    parts = Path(path).parts
    if parts[0] == "engine":
        return parts[1] if len(parts) > 2 else "core"
    if parts[0] == "docs":
        return parts[1]
    return "programs" if "program" in parts else parts[0]


def includes(root):
    """The pairs (group, group that it includes) of the sources as they stand."""
    pairs = set()
    for folder in FOLDERS:
        for path in (root / folder).rglob("*"):
            inside = path.relative_to(root)
            if path.suffix not in (".h", ".cpp") or "answers" in inside.parts:
                continue
            user = group_of(inside)
            for header in re.findall(r'^\s*#include "((?:\w+/)+[\w.]+)"', path.read_text(), re.M):
                pairs.add((user, group_of(header)))
    return {(user, used) for user, used in pairs if user != used}


def levels(root):
    """{group: its level}: one above the highest of all that it includes; the lowest is 0."""
    used = {}
    for user, below in includes(root):
        used.setdefault(user, set()).add(below)
        used.setdefault(below, set())
    found = {}
    while len(found) < len(used):
        free = [name for name in used if name not in found and used[name] <= set(found)]
        if not free:
            raise ValueError("these include each other: " + ", ".join(set(used) - set(found)))
        found |= {name: 1 + max((found[other] for other in used[name]), default=-1)
                  for name in free}
    return found
