"""The formulas of the types' pages: the equations that a type's code names, drawn where it is
described. The code names them by number; the chapter's text has them."""
import re
from pathlib import Path

from website import formulas

ROOT = Path(__file__).resolve().parents[2]
NUMBERS = re.compile(r"\bEqs?\. (\d-\d+)")
OPENS = re.compile(r"^(?:template <[^>]*>\s*)?(?:struct|class) (\w+)[^;]*$"
                   r"|^[^\s/#}][^;=]*?\b(\w+)::~?\w+\(")
MOST = 6  # equations of a page; the chapter has the others


def equations(pages):
    """{3-4: its TeX} of all pages."""
    found = {}
    for text in pages.values():
        for piece in formulas.PIECES.finditer(text):
            if number := formulas.TAG.search(piece["display"] or ""):
                found[number[1]] = formulas.TAG.sub("", piece["display"])
    return found


def named():
    """{Axis: the numbers of the equations in its functions and comments, in their order}."""
    found = {}
    for path in [*sorted(ROOT.glob("chapters/*/*.h")), *sorted(ROOT.glob("solutions/*/*.cpp"))]:
        owner, before = None, []
        for line in path.read_text(encoding="utf-8").split("\n"):
            if opens := OPENS.match(line):
                owner = opens[1] or opens[2]
                found.setdefault(owner, []).extend(before)
            elif line.startswith("}"):
                owner = None
            numbers = NUMBERS.findall(line)
            if not line.startswith("template"):
                before = before + numbers if line.startswith("///") else []
            if owner:
                found.setdefault(owner, []).extend(numbers)
    return {owner: list(dict.fromkeys(numbers)) for owner, numbers in found.items() if numbers}


def with_formulas(pages):
    """The pages, those of types with the equations of their code behind their first paragraph."""
    tex, made = equations(pages), dict(pages)
    for owner, numbers in named().items():
        shown = "".join(f'<div class="of"><span>Eq. {number}</span><p class="formulaDsp">'
                        f"\\[{tex[number]}\\]</p></div>"
                        for number in numbers[:MOST] if number in tex)
        for page in (f"structjoints_1_1{owner}.html", f"classjoints_1_1{owner}.html"):
            if page in pages:
                made[page] = re.sub(r'(<a name="details"[^>]*>.*?<div class="textblock">.*?</p>)',
                                    lambda at: f'{at[1]}<div class="equations">{shown}</div>',
                                    pages[page], count=1, flags=re.S)
    return made
