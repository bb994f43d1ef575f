#!/usr/bin/env python3
"""The page of all recorded motions: docs/gallery.md with a picture and a link for every row.

docs/gallery.md is the one place where a motion's sentence stands. The recordings say which rows
there must be: a recording without a row is an error, and a row without a recording, too.

As Doxygen's filter of that page (docs/Doxyfile): gallery.py docs/gallery.md, from the root of the
repository. Tables become empty places for tools/website/docs.py to fill; the rest goes through
docs/math_filter.py.
"""
import re
import sys
from dataclasses import dataclass
from html import escape
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from pictures import motion, pages, poster  # noqa: E402

ROOT = Path(__file__).absolute().parents[2]
PAGE = "docs/gallery.md"
FOLDER = re.compile(r"\]\(\.\./chapters/(\w+)/README\.md\)")
TABLE = re.compile(r"^\|[^\n]*\|\n\|[-| ]+\|\n(?P<rows>(?:\|[^\n]*\|\n)*)", re.M)
SLOT = '<div class="gallery" id="gallery_{}"></div>'


class GalleryError(Exception):
    """The mistake and its remedy, in one line."""


@dataclass
class Row:
    """One motion: its moments [s] (none: the picture chooses) and what there is to watch."""
    folder: str
    name: str
    moments: list
    sentence: str


def tables(text):
    """The tables of the page: (match, the chapter's folder that was last linked before it)."""
    for table in TABLE.finditer(text):
        before = FOLDER.findall(text[:table.start()])
        if not before:
            raise GalleryError(f"{PAGE}: a table comes before the first link to a chapter's text")
        yield table, before[-1]


def read_rows(text):
    """All rows of the page, in its order."""
    rows = []
    for table, folder in tables(text):
        for line in table["rows"].splitlines():
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            try:
                name, moments, sentence = cells
                row = Row(folder, name, [float(t) for t in moments.split()], sentence)
            except ValueError:
                raise GalleryError(f"{PAGE}: {line}: a row is | name | moments in seconds, or "
                                   "none | what to watch |") from None
            if not sentence:
                raise GalleryError(f"{PAGE} says nothing of {folder}/{name}: write one sentence "
                                   "on what to watch")
            if any((row.folder, row.name) == (other.folder, other.name) for other in rows):
                raise GalleryError(f"{PAGE} has two rows for {folder}/{name}: take one out")
            rows.append(row)
    return rows


def check_rows(rows, recorded):
    """Rows and recordings (pairs of folder and name) must be the same."""
    there = {(row.folder, row.name) for row in rows}
    for folder, name in sorted(recorded - there):
        raise GalleryError(
            f"{PAGE} says nothing of the recording {folder}/{name}.motion.json: add the row "
            f"| {name} | | one sentence on what to watch | to the table of that chapter")
    for folder, name in sorted(there - recorded):
        raise GalleryError(
            f"{PAGE} has a row for {folder}/{name}, but the chapter's program has recorded no "
            f"{name}.motion.json: take the row out, or call ./wb tour if the recordings are old")


def check_moments(row, run):
    end = (len(run["frames"]) - 1) * run["dt"]
    if any(not 0 <= t <= end + run["dt"] for t in row.moments):
        raise GalleryError(f"{PAGE}: {row.folder}/{row.name} lasts from 0 to {end:.2f} s: "
                           f"{' '.join(map(str, row.moments))} lies outside")


def card(row, picture, folder="motion"):
    """The HTML of one motion, for a page beside the `folder` of the pages that play."""
    words = row.name.replace("_", " ")
    return (f'<figure><a class="recording" href="{folder}/{row.folder}.html?scene={row.name}" '
            f'aria-label="Play: {escape(words)}">{picture}</a>'
            f"<figcaption><b>{escape(words)}</b> {escape(row.sentence)}</figcaption></figure>\n")


def inline(row, recordings):
    """The picture of a motion, for a page of one file."""
    run = motion.read_run(recordings / row.folder / f"{row.name}.motion.json", "the solution")
    check_moments(row, run)
    return poster.picture(run, row.moments)


def image(row):
    """The picture of a motion, of the file that fill() has written."""
    return (f'<img class="poster" loading="lazy" width="{poster.WIDTH}" height="{poster.HEIGHT}" '
            f'alt="" src="posters/{row.folder}-{row.name}.svg">')


def watch(folder):
    """What there is to watch in each motion of a chapter: {name: sentence}."""
    rows = read_rows((ROOT / PAGE).read_text(encoding="utf-8"))
    return {row.name: row.sentence for row in rows if row.folder == folder}


def fill(html, recordings):
    """Writes the playing pages to html/motion and puts the pictures into the gallery's page.

    `recordings` has a folder for every chapter with its *.motion.json.
    """
    rows = read_rows((ROOT / PAGE).read_text(encoding="utf-8"))
    paths = {(path.parent.name, path.name[:-len(".motion.json")]): path
             for path in Path(recordings).glob("*/*.motion.json")}
    if not paths:
        raise GalleryError(f"no recordings in {recordings}: ./wb docs or ./wb tour makes them")
    check_rows(rows, set(paths))
    (html / "posters").mkdir(exist_ok=True)
    for row in rows:
        run = motion.read_run(paths[row.folder, row.name], "the solution")
        check_moments(row, run)
        (html / "posters" / f"{row.folder}-{row.name}.svg").write_text(
            poster.file_text(run, row.moments), encoding="utf-8")
    page = next(page for page in sorted(html.glob("*.html"))
                if 'id="gallery_' in page.read_text(encoding="utf-8"))
    text = page.read_text(encoding="utf-8")
    for folder in dict.fromkeys(row.folder for row in rows):
        cards = "".join(card(row, image(row)) for row in rows if row.folder == folder)
        slot = SLOT.format(folder)
        text = text.replace(slot, slot.replace("></div>", ">\n" + cards + "</div>"))
        number, _, name = folder.partition("_")
        motion.write_page(html / "motion" / f"{folder}.html", f"Chapter {int(number)}: {name}",
                          Path(recordings) / folder, watch=watch(folder),
                          beside=pages.beside(html, "../"),
                          back={"href": f"../chapters_{folder}_README.html"
                                        f"#chapters_{folder}_README-see-it",
                                "textContent": "the chapter"})
    page.write_text(text, encoding="utf-8")


def translate(text):
    """The page for Doxygen: an empty place in place of every table."""
    for table, folder in reversed(list(tables(text))):
        text = (text[:table.start()] + f"\n\\htmlonly[block]\n{SLOT.format(folder)}\n"
                + "\\endhtmlonly\n" + text[table.end():])
    return text


if __name__ == "__main__":
    sys.path.insert(0, str(ROOT / "docs"))
    sys.dont_write_bytecode = True
    import math_filter
    sys.stdout.reconfigure(encoding="utf-8")
    whole = Path(sys.argv[1]).read_text(encoding="utf-8")
    try:
        read_rows(whole)  # before Doxygen does its work
        sys.stdout.write(math_filter.translate(translate(whole), PAGE))
    except GalleryError as error:
        sys.exit(f"gallery: {error}")
