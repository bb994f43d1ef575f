"""The numbers and the length of the texts: numbers_test.py ROOT BUILD"""
import re
import sys

from proofs import beyond, files, house, main, notes, read

from keep import tied

WORDS = 1700  # an aim for a sitting: about a quarter of an hour of reading, without the exercises
SECOND_SITTING = "<!-- second sitting -->"  # stands in a text that is too long for one


def texts(root):
    """Every text that may hold a number of a run, and its chapter (0: none)."""
    for path in files(root, ".md"):
        chapter = re.match(r"(?:chapters|solutions)/(\d\d)_", str(path.relative_to(root)))
        yield path, int(chapter[1]) if chapter else 0


def numbers_are_what_the_runs_say(root, build):
    """every number that is tied to a table is what the table says, to the digits shown"""
    tables = tied.Tables(root, build)
    count = 0
    for path, chapter in texts(root):
        text = read(path)
        count += sum(1 for _ in tied.ties_of(text))
        for line, words in tied.faults_of(text, chapter, tables):
            yield f"{path.relative_to(root)}:{line}: {words}"
    notes.append(f"{count} numbers of the texts are tied to tables")


def changed_digits_are_found(root, build):
    """a digit changed in a text is found: a decimal, a whole number, a number of a table"""
    tables = tied.Tables(root, build)
    planted = 0
    for path, chapter in texts(root):
        text = read(path)
        seen = re.sub(r"<!--.*?-->", lambda comment: re.sub(r"[^\n]", " ", comment[0]), text,
                      flags=re.S).split("\n")
        good = [tie for _, tie in tied.ties_of(text) if isinstance(tie, tied.Tie)]
        for tie in good[:: max(1, len(good) // 3)]:
            lines = text.split("\n")
            digit = next(c for c in reversed(tie.shown) if c.isdigit())
            at = seen[tie.line - 1].rindex(tie.shown) + tie.shown.rindex(digit)
            line = lines[tie.line - 1]
            lines[tie.line - 1] = line[:at] + str((int(digit) + 2) % 10) + line[at + 1:]
            planted += 1
            if not any(at == tie.line and words.startswith("says ")
                       for at, words in tied.faults_of("\n".join(lines), chapter, tables)):
                yield f"{path.relative_to(root)}:{tie.line}: {tie.shown} may be anything"
    if planted < 3:
        yield f"only {planted} mistakes could be planted"


def live_links_say_what_is_seen(root, build):
    """every link to a state of the live page has a number behind it that the page shows there"""
    count = 0
    for path, _ in texts(root):
        text = read(path)
        links = list(tied.LIVE_LINK.finditer(text))
        count += len(links)
        for link, end in zip(links, [*(after.start() for after in links[1:]), len(text)]):
            states = {state for state, _ in tied.LIVE.findall(text, link.end(), end)}
            if link[1] not in states:
                yield (f"{path.relative_to(root)}:{text.count(chr(10), 0, link.start()) + 1}: "
                       f"no number says what is seen at {link[1]}")
    notes.append(f"{count} links of the texts lead to states of the live page")


def main_path(text):
    """What a reader reads at first: no folds, code, formulas on their own, tables, captions."""
    text = re.sub(r"<!--.*?-->", "", text, flags=re.S)
    while re.search(r"<details>", text):
        text = re.sub(r"<details>(?:(?!<details>).)*?</details>", "", text, flags=re.S)
    text = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
    text = re.sub(r"^\s*(?:\||#|!\[|<).*$", "", text, flags=re.M)
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


PROOFS = [numbers_are_what_the_runs_say, changed_digits_are_found,
          live_links_say_what_is_seen, main_paths_fit_one_sitting]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
