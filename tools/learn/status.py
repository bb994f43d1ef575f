"""./wb: where the reader is, and the next thing to do."""
from judge import grade as grading
from base import house
from judge import reading
from base.talk import bad, bold, faint, folded, good

COLOURS = {grading.DONE: good, grading.WRONG: bad, grading.BROKEN: bad}


def status(chapters=True, every=False):
    """Every exercise of the chapters that are begun, or of all, and the next thing to do, or that
    alone."""
    looks = [reading.look(chapter) for chapter in house.chapters()]
    grades = grades_of(looks)
    still = [(look, one) for look in looks for one in grades[look.chapter.number]
             if one.status != grading.DONE]
    last = max((look.chapter.number for look in looks if look.begun()), default=0)
    upcoming = next((each for each in still if each[0].chapter.number >= last),
                    still[0] if still else None)  # it goes on where the reader was last
    for look in looks if chapters else []:
        tell_chapter(look, grades[look.chapter.number],
                     every or look.begun() or (upcoming and look is upcoming[0]), every)
    if chapters:
        print()
    if not upcoming:
        print("Every exercise is done. See what you built: ./wb run N, ./wb plot N, ./wb see N")
        return 0
    tell_next(*upcoming)
    if upcoming != still[0]:
        print(faint(f"This follows your last exercise. The first open one: {still[0][1].id}"))
    if not any(look.begun() for look in looks):
        print(faint("./wb help lists all commands"))
    return 0


def grades_of(looks):
    """{number of the chapter: grades}. Only what somebody has written is built and tested."""
    begun = [look.chapter for look in looks if look.written() and not look.faults]
    if len(begun) > 1:  # all at once; what does not compile is found out below
        house.build([f"{chapter.folder}_test_mine" for chapter in begun])
    found = {}
    for look in looks:
        known = {}
        if look.chapter in begun:
            known = grading.grade(look.chapter, look.written())
            if known[0].status == grading.BROKEN:
                known = grading.beside_refused(look.chapter, known)
            known = {one.id: one for one in known}
        found[look.chapter.number] = [
            known.get(id_) or grading.Grade(id_, grading.BROKEN if look.faults else grading.OPEN)
            for id_ in look.chapter.ids()]
    return found


def words_of(look, one):
    """Where an exercise stands; of one that is begun, where it goes on."""
    state = look.states[one.id]
    if one.id in look.left and state == reading.BEGUN:
        return f"begun: todo in line {look.left[one.id]}"
    return grading.OPEN if state == reading.UNTOUCHED else one.words()


def tell_chapter(look, grades, whole, even_done):
    """A chapter in one line, or, where it is begun, with a line for each exercise."""
    chapter, done = look.chapter, sum(one.status == grading.DONE for one in grades)
    count = f"{done} of {len(grades)} done"
    name = f"Chapter {chapter.number}: {chapter.name}"
    if not whole or (done == len(grades) and not even_done):
        print(f"{bold(f'{name:24}')} {good(count) if done == len(grades) else faint(count)}")
        return
    print(f"{bold(f'{name:24}')} {count}   {faint(house.short(chapter.text))}")
    titles = chapter.titles()
    for one in grades:
        colour = COLOURS.get(one.status, str)
        print(f"  {one.id}  {titles.get(one.id, ''):44} {colour(words_of(look, one))}")


def tell_next(look, one):
    chapter = look.chapter
    if look.faults:
        _, words, cure = look.faults[0]
        print(f"{folded(words)}\n{folded(cure)}")
    elif one.status == grading.BROKEN:
        print(f"Next: {house.short(chapter.mine)} does not compile: ./wb test {chapter.number}")
    elif one.status == grading.WRONG:
        print(f"Next: {one.id} is not right yet: ./wb test {one.id}")
    else:
        print(f"{bold(f'Next: exercise {one.id}')}, {chapter.titles().get(one.id, '')}")
        print(f"  read   {chapter.to_read(one.id)}")
        print(f"  edit   {chapter.place(one.id)}")
        print(f"  check  ./wb test {one.id}        stuck? ./wb hint {one.id}")
