"""Files of the figures: few colours in a PNG, few letters in an SVG."""
import io
import re

from PIL import Image, PngImagePlugin

# The pieces of an SVG: a comment, a CDATA section, a tag or a declaration, or what is between them.
PIECE = re.compile(r"""<!--.*?-->|<!\[CDATA\[.*?]]>|<(?:"[^"]*"|'[^']*'|[^<>"'])*>|[^<]+""", re.S)
TAG = re.compile(r"<(?!!--|!\[)")
BLANK = re.compile(r"""("[^"]*"|'[^']*')|\s+""")  # a value, or what is blank outside of values
WORDS = re.compile(r"</?(?:text|style|script|title|desc)\b(?!.*/>$)", re.S)
GROUP = re.compile(r'<g id="(?!text)|<svg\b|<!DOCTYPE')


def save_png(made, path):
    """A PNG with as many colours as a figure needs: less than half the size. Its title goes with
    it, for those who show the picture."""
    drawn, words = io.BytesIO(), PngImagePlugin.PngInfo()
    words.add_itxt("Title", " ".join(made._suptitle.get_text().split()) if made._suptitle else "")
    made.savefig(drawn, metadata={"Software": None})
    with Image.open(drawn) as picture:
        picture.convert("RGB").quantize(128, dither=Image.Dither.NONE).save(path, optimize=True,
                                                                         pnginfo=words)


def save_svg(made, path, change=str, **options):
    """An SVG on few lines: the same bytes for the same data. `change` makes it smaller before."""
    drawn = io.StringIO()
    made.savefig(drawn, format="svg", metadata={"Date": None}, **options)
    path.write_text(compact(change(drawn.getvalue())), encoding="utf-8")


def compact(drawn):
    """An SVG with a line for each named group, where matplotlib writes one for every corner of an
    outline: words alone begin no line. A parser reads the same: to it a line break in an attribute
    is a space, and what is blank between tags has no meaning, except where it is part of words or
    of a style sheet."""
    kept, inside = [], 0
    for piece in PIECE.findall(drawn):
        if TAG.match(piece):
            piece = BLANK.sub(lambda at: re.sub(r"\s", " ", at[0]) if at[1] else " ", piece)
            inside += WORDS.match(piece) is not None and (-1 if piece[1] == "/" else 1)
            kept += ["\n", piece] if GROUP.match(piece) and not inside else [piece]
        elif inside or piece.strip():
            kept.append(piece)
    return "".join(kept).lstrip() + "\n"


def small(drawn):
    """An SVG without indentation, with short names of its glyphs and clips and with places to a
    tenth of a point: smaller by a third, and the same for numbers that differ by rounding."""
    glyph = re.compile(r'(?<=")(#?)(DejaVu[\w-]+)(?=")')
    names = list(dict.fromkeys(match[1] for match in glyph.findall(drawn)))
    clips = list(dict.fromkeys(re.findall(r"\bp[0-9a-f]{10}\b", drawn)))
    drawn = re.sub(r"\bp[0-9a-f]{10}\b", lambda match: f"p{clips.index(match[0])}", drawn)
    drawn = glyph.sub(lambda match: f"{match[1]}g{names.index(match[2])}", drawn)
    parts = re.split(r"(scale\([^)]*\))", re.sub(r"^ +| +$|xlink:(?=href)", "", drawn,
                                                     flags=re.M))
    parts[::2] = [re.sub(r"(?<![\w.])\d+\.\d{2,}", lambda number: f"{float(number[0]):.1f}", part)
                  for part in parts[::2]]
    return "".join(parts)
