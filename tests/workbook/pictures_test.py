"""The pictures of the texts are as their scripts draw them today: pictures_test.py ROOT BUILD"""
import sys

from proofs import house, main, read, would_change

from keep import values
from website import gallery

MOST_BYTES = 60_000  # of a result: it is read on a code host, over a network


def pictures_are_what_their_scripts_draw(root, build):
    """every drawing and result is, byte for byte, as its script draws it from the measurements"""
    yield from would_change("pictures", root, build)


def results_are_shown_and_small(root, build):
    """the text of every chapter shows its result, and that is small"""
    for chapter in house.chapters():
        kept = chapter.text.parent / "result.svg"
        if "](result.svg)" not in read(chapter.text):
            yield f"{chapter.folder}/README.md does not show result.svg"
        if len(read(kept)) > MOST_BYTES:
            yield f"{kept.relative_to(root)} has {len(read(kept))} bytes: at most {MOST_BYTES}"


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


PROOFS = [pictures_are_what_their_scripts_draw, results_are_shown_and_small,
          recordings_stand_in_the_gallery]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
