"""Whose exercise files are alike: a hint for whoever grades, no verdict.

Of each file the runs of symbols are compared, with every name as good as another, so that other
names, spaces and comments hide nothing. Code of the solution, or of a third of the class and of
three at least, does not count."""
import re
from collections import Counter

from base import exercises

TOKEN = re.compile(r"[A-Za-z_]\w*|\d[\w.]*|[^\w\s]")
WORDS = {"if", "else", "for", "while", "return", "const", "auto", "int", "real", "vec3", "mat3"}
RUN = 10       # symbols that follow one another
LEAST = 20     # runs that two files share
ALIKE = 0.5    # shared of all
USUAL = "Code of the solution, or of three and a third of the class, does not count."


def runs(text):
    """The runs of symbols in the answers."""
    found = set()
    for region in exercises.scan(text)[0]:
        code = "\n".join(line.split("//")[0] for line in region.lines)
        symbols = [word if word in WORDS or not (word[0].isalnum() or word[0] == "_") else
                   "0" if word[0].isdigit() else "n" for word in TOKEN.findall(code)]
        found |= {(region.id, *symbols[k:k + RUN]) for k in range(len(symbols) - RUN + 1)}
    return found


def pairs(texts, solution):
    """{name: (the name of the file that is most like it, how much)} of {name: text}."""
    all_ = {name: runs(text) - runs(solution) for name, text in texts.items()}
    count = Counter(run for found in all_.values() for run in found)
    usual = {run for run, often in count.items() if often > max(2, len(texts) / 3)}
    all_ = {name: found - usual for name, found in all_.items()}
    best = {}
    for name, mine in all_.items():
        for other, its in all_.items():
            shared = len(mine & its)
            share = shared / (len(mine | its) or 1)
            if other != name and shared >= LEAST and share >= ALIKE and \
                    share > best.get(name, ("", 0))[1]:
                best[name] = other, share
    return best
