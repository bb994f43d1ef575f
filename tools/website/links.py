"""Links inside the site's texts: equations, errata, sections of the thesis, names in the code
and files become links when the site is built."""
import re
import xml.etree.ElementTree as xml
from html import unescape
from pathlib import Path

from website import gallery

ROOT = Path(__file__).absolute().parents[2]
TOKEN = re.compile(r"(<[^>]+>)")
CLOSED = ("a", "pre", "svg", "script", "style", "title", "h1", "h2", "h3", "nav", "head",
          "summary")
CLOSED_CLASSES = re.compile(r'class="(?:fragment|tex|toc|title|memproto|memname|display|line)\b')
EQUATIONS = re.compile(r"\bEqs?\.\s\d+-\d+(?:(?:,| and| or| to)\s\d+-\d+)*")
ERRATUM = re.compile(r"\bE\d{1,2}\b")
SECTION = re.compile(r"\bT \d(?:\.\d)*\b")
THESIS = "docs_thesis.html"
ERRATA, KINDS = "docs_errata.html", ("function", "variable", "typedef", "enumeration")


class Targets:
    """Where the links lead."""

    def __init__(self, texts, tags):
        self.equations = {number: f"{page}#eq-{number}" for page, text in texts.items()
                          for number in re.findall(r'id="eq-(\d+-\d+)"', text)}
        notes = re.search(r'id="(docs_errata-notes[^"]*)"', texts[ERRATA])  # a table of them
        self.errata = {f"E{number}": f"{ERRATA}#{notes[1]}" for number in
                       re.findall(r"<td[^>]*>E(\d+)\s*<", texts[ERRATA]) if notes} | {
            f"E{number}": f"{ERRATA}#{place}" for place, number in
            re.findall(r'id="(docs_errata-e(\d+)-[^"]*)"', texts[ERRATA])}
        self.names, self.files = {}, {}
        self.read_tags(xml.fromstring(tags))
        for path in [*ROOT.glob("engine/*.h"), *ROOT.glob("engine/parts/*.h"),
                     *ROOT.glob("engine/rotation/*.h"), *ROOT.glob("checker/*.h"),
                     *ROOT.glob("direct/*.h"), *ROOT.glob("reduced/*.h"),
                     *ROOT.glob("comparison/*.h"),
                     *ROOT.glob("chapters/*/*.h")]:
            if group := re.search(r"\\(?:defgroup|addtogroup) (\w+)", path.read_text()):
                self.files.setdefault(path.name, f"group__{group[1]}.html")
        for path in ROOT.glob("solutions/*/*.cpp"):
            self.files[path.name] = f"chapters_{path.parent.name}_hints.html"

    def read_tags(self, root):
        for compound in root.iter("compound"):
            kind, page = compound.get("kind"), compound.findtext("filename", "")
            name = compound.findtext("name", "").rpartition("joints::")[2]
            if kind in ("class", "struct"):
                self.add(name, page)
            for member in compound.iter("member") if kind in ("class", "struct", "group") else ():
                if member.get("kind") not in KINDS:
                    continue
                at = f"{member.findtext('anchorfile')}#{member.findtext('anchor')}"
                one = member.findtext("name")
                if kind == "group":
                    self.add(one, at)
                else:
                    self.add(f"{name}::{one}", at)
                    if member.get("kind") == "function":
                        self.add(one, at)

    def add(self, name, at):
        self.names.setdefault(name, [])
        if at not in self.names[name]:
            self.names[name].append(at)

    def of_code(self, code, page):
        """Where a piece of code in a text leads: a file, a type, a function; None if unclear."""
        file = code.rpartition("/")[2]
        if file in self.files:
            return self.files[file]
        found = re.match(r"([A-Za-z_]\w*(?:::\w+)*)(?:<\w+>)?(?:[({].*[)}])?$", code, re.S)
        places = self.names.get(found[1], []) if found else []
        own = [at for at in places if at.startswith(f"group__chapter{chapter_number(page)}.")]
        if len(places) > 1 and len(own) != 1:
            own = [at for at in places if "#" not in at][:1]  # a type before its constructors
        if len(places) == 1:
            return places[0]
        return own[0] if own else None


def chapter_number(page):
    found = re.match(r"(?:chapters|solutions)_(\d+)_", page)
    return int(found[1]) if found else 0


def anchor(at, words):
    return f'<a class="ref" href="{at}">{words}</a>'


def in_words(text, page, targets):
    """A piece of plain text with its references linked."""
    def equation(found):
        at = targets.equations.get(found[0])
        if not at:
            raise gallery.GalleryError(f"{page} speaks of Eq. {found[0]}, which does not exist")
        return anchor(at, found[0])

    text = EQUATIONS.sub(lambda all_: re.sub(r"\d+-\d+", equation, all_[0]), text)
    if page == ERRATA:
        return text
    text = ERRATUM.sub(lambda e: anchor(targets.errata[e[0]], e[0])
                       if e[0] in targets.errata else e[0], text)
    return text if page == THESIS else SECTION.sub(lambda t: anchor(THESIS, t[0]), text)


def without(target, text):
    """A page without its links to another one, which is not built: their words stay."""
    link = rf'<a\b[^>]*href="{re.escape(target)}[#"][^>]*>(.*?)</a>'
    return re.sub(link, r"\1", text, flags=re.S)


def linked(text, page, targets):
    """The page with its references linked; headings, listings and links stay as they are."""
    out, closed, code = [], [], None
    for token in TOKEN.split(text):
        if not token.startswith("<"):
            if closed or not token.strip():
                out.append(token)
            elif code is not None:
                at = targets.of_code(unescape(token), page)
                out.append(anchor(at, token) if at and at.partition("#")[0] != page else token)
            else:
                out.append(in_words(token, page, targets))
            continue
        out.append(token)
        name = re.match(r"</?(\w*)", token)[1]
        if token.startswith("</"):
            if closed and closed[-1] == name:
                closed.pop()
            code = None if name == "code" else code
        elif token.endswith("/>") or token.startswith("<!"):
            continue
        elif closed:
            closed += [name] if name == closed[-1] else []
        elif name in CLOSED or (name in ("div", "span", "table", "td")
                                and CLOSED_CLASSES.search(token)):
            closed.append(name)
        elif name == "code":
            code = token
    return "".join(out)
