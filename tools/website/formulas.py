"""Formulas of the site's pages, drawn by KaTeX (docs/tex.js) when the site is built: nothing moves
when a page is opened. Where there is no node the pages take KaTeX along and draw them themselves.
"""
import json
import re
import shutil
import subprocess
from html import escape, unescape
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
KATEX = Path("/usr/share/javascript/katex")
PIECES = re.compile(
    r"(?P<code><code\b.*?</code>|<pre\b.*?</pre>|<script\b.*?</script>|<title>.*?</title>"
    r'|<div class="line">.*?</div>)'
    r'|<p class="formulaDsp">\s*\\\[(?P<display>.+?)\\\]\s*</p>|\\\((?P<inline>.+?)\\\)', re.S)
TAG = re.compile(r"\s*\\tag\{([\w-]+)\}")
MATHJAX = re.compile(r'<script type="text/x-mathjax-config">.*?</script>\s*'
                     r'|<script type="text/javascript" async="async" src="mathjax/.*?</script>\s*',
                     re.S)  # Doxygen leaves formulas alone only for its sake
DRAWS = '<script src="katex/katex.min.js"></script><script src="tex.js"></script>\n'


class FormulaError(Exception):
    """A formula that cannot be drawn, in words."""


def plain(tex):
    return TAG.sub("", unescape(tex)).strip()


def read(text):
    """All formulas of a page, as (TeX without its number, display?)."""
    for piece in PIECES.finditer(text):
        if tex := piece["display"] or piece["inline"]:
            yield plain(tex), bool(piece["display"])


def drawn(formulas, node):
    """{formula: its HTML and MathML}; without node the TeX, for the page to draw."""
    if not node:
        return {formula: escape(formula[0]) for formula in formulas}
    result = subprocess.run([node, ROOT / "docs/tex.js", KATEX / "katex.js"], text=True,
                            input=json.dumps(formulas), capture_output=True)
    if result.returncode:
        raise FormulaError(result.stderr.strip()[-600:])
    return dict(zip(formulas, json.loads(result.stdout)))


def element(piece, drawings):
    """The formula on the page; one with a number is a place to link to."""
    if piece["code"]:
        return piece[0]
    tex, display = plain(piece["display"] or piece["inline"]), bool(piece["display"])
    drawing = drawings[tex, display]
    if not display:
        return f'<span class="tex">{drawing}</span>'
    number = TAG.search(unescape(piece["display"]))
    place = f' id="eq-{number[1]}"' if number else ""
    label = f'<span class="number">({number[1]})</span>' if number else ""
    return f'<div class="display"{place}><div class="tex">{drawing}</div>{label}</div>'


def draw(texts, html):
    """These pages, {page: text}, with drawn formulas, and what they need in the folder `html`."""
    node = shutil.which("node") or shutil.which("nodejs")
    drawings = drawn(sorted({one for text in texts.values() for one in read(text)}), node)
    shutil.copytree(KATEX / "fonts", html / "katex/fonts", dirs_exist_ok=True,
                    ignore=lambda _, names: [one for one in names if not one.endswith(".woff2")])
    shutil.copyfile(KATEX / "katex.min.css", html / "katex/katex.min.css")
    if not node:
        shutil.copyfile(KATEX / "katex.js", html / "katex/katex.min.js")
        shutil.copyfile(ROOT / "docs/tex.js", html / "tex.js")
    return {page: finish(text, drawings, "" if node else DRAWS) for page, text in texts.items()}


def finish(text, drawings, script):
    made = PIECES.sub(lambda piece: element(piece, drawings), MATHJAX.sub("", text))
    return made.replace("</body>", script + "</body>", 1)
