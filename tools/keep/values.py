"""The value of an expression: cells of the tables that the programs write, and operations on
them.

`FILE[CONDITIONS].COLUMN` is a cell of a table: of the chapter that a text belongs to, of another
(`06/beta.csv`), of a run with options (`03 --iterations 300/curl.csv`), or of a table that is kept
(`bench/peers.csv`). A condition is the value of the next column, or `column=value`, `column>=value`
and so on. A selection of more than one row goes into first, last, max, min, mean, rms, count.
`printed("limits (\\d+) of 4")` is the output of the chapter's programs on the terminal.
`live("scene=chain&t=3", "gap")` is a number of the live page at this address: gap [m], energy [J],
or within a step error and first_error [m/s]. `exercises(3)`, `questions(3)`, `lines(3)` are how
many of them a chapter has, `words(3)` those of its text outside its folds; `hours(3)` is what that
takes by the paces of docs/teaching.md, `hours()` what all chapters take.
"""
import csv
import fcntl
import math
import re
import subprocess
from functools import lru_cache

from base import exercises, house

CHAPTER = r"(?<![\w.])\d\d(?: --[a-z-]+ [\w.]+)*/"  # with options of its program
CELL = re.compile(rf"(?P<file>(?:{CHAPTER}|[a-z]+(?:/[a-z]+)*/)?\w+\.csv)"
                  r"\[(?P<where>[^\]]*)\]\.(?P<column>\w+)")
CONDITION = re.compile(r"^(\w+)\s*(>=|<=|!=|=|>|<)\s*(.+)$")


class Wrong(Exception):
    """What is wrong with an expression or with the table that it names."""


class Tables:
    """The tables of the programs that are in `build`, made when they are asked for."""

    def __init__(self, root, build):
        self.root, self.build = root, build

    @lru_cache(maxsize=None)
    def run(self, number, options):
        """(folder of the tables, what was printed) of a chapter's programs; options are those of
        the first."""
        chapter = next((c for c in house.chapters() if c.number == number), None)
        programs = [self.build / name for name in chapter.programs] if chapter else []
        programs = programs[:1] if options else programs
        if not programs or not all(program.is_file() for program in programs):
            raise Wrong(f"there is no program of chapter {number}")
        folder = self.build / "numbers" / (chapter.folder + "".join(options.split()))
        printed = folder / "printed.txt"
        folder.mkdir(parents=True, exist_ok=True)
        with open(folder / "lock", "w") as lock:  # several proofs ask at once: one of them runs it
            fcntl.flock(lock, fcntl.LOCK_EX)
            built = max(program.stat().st_mtime for program in programs)
            if not printed.is_file() or printed.stat().st_mtime < built:
                for old in folder.glob("*.*"):
                    old.unlink()
                said = ""
                for program in programs:
                    result = subprocess.run([program, *options.split(), "--out", folder],
                                            capture_output=True, text=True)
                    if result.returncode:
                        raise Wrong(f"{program.name} {options}: {result.stderr.strip()}")
                    said += result.stdout
                printed.write_text(said, encoding="utf-8")
        return folder, printed.read_text(encoding="utf-8")

    def path(self, name, chapter):
        """Where a table is. \\param chapter of the text, or 0"""
        folder, _, file = name.rpartition("/")
        number, _, options = folder.partition(" ")
        if number.isdigit() or not folder:
            return self.run(int(number or chapter), options)[0] / file
        return self.root / name

    @lru_cache(maxsize=None)
    def rows(self, path):
        if not path.is_file():
            raise Wrong(f"there is no table {path.name}")
        with open(path, newline="", encoding="utf-8") as file:
            table = csv.DictReader(file)
            return table.fieldnames, list(table)

    def cells(self, match, chapter):
        """The cells that a reference selects, as numbers."""
        columns, rows = self.rows(self.path(match["file"], chapter))
        if match["column"] not in columns:
            raise Wrong(f"{match['file']} has no column {match['column']}; it has "
                        f"{', '.join(columns)}")
        place = 0
        for condition in filter(None, (part.strip() for part in match["where"].split(","))):
            named = CONDITION.match(condition)
            if named and named[1] in columns:
                column, sign, wanted = named[1], named[2], named[3]
            else:
                column, sign, wanted = columns[place], "=", condition
                place += 1
            rows = [row for row in rows if holds(row[column], sign, wanted)]
        if not rows:
            raise Wrong(f"{match['file']} has no row [{match['where']}]")
        try:
            return [float(row[match["column"]]) for row in rows]
        except ValueError as error:
            raise Wrong(f"{match[0]}: {error}") from error

    @lru_cache(maxsize=None)
    def states(self, state):
        """What the live page shows at an address, by a native program."""
        program = self.build / "tests" / "live_digits"
        if not program.is_file():
            raise Wrong("there is no program live_digits")
        result = subprocess.run([program, "--state", state], capture_output=True, text=True)
        if result.returncode:
            raise Wrong(f"{state}: {result.stderr.strip()}")
        return {name: float(value) for name, value in map(str.split, result.stdout.splitlines())}

    def live(self, state, what):
        shown = self.states(state)
        if what not in shown:
            raise Wrong(f"the live page has {', '.join(shown)} at {state}, no {what}")
        return shown[what]

    @lru_cache(maxsize=None)
    def value(self, expression, chapter, of=""):
        """What an expression is worth. With `of`, FILE[CONDITIONS], a column alone is its cell."""
        found = {}

        def take(match):
            cells = self.cells(match, chapter)
            name = f"cells{len(found)}"
            found[name] = cells if len(cells) > 1 else cells[0]
            return name

        class Columns(dict):
            def __missing__(columns, name):  # noqa: N805
                match = of and CELL.fullmatch(f"{of}.{name}")
                if not match:
                    raise KeyError(name)
                return found[take(match)]

        words = CELL.sub(take, expression)
        known = {**FUNCTIONS, "live": self.live, "exercises": exercises_of, "words": words_of,
                 "questions": questions_of, "lines": lines_of, "hours": hours_of,
                 "printed": lambda what: printed(self.run(chapter, "")[1], what)}
        try:
            return float(eval(words, {"__builtins__": {}}, Columns(known | found)))
        except Wrong:
            raise
        except Exception as error:
            many = [words for words in found.values() if isinstance(words, list)]
            why = f"{len(many[0])} rows, where one is wanted" if many else error
            raise Wrong(f"{expression}: {why}") from error


def holds(cell, sign, wanted):
    try:
        a, b = float(cell), float(wanted)
    except ValueError:
        a, b = cell, wanted
        if sign not in ("=", "!="):
            return False
    if isinstance(a, float) and sign in ("=", "!="):
        same = math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-12)
        return same == (sign == "=")
    return {"=": a == b, "!=": a != b, ">": a > b, "<": a < b, ">=": a >= b, "<=": a <= b}[sign]


def exercises_of(number):
    return len(house.chapter_of(str(number)).ids())


def text_of(number):
    text = house.chapter_of(str(number)).text.read_text(encoding="utf-8")
    return re.sub(r"<!--.*?-->", "", text, flags=re.S)


def words_of(number):
    """Outside folds, code and formulas in blocks."""
    text = re.sub(r"<details>.*?</details>|^```.*?^```", "", text_of(number), flags=re.S | re.M)
    return len(text.split())


def questions_of(number):
    part = text_of(number).partition("\n## Questions\n")[2].partition("\n## ")[0]
    return len(re.findall(r"^\d+\. ", part, re.M))


def lines_of(number):
    """Of the answers in the solution, without comments."""
    text = exercises.read(house.chapter_of(str(number)).solution)
    return sum(bool(line.split("//")[0].strip()) for region in exercises.regions(text)
               for line in region.answer())


def hours_of(number=None):
    """In halves."""
    if number is None:
        return sum(hours_of(chapter.number) for chapter in house.chapters())
    time = words_of(number) / 1500 + exercises_of(number) / 2 + questions_of(number) / 6
    return round(2 * time) / 2


def printed(text, what):
    match = re.search(what, text)
    if not match:
        raise Wrong(f"the program does not print {what}")
    return float(match[1])


def several(function):
    return lambda cells: function(cells if isinstance(cells, list) else [cells])


FUNCTIONS = {
    "first": several(lambda a: a[0]), "last": several(lambda a: a[-1]),
    "max": several(max), "min": several(min), "count": several(len),
    "mean": several(lambda a: sum(a) / len(a)),
    "rms": several(lambda a: math.sqrt(sum(x * x for x in a) / len(a))),
    "abs": abs, "sqrt": math.sqrt, "log": math.log, "exp": math.exp, "cos": math.cos,
    "sin": math.sin, "atan": math.atan, "pi": math.pi,
}
