"""Runs an exercise's tests on a stub or on a known wrong or right answer and checks the outcome.

expect.py stub  TEST SOLUTION   every exercise has a test that fails with "not written yet"
expect.py wrong TEST ANSWER     the exercise's tests fail, in the words that the answer promises
expect.py right TEST ANSWER     the exercise's tests pass
"""
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tools"))
import exercises  # noqa: E402
import grade  # noqa: E402


def run(test, id_):
    result = subprocess.run([test, f"[{id_}]"], capture_output=True, text=True, timeout=60)
    output = result.stdout + result.stderr
    if "No test" in output or "No tests ran" in output:
        sys.exit(f"exercise {id_} has no test")
    return result.returncode, output


def check_stub(test, solution):
    ids = sorted({r.id for r in exercises.regions(Path(solution).read_text())})
    for id_ in ids:
        code, output = run(test, id_)
        if code == 0 or f"exercise {id_} is not written yet" not in output:
            sys.exit(f"the stub of {id_} does not say that it is not written yet:\n{output}")
    print(f"{len(ids)} exercises say that they are not written yet: {' '.join(ids)}")


def check_wrong(test, answer):
    id_, _, promise, _ = exercises.read_answer(Path(answer))
    if not promise:
        sys.exit(f"{answer}: lacks a line '// expects: words of the report'")
    code, output = run(test, id_)
    if code == 0:
        sys.exit(f"this wrong answer passes every test of {id_}")
    flat = " ".join(f"{output}\n{grade.plainly(output)}".split())  # what is told of a crash, too
    for words in promise:
        if " ".join(words.split()) not in flat:
            sys.exit(f"the report does not say '{words}':\n{output}")
    print(f"found out: {'; '.join(promise)}")


def check_right(test, answer):
    id_, *_ = exercises.read_answer(Path(answer))
    code, output = run(test, id_)
    if code != 0:
        sys.exit(f"a right answer of {id_} is called wrong:\n{output}")
    print(f"accepted as a right answer of {id_}")


if __name__ == "__main__":
    kind, program, file = sys.argv[1:]
    {"stub": check_stub, "wrong": check_wrong, "right": check_right}[kind](program, file)
