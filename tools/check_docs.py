#!/usr/bin/env python3
"""Looks at the finished site as a reader's browser does: check_docs.py SITE_DIR.

SITE_DIR is the folder html that docs.py made. Doxygen notices bad references but not bad formulas:
every page with formulas is opened in headless Chromium, and each formula must have become a
drawing, none of them an error. Links and pictures of all pages must lead somewhere. The gallery
must have a drawn picture for every recorded motion, and the page behind it must play that motion.
Where there is no Chromium formulas and playing are skipped, and the last line says so.
Exit status: 0 good or skipped, 1 something is wrong, 2 no site there.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

BROWSERS = ("chromium", "chromium-browser", "google-chrome")
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--virtual-time-budget=15000", "--dump-dom"]
FORMULA = re.compile(r"\\\(.+?\\\)|\\\[.+?\\\]", re.S)
QUIET = {"script", "style", "pre", "code", "title"}  # a backslash in there is meant to be read
ERROR = re.compile(r"merror|mjx-error|MathJax_Error|noError", re.I)
RED = re.compile(r"\bred\b|rgb\(204, 0, 0\)|rgb\(255, 0, 0\)|#c00|#f00|#ff0000", re.I)


class Page(HTMLParser):
    """What a reader sees: the text, how many formulas were understood and drawn, and errors."""

    def __init__(self, html):
        super().__init__()
        self.text, self.errors, self.formulas, self.drawings = "", [], 0, 0
        self.open_quiet = 0
        self.message = None  # of an error: the red text of the drawing, then comes the TeX
        self.in_tex = False
        self.feed(html)

    def handle_starttag(self, tag, attributes):
        values = {name: value or "" for name, value in attributes}
        self.open_quiet += tag in QUIET
        self.in_tex = tag == "script" and values.get("type", "").startswith("math/tex")
        self.formulas += self.in_tex
        self.drawings += tag == "svg" and "ex" in values.get("width", "")
        if ERROR.search(tag + " " + values.get("class", "")) or any(
                RED.search(values.get(name, "")) for name in ("fill", "stroke", "color", "style")):
            self.message = self.message or ""

    def handle_endtag(self, tag):
        self.open_quiet -= tag in QUIET

    def handle_data(self, data):
        if self.in_tex and self.message is not None:
            self.errors.append(f"{self.message or 'red'}: {data.strip()}")
            self.message = None
        elif self.message is not None:
            self.message += data.strip()
        elif not self.open_quiet:
            self.text += data


def open_page(browser, address):
    """The page after its scripts have run."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        return subprocess.run([browser, *FLAGS, f"--user-data-dir={profile}", address],
                              capture_output=True, text=True, timeout=120).stdout


def bad_formulas(browser, page, wanted):
    """What is wrong with the formulas of one page, in words."""
    seen = Page(open_page(browser, page.as_uri()))
    for raw in re.finditer(r"(\\[(\[]|\\f[$\[]|\$\$|Math Processing Error).{0,60}", seen.text):
        yield f"{page.name}: not drawn: {raw[0]}"
    for error in seen.errors[:3] + ([f"{len(seen.errors) - 3} more"] if seen.errors[3:] else []):
        yield f"{page.name}: {error}"
    if seen.message is not None:
        yield f"{page.name}: red: {seen.message[:80]}"
    if not wanted == seen.formulas == seen.drawings:
        yield (f"{page.name}: {wanted} formulas, {seen.formulas} understood, "
               f"{seen.drawings} drawn")


def dead_links(site, sources):
    """Links and pictures that lead nowhere, each said once."""
    dead = {}
    places = {page: set(re.findall(r'\b(?:id|name)="([^"]+)"', html))
              for page, html in sources.items()}
    for page, html in sources.items():
        html = re.sub(r'<div class="summary">.*?</div>', "", html, flags=re.S)  # Doxygen's own bar
        for url in set(re.findall(r'\b(?:href|src)="([^"]+)"', html)):
            file, _, place = unquote(unescape(url)).partition("#")
            file = file.partition("?")[0]
            if file == "live.html":
                place = ""  # the state of the page
            target = (site / file).resolve() if file else page
            if not re.match(r"\w+:", file) and (
                    not target.exists() or (place and place not in places.get(target, {place}))):
                dead.setdefault(url, []).append(page.name)
    for url, pages in sorted(dead.items()):
        yield f"{pages[0]}{f' and {len(pages) - 1} more' if pages[1:] else ''}: no {url} there"


def scenes_of(page):
    """The motions of a playing page, name and title, and its link back."""
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>',
                      page.read_text(encoding="utf-8"), re.S)
    data = json.loads(found[1]) if found else {"scenes": []}
    return {scene["name"]: scene["title"] for scene in data["scenes"]}, data.get("back")


def bad_gallery(site, sources):
    """What is wrong with the gallery: each motion needs one picture that leads to it."""
    shown = {}
    for page, html in sources.items():
        for url, inside in re.findall(r'<a class="recording" href="([^"]+)"[^>]*>(.*?)</a>', html,
                                      re.S):
            shown[url] = shown.get(url, 0) + 1
            last = inside.rpartition("<g ")[2]
            if not re.search(r'<svg class="poster" viewBox.*<g .*<(path|circle) ', inside, re.S) \
                    or not re.search(r"<(path|circle) ", last) or "nan" in inside:
                yield f"{page.name}: {url} has no picture"
    there = set()
    for page in sorted((site / "motion").glob("*.html")):
        scenes, back = scenes_of(page)
        there |= {f"motion/{page.name}?scene={name}" for name in scenes}
        if not back or not (page.parent / back["href"].partition("#")[0]).is_file():
            yield f"motion/{page.name}: no way back to the gallery"
    if not there:
        yield "there is no motion to play: no motion/*.html"
    for url in sorted(there ^ set(shown)):
        yield f"{url}: " + ("recorded, but not in the gallery" if url in there
                            else "in the gallery, but nothing is recorded")
    for url, times in shown.items():
        if times > 1:
            yield f"{url}: {times} times in the gallery"


def bad_player(browser, page):
    """A playing page must show each of its motions, at its second frame."""
    scenes = scenes_of(page)[0]
    for name, title in scenes.items():
        seen = open_page(browser, f"{page.as_uri()}?scene={name}&f=1")
        if f"{title}, the solution: a picture that moves" not in unescape(seen) \
                or ">frame 1<" not in seen:
            yield f"motion/{page.name}: does not play {name}"


def main():
    if len(sys.argv) != 2 or not Path(sys.argv[1], "index.html").is_file():
        print("check_docs: usage: check_docs.py SITE_DIR, a folder with index.html",
              file=sys.stderr)
        return 2
    site = Path(sys.argv[1]).resolve()
    sources = {page: page.read_text(encoding="utf-8") for page in sorted(site.glob("*.html"))}
    bad = [*dead_links(site, sources), *bad_gallery(site, sources)]
    players = sorted((site / "motion").glob("*.html"))

    wanted = {page: len(FORMULA.findall(Page(html).text)) for page, html in sources.items()}
    wanted = {page: count for page, count in wanted.items() if count}
    browser = next(filter(None, map(shutil.which, BROWSERS)), None)
    if browser:
        with ThreadPoolExecutor(2) as pool:
            for found in pool.map(lambda page: list(bad_formulas(browser, page, wanted[page])),
                                  wanted):
                bad += found
            for found in pool.map(lambda page: list(bad_player(browser, page)), players):
                bad += found
        motions = sum(len(scenes_of(page)[0]) for page in players)
        done = f"{sum(wanted.values())} formulas on {len(wanted)} pages, {motions} motions play"
    else:
        done = "formulas and motions SKIPPED: there is no chromium here (Debian package: chromium)"
    for line in bad:
        print(f"check_docs: {line}", file=sys.stderr)
    print(f"check_docs: {'FAILED' if bad else 'good'}: {len(sources)} pages, {done}")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
