#!/usr/bin/env python3
"""Looks at the finished site as a reader's browser does: check_docs.py SITE_DIR.

SITE_DIR is the folder html that docs.py made. Without a browser: links and pictures of all pages
lead somewhere, every formula is drawn, each chapter shows a figure and a motion and has 15 links,
each type of rows shows its C, J and K, the gallery has a picture for every recording, and the site
is no larger than it may be. In headless Chromium: no page is wider than its window at 390 pixels,
the letters of drawings are large enough there, ten words of the texts are found, and every motion
plays. Where there is no Chromium that is skipped, and the last line says so.
Exit status: 0 good or skipped, 1 something is wrong, 2 no site there.
"""
import json
import re
import sys
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from website import browser  # noqa: E402

QUIET = {"script", "style", "pre", "code", "title"}  # a backslash in there is meant to be read
MEGABYTES = 12  # of the whole site, with the live page
LINKS = 15      # of a chapter's text into code and other pages
HINTS = re.compile(r'href="chapters_\w+_hints.html#[\w-]+-\d+"')
TELEPHONE = 390  # [pixels]
# Words, and the chapter whose text must be among what is found.
WORDS = {"baumgarte": "06", "effective mass": "01", "quaternion": "02", "swing twist": "03",
         "piston": "04", "cantilever": "05", "roofline": "07", "restitution": "08", "bricard": "09",
         "erratum": "03"}


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
    glyphs = site / "glyphs.js"
    letters = set(re.findall(r'id=\\"(g\d+)', glyphs.read_text() if glyphs.exists() else ""))
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


def chapters_of(sources):
    return {page: html for page, html in sources.items()
            if re.fullmatch(r"chapters_\w+_README.html", page.name)}


def bad_chapters(sources):
    """Chapters without a figure, a motion, a way on, or enough links."""
    for page, html in chapters_of(sources).items():
        body = html[html.index('<div class="textblock">'):]
        links = set(re.findall(r'<a [^>]*href="([\w.-]+\.html[^"]*)"', body))
        for what, there in (("figure", '<figure class="result">' in body),
                            ("motion", '<a class="recording"' in body),
                            ("way on", body.count('rel="next"') == 2),
                            ("exercises with hints", re.search(HINTS, body)),
                            (f"{LINKS} links", len(links) >= LINKS)):
            if not there:
                yield f"{page.name}: no {what}"


def bad_types(sources):
    """Types of rows whose pages do not show C, J and K."""
    for page, html in sources.items():
        if re.match(r"(struct|class)joints_1_1", page.name) and ">jacobian</a>" in html:
            shown = html.count('<div class="of">')
            if shown < 3:
                yield f"{page.name} shows {shown} equations: name those of C, J and K in its code"


def scenes_of(page):
    """The motions of a playing page, by name: title and what to watch; and its link back."""
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>',
                      page.read_text(encoding="utf-8"), re.S)
    data = json.loads(found[1]) if found else {"scenes": []}
    return {scene["name"]: scene for scene in data["scenes"]}, data.get("back")


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


def too_large(site):
    size = sum(path.stat().st_size for path in site.rglob("*") if path.is_file()) / 1e6
    if size > MEGABYTES:
        yield f"the site has {size:.1f} MB, more than {MEGABYTES}"


def browser_jobs(site, sources):
    """(job, what is wrong with its answer, in words) for all that only a browser can tell."""
    width = "document.readyState === 'complete' && document.documentElement.scrollWidth"
    for page in [*sources, *sorted((site / "motion").glob("*.html"))]:
        yield browser.job(page.as_uri(), width, TELEPHONE, 800), lambda wide, page=page: (
            None if wide and wide <= TELEPHONE else
            f"{page.name}: {wide} pixels wide in {TELEPHONE}")
    letters = ("document.readyState === 'complete' && (all => all.length && all.filter("
               "one => !(parseInt(one.style.getPropertyValue('--wide')) > 0 && "
               "one.firstChild.offsetWidth >= parseInt(one.style.getPropertyValue('--wide')))"
               ").length + ' of ' + all.length)([...document.querySelectorAll('.drawing')])")
    for page in chapters_of(sources):
        yield browser.job(page.as_uri(), letters, TELEPHONE, 800), lambda small, page=page: (
            None if str(small).startswith("0 of ")
            else f"{page.name}: {small} drawings too small for their letters")
    for words, chapter in WORDS.items():
        look = ("(all => all.length && all.map(a => a.getAttribute('href')).join(' '))"
                "([...document.querySelectorAll('#found a')])")
        address = f"{(site / 'index.html').as_uri()}?search={words.replace(' ', '+')}"
        yield browser.job(address, look), lambda found, words=words, chapter=chapter: (
            None if f"chapters_{chapter}_" in str(found)
            else f"searching for {words} does not find chapter {chapter} but {found}")
    for page in sorted((site / "motion").glob("*.html")):
        for name, scene in scenes_of(page)[0].items():
            label = f"{scene['title']}, the solution: a picture that moves"
            look = ("document.querySelector('canvas').getAttribute('aria-label') + "
                    "document.getElementById('frame').textContent + "
                    "(document.querySelector('figure output').value.includes('gap') ? '' "
                    ": ', no readings')")
            yield browser.job(f"{page.as_uri()}?scene={name}&f=1", look), (
                lambda said, page=page, name=name, label=label: None if said == f"{label}frame 1"
                else f"motion/{page.name}: does not play {name}: {said}")


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1], "index.html").is_file():
        print("check_docs: usage: check_docs.py SITE_DIR, a folder with index.html",
              file=sys.stderr)
        return 2
    site = Path(sys.argv[1]).resolve()
    sources = {page: page.read_text(encoding="utf-8") for page in sorted(site.glob("*.html"))
               if page.name != "live.html"}
    bad = [*dead_links(site, sources), *bad_chapters(sources), *bad_types(sources),
           *bad_gallery(site, sources), *too_large(site)]
    if (site / "glyphs.js").exists():
        bad += bad_formulas(sources)
    if browser.there():
        jobs = list(browser_jobs(site, sources))
        answers = browser.ask([job for job, _ in jobs])
        bad += filter(None, (wrong(answer) for (_, wrong), answer in zip(jobs, answers)))
        done = f"{len(jobs)} looks of a browser"
    else:
        done = "widths, search and motions SKIPPED: no chromium here (Debian package: chromium)"
    for line in bad:
        print(f"check_docs: {line}", file=sys.stderr)
    print(f"check_docs: {'FAILED' if bad else 'good'}: {len(sources)} pages, {done}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
