"""Numbers of a text that come from a run: as the text states them, and as the run gives them.

Behind a number, or behind several, a text has a comment that no reader sees:

    42 %<!-- = 100 * driven.csv[S4l, blocks apart, 1].overshoot_deg / 60 -->

An expression (values.py says what may stand in it) stands for one number; several are parted by
semicolons and stand for as many numbers before the comment, in their order. `10|30|100` within
brackets stands for three expressions. A number counts as right if it is the value rounded to the
digits that the text shows. `<!-- given -->` marks numbers that are chosen, not found. Tables of
measured numbers are made whole, see tabled.py.
"""
import math
import re
from dataclasses import dataclass

from keep.values import Wrong

COMMENT = re.compile(r"<!--\s*=\s*(.*?)-->", re.S)
TIED = re.compile(r"<!--\s*(?:=.*?|given\s*)-->", re.S)
NUMBER = re.compile(
    r"(?<![\w.^{/])(?P<sign>[-−+]?)(?P<digits>\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+(?:\.\d+)?)"
    r"(?:\s*\\cdot\s*10\^\{?(?P<power>-?\d+)\}?)?(?![\w{^])"
    r"|(?<![\w.\\^{])10\^\{?(?P<ten>-?\d+)\}?")
LIVE = re.compile(r"""live\("([^"]*)",\s+"(\w+)"\)""")
LIVE_LINK = re.compile(r"\]\([./\w]*docs/live/README\.md\?([^)\s]+)\)")


@dataclass
class Tie:
    """A number of a text and the expression that it is tied to."""
    line: int    # of the number
    place: int   # in the text
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
            shown = match[0].strip()
            place = begin + match.start() + match[0].index(shown)
            at = text.count("\n", 0, place) + 1
            yield at, Tie(at, place, shown, said, unit, expression)


def blanked(text):
    """Numbers that are names go, and nothing changes its place."""
    names = r"`[^`]*`|\]\([^)]*\)|\bEqs?\. [\d-]+|\b(?:T|E|I|X|S)\s?\d[\d.a-z]*\b|<!--.*?-->"
    return re.sub(names, lambda match: re.sub(r"[^\n]", "x", match[0]), text, flags=re.S)


# ---- the comparison ------------------------------------------------------------------------------

def renewed(text, chapter, tables):
    """(the text with every number as its tie has it, [(line, words)] of changes, of faults)."""
    changes, faults, new = [], [], []
    for line, tie in ties_of(text):
        if isinstance(tie, Wrong):
            faults.append((line, str(tie)))
            continue
        try:
            value = tables.value(tie.expression, chapter)
        except Wrong as wrong:
            faults.append((line, f"{tie.shown}: {wrong}"))
            continue
        if not abs(value - tie.said) <= 0.5000001 * tie.unit + 1e-12 * abs(value):
            paragraph = text[text.rfind("\n\n", 0, tie.place) + 1:tie.place]
            again = shown_again(tie.shown, value, "-" if paragraph.count("$") % 2 else "−")
            changes.append((line, f"says {tie.shown}, but {tie.expression} is {value:.6g}: "
                            f"now {again}"))
            new.append((tie.place, tie.shown, again))
    for place, old, again in reversed(new):
        text = text[:place] + again + text[place + len(old):]
    return text, changes, faults


def shown_again(shown, value, minus):
    """A value as a text shows a number: with as many decimals, but at least one digit."""
    match = NUMBER.fullmatch(shown)
    size = abs(value)
    exponent = math.floor(math.log10(size)) if size else 0
    if match["ten"]:
        return f"10^{{{round(math.log10(size))}}}"
    decimals = len(match["digits"].partition(".")[2])
    sign = (match["sign"] if match["sign"] in tuple("-−") else minus) if value < 0 else \
        "+" if match["sign"] == "+" else ""
    if match["power"]:
        mantissa = f"{size / 10 ** exponent:.{decimals}f}"
        if float(mantissa) == 10:
            mantissa, exponent = f"{1:.{decimals}f}", exponent + 1
        return f"{sign}{mantissa} \\cdot 10^{{{exponent}}}"
    if size and float(f"{size:.{decimals}f}") == 0:
        decimals = -exponent
    comma = "" if re.match(r"\d{4}", match["digits"]) else ","
    return f"{sign}{size:{comma}.{decimals}f}"
