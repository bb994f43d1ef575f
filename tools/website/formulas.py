"""Formulas of the site's pages as drawings, made when the site is built: nothing moves when a page
is opened. docs/tex.js draws them with the MathJax of the system, in node.
"""
import json
import re
import subprocess
from html import escape, unescape
from pathlib import Path

ROOT = Path(__file__).absolute().parents[2]
MATHJAX = Path("/usr/share/javascript/mathjax")
PIECES = re.compile(
    r"(?P<code><code\b.*?</code>|<pre\b.*?</pre>|<script\b.*?</script>|<title>.*?</title>"
    r'|<div class="line">.*?</div>)'
    r'|<p class="formulaDsp">\s*\\\[(?P<display>.+?)\\\]\s*</p>|\\\((?P<inline>.+?)\\\)', re.S)
TAG = re.compile(r"\s*\\tag\{([\w-]+)\}")
MATHJAX_LINE = re.compile(r'<script type="text/x-mathjax-config">.*?</script>\s*'
                          r'|<script type="text/javascript" async="async" src="mathjax/'
                          r'.*?</script>\s*',
                          re.S)

LONG = 36  # [ex]; a longer one in a line scrolls by itself where the window is narrow


class FormulaError(Exception):
    """A formula that cannot be drawn, in words."""


def read(text):
    """All formulas of a page, as (TeX without its number, display?)."""
    for piece in PIECES.finditer(text):
        if tex := piece["display"] or piece["inline"]:
            yield plain(tex), bool(piece["display"])


def plain(tex):
    return TAG.sub("", unescape(tex)).strip()


def drawn(formulas):
    """(drawings, glyphs): an <svg> for each, and the letters that they refer to by name."""
    result = subprocess.run(["node", ROOT / "docs" / "tex.js", MATHJAX], text=True,
                            input=json.dumps(formulas), capture_output=True)
    if result.returncode or not result.stdout:
        raise FormulaError(result.stderr.strip()[-600:] or "docs/tex.js said nothing")
    answer = json.loads(result.stdout)
    wrong = [drawing["error"] for drawing in answer["drawings"] if isinstance(drawing, dict)]
    if wrong:
        raise FormulaError("; ".join(wrong[:5]))
    return dict(zip(formulas, map(tidy, answer["drawings"]))), answer["glyphs"]


def tidy(svg):
    """A drawing in fewer letters."""
    svg = re.sub(r'; max-width: \w+|xmlns:xlink="[^"]*" |role="img" |focusable="false" '
                 r'| x="0"(?=[ >])| y="0"(?=[ >])', "", svg)
    return re.sub(r"<(use|path|rect)([^>]*)></\1>", r"<\1\2/>", svg)


def element(piece, drawings):
    """The formula on the page: its drawing, its TeX for those who listen, its number."""
    if piece["code"]:
        return piece[0]
    tex, display = plain(piece["display"] or piece["inline"]), bool(piece["display"])
    words = f'role="img" aria-label="{escape(tex)}"'
    if not display:
        drawing = drawings[tex, False]
        wide = float(re.search(r'width="([\d.]+)ex"', drawing)[1]) > LONG
        return f'<span class="tex{" long" if wide else ""}" {words}>{drawing}</span>'
    number = TAG.search(unescape(piece["display"]))
    place = f' id="eq-{number[1]}"' if number else ""
    label = f'<span class="number">({number[1]})</span>' if number else ""
    return (f'<div class="display"{place}><div class="tex" {words}>{drawings[tex, True]}</div>'
            f"{label}</div>")


def draw(texts, html):
    """Draws the formulas of these pages, {page: text}, in the folder `html`."""
    formulas = sorted({one for text in texts.values() for one in read(text)})
    drawings, glyphs = drawn(formulas)
    short = {name: f"g{k}" for k, name in enumerate(glyphs)}
    glyphs = {name: path.replace(f'"{name}"', f'"{short[name]}"') for name, path in glyphs.items()}
    drawings = {formula: re.sub(r'href="#(MJ[\w-]+)"', lambda at: f'href="#{short[at[1]]}"', svg)
                for formula, svg in drawings.items()}
    write_glyphs(html / "glyphs.js", glyphs)
    return {page: finish(text, drawings) for page, text in texts.items()}


def finish(text, drawings):
    made = PIECES.sub(lambda piece: element(piece, drawings), MATHJAX_LINE.sub("", text))
    return made.replace("<body>", '<body><script src="glyphs.js"></script>', 1)


def write_glyphs(file, glyphs):
    """The letters of all pages' formulas, in one script: a page takes it before it is painted."""
    store = f'<svg class="glyphs" aria-hidden="true"><defs>{"".join(glyphs.values())}</defs></svg>'
    file.write_text(f"document.body.insertAdjacentHTML('afterbegin', {json.dumps(store)});\n",
                    encoding="utf-8")
