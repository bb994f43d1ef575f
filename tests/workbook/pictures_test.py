"""The pictures of the texts are as their scripts draw them today: pictures_test.py ROOT BUILD"""
import io
import sys
from xml.dom import minidom

from proofs import house, main, read, would_change

import files
from keep import values
from website import gallery

MOST_BYTES = 60_000  # of a result: it is read on a code host, over a network
MOST_MOVING = 160_000  # of the picture that moves
MOST_LINES = 400  # of a drawing: one for each of its groups, where matplotlib writes thousands
WORDS = ("text", "style", "script", "title", "desc")  # in which blank text counts
SAMPLE = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg"
     viewBox="0 0 9 9">
  <style>
    .a > .b { fill:
      none }
  </style>
  <style> <![CDATA[ .c { content: "</style> <g id='x'>" } ]]> </style>
  <!-- a  comment with <g id="y"> and
       two lines -->
  <title/>
  <g id="a"
     class='b > "c"'>
    <text x="1"> two  words <tspan> </tspan>
      <tspan>and a line</tspan> </text>
    <path d="M 0 0
L 1   1
" transform="scale(2)
 rotate(3)"/>
  </g>
</svg>
"""


def pictures_are_what_their_scripts_draw(root, build):
    """every drawing and result is, byte for byte, as its script draws it from the measurements"""
    yield from would_change("pictures", root, build)


def results_are_shown_and_small(root, build):
    """the text of every chapter shows its result, the README moves, and both are small"""
    if not 0 < len(read(root / "plots/moving.svg")) <= MOST_MOVING:
        yield f"plots/moving.svg must be there, with at most {MOST_MOVING} bytes"
    for chapter in house.chapters():
        kept = chapter.text.parent / "result.svg"
        if "](result.svg)" not in read(chapter.text):
            yield f"{chapter.folder}/README.md does not show result.svg"
        if len(read(kept)) > MOST_BYTES:
            yield f"{kept.relative_to(root)} has {len(read(kept))} bytes: at most {MOST_BYTES}"


def tree(node, words=False):
    """All that an SVG means to a parser: tags, attributes, comments, and words as they stand."""
    words |= node.nodeName in WORDS
    inside = [child for child in node.childNodes
              if words or child.nodeName != "#text" or child.data.strip()]
    return (node.nodeName, node.nodeValue, sorted((node.attributes or {}).items()),
            [tree(child, words) for child in inside])


def drawings_are_compact(root, build):
    """a drawing on few lines means the same to a parser, and every kept one is on few lines"""
    import matplotlib.pyplot as plt
    made, ax = plt.subplots()
    ax.plot([1, 2, 3], label="a < b & $c^2$")
    ax.pcolormesh([[1, 2], [3, 4]])
    ax.legend()
    drawn = io.StringIO()
    made.savefig(drawn, format="svg")
    for name, text in (("the sample", SAMPLE), ("a figure", drawn.getvalue())):
        if tree(minidom.parseString(files.compact(text))) != tree(minidom.parseString(text)):
            yield f"{name} has another tree when it is compact"
    for path in house.files(root, ".svg"):
        text, name = read(path), path.relative_to(root)
        if files.compact(text) != text:
            yield f"{name} is not compact: ./wb keep pictures"
        if text.count("\n") > MOST_LINES:
            yield f"{name} has {text.count(chr(10))} lines: at most {MOST_LINES}"


def recordings_stand_in_the_gallery(root, build):
    """every motion that a chapter's program records has a row in docs/gallery.md, and back"""
    tables, recorded = values.Tables(root, build), set()
    for chapter in house.chapters():
        recorded |= {(chapter.folder, path.name.removesuffix(".motion.json"))
                     for path in tables.run(chapter.number, "")[0].glob("*.motion.json")}
    try:
        gallery.check_rows(gallery.read_rows(read(root / gallery.PAGE)), recorded)
    except gallery.GalleryError as error:
        yield str(error)


PROOFS = [pictures_are_what_their_scripts_draw, drawings_are_compact, results_are_shown_and_small,
          recordings_stand_in_the_gallery]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
