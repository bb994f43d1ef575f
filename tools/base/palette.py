"""The colours of docs/palette.css, by their names, as #rrggbb."""
import re
from pathlib import Path

FILE = Path(__file__).absolute().parents[2] / "docs" / "palette.css"


def read():
    """Every name of the first block, and its colour."""
    block = re.search(r"^:root \{(.*?)^\}", FILE.read_text(encoding="utf-8"), re.M | re.S)[1]
    found = dict(re.findall(r"--([\w-]+): ([^;]+);", block))
    return {name: found[value[6:-1]] if value.startswith("var(--") else value
            for name, value in found.items()}


_colours = read()


def named(name):
    return _colours[name]


def rgb(name):
    """Red, green and blue, each 0 to 255."""
    return tuple(bytes.fromhex(named(name)[1:]))
