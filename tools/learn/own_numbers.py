"""Numbers of one's own, drawn from a name: neighbours in a class cannot copy each other's results.

The options of a chapter's program are drawn around what they are without (`--help` says it), and
three factors for the section Numbers of the text. Whoever types the same name gets the same."""
import hashlib
import random
import re
import unicodedata

from base.talk import folded

# Of the options that every program treats alike: the least and the most, in what they are without.
AROUND = {"iterations": (0.4, 1.6), "beta": (0.6, 1.6), "seconds": (0.6, 1.2)}
FACTORS = ["1/5", "1/4", "1/3", "1/2", "2", "3", "4", "5"]


def drawn(name, chapter, help_):
    """(options, factors of mass, length and time) of a name. `help_` is what the program says of
    its options."""
    plain = " ".join(unicodedata.normalize("NFKC", name).casefold().split())
    seed = hashlib.sha256(f"{plain} {chapter.number}".encode()).digest()
    choose, options = random.Random(seed), []
    for option, usual in re.findall(r"^ *--(\w+) .*\((\d+(?:\.\d+)?)\)$", help_, re.M):
        if option in AROUND:
            least, most = (float(usual) * factor for factor in AROUND[option])
            number = choose.uniform(least, most)
            options += [f"--{option}", f"{number:.3f}" if option == "beta" else f"{number:.0f}"]
    return options, choose.sample(FACTORS, 3)


def tell(name, options, factors):
    mass, length, time = factors
    print(folded(f"numbers of {name}: {' '.join(options)}", hang=2))
    print(folded(f"on paper: those of the section Numbers, with every mass times {mass}, every "
                 f"length times {length} and every time times {time}", hang=2), flush=True)
