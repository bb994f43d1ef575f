"""Known answers of the exercises: tests/NN_name/answers/N.M.cpp.

    // wrong sign-of-gravity: v += ==> v -=      words of the solution ==> those in their place,
    //         ;; settings.h ==> real(1) / 60    and once more, on the same line or below
    // wrong forces-last:                        or lines that take the place of all of it
      the lines
    // right added in place: h * ==> h +=
    // wrong units "h is missing": h * ==>       as one whose numbers carry units
    // mistake "the sign of gravity": v += ==> v -=

A mistake is a wrong answer that a check knows: it is compiled as a function of its own, a check
runs it on its cases, and where it gives a reader's numbers its sentence stands in the report
(tests/checker/known.h). Of mistakes with the same numbers the first is told; the slips of slips.py
come after everything else that may be told. The sentence may be continued on lines like those of a
change. A heading with {1|2} in it, or {x|y|z}, stands for as many answers, one with the first of
them in every place, and so on.

Other wrong answers name what they must be told: a diagnosis by its id, "#sign-of-gravity the sign
of gravity" in the checker, `a + b` where it is told two; or "words of the report", where these are
put together. So do those that crash or do not end. It is looked for in the report that a reader
sees first. Poses may follow: sign (turned, moved). Below a heading:

    // tests: 1.5                                those of 1.5 judge it; its own find it right
    // expects: words                            which some report of it has, too

`// region 2` stands above the answers that belong to the second of the regions that share the id,
`// from right in two lines` above those that change this right answer rather than the solution.

All answers of a chapter become one source: in each region `if (chosen == k) {answer} else
{solution}`. The choice comes from the environment, see tests/checker/chosen.h.
"""
import hashlib
import json
import re
import sys
from collections import Counter
from dataclasses import dataclass, field, replace
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import exercises  # noqa: E402
from check import slips  # noqa: E402

HEADING = re.compile(r'// (wrong units|wrong|right|mistake) ("[^"]+"|[^":]+):(?: +(\S.*))?$')
OPEN = re.compile(r'// (mistake|wrong|wrong units) "[^"]*$')  # a sentence that goes on below
NAMED = re.compile(r"([a-z0-9-]+(?: \+ [a-z0-9-]+)*)(?: \((.+)\))?$")  # a diagnosis, by its ids
MORE = re.compile(r"// {7,}(\S.*)$")  # of changes that take more than a line
EACH = re.compile(r"\{(?! )([^{}|]*(?:\|(?! )[^{}|]*)+)(?<! )\}")  # of several answers, see above
DIAGNOSIS = re.compile(r"#([a-z0-9-]+) +(\S.*)", re.S)  # a text of a table of mistakes
TEXT = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
STUB = "stub"  # the choice that leaves every exercise unwritten


@dataclass
class Answer:
    """One known answer and its promises."""
    id: str
    kind: str
    told: str                                     # what the heading names
    file: Path
    line: int                                     # of its heading
    region: int = 1                               # which of the regions that share the id
    base: str = ""                                # the right answer that it changes
    again: int = 1                                # it is so many-th of those with this heading
    tests: str = ""                               # the exercise that finds it out, not its own
    promises: list = field(default_factory=list)  # (line, words)
    body: list = field(default_factory=list)
    changes: str = ""                             # "words of the solution ==> others ;; ..."
    first: int = 0                                # the line of the file where the body begins
    faults: list = field(default_factory=list)    # (line, words): why it cannot be judged

    @property
    def name(self):
        told = self.told.strip('"')
        return f"{self.id} {self.kind}: {told}" + (f" {self.again}" if self.again > 1 else "")

    def ids(self):
        """Of the diagnoses that it must be told."""
        named = self.kind == "wrong" and NAMED.match(self.told)
        return named[1].split(" + ") if named else []

    def key(self):
        """Changes when the answer does."""
        words = "\n".join([self.id, str(self.region), *self.body])
        return hashlib.sha1(words.encode()).hexdigest()

    def placed(self):
        """The body with its places in the file: all that is changed from the solution stands where
        the heading does."""
        if not self.changes:
            return [f'#line {self.first} "{self.file}"', *self.body]
        return [part for line in self.body for part in (f'#line {self.first} "{self.file}"', line)]

    def last(self):
        """The line of the file behind the body."""
        return self.first + (1 if self.changes else len(self.body))


def read(path, regions):
    """The answers of one file, each with its faults. `regions`: the solution's lines in each of
    those that its exercise has."""
    found, region, base = [], 1, ""
    for number, line in headed(path.read_text().rstrip("\n").split("\n")):
        answer = found[-1] if found else None
        if match := HEADING.match(line):
            answer = Answer(path.stem, match[1], match[2], path, number, region, base)
            answer.changes = match[3] or ""
            found.append(answer)
        elif match := re.match(r"// region (\d+)$", line):
            region, base = int(match[1]), ""
        elif match := re.match(r"// from right (\S.*)$", line):
            base = match[1]
        elif answer is None:
            if line.strip():
                answer = Answer(path.stem, "wrong", "no-heading", path, number)
                answer.faults.append((number, "this stands before the first heading, "
                                      "'// wrong id:' or right or wrong units"))
                found.append(answer)
        elif match := re.match(r"// expects: (\S.*)$", line):
            answer.promises.append((number, match[1].strip()))
        elif match := re.match(r"// tests: (\d+\.\d+)$", line):
            answer.tests = match[1]
        elif not answer.body and (match := MORE.match(line)):
            answer.changes += " " + match[1]
        elif line.startswith("//") or answer.changes and line.strip():
            answer.faults.append((number, f"'{line.strip()}' is neither a heading, '// wrong id:' "
                                          "or right or wrong units, nor one of the lines that may "
                                          "stand below it; comments of an answer are indented"))
        else:
            answer.first = answer.first or number
            answer.body.append(line)
    found = [one for answer in found for one in each(answer)]
    again = Counter()
    for one in found:
        again[one.name] += 1
        one.again = again[one.name]
        change(one, regions, found)
        faults_of(one, len(regions))
    return found


def headed(lines):
    """The lines with their numbers; a heading's sentence on one line."""
    whole = []
    for number, line in enumerate(lines, 1):
        if whole and OPEN.match(whole[-1][1]) and (match := MORE.match(line)):
            whole[-1] = (whole[-1][0], f"{whole[-1][1]} {match[1]}")
        else:
            whole.append((number, line))
    return whole


def each(answer):
    """The answers for which a heading stands."""
    words = (answer.told, answer.changes)
    counts = {match[1].count("|") + 1 for text in words for match in EACH.finditer(text)}
    if len(counts) > 1:
        answer.faults.append((answer.line, "{a|b} in one place, {a|b|c} in another"))
    if len(counts) != 1:
        return [answer]
    return [replace(answer, **dict(zip(("told", "changes"), chosen)), body=answer.body[:],
                    faults=[])
            for chosen in zip(*([EACH.sub(lambda match: match[1].split("|")[k], text)
                                 for k in range(*counts)] for text in words))]


def change(answer, regions, found):
    """Makes the body of an answer that changes the solution, or a right answer found above it."""
    while answer.body and not answer.body[-1].strip():
        answer.body.pop()
    if not answer.changes or not 1 <= answer.region <= len(regions):
        return
    answer.first = answer.line
    above = {"": regions[answer.region - 1]}
    above |= {one.told: one.body for one in found
              if one.kind == "right" and one.region == answer.region and one.line < answer.line}
    if answer.base not in above:
        answer.faults.append((answer.line, f"no right answer '{answer.base}' stands above it"))
        return
    text = "\n".join(above[answer.base])
    for words in answer.changes.split(" ;; "):
        old, arrow, new = (part.strip() for part in f"{words} ".partition(" ==> "))
        place = re.search(r"\s+".join(map(re.escape, old.split())), text) if old else None
        if not arrow or not place:
            answer.faults.append((answer.line, f"{answer.base or 'the solution'} has no '{old}'"))
            continue
        text = text[:place.start()] + new + text[place.end():]
    answer.body = text.split("\n")


def faults_of(answer, regions):
    """Adds what is wrong with an answer on paper."""
    if not answer.body:
        answer.faults.append((answer.line, "the answer is empty"))
    if answer.kind != "right" and answer.told[0] != '"' and not answer.ids():
        answer.faults.append((answer.line, f"'{answer.told}' is neither an id nor words in quotes"))
    if answer.kind == "mistake" and answer.tests:
        answer.faults.append((answer.line, "a mistake is found by the tests of its own exercise"))
    if answer.kind == "right" and answer.promises:
        answer.faults.append((answer.promises[0][0], "a right answer expects no report"))
    if not 1 <= answer.region <= regions:
        answer.faults.append((answer.line, f"exercise {answer.id} has no region {answer.region}"))
    if answer.tests == answer.id or answer.tests and answer.kind == "wrong units":
        answer.faults.append((answer.line, "'// tests:' names another exercise than its own; units "
                                           "are asked of its own alone"))
    depth = 0
    code = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'|//[^\n]*', "", "\n".join(answer.body))
    for k, line in enumerate(code.split("\n")):
        for letter in line:
            depth += (letter == "{") - (letter == "}")
        if depth < 0:
            break
    if depth:
        answer.faults.append((answer.first + k, "the braces { } of this answer do not match"))


def diagnoses(folder):
    """What can be told by its id in the sources of a folder: [(id, wording)]; and how often each
    text stands in a source: {(source, text): times}."""
    told, texts = [], Counter()
    for path in sorted(path for path in Path(folder).glob("*.*") if path.suffix in (".h", ".cpp")):
        code = re.sub(r"^\s*(#.*|//.*)$", "", path.read_text(), flags=re.M)
        for match in re.finditer(rf"{TEXT.pattern}(?:\s*{TEXT.pattern})*", code):
            text = "".join(TEXT.findall(match[0]))
            if named := DIAGNOSIS.match(text):
                told.append((named[1], named[2]))
                text = named[2]
            texts[path.name, text] += 1
    return told, texts


def without_ids(words):
    """What a reader sees."""
    return re.sub(r"#[a-z0-9-]+ ", "", words)


def files_of(chapter_folder, root):
    return sorted((Path(root) / "tests" / chapter_folder / "answers").glob("*.cpp"))


def read_all(files, solution_text):
    """All answers of a chapter's files."""
    regions = {}
    for region in exercises.regions(solution_text):
        regions.setdefault(region.id, []).append(region.answer())
    return [answer for path in files for answer in read(Path(path), regions.get(path.stem, []))]


# ---- the source that holds them all --------------------------------------------------------------

def returns_nothing(lines, begin):
    """True when the function around a line is void: its head is the last line not indented."""
    head = next(line for line in reversed(lines[:begin]) if re.match(r"\w", line))
    return head.startswith("void ")


def make(solution, files, units, out, root):
    """Writes one source of all answers of these files that belong to numbers, or to units. Those
    that the compiler has refused, listed beside `out`, are left out."""
    text = Path(solution).read_text()
    lines, shown = text.split("\n"), Path(solution).relative_to(root)
    refused = refused_of(out)
    chosen = [a for a in read_all(files, text) if (a.kind == "wrong units") == units
              and not a.faults and a.key() not in refused]

    def branches(region, place):
        before = lines[region.begin:region.begin + len(region.task())]
        answer_at = region.begin + len(before) + 1
        last = lines[region.end + 1].strip() == "}" and not returns_nothing(lines, region.begin)
        made = before + [f'  if (chosen == 0) todo("{region.id}");']
        for k, one in enumerate(chosen, 1):
            if (one.id, one.region) == (region.id, place):
                made += [f"  else if (chosen == {k}) {{", *one.placed()]
                made += [f'  testing::no_return("{one.file}:{one.line}");'] * last + ["  }"]
        return made + ["  else {", f'#line {answer_at} "{root}/{shown}"', *region.answer(),
                       "  }", f'#line {region.end + 1} "{root}/{shown}"']

    names = [STUB] + [one.name for one in chosen]
    table = ",\n  ".join(json.dumps(name, ensure_ascii=False) for name in names)
    head = ["// Made by tools/check/answers.py.",
            '#include "tests/checker/chosen.h"', "namespace {",
            "const int chosen = joints::testing::chosen_answer({", f"  {table}}});", "}",
            f'#line 1 "{root}/{shown}"']
    exercises.write_if_new(out, "\n".join(head) + "\n" + exercises.replace(text, branches))


# ---- the source of the mistakes that a check knows -----------------------------------------------

def around(lines, region):
    """What a template's parameter is, in double, and the lines of the function around a region,
    before and behind it."""
    begin = max(k for k in range(region.begin) if re.match(r"\w", lines[k]))
    end = lines.index("}", region.end)
    number = re.match(r"template <class (\w+)>$", lines[begin - 1])
    return ([f"using {number[1]} = real;"] if number else [], lines[begin:region.begin - 1],
            lines[region.end + 1:end + 1])


def of_member(before):
    """A member function as one of a struct that is derived from its own: the declaration, the lines
    with this name, a plain function that is given the part first, and what that is called. One that
    changes its part returns it."""
    head = re.match(r"(.*?) (\w+)::(\w+)\((.*?)\)( const)? \{", " ".join(before))
    if not head:
        return [], before, [], re.search(r"(\w+)\(", " ".join(before))[1]
    result, part, name, parameters, const = head.groups()
    names = ", ".join(re.findall(r"(\w+)(?:,|$)", parameters))
    declared = [f"struct Mistaken : {part} {{ {result} {name}({parameters}){const or ''}; }};"]
    called = [f"{result} does(const {part}& part, {parameters}) {{ "
              f"return Mistaken{{part}}.{name}({names}); }}"] if const else \
             [f"{part} does(const {part}& part, {parameters}) {{ "
              f"Mistaken one{{part}}; one.{name}({names}); return one; }}"]
    return declared, [line.replace(f"{part}::", "Mistaken::", 1) for line in before], called, "does"


def make_mistakes(solution, files, out, root, refused):
    """Writes one source of all mistakes of these files, each a function in a namespace of its own;
    what it calls is the reader's."""
    text = Path(solution).read_text()
    lines, shown = text.split("\n"), Path(solution).relative_to(root)
    regions, made, table = {}, [], []
    for region in exercises.regions(text):
        regions.setdefault(region.id, []).append(region)
    known = [a for a in read_all(files, text) if a.kind == "mistake"
             and not a.faults and a.key() not in refused]
    more = [Answer(id_, "mistake", words, Path("slip"), 1, place, body=body, first=1)
            for id_, place, words, body in slips.said(text)]
    for k, one in enumerate(known + more, 1):
        given, before, behind = around(lines, regions[one.id][one.region - 1])
        declared, before, called, name = of_member(before)
        made += [f"namespace mistake_{k} {{", *given, *declared, f'#line 1 "{root}/{shown}"',
                 *before, *one.placed(), f'#line 1 "{root}/{shown}"', *behind, *called, "}"]
        words = json.dumps(one.told.strip('"'), ensure_ascii=False)
        slip = "true" if k > len(known) else "false"
        table.append(f'  {{"{one.id}", {one.region}, {words}, &joints::mistake_{k}::{name}, '
                     f'{slip}}},')
    head = ["// Made by tools/check/answers.py."]
    if made:
        includes = re.findall(r"^#.*", text.partition("namespace joints")[0], re.M)
        head += ['#include "tests/checker/known.h"', '#include "tests/checker/slips.h"', *includes,
                 "namespace joints {", *made, "}",
                 "static const joints::testing::Known known[] = {", *table, "};"]
    exercises.write_if_new(out, "\n".join(head) + "\n")


def refused_of(out):
    """{key: (line, what the compiler said)} of the answers that an earlier build refused."""
    path = Path(f"{out}.refused.json")
    return json.loads(path.read_text()) if path.exists() else {}


def refuse(out, answers, log):
    """Notes the answers whose lines the compiler complains of, so that the next build leaves them
    out. Returns how many are new."""
    refused = refused_of(out)
    before = len(refused)
    for block in re.split(r"^FAILED: ", log, flags=re.M):
        error = re.search(r"\berror: (.*)", block)
        if not error:
            continue
        for one in answers:
            places = re.findall(rf"{re.escape(one.file.name)}:(\d+):", block) \
                if str(one.file) in block else []
            for number in map(int, places):
                if one.first <= number < one.last() and one.key() not in refused:
                    refused[one.key()] = (number, error_at(block, one.file, number) or error[1])
    Path(f"{out}.refused.json").write_text(json.dumps(refused))
    return len(refused) - before


def error_at(block, file, number):
    match = re.search(rf"{re.escape(str(file))}:{number}:.*?error: (.*)", block)
    return match[1] if match else ""


def main(arguments):
    """answers.py numbers|units|mistakes ROOT SOLUTION OUT ANSWERS..."""
    if len(arguments) < 4 or arguments[0] not in ("numbers", "units", "mistakes"):
        print(main.__doc__, file=sys.stderr)
        return 2
    kind, root, solution, out, *files = arguments
    paths = [Path(f) for f in files]
    try:
        if kind == "mistakes":
            make_mistakes(Path(solution), paths, Path(out), Path(root),
                          refused_of(out.replace("_mistakes.cpp", "_numbers.cpp")))
        else:
            make(Path(solution), paths, kind == "units", Path(out), Path(root))
    except (exercises.Broken, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
