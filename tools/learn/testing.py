"""./wb test and ./wb watch: what is wrong with an exercise, or what comes after it."""
import re
import time

from base import exercises
from judge import crashes
from judge import grade as grading
from base import house
from judge import reading
from learn.status import COLOURS, status
from base.talk import bad, bold, faint, folded, indented

AT_ONCE = 2  # what is not asked for is not waited for longer [s]
MOST_PRINTED = 12  # lines of an answer's own output


def test(word):
    """One exercise or one chapter. Exit status 0 when all of it is done."""
    chapter, id_ = house.asked(word)
    look = reading.look(chapter)
    if look.faults:
        _, words, cure = look.faults[0]
        print(f"{house.short(chapter.mine)}: {bad('cannot be built')}\n")
        print(f"{folded(words, 2)}\n{folded(cure, 2)}")
        return 1
    passed = test_one(look, id_) if id_ else test_all(look)
    if look.note:
        print("\n" + folded(look.note))
    return 0 if passed else 1


def test_one(look, id_):
    """True when the exercise is done."""
    if look.states[id_] == reading.UNTOUCHED:  # the text tells: nothing need be built
        tell(look, grading.Grade(id_, grading.OPEN))
        return False
    one, = grading.grade(look.chapter, [id_], fresh=True)
    if one.status == grading.BROKEN:
        return tell_broken(look.chapter, one.detail)
    tell(look, one)
    if one.status == grading.WRONG:
        name_earlier(look, id_)
    if one.status == grading.DONE:
        print(f"{one.tests} tests passed. {after(look, id_)}")
    return one.status == grading.DONE


def test_all(look):
    """A whole chapter: the first exercise that is not done is told in full. True if all are."""
    ids = look.chapter.ids()
    asked = [id_ for id_ in ids if look.states[id_] != reading.UNTOUCHED]
    grades = grading.grade(look.chapter, asked, fresh=True) if asked else []
    if grades and grades[0].status == grading.BROKEN:
        return tell_broken(look.chapter, grades[0].detail)
    known = {one.id: one for one in grades}
    grades = [known.get(id_) or grading.Grade(id_, grading.OPEN) for id_ in ids]
    told = False
    for one in grades:
        if told or one.status == grading.DONE:
            print(headline(look.chapter, one))
        else:
            tell(look, one)
            told = True
    if not told:
        print(f"{sum(one.tests for one in grades)} tests passed. {after_all(look.chapter)}")
    return not told


# ---- what is said of an exercise -----------------------------------------------------------------

def headline(chapter, one):
    colour = COLOURS.get(one.status, str)
    return f"{bold(one.id)}  {chapter.titles().get(one.id, '')}: {colour(one.words())}"


def tell(look, one):
    """What there is to say of one graded exercise."""
    chapter = look.chapter
    print(headline(chapter, one))
    tell_printed(one.printed)
    if one.status == grading.OPEN and look.states[one.id] == reading.UNTOUCHED:
        print(f"  read   {chapter.to_read(one.id)}")
        print(f"  edit   {chapter.place(one.id)}")
        print(f"  stuck? ./wb hint {one.id}")
    elif one.status == grading.OPEN:
        print(f"  it is begun; todo(\"{one.id}\"); still stands in its place:\n"
              f"  {chapter.place(one.id)}")
    elif one.status == grading.WAITS:
        print(f"  it calls {one.detail}, which is not written yet: ./wb test {one.detail}")
    elif one.status == grading.WRONG:
        name, report = one.failures[0]
        if name:
            print(folded(name.removeprefix(one.id).strip(), 2) + "\n")
        print(indented(report), flush=True)
        if len(one.failures) > 1:
            others = len(one.failures) - 1
            print(f"\n  {others} more of its {one.tests} tests "
                  f"{'fails' if others == 1 else 'fail'}; mend this one first.", flush=True)
            if words := grading.second_mistake(one.failures):
                print(folded(words, 2))
        if report.startswith("Exercise") and "Likely mistake:" not in report:
            if sentence := grading.units(chapter, one.id):  # they may have to be compiled first
                print("\n" + folded(sentence, 2))


def tell_printed(words):
    """What the tested code has printed itself, cut where it is long."""
    lines = words.split("\n") if words else []
    if lines:
        print("  your code prints:")
    for line in lines[:MOST_PRINTED]:
        print(faint("    | ") + "".join(c if c.isprintable() else "?" for c in line.expandtabs()))
    if len(lines) > MOST_PRINTED:
        print(faint(f"    | ... {len(lines) - MOST_PRINTED} lines more"))


def tell_broken(chapter, words):
    """Reports the first error of the compiler and its meaning. False: nothing passed."""
    print(f"{house.short(chapter.mine)}: {bad('does not compile')}\n")
    if missing := sorted(set(re.findall(r"undefined reference to [`'](.+)'", words))):
        print(folded(f"These functions are not there, or not with these arguments: "
                     f"{'; '.join(missing)}. Was a line outside the exercises changed?", 2))
        print(f"  Next: ./wb reset {chapter.number} --keep")
        return False
    meaning = crashes.refused(words)
    for id_, number in grading.refused_in(chapter, words)[:1]:
        print(f"  The first error lies in exercise {id_}, line {number}.")
        if meaning:
            print(folded(f"Likely mistake: {meaning}", 2))
        print(f"  Next: mend it, then ./wb test {id_}\n")
    print(indented(words))
    return False


# ---- the others of the chapter -------------------------------------------------------------------

def name_earlier(look, id_):
    """An exercise may call earlier ones of its chapter: says which of them are wrong themselves."""
    code = "\n".join(line.split("//")[0] for region in exercises.scan(look.chapter.mine_text())[0]
                     if region.id == id_ for line in region.lines)
    earlier = [other for other in look.written() if number(other) < number(id_) and any(
        re.search(rf"\b{name}\(", code)
        for name in re.findall(r"(\w+)(?=,|$| \()", look.chapter.titles().get(other, "")))]
    wrong = [one.id for one in grading.grade(look.chapter, earlier, AT_ONCE)
             if one.status == grading.WRONG] if earlier else []
    if wrong:
        print("\n" + folded(f"{', '.join(wrong)} {'is' if len(wrong) == 1 else 'are'} not right "
                            f"yet, and {id_} calls {'it' if len(wrong) == 1 else 'them'}: "
                            f"./wb test {wrong[0]}", 2))


def number(id_):
    return int(id_.split(".")[1])


def after(look, id_):
    """The next thing after an exercise that is done: the next one of the chapter that is not."""
    ids = look.chapter.ids()
    place = ids.index(id_)
    known = {}
    for other in ids[place + 1:] + ids[:place]:
        if look.states[other] == reading.WRITTEN and other not in known:
            rest = [one for one in look.written() if one != id_]
            known = {one.id: one for one in grading.grade(look.chapter, rest, AT_ONCE)}
        if other in known and known[other].status in (grading.WRONG, grading.BROKEN):
            return f"Next: ./wb test {other}, which is not right yet."
        if other not in known or known[other].status != grading.DONE:
            return (f"Next: {other}\n  read   {look.chapter.to_read(other)}\n"
                    f"  edit   {look.chapter.place(other)}")
    return after_all(look.chapter)


def after_all(chapter):
    """What to do when a chapter is done."""
    words = f"See what you built:\n  ./wb run {chapter.number}   ./wb plot {chapter.number}   " \
            f"./wb see {chapter.number}"
    later = [c for c in house.chapters() if c.number == chapter.number + 1]
    return words + (f"\nThen {house.short(later[0].text)}" if later else "")


# ---- watch ---------------------------------------------------------------------------------------

def watch(word):
    """Tests again whenever an exercise file is saved, until interrupted."""
    if word:  # refuse nonsense before waiting for it
        house.asked(word)
    seen = None
    while True:
        stamps = {c.number: c.mine.stat().st_mtime if c.mine.exists() else 0
                  for c in house.chapters()}
        if stamps != seen:
            changed = [c for c in house.chapters()
                       if seen and stamps[c.number] != seen[c.number]]
            seen = stamps
            if house.TERMINAL:
                print("\033[2J\033[H", end="")
            try:
                test(word) if word else test(str(changed[0].number)) if changed else status()
            except house.Trouble as trouble:
                print(trouble)
            print(faint("\nwatching; save a file to test again, Ctrl-C ends"), flush=True)
        time.sleep(0.3)
