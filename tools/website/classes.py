"""The types' pages: the equations that a type's code names, drawn where it is described (the code
names them by number, the chapter's text has them), how a joint is used, and the list of types."""
import re
from html import escape
from pathlib import Path

from website import formulas

ROOT = Path(__file__).absolute().parents[2]
NUMBERS = re.compile(r"\bEqs?\. (\d+-\d+)")
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


INCLUDES = "<p><code>#include &lt;"  # after the description of a type
LIBRARY = ROOT / "docs" / "library.md"
EXAMPLES = sorted((ROOT / "library" / "examples").iterdir(),
                  key=lambda path: (path.name != "door.cpp", path.name))  # the simplest hinge
CLASS = r"(?:struct|class)joints_1_1(\w+)\.html"
GROUPS = (("use", "To use", "What a program with joints names; the programs of "
           '<a href="docs_library.html">the joints in your own program</a> are made of it.'),
          ("exercises", "From the exercises", "What you write, and what your code is called by."),
          ("inside", "Inside", "What these are made of."))


def group_of(name):
    """In which of GROUPS a type stands, by the file that declares it."""
    used = re.compile(rf"\b{name}\b")
    if any(used.search(path.read_text(encoding="utf-8")) for path in [LIBRARY, *EXAMPLES]):
        return "use"
    declared = re.compile(rf"^(?:struct|class) {name}\b[^;]*$", re.M)
    contracts = (path / f"{path.name[3:]}.h" for path in ROOT.glob("chapters/[0-9]*"))
    return "exercises" if any(declared.search(path.read_text(encoding="utf-8"))
                              for path in contracts) else "inside"


def list_of_types(page):
    """The page of all types, sorted by who needs them; those of the programs' scenes left out."""
    groups = {key: [] for key, _, _ in GROUPS}
    for at, name, words in re.findall(
            r'<a class="el" href="([^"]+)" target="_self">(\w+)</a></td>'
            r'<td class="desc">(.*?)</td>', page, re.S):
        found = re.fullmatch(CLASS, at)
        if found and "chapter" not in found[1] and "_1_1" not in found[1]:
            groups[group_of(name)].append(
                f'<tr><td><a class="el" href="{at}">{name}</a></td><td>{words}</td></tr>')
    body = "".join(f'<h2>{title}</h2><p>{words}</p><table class="doxtable types">'
                   f'{"".join(groups[key])}</table>' for key, title, words in GROUPS)
    return re.sub(r'(<div class="contents">).*?(?=</div><!-- contents -->)',
                  lambda found: f'{found[1]}<div class="textblock">{body}</div>', page,
                  flags=re.S)


def uses():
    """{HingeJoint: (where from, lines)}: how the programs add each joint, the library's first."""
    found = {}
    for path in [*EXAMPLES, *sorted(ROOT.glob("chapters/*/program/*"))]:
        text = path.read_text(encoding="utf-8")
        for use in re.finditer(r"^ *(?:auto&|\w+&) (\w+) =\s*[^;{}]*?\badd<(\w+)>[^;]*;"
                               r"(?:\s*(?=\1\.)[^;{}]*;)*", text, re.M):
            lines = use[0].split("\n")
            indent = len(lines[0]) - len(lines[0].lstrip())
            found.setdefault(use[2], (path, "\n".join(line[indent:] for line in lines)))
    return {**found, "PartJoint": found["BallJoint"]}  # whose page is that of its template


def with_uses(pages):
    """The pages, those of joints with the lines of a program that adds one."""
    made = dict(pages)
    for name, (path, lines) in uses().items():
        page = f"classjoints_1_1{name}.html"
        if page in pages:
            words = ('<a href="docs_library.html">the joints in your own program</a>'
                     if path in EXAMPLES else f"<code>{path.relative_to(ROOT)}</code>")
            shown = "".join(f'<div class="line">{escape(line)}</div>' for line in lines.split("\n"))
            made[page] = pages[page].replace(INCLUDES, (
                f'<p>An example, from {words}:</p><div class="fragment">{shown}</div>'
                + INCLUDES), 1)
    return made
