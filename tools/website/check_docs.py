#!/usr/bin/env python3
"""Looks at the finished site as a reader's browser does: check_docs.py SITE_DIR [REPORT].

SITE_DIR is the folder html that docs.py made, REPORT the page that ./wb tour ends with. Without a
browser: links and pictures of all pages lead somewhere, every formula is drawn, each chapter shows
a figure, a motion and a live scene and has 15 links, pictures are told in a sentence, each page has
its language, its first heading and its main part, each type of rows shows its C, J and K, each
joint's an example, the list of types has three groups, the gallery has a picture for every
recording, and the site is no larger than it may be. In headless Chromium: no page is wider than its
window at 390 pixels, listings stand where the text does, every word can be told from its background
in the light and in the dark, paper shows the text alone, the letters of drawings are large enough,
all searches of in_browser.py find the wanted page among the first three, and every motion plays,
and axe-core finds nothing serious (accessible.py). Where there is no Chromium that is skipped, and
the last line says so.
Exit status: 0 good or skipped, 1 something is wrong, 2 no site there.
"""
import re
import sys
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from website import accessible, browser, in_browser  # noqa: E402
from website.in_browser import chapters_of, scenes_of  # noqa: E402

QUIET = {"script", "style", "pre", "code", "title"}  # a backslash in there is meant to be read
MEGABYTES = 16.0  # of the whole site, with the live page and three.js
LINKS = 15      # of a chapter's text into code and other pages
HINTS = re.compile(r'href="chapters_\w+_hints.html#[\w-]+-\d+"')
TOLD = 44        # letters that tell what a figure shows, at least
class Page(HTMLParser):
    """What a reader sees: the text, and how many formulas are drawn."""

    def __init__(self, html):
        super().__init__()
        self.text, self.formulas, self.drawings, self.open_quiet = "", 0, 0, 0
        self.in_tex = False
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        self.open_quiet += tag in QUIET
        formula = (dict(attributes).get("class") or "").split(" ")[0] == "tex"
        self.formulas += formula
        self.drawings += tag == "svg" and self.in_tex
        self.in_tex = formula

    def handle_endtag(self, tag):
        self.open_quiet -= tag in QUIET

    def handle_data(self, data):
        if not self.open_quiet:
            self.text += data


def bad_formulas(sources):
    """Formulas that are not drawn."""
    for page, html in sources.items():
        seen = Page(html)
        for raw in re.finditer(r"(\\[(\[]|\\f[$\[]|\$\$).{0,60}", seen.text):
            yield f"{page.name}: not drawn: {raw[0]}"
        if seen.formulas != seen.drawings:
            yield f"{page.name}: {seen.formulas} formulas, {seen.drawings} drawn"


def dead_links(site, sources):
    """Links and pictures that lead nowhere, each said once."""
    dead = {}
    places = {page: set(re.findall(r'\b(?:id|name)="([^"]+)"', html))
              for page, html in sources.items()}
    letters = set(re.findall(r'id=\\"(g\d+)', (site / "glyphs.js").read_text()))
    for page, html in sources.items():
        html = re.sub(r'<div class="summary">.*?</div>', "", html, flags=re.S)  # Doxygen's own bar
        for url in set(re.findall(r'\b(?:href|src|data-src)="([^"]+)"', html)):
            file, _, place = unquote(unescape(url)).partition("#")
            file = file.partition("?")[0]
            if file == "live.html":
                place = ""  # the state of the page
            target = (site / file).resolve() if file else page
            if not re.match(r"\w+:", file) and (
                    not target.exists() or (place and place not in letters
                                            and place not in places.get(target, {place}))):
                dead.setdefault(url, []).append(page.name)
    for url, pages in sorted(dead.items()):
        yield f"{pages[0]}{f' and {len(pages) - 1} more' if pages[1:] else ''}: no {url} there"


def experiment_open(body):
    """True if a live scene stands outside all folds."""
    folds = 0
    for mark in re.findall(r'<details|</details>|<div class="experiment"', body):
        folds += {"<details": 1, "</details>": -1}.get(mark, 0)
        if folds == 0 and mark.startswith("<div"):
            return True
    return False


def bad_chapters(sources):
    """Chapters without a figure, a motion, a live scene, a way on, or enough links."""
    for page, html in chapters_of(sources).items():
        body = html[html.index('<div class="textblock">'):]
        links = set(re.findall(r'<a [^>]*href="([\w.-]+\.html[^"]*)"', body))
        for what, there in (("figure", '<figure class="result">' in body),
                            ("motion", '<a class="recording"' in body),
                            ("way on", body.count('rel="next"') == 2),
                            ("exercises with hints", re.search(HINTS, body)),
                            ("live scene beside its sentence, open",
                             "live.html" not in html or experiment_open(body)),
                            (f"{LINKS} links", len(links) >= LINKS)):
            if not there:
                yield f"{page.name}: no {what}"


def bad_reading(sources):
    """Pages that a screen reader or a keyboard cannot find its way in, pictures not told."""
    for page, html in sources.items():
        for what, there in (("language", '<html lang="' in html),
                            ("one main part", html.count("<main ") == 1),
                            ("one title", len(re.findall(r"<h1\b", html)) == 1),
                            ("way past the list of pages", '<body><a id="skip"' in html)):
            if not there:
                yield f"{page.name}: no {what}"
        for image in re.findall(r"<img [^>]*>", html):
            told = re.search(r'alt="([^"]*)"', image)
            if not told or ('src="plots/' in image and len(told[1]) < TOLD):
                yield f"{page.name}: does not tell what is to be seen: {image}"


def bad_types(sources):
    """Types of rows whose pages do not show C, J and K, joints without an example; the list."""
    for page, html in sources.items():
        if re.match(r"class\w+_(Ball|Hinge|Slider|Fixed|Part)Joint\.html|class\w+_GroundContact",
                    page.name) and "An example, from" not in html:
            yield f"{page.name}: no example"
        if page.name == "annotated.html" and (html.count('<table class="doxtable types">') != 3
                                              or "chapter8_1_1" in html):
            yield f"{page.name}: not in three groups, or with scenes of the programs"
        if re.match(r"(struct|class)joints_1_1", page.name) and ">jacobian</a>" in html:
            shown = html.count('<div class="of">')
            if shown < 3:
                yield f"{page.name} shows {shown} equations: name those of C, J and K in its code"


def bad_members(sources):
    """Members without a brief line, other than operators and deleted ones."""
    for page, html in sources.items():
        told = set(re.findall(r'<tr class="memdesc:(\w+)', html))
        for name, row in re.findall(r'<tr class="memitem:(\w+)"[^>]*>(.*?)</tr>', html, re.S):
            if name not in told and "=delete" not in row and "operator" not in row:
                yield f"{page.name}: no brief line: {re.sub('<[^>]+>', '', row)[:80]}"


def bad_gallery(site, sources):
    """What is wrong with the gallery: each motion needs one picture that leads to it."""
    gallery = next(page for page in sources if page.name == "docs_gallery.html")
    shown = {}
    for url, inside in re.findall(r'<a class="recording" href="([^"]+)"[^>]*>(.*?)</a>',
                                  sources[gallery], re.S):
        shown[url] = shown.get(url, 0) + 1
        drawn = (site / re.search(r'src="([^"]+)"', inside)[1]).read_text(encoding="utf-8")
        if not re.search(r"<(path|circle) ", drawn.rpartition("<g ")[2]) or "nan" in drawn:
            yield f"{url} has no picture"
    there = set()
    for page in sorted((site / "motion").glob("*.html")):
        scenes, back = scenes_of(page)
        there |= {f"motion/{page.name}?scene={name}" for name in scenes}
        if not back or not (page.parent / back["href"].partition("#")[0]).is_file():
            yield f"motion/{page.name}: no way back to the chapter"
        for name in [name for name, scene in scenes.items() if not scene["watch"]]:
            yield f"motion/{page.name}: does not say what to watch in {name}"
    if not there:
        yield "there is no motion to play: no motion/*.html"
    for url in sorted(there ^ set(shown)):
        yield f"{url}: " + ("recorded, but not in the gallery" if url in there
                            else "in the gallery, but nothing is recorded")
    for url, times in shown.items():
        if times > 1:
            yield f"{url}: {times} times in the gallery"


def bad_report(page):
    """What is wrong with the report of a tour: three findings first, nothing empty or unmeant."""
    html = page.read_text(encoding="utf-8")
    sections = re.split(r"<h2\b", html[html.index("<body"):])[1:]
    for what, there in (("three findings with pictures, above all else",
                         all("<img " in one for one in sections[:3])),
                        ("error against run time first", "iterations" in sections[0]),
                        ("the machine and the time on top", " s on the clock" in html),
                        ("only settings that fail since they are meant to",
                         "<b>fails</b></td>" not in html),
                        ("tables folded", html.count("<details>") == html.count("<table>"))):
        if not there:
            yield f"{page.name}: not there: {what}"
    for section in sections:
        if "<p>" not in section and "<img " not in section:
            yield f"{page.name}: an empty section: {section[:60]}"
    for image in re.findall(r"<figcaption>(?!<)(.*?)</figcaption>", html):
        if len(image) < TOLD:
            yield f"{page.name}: a caption that is no sentence: {image}"


def too_large(site):
    size = sum(path.stat().st_size for path in site.rglob("*") if path.is_file()) / 1e6
    if size > MEGABYTES:
        yield f"the site has {size:.1f} MB, more than {MEGABYTES}"


def main():
    if not 2 <= len(sys.argv) <= 3 or not Path(sys.argv[1], "index.html").is_file():
        print("check_docs: usage: check_docs.py SITE_DIR [REPORT], a folder with index.html",
              file=sys.stderr)
        return 2
    site, reports = Path(sys.argv[1]).resolve(), [Path(one).resolve() for one in sys.argv[2:]]
    sources = {page: page.read_text(encoding="utf-8") for page in sorted(site.glob("*.html"))
               if page.name != "live.html"}
    bad = [*dead_links(site, sources), *bad_chapters(sources), *bad_types(sources),
           *bad_reading(sources), *bad_gallery(site, sources), *too_large(site),
           *bad_members(sources), *bad_formulas(sources),
           *(line for page in reports for line in bad_report(page))]
    if browser.there():
        lacking = accessible.lacking()
        pages = [*sources, *(page for page in [site / "live.html"] if page.exists()), *reports]
        checked = {} if lacking else accessible.of_today(pages)
        bad += in_browser.bad_in_browser(
            site, sources, pages + sorted((site / "motion").glob("*.html")), checked)
        done = "each in a browser, " + (f"axe-core SKIPPED: {lacking}" if lacking
                                        else f"{len(checked)} by axe-core")
    else:
        done = "widths, search and motions SKIPPED: no chromium here (Debian package: chromium)"
    for line in bad:
        print(f"check_docs: {line}", file=sys.stderr)
    print(f"check_docs: {'FAILED' if bad else 'good'}: {len(sources)} pages, {done}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
