"""Tables of measured numbers in the texts, made from a short description that stands before them.

    <!-- table of bench/measured/methods.csv[$1, double, $2]
    Scene
    Method
    RMS [mm]      | {1000 * gap_rms_m : 2}
    largest [mm]  | {1000 * gap_max_m : 2, lost > 10000}

    chain of 20 hinges | 30 iterations           <- chain of 20 | si30
                       | 4 substeps of 8         <- chain of 20 | 4x8
    -->
    | ... the rows, which nobody writes by hand
    <!-- end of table -->

First the columns: a heading, what stands in its cells where a row says nothing else, and behind an
arrow what `$a`, `$b` and so on stand for (without one `$a` is the heading). Headings parted by
semicolons share their cells. Then the rows: the cells, and behind an arrow what `$1`, `$2` and so
on stand for (without one `$1` is the first cell). In braces stands an expression (values.py says
what may stand in it; with `of`, a column of that table alone is enough) and how it is shown: `2`
with two digits and all those of a whole number, below a thousandth as a power of ten; `.2` with two
decimals; `+` before it: with its sign always; `2 mm`: with a unit; `lost > 10000` behind that: this
word for larger values, `0 < 1e-9` for smaller ones. `""` is a cell without words; a line that
ends with a backslash goes on in the next.
"""
import math
import re

from keep.values import Wrong

TABLE = re.compile(r"^(?P<head><!-- table(?: of (?P<of>[^\n]+))?\n(?P<columns>.*?)\n\n(?P<rows>.*?)"
                   r"-->\n)(?P<made>.*?)^<!-- end of table -->$", re.M | re.S)
FORMAT = re.compile(r"(?P<sign>\+?)(?P<point>\.?)(?P<digits>\d+)(?P<unit> [^,]+)?"
                    r"(?P<words>(?:, \S+ [<>] [\d.e-]+)*)")
CELL = re.compile(r"\{([^{}]*?) *: *(" + re.sub(r"\?P<\w+>", "", FORMAT.pattern) + r")\}")


def shown(value, form):
    """A number as a cell shows it."""
    match = FORMAT.fullmatch(form)
    size = abs(value)
    for word, sign, limit in re.findall(r", (\S+) ([<>]) ([\d.e-]+)", match["words"]):
        if size > float(limit) if sign == ">" else size < float(limit):
            return word
    digits, unit = int(match["digits"]), match["unit"] or ""
    rounded = size if match["point"] else float(f"{size:.{digits - 1}e}")
    exponent = math.floor(math.log10(rounded)) if rounded else 0
    if exponent < -3 and not match["point"]:
        mantissa, _, power = f"{size:.0e}".partition("e")
        words = f"${mantissa} \\cdot 10^{{{int(power)}}}$"
    else:
        decimals = digits if match["point"] else max(0, digits - 1 - exponent)
        words = f"{size:,.{decimals}f}" if rounded else "0"
    sign = "" if not re.search("[1-9]", words) else "−" if value < 0 else match["sign"]
    return sign + words + unit


def lines_of(text):
    return re.sub(r"\\\n *", "", text).rstrip("\n").split("\n")


def cells_of(line):
    return [cell.strip() for cell in line.split("|")]


def rows_of(match, value):
    """The rows of a table, from its description. \\param value of an expression, of a table"""
    columns = []
    for line in lines_of(match["columns"]):
        words, _, keys = line.partition("<-")
        headings, _, template = words.partition("|")
        columns += [(heading, template.strip(), dict(zip("abcd", cells_of(keys or heading))))
                    for heading in map(str.strip, headings.split(";"))]
    yield [heading for heading, _, _ in columns]
    yield ["---"] * len(columns)
    for line in lines_of(match["rows"]):
        words, _, keys = line.partition("<-")
        cells = cells_of(words)
        cells += [""] * (len(columns) - len(cells))
        if len(cells) > len(columns):
            raise Wrong(f"{len(cells)} cells in {len(columns)} columns: {line}")
        known = dict(zip("1234", cells_of(keys or cells[0])))
        yield ["" if cell == '""' else cell_of(
            cell or template, known | of_column, match["of"], value)
               for cell, (_, template, of_column) in zip(cells, columns)]


def cell_of(words, known, of, value):
    """What stands in a cell. \\param known what $1, $a and so on stand for"""
    def put(text):
        return re.sub(r"\$([1-4a-d])", lambda key: known.get(key[1], key[0]), text)

    def shown_value(braces):
        match = CELL.fullmatch(put(braces[0]))
        return shown(value(match[1], put(of or "")), match[2]) if match else braces[0]
    return re.sub(r"\{[^{}]*\}", shown_value, words)


def renewed(text, chapter, tables):
    """(the text with its tables as they are made, [(line, words)] of changes, of faults)."""
    changes, faults, new = [], [], []
    for match in TABLE.finditer(text):
        line = text.count("\n", 0, match.start("made")) + 1
        try:
            made = ["| " + " | ".join(row) + " |" for row in rows_of(
                match, lambda expression, of: tables.value(expression, chapter, of))]
        except Wrong as wrong:
            faults.append((line - 1, f"table: {wrong}"))
            continue
        there = match["made"].rstrip("\n").split("\n")
        for n, row in enumerate(made):
            if n >= len(there) or there[n] != row:
                changes.append((line + n, f"row of a table: {row}"))
        if len(there) > len(made):
            changes.append((line + len(made), f"{len(there) - len(made)} rows too many in a table"))
        new.append((match.span("made"), "\n".join(made) + "\n"))
    for (begin, end), made in reversed(new):
        text = text[:begin] + made + text[end:]
    if text.count("<!-- table") != len(list(TABLE.finditer(text))):
        faults.append((1, "a table has no columns, no rows or no <!-- end of table -->"))
    return text, changes, faults

