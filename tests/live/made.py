"""What the tests of the live page look at: a page with the solutions' module and, for each of some
answers to exercise 1.1, a module with that answer."""
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).absolute().parents[1] / "workbook"))
from proofs import exercises, house  # noqa: E402

from website import live  # noqa: E402

# Answers to exercise 1.1, and the words of the page about them.
ANSWERS = {
    "endless": ("while (true) {}", None),
    "thrown": ('throw std::runtime_error("too far");', "too far"),
    "open": ('todo("1.1");', "exercise 1.1 is not written yet"),
    "outside": ("std::vector<real> v; return {vec3(v[int(body1.inverse_mass)]), {}, {}, {}};",
                "the code stopped: an index outside a vector"),
    "nan": ("return {vec3(std::sqrt(-body2.inverse_mass)), {}, {}, {}};",
            "must be finite")}
SKIPPED = 77


def skip_without(what, packages):
    """Ends the test where something is missing."""
    if packages:
        print(f"{what}: {' '.join(packages)} missing (Debian packages)")
        sys.exit(SKIPPED)


def page(build, test):
    """The page for a test of this name; its modules have the names of the answers."""
    folder, chapter = build / "live", house.chapter_of("1")
    solution = exercises.read(chapter.solution)
    swaps = {}
    for name, (answer, _) in ANSWERS.items():
        source = folder / f"{name}.cpp"
        text = exercises.replace(solution, lambda region, place, code=answer: [
            *region.task(), code] if region.id == "1.1" else None)
        exercises.write_if_new(source, "#include <stdexcept>\n" + text)
        swaps[name] = {chapter.folder: source}
    live.build(swaps, folder)
    return live.write_page(folder / f"{test}.html", "tried", [
        (label, folder / f"{file}.wasm")
        for label, file in [("the solution", "solution"), *((name, name) for name in swaps)]])
