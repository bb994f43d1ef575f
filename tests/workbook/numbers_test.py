"""The numbers and the length of the texts: numbers_test.py ROOT BUILD"""
import re
import sys
from collections import Counter

from proofs import beyond, folded, house, main, notes, prose, read, would_change

from check import habits
from keep import tabled, tied, values
from keep.keeping import texts

WORDS = 1700  # an aim for a sitting: about a quarter of an hour of reading, without the exercises
SECOND_SITTING = "<!-- second sitting -->"  # stands in a text that is too long for one
# Words before a comment, behind one, or on the line after one that ties numbers.
IN_A_SENTENCE = re.compile(r".*[^ >\n].*<!--.*|-->.*\S.*|"
                           r"<!-- tied:(?:[^-]|-(?!->))*-->\n[ >]*[\w$([].*")


def numbers_are_what_the_runs_say(root, build):
    """every number that is tied to a table, and every table that is made, agrees with the runs"""
    yield from would_change("numbers", root, build)
    found = [read(path) for path, _ in texts(root)]
    notes.append(f"{sum(len(list(tied.ties_of(text))) for text in found)} numbers of sentences and "
                 f"{sum(len(tabled.TABLE.findall(text)) for text in found)} tables come from runs")


def changed_digits_are_found(root, build):
    """a digit changed in a text is put right, or told where several numbers could be meant"""
    tables = values.Tables(root, build)
    planted = Counter()
    for path, chapter in texts(root):
        text = read(path)
        ties = [tie for _, tie in tied.ties_of(text) if isinstance(tie, tied.Tie)]
        places = [("sentence", tied.renewed, tie.place + max(
            n for n, c in enumerate(tie.shown) if c.isdigit()))
            for tie in ties[:: max(1, len(ties) // 3)]]
        places += [("table", tabled.renewed, table.start("made") + table["made"].rindex(digit))
                   for table in tabled.TABLE.finditer(text)
                   for digit in re.findall(r"\d", table["made"])[-1:]]
        for kind, renewed, place in places:
            other = text[:place] + str((int(text[place]) + 2) % 10) + text[place + 1:]
            planted[kind] += 1
            line = text.count("\n", 0, place) + 1
            again, changes, faults = renewed(other, chapter, tables)
            right, _, before = renewed(text, chapter, tables)
            mended = line in [at for at, _ in changes] and again == right
            if not mended and faults == before:
                yield f"{path.relative_to(root)}:{line}: a number of a {kind} may be anything"
    if min(planted["sentence"], planted["table"]) < 10:
        yield f"only so many mistakes could be planted: {dict(planted)}"


def sentences_are_without_comments(root, build):
    """no comment stands in a sentence: it has lines of its own, for numbers behind a paragraph"""
    for path, _ in texts(root):
        for match in IN_A_SENTENCE.finditer(prose(read(path))):
            yield (f"{path.relative_to(root)}: put the comment behind the paragraph: "
                   f"{folded(match[0])[:80]}")


def live_links_say_what_is_seen(root, build):
    """every link to a state of the live page has a number behind it that the page shows there"""
    count = 0
    for path, _ in texts(root):
        text = read(path)
        ties = [tie for _, tie in tied.ties_of(text) if isinstance(tie, tied.Tie)]
        links = list(tied.LIVE_LINK.finditer(text))
        count += len(links)
        for link, end in zip(links, [*(after.start() for after in links[1:]), len(text)]):
            states = {state for tie in ties if link.end() < tie.place < end
                      for state, _ in tied.LIVE.findall(tie.expression)}
            if link[1] not in states:
                yield (f"{path.relative_to(root)}:{text.count(chr(10), 0, link.start()) + 1}: "
                       f"no number says what is seen at {link[1]}")
    notes.append(f"{count} links of the texts lead to states of the live page")


def main_path(text):
    """What a reader reads at first: no folds, code, formulas on their own, tables, captions, nor
    the list of exercises."""
    text = re.sub(r"[ >]*<!--.*?-->|^## Exercises$.*?(?=^## )", "", text, flags=re.S | re.M)
    while re.search(r"<details>", text):
        text = re.sub(r"<details>(?:(?!<details>).)*?</details>", "", text, flags=re.S)
    text = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
    text = re.sub(r"^!\[[^\]]*\]\([^)]*\)$|^\s*(?:\||#|<).*$", "", text, flags=re.M)
    return re.sub(r"\$[^$]+\$", "x", text)


def main_paths_fit_one_sitting(root, build):
    """no sitting of a chapter is far longer than the aim of 1,700 words: by a fifth at most"""
    counts = []
    for chapter in house.chapters():
        sittings = read(chapter.text).split(SECOND_SITTING)
        words = [len(main_path(sitting).split()) for sitting in sittings]
        counts.append(f"{chapter.number}: {' + '.join(map(str, words))}")
        if len(sittings) > 2:
            yield f"{chapter.folder}/README.md: {len(sittings)} sittings, at most two are wanted"
        for count in words:
            yield from beyond(f"{chapter.folder}/README.md", count, WORDS,
                              "words outside of folds, code and tables in one sitting")
    notes.append("words of the main paths: " + ", ".join(counts))
    notes.extend(habits.told(*one) for one in habits.found(root).items())


PROOFS = [numbers_are_what_the_runs_say, changed_digits_are_found,
          sentences_are_without_comments, live_links_say_what_is_seen, main_paths_fit_one_sitting]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
