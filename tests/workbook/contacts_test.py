"""A contact needs no new solver, and no earlier program carries one: contacts_test.py ROOT BUILD"""
import re
import sys

from proofs import main, programs_that_carry

WORDS = re.compile(r"contact|frict|restitut|rebound|corner|ground|tangent", re.I)
SYMBOLS = re.compile(r"joints::(?:GroundContact|Corner\b|Outline|Top\b|tangents\(|impact_speed"
                     r"|friction_impulse)")
CHAPTER = 8  # where all that is found


def words_of(path):
    return sorted({word.lower() for word in WORDS.findall(path.read_text(encoding="utf-8"))})


def the_engine_knows_no_contact(root, build):
    """the engine says no word of contacts, friction or the ground, but where it orders lanes"""
    sources = [path for end in ("h", "cpp") for path in (root / "engine").rglob(f"*.{end}")
               if path.parent.name != "simd"]
    if len(sources) < 40:
        yield "engine: no sources were found"
    for path in sorted(sources):
        for word in words_of(path):
            yield f"{path.relative_to(root)} says '{word}'"
    if len(words_of(root / "contacts" / "ground_contact.h")) < 5:
        yield "ground_contact.h does not say the words that are looked for"


def earlier_programs_carry_no_contact(root, build):
    """no program of an earlier chapter carries a symbol of the ground, this chapter's does"""
    yield from programs_that_carry(build, CHAPTER, SYMBOLS,
                                   {"joints::GroundContact", "joints::Corner"})


PROOFS = [the_engine_knows_no_contact, earlier_programs_carry_no_contact]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
