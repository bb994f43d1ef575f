"""The course and the live page in a headless Firefox: firefox_test.py ROOT BUILD

What page_test.py looks at in Chromium: faults, the file, without a network, the one-file edition.
Exercise 1.1 by the keyboard alone, wrong, right and moving; one exercise of each other chapter; 390
pixels; a body taken by keys. Skipped, with exit status 77, where there is no Firefox or no
out/course.
"""
import json
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).absolute().parent
sys.path += [str(HERE.parent / folder) for folder in ("workbook", "live")]
from page_test import (PAGE, PATIENCE, RIGHT, WRONG, lacks, nothing_is_lost,  # noqa: E402
                       one_file_is_enough, served, take_in, what_goes_wrong_is_told)
import firefox  # noqa: E402
from proofs import house, main, notes, read  # noqa: E402

from course import packing  # noqa: E402
from website import shell  # noqa: E402

READY = "document.documentElement?.dataset.course === 'ready'"
MOST_TABS = 300


def place_of(id_):
    return f"document.querySelector('[data-exercise=\"{id_}\"]')"


def packed():
    """The chapters that out/course has."""
    folders = packing.manifest()["folders"]
    return [chapter for chapter in house.chapters() if chapter.folder in folders]


def report(here, id_):
    """What the tests say, once they have ended."""
    time.sleep(0.2)
    here.wait(f"!{place_of(id_)}.querySelector('button.check').ariaDisabled", PATIENCE)
    return here.ask(f"{place_of(id_)}.querySelector('.report').textContent")


def tab_to(here, element, back=False):
    """Presses tab, or shift and tab, until an element has the focus; returns how often."""
    for count in range(MOST_TABS):
        if here.ask(f"document.activeElement === {element}"):
            return count
        here.chord(firefox.SHIFT, firefox.TAB) if back else here.keys(firefox.TAB)
    raise TimeoutError(f"{MOST_TABS} tabs do not lead to {element}")


def the_first_exercise_by_keys(root, build):
    """in Firefox 1.1 is written, checked and right by the keyboard alone, and its scene moves"""
    address, server = served()
    editor = f"{place_of('1.1')}.querySelector('.cm-content')"
    with firefox.Firefox() as here:
        here.open(address + PAGE, READY)
        notes.append(f"Firefox: {tab_to(here, editor)} tabs to the first editor")
        for answer, words in ((WRONG, ("1.1  CentreDistance::jacobian: wrong",
                                       "Likely mistake: the sign of the block v1")),
                              (RIGHT, ("done", "6 tests passed."))):
            tab_to(here, editor, back=answer is RIGHT)
            here.chord(firefox.CONTROL, "a")
            here.keys(*answer.replace("\n  ", "\n").strip().replace("\n", firefox.ENTER))
            tab_to(here, f"{place_of('1.1')}.querySelector('button.check')")
            here.keys(firefox.ENTER)
            yield from lacks(report(here, "1.1"), *words)
        frame = f"{place_of('1.1')}.querySelector('.scene iframe')"
        here.wait(f"!!{frame}", PATIENCE)
        here.wait(f"{frame}.contentDocument?.documentElement?.dataset.ready === 'yes'", PATIENCE)
        moving = here.ask(f"{frame}.contentDocument.body.innerText")
        if "yours" not in moving or "stopped" in moving:
            yield f"the scene does not move with the reader's code: {moving[:200]}"
    server.shutdown()


def each_chapter_is_judged(root, build):
    """in Firefox each chapter's first exercise is open, and right once the solution is imported"""
    address, server = served()
    with firefox.Firefox() as here:
        for chapter in packed():
            here.open(address + shell.text_of(chapter), READY)
            about = packing.OUT / "course" / f"chapter_{chapter.number}.json"
            id_, text = chapter.ids()[0], json.dumps(json.loads(read(about))["solution"])
            for words in ("not written yet", "done"):
                here.ask(f"{place_of(id_)}.querySelector('button.check').click(), 0")
                if words not in (said := report(here, id_)):
                    yield f"{id_}: the report lacks '{words}':\n{said[:400]}"
                take_in(here, text)
    server.shutdown()


def a_body_is_taken_by_keys(root, build):
    """in Firefox the live page opens at its state; enter takes a body, arrows pull it"""
    with firefox.Firefox() as here:
        here.open((house.OUT / "docs" / "html" / "live.html").as_uri() + "#scene=chain&t=2")
        if not here.text_of("reading").startswith("t = 2.00 s"):
            yield f"shows {here.text_of('reading')}"
        here.ask("document.querySelector('canvas').focus()")
        here.keys(firefox.ENTER)
        here.wait("held !== null")
        before = here.ask("panels[0].painted.bodies[1].x[1]")
        here.keys(*[firefox.UP] * 20)
        here.wait(f"panels[0].painted.bodies[1].x[1] > {before} + 0.05")
        here.keys(firefox.ESCAPE)
        here.wait("held === null")


def a_narrow_window_shows_it(root, build):
    """in Firefox no chapter's page is wider than a window of 390 pixels"""
    address, server = served()
    with firefox.Firefox() as here:
        here.open(address, "document.readyState === 'complete'")
        for chapter in packed():
            frame = f"{{src: '{shell.text_of(chapter)}', style: 'width: 390px; height: 844px'}}"
            here.ask("document.body.replaceChildren(Object.assign("
                     f"document.createElement('iframe'), {frame})), 0")
            here.wait("document.querySelector('iframe').contentDocument?.documentElement?"
                      ".dataset.course === 'ready'")
            wide = here.ask("document.querySelector('iframe').contentDocument.documentElement"
                            ".scrollWidth")
            if wide > 390:
                yield f"{chapter.folder}: {wide} pixels wide"
    server.shutdown()


def in_firefox(proof):
    """A proof of page_test.py with the other browser."""
    def same(root, build):
        yield from proof(root, build, firefox.Firefox)
    same.__name__, same.__doc__ = proof.__name__, f"in Firefox: {proof.__doc__}"
    return same


PROOFS = [*map(in_firefox, (what_goes_wrong_is_told, nothing_is_lost, one_file_is_enough)),
          the_first_exercise_by_keys, each_chapter_is_judged, a_body_is_taken_by_keys,
          a_narrow_window_shows_it]

if __name__ == "__main__":
    try:
        packing.manifest()
    except house.Trouble as trouble:
        lacking = str(trouble)
    else:
        lacking = "" if firefox.there() else "firefox-esr missing (Debian package)"
    if lacking:
        print(f"the course in Firefox: {lacking}")
        sys.exit(77)
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
