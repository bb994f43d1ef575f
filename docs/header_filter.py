#!/usr/bin/env python3
"""Doxygen's input filter for *.h: says what the headers mean in the way that Doxygen takes it.

One comment behind several variables is meant for all of them:

    int a = 0, b = 0;  ///< slots    becomes    int a = 0; /**< slots */ int b = 0; /**< slots */

A group that opens before the namespace and closes after it is meant for the namespace's contents,
so its marks move inside. A chapter's group is called its code, since the text is the chapter. Line
numbers of warnings stay true for the first, nearly for the second.
Used by docs/Doxyfile; by hand: header_filter.py FILE.
"""
import re
import sys

SEVERAL = re.compile(r"^(?P<indent>[ ]+)(?P<type>[\w:]+(?:<[^;()\n]*>)?\*?) "
                     r"(?P<names>[^;()\n]*,[^;()\n]*);[ ]*///<(?P<note>.*)$", re.M)
CHAPTER = re.compile(r"(\\defgroup chapter\d )C(hapter \d)")
COMMA = re.compile(r",\s*(?![^{]*\})")  # not one inside braces
OPENS = re.compile(r"^(?P<group>/// \\(?:defgroup|addtogroup) .*\n(?:///.*\n)*?/// @\{\n)"
                   r"(?P<namespace>\n?(?:///.*\n)*namespace \w+ \{\n)", re.M)
CLOSES = re.compile(r"^(?P<namespace>\}  // namespace \w+\n)(?P<group>/// @\}\n)", re.M)


def spread(found):
    names = COMMA.split(found["names"])
    if len(names) < 2:
        return found[0]
    return found["indent"] + " ".join(
        f"{found['type']} {name}; /**<{found['note']} */" for name in names)


def translate(text):
    text = CHAPTER.sub(r"\1Code of c\2", text)
    text = OPENS.sub(r"\g<namespace>\g<group>", text)
    text = CLOSES.sub(r"\g<group>\g<namespace>", text)
    return SEVERAL.sub(spread, text)


if __name__ == "__main__":
    with open(sys.argv[1], encoding="utf-8") as file:
        sys.stdout.reconfigure(encoding="utf-8")
        sys.stdout.write(translate(file.read()))
