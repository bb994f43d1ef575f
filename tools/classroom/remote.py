"""The functions of an exercise file, and the two sides of a call to them, see tests/remote/wire.h:
remote.py client|server SOLUTION OUT

`client` is the solution's file, where each function with an exercise in it asks the process of the
answer; what is given in it stays. `server` serves these functions. A function whose arguments are
more than values is written by hand, in tests/remote/NN_name.h.
"""
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import exercises  # noqa: E402

ROOT = Path(__file__).absolute().parents[2]
HEAD = re.compile(r"^((?:template <class \w+>\n)?)(\w[\w:<>, ]*?) ((?:\w+::)?\w+)\(([^{;]*?)\)"
                  r"( const)? \{\n", re.M)
NAMESPACE = "joints::testing::remote"


@dataclass
class Function:
    """A function with an exercise in it."""
    id: str
    at: int        # where its lines begin in the text
    template: str  # its first line; "": it is none
    result: str
    name: str      # with its class
    arguments: list  # (type, name)
    const: str

    def signature(self, *own):
        return f"{self.result}({', '.join([*own, *(type_ for type_, _ in self.arguments)])})"

    def names(self):
        return ", ".join(name for _, name in self.arguments)

    @property
    def owner(self):
        """The argument that a member function has before the others."""
        kind = self.name.partition("::")[0] if "::" in self.name else ""
        return [f"{self.const.strip()} {kind}&".strip()] if kind else []


def functions(text):
    """Those of a solution."""
    lines = text.split("\n")
    heads = list(HEAD.finditer(text))
    for region in exercises.regions(text):
        place = len("\n".join(lines[:region.begin]))
        head = [match for match in heads if match.end() <= place][-1]
        yield Function(region.id, head.end(), head[1], head[2], head[3], list(arguments(head[4])),
                       head[5] or "")


def arguments(text):
    """(type, name) of each."""
    while (flat := re.sub(r"<([^<>,]*),", r"<\1;", text)) != text:
        text = flat
    for one in text.split(","):
        one = " ".join(one.replace(";", ",").replace("[[maybe_unused]]", "").split())
        yield tuple(one.rsplit(" ", 1))


def by_hand(folder):
    """What the header of a chapter has, where there is one: (its include, names of functions)."""
    path = ROOT / "tests" / "remote" / f"{folder}.h"
    text = path.read_text() if path.is_file() else ""
    return [f'#include "tests/remote/{folder}.h"'] * bool(text), re.findall(r"^// By hand: (\w+)$",
                                                                           text, re.M)


def client(text, folder):
    include, hand = by_hand(folder)
    for one in reversed({one.at: one for one in functions(text)}.values()):
        own = ["*this"] * bool(one.owner)
        values = ", ".join([f'"{one.id}"', f'"{one.name}"', "nullptr", *own,
                            *(name for _, name in one.arguments)])
        call = f"by_hand::{one.name}({one.names()})" if one.name in hand else \
            f"{NAMESPACE}::Function<{one.signature(*one.owner)}>::call({values})"
        end = " return;" if one.result == "void" else ""
        text = f"{text[:one.at]}  {'' if end else 'return '}{call};{end}\n{text[one.at:]}"
    return "\n".join(['#include "tests/remote/function.h"', *include, text])


def server(text, folder):
    include, hand = by_hand(folder)
    said = [*re.findall("^#include .*", text, re.M), '#include "tests/remote/function.h"', *include,
            f"void {NAMESPACE}::serve_all() {{", "using namespace joints;"]
    for one in {one.at: one for one in functions(text)}.values():
        own = [f"{owner} self" for owner in one.owner]
        name = f"self.{one.name.partition('::')[2]}" if own else one.name
        call = (f'Function<{one.signature(*one.owner)}>::serve("{one.name}", []('
                + ", ".join([*own, *map(" ".join, one.arguments)])
                + f") {{ return {name}({one.names()}); }});")
        number = one.template[len("template <class "):-2]
        for kind in instances(text, one.name) if number else [""]:
            said += [re.sub(rf"\b{number}\b", kind, call) if number else call] * (
                one.name not in hand)
    return "\n".join([*said, *["by_hand::serve();"] * bool(hand), "}\n"])


def instances(text, name):
    """What a template is made of: "real", "Lanes"."""
    return [re.search(r"<(\w+)>", line)[1] for line in
            re.findall(rf"^template \w+ {name}\((.*)\);$", text, re.M)]


# ---- in objects ----------------------------------------------------------------------------------

def symbols(path, text):
    """{exercise: the symbols of its functions} in the object of a file; under "" the others."""
    table = [subprocess.run(["nm", "--defined-only", *option, path], capture_output=True, text=True,
                            check=True).stdout.splitlines() for option in ([], ["-C"])]
    found = {}
    for plain, shown in zip(*table):
        kind, name = shown.split(" ", 2)[1:]
        id_ = next((one.id for one in functions(text)
                    if re.search(rf"(^| )joints::{one.name}(<.*>)?\(", name)), "")
        if kind in "TW":
            found.setdefault(id_, []).append(plain.split(" ", 2)[2])
    return found


def uses(path, own, tests):
    """{exercise: the others that it needs}: what the functions of the solution's object call, and
    what has a test with it."""
    said = subprocess.run(["objdump", "-r", path], capture_output=True, text=True,
                          check=True).stdout
    calls = {}
    for part in said.split("RELOCATION RECORDS FOR [")[1:]:
        name, _, lines = part.partition("]:")
        calls[name.removeprefix(".text.")] = set(re.findall(r"(_Z\w+)", lines))
    for tags in re.findall(r'"((?:\[\d+\.\d+\]){2,})"', tests):
        together = {name for id_ in re.findall(r"[\d.]+", tags) for name in own[id_]}
        for name in together:
            calls[name] = calls.get(name, set()) | together
    found = {}
    for id_ in own:
        reached, left = set(), set(own[id_])
        while left:
            reached |= left
            left = {name for one in left for name in calls.get(one, ())} - reached
        found[id_] = sorted(other for other in own if other not in ("", id_)
                            and reached.intersection(own[other]))
    return found


if __name__ == "__main__":
    kind, solution, out = sys.argv[1:]
    exercises.write(out, {"client": client, "server": server}[kind](
        exercises.read(solution), Path(solution).parent.name))
