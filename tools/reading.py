"""What the text of a reader's file tells before anything is built."""
import difflib
import re
from collections import Counter
from dataclasses import dataclass, field

import exercises
import house

UNTOUCHED, BEGUN, WRITTEN = "untouched", "begun", "written"


@dataclass
class Look:
    """What was seen in the exercise file of a chapter."""
    chapter: house.Chapter
    states: dict = field(default_factory=dict)  # exercise: UNTOUCHED, BEGUN or WRITTEN
    left: dict = field(default_factory=dict)    # exercise that is begun: line of a todo
    faults: list = field(default_factory=list)  # (exercise or "", sentence, what to do): no build
    note: str = ""                              # what has changed outside the exercises

    def written(self):
        return [id_ for id_, state in self.states.items() if state == WRITTEN]

    def begun(self):
        """True when there is anything of the reader's in the file."""
        return bool(self.faults) or any(state != UNTOUCHED for state in self.states.values())

    def refuse(self):
        """Stops at the first fault."""
        for _, words, cure in self.faults:
            raise house.Trouble(f"{words}\n{cure}")


def look(chapter):
    """Reads the exercise file of a chapter."""
    seen, text = Look(chapter), chapter.mine_text()
    name, again = house.short(chapter.mine), f"./wb reset {chapter.number}"
    if not chapter.mine.is_file():
        seen.faults.append(("", f"{name} is not there.", f"Next: {again} makes it new."))
    solution = exercises.read(chapter.solution)
    whole, broken = exercises.scan(text)
    for line, id_, words in broken:
        seen.faults.append((id_, f"{name}:{line}: {words}.", "Next: put it back, or "
                            f"./wb reset {id_} does (your other answers stay)."))
    wanted = Counter(region.id for region in exercises.regions(solution))
    for id_ in chapter.ids():
        mine = [region for region in whole if region.id == id_]
        open_ = [region for region in mine if exercises.is_open(region)]
        if len(mine) == wanted[id_] and not open_:
            seen.states[id_] = WRITTEN
        elif all(untouched(region) for region in mine):
            seen.states[id_] = UNTOUCHED
        else:
            seen.states[id_] = BEGUN
        if open_:
            seen.left[id_] = line_of_todo(open_[0])
        if seen.faults:
            continue
        if not mine:
            seen.faults.append((id_, f"{name}: the lines '// begin [exercise {id_}]' and '// end "
                                f"[exercise {id_}]' are missing.",
                                f"Next: put them back, or ./wb reset {id_} does (your other "
                                "answers stay)."))
        elif len(mine) != wanted[id_]:
            lines = " and ".join(str(region.begin) for region in mine)
            seen.faults.append((id_, f"{name}: exercise {id_} begins in line {lines}: that is "
                                f"{len(mine)} times, not {wanted[id_]}.",
                                f"Next: delete what is too many, or ./wb reset {id_} makes it new "
                                "(your other answers stay)."))
    for region in whole:
        if words := not seen.faults and unbalanced(region):
            seen.faults.append((region.id, f"{name}:{words}",
                                f"Next: mend it, then ./wb test {region.id}"))
    if not seen.faults and (lines := changed_outside(exercises.stub(solution), text)):
        seen.note = (f"Note: {name} has changed outside the exercises, in line{lines}. If that was "
                     f"not meant: {again} --keep puts it back and keeps your answers.")
    return seen


def untouched(region):
    code = [line.split("//")[0].strip() for line in region.lines]
    return [line for line in code if line] == [f'todo("{region.id}");']


def line_of_todo(region):
    return next(region.begin + place for place, line in enumerate(region.lines, 1)
                if "todo(" in line.split("//")[0])


# ---- braces --------------------------------------------------------------------------------------

# Comments, texts and characters, which may hold anything; a comment that never ends; braces.
TOKEN = re.compile(r"""//[^\n]* | /\*.*?\*/ | R"(\w*)\(.*?\)\1" | "(?:\\.|[^"\\\n])*"
                       | (?<![0-9a-fA-F])'(?:\\.|[^'\\\n])+' | /\* | [{}]""", re.X | re.S)


def unbalanced(region):
    """What is wrong with the braces of a region, "line: words", or "". The compiler would see it
    only at the end of the file."""
    text = "\n".join(region.lines)
    if re.search(r"^\s*#", text, re.M):  # what a preprocessor leaves out may hold anything
        return ""
    opened, extra = [], []
    for match in TOKEN.finditer(text):
        line = region.begin + 1 + text.count("\n", 0, match.start())
        if match[0] == "/*":
            return f"{line}: exercise {region.id}: the comment that begins with /* never ends."
        if match[0] == "{":
            opened.append(line)
        elif match[0] == "}" and opened:
            opened.pop()
        elif match[0] == "}":
            extra.append(line)
    if len(opened) > len(extra):
        return f"{opened[-1]}: exercise {region.id}: the {{ of this line is never closed."
    if len(extra) > len(opened):
        return f"{extra[-1]}: exercise {region.id}: the }} of this line closes nothing."
    return ""


# ---- outside the exercises -----------------------------------------------------------------------

def frame(text):
    """The code outside the regions: [(line, code)], without comments, blanks and includes."""
    inside = {number for region in exercises.scan(text)[0]
              for number in range(region.begin, region.end)}
    found = []
    for number, line in enumerate(text.split("\n")):
        code = line if line.strip().startswith("// ") and "[exercise" in line \
            else " ".join(line.split("//")[0].split())
        if number not in inside and code.strip() and not code.startswith("#include"):
            found.append((number + 1, code.strip()))
    return found


def changed_outside(fresh, mine):
    """" 3" or "s 3, 7-9": the lines outside the exercises that are not as they were; or ""."""
    before, after = frame(fresh), frame(mine)
    matcher = difflib.SequenceMatcher(None, [code for _, code in before],
                                      [code for _, code in after], autojunk=False)
    found = []
    for kind, _, _, first, last in matcher.get_opcodes():
        if kind == "equal":
            continue
        lines = [line for line, _ in after[first:last]]
        if not lines:  # something is gone: named by the line after which it stood
            lines = [after[first - 1][0] if first else 1]
        found.append(f"{lines[0]}-{lines[-1]}" if lines[-1] > lines[0] else f"{lines[0]}")
    found = list(dict.fromkeys(found))
    return ("s " if len(found) > 1 or "-" in "".join(found) else " ") + ", ".join(found) \
        if found else ""
