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


def direct(pairs):
    """Without those that lead there by way of another group as well."""
    groups = {group for pair in pairs for group in pair}
    return {(a, c) for a, c in pairs
            if not any((a, b) in pairs and (b, c) in pairs for b in groups - {a, c})}


def arrows(root):
    """The arrows that docs/architecture.svg has to show, as words."""
    return {f"{user} includes {used}" for user, used in direct(includes(root))}
