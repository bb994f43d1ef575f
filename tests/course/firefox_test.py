"""The course in a headless Firefox: firefox_test.py ROOT BUILD

What may differ from Chromium, where page_test.py looks at everything: 1.1 by the keyboard alone,
wrong, right and moving; what is pasted, and a full stack, which each browser calls otherwise; what
it keeps, also for use without a network; pages from a disk. Skipped, with exit status 77, where
there is no Firefox or no out/course.
"""
import sys

from reader import RIGHT, WRONG, lacks, tab

import firefox
from page_test import CALLS_ITSELF, FAULTS, nothing_is_lost, one_file_is_enough
from proofs import house, main, notes

from course import packing

MOST_TABS = 300


def tab_to(here, element, back=False):
    """Presses tab, or shift and tab, until an element has the focus; returns how often."""
    for count in range(MOST_TABS):
        if here.ask(f"document.activeElement === {element}"):
            return count
        here.chord(firefox.SHIFT, firefox.TAB) if back else here.keys(firefox.TAB)
    raise TimeoutError(f"{MOST_TABS} tabs do not lead to {element}")


def the_first_exercise_by_keys(root, build):
    """in Firefox 1.1 is written, checked and right by the keyboard alone, and its scene moves"""
    exercise, *_ = tab(firefox.Firefox)
    here, editor = exercise.browser, f"{exercise.place}.querySelector('.cm-content')"
    notes.append(f"Firefox: {tab_to(here, editor)} tabs to the first editor")
    for answer, words in ((WRONG, ("1.1  CentreDistance::jacobian: wrong",
                                   "Likely mistake: the sign of the block v1")),
                          (RIGHT, ("done", "6 tests passed."))):
        tab_to(here, editor, back=answer is RIGHT)
        here.chord(firefox.CONTROL, "a")
        here.keys(*answer.replace("\n  ", "\n").strip().replace("\n", firefox.ENTER))
        exercise.await_text(answer)
        tab_to(here, f"{exercise.place}.querySelector('button.check')")
        yield from lacks(exercise.check(lambda: here.keys(firefox.ENTER)), *words)
    yield from lacks(exercise.scene(), "yours")
    exercise.ask(".querySelector('.scene').replaceChildren()")


def a_paste_is_taken(root, build):
    """in Firefox an editor takes what is pasted; a full stack is told"""
    exercise, *_ = tab(firefox.Firefox)
    exercise.write(CALLS_ITSELF)
    yield from lacks(exercise.check(), FAULTS[CALLS_ITSELF])


def in_firefox(proof):
    """A proof of page_test.py with the other browser."""
    def same(root, build):
        yield from proof(root, build, firefox.Firefox)
    same.__doc__ = f"in Firefox: {proof.__doc__}"
    return same


PROOFS = [the_first_exercise_by_keys, a_paste_is_taken, in_firefox(nothing_is_lost),
          in_firefox(one_file_is_enough)]

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
