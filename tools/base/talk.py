"""How wb talks: colours, progress, questions, lines that fit a terminal."""
import contextlib
import os
import shutil
import sys
import textwrap
import threading
import time

WIDTH = 80  # what is printed does not wrap in a terminal of as many columns
TERMINAL = sys.stdout.isatty() and os.environ.get("TERM", "dumb") != "dumb"


class Trouble(Exception):
    """Something the user can do something about: one line, exit status 2."""


def coloured(words, code):
    return f"\033[{code}m{words}\033[0m" if TERMINAL and "NO_COLOR" not in os.environ else words


def good(words):
    return coloured(words, "32")


def bad(words):
    return coloured(words, "31")


def faint(words):
    return coloured(words, "2")


def bold(words):
    return coloured(words, "1")


def folded(words, margin=0, hang=0):
    """A sentence in lines that fit: indented by margin, all but the first by hang more."""
    return textwrap.fill(words, WIDTH - 1, initial_indent=" " * margin, break_long_words=False,
                         subsequent_indent=" " * (margin + hang), break_on_hyphens=False)


def indented(words, margin=4):
    return "\n".join(" " * margin + line if line else "" for line in words.split("\n"))


# ---- progress ------------------------------------------------------------------------------------

QUIET = 8.0  # a log gets a line of progress at least this often [s], and not much oftener
_said = {"words": "", "at": time.time()}  # nothing is said of work that takes a moment


def progress(words):
    """What is being done: a line that is overwritten by the next. A log gets only some of them,
    beside what is reported."""
    _said["words"] = words
    if TERMINAL:
        width = shutil.get_terminal_size().columns - 1
        sys.stdout.write("\r\033[K" + words[:width])
        sys.stdout.flush()
    elif time.time() - _said["at"] > QUIET / 2:
        say_progress()


def say_progress():
    _said["at"] = time.time()
    print(f"  {_said['words']}", file=sys.stderr, flush=True)


def progress_done():
    if TERMINAL:
        sys.stdout.write("\r\033[K")
        sys.stdout.flush()


@contextlib.contextmanager
def talking():
    """While it lasts, a log gets a line of progress even where one thing takes long."""
    ended = threading.Event()

    def talk():
        while not ended.wait(1):
            if _said["words"] and time.time() - _said["at"] > QUIET:
                say_progress()
    if not TERMINAL:
        threading.Thread(target=talk, daemon=True).start()
    try:
        yield
    finally:
        ended.set()


def ask(question, yes):
    """True when the user agrees, or said so on the command line."""
    if yes:
        return True
    if not sys.stdin.isatty():
        raise Trouble(f"{question} Nobody is here to ask: add --yes to agree.")
    try:
        return input(f"{question} [y/N] ").strip().lower().startswith("y")
    except EOFError:
        print()
        return False
