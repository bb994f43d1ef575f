"""Several sources as one, which a compiler reads faster: gather.py OUT SOURCES...

The includes of the sources come first. Each source stands in a namespace of its own, so that they
may give the same name to different things, as in files of their own.
"""
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import exercises  # noqa: E402


def gathered(sources):
    """The text of the source that includes them all."""
    headers = {line for path in sources
               for line in re.findall(r"^#include [<\"].*", path.read_text(), re.M)}
    lines = ["// Made by tools/check/gather.py."] + sorted(headers)
    for path in sources:
        lines += [f"namespace {path.stem} {{", f'#include "{path}"', "}"]
    return "\n".join(lines) + "\n"


def main(arguments):
    if len(arguments) < 2:
        print(__doc__.split("\n", maxsplit=1)[0], file=sys.stderr)
        return 2
    out, *sources = map(Path, arguments)
    exercises.write_if_new(out, gathered(sources))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
