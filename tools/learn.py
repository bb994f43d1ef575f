"""The commands of somebody who does the exercises: status, test, watch, hint, show, reset."""
import re
import textwrap
import time

import exercises
import grade as grading
import house
from house import bad, bold, faint, good

MARK = {grading.DONE: good, grading.WRONG: bad, grading.BROKEN: bad}


def status():
    """Every exercise and the next thing to do."""
    upcoming, all_done = None, True
    width = max(len(title) for c in house.chapters() for title in c.titles().values())
    for chapter in house.chapters():
        print(f"{bold(f'Chapter {chapter.number}: {chapter.name}')}   "
              f"{faint(house.short(chapter.text))}")
        titles = chapter.titles()
        for one in grading.grade(chapter):
            colour = MARK.get(one.status, lambda words: words)
            print(f"  {one.id}  {titles.get(one.id, ''):{width}} {colour(one.words())}")
            if one.status != grading.DONE:
                all_done = False
                upcoming = upcoming or (chapter, one)
    print()
    if all_done:
        print("Every exercise is done. ./wb run N, ./wb plot N and ./wb see N show what you built.")
        return 0
    chapter, one = upcoming
    if one.status == grading.BROKEN:
        print(f"Next: {house.short(chapter.mine)} does not compile: ./wb test {chapter.number}")
    elif one.status == grading.WRONG:
        print(f"Next: {one.id} is not right yet: ./wb test {one.id}")
    else:
        print(f"Next: exercise {one.id}.")
        print(f"  read   {house.short(chapter.text)}")
        print(f"  edit   {chapter.place(one.id)}")
        print(f"  check  ./wb test {one.id}        stuck? ./wb hint {one.id}")
    return 0


def indented(words):
    return "\n".join("    " + line if line else "" for line in words.split("\n"))


def tell(chapter, one):
    """What there is to say of one graded exercise."""
    title = chapter.titles().get(one.id, "")
    colour = MARK.get(one.status, lambda words: words)
    print(f"{bold(one.id)}  {title}: {colour(one.words())}")
    if one.status == grading.OPEN:
        print(f"  your code goes to {chapter.place(one.id)}, in place of todo(\"{one.id}\");")
        print(f"  the text: {house.short(chapter.text)}   a hint: ./wb hint {one.id}")
    elif one.status == grading.WAITS:
        print(f"  it calls {one.detail}, which is not written yet: ./wb test {one.detail}")
    elif one.status == grading.BROKEN:
        print(indented(one.detail))
    elif one.status == grading.WRONG:
        name, report = one.failures[0]
        if name:
            print(f"  {name.removeprefix(one.id).strip()}\n")
            report = with_units(report, grading.units(chapter, one.id))
        print(indented(report))
        if len(one.failures) > 1:
            others = len(one.failures) - 1
            print(f"\n  {others} more of its {one.tests} tests "
                  f"{'fails' if others == 1 else 'fail'}; mend this one first.")


def with_units(report, sentence):
    """The report with one line more under what is likely, before it says where."""
    words, where, rest = report.partition("\nWhere: ")
    lines = textwrap.fill(sentence, 76, subsequent_indent=" " * len("Units: "))
    return words.rstrip() + "\n" + lines + "\n" + where + rest if sentence else report


def test(word):
    """One exercise or one chapter. Exit status 0 when all of it is done."""
    if "." in word:
        chapter, id_ = house.exercise_of(word)
        grades = grading.grade(chapter, [id_])
    else:
        chapter = house.chapter_of(word)
        grades = grading.grade(chapter)
    if grades[0].status == grading.BROKEN:
        print(f"{house.short(chapter.mine)}: {bad('does not compile')}\n")
        place_of_error(chapter, grades[0].detail)
        print(indented(grades[0].detail))
        return 1
    stopped = False
    for one in grades:
        if stopped and one.status != grading.DONE:
            print(f"{bold(one.id)}  {chapter.titles().get(one.id, '')}: {one.words()}")
            continue
        tell(chapter, one)
        stopped = stopped or one.status != grading.DONE
    if len(grades) == 1 and grades[0].status == grading.WRONG:
        name_earlier(chapter, grades[0].id)
    if all(one.status == grading.DONE for one in grades):
        tests = sum(one.tests for one in grades)
        print(f"{tests} tests passed. " + after(chapter, grades[-1].id))
        return 0
    return 1


def name_earlier(chapter, id_):
    """An exercise may call earlier ones of its chapter: says which of them are wrong themselves."""
    earlier = chapter.ids()[:chapter.ids().index(id_)]
    wrong = [one.id for one in grading.grade(chapter, earlier) if one.status == grading.WRONG] \
        if earlier else []
    if wrong:
        print(f"\n  {' and '.join(wrong)} {'is' if len(wrong) == 1 else 'are'} not right yet, and "
              f"{id_} may call {'it' if len(wrong) == 1 else 'them'}: ./wb test {wrong[0]}")


def after(chapter, id_):
    """The next thing after an exercise that is done: the next one of the chapter that is not."""
    ids = chapter.ids()
    place = ids.index(id_)
    for one in grading.grade(chapter, ids[place + 1:] + ids[:place]) if len(ids) > 1 else []:
        if one.status != grading.DONE:
            return f"Next: {one.id}, {chapter.place(one.id)}"
    words = f"See what you built: ./wb run {chapter.number}, ./wb plot {chapter.number}, " \
            f"./wb see {chapter.number}"
    later = [c for c in house.chapters() if c.number == chapter.number + 1]
    return words + (f"\nThen {house.short(later[0].text)}" if later else "")


def place_of_error(chapter, words):
    """Which exercise the first error of the compiler lies in."""
    line = rf"{re.escape(chapter.mine.name)}:(\d+):"
    errors = re.findall(rf"{line}.*\berror:", words)[:1]  # a template's error begins with its user
    for number in map(int, errors or re.findall(line, words)):
        for region in exercises.regions(chapter.mine.read_text()):
            if region.begin <= number <= region.end + 2:  # the closing brace, too
                print(f"  The first error lies in exercise {region.id}, line {number}.")
                if "LanesFor" in words:
                    print("  Likely mistake: lanes have only + - * with other lanes: no if, no "
                          "comparison, no\n  division, no plain number such as 2.")
                print(f"  Next: ./wb hint {region.id}\n")
                return


def watch(word):
    """Tests again whenever an exercise file is saved, until interrupted."""
    if word:  # refuse nonsense before waiting for it
        house.exercise_of(word) if "." in word else house.chapter_of(word)
    seen = None
    while True:
        stamps = {c.mine: c.mine.stat().st_mtime for c in house.chapters()}
        if stamps != seen:
            changed = [c for c in house.chapters() if seen and stamps[c.mine] != seen[c.mine]]
            seen = stamps
            if house.TERMINAL:
                print("\033[2J\033[H", end="")
            if word:
                test(word)
            elif changed:
                first_open(changed[0])
            else:
                status()
            print(faint("\nwatching; save a file to test again, Ctrl-C ends"), flush=True)
        time.sleep(0.3)


def first_open(chapter):
    """The first exercise of a chapter that is not done."""
    grades = grading.grade(chapter)
    for one in grades:
        if one.status != grading.DONE:
            return tell(chapter, one)
    print(good(f"chapter {chapter.number} is done"))
    return None


def hint(word, step):
    chapter, id_ = house.exercise_of(word)
    if step not in ("1", "2", "3"):
        raise house.Trouble(f"{step}: a hint has steps 1, 2 and 3")
    if not chapter.hints.exists():
        raise house.Trouble(f"{house.short(chapter.hints)} is missing")
    text = chapter.hints.read_text()
    match = re.search(rf"^## {re.escape(id_)}\b.*?\n(.*?)(?=^## |\Z)", text, re.M | re.S)
    part = match and re.search(rf"^### {step}\b.*?\n(.*?)(?=^### |\Z)", match[1], re.M | re.S)
    if not part:
        raise house.Trouble(f"{house.short(chapter.hints)} has no hint {step} for {id_}")
    print(bold(f"Hint {step} of 3 for {id_}\n"))
    print(part[1].strip())
    print()
    if step != "3":
        print(faint(f"more: ./wb hint {id_} {int(step) + 1}"))
    else:
        print(faint(f"the solution: ./wb show {id_}"))
    return 0


def solution(word, yes):
    chapter, id_ = house.exercise_of(word)
    if not house.ask(f"Show the solution of {id_}?", yes):
        return 0
    for region in exercises.regions(chapter.solution.read_text()):
        if region.id == id_:
            print(bold(f"\n{house.short(chapter.solution)}:{region.begin}"))
            print("\n".join(region.lines))
    return 0


def reset(word, yes):
    """Puts the stub back for an exercise or a chapter, after asking if there is work in it."""
    chapter = house.chapter_of(word)
    ids = [house.exercise_of(word)[1]] if "." in word else chapter.ids()
    fresh = exercises.stub(chapter.solution.read_text())
    mine = chapter.mine.read_text()
    try:
        new = fresh if "." not in word else exercises.fill(mine, fresh, ids)
    except exercises.Broken as broken:
        raise house.Trouble(f"{broken}; ./wb reset {chapter.number} makes the whole file new")
    if new == mine:
        print(f"{house.short(chapter.mine)} is the stub already.")
        return 0
    what = f"exercise {word}" if "." in word else house.short(chapter.mine)
    if not house.ask(f"Throw away your work in {what}?", yes):
        return 0
    chapter.mine.write_text(new)
    print(f"{house.short(chapter.mine)}: the stub is back for {' '.join(ids)}.")
    return 0
