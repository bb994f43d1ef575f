"""Runs a whole Catch2 program and reads what it says, case by case."""
import re
import subprocess
import threading
import time
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

from judge import grade as grading

LIMIT = 600  # for one case [s]: the longest takes a few seconds, and a minute under the sanitizers


@dataclass
class Outcome:
    """What a program's run came to."""
    cases: list = field(default_factory=list)   # (name, tags)
    failed: list = field(default_factory=list)  # (name, words)


def run(program, only="", env=None, each=lambda name: None):
    """Every case of a program. One that crashes or does not end is named; the rest is run again
    without it. `only` is a filter of Catch2's, `each` is told every case's name as it begins."""
    outcome, without = Outcome(), []
    while True:
        text, stopped, status = once(program, only, without, env, each)
        names = [unescape(name) for name in re.findall(r'<TestCase name="([^"]*)"', text)]
        tree = parsed(text)
        if tree is not None:
            for case in tree.iter("TestCase"):
                take(outcome, case)
        crash = tree is not None and any(True for _ in tree.iter("FatalErrorCondition"))
        if tree is not None and not crash:
            return outcome
        culprit = names[-1] if names else ""
        if tree is None:
            words = (f"did not end within {LIMIT} s: a loop without an end?" if stopped
                     else f"the program crashed (exit status {status})")
            outcome.failed.append((culprit, words))
        if not culprit or culprit in without:
            return outcome
        # what came before it has been read only where the report was whole
        without = without + [culprit] if tree is None else without + names


def once(program, only, without, env, each):
    """One process: (its XML, whether it was stopped, exit status)."""
    filter_ = only + "".join(f' ~"{escape(name)}"' for name in without)
    command = [program, "-r", "xml"] + ([filter_] if filter_ else [])
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                               text=True, errors="replace", env=env)
    last, stopped = [time.time()], []

    def watch():
        while process.poll() is None:
            if time.time() - last[0] > LIMIT:
                stopped.append(True)
                process.kill()
                return
            time.sleep(0.2)
    watcher = threading.Thread(target=watch, daemon=True)
    watcher.start()
    lines = []
    for line in process.stdout:
        lines.append(line)
        if match := re.search(r'<TestCase name="([^"]*)"', line):
            last[0] = time.time()
            each(unescape(match[1]))
    return "".join(lines), bool(stopped), process.wait()


def parsed(text):
    try:
        return ElementTree.fromstring(text)
    except ElementTree.ParseError:
        return None


def unescape(name):
    for letters, sign in (("&quot;", '"'), ("&lt;", "<"), ("&gt;", ">"), ("&amp;", "&")):
        name = name.replace(letters, sign)
    return name


def escape(name):
    return re.sub(r'([\\\\",\[\]])', r"\\\1", name)


def take(outcome, case):
    """One case of the XML."""
    name = case.get("name")
    outcome.cases.append((name, case.get("tags", "")))
    result = case.find("OverallResult")
    if result is None or result.get("success") != "true":
        outcome.failed.append((name, "\n".join(words_of(case))))


def words_of(case):
    """What a failed case says, with the places of its checks."""
    for element in case.iter():
        place = f"{element.get('filename', '')}:{element.get('line', '')}"
        if element.tag == "FatalErrorCondition":
            words = f"the program crashed: {(element.text or '').strip()}"
            yield f"{place}: {grading.plainly(words)}"
        elif element.tag in ("Exception", "Failure", "Info") and element.text:
            yield (f"{place}: " if element.get("line") else "") + element.text.strip()
        elif element.tag == "Expression" and element.get("success") == "false":
            yield (f"{place}: {element.findtext('Original', '').strip()} is not true: "
                   f"{element.findtext('Expanded', '').strip()}")
