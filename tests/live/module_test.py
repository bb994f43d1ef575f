"""The live page's module does what a native program does: module_test.py ROOT BUILD

Without a browser: node takes worker and modules out of the page. Skipped, with exit status 77,
where node or the packages that make WebAssembly are missing.
"""
import json
import re
import shutil
import subprocess
import sys

from made import ANSWERS, exercises, house, live, page, skip_without

from door import Door
from pictures import pages
from proofs import main

STEPS = 300
CLOSE = 1e-9  # of places [m] and quaternions
# Chaotic: sin, cos and atan2 of two C libraries differ in the last digit, and that grows.
EARLY = {"heavy": 30}


def asked(where, questions):
    """The answers of a page's worker."""
    result = subprocess.run(["node", house.ROOT / "tests" / "live" / "module.js", where],
                            input="\n".join(map(json.dumps, questions)), capture_output=True,
                            text=True, timeout=1800)
    if result.returncode:
        raise RuntimeError(result.stderr[-500:])
    return [json.loads(line) for line in result.stdout.splitlines()]


def load(label):
    return {"what": "load", "label": label}


def make(about, name, **settings):
    """The question that makes a scene, as it begins by itself but for some settings."""
    scene = next(scene for scene in about["scenes"] if scene["name"] == name)
    return {"what": "make", "name": name,
            "settings": {**dict(zip(about["settings"], scene["begin"])), **settings}}


def native(build, steps):
    """What the native program prints: {scene: numbers}."""
    out = subprocess.run([build / "tests" / "live_digits", str(steps)], capture_output=True,
                         text=True, check=True).stdout
    return {line.split()[0]: [float(word) for word in line.split()[1:]]
            for line in out.splitlines()}


def the_digits_are_the_same(root, build):
    """after 300 steps all bodies of every scene are where the native program has them"""
    where = page(build, "module")
    about = asked(where, [load("the solution")])[0]
    for steps in {STEPS, *EARLY.values()}:
        names = [scene["name"] for scene in about["scenes"]
                 if EARLY.get(scene["name"], STEPS) == steps]
        questions = [load("the solution")]
        for name in names:
            questions += [make(about, name), {"what": "steps", "count": steps},
                          {"what": "errors", "most": 10}]
        answers, wanted = asked(where, questions)[1:], native(build, steps)
        for name, (_, done, left) in zip(names, zip(*[iter(answers)] * 3)):
            here = done["state"][3:] + left["errors"] + [left["rate"]]
            if len(here) != len(wanted[name]):
                yield f"{name}: {len(here)} numbers, {len(wanted[name])} by the native program"
            off = max(abs(a - b) for a, b in zip(done["state"][3:], wanted[name]))
            if not off < CLOSE:
                yield f"{name}: {off:.2g} off after {steps} steps"
            for a, b in zip(here[-12:], wanted[name][-12:]):  # quotients of small numbers too
                if not abs(a - b) <= 1e-3 * max(abs(b), 1e-6):
                    yield f"{name}: error or rate within the step {a:.6g}, native {b:.6g}"


def a_look_changes_nothing(root, build):
    """looking into a step leaves the run as it was"""
    where = page(build, "module")
    about = asked(where, [load("the solution")])[0]
    steps = {"what": "steps", "count": 20}
    looks = [{"what": "look", "iterations": 3, "blocks": 2}, {"what": "errors", "most": 30}]
    for scene in about["scenes"]:
        name = scene["name"]
        plain = asked(where, [load("the solution"), make(about, name), steps, steps])
        looked = asked(where, [load("the solution"), make(about, name), steps, *looks, steps])
        if plain[-1]["state"] != looked[-1]["state"]:
            yield f"{name}: goes on otherwise after a look"


def refusals_are_sentences(root, build):
    """what the engine refuses comes back as its sentence, and the run goes on"""
    where = page(build, "module")
    about = asked(where, [load("the solution")])[0]
    settings = make(about, "chain")["settings"]
    for name, value, said in (("beta", -1, "beta is -1"), ("beta", 11, "beta is 11"),
                              ("iterations", 0, "iterations: there must be at least one"),
                              ("relaxation", 2, "relaxation is 2; must be above 0 and below 2"),
                              ("h", 0, "h is 0; must be from 1e-9"),
                              ("substeps", 0, "substeps: there must be at least one"),
                              ("damping", -1, "damping is -1"), ("ratio", 0, "ratio is 0")):
        answers = asked(where, [
            load("the solution"), make(about, "chain"), {"what": "steps", "count": 5},
            {"what": "set", "settings": {**settings, name: value}}, {"what": "steps", "count": 5}])
        if said not in answers[3].get("refused", ""):
            yield f"{name} = {value}: {answers[3]}, not '{said}'"
        if abs(answers[4]["state"][0] - 10 / 60) > 1e-9:
            yield f"{name} = {value}: the run does not go on: {answers[4]}"


def wrong_answers_are_told(root, build):
    """a reader's code that throws, crashes or never ends is told, and the page goes on"""
    where = page(build, "module")
    about = asked(where, [load("the solution")])[0]
    one = {"what": "steps", "count": 1}
    for label, (_, said) in ANSWERS.items():
        tried = {**one, "patience": 1000} if said is None else one
        answers = asked(where, [load(label), make(about, "pendulum"), tried, load(label),
                                make(about, "box"), one])
        if not (answers[2].get("ended") if said is None else
                said in answers[2].get("refused", "")):
            yield f"{label}: {answers[2]}"
        if answers[5]["state"][0] == 0:
            yield f"{label}: a scene that does not use it does not run: {answers[5]}"


def a_reader_gets_a_page(root, build):
    """./wb live 1 runs the reader's code beside the solution, and an edit is there within 6 s"""
    with Door(root, build) as door:
        shutil.copytree(root / "docs", door.root / "docs", dirs_exist_ok=True)
        shutil.copytree(build / "live", door.root / "build" / "live", symlinks=True)
        door.write(e1_1=True)
        door.type("live 1")
        door.change("// begin [exercise 1.1]", "// edited\n// begin [exercise 1.1]")
        code, out, err, used = door.type("live 1")
        if code or "out/live_01_distance.html" not in out or "your 1.1; the solution's" not in out:
            yield f"./wb live 1, exit status {code}: {out}{err}"
            return
        if used > 6:
            yield f"./wb live 1 takes {used:.1f} s of processor time after an edit"
        text = (door.root / "out" / "live_01_distance.html").read_text()
        labels = re.findall(r'"label":"([^"]+)"', text)
        if labels != ["yours", "the solution"]:
            yield f"the page's modules are {labels}"
        own = text.replace(pages.three(), "")  # without the names of its authors
        if "https:" in own or "http:" in own:
            yield "the page names an address of the network"
        door.file.write_text(exercises.read(door.file).replace("return", "retrun", 1))
        line = door.file.read_text().split("retrun")[0].count("\n") + 1
        code, _, err, _ = door.type("live 1")
        if code != 2 or f"chapters/01_distance/distance.cpp:{line}:" not in err:
            yield f"what does not compile in line {line}, exit status {code}: {err[:300]}"


PROOFS = [the_digits_are_the_same, a_look_changes_nothing, refusals_are_sentences,
          wrong_answers_are_told, a_reader_gets_a_page]

if __name__ == "__main__":
    skip_without("the live page's module", live.missing() + [
        "nodejs"] * (shutil.which("node") is None))
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
