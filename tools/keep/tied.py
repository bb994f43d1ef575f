"""Numbers of a text that come from a run: as the text states them, and as the run gives them.

Behind the last line of a paragraph, a list or a table stands a comment that no reader sees:

    <!-- tied: 42 = 100 * driven.csv[S4l, blocks apart, 1].overshoot_deg / 60; 9;
    3.5|9 = bounds.csv[10|30].gap_mm -->

It names numbers of the lines above it, back to an empty line or another such comment: as they are
shown and in their order, each with its expression (values.py says what may stand in it). `10|30`
within brackets makes one for each of several numbers. Numbers that equal a named one are all named,
those that come from no run without an expression, as the first 9 here. A number counts as right if
it is the value rounded to the digits that are shown. Tables of measured numbers are made whole, see
tabled.py.
"""
import math
import os
import re
from dataclasses import dataclass

from keep.values import Wrong

TIED = re.compile(r"(?P<above>(?:^[ >]*[^ >\n].*\n)+?)"
                  r"[ >]*<!-- tied:(?P<named>(?:[^-]|-(?!->))*)-->$", re.M)
NUMBER = re.compile(
    r"(?<![\w.^{/])(?P<sign>[-−+]?)(?P<digits>\d{1,3}(?:,\d{3})+(?:\.\d+)?|\d+(?:\.\d+)?)"
    r"(?:\s*\\cdot\s*10\^\{?(?P<power>-?\d+)\}?)?(?![\w{^])"
    r"|(?<![\w.\\^{])10\^\{?(?P<ten>-?\d+)\}?")
CHOICES = re.compile(r"(?<=[\[,=])[^\[\],=]*\|[^\[\],]*")
LIVE = re.compile(r"""live\("([^"]*)",\s+"(\w+)"\)""")
LIVE_LINK = re.compile(r"\]\([./\w]*docs/live/README\.md\?([^)\s]+)\)")


@dataclass
class Tie:
    """A number of a text and the expression that it is tied to."""
    place: int   # in the text
    shown: str   # as the text has it
    said: float  # what that means
    unit: float  # of its last digit
    named: tuple  # (place, number) in the comment
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


def named_in(comment):
    """((place, number), expression or "") of every number that a comment names."""
    words = re.sub(r"\n[ >]*", lambda lead: " " * len(lead[0]), comment["named"])
    for entry in re.finditer(r"[^;]+", words):
        head, _, tail = entry[0].partition(" = ")
        numbers = list(re.finditer(r"[^ |](?:[^|]*[^ |])?", head))
        choices = {group.count("|") + 1 for group in CHOICES.findall(tail)} or {1}
        if tail and choices != {len(numbers)}:
            raise Wrong(f"{len(numbers)} numbers, {max(choices)} expressions: {entry[0].strip()}")
        for n, number in enumerate(numbers):
            one = CHOICES.sub(lambda group, n=n: group[0].split("|")[n].strip(), tail)
            place = comment.start("named") + entry.start() + number.start()
            yield (place, number[0]), " ".join(one.split())


def meant(names, shown):
    """Which numbers the names are: all that equal one. One may have a digit changed by hand."""
    names, shown = ([" ".join(number.split()) for number in these] for these in (names, shown))
    readings = [shown] + [[*shown[:n], name, *shown[n + 1:]] for n, number in enumerate(shown)
                          for name in {*names} if len(name) == len(number)
                          and sum(map(str.__ne__, name, number)) == 1]
    which = [[n for n, number in enumerate(reading) if number in names] for reading in readings]
    fitting = [found for found, reading in zip(which, readings)
               if [reading[n] for n in found] == names]
    if len(fitting) == 1:
        return fitting[0]
    equal = [shown[n] for n in which[0]]
    n = len(os.path.commonprefix([names, equal]))
    name, number = ([*these, "nothing"][n] for these in (names, equal))
    raise Wrong(f"the lines above have {number} where number {n + 1} of this comment is {name}: "
                "name all that are tied, and all that equal one, in their order")


def ties_of(text):
    """(line, tie) of all ties of a text, in their order; a fault instead of a tie is a Wrong."""
    astray = [comment.start() for comment in re.finditer(r"<!--\s*(?:tied|=)", text)]
    for comment in TIED.finditer(text):
        astray = [place for place in astray if not comment.end("above") <= place < comment.end()]
        numbers = list(NUMBER.finditer(blanked(comment["above"])))
        try:
            named = list(named_in(comment))
            which = meant([name for (_, name), _ in named], [number[0] for number in numbers])
        except Wrong as wrong:
            yield text.count("\n", 0, comment.end("above")) + 1, wrong
            continue
        for n, (name, expression) in zip(which, named):
            place = comment.start() + numbers[n].start()
            if expression:
                yield text.count("\n", 0, place) + 1, Tie(
                    place, numbers[n][0], *value_of(numbers[n]), name, expression)
    for place in astray:
        yield text.count("\n", 0, place) + 1, Wrong(
            "a comment that ties numbers has lines of its own, right behind those of the numbers")


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
        again = tie.shown
        if not abs(value - tie.said) <= 0.5000001 * tie.unit + 1e-12 * abs(value):
            paragraph = text[text.rfind("\n\n", 0, tie.place) + 1:tie.place]
            again = shown_again(tie.shown, value, "-" if paragraph.count("$") % 2 else "−")
        if not again.split() == tie.shown.split() == tie.named[1].split():
            changes.append((line, f"says {tie.shown}, but {tie.expression} is {value:.6g}: "
                            f"now {again}"))
            new += [(tie.place, tie.shown, again), (*tie.named, again)]
    for place, old, again in sorted(new, reverse=True):
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
