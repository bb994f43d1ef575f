"""Files of the figures: few colours in a PNG, few letters in an SVG."""
import io
import re

from PIL import Image, PngImagePlugin


def save_png(made, path):
    """A PNG with as many colours as a figure needs: less than half the size. Its title goes with
    it, for those who show the picture."""
    drawn, words = io.BytesIO(), PngImagePlugin.PngInfo()
    words.add_itxt("Title", " ".join(made._suptitle.get_text().split()) if made._suptitle else "")
    made.savefig(drawn, metadata={"Software": None})
    with Image.open(drawn) as picture:
        picture.convert("RGB").quantize(128, dither=Image.Dither.NONE).save(path, optimize=True,
                                                                         pnginfo=words)


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
