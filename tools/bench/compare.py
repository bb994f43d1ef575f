"""./wb compare FILE: every method on a scene of the reader's own, and which one to take; a table
and a figure of error against run time. ./wb run 3 --compare: on the scene of a chapter."""
import json
import subprocess

from base import house
from pictures import figures

SCENE = """// Written by ./wb compare.
#include <joints.h>
using namespace joints;
#include {path}
int main(int argc, char** argv) {{
  return joints::compare_main([] {{ return make_world(); }}, argc, argv);
}}
"""
WANTED = ("a scene is a file with one function, World make_world() {...}; "
          "docs/which_method.md shows one")


def main(file, options):
    path = (house.CALLED_FROM / file).resolve()
    if not path.is_file():
        raise house.Trouble(f"compare: {file} is no file: {WANTED}")
    if "make_world" not in path.read_text(encoding="utf-8", errors="replace"):
        raise house.Trouble(f"compare: {file} has no make_world: {WANTED}")
    scene = house.BUILD / "comparison" / "scene.cpp"
    scene.parent.mkdir(parents=True, exist_ok=True)
    text = SCENE.format(path=json.dumps(str(path), ensure_ascii=False))
    if not scene.is_file() or scene.read_text(encoding="utf-8") != text:
        scene.write_text(text, encoding="utf-8")
    house.must_build(["compare_scene"])
    house.progress_done()
    return run([house.BUILD / "comparison" / "compare_scene", *options], path.stem)


def of_chapter(chapter, options):
    house.must_build(["compare_chapter"])
    house.progress_done()
    return run([house.BUILD / "tests" / "compare_chapter", str(chapter.number), *options],
               chapter.folder)


def run(command, name):
    """Runs it, keeps its table and draws the figure beside it; one that fails leaves nothing."""
    given = command.index("--csv") + 1 if "--csv" in command[:-1] else 0
    table = house.CALLED_FROM / command[given] if given else house.OUT / "compare" / f"{name}.csv"
    made = table.with_name(table.name + ".new")
    if given:
        command[given] = made
    else:
        made.parent.mkdir(parents=True, exist_ok=True)
        command += ["--csv", made]
    code = subprocess.run(command, cwd=house.CALLED_FROM).returncode
    if code == 0:
        made.replace(table)
        figures.draw("comparison.py", "--csv", table, figures=table.with_suffix(".svg"))
        print(f"\n{house.short(table)}\n{house.short(table.with_suffix('.svg'))}")
    made.unlink(missing_ok=True)
    return code
