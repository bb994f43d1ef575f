"""What submissions try that is not theirs to do: attempts_test.py ROOT BUILD"""
import os
import re
import socket
import subprocess
import sys
from pathlib import Path

import attempts
from door import Door
from grade_test import FILE, IDS, STATES, Class, tree
from proofs import exercises, main, notes

from classroom import fence


def none_reaches_what_is_not_its_own(root, build):
    """forty attempts to read, write, signal, connect, fork, exec or stay: none succeeds"""
    if fence.refusal() or not fence.seccomp:
        notes.append("no fence or no python3-seccomp here: no attempt was made")
        return
    with Door(root, build) as door, socket.socket(type=socket.SOCK_DGRAM) as udp, \
            socket.socket() as tcp:
        door.lend_build()
        for one in (udp, tcp):
            one.bind(("127.0.0.1", 0))
            one.setblocking(False)
        os.environ["WORKBOOK_SECRET"] = "secret"
        try:
            yield from tried(Class(door), udp)
        finally:
            del os.environ["WORKBOOK_SECRET"]
        try:
            yield f"a submission has sent {udp.recv(9)}"
        except BlockingIOError:
            pass


def no_result_is_forged(root, build):
    """fifty attempts to write, end, replace or borrow: no wrong answer counts as right"""
    with Door(root, build) as door:
        door.lend_build()
        c = Class(door)
        passed = '<OverallResult success="true"/>'
        tests = "".join(f'<TestCase name="{id_}" tags="[{id_}]">{passed}</TestCase>'
                        for id_ in IDS)
        head = attempts.FORGER.format(perfect=f"<Catch2TestRun>{tests}</Catch2TestRun>")
        wrong, stub = c.solution, exercises.stub(c.solution)
        for id_, code in zip(IDS, ("return {};", "return 0;", "return 0;", "", "return 0;",
                                   "return {};")):
            wrong = c.answer(id_, code, wrong)
        for place in range(0, len(attempts.FORGED), len(IDS)):
            text = wrong
            for id_, code in zip(IDS, attempts.FORGED[place:]):
                text = c.answer(id_, code.format() + {"1.4": ""}.get(id_, answer_of(wrong, id_)),
                                text)
            c.put(f"inside_{place}/{FILE}", head + text)
        for place, code in enumerate(attempts.ABOVE):
            c.put(f"above_{place}/{FILE}", head + code.format() + "\n"
                  + c.answer("1.2", "return 0;", stub))
        for id_, code in attempts.BORROWED.items():
            c.put(f"borrowed_{id_}/{FILE}", c.answer(id_, code, stub))
        c.put(f"leak/{FILE}", attempts.LEAK + c.answer(  # beside one that has to be left out
            "1.2", "throw std::runtime_error(leak);", c.answer("1.5", "return nonsense;", stub)))
        c.put(f"steers/{FILE}", c.answer("1.2", '#error "\x1b[2J\u202e"\nreturn 0;', stub))
        yield from c.grade("", 1, "submissions")
        for name, row in c.table().items():
            if name != "done in all" and (float(row["points"]) or not {"wrong", "broken"} & {
                    *row.values()}):
                yield f"{name}: {list(row.values())}: {c.feedback(name)[:900]}"
        if '#error "?[2J?"' not in c.feedback("steers"):
            yield f"the feedback steers the terminal: {c.feedback('steers')!r}"
        if not c.feedback("leak").count("begin [exercise"):
            yield f"the feedback shows nothing of the file: {c.feedback('leak')}"
        if "glm::max(before" in c.feedback("leak"):
            yield "the feedback shows a solution"


def answer_of(text, id_):
    return "\n".join(next(region for region in exercises.regions(text)
                          if region.id == id_).answer())


def tried(c, udp):
    victim = c.door.root / "README.md"
    words = {"root": c.door.root, "victim": victim, "port": udp.getsockname()[1],
             "other": c.folder / "neighbour" / FILE}
    c.put(f"neighbour/{FILE}", c.solution)
    head, asked, vain = attempts.HEAD.format(**words), attempts.ASKED, attempts.VAIN
    expected = {"neighbour": ("DDDDDD", [])}
    for place in range(0, len(asked), len(IDS)):  # six in a file, each in front of a right answer
        text, name = c.solution, f"asks_{place}"
        for id_, code in zip(IDS, asked[place:]):
            text = c.answer(id_, "", text, own=code.format(**words))
        c.put(f"{name}/{FILE}", head + text)
        expected[name] = "WWWWWW", []
    text = c.solution
    for id_, place in zip(IDS, range(0, len(vain), 3)):
        text = c.answer(id_, "", text, own="\n".join(
            f"{{ static int n; if (n++ == 0 && ({one.format(**words)})) std::abort(); }}"
            for one in vain[place:place + 3]))
    c.put(f"vain/{FILE}", head + text)
    expected["vain"] = "DDDDDD", []
    for place, (code, said) in enumerate(attempts.SHUT.items()):
        c.put(f"shut_{place}/{FILE}", code.format(**words) + "\n" + c.solution)
        expected[f"shut_{place}"] = "BBBBBB" if "no part" in said else "DDDDDD", [said]
    before = tree(c.door.root)
    yield from c.grade("", 1, f"{len(expected)} submissions")
    yield from (f"{path} has changed" for path in
                {path for path, _ in set(before.items()) ^ set(tree(c.door.root).items())})
    for name, (states, sentences) in expected.items():
        row = c.table().get(name, {})
        if [row.get(id_) for id_ in IDS] != [STATES[state] for state in states]:
            yield f"{name}: {[row.get(id_) for id_ in IDS]}, not {states}"
        said = c.feedback(name)
        if states == "WWWWWW" and said.count("something that no exercise needs") < 6:
            yield f"{name}: not every attempt was ended: {said}"
        for sentence in sentences:
            if sentence not in said:
                yield f"{name}: '{sentence}' is not in {said[:1500]}"
        for secret in ("root:x:", "secret", "row_impulse(row.J"):
            if secret in said.replace("WORKBOOK_SECRET", ""):
                yield f"{name}: the feedback tells {secret}"
    left = subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True).stdout
    own = re.escape(str(c.door.root))
    if found := re.findall(rf"^{own}.*_answer_mine|^sleep 1000", left, re.M):
        yield f"left running: {found}"
    for path in ("/tmp/workbook_attempt", "/dev/shm/workbook_attempt"):
        if Path(path).exists():
            yield f"{path} was written"
            Path(path).unlink()


PROOFS = [no_result_is_forged, none_reaches_what_is_not_its_own]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
