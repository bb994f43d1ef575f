"""The front page of the site: what moves on top, two ways in, a card for each chapter."""
import re
from html import escape

from base import house
from keep import values
from website import gallery

MOVES = {"live.html": "live.html#scene=ragdoll", None: "motion/08_ground.html?scene=ragdoll&play=1"}
ROW = re.compile(r'<tr class="markdownTableRow\w+">\s*(.*?)</tr>', re.S)
CELL = re.compile(r"<td\b[^>]*>(.*?)</td>", re.S)
# The picture of a chapter's card, where it is not the first motion of the chapter.
PICTURES = {1: "bridge", 4: "piston", 5: "ragdoll", 6: "bridge_of_rods", 8: "ragdoll"}


def top(live):
    """What moves, and two ways in."""
    first = house.chapters()[0].page_name
    return (f'<iframe class="live" title="A scene of the engine that moves" '
            f'data-src="{escape(MOVES["live.html" if live else None])}"></iframe>'), (
        f'<p class="ways"><a class="button" href="{first}">Start with chapter 1</a>'
        '<a class="button" href="docs_gallery.html">See all that moves</a></p>')


def card(chapter, row, rows):
    """A chapter: its picture, what you build, what you see, how long it takes."""
    _, name, build, see = CELL.findall(row)
    own = [one for one in rows if one.folder == chapter.folder]
    shown = next((one for one in own if one.name == PICTURES.get(chapter.number)), own[0])
    count, time = len(chapter.ids()), values.hours_of(chapter.number)
    words = re.sub(r"<[^>]+>", "", name).strip()
    return (f'<a class="chapter" href="{chapter.page_name}">'
            f"{gallery.image(shown)}<h3>{chapter.number} {words}</h3>"
            f"<p>You build {re.sub('</?a[^>]*>', '', build).strip()}.</p>"
            f"<p>You see {re.sub('</?a[^>]*>', '', see).strip()}.</p>"
            f"<p class=\"plan\">{count} exercises, about {time:g} hours</p></a>")


def finished(text, rows, live):
    """The front page: the table of the chapters becomes cards."""
    moving, ways = top(live)
    start = text.index("<h2>The chapters</h2>")
    begin = text.index("<table", start)
    end = text.index("</table>", begin) + len("</table>")
    chapters, found = house.chapters(), ROW.findall(text[begin:end])
    if len(found) != len(chapters):
        raise gallery.GalleryError("docs/mainpage.md needs a row for each of the "
                                   f"{len(chapters)} chapters")
    cards = "".join(card(chapter, row, rows) for chapter, row in zip(chapters, found))
    text = text[:begin] + f'<div class="cards">{cards}</div>' + text[end:]
    return re.sub(r'(<div class="textblock">)(\s*<p\b.*?</p>)',
                  lambda at: at[1] + moving + at[2] + ways, text, count=1, flags=re.S)
