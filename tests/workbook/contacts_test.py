"""A contact needs no new solver, and no earlier program carries one: contacts_test.py ROOT BUILD"""
import re
import subprocess
import sys

from proofs import house, main

WORDS = re.compile(r"contact|frict|restitut|rebound|corner|ground|tangent", re.I)
SYMBOLS = re.compile(r"joints::(?:GroundContact|Corner\b|Outline|Top\b|tangents\(|impact_speed"
                     r"|friction_impulse)")
CHAPTER = 8  # where all that is found


def words_of(path):
    return sorted({word.lower() for word in WORDS.findall(path.read_text(encoding="utf-8"))})


def the_engine_knows_no_contact(root, build):
    """the engine says no word of contacts, friction or the ground"""
    sources = [*(root / "engine").glob("*.h"), *(root / "engine").glob("*.cpp")]
    if len(sources) < 20:
        yield "engine: no sources were found"
    for path in sorted(sources):
        for word in words_of(path):
            yield f"engine/{path.name} says '{word}'"
    if len(words_of(root / "chapters" / "08_ground" / "ground_contact.h")) < 5:
        yield "ground_contact.h does not say the words that are looked for"


def earlier_programs_carry_no_contact(root, build):
    """no program of an earlier chapter carries a symbol of the ground, this chapter's does"""
    for chapter in house.chapters():
        program = f"{chapter.folder}_run"
        symbols = subprocess.run(["nm", "-C", str(build / program)], capture_output=True,
                                 text=True).stdout
        found = sorted(set(SYMBOLS.findall(symbols)))
        if "joints::" not in symbols:
            yield f"{program}: nm shows no symbols"
        elif chapter.number < CHAPTER:
            yield from (f"{program} carries {symbol}" for symbol in found)
        elif chapter.number == CHAPTER and not {"joints::GroundContact", "joints::Corner"} <= set(
                found):
            yield f"{program} carries {found} only: are the symbols still called so?"


PROOFS = [the_engine_knows_no_contact, earlier_programs_carry_no_contact]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
