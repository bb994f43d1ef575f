"""A reader's commands in a copy of the workbook, and their output: front_door_test.py ROOT BUILD"""
import json
import os
import re
import shutil
import subprocess
import sys

from door import CHAPTER, Door
from proofs import house, main, read

# Right, and it prints what could be taken for a part of the tests' report.
LOUD = """  std::cout << "]]> <?xml\\n";
  for (int k = 0; k < 20; ++k) std::printf("raw </StdOut> & <b>\\n");
  const vec3 n = direction(body2.x - body1.x);
  return {-n, vec3(0), n, vec3(0)};"""


def typed(door, words, status, *expected, hidden=(), wide=False):
    """What is wrong with the answer to ./wb with these words."""
    code, out, err, _ = door.type(words)
    said = " ".join((out + err).split())
    if code != status:
        yield f"./wb {words}: exit status {code}, not {status}: {said[-300:]}"
    for part in expected:
        if part not in said:
            yield f"./wb {words} does not say '{part}' but: {said[-600:]}"
    for part in hidden:
        if part in said:
            yield f"./wb {words} says '{part}'"
    for line in (out + err).split("\n"):
        if len(line) > 80 and not wide:
            yield f"./wb {words}: a line has {len(line)} columns: {line}"
    if "Traceback" in said:
        yield f"./wb {words}: {err[-600:]}"


def the_front_page_shows_a_real_report(root, build):
    """the report on docs/mainpage.md is the one of ./wb test 1.1 on a forgotten sign"""
    shown = read(root / "docs" / "mainpage.md").split("```\n")[1]
    with Door(root, build) as door:
        door.lend_build()
        door.write(e1_1="""  const vec3 n = direction(body2.x - body1.x);
  return {n, vec3(0), n, vec3(0)};""")
        _, out, _, _ = door.type("test 1.1")
        said = "\n".join(line.rstrip() for line in out.split("\n"))
        if shown.strip() not in said:
            yield f"docs/mainpage.md shows another report than {said}"


def a_fresh_copy_leads_to_the_first_exercise(root, build):
    """a fresh copy names exercise 1.1 within a second, from its texts alone"""
    with Door(root, build) as door:
        code, out, _, used = door.type("", ["./wb"])
        if code or "Next: exercise 1.1" not in out or f"  edit   chapters/{CHAPTER}" not in out:
            yield f"./wb, exit status {code}: {out[-300:]}"
        if used > 1:
            yield f"./wb takes {used:.1f} s of processor time"
        if len(out.strip().split("\n")) > 24:
            yield "./wb does not fit a terminal"
        yield from typed(door, "status", 0, " ".join(out.split()))
        yield from typed(door, "next", 0, "Next: exercise 1.1", hidden=["Chapter 1"])
        yield from typed(door, "list", 0, "Next: exercise 1.1", *every_exercise())
        yield from typed(door, "--version", 0, f"The Joint Workbook {house.version()}")
        yield from typed(door, "test 1.1", 1, "not written yet", "./wb hint 1.1")
        yield from typed(door, "test 1", 1, "1.6 Distance::jacobian, Distance::K: not written yet")
        yield from every_command_has_help(door)
        yield from typed(door, "hint 1.1", 0, "more: ./wb hint 1.1 2")
        if (door.root / "build").exists() or (door.root / "out").exists():
            yield "something was built or written for it"


def every_exercise():
    """The lines of ./wb list, without where they stand, as words with one blank between."""
    for chapter in house.chapters():
        yield f"Chapter {chapter.number}: {chapter.name} 0 of {len(chapter.ids())} done"
        for id_ in chapter.ids():
            yield f"{id_} {chapter.titles()[id_]} not written yet"


def every_command_has_help(door):
    """What ./wb help lists has a help of its own, in both ways of asking."""
    yield from typed(door, "help", 0, "./wb test 2.1", "./wb tour", "--methods --help")
    _, overview, _, _ = door.type("help")
    for name in sorted(set(re.findall(r"^  \./wb ([\w-]+)", overview, re.M))):
        yield from typed(door, f"{name} --help", 0, f"usage: ./wb {name}", hidden=["./wb tour run"])
        if door.type(f"help {name}")[:3] != door.type(f"{name} -h")[:3]:
            yield f"./wb help {name} and ./wb {name} -h differ"


def bad_words_are_refused(root, build):
    """a command line that makes no sense gets a line that says what is allowed, and status 2"""
    with Door(root, build) as door:
        for words, said in (
                ("test", "required: what (./wb test --help)"), ("test 1.1 2.1", "arguments: 2.1"),
                ("test 1.1 --foo", "arguments: --foo"), ("Test 1.1", "did you mean ./wb test?"),
                ("tset", "did you mean ./wb test?"), ("solve", "did you mean ./wb show?"),
                ("1.1", "did you mean ./wb test 1.1?"), ("--whole 2", "no such command"),
                ("--out", "no such command"), ("help nothing", "nothing: no such command"),
                ("hint", "required: exercise"),
                ("hint 19.9", "19.9: no such chapter"), ("hint 1.9", "chapter 1 has 1.1 1.2"),
                ("hint 1.1 4", "1, 2 and 3"), ("run", "required: chapter"),
                ("run --foo", "required: chapter"), ("run 1 --out x", "--out"),
                ("plot 1 2", "arguments: 2"), ("live 1 2", "arguments: 2"),
                ("live 19", "19: no such chapter"), ("reset", "required: what"),
                ("tour now", "arguments: now"), ("reset 1.1 --kep", "did you mean --keep?"),
                ("check 1 --quik", "did you mean --quick?"),
                ("bench --loop --cost", "one table at a time"),
                ("bench --cost --scene S1", "--cost --scene")):
            code, out, err, _ = door.type(words)
            if code != 2 or out or err.count("\n") != 1 or said not in err:
                yield f"./wb {words}: exit status {code}, says {out!r} {err!r}, not '{said}'"
            if len(err) > 81:
                yield f"./wb {words}: {len(err)} columns: {err}"


def a_damaged_file_is_told(root, build):
    """what is wrong with an exercise file's lines is told before anything is built, and mended"""
    with Door(root, build) as door:
        begin, end = "// begin [exercise 1.2]\n", "// end [exercise 1.2]\n"
        for old, new, said in (
                (end, "", f"'{end.strip()}' is missing"),
                (begin, "", f"'{begin.strip()}' is missing"),
                (end, end + begin + end, "exercise 1.2 begins in line"),
                ('todo("1.2");', "if (true) {", "exercise 1.2: the { of this line"),
                ('todo("1.2");', "return 1; }", "exercise 1.2: the } of this line"),
                ('todo("1.2");', "/* return 1;", "exercise 1.2: the comment"),
                ('#include "', '#include "tests/checker/cases.h"\n#include "',
                 "includes tests/checker/cases.h, which is no part of an exercise")):
            door.write(e1_1=True)
            door.change(old, new)
            yield from typed(door, "test 1.1", 1, "cannot be built", said, "Next: ")
            yield from typed(door, "reset 1.2 --yes", 0, "the stub is back for 1.2")
            yield from typed(door, "test 1.2", 1, "not written yet", hidden=["Note:"])
            if "todo(\"1.1\")" in read(door.file):
                yield f"reset 1.2 has thrown away 1.1, after {said}"
        door.file.unlink()
        yield from typed(door, "", 0, "is not there. Next: ./wb reset 1")
        yield from typed(door, "test 1.1", 1, "is not there. Next: ./wb reset 1")
        yield from typed(door, "reset 1.1", 0, "the stub is back")
        yield from typed(door, "test 1.1", 1, "not written yet")
        yield from typed(door, "reset 1.1", 0, "nothing to put back")


def an_answer_is_judged_alone(root, build):
    """an exercise is judged, shown with its output, whatever the others of its file do"""
    with Door(root, build) as door:
        door.lend_build()
        endless = "while (true) std::this_thread::sleep_for(std::chrono::seconds(1));"
        door.write(e1_1=LOUD, e1_2=endless)
        door.change("#include", "#include <iostream>\n#include <thread>\n#include")
        door.change("row.K = rod.K(body1, body2);", "row.K = 1 * rod.K(body1, body2);")
        yield from typed(door, "test 1.1", 0, "1.1 CentreDistance::jacobian: done",
                         "your code prints:", "]]> <?xml", "raw </StdOut> & <b>", "lines more",
                         "Next: ./wb test 1.2", "changed outside the exercises, in line 5",
                         "./wb reset 1 --keep")
        yield from typed(door, "", 0, "1.2 CentreDistance::K wrong", "Next: 1.2 is not right yet")
        yield from typed(door, "run 1", 2, "1.2 does not end")
        door.change(endless, "return 2;")
        yield from typed(door, "test 1.2", 1, "1.2 CentreDistance::K: wrong",
                         f"Where: chapters/{CHAPTER}/distance.cpp:")
        code, out, _, used = door.type("")
        if "1.1  CentreDistance::jacobian                     done" not in out or used > 1:
            yield f"./wb, when all is known, takes {used:.1f} s and says {out}"
        yield from typed(door, "run 1 --seconds 0.1", 0, "1.2 is not right yet: ./wb test 1.2",
                         "your code: 1.1 1.2 the solution's: 1.3")
        yield from typed(door, "reset 1 --keep", 0, "around your answers")
        if "return 2;" not in read(door.file) or "1 * rod" in read(door.file):
            yield "reset 1 --keep does not keep the answers, or not put the rest back"


def crashes_are_told(root, build):
    """a crash is reported in plain words, with its place and the next thing to do"""
    crashes = {
        "1.1": ("vec3* p = nullptr; if (body1.inverse_mass > 9) p = new vec3(0); p->x = 1;\n"
                "  return {*p, *p, *p, *p};", "it reached for memory that is not its own"),
        "1.2": ("std::vector<real> v; return v[int(body1.inverse_mass)];",
                "an index outside a vector"),
        "1.4": ("step(bodies, links, settings); bodies[0].v.x += 1;", "calls itself without end"),
        "1.5": ("const int n = int(sum) / 1000; return real(3 / n);",
                "a whole number was divided by zero"),
        "1.6": ('[]() noexcept { throw std::runtime_error("too far"); }(); return {};',
                "an exception that nothing catches, std::runtime_error: too far")}
    with Door(root, build) as door:
        door.lend_build()
        door.write(**{f"e{id_.replace('.', '_')}": code for id_, (code, _) in crashes.items()})
        door.change("#include", "#include <stdexcept>\n#include")
        for id_, (_, said) in crashes.items():
            yield from typed(door, f"test {id_}", 1, f"{id_} ", "wrong", said,
                             f"Where: chapters/{CHAPTER}/distance.cpp:", f"./wb hint {id_}")


def refusals_of_the_compiler_are_told(root, build):
    """what the compiler refuses is told with its exercise and a plain sentence"""
    with Door(root, build) as door:
        door.lend_build()
        door.write(e1_1="vec3 n; real a; return {a * n, n, n, n};")
        yield from typed(door, "test 1.2", 1, "not written yet")
        yield from typed(door, "test 1.1", 1, "does not compile", "lies in exercise 1.1, line",
                         "a variable is read before it is set", "mend it, then ./wb test 1.1",
                         hidden=["-std=", "warning:"], wide=True)
        yield from typed(door, "run 1", 2, "does not compile")
        for id_, code, said in (
                ("1.1", "return {vec3(0), vec3(0), vec3(0), vec3(0)}", "ends with a semicolon"),
                ("1.2", "return 1 / body1.mass;", "a Body has no mass. It has x, q, v, w, inv"),
                ("1.4", "body1.v = vec3(0);", "Body& body1 = bodies[link.body1];"),
                ("1.5", "return before;", "no line above declares before"),
                ("1.6", "return 1 / vec3(1);", "real(1) / v, not 2 * v and 1 / v"),
                ("1.6", "return inverse_inertia(body1, body2);", "with other arguments than"),
                ("1.3", "return J.v1;", "stands where another of them is meant")):
            door.write(**{"e" + id_.replace(".", "_"): code})
            yield from typed(door, f"test {id_}", 1, f"lies in exercise {id_}, line", said,
                             wide=True)


def a_debugger_gets_one_exercise(root, build):
    """./wb test --debug builds the tests of the exercise at the cursor, and says where it begins"""
    name = f"{CHAPTER}_test_mine"
    with Door(root, build) as door:
        door.lend_build("build/debug", {name: f"tests/{name}"})
        door.write(e1_1=True)
        lines = read(door.file).split("\n")
        begin = lines.index("  // begin [exercise 1.2]") + 1
        place = lines.index('  todo("1.2");') + 1
        program = f"build/debug/tests/{name}"
        for words in (f"chapters/{CHAPTER}/distance.cpp:{begin}", "1.2"):
            yield from typed(door, f"test {words} --debug", 0, f"distance.cpp:{place}",
                             f"{program} '[1.2]'", wide=True)
        only = ["--input-file", "build/debug/exercise.txt", "--list-tests"]
        listed = subprocess.run([program, *only], cwd=door.root, capture_output=True,
                                text=True).stdout
        cases = read(root / "tests" / CHAPTER / "test.cpp")
        known = re.findall(r'^TEST_CASE\("(1\.2 .*)", "', cases, re.M)
        if not known or re.findall(r"^  (\d\.\d .*)$", listed, re.M) != known:
            yield f"the debugger runs {listed}, not {known}"
        door.change('todo("1.2");', "return nothing;")
        yield from typed(door, "test 1.2 --debug", 1, "does not compile", "lies in exercise 1.2",
                         wide=True)


def the_editor_types_what_there_is(root, build):
    """the tasks of .vscode type commands that there are, and F5 starts one of them"""
    tasks, launch = (json.loads(read(root / ".vscode" / f"{name}.json"))
                     for name in ("tasks", "launch"))
    with Door(root, build) as door:
        for task in tasks["tasks"]:
            for key, value in {"${relativeFile}": f"chapters/{CHAPTER}/distance.cpp",
                               "${lineNumber}": "12", "${input:step}": "1", "'": ""}.items():
                task["command"] = task["command"].replace(key, value)
            words = task["command"].removeprefix("./wb ")
            if words.startswith("hint") and not words.endswith("--debug"):
                yield from typed(door, words, 0, "Hint 1 of 3 for 1.1")
            elif words.startswith("test") and not words.endswith("--debug"):
                yield from typed(door, words, 1, "1.1 CentreDistance::jacobian: not written yet")
            else:
                yield from typed(door, f"{words.split()[0]} --help", 0, "usage: ")
    labels = [task["label"] for task in tasks["tasks"]]
    for one in launch["configurations"]:
        if one["preLaunchTask"] not in labels:
            yield f".vscode/launch.json starts {one['preLaunchTask']}: there is no such task"


def who_skips_chapters_goes_on_there(root, build):
    """whoever begins with chapter 2 is led on in chapter 2, and told what is open before it"""
    with Door(root, build) as door:
        file = door.root / "chapters" / "02_ball" / "ball.cpp"
        text = read(file)
        file.write_text(text.replace('todo("2.1");', 'const int k = 3;\n  todo("2.1");', 1),
                        encoding="utf-8")
        yield from typed(door, "", 0, "Next: exercise 2.1", "The first open one: 1.1")


def bare(door, words, user, answer, *programs):
    """(what ./wb says, what it asks apt-get) where nothing is installed but these programs, all of
    which write what they are asked. Without an answer nobody sits at a terminal."""
    folder = door.root.parent / "bare"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    for name in ("sh", "dirname", "env", "mktemp", "tail", "uname", "rm"):
        (folder / name).symlink_to(shutil.which(name))
    asked = folder / "asked"
    asked.touch()
    for name, does in {"id": f"echo {user}", "sudo": 'exec "$@"',
                       "apt-get": f'echo "$*" >>{asked}\n[ "$3" = update ]'}.items():
        if name in ("id", *programs):
            (folder / name).write_text(f"#!/bin/sh\n{does}\n")
            (folder / name).chmod(0o755)
    ours, theirs = os.openpty()
    os.write(ours, f"{answer}\n".encode())
    result = subprocess.run(
        ["./wb", *words.split()], cwd=door.root, capture_output=True, text=True, timeout=60,
        stdin=subprocess.DEVNULL if answer is None else theirs,
        env={"PATH": str(folder), "TMPDIR": str(folder), "WORKBOOK_PYTHON": sys.executable})
    os.close(ours)
    os.close(theirs)
    return result.stdout + result.stderr, asked.read_text()


def nothing_is_installed_unasked(root, build):
    """packages are installed by a yes, or by root's setup, check, tour, docs, live; else named"""
    missing = "g++ cmake ninja-build"
    command = f"apt-get install --no-install-recommends {missing}"
    with Door(root, build) as door:
        for words, user, answer, programs, said, installs in (
                ("", 0, None, [], f"Install them: {command}", False),
                ("", 0, "y", [], f"Install them: {command}", False),
                ("", 1000, None, ["sudo"], f"Install them: sudo {command}", False),
                ("help", 0, "y", [], f"Install them: {command}", False),
                ("check --help", 0, None, [], f"Install them: {command}", False),
                ("test 1.1", 0, None, [], f"Install them: {command}", False),
                ("test 1.1", 0, "n", [], "Nothing was installed.", False),
                ("test 1.1", 0, "y", [], f"installing {missing}", True),
                ("test 1.1", 1000, "y", ["sudo"], f"installing {missing}", True),
                ("test 1.1", 1000, "y", [], f"Install them as root: {command}", False),
                ("check", 0, None, [], f"installing {missing}", True),
                ("tour", 0, None, [], f"installing {missing}", True),
                ("docs", 0, None, [], f"installing {missing}", True),
                ("setup", 0, None, [], f"installing {missing} pkg-config", True),
                ("setup", 1000, None, [], f"Install them as root: {command}", False),
                ("live", 0, None, [], f"installing {missing} clang lld", True),
                ("live 3", 1000, None, [], "Without them: ./wb see plays the recorded", False),
                ("check", 0, "n", [], "Nothing was installed.", False),
                ("check", 1000, None, ["sudo"], f"Install them: sudo {command}", False),
                ("check", 1000, None, [], f"Install them as root: {command}", False)):
            out, asked = bare(door, words, user, answer, "apt-get", *programs)
            if said not in out or installs != (f"--no-install-recommends {missing}" in asked):
                yield f"./wb {words}, user {user}, answer {answer}: {out!r}, apt-get: {asked!r}"
            if asked and not installs:
                yield f"./wb {words}, user {user}, answer {answer} asks apt-get {asked!r}"
        out, _ = bare(door, "", 0, None)
        if f"Missing here: {missing}" not in out:
            yield f"./wb without apt-get: {out!r}"


PROOFS = [a_fresh_copy_leads_to_the_first_exercise, the_front_page_shows_a_real_report,
          bad_words_are_refused, a_damaged_file_is_told,
          an_answer_is_judged_alone, crashes_are_told, refusals_of_the_compiler_are_told,
          a_debugger_gets_one_exercise, the_editor_types_what_there_is,
          who_skips_chapters_goes_on_there, nothing_is_installed_unasked]

if __name__ == "__main__":
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
