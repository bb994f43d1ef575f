"""./wb hint, ./wb show and ./wb reset: help with an exercise, and a new beginning."""
import re
from itertools import count

from base import exercises, house
from judge import reading
from base.talk import WIDTH, bold, faint, folded


def hint(word, step):
    chapter, id_ = house.exercise_of(word)
    if step not in ("1", "2", "3"):
        raise house.Trouble(f"hint {word} {step}: there are the hints 1, 2 and 3")
    text = chapter.hints.read_text() if chapter.hints.exists() else ""
    match = re.search(rf"^## {re.escape(id_)}\b.*?\n(.*?)(?=^## |\Z)", text, re.M | re.S)
    part = match and re.search(rf"^### {step}\b.*?\n(.*?)(?=^### |\Z)", match[1], re.M | re.S)
    if not part:
        raise house.Trouble(f"{house.short(chapter.hints)} has no hint {step} for {id_}")
    print(bold(f"Hint {step} of 3 for {id_}\n"))
    print(paragraphs(in_letters(part[1].strip())))
    print()
    if step != "3":
        print(faint(f"more: ./wb hint {id_} {int(step) + 1}"))
    elif not chapter.sealed:
        print(faint(f"the solution: ./wb show {id_}"))
    return 0


def in_letters(text):
    """The text with its formulas as they are written in code and in reports: kappa h^2 for
    $\\kappa h^2$."""
    def plain(match):
        tex = re.sub(r"\\sqrt\s*(\\?\w+|\{[^{}]*\})", r"sqrt(\1)", match[1])
        tex = re.sub(r"\\[,;!:]", "", tex).replace(r"\times", "x")
        return " ".join(re.sub(r"\\([a-zA-Z]+)|[{}]", r"\1", tex).split())
    return re.sub(r"(?<!\$)\$([^$\n]+)\$(?!\$)", plain, text)


def paragraphs(text):
    """A text whose paragraphs fit a terminal; code, tables, lists and formulas stay as they are."""
    blocks, code = [], False
    for block in text.split("\n\n"):
        plain = not code and not re.search(r"^(\||- |\d+\. |    |```|\$\$)", block, re.M)
        code ^= len(re.findall(r"^```", block, re.M)) % 2 == 1
        long = any(len(line) >= WIDTH for line in block.split("\n"))
        blocks.append(folded(" ".join(block.split())) if plain and long else block)
    return "\n\n".join(blocks)


def solution(word, yes):
    chapter, id_ = house.exercise_of(word)
    if chapter.sealed:
        raise house.Trouble(f"the solutions of chapter {chapter.number} are not in this edition"
                            f"\n./wb hint {id_} 3 is nearly the answer")
    if not house.ask(f"Show the solution of {id_}?", yes):
        return 0
    for region in exercises.regions(exercises.read(chapter.solution)):
        if region.id == id_:
            print(bold(f"\n{house.short(chapter.solution)}:{region.begin}"))
            print("\n".join(region.lines))
    return 0


def reset(word, yes, keep):
    """Makes a file anew: with the reader's answers apart from the exercise that is named, or, with
    `keep`, with all of them. The old text is kept under out/."""
    chapter, id_ = house.asked(word)
    fresh, mine = exercises.stub(exercises.read(chapter.solution)), chapter.mine_text()
    name, look = house.short(chapter.mine), reading.look(chapter)
    if keep:
        new, said = exercises.transplant(fresh, mine), "as it was around your answers"
    elif id_:
        new, said = exercises.transplant(fresh, mine, [id_]), f"the stub is back for {id_}"
    else:
        new, said = fresh, f"the stub is back for {' '.join(chapter.ids())}"
    if new == mine:
        print(f"{name}: there is nothing to put back.")
        return 0
    work = mine and not keep and (look.faults or any(
        look.states[i] != reading.UNTOUCHED for i in ([id_] if id_ else look.states)))
    what = f"exercise {id_}" if id_ else name
    if work and not house.ask(f"Throw away your work in {what}?", yes):
        return 0
    if mine:
        places = (house.OUT / "before_reset" / f"{chapter.name}{n or ''}.cpp" for n in count())
        kept = next(one for one in places if not one.exists() or exercises.read(one) == mine)
        exercises.write(kept, mine)
        said += f" (what stood there: {house.short(kept)})"
    exercises.write(chapter.mine, new)
    print(folded(f"{name}: {said}."))
    return 0
