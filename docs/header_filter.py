#!/usr/bin/env python3
"""Doxygen's input filter for *.h: one comment behind several variables is meant for all of them.

    int a = 0, b = 0;  ///< slots    reaches Doxygen, in one line so that line numbers stay, as
    int a = 0; /**< slots */ int b = 0; /**< slots */
Used by docs/Doxyfile; by hand: header_filter.py FILE.
"""
import re
import sys

SEVERAL = re.compile(r"(?P<indent>\s+)(?P<type>[\w:]+(?:<[^;()]*>)?\*?) (?P<names>[^;()]*,[^;()]*);"
                     r"\s*///<(?P<note>.*)\n?")
COMMA = re.compile(r",\s*(?![^{]*\})")  # not one inside braces


def spread(line):
    found = SEVERAL.fullmatch(line)
    names = COMMA.split(found["names"]) if found else []
    if len(names) < 2:
        return line
    return (found["indent"]
            + " ".join(f"{found['type']} {name}; /**<{found['note']} */" for name in names) + "\n")


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        sys.stdout.reconfigure(encoding="utf-8")
        sys.stdout.writelines(map(spread, file))
