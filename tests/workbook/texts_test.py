"""The texts: headings, equations, links, errata: texts_test.py ROOT BUILD"""
import re
import sys
from collections import Counter

from proofs import (beyond, files, folded, house, main, prose, read, regions, section, sections,
                    would_change)

from keep import tabled
from website import experiments, gallery

HEADINGS = ["Goal", "Derivation", "Numbers", "Code", "Exercises", "Check", "Predict", "See it",
            "A printed formula that is wrong: find it", "Questions", "Further reading"]
FIELD = {"degree of freedom", "constraint", "holonomic", "jacobian", "lagrange multiplier",
         "effective mass", "gauss-seidel", "projected gauss-seidel", "iteration", "warm starting",
         "block solve", "composite", "island", "graph colouring", "simd", "lane", "gather",
         "scatter", "transpose", "latency", "throughput", "cache", "memory bandwidth", "roofline",
         "constraint softness", "split impulse", "relax iteration", "substep", "speculative limit",
         "slop", "restitution", "contact point", "manifold", "friction pyramid"}
OPTIONAL = {"A printed formula that is wrong: find it"}
THESIS = """1.1 1.2 2 3.1 3.2 3.3 3.4 3.5 3.6 3.7 3.7.1 3.7.2 3.7.3 3.7.4 3.7.5 4 5 5.1 5.2 5.3
    6""".split()  # its sections, and its pieces beside the text
PIECES = ["algorithm 1", "listing 4.1", *(f"figure {n}" for n in "3.1 3.2 3.3 5.3 5.4 5.5 5.6 5.7"
                                          .split()), "figures 5.1 and 5.2", "tables 5.1 and 5.2"]


def texts_have_their_headings(root, build):
    """every chapter's text has the headings that all chapters have, in their order"""
    for chapter in house.chapters():
        found = [heading for heading, _ in sections(prose(read(chapter.text)), "##")]
        wanted = [h for h in HEADINGS if h not in OPTIONAL or h in found]
        if found != wanted:
            yield f"{chapter.folder}/README.md: {found} where {wanted} is wanted"


def questions_have_answers(root, build):
    """every chapter asks three or four questions, and each has an answer"""
    for chapter in house.chapters():
        asked = re.findall(r"^(\d+)\. ", section(chapter, "Questions"), re.M)
        answers = prose(read(chapter.solution.parent / "answers.md"))
        answered = [heading.removeprefix("Question ") for heading, _ in sections(answers, "##")]
        if asked not in (list("123"), list("1234")) or answered != asked:
            yield f"{chapter.folder}: README.md asks {asked}, answers.md answers {answered}"


def equations_exist(root, build):
    """every equation is numbered once, in order, and every number that is used exists"""
    tags = {c.number: re.findall(r"\\tag\{([^}]*)\}", read(c.text)) for c in house.chapters()}
    for number, found in tags.items():
        wanted = [f"{number}-{n + 1}" for n in range(len(found))]
        if found != wanted or not found:
            yield f"chapter {number}: the equations are {found}"
    known = {tag for found in tags.values() for tag in found}
    used = re.compile(r"\bEqs?\. (\d+-\d+(?:(?:,| and| or| to|, and) \d+-\d+)*)")
    for path in files(root, ".cpp", ".h", ".md", ".py"):
        text = prose(read(path)) if path.suffix == ".md" else read(path)
        for match in used.finditer(folded(text)):
            for tag in set(re.findall(r"\d+-\d+", match[1])) - known:
                yield f"{path.relative_to(root)}: there is no Eq. {tag}"


def texts_keep_the_solution(root, build):
    """no line of a solution stands in a chapter's text or in a first or second hint"""
    for chapter in house.chapters():
        hints = [hint for _, body in sections(read(chapter.hints), "##")
                 for number, hint in sections(body, "###") if number in "12"]
        public = folded(read(chapter.text) + " ".join(hints))
        for region in regions(chapter):
            for line in region.answer():
                code = folded(line.split("//")[0])
                if len(code) > 25 and code in public:
                    yield f"{chapter.folder}: the answer of {region.id} stands in the text: {code}"


def places_in(path):
    """The names by which links reach the headings of a text, as code hosts make them."""
    text = re.sub(r"^```.*?^```$", "", read(path), flags=re.M | re.S)
    headings = re.findall(r"^##+ (.+?) *$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def links_lead_somewhere(root, build):
    """every link and picture of a text leads to a file, and to a heading if it names one"""
    link = re.compile(r"\]\(\s*<?([^)\s>]+)[^)]*\)|<[^>]+(?:src|href)=\"([^\"]+)\"")
    for path in files(root, ".md"):
        for match in link.finditer(re.sub(r"\$[^$\n]*\$", "", prose(read(path)))):
            target, _, place = (match[1] or match[2]).partition("#")
            if re.match(r"[a-z]+:", target):
                continue
            file = path.parent / target.split("?")[0] if target else path
            if not file.exists():
                yield f"{path.relative_to(root)}: {target} does not exist"
            elif place and file.suffix == ".md" and place not in places_in(file):
                yield f"{path.relative_to(root)}: {target} has no heading #{place}"


def thesis_is_listed(root, build):
    """docs/thesis.md has every section, figure and table of the thesis, with its errata"""
    rows = re.findall(r"^\| (T \d[^|]*) \| [^|]+ \| (\w[\w ]*) \| ([^\n]+) \|$",
                      read(root / "docs/thesis.md"), re.M)
    for part in [f"T {number}" for number in THESIS] + PIECES:
        if not any(part in re.split(r", ", where) for where, *_ in rows):
            yield f"docs/thesis.md has no row for {part}"
    for where, verdict, words in rows:
        if verdict not in ("covered", "corrected", "improved", "left out"):
            yield f"docs/thesis.md: {where} is {verdict}"
        if "](" not in words and verdict != "left out":
            yield f"docs/thesis.md: {where} leads nowhere: {words}"
        if (verdict == "corrected") != bool(re.search(r"\bE\d", words)):
            yield f"docs/thesis.md: {where} is {verdict}: {words}"
    listed = {(f"T {section}", number) for where, _, words in rows
              for section in re.findall(r"T ([\d.]+)", where)
              for number in re.findall(r"\bE\d+", words)}
    said = {(section, heading.partition(":")[0])
            for heading, body in sections(read(root / "docs/errata.md"), "###")
            for section in re.search(r"^\*\*(T .*?)\.\*\*", body.strip())[1].split(", ")}
    said |= {(section, number) for number, where in re.findall(
        r"^\| (E\d+) \| (T [^|]*) \|", read(root / "docs/errata.md"), re.M)
             for section in where.split(", ")}
    for section, number in sorted(listed ^ said):
        page = "thesis" if (section, number) in listed else "errata"
        yield f"docs/{page}.md alone has {number} at {section}"


def errata_are_shown(root, build):
    """every test that the list of errata names exists"""
    tests = "".join(read(path) for path in files(root / "tests", ".cpp"))
    for word in sorted(set(re.findall(r"`(\[E\d+\]|[IX]\d+)`", read(root / "docs/errata.md")))):
        if (word if word[0] == "[" else f'TEST_CASE("{word} ') not in tests:
            yield f"docs/errata.md names the test {word}: there is none"


def words_of_the_field_are_explained(root, build):
    """every word of the field that the texts use is explained"""
    table = read(root / "docs/notation.md").partition("## The field's words")[2]
    explained = {word.strip().lower() for row in re.findall(r"^\| ([^|]+) \|", table, re.M)
                 for word in row.split(",")}
    for word in FIELD - explained:
        yield f"docs/notation.md does not explain: {word}"


BRACES = r"\{(?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*\}"
NO_LETTERS = re.compile(  # words, indices, transposes and inverses, functions, sizes of brackets
    rf"\\(?:text|mathrm|operatorname|tag|begin|end){BRACES}|_(?:{BRACES}|\\\w+|\w)"
    r"|\^(?:T\b|\{-1\})|\\(?:left|right|[bB]ig[lr]?)")
LETTER = re.compile(r"\\([A-Za-z]+)|(?<![\\a-zA-Z])([a-zA-Z])(?![a-zA-Z])")
GREEK = set("""alpha beta gamma delta varepsilon zeta eta theta kappa lambda mu nu xi rho sigma tau
    phi varphi chi psi omega ell Delta Omega""".split())
# Where a chapter uses a letter for two things, both of which the field writes so.
TWICE = {("a", 11), ("omega", 7), ("x", 4)}
MOST_MEANINGS = 2  # of a letter in all chapters, but for these: robotics writes a torque as n
THRICE = {"n"}


def letters_of(formula):
    """The letters of a formula, without those of indices; d/dt and the axes x, y, z are none."""
    if formula.strip() in ("x", "y", "z"):
        return set()
    bare = re.sub(r"\\frac\{d(\w?)\}\{dt\}", r"\1 ", NO_LETTERS.sub(" ", formula))
    found = {command or letter for command, letter in LETTER.findall(bare)}
    return {letter for letter in found if len(letter) == 1 or letter in GREEK}


def letters_in(text):
    """Those of all formulas of a text."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    blocks = re.findall(r"^```math\n(.*?)^```", text, re.M | re.S)
    text = re.sub(r"^```.*?^```|`[^`\n]*`", "", text, flags=re.M | re.S)
    return set().union(*map(letters_of, blocks + re.findall(r"\$([^$]+)\$", text)))


def listed_letters(text):
    """[(letter, chapters, meaning)] of the table of docs/notation.md."""
    for line in dict(sections(text, "##"))["Letters"].split("\n"):
        if line.startswith("| $"):
            symbols, meaning, where, *_ = (cell.strip() for cell in line.split("|")[1:])
            ends = [[int(n) for n in part.split(" to ")] for part in where.split(",")]
            chapters = {n for first, *last in ends for n in range(first, (last or [first])[0] + 1)}
            for letter in set().union(*({symbol.strip()} if symbol in "xyz" else letters_of(symbol)
                                        for symbol in re.findall(r"\$([^$]+)\$", symbols))):
                yield letter, chapters, meaning


def letters_are_listed(root, build):
    """docs/notation.md lists every letter of the chapters' formulas and no other, each once"""
    listed = list(listed_letters(read(root / "docs/notation.md")))
    used = {(letter, chapter.number) for chapter in house.chapters()
            for letter in letters_in(read(chapter.text))}
    indices = {letter for letter, _, meaning in listed if meaning.startswith("index")}
    known = {(letter, number) for letter, chapters, _ in listed for number in chapters}
    for letter, number in sorted(used ^ known, key=str):
        if (letter, number) in used or letter not in indices:
            yield f"docs/notation.md: {letter} of chapter {number}: " + \
                ("not listed" if (letter, number) in used else "the chapter has no such letter")
    meant = Counter((letter, number) for letter, chapters, meaning in listed
                    for number in chapters if not meaning.startswith("index"))
    twice = {place for place, count in meant.items() if count > 1}
    for letter, number in sorted(twice ^ TWICE):
        yield f"{letter} has {meant[letter, number]} meanings in chapter {number}"
    for letter, count in Counter(letter for letter, _, meaning in listed
                                 if not re.match("index|any", meaning)).items():
        if count > MOST_MEANINGS + (letter in THRICE):
            yield f"docs/notation.md: {letter} has {count} meanings"
    planted = "$Q_i \\cdot x^T$ and `$Z$`, along $z$\n```math\n\\psi \\tag{1}\n```"
    if letters_in(planted) != {"Q", "x", "psi"}:
        yield "the letters of a planted formula are not found"


def quotations_are_exact(root, build):
    """code that a text quotes from a file, <!-- from FILE -->, stands there as it is"""
    yield from would_change("listings", root, build)
    for path in sorted((root / "library" / "examples").iterdir()):
        if f"](../{path.relative_to(root)})" not in read(root / "docs/library.md"):
            yield f"docs/library.md does not lead to {path.relative_to(root)}"


def lines_can_be_edited(root, build):
    """no line of the chapters and of which method, but for made ones, is far over 200 letters"""
    guides = [root / "docs" / name for name in ("which_method.md", "measurements.md")]
    for path in [chapter.text for chapter in house.chapters()] + guides:
        text = tabled.TABLE.sub(lambda table: table["head"], read(path))
        longest = max(text.split("\n"), key=len)
        yield from beyond(f"{path.relative_to(root)}: {longest[:30]}...", len(longest), 200,
                          "letters")


def folds_are_named_as_they_are(root, build):
    """every fold that docs/teaching.md recommends or leaves out is one of its chapter"""
    titles = {c.number: " ".join(re.findall(r"<summary>([^<]*)", read(c.text))).lower()
              for c in house.chapters()}
    named = dict(sections(read(root / "docs/teaching.md"), "##"))["Folds"].partition("* **")[2]
    found = re.findall(r"(\d+)(?: and (\d+))?: ([^;.]+)", folded(named))
    for *numbers, names in found:
        for number in filter(None, numbers):
            for name in names.split(", "):
                if name.lower() not in titles[int(number)]:
                    yield f"docs/teaching.md: chapter {number} has no fold '{name}'"
    if len(found) < 10:
        yield f"docs/teaching.md names only {len(found)} chapters with folds"


def changes_begin_with_the_version(root, build):
    """the first entry of CHANGELOG.md is the version of CMakeLists.txt"""
    first, *_ = sections(read(root / "CHANGELOG.md"), "##")
    if first[0].split()[0] != house.version() or not first[1].strip():
        yield f"CHANGELOG.md begins with {first[0]}, the version is {house.version()}"


def code_beside_a_scene_is_there(root, build):
    """the lines of code that the site shows beside a setting of a live scene exist"""
    for setting in experiments.CODE:
        try:
            experiments.code_of(setting)
        except gallery.GalleryError as error:
            yield str(error)


PROOFS = [changes_begin_with_the_version, texts_have_their_headings, questions_have_answers,
          equations_exist,
          texts_keep_the_solution, links_lead_somewhere, thesis_is_listed,
          errata_are_shown,
          words_of_the_field_are_explained, letters_are_listed, quotations_are_exact,
          code_beside_a_scene_is_there, folds_are_named_as_they_are, lines_can_be_edited]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
