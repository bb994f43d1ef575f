"""Slips of the pen: small changes of a solution's region, made from its tokens.

Some come with a sentence. Of these tools/check/answers.py makes mistakes that a check knows, after
the known answers of tests/NN_name/answers: they compile whatever the types are, end, and reach for
no other memory. The others are for tests/workbook/mistakes.py alone.
"""
import re
from collections import Counter
from dataclasses import dataclass

from base import exercises

TOKEN = re.compile(r'//[^\n]*|"(?:\\.|[^"\\])*"|\d[\w.]*(?:(?<=e)-\d+)?|\w+(?:<[\w:]+>)?|'
                   r'::|->|\+\+|--|[-+*/%&|<>=!]=|&&|\|\||\S')
PAIRS = {"(": ")", "[": "]", "{": "}"}
# Of places and pointers, a whole step, or long to compile: no sentences.
LOOPS = ("7.3", "8.3", "9.2", "9.3", "9.5", "10.5")
PARTNERS = dict(pair for a, b in (
    ("to_world", "to_local"), ("min", "max"), ("sin", "cos"), ("v", "w"), ("x", "y"), ("y", "z"),
    ("lower", "upper"), ("begin", "end"), ("continue", "break"), ("linear", "angular"),
    ("true", "false")) for pair in ((a, b), (b, a)))
UNITS = ("direction", "normalize")  # they make unit vectors
# Of an expression: the kind, what stands in its place, and what the report says.
WRAPPED = (
    ("the sign", "testing::minus({})", "the sign of {}"),
    ("twice", "testing::twice({})", "{} counts twice"),
    ("half", "testing::half({})", "{} counts half"),
    ("abs", "testing::size({})", "{} has lost its sign, or the signs of its numbers"),
    ("unit", "glm::normalize({})", ""),
    ("int", "[](auto x) requires (sizeof(x) > 4) {{ return real(int(x)); }}({})", ""),
    ("float", "real(float({}))", ""), ("float", "vec3(glm::vec3({}))", ""),
    *(("small ones left out", "testing::above({}, " + least + ")", "")
      for least in ("1e-2", "1e-4", "1e-6", "1e-9")),
    *(("large ones cut off", "testing::below({}, " + most + ")", "")
      for most in ("1e2", "1e4", "1e6")))
LEFT = ("unit", "small ones left out", "large ones cut off")  # change no unit vector
PURE = set("cross dot skew to_world to_local direction normalize length inverse transpose max min "
           "clamp sqrt abs sin cos acos asin atan2 exp2 pow vec3 mat3 quat outerProduct".split())
IS_UNIT = re.compile(r"(direction|normalize|turned)\(|(n|a|b|c|a1|a2|t1|axis|direction)$")


@dataclass(frozen=True)
class Slip:
    """Words that take the place of tokens."""
    kind: str
    begin: int  # in the region's text
    end: int
    words: str
    said: str = ""  # the sentence

    def body(self, text):
        return text[:self.begin] + self.words + text[self.end:]


def short(words):
    words = " ".join(words.split())
    return words if len(words) <= 40 else words[:37] + "..."


class Slips:
    """All slips of a region. \\param head the lines of its function above it"""

    def __init__(self, id_, head, text):
        self.text, self.found, self.quiet = text, [], id_ in LOOPS
        self.at = [m for m in TOKEN.finditer(text) if not m[0].startswith("//")]
        self.token = [m[0] for m in self.at] + [""] * 3
        self.head = set(re.findall(r"\w+", head))
        code = re.sub(r"//.*", "", f"{head}\n{text}")
        self.names = sorted(set(re.findall(
            r"(?<=[\w>&*,]) [&*]*([a-z]\w*|[A-Z])(?= ?[,;=)({:\[])", code)) - set(
            "return const if for else real vec3 int auto double bool mat3 quat true false".split()))
        self.pair, opened = {}, []
        for k, token in enumerate(self.token):
            if token in PAIRS:
                opened.append(k)
            elif token and token in PAIRS.values():
                self.pair[k] = opened.pop()
                self.pair[self.pair[k]] = k
        for k in range(len(self.at)):
            self.operator(k)
            self.name(k)
            self.expression(k)
        self.statements(0, len(self.at))

    def words(self, a, b):
        return self.text[self.at[a].start():self.at[b].end()]

    def add(self, kind, a, b, words, said=""):
        if " ".join(words.split()) == " ".join(self.words(a, b).split()):
            return
        inside = [i for i, j in self.pair.items() if i <= a < j]
        if self.quiet or any(self.token[i] == "[" or self.token[i - 1] in ("for", "while")
                             for i in inside):
            said = ""
        self.found.append(Slip(kind, self.at[a].start(), self.at[b].end(), words, said))

    # ---- operands -------------------------------------------------------------------------------

    def is_operand(self, k):
        """Does one end here?"""
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
            elif k > 1 and self.token[k - 1] in (".", "->", "::"):
                k -= 2
            else:
                return k

    def term(self, k, step):
        """The other end of a product."""
        end = self.first if step < 0 else self.last
        k = end(k)
        while self.token[k + step] in ("*", "/") and (step > 0 or self.is_operand(k - 2)):
            k = end(k + 2 * step)
        return k

    def line(self, k):
        """The first token of a line."""
        begin = self.text.rfind("\n", 0, self.at[k].start())
        return next(i for i in range(k + 1) if self.at[i].start() > begin)

    # ---- where the changes are ------------------------------------------------------------------

    def operator(self, k):
        token, binary = self.token[k], self.is_operand(k - 1)
        if token in ("+", "-") and binary:
            a, b = self.term(k - 1, -1), self.term(k + 1, 1)
            left, right = self.words(a, k - 1), self.words(k + 1, b)
            self.add("the sign", k, k, "-" if token == "+" else "+", f"the sign of {short(right)}")
            self.add("a term left out", a, b, f"testing::first_term({left}, {right})",
                     f"{short(right)} is missing")
            around = "testing::{}_term({}, {})".format("second" if token == "+" else "less", left,
                                                       right)
            self.add("a term left out", a, b, around, f"{short(left)} is missing")
            if token == "-":
                self.add("exchanged operands", a, b, f"{right} - {left}",
                         f"the sign of {short(self.words(a, b))}")
            for first, last in ((k + 1, b), (a, k - 1)):
                for kind, around, said in WRAPPED[1:3]:
                    self.add(kind, first, last, around.format(self.words(first, last)),
                             said.format(short(self.words(first, last))))
        elif token == "-" and re.match(r"[\w(]", self.token[k + 1]):
            self.add("the sign", k, k, "+",
                     f"the sign of {short(self.words(k + 1, self.last(k + 1)))}")
        elif token in ("*", "/") and binary and re.match(r"[-\w(]", self.token[k + 1]):
            a, b = self.term(k - 1, -1), self.last(k + 1)
            left, right = self.words(a, k - 1), self.words(k + 1, b)
            times, two = token == "*", a == self.first(k - 1)
            self.add("a factor left out", a, b,
                     f"testing::{'first' if times else 'undivided'}({left}, {right})",
                     f"the {'factor' if times else 'divisor'} {short(right)} is missing")
            if times and two:
                self.add("a factor left out", a, b, f"testing::second({left}, {right})",
                         f"the factor {short(left)} is missing")
                self.add("exchanged operands", a, b, f"testing::exchanged({left}, {right})")
            self.add("* and /", a, b, f"testing::over({left}, {right})" if times
                     else f"{left} * {right}",
                     "" if times else f"multiplied by {short(right)}, not divided by it")
        elif token in ("+=", "-=", "*=", "/="):
            said = f"the sign in the line of {short(self.words(self.first(k - 1), k - 1))}"
            self.add("the sign", k, k, {"+=": "-=", "-=": "+=", "*=": "/=", "/=": "*="}[token],
                     said if token in ("+=", "-=") else "")
            self.add("= for +=", k, k, "=", f"= stands where {token} belongs, in the line of "
                     f"{short(self.words(self.first(k - 1), k - 1))}" if token == "+=" else "")
        elif token in ("<", ">", "<=", ">=", "==", "!=") and binary:
            for other in {"<": "> <=", ">": "< >=", "<=": ">= <", ">=": "<= >", "==": "!=",
                          "!=": "=="}[token].split():
                self.add("another comparison", k, k, other,
                         f"{other} stands where {token} belongs, in "
                         f"{short(self.words(self.first(k - 1), self.last(k + 1)))}")
        elif token in ("&&", "||"):
            self.add("and, or", k, k, "||" if token == "&&" else "&&")
        elif token == "!":
            self.add("and, or", k, k, "")
        elif re.match(r"\d", token):
            for other in ("2" if token == "1" else "1", "0"):
                before = self.words(self.line(k), k)
                self.add("another number", k, k, other, f"{other} stands where {token} belongs, at "
                         f"the end of {before if len(before) <= 40 else '...' + before[-37:]}")
        elif token == "(" and binary and self.token[k - 1] not in ("if", "for", "while"):
            self.call(self.first(self.pair[k]), k)

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

    def call(self, a, k):
        name, arguments, b = self.token[k - 1], self.arguments(k), self.pair[k]
        kept = name in ("to_world", "to_local", "direction", "normalize", "conjugate", "inverse",
                        "transpose", "abs", "sqrt")
        for first, last in arguments:
            said = f"{short(self.words(first, last))} stands there without {name}()"
            self.add("a call left out", a, b, f"({self.words(first, last)})",
                     said if kept and last == b - 1 or name == "cross" else "")
        for (p, q), (r, s) in zip(arguments, arguments[1:]):
            if name not in ("dot", "min", "max"):
                self.add("exchanged arguments", p, s, f"{self.words(r, s)}, {self.words(p, q)}",
                         "the order of the factors of a cross product: of "
                         f"{short(self.words(p, s))}" if name == "cross" else "")

    def name(self, k):
        token = self.token[k]
        members = {self.token[i] for i in range(1, len(self.at))
                   if self.token[i - 1] in (".", "->")}
        before = self.head | {self.token[i] for i in range(k) if self.token[i + 1] != "("
                              and self.token[i - 1] not in (".", "->")}
        if not re.match(r"[A-Za-z_]", token):
            return
        declared = self.token[k + 1] in ("=", "{") and self.token[k - 1] not in (".", "->")
        others = [token.removesuffix("_local"), f"{token}_local"]
        if digit := re.search(r"[12](?=_local$|$)", token):
            others.append(token[:digit.start()] + "21"[int(digit[0]) - 1] + token[digit.end():])
        for other in others:
            known = other in (members if self.token[k - 1] in (".", "->") else before) \
                and self.token[k + 1] != "("
            self.add("another place", k, k, other, f"{other} stands where {token} belongs"
                     if known and not declared else "")
        if token in PARTNERS:
            other = PARTNERS[token]
            known = f"{self.token[k - 2]}.{other}" in self.text or \
                self.token[k + 1] == "(" and token[:3] in ("to_", "min", "max", "sin", "cos")
            self.add("another name", k, k, other, f"{other} stands where {token} belongs, in "
                     f"{short(self.words(self.first(k), k))}" if known and not declared else "")
        if token in self.names and self.token[k - 1] not in (".", "->", "::"):
            for other in self.names:
                self.add("another name", k, k, other)

    def expression(self, k):
        """What stands behind =, return, a bracket or a comma, whole; ends of loops."""
        if self.token[k] not in ("=", "+=", "-=", "return", "(", ",", "?", ":", "<", ">", "{") or \
                self.token[k] == "{" and self.token[k - 1] in (")", "else", ";", "}", "{"):
            return
        end = k + 1
        while self.token[end] and self.token[end] not in (",", ";", ")", "]", "}", "?", ":", "<"):
            end = self.pair[end] + 1 if self.token[end] in PAIRS else end + 1
        if end == k + 1 or self.token[end] in ("", "?"):
            return
        words = self.words(k + 1, end - 1)
        within = max((i for i, j in self.pair.items() if i <= k < j), default=0)
        control = within and self.token[within - 1]
        for step in (" + 1", " - 1") if control == "for" and self.token[k] in ("=", "<") else ():
            self.add("ends of a loop", k + 1, end - 1, words + step)
        if self.token[k] == "," and not self.is_operand(within - 1):
            return  # another variable
        constant = not re.search(r"\b(?!real|vec)[a-z]|\b[A-Z]", words)
        if control in ("if", "for", "while") or constant or words[0] == "{" or \
                re.match(r"(const|return|for|if|while)\b|&?\w+( =|\{)", words):
            return
        reference = self.token[k] in ("(", ",") and control not in PURE and \
            re.fullmatch(r"[\w.\[\]>-]+", words) or \
            self.token[k] == "=" and "&" in self.token[max(0, k - 3):k]
        for kind, around, said in WRAPPED:
            if not (control in UNITS and kind in ("twice", "half", "unit") or
                    kind in LEFT and IS_UNIT.match(words)):
                self.add(kind, k + 1, end - 1, around.format(words),
                         said.format(short(words)) if not reference else "")

    # ---- statements -----------------------------------------------------------------------------

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

    def statements(self, k, end, bare=False):
        """Of those from k to the end; `bare`: without braces around them."""
        before, around = None, "{{ {} }}" if bare else "{}"
        while k < end:
            last = self.end_of(k)
            words = self.words(k, last)
            if not re.match(r"return\b.", words):
                line = re.match(r"([\w.]+(?:\[\w+\])?) [-+*/]?= ", words)
                self.add("a statement left out", k, last, ";",
                         f"the line of {line[1]} is missing" if line else "")
            if re.match(r"(?!return|const)[\w.]+ [-+*/]=", words):
                self.add("a statement twice", k, last, around.format(f"{words} {words}"),
                         f"it is done twice: {short(words)}")
            if before is not None and not (words + self.words(before, k - 1)).count("const ") > 1:
                self.add("exchanged statements", before, last,
                         f"{words} {self.words(before, k - 1)}")
            number = self.names and re.search(
                rf"\b({'|'.join(self.names)})(?:\.\w+|\[\w+\])*(?![\w(])", words)
            for leave in ("continue", "break", "return", "return {}") if number else ():
                self.add("an early exit", k, last, around.format(
                    f"if (glm::length({number[0]}) < real(1e-6)) {leave}; {words}"))
            inner = k
            while self.token[inner] in ("for", "if", "while"):
                inner = self.pair[inner + 1] + 1
                if self.token[k] == "if":
                    self.add("a condition left out", k, last, self.words(inner, last),
                             "" if "else" in self.token[k:last + 2] else
                             f"the condition is missing: {short(self.words(k, inner - 1))}")
            if inner > k or self.token[k] == "{":
                block = self.token[inner] == "{"
                self.statements(inner + block, self.end_of(inner) + (not block), not block)
            before, k = k, last + 1


def of(text, region):
    """All slips of a region of a solution."""
    lines = text.split("\n")
    head = next(k for k in range(region.begin - 1, 0, -1) if re.match(r"\w", lines[k]))
    return Slips(region.id, "\n".join(lines[head:region.begin]), "\n".join(region.answer()))


def said(text):
    """Those of a solution that have a sentence: (exercise, place of its region, words, lines)."""
    count = Counter()
    for region in exercises.regions(text):
        count[region.id] += 1
        code, seen = of(text, region), set()
        for slip in code.found:
            body = slip.body(code.text)
            if slip.said and body not in seen:
                yield region.id, count[region.id], slip.said, body.split("\n")
                seen.add(body)
