"""Lines of the solutions, and the files of a folder in which they stand.

A line of an answer is compared without its comment, blanks and `const`, without what it is assigned
to, without `return`, and with `body.x` for `pair.body.x`: once as it is, if 16 characters remain,
and once with every variable called `_`, if 24 remain. It must be more than the head of a loop, a
declaration, or one call with names as arguments. What the engine or the given part of an exercise
file says, too, does not count: every student reads it.
"""
import re

from base import exercises, house

LEAST = 16, 24  # characters of the two forms
TYPES = "auto|bool|double|int|mat3|quat|real|std|vec3|void"
WORDS = "break|const|continue|else|false|for|if|return|true|while"
VARIABLE = re.compile(rf"(?!(?:{TYPES}|{WORDS})$)(?:[a-z]\w*|[A-Z]\w?)$")
LOOP = r"(?:for|while) \((?:[^()]|\([^()]*\))*\)"
CALL = r"[\w.:<>]+\((?:[\w., \[\]]|real\(\w+\))*\)"
PLAIN = re.compile(rf"{LOOP}|{CALL}|[\w:<>, ]+ \w+|\[.?\]\([^()]*\)")


def forms(code):
    """(without comments and blanks, the same with _ for variables) of code."""
    code = re.sub(r"//.*|\bconst\b", "", code)
    code = re.sub(r"\b(?:\w+(?:\.|->))+(?=\w+(?:\.|->))", "", code)
    words = re.findall(r"\w+|::|->|\S", code)
    bare = ["_" if VARIABLE.match(word) and before not in (".", "->", "::")
            and after not in ("(", "::", "<", "{") else word
            for before, word, after in zip(["", *words], words, [*words[1:], ""])]
    return "".join(words), "".join(bare)


def expression(line):
    """What a line computes; "" for a line that anyone would write."""
    code = re.sub(r"//.*", "", line).strip(" ;{")
    code = re.sub(r"^return\b|^[^=(]*[^=<>!([]=(?!=)", "", code).strip()
    return "" if PLAIN.fullmatch(code) else code


def known():
    """{form: (exercise, line)} of all answers."""
    given = forms("\n".join(
        [exercises.stub(exercises.read(chapter.solution)) for chapter in house.chapters()]
        + [exercises.read(path) for path in house.files(house.ROOT / "engine", ".h", ".cpp")]))
    return {form: (region.id, line.strip()) for chapter in house.chapters()
            for region in exercises.regions(exercises.read(chapter.solution))
            for line in region.answer()
            for form, others, least in zip(forms(expression(line)), given, LEAST)
            if len(form) >= least and form not in others}


def found(folder, answers):
    """[(file, exercise, line)]: where forms of `answers` stand in the text files of a folder."""
    out = set()
    for path in sorted(folder.rglob("*")):
        try:
            texts = forms(path.read_text(encoding="utf-8")) if path.is_file() else ()
        except UnicodeDecodeError:  # a picture, an object
            continue
        out |= {(str(path.relative_to(folder)), *one) for form, one in answers.items()
                if any(form in text for text in texts)}
    return sorted(out)
