"""What the text of a reader's file tells before anything is built."""
import difflib
import re
from collections import Counter
from dataclasses import dataclass, field

from base import exercises, house
from judge import includes

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
    solution = exercises.read(chapter.solution)
    whole, broken = exercises.scan(text)
    mine = {id_: [region for region in whole if region.id == id_] for id_ in chapter.ids()}
    wanted = Counter(region.id for region in exercises.regions(solution))
    for id_, regions in mine.items():
        open_ = [region for region in regions if exercises.is_open(region)]
        seen.states[id_] = UNTOUCHED if all(map(untouched, regions)) else \
            WRITTEN if len(regions) == wanted[id_] and not open_ else BEGUN
        if open_:
            seen.left[id_] = line_of_todo(open_[0])
    seen.faults = list(faults(chapter, broken, mine, wanted))
    if words := includes.refused(text):
        seen.faults.append(("", f"{house.short(chapter.mine)}: {words}", "Next: remove that line."))
    if not seen.faults and (lines := changed_outside(exercises.stub(solution), text)):
        seen.note = (f"Note: {house.short(chapter.mine)} has changed outside the exercises, in "
                     f"line{lines}. If that was not meant: ./wb reset {chapter.number} --keep puts "
                     "it back and keeps your answers.")
    return seen


def faults(chapter, broken, mine, wanted):
    """What keeps the file from being built: the file, its markers, the braces in its regions."""
    name, stay = house.short(chapter.mine), "(your other answers stay)."
    if not chapter.mine.is_file():
        yield "", f"{name} is not there.", f"Next: ./wb reset {chapter.number} makes it new."
        return
    for line, id_, words in broken:
        yield (id_, f"{name}:{line}: {words}.",
               f"Next: put it back, or ./wb reset {id_} does {stay}")
    for id_, regions in mine.items():
        lines = " and ".join(str(region.begin) for region in regions)
        if not regions:
            yield (id_, f"{name}: the lines '// begin [exercise {id_}]' and '// end [exercise "
                   f"{id_}]' are missing.", f"Next: put them back, or ./wb reset {id_} does {stay}")
        elif len(regions) != wanted[id_]:
            yield (id_, f"{name}: exercise {id_} begins in line {lines}: that is {len(regions)} "
                   f"times, not {wanted[id_]}.", "Next: put right how often it stands there, or "
                   f"./wb reset {id_} makes it new {stay}")
    for region in (region for regions in mine.values() for region in regions):
        if words := unbalanced(region):
            yield region.id, f"{name}:{words}", f"Next: mend it, then ./wb test {region.id}"


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
