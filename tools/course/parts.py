"""What the course in a browser is packed from: the compiler, headers, objects."""
import base64
import gzip
import hashlib
import json
import lzma
import os
import re
import shutil
import struct
import subprocess
import tarfile
import tempfile
from pathlib import Path

from base import exercises, house
from check import answers, judging
from website import live

HERE = house.ROOT / "docs" / "course"
BUILD = house.BUILD / "course"
PACKAGES = json.loads((HERE / "packages.json").read_text())
WASI, CLANG = Path("/usr/include/wasm32-wasi"), "/usr/lib/llvm-*/lib/clang/*"
# Read by the compiler once, when the course is packed. Other headers of a reader are there, too.
STANDARD = """algorithm array cassert cmath cstdint cstdio cstdlib cstring deque functional iostream
    limits list map memory numbers numeric optional queue set span sstream stdexcept string tuple
    type_traits utility vector""".split()
UNITS = '-O0 -DJOINTS_REAL=joints::Quantity -DJOINTS_REAL_HEADER=\\"tests/checker/quantity.h\\"'
FLAGS = [*live.FLAGS, "-O1"]


def missing(npm=True):
    """What is not there, by Debian's names."""
    names = {"nodejs": "node", "npm": "npm" if npm else "node"}
    return live.missing() + [name for name, tool in names.items() if not shutil.which(tool)]


def package(name, known=None):
    """The file that is taken of a package of npm: fetched once, and only as it was when its hash
    was written down, in packages.json or in `known`."""
    known = known or PACKAGES[name]
    folder = BUILD / "npm" / name / known["version"]
    if (folder / known["take"]).exists():
        return folder / known["take"]
    house.progress(f"fetching {name}")
    folder.parent.mkdir(parents=True, exist_ok=True)
    # Two that fetch at once do not see each other's half.
    with tempfile.TemporaryDirectory(dir=folder.parent) as apart:
        got = subprocess.run(["npm", "pack", "--silent", f"{name}@{known['version']}"], cwd=apart,
                             capture_output=True, text=True)
        if got.returncode:
            raise house.Trouble(f"npm cannot fetch {name} {known['version']}:\n{got.stderr[-500:]}")
        archive = Path(apart, got.stdout.split()[-1])
        kind, _, wanted = known["integrity"].partition("-")
        if base64.b64encode(hashlib.new(kind, archive.read_bytes()).digest()).decode() != wanted:
            raise house.Trouble(f"{name} {known['version']} has changed: its {kind} differs")
        with tarfile.open(archive) as parts:
            for part in parts.getmembers():
                path = part.name.partition("/")[2]
                if part.isfile() and (path == known["take"] or re.match("licen[sc]e", path, re.I)):
                    (Path(apart) / path).parent.mkdir(parents=True, exist_ok=True)
                    (Path(apart) / path).write_bytes(parts.extractfile(part).read())
                    (folder / path).parent.mkdir(parents=True, exist_ok=True)
                    (Path(apart) / path).replace(folder / path)
    return folder / known["take"]


def packed(target, data):
    """Writes data packed by xz or, for node, by gzip; what was packed before is copied."""
    kept = BUILD / "packed" / (hashlib.sha256(data).hexdigest() + target.suffix)
    if not kept.exists():
        house.progress(f"packing {target.name}")
        kept.parent.mkdir(parents=True, exist_ok=True)
        kept.write_bytes(lzma.compress(data, check=lzma.CHECK_CRC32) if target.suffix == ".xz"
                         else gzip.compress(data, mtime=0))
    shutil.copyfile(kept, target)


def pack(target, files):
    """Writes a pack, {path: bytes}, see docs/course/pack.js."""
    index = json.dumps([[path, len(data)] for path, data in files.items()]).encode()
    packed(target, b"".join([struct.pack("<I", len(index)), index, *files.values()]))


def licences():
    """The terms of all that is handed on: of clang and the libraries as Debian has them, and of the
    packages of npm."""
    debian = [Path("/usr/share/doc") / name / "copyright" for name in
              ("libc++-14-dev-wasm32", "libc++-dev-wasm32", "wasi-libc", "libglm-dev")]
    ours = [(name, BUILD / "npm" / name / known["version"]) for name, known in PACKAGES.items()]
    texts = [("The Joint Workbook", house.ROOT / "LICENSE"),
             ("Compiler (@yowasp/clang, LLVM) and libc++: the Apache License 2.0, with the LLVM "
              "Exceptions below", Path("/usr/share/common-licenses/Apache-2.0")),
             *((f"{path.parent.name} of Debian", path) for path in debian),
             *((name, path) for name, folder in ours for path in folder.glob("LICEN*"))]
    return "\n".join(f"==== {name} ====\n\n{path.read_text(errors='replace')}"
                     for name, path in texts if path.exists())


# ---- objects -------------------------------------------------------------------------------------

def sources():
    """{object: (sources that are compiled as one, flags of its own)}, without readers' files."""
    tests, engine = house.ROOT / "tests", house.ROOT / "engine"
    checker = [path for place in ("checker", "tests/checker")
               for path in sorted((house.ROOT / place).glob("*.cpp")) if path.name != "where.cpp"]
    found = {"checker": (checker, ""), "module": ([tests / "course" / "module.cpp"], ""),
             "units_engine": ([engine / f"{name}.cpp"
                               for name in ("real", "body", "rotation/motion", "kept/bodies",
                                            "matrix", "block")], UNITS)}
    for chapter in house.chapters():
        name = chapter.folder
        found |= {f"tests_{name}": ([tests / name / "test.cpp"], ""),
                  f"where_{name}": ([tests / "checker" / "where.cpp"],
                                    rf'-DEXERCISE_FILE=\"{house.short(chapter.mine)}\"'),
                  f"mistakes_{name}": ([mistakes_of(chapter)], "-O0"),
                  f"units_{name}": ([tests / name / "units.cpp"], UNITS),
                  f"units_of_{name}": ([chapter.solution], UNITS)}
    return found


def mistakes_of(chapter):
    """The source of the mistakes that its checks know."""
    source = judging.source_of(chapter, "mistakes")
    answers.main(["mistakes", str(house.ROOT), str(chapter.solution), str(source),
                  *map(str, answers.files_of(chapter.folder, house.ROOT))])
    return source


def build_objects(names=()):
    """The objects of the tests, or some; those of engine and solutions are the live page's."""
    live.build()
    BUILD.mkdir(parents=True, exist_ok=True)
    with house.alone():
        tests, root = (os.path.relpath(path, BUILD) for path in
                       (house.ROOT / "tests" / "course", house.ROOT))
        live.write_compiling(BUILD, [*FLAGS, "-isystem", tests, f"-I{root}", "-isystem",
                                     "../live/include", '-DWORKBOOK_ROOT=\\"/\\"'], sources())
        house.progress(what := "building the tests for the browser")
        log = house.run_ninja(["ninja", "-C", BUILD, *(f"{name}.o" for name in names)], what)
    if log:
        raise house.Trouble("the tests cannot be compiled for the browser:\n"
                            + house.compiler_words(log))


def objects(*names):
    """Of the tests."""
    return {f"/lib/{name}.o": (BUILD / f"{name}.o").read_bytes() for name in names}


def shared_objects():
    """What every chapter's tests may call, each taken only where it is called."""
    return {f"/lib/{name}.o": live.object_of(name).read_bytes()
            for name in ("engine", "given", *(c.folder for c in house.chapters()))}


def units_objects():
    """Of all chapters: a reader needs them seldom."""
    return objects("units_engine", *(f"{kind}_{chapter.folder}" for chapter in house.chapters()
                                     for kind in ("units", "units_of")))


def live_objects():
    """What the live page has besides."""
    return {f"/lib/{name}.o": live.object_of(name).read_bytes()
            for name in ("bench", "exports", "run", "scenes", "thrown")}


def libraries():
    system = Path("/usr/lib/wasm32-wasi")
    builtins = next(Path("/").glob(f"{CLANG[1:]}/lib/wasi/libclang_rt.builtins-wasm32.a"))
    return {f"/lib/{name}": (system / name).read_bytes()
            for name in ("crt1-reactor.o", "libc++.a", "libc++abi.a", "libc.a")} | {
                "/lib/builtins.a": builtins.read_bytes()}


# ---- headers -------------------------------------------------------------------------------------

def probe(but=()):
    """A header with the includes of the chapters' files, and others that readers often add."""
    named = {line for chapter in house.chapters()
             for line in re.findall(r'^#include "[^"]+"', exercises.read(chapter.solution), re.M)}
    return "".join(f"#include <{name}>\n" for name in STANDARD) + \
        "".join(f"{line}\n" for line in sorted(named) if not any(one in line for one in but))


def headers():
    """{path in the browser: bytes} of every header: those that are read here, and all of the
    standard library."""
    header = BUILD / "course.h"
    exercises.write_if_new(header, probe() + '#include "tests/checker/quantity.h"\n'
                           '#include "tests/checker/chosen.h"\n')
    found = subprocess.run(
        ["clang++", *FLAGS, "-D_LIBCPP_DEBUG=0", "-isystem", house.BUILD / "live" / "include",
         f"-I{house.ROOT}", "-M", "-x", "c++", header], capture_output=True, text=True, check=True)
    glm, out = house.BUILD / "live" / "include", {}
    places = [(WASI, "/wasi"), (glm, "/glm"), (house.ROOT, "")]
    paths = {Path(path) for path in found.stdout.replace("\\\n", " ").split(":", 1)[1].split()}
    paths |= {path for path in (WASI / "c++" / "v1").rglob("*") if path.is_file()}
    for path in sorted(paths - {header}):
        for place, seen in places:
            if path.is_relative_to(place):
                out[f"{seen}/{path.relative_to(place)}"] = path.read_bytes()
                break
        else:
            if "/clang/" in str(path):
                out[f"/clang/{path.name}"] = path.read_bytes()
    out["/course.h"] = probe().encode()
    # lanes hold no numbers with units
    out["/units.h"] = probe(but=("lanes", "performance")).encode()
    return out
