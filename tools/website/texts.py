"""The chapters' pages of the site: figures and motions where the text names them."""
import re
from html import escape

from base import house, palette
from pictures import figures
from website import gallery

PARAGRAPH = re.compile(r"<p\b[^>]*>(?:(?!</p>).)*?</p>", re.S)
LEAST = 9  # of letters in a drawing [pixels]

RESULT = re.compile(r"\bresult=(?:draw_)?(\w+)")


def figure(stem):
    words = f"Figure {stem}: {figures.title_of(figures.FIGURES / f'{stem}.png')}"
    return (f'<figure class="result"><a href="plots/{stem}.png"><img loading="lazy" '
            f'src="plots/{stem}.png" alt="{escape(words, quote=True)}"></a></figure>')


def width_for_labels(path):
    """How wide a drawing must be [pixels] for its smallest letters to be LEAST high."""
    svg = path.read_text(encoding="utf-8")
    wide = re.search(r'width="([\d.]+)pt"', svg)
    letters = [100 * float(size) for size in re.findall(r"scale\((0\.\d+)", svg)]
    letters = [size for size in letters if size > 3]  # not the glyphs' own units
    return round(LEAST / min(letters) * float(wide[1])) if wide and letters else 0


def with_drawings(text, root):
    """Drawings that on a telephone stay large enough to be read, and scroll. Some lie on a card."""
    def drawing(image):
        wide = width_for_labels(root / image[1])
        card = palette.named("card") in (root / image[1]).read_text(encoding="utf-8")
        kind = "drawing card" if card else "drawing"
        return f'<span class="{kind}" style="--wide: {wide}px">{image[0]}</span>'
    return re.sub(r'<img src="([\w./-]+/[\w.-]+\.svg)"[^>]*>', drawing, text)


def result_of(chapter):
    """The figure that the chapter's text itself shows, as result.svg."""
    script = house.ROOT / "plots" / f"chapter_{chapter.number:02}.py"
    found = RESULT.findall(script.read_text(encoding="utf-8"))
    return f"{chapter.number:02}_{found[-1]}" if found else ""


def with_figures(text, chapter):
    """The chapter's drawn figures, each behind the first paragraph that names it."""
    drawn = [path.stem for path in sorted(figures.FIGURES.glob(f"{chapter.number:02}_*.png"))]
    paragraphs = [(p, re.sub(r"<[^>]+>", "", p[0]).strip()) for p in PARAGRAPH.finditer(text)]
    # Behind the paragraph; before it where its sentence goes on in a table.
    paragraphs = [(p.end() if words.endswith((".", "!", "?", ")")) else p.start(), words)
                  for p, words in paragraphs]
    places = {stem: next((end for end, words in paragraphs
                          if re.search(rf"\b{stem}\b", words)), 0)
              for stem in drawn}
    places.pop(result_of(chapter), None)
    for stem, end in sorted(places.items(), key=lambda one: -one[1]):
        if end:
            text = text[:end] + figure(stem) + text[end:]
    more = "".join(figure(stem) for stem, end in places.items() if not end)
    return text, more


def with_motions(text, chapter, rows, more):
    """The chapter's motions, at the beginning of See it; behind them the figures not named."""
    cards = "".join(gallery.card(row, gallery.image(row)) for row in rows
                    if row.folder == chapter.folder)
    place = re.search(r'id="[\w-]*_README-see-it"></a>\s*See it</h\d>', text)
    if not place:
        raise gallery.GalleryError(f"chapter {chapter.number} has no heading See it")
    end = re.compile(r"(?=<h1>|</div><!-- contents -->)").search(text, place.end()).start()
    return (text[:place.end()] + f'<div class="gallery motions">{cards}</div>'
            + text[place.end():end] + more + text[end:])


def finished(text, chapter, rows):
    """A chapter's page. `rows` are those of the gallery."""
    text, more = with_figures(text, chapter)
    return with_motions(text, chapter, rows, more)
