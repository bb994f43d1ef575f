"""./wb live: the page in which the engine runs, with the solutions and with a reader's file."""
import base64
import glob
import os
import shlex
import shutil
from pathlib import Path

from base import exercises, house
from judge import grade, reading
from learn import show
from pictures import pages

TEMPLATE = house.ROOT / "docs" / "live" / "live.html"
SHIPPED = house.ROOT / "solutions" / "wasm"  # the objects, in a student's edition
FLAGS = ["--target=wasm32-wasi", "-std=c++20", "-fexceptions", "-ffp-contract=off",
         "-ffunction-sections", "-fdata-sections", "-DGLM_FORCE_EXPLICIT_CTOR", "-w"]
LINK = ["--target=wasm32-wasi", "-mexec-model=reactor", "-Wl,--gc-sections", "-Wl,--strip-all"]
SCENES = ("live", "bench")  # folders of code that no iteration calls: for size alone
# A reader's file is looked at more closely: an index outside a vector stops the module, and a loop
# without end stays one.
LENIENT = ["-D_LIBCPP_DEBUG=0", "-ftrivial-auto-var-init=pattern", "-fno-finite-loops"]


def sources():
    """What the module is made of: {name of an object: the sources that are compiled as one}."""
    root, chapters = house.ROOT, house.chapters()
    mine = {chapter.mine for chapter in chapters}
    engine = ("real", "body", "matrix", "block", "world", "solver",
              "sequential_impulses", "step", "rotation/motion",
              "kept/state", "kept/input", "kept/bodies",
              "steps/step", "steps/leapfrog", "steps/projection", "steps/two_pass_impulses",
              "simd/lane_order", "simd/places",
              "instruments/measure", "instruments/rate", "instruments/scene")
    return {"engine": [root / "engine" / f"{name}.cpp" for name in engine],
            "given": [path for path in (*sorted((root / "chapters").glob("*/*.cpp")),
                                        *sorted((root / "direct").glob("*.cpp")))
                      if path not in mine],
            "bench": [root / "bench" / "scenes.cpp"],
            **{path.stem: [path] for path in sorted((root / "docs" / "live").glob("*.cpp"))},
            **{chapter.folder: [chapter.solution] for chapter in chapters}}


def missing():
    """The packages that are not there, by Debian's names."""
    there = {"clang": shutil.which("clang++"), "lld": shutil.which("wasm-ld"),
             "wasi-libc": Path("/usr/include/wasm32-wasi/stdio.h").exists(),
             "libc++-dev-wasm32": Path("/usr/include/wasm32-wasi/c++/v1/vector").exists(),
             "libclang-rt-dev-wasm32": glob.glob("/usr/lib/llvm-*/lib/clang/*/lib/wasi/*.a")}
    return [package for package, found in there.items() if not found]


def refuse(chapter):
    """Without the packages, or the objects of an edition: one line that says which, and names the
    replacement."""
    lacking = missing()
    if any(one.sealed for one in house.chapters()) and not SHIPPED.is_dir():
        lacking = ["objects that this edition was handed out without"]
    if lacking:
        raise house.Trouble(
            f"live needs {' '.join(lacking)}{' (Debian packages)' * bool(missing())}. Without "
            f"them the recorded motion: ./wb see{f' {chapter.number}' if chapter else ''}")


# ---- the modules ---------------------------------------------------------------------------------

def glm_folder():
    """Where glm/ lies; the system's other headers must not be seen."""
    places = [Path(place) / "include" for place in
              os.environ.get("CMAKE_PREFIX_PATH", "").split(os.pathsep) if place]
    for place in places + [Path("/usr/include"), Path("/usr/local/include")]:
        if (place / "glm" / "glm.hpp").exists():
            return place / "glm"
    raise house.Trouble("glm is not there (Debian package: libglm-dev)")


def object_of(name):
    """The file of one of the objects."""
    return (SHIPPED if SHIPPED.is_dir() else house.BUILD / "live") / f"{name}.o"


def write_ninja(folder, swaps):
    """build.ninja of the modules: the solutions' as solution.wasm, and one for each swap: its name,
    and which source takes the place of which object. All paths are seen from the folder, so that it
    can be copied together with the workbook."""
    def seen(path):
        return os.path.relpath(path, folder)
    include = folder / "include"
    include.mkdir(parents=True, exist_ok=True)
    link, glm = include / "glm", glm_folder()
    if not link.is_symlink() or link.readlink() != glm:
        link.unlink(missing_ok=True)
        link.symlink_to(glm)
    made = {} if SHIPPED.is_dir() else {
        name: (paths, "-Oz" if paths[0].parent.name in SCENES else "")
        for name, paths in sources().items()}
    objects = {name: f"{name}.o" if made else seen(object_of(name)) for name in sources()}
    lines = ["rule link", f"  command = clang++ {' '.join(LINK)} $in -o $out"]
    for name, swap in {"solution": {}, **swaps}.items():
        mine = {which: f"{name}.{which}.o" for which in swap}
        lines.append(f"build {name}.wasm: link {' '.join({**objects, **mine}.values())}")
        made |= {f"{name}.{which}": ([path], " ".join(LENIENT)) for which, path in swap.items()}
    write_compiling(folder, [*FLAGS, "-Os", "-isystem include", f"-I{seen(house.ROOT)}"], made,
                    lines)


def write_compiling(folder, flags, objects, lines=()):
    """build.ninja of objects, {name: (sources that are compiled as one, flags of its own)}, and of
    what more lines say."""
    launcher = shlex.join(filter(None, os.environ.get(
        "CMAKE_CXX_COMPILER_LAUNCHER", "").split(";"))).replace("$", "$$")
    lines = ["rule compile", f"  command = {launcher} clang++ {' '.join(flags)} $more -MMD -MF "
             "$out.d -c $in -o $out", "  deps = gcc", "  depfile = $out.d", *lines]
    for name, (paths, more) in objects.items():
        source = os.path.relpath(paths[0], folder)
        if len(paths) > 1:
            source = f"{name}.cpp"
            exercises.write_if_new(folder / source, "".join(
                f'#include "{path.relative_to(house.ROOT)}"\n' for path in paths))
        lines += [f"build {name}.o: compile {source}", f"  more = {more}"]
    exercises.write_if_new(folder / "build.ninja", "\n".join(lines) + "\n")


def build(swaps=None, folder=None):
    """Builds the modules; returns the folder in which they are."""
    folder, swaps = folder or house.BUILD / "live", swaps or {}
    folder.mkdir(parents=True, exist_ok=True)
    with house.alone():
        write_ninja(folder, swaps)
        names = [f"{name}.wasm" for name in ("solution", *swaps)]
        house.progress(what := "building the live page")
        log = house.run_ninja(["ninja", "-C", folder, *names], what)
    if log:
        raise house.Trouble("the live page's module cannot be built:\n"
                            + house.compiler_words(log))
    return folder


# ---- the page ------------------------------------------------------------------------------------

def write_page(page, title, modules, beside="", **more):
    """The page of these modules, [(label, file)]; `more` are its other settings; `beside` is where
    three.js lies, if not in the page."""
    data = {"title": title, **more, "modules": [
        {"label": label, "wasm": base64.b64encode(file.read_bytes()).decode()}
        for label, file in modules]}
    page.parent.mkdir(parents=True, exist_ok=True)
    page.write_text(pages.filled(TEMPLATE, data, beside), encoding="utf-8")
    return page


def prepare_mine(chapter):
    """Which exercises are the reader's own; their file, the rest from the solution, lies ready.
    Without the solution they count only if none is missing."""
    look = reading.look(chapter)
    look.refuse()
    written = look.written()
    if chapter.sealed and len(written) < len(chapter.ids()):
        return []
    if written:
        show.write_mixed(chapter, written)
    return written


def source_of(chapter, folder):
    """That file for the module, in which the compiler finds the lines of the one that is edited."""
    ends = iter([region.end + 1 for region in exercises.regions(chapter.mine_text())])
    source = folder / f"mine_{chapter.number}.cpp"
    exercises.write_if_new(source, f'#line 1 "{chapter.mine}"\n' + exercises.replace(
        exercises.read(show.mixed_file(chapter)),
        lambda region, _: [*region.lines, f'#line {next(ends)} "{chapter.mine}"']))
    return source


def named(chapter, written):
    """The reader's exercises in words, with the results of this file's tests, if they ran."""
    known = grade.recall(chapter)
    return " ".join(id_ if id_ not in known or known[id_].status == grade.DONE
                    else f"{id_} (red)" for id_ in written)


def live(chapter):
    """The page with the solutions, or with the reader's file of a chapter beside them."""
    refuse(chapter)
    page = house.OUT / (f"live_{chapter.folder}.html" if chapter else "live.html")
    written = prepare_mine(chapter) if chapter else []
    if written:
        name = f"mine_{chapter.number}"
        folder = house.BUILD / "live"
        folder.mkdir(parents=True, exist_ok=True)
        build({name: {chapter.folder: source_of(chapter, folder)}})
        rest = [id_ for id_ in chapter.ids() if id_ not in written]
        note = f"your {named(chapter, written)}" + (
            f"; the solution's {' '.join(rest)}" if rest else "")
        modules = [("yours", folder / f"{name}.wasm"), ("the solution", folder / "solution.wasm")]
    else:
        folder = build()
        note, modules = "", [("the solution", folder / "solution.wasm")]
        if chapter:
            note = "the solution: no exercise of this chapter is written yet" \
                if not chapter.sealed else "the solution; yours when all exercises are written"
    house.progress_done()
    title = f"Chapter {chapter.number}: {chapter.name}, live" if chapter else "The engine, live"
    write_page(page, title, modules, note=note, chapter=chapter.number if chapter else 0)
    print(house.short(page) + (f"   ({note})" if note else ""))
    show.open_page(page)
    return 0
