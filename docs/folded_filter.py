#!/usr/bin/env python3
"""Doxygen's input filter for hints.md and answers.md: each hint and answer behind a click.

A chapter's hints become the page of its exercises: for each one what the file that the reader edits
says at its place, and its three hints. The rest goes through math_filter.py.
Used by docs/Doxyfile; by hand: folded_filter.py FILE, from the root of the repository.
"""
import os
import re
import sys

sys.dont_write_bytecode = True
import math_filter  # noqa: E402

REGION = re.compile(r"^( *)// begin \[exercise ([\d.]+)\]\n((?: *//[^\n]*\n)*).*?^ *// end",
                    re.S | re.M)
HINTS = {"1": "Hint 1: a nudge", "2": "Hint 2", "3": "Hint 3: nearly the answer"}


def fold(title, body):
    return f"<details><summary>{title}</summary>\n\n{body.strip()}\n\n</details>\n"


def stub(solution, id_):
    """What the reader's file says at the exercise, in all its places."""
    return "\n\n".join(
        "```cpp\n" + re.sub(f"^{indent}", "", task, flags=re.M) + f'todo("{id_}");\n```'
        for indent, id_found, task in REGION.findall(solution) if id_found == id_)


def titles(text):
    """{3.1: what the list of exercises in the chapter's text says it is about}."""
    return dict(re.findall(r"^\* \[(\d+\.\d+)\]\(\S+\) (.*?):(?= |$)", text, re.M))


def hints(text, folder):
    """The page of a chapter's exercises."""
    number, name = int(folder[:2]), folder[3:]
    with open(f"chapters/{folder}/README.md", encoding="utf-8") as file:
        about = titles(file.read())
    with open(f"solutions/{folder}/{name}.cpp", encoding="utf-8") as file:
        solution = file.read()
    out = [f"# Chapter {number}: its exercises, with hints\n",
           f"What stands in `{name}.cpp` at each exercise, and three hints, a small one first. "
           f"The text: [chapter {number}](README.md). In a terminal: `./wb hint {number}.1`.\n"]
    for part in re.split(r"^## ", text, flags=re.M)[1:]:
        id_, _, rest = part.partition("\n")
        out += [f"## {id_}\n", about.get(id_.strip(), "") + "\n",
                stub(solution, id_.strip()) + "\n"]
        out += [fold(HINTS[step], body) for step, body in
                re.findall(r"^### (\d)\n(.*?)(?=^### |\Z)", rest, re.M | re.S)]
    return "\n".join(out)


def answers(text, folder):
    """The page of a chapter's answers."""
    number = int(folder[:2])
    head, *parts = re.split(r"^(?=## \d)", text, flags=re.M)
    head = re.sub(r"^# .*", f"# Chapter {number}: answers", head)
    out = [head, f"The questions stand at the end of [chapter {number}]"
                 f"(../../chapters/{folder}/README.md#questions).\n"]
    for part in parts:
        title, _, body = part.partition("\n")
        out += [re.sub("^## ", "## Question ", title) + "\n", fold("The answer", body)]
    return "\n".join(out)


if __name__ == "__main__":
    name = os.path.relpath(sys.argv[1])
    with open(name, encoding="utf-8") as file:
        whole = (hints if name.endswith("hints.md") else answers)(
            file.read(), os.path.basename(os.path.dirname(name)))
    sys.stdout.reconfigure(encoding="utf-8")
    sys.stdout.write(math_filter.translate(whole, name))
