"""./wb compare FILE: every method on a scene of the reader's own, and which one to take."""
import json
import subprocess

from base import house

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
    return subprocess.run([house.BUILD / "comparison" / "compare_scene", *options],
                          cwd=house.CALLED_FROM).returncode
