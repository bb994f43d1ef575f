"""What a check has cost: the sum by kind, and the files that took the longest to compile."""
import re
from collections import Counter
from pathlib import Path

from base import house

# By where an object lies in the build folder; the first that fits.
KINDS = [("known answers", r"_answers_file|_stub\.dir"), ("units", r"_units"),
         ("tests of the exercises", r"/\d\d_\w+_tests"),
         ("topics", r"^tests/CMakeFiles/\w+_test(_float)?\.dir"),
         ("checker", r"^checker|^tests/CMakeFiles/checker"),
         ("programs", r"/\d\d_\w+_(run|experiments)"),
         ("solutions", r"^CMakeFiles/\d\d_"), ("engine", r"^engine/"), ("bench", r"^bench/")]
MOST = 5


def compiled(since):
    """{object: time by the clock [s]} of all that was compiled since then, see Ninja's log. With a
    process for each processor that is what it took of one."""
    found = {}
    for line in (house.BUILD / ".ninja_log").read_text().split("\n"):
        began, ended, _, path, *_ = [*line.split("\t"), "", "", "", ""]
        place = house.BUILD / path
        if path.endswith(".o") and place.exists() and place.stat().st_mtime >= since:
            found[Path(path)] = (int(ended) - int(began)) / 1000
    return found


def kind_of(path):
    return next((kind for kind, where in KINDS if re.search(where, str(path))), "oracle and scenes")


def named(path):
    """An object as one knows it: the target and the source."""
    target = re.search(r"(\w+)\.dir/", str(path))
    return f"{target[1]}, {path.stem.removesuffix('.o')}"


def listed(costs, most=None):
    return ", ".join(f"{what} {cost:.0f}" for what, cost in Counter(costs).most_common(most)
                     if cost >= 0.5)


def tell(since, built, run, scripts):
    """\\param scripts: {name: processor time [s]}"""
    objects, kinds = compiled(since), Counter()
    for path, cost in objects.items():
        kinds[kind_of(path)] += cost
    if objects:
        kinds["links and the rest"] = max(0, built - sum(objects.values()))
        print(f"  to build [s]: {listed(kinds)}")
        print(f"  the dearest files [s]: "
              f"{listed({named(path): cost for path, cost in objects.items()}, MOST)}")
    names = {Path(name).name: cost for name, cost in scripts.items()}
    programs = run - sum(scripts.values())
    print(f"  to run [s]: {listed({'test programs and known answers': programs, **names})}")
