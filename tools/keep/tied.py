"""Numbers of a text that come from a run: what the text says they are, and what they are.

Behind a number, or behind several, a text has a comment that no reader sees:

    42 %<!-- = 100 * driven.csv[S4l, blocks apart, 1].overshoot_deg / 60 -->

An expression stands for one number; several are parted by semicolons and stand for as many numbers
before the comment, in their order. `FILE[CONDITIONS].COLUMN` is a cell of a table: of the chapter
that the text belongs to, of another (`06/beta.csv`), of a run with options
(`03 --iterations 300/curl.csv`), or of a table that is kept (`bench/peers.csv`). A condition is the
value of the next column, or `column=value`, `column>=value` and so on; `10|30|100` stands for three
expressions (in a row of a table `10\\|30\\|100`: a bare bar would begin a cell there). A selection
of more than one row goes into first, last, max, min, mean, rms, count.
`printed("limits (\\d+) of 4")` is what the chapter's program says on the terminal.
`live("scene=chain&t=3", "gap")` is what the live page shows at this address: gap [m], energy [J],
or within a step error and first_error [m/s]. A number counts as right if it is the value rounded to
the digits that the text shows. `<!-- given -->` marks numbers that are chosen, not found.
"""
import csv
import math
import re
import subprocess
from dataclasses import dataclass
from functools import lru_cache

from base import house

COMMENT = re.compile(r"<!--\s*=\s*(.*?)-->", re.S)
TIED = re.compile(r"<!--\s*(?:=.*?|given\s*)-->", re.S)
NUMBER = re.compile(
    r"(?<![\w.^{/])(?P<sign>[-−+]?)(?P<digits>\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+(?:\.\d+)?)"
    r"(?:\s*\\cdot\s*10\^\{?(?P<power>-?\d+)\}?)?(?![\w{^])"
    r"|(?<![\w.\\^{])10\^\{?(?P<ten>-?\d+)\}?")
CHAPTER = r"(?<![\w.])\d\d(?: --[a-z-]+ [\w.]+)*/"  # with options of its program
CELL = re.compile(rf"(?P<file>(?:{CHAPTER}|[a-z]+(?:/[a-z]+)*/)?\w+\.csv)"
                  r"\[(?P<where>[^\]]*)\]\.(?P<column>\w+)")
LIVE = re.compile(r"""live\("([^"]*)",\s+"(\w+)"\)""")
LIVE_LINK = re.compile(r"\]\([./\w]*docs/live/README\.md\?([^)\s]+)\)")
CONDITION = re.compile(r"^(\w+)\s*(>=|<=|!=|=|>|<)\s*(.+)$")


class Wrong(Exception):
    """What is wrong with an expression or with the table that it names."""


@dataclass
class Tie:
    """A number of a text and the expression that it is tied to."""
    line: int    # of the number
    shown: str   # as the text has it
    said: float  # what that means
    unit: float  # of its last digit
    expression: str


# ---- the text ------------------------------------------------------------------------------------

def value_of(match):
    """(what a number of a text means, one unit of its last digit)."""
    if match["ten"]:
        return 10.0 ** int(match["ten"]), 10.0 ** int(match["ten"])
    digits = match["digits"].replace(",", "")
    scale = 10.0 ** int(match["power"] or 0)
    unit = 10.0 ** -len(digits.partition(".")[2])
    sign = -1 if match["sign"] in ("-", "−") else 1
    return sign * float(digits) * scale, unit * scale


def expressions_of(comment):
    """One expression for each number; a|b stands for two."""
    for part in " ".join(comment.split()).split(";"):
        choices = [[choice.strip() for choice in group.split("|")]
                   for group in re.findall(r"(?<=[\[,=])[^\[\],=]*\|[^\[\],]*", part)]
        count = max(map(len, choices), default=1)
        if any(len(choice) != count for choice in choices):
            raise Wrong(f"not as many choices everywhere: {part.strip()}")
        for n in range(count):
            yield re.sub(r"(?<=[\[,=])[^\[\],=]*\|[^\[\],]*",
                         lambda group, n=n: group[0].split("|")[n].strip(), part).strip()


def ties_of(text):
    """All ties of a text, in their order; a fault instead of a tie is a Wrong."""
    for comment in COMMENT.finditer(text):
        begin = max([0, *(m.end() for m in TIED.finditer(text, 0, comment.start()))])
        numbers = list(NUMBER.finditer(blanked(text[begin:comment.start()])))
        line = text.count("\n", 0, comment.start()) + 1
        in_row = text[text.rfind("\n", 0, comment.start()) + 1] == "|"
        try:
            if not text[text.rfind("\n", 0, comment.start()) + 1:comment.start()].strip():
                raise Wrong("a comment that begins a line ends the formulas of its paragraph: "
                            f"put it behind a word: {comment[1].strip()}")
            if in_row and re.search(r"(?<!\\)\|", comment[1]):
                raise Wrong(f"a bar begins a cell of the table, write \\|: {comment[1].strip()}")
            expressions = list(expressions_of(comment[1].replace("\\|", "|")))
            if len(expressions) > len(numbers):
                raise Wrong(f"{len(expressions)} expressions for {len(numbers)} numbers: "
                            f"{comment[1].strip()}")
        except Wrong as wrong:
            yield line, wrong
            continue
        for match, expression in zip(numbers[len(numbers) - len(expressions):], expressions):
            said, unit = value_of(match)
            at = text.count("\n", 0, begin + match.start()) + 1
            yield at, Tie(at, match[0].strip(), said, unit, expression)


def blanked(text):
    """Numbers that are names go, and nothing changes its place."""
    names = r"`[^`]*`|\]\([^)]*\)|\bEqs?\. [\d-]+|\b(?:T|E|I|X|S)\s?\d[\d.a-z]*\b|<!--.*?-->"
    return re.sub(names, lambda match: re.sub(r"[^\n]", "x", match[0]), text, flags=re.S)


# ---- the tables ----------------------------------------------------------------------------------

class Tables:
    """The tables of the programs that are in `build`, made when they are asked for."""

    def __init__(self, root, build):
        self.root, self.build = root, build

    @lru_cache(maxsize=None)
    def run(self, number, options):
        """(folder of the tables, what was printed) of a chapter's program."""
        chapter = next((c for c in house.chapters() if c.number == number), None)
        program = chapter and self.build / f"{chapter.folder}_run"
        if not program or not program.is_file():
            raise Wrong(f"there is no program of chapter {number}")
        folder = self.build / "numbers" / (chapter.folder + "".join(options.split()))
        printed = folder / "printed.txt"
        if not printed.is_file() or printed.stat().st_mtime < program.stat().st_mtime:
            folder.mkdir(parents=True, exist_ok=True)
            result = subprocess.run([program, *options.split(), "--out", folder],
                                    capture_output=True, text=True)
            if result.returncode:
                raise Wrong(f"{program.name} {options}: {result.stderr.strip()}")
            printed.write_text(result.stdout, encoding="utf-8")
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

    def value(self, expression, chapter):
        """What an expression is worth."""
        found = {}

        def take(match):
            cells = self.cells(match, chapter)
            name = f"cells{len(found)}"
            found[name] = cells if len(cells) > 1 else cells[0]
            return name

        words = CELL.sub(take, expression)
        try:
            result = eval(words, {"__builtins__": {}}, {**FUNCTIONS, **found, "live": self.live,
                          "printed": lambda what: printed(self.run(chapter, "")[1], what)})
            return float(result)
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


# ---- the comparison ------------------------------------------------------------------------------

def faults_of(text, chapter, tables):
    """(line, words) of every number of a text that is not what it is tied to."""
    for line, tie in ties_of(text):
        if isinstance(tie, Wrong):
            yield line, str(tie)
            continue
        try:
            value = tables.value(tie.expression, chapter)
        except Wrong as wrong:
            yield line, f"{tie.shown}: {wrong}"
            continue
        if not abs(value - tie.said) <= 0.5000001 * tie.unit + 1e-12 * abs(value):
            yield line, f"says {tie.shown}, but {tie.expression} is {value:.6g}"
