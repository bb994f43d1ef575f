"""Mistakes that nobody has written down: mistakes.py ROOT BUILD --seed S --count N [--chapter C]

Each changes tokens of a solution's region, is compiled into the exercise's place as the known
answers are, and is judged by its tests. What comes of it:

    known    named by the sentence of a known answer, or by a diagnosis of the checker
    plain    ended by the tests with a plain sentence: an index outside, a loop without an end
    pointed  found wrong, where and by how much; no sentence says why
    passed   not found. Either the tests lack a case, or it is no mistake: equivalents.txt says why

Those that the compiler refuses are not counted. Names are written with --every, too: whether one
misleads must be read. Exit status 1 if a mistake passes.
"""
import argparse
import random
import re
import shlex
import subprocess
import sys
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from proofs import exercises, house

from check import answers, judging
from judge import grade as grading

TOKEN = re.compile(r'//[^\n]*|"(?:\\.|[^"\\])*"|\d[\w.]*|\w+|::|->|\+\+|--|[-+*/%&|<>=!]=|&&|\|\||\S')
PAIRS = {"(": ")", "[": "]", "{": "}"}
PARTNERS = dict(pair for a, b in (
    ("to_world", "to_local"), ("cross", "dot"), ("min", "max"), ("sin", "cos"), ("v", "w"),
    ("x", "y"), ("y", "z"), ("lower", "upper"), ("rows", "columns"), ("begin", "end"),
    ("conjugate", ""), ("inverse", ""), ("transpose", ""), ("continue", "break"),
    ("linear", "angular"), ("first", "last"), ("true", "false")) for pair in ((a, b), (b, a)))
WRAPPED = {
    "the sign": ["-({})"], "twice": ["(real(2) * ({}))"], "half": ["(real(0.5) * ({}))"],
    "int": ["real(int({}))"], "float": ["real(float({}))", "vec3(glm::vec3({}))"],
    "abs": ["glm::abs({})"], "unit": ["glm::normalize({})"],
    "small ones left out": [f"[](auto x) {{{{ return glm::length(x) < real({least}) ? real(0) * x "
                            ": x; }}({})" for least in ("1e-2", "1e-4", "1e-6", "1e-9")],
    "large ones cut off": [f"[](auto x) {{{{ return glm::length(x) > real({most}) ? x * (real({most}"
                           ") / glm::length(x)) : x; }}({})" for most in ("1e2", "1e4", "1e6")]}
LEFT = tuple(WRAPPED)[-2:]
UNITS = ("direction", "normalize")  # make unit vectors
EXCHANGED = ("[](auto a, auto b) requires (sizeof(a) > 8 && sizeof(b) > 8) {{ return b * a; }}"
             "({}, {})")
SIZE = 8  # candidates for each mistake that is wanted: the compiler refuses some


class Code:
    """The tokens of a region, and every change of them: [(kind, first, last, words)]."""

    def __init__(self, text, names):
        self.text, self.found = text, []
        self.at = [m for m in TOKEN.finditer(text) if not m[0].startswith("//")]
        self.token = [m[0] for m in self.at] + [""] * 3
        self.pair, opened = {}, []
        for k, token in enumerate(self.token):
            if token in PAIRS:
                opened.append(k)
            elif token and token in PAIRS.values():
                self.pair[k] = opened.pop()
                self.pair[self.pair[k]] = k
        for k in range(len(self.at)):
            self.operators(k)
            self.names(k, names)
        for k in range(len(self.at)):
            self.expressions(k)
        self.statements(0, len(self.at), names)

    def words(self, a, b):
        return self.text[self.at[a].start():self.at[b].end()]

    def add(self, kind, a, b, words):
        if " ".join(words.split()) != " ".join(self.words(a, b).split()):
            self.found.append((kind, a, b, words))

    def is_operand(self, k):
        """Does an operand end here?"""
        return k >= 0 and re.match(r"[\w)\]]", self.token[k]) is not None \
            and self.token[k] not in ("return", "else", "case")

    def last(self, k):
        """Of the operand that begins here."""
        while self.token[k] in ("-", "!", "*", "&"):
            k += 1
        k = self.pair.get(k, k)
        while True:
            if self.token[k + 1] in (".", "->", "::"):
                k += 2
            elif self.token[k + 1] in ("(", "["):
                k = self.pair[k + 1]
            else:
                return k

    def first(self, k):
        """Of the operand that ends here."""
        while True:
            if self.token[k] in (")", "]"):
                k = self.pair[k]
                if not self.is_operand(k - 1) or self.token[k - 1] in ("if", "for", "while"):
                    return k
                k -= 1
            elif self.token[k - 1] in (".", "->", "::") and k > 1:
                k -= 2
            else:
                return k

    def term(self, k, step):
        """The other end of a product."""
        end = self.first if step < 0 else self.last
        k = end(k)
        while self.token[k + step] in ("*", "/") and self.is_operand(k + step - 1):
            k = end(k + 2 * step)
        return k

    def operators(self, k):
        token, binary = self.token[k], self.is_operand(k - 1)
        if token in ("+", "-") and binary:
            a, b = self.term(k - 1, -1), self.term(k + 1, 1)
            left, right = self.words(a, k - 1), self.words(k + 1, b)
            self.add("the sign", k, k, "-" if token == "+" else "+")
            self.add("a term left out", a, b, left)
            self.add("a term left out", a, b, right if token == "+" else f"-{right}")
            if token == "-":
                self.add("exchanged operands", a, b, f"{right} - {left}")
            for kind in ("twice", "half"):
                self.add(kind, k + 1, b, WRAPPED[kind][0].format(right))
                self.add(kind, a, k - 1, WRAPPED[kind][0].format(left))
        elif token == "-" and self.is_operand(k + 1):
            self.add("the sign", k, k, "")
        elif token in ("*", "/") and binary:
            a, b = self.first(k - 1), self.last(k + 1)
            left, right = self.words(a, k - 1), self.words(k + 1, b)
            self.add("a factor left out", a, b, left)
            self.add("a factor left out", a, b, right if token == "*" else f"1 / {right}")
            self.add("* and /", k, k, "/" if token == "*" else "*")
            self.add("exchanged operands", a, b, EXCHANGED.format(left, right) if token == "*"
                     else f"{right} / {left}")
        elif token in ("+=", "-=", "*=", "/="):
            self.add("the sign", k, k, {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}[token])
            self.add("= for +=", k, k, "=")
        elif token in ("<", ">", "<=", ">=", "==", "!=") and binary:
            for other in {"<": "> <=", ">": "< >=", "<=": "< >=", ">=": "> <=", "==": "!=",
                          "!=": "=="}[token].split():
                self.add("another comparison", k, k, other)
        elif token in ("&&", "||"):
            self.add("and, or", k, k, "||" if token == "&&" else "&&")
        elif token == "!":
            self.add("and, or", k, k, "")
        elif re.match(r"\d", token) and not re.match(r"\w*<", self.text[:self.at[k].start()][-9:]):
            self.add("another number", k, k, "2" if token == "1" else "1")
            self.add("another number", k, k, "0")
        if token == "(" and binary and self.token[k - 1] not in ("if", "for", "while"):
            self.call(self.first(self.pair[k]), self.arguments(k), self.pair[k])

    def arguments(self, k):
        """[(first, last)] of a call whose bracket opens here."""
        found, begin, end = [], k + 1, self.pair[k]
        while begin < end:
            i = begin
            while i < end and self.token[i] != ",":
                i = self.pair[i] + 1 if self.token[i] in PAIRS else i + 1
            found.append((begin, i - 1))
            begin = i + 1
        return found

    def call(self, a, arguments, b):
        for first, last in arguments:
            self.add("a call left out", a, b, f"({self.words(first, last)})")
        if self.token[a] not in ("dot", "min", "max") and "::m" not in self.words(a, b)[:9]:
            for (p, q), (r, s) in zip(arguments, arguments[1:]):
                self.add("exchanged arguments", p, s, f"{self.words(r, s)}, {self.words(p, q)}")

    def names(self, k, names):
        token = self.token[k]
        if not re.match(r"[A-Za-z_]", token):
            return
        if digit := re.search(r"[12](?=_local$|$)", token):
            other = token[:digit.start()] + "21"[int(digit[0]) - 1] + token[digit.end():]
            self.add("body 1, body 2", k, k, other)
        if token in PARTNERS:
            self.add("another name", k, k, PARTNERS[token])
        for other in (token.removesuffix("_local"), f"{token}_local"):
            if other in names:
                self.add("the wrong space", k, k, other)
        if token in names and self.token[k - 1] not in (".", "->", "::"):
            for other in names:
                self.add("another name", k, k, other)

    def expressions(self, k):
        """What stands behind =, return, a bracket or a comma, whole; ends of loops."""
        if self.token[k] not in ("=", "+=", "-=", "return", "(", ",", "?", ":", "<", ">"):
            return
        end = k + 1
        while self.token[end] and self.token[end] not in (",", ";", ")", "]", "}", "?", ":", "<"):
            end = self.pair[end] + 1 if self.token[end] in PAIRS else end + 1
        if end == k + 1 or not self.token[end]:
            return
        words = self.words(k + 1, end - 1)
        begin = max((i for i, j in self.pair.items() if i <= k < j), default=0)
        control = begin and self.token[begin - 1]
        constant = not re.search(r"\b(?!real|vec)[a-z]|\b[A-Z]", words)
        for kind, ways in WRAPPED.items() if control not in ("if", "for", "while") else ():
            if constant or control in UNITS and kind in ("twice", "half", "unit") or \
                    self.token[k + 1] in UNITS and kind in ("unit", *LEFT):
                continue
            for way in ways:
                self.add(kind, k + 1, end - 1, way.format(words))
        for step in (" + 1", " - 1") if control == "for" and self.token[k] in ("=", "<") else ():
            self.add("ends of a loop", k + 1, end - 1, words + step)

    def end_of(self, k):
        """The last token of the statement that begins here."""
        if self.token[k] in ("for", "if", "while"):
            k = self.end_of(self.pair[k + 1] + 1)
            return self.end_of(k + 2) if self.token[k + 1] == "else" else k
        if self.token[k] == "{":
            return self.pair[k]
        while self.token[k] not in (";", ""):
            k = self.pair[k] + 1 if self.token[k] in PAIRS else k + 1
        return k

    def statements(self, k, end, names):
        before = None
        while k < end:
            last = self.end_of(k)
            words = self.words(k, last)
            if self.token[k] != "return" or self.token[k + 1] == ";":
                self.add("a statement left out", k, last, ";")
            if re.match(r"(?!return|const)[\w.]+(\(| [-+*/]=)", words):
                self.add("a statement twice", k, last, f"{words} {words}")
            if before is not None:
                self.add("exchanged statements", before, last,
                         f"{words} {self.words(before, k - 1)}")
            number = re.search(rf"\b({'|'.join(names)})(?:\.\w+|\[\w+\])*(?![\w(])", words)
            for leave in ("continue", "break", "return", "return {}") if number else ():
                self.add("an early exit", k, last, f"if (glm::length({number[0]}) < real(1e-6)) "
                         f"{leave}; {words}")
            inner = k
            while self.token[inner] in ("for", "if", "while", "else"):
                inner = self.pair[inner + 1] + 1
                if self.token[k] == "if":
                    self.add("a condition left out", k, last, self.words(inner, last))
            if inner > k or self.token[k] == "{":
                block = self.token[inner] == "{"
                self.statements(inner + block, self.end_of(inner) + (not block), names)
            before, k = k, last + 1


def around(text, region):
    """The names that a region knows: its own and those in the head of its function."""
    lines = text.split("\n")
    head = next(k for k in range(region.begin - 1, 0, -1) if re.match(r"\w", lines[k]))
    words = re.sub(r"//.*", "", "\n".join(lines[head:region.begin] + region.answer()))
    return sorted(set(re.findall(r"(?<=[\w>&*,]) [&*]*([a-z]\w*|[A-Z])(?= ?[,;=)({:\[])", words))
                  - {"return", "const", "if", "for", "template", "class", "else", "real", "vec3",
                     "std", "int", "auto", "double", "bool", "mat3", "quat", "true", "false"})


def drawn(chapter, wanted, seed):
    """Writes mistakes as answers, [(answer id, kind, old line, new line)] of each exercise."""
    text, found = chapter.solution.read_text(), {}
    folder = house.BUILD / "mistakes" / chapter.folder
    for id_ in chapter.ids():
        draw, seen, lines = random.Random(f"{seed} {id_}"), set(), []
        regions = [one for one in exercises.regions(text) if one.id == id_]
        codes = [Code("\n".join(one.answer()), around(text, one)) for one in regions]
        for n in range(SIZE * wanted[id_]):
            place = draw.randrange(len(codes))
            code = codes[place]
            kind = draw.choice(sorted({one[0] for one in code.found}))
            change = draw.choice([one for one in code.found if one[0] == kind])
            if (place, change) in seen:
                continue
            seen.add((place, change))
            _, a, b, words = change
            begin, end = code.at[a].start(), code.at[b].end()
            body = code.text[:begin] + words + code.text[end:]
            lines += [f"// region {place + 1}", f'// wrong "number {n}":', body, ""]
            found[f"{id_} wrong: number {n}"] = (kind, *(" ".join(one.split()) for one in (
                code.text[code.text.rfind("\n", 0, begin) + 1:(code.text + "\n").find("\n", end)],
                body[body.rfind("\n", 0, begin) + 1:
                     (body + "\n").find("\n", begin + len(words))])))
        exercises.write(folder / f"{id_}.cpp", "\n".join(lines))
    return found


def build(chapter):
    """A program with those of the mistakes that compile, and the answers in it."""
    folder = house.BUILD / "mistakes" / chapter.folder
    source, program = folder / "all.cpp", folder / "program"
    files = sorted(folder.glob("[0-9]*.cpp"))
    known = answers.read_all(files, chapter.solution.read_text())
    Path(f"{source}.refused.json").unlink(missing_ok=True)
    target = f"{chapter.folder}_answers"
    house.must_build([target])
    commands = subprocess.run(["ninja", "-C", house.BUILD, "-t", "commands", target], text=True,
                              capture_output=True, check=True).stdout.split("\n")
    object_ = f"{chapter.folder}_numbers.cpp.o"
    compiles = next(one for one in commands if f"{object_} -c" in one)
    compiles = [*shlex.split(compiles.partition(" -MD ")[0]), "-c", source, "-o", f"{source}.o"]
    while True:
        answers.make(chapter.solution, files, False, source, house.ROOT)
        log = subprocess.run(compiles, cwd=house.BUILD, text=True, capture_output=True).stderr
        if not answers.refuse(source, known, f"FAILED: \n{log}"):
            break
    links = re.sub(rf"\S*{re.escape(object_)}", f"{source}.o", commands[-2])
    links = links.replace(f"-o tests/{target} ", f"-o {program} ")
    subprocess.run(links, shell=True, cwd=house.BUILD, check=True)
    refused = answers.refused_of(source)
    return program, [one for one in known if not one.faults and one.key() not in refused]


def outcome(answer, program, chapter):
    """(what comes of a mistake, the sentence)."""
    one, trouble = judging.graded(answer, answer.id, program, chapter)
    if trouble:
        return "refused", trouble
    if one.status == grading.DONE:
        return "passed", ""
    report = one.failures[0][1]
    words = grading.named(report)
    if not words and not re.match(r"Exercise \d", report.strip()):
        return "plain", " ".join(report.partition("Where:")[0].split())
    vague = not words or "#drawn-alone" in words
    return "pointed" if vague else "known", words


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("root"), parser.add_argument("build")
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--count", type=int, required=True)
    parser.add_argument("--chapter", default="")
    parser.add_argument("--every", action="store_true")
    args = parser.parse_args(arguments)
    house.ROOT, house.BUILD = Path(args.root).resolve(), Path(args.build).resolve()
    chapters = [one for one in house.chapters() if args.chapter in ("", str(one.number))]
    ids = [id_ for chapter in chapters for id_ in chapter.ids()]
    wanted = Counter(ids[n % len(ids)] for n in range(args.count))
    total = Counter()
    for chapter in chapters:
        words = drawn(chapter, wanted, args.seed)
        program, compiled = build(chapter)
        chosen = [one for id_ in chapter.ids() for one in
                  [one for one in compiled if one.id == id_][:wanted[id_]]]
        with ThreadPoolExecutor(2) as pool:
            judged = list(pool.map(lambda one: outcome(one, program, chapter), chosen))
        counts = Counter(kind for kind, _ in judged)
        total += counts
        print(f"chapter {chapter.number}: {dict(counts)}", flush=True)
        for one, (came, said) in zip(chosen, judged):
            kind, old, new = words[one.name]
            if came in ("passed", "pointed") or args.every:
                print(f"  {came} {one.id} ({one.region}) {kind}: {old} ==> {new}\n      {said}")
    print(f"in all: {dict(total)}")
    return 1 if total["passed"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
