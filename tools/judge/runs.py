"""Runs the tests of exercises in a process of their own and reads what it says, however it ends."""
import contextlib
import os
import re
import signal
import subprocess
import tempfile
import threading
import tty
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field

from judge import crashes

# Processor time for the tests of an exercise [s]: they take milliseconds. The proofs wait less.
LIMIT = int(os.environ.get("WORKBOOK_LIMIT", "4"))
WAIT = 15  # for work that may wait, which uses no processor time [s]; on a busy machine more
STACK, MEMORY = 16, 256  # [MB]: what grows for ever fills them at once
LIMITED = "".join(f"ulimit {limit} 2>/dev/null; " for limit in (
    f"-s {STACK * 1024}", f"-v {MEMORY * 1024}", "-t $0")) + 'exec "$@"'
MOST = 1 << 16  # of its output are kept [bytes]
LATE = "nor long after by the clock: does it wait for something?"


def crowd():
    """By how much longer everything takes: the programs that want a processor, by processors."""
    return max(1, os.getloadavg()[0] / (os.cpu_count() or 1))


@contextlib.contextmanager
def clock(seconds, end):
    """Ends what takes longer by the clock, on a busy machine later: then its list is not empty."""
    late = []
    alarm = threading.Timer(crowd() * seconds, lambda: (late.append(True), end()))
    alarm.start()
    yield late
    alarm.cancel()


@dataclass
class Run:
    """What came out."""
    cases: list = field(default_factory=list)  # Catch2's XML of every test that ended
    tags: str = ""     # of the test in which it ended badly: "[1.1]"
    name: str = ""     # of that test
    fault: str = ""    # how it ended, in plain words, where it did not end well
    printed: str = ""  # what the tested code itself has printed


def run(program, ids, limit=LIMIT, answer=None, to_end=True):
    """Runs the tests of these exercises, or not `to_end`: until one fails. `answer` is the known
    answer to run (tools/check/answers.py)."""
    env = dict(os.environ, WORKBOOK_ANSWER=answer) if answer else None
    with tempfile.NamedTemporaryFile(prefix="joints_", suffix=".xml") as report:
        status, printed = process(
            [program, ",".join(f"[{id_}]" for id_ in ids), "-r", "xml", "-o", report.name,
             *["-a"] * (not to_end)],
            limit, env)
        cases, open_case, whole = read(report.read())
    own, library = apart(printed)
    result = Run(cases, printed=own)
    crash = next((case for case in cases if case.find(".//FatalErrorCondition") is not None), None)
    if crash is not None:
        cases.remove(crash)
        signal_ = crash.find(".//FatalErrorCondition").text or ""
        result.fault = crashes.plainly(f"{library}\n{signal_}")
    elif not whole:
        crash, result.fault = open_case, ending(status, limit)
    if crash is not None:
        result.tags, result.name = crash.get("tags", ""), crash.get("name", "")
    result.printed = "\n".join(filter(None, [*map(said, cases), own]))
    return result


def process(command, limit, env=None):
    """(exit status, what was printed) of a process with limits. It prints to a terminal of its own:
    into a pipe the last lines before a crash would be lost."""
    try:
        ours, its = os.openpty()
        tty.setraw(its)
    except OSError:  # a system without terminals, such as a bare container
        ours, its = os.pipe()
    child = subprocess.Popen(["sh", "-c", LIMITED, str(limit), *command],
                             stdin=subprocess.DEVNULL, stdout=its, stderr=its, env=env)
    os.close(its)
    kept = []
    listener = threading.Thread(target=listen, args=(ours, kept), daemon=True)
    listener.start()
    with clock(max(WAIT, 5 * limit), child.kill) as late:
        status = child.wait()
    listener.join(1)  # what it has left running in the background may print for ever
    os.close(ours)
    if status > 128:  # how what stands around it says by which signal it was ended
        status = 128 - status
    status = -signal.SIGALRM if late else status
    return status, b"".join(kept).decode(errors="replace")


def listen(terminal, kept):
    """Reads to the end, but keeps no more than the beginning."""
    size = 0
    try:
        while part := os.read(terminal, MOST):
            if size < MOST:
                kept.append(part[:MOST - size])
            size += len(part)
    except OSError:  # how a terminal says that nobody writes to it any more
        pass


def read(report):
    """(the tests that ended, the one that did not, whether the report is whole)."""
    parser, ended, begun, whole = ElementTree.XMLPullParser(("start", "end")), [], None, False
    parser.feed(report.replace(b"]]>", b"]]&gt;"))  # which Catch2 forgets where a text begins so
    try:
        for event, element in parser.read_events():
            if element.tag == "TestCase":
                begun = element if event == "start" else None
                ended += [element] if event == "end" else []
            whole = whole or (event == "end" and element.tag in ("Catch", "Catch2TestRun"))
    except ElementTree.ParseError:
        pass
    return ended, begun, whole


def ending(status, limit):
    """How a process ended that did not finish its report."""
    if status == -signal.SIGALRM:
        return f"it did not end within {limit} seconds, {LATE}"
    if status in (-signal.SIGXCPU, -signal.SIGKILL):
        return (f"it did not end within {limit} seconds: a loop without an end, or a number whose "
                "type is too small to reach it?")
    if status == -signal.SIGSYS:
        return ("it asked the system for something that no exercise needs, and was ended: a "
                "process, a thread, the network, a signal to a process, or the name or mode "
                "of a file")
    if status in (-signal.SIGSEGV, -signal.SIGBUS, -signal.SIGABRT):  # Catch2 crashed of it, too
        return crashes.plainly("corrupted size")
    if status == 97:
        return "no such answer"
    return "the program ended in the middle of a test: does the code call exit()?"


def thrown(words):
    """What was thrown in a test, in plain words; or how the process ended that was asked for an
    answer, see tests/remote/client.cpp."""
    words, is_remote = re.subn(r"\AExercise [\d.]+: ", "", words)
    match = is_remote and re.match(r"(.*)\nended with status (-?\d+)$", words, re.S)
    if not match:
        plain = crashes.plainly(words)
        return f"it threw an exception: {plain}" if plain == words else plain
    status = int(match[2]) if int(match[2]) <= 128 else 128 - int(match[2])
    own, library = apart(match[1])
    name = signal.Signals(-status).name if -status in set(signal.Signals) else ""
    last = f"{library}\n{name}"
    plain = crashes.plainly(last)
    return ending(status, LIMIT) if plain == last else plain


def apart(printed):
    """What the tested code printed, and the library's last words."""
    own, library = [], []
    for line in printed.split("\n"):
        (library if crashes.LIBRARY.match(line) else own).append(line)
    return "\n".join(own).strip("\n"), "\n".join(library)


def said(case):
    """What a test that ended has written to std::cout and std::cerr."""
    return "\n".join((case.findtext(f".//{stream}") or "").strip()
                     for stream in ("StdOut", "StdErr")).strip()


def said_in(program, name, limit=1):
    """What the code prints in one test, all of it in its order, up to a crash, too: with a report
    of this kind Catch2 leaves std::cout alone."""
    quoted = '"' + "".join("\\" + c if c in '\\",[]' else c for c in name) + '"'
    with tempfile.NamedTemporaryFile(prefix="joints_") as report:
        _, printed = process([program, quoted, "-r", "compact", "-o", report.name], limit)
    return apart(printed)[0]
