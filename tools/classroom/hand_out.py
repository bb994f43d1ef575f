"""./wb hand-out: an edition for students, without solutions and known answers. The mistakes that
the checks know are in it as objects, for the kind of machine on which it is made.

A stub stands in the place of every solution; what the solution's program has recorded lies beside
it, for the figures. A chapter that is over is completed with its folder of solutions/.
"""
import os
import platform
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from base import exercises, house
from base.talk import folded
from learn import show
from website import live

# What holds answers, or computes the same for tests and benchmarks of the whole workbook.
LEFT_OUT = re.compile(r"solutions/|tests/\d\d_\w+/answers/|tests/(?!\d\d_|checker/)\w+/|"
                      r"bench/.*(?<!\.csv)$|docs/(browser|library|mainpage|teaching)\.md$|"
                      r"CONTRIBUTING|"
                      r"tests/topics\.cmake$|\.github/|\.gitlab-ci\.yml$|\.ci/")
# What stands between these lines of a text is not in an edition. Its README begins with a note.
ONLY_HERE = re.compile(r"<!-- not handed out -->\n.*?<!-- end -->\n", re.S)
NOTE = """\
> **An edition for students.** The solutions are not in it, so the commands that need them are
> refused, also where a text names one; `./wb help` lists the others. `./wb run 1` needs all
> exercises of chapter 1; `plot` and `see` draw your run over a recorded one, and `live` runs both
> once all exercises are written.
> `./wb run 1 --for NAME` gives you numbers of your own: of the program, and three factors with
> which you calculate the section Numbers again.
"""


def files():
    """The files of the workbook: nothing that lies beside it, such as submissions."""
    said = subprocess.run(["git", "-C", house.ROOT, "ls-files", "-z"], capture_output=True,
                          text=True)
    if said.returncode:
        raise house.Trouble("hand-out: git must know which files belong to the workbook, and it "
                            "says: " + said.stderr.strip())
    return [name for name in said.stdout.split("\0") if name and (house.ROOT / name).is_file()]


def linked(text, place, there):
    """A text without its links to what is not in the edition."""
    def kept(match):
        path = os.path.normpath(os.path.join(os.path.dirname(place), match[2]))
        return match[0] if path in there or (house.ROOT / path).is_dir() else match[1]
    return re.sub(r"(?<!!)\[([^\]]+)\]\(([\w.-]*[./][\w./-]*)[^)\s]*\)", kept, text)


def copy_mistakes(folder):
    """The objects of the mistakes that the checks know, see tests/CMakeLists.txt."""
    chapters = house.chapters()
    house.must_build([f"{chapter.folder}_mistakes" for chapter in chapters])
    place = folder / "solutions" / "mistakes"
    place.mkdir(parents=True, exist_ok=True)
    machine = f"{platform.system()}.{platform.machine()}"
    for chapter in chapters:
        made = house.BUILD / "tests" / "CMakeFiles" / f"{chapter.folder}_mistakes.dir"
        shutil.copy(next(made.rglob("*.o")), place / f"{chapter.folder}.{machine}.o")


def hand_out(folder):
    if folder.exists():
        raise house.Trouble(f"hand-out: {folder} is there already; name a new folder, or renew it "
                            "with --update")
    make(folder)
    print(folded(f"{folder}: the workbook without solutions. When a chapter is over, hand out its "
                 "folder too, such as solutions/01_distance: what is missing works then."))
    return 0


def make(folder):
    """Writes an edition."""
    names = files()
    for chapter in house.chapters():
        show.run_solution(chapter)
    house.progress_done()
    there = {name for name in names if not LEFT_OUT.match(name)}
    links = there | {f"solutions/{chapter.folder}/answers.md" for chapter in house.chapters()}
    for name in there:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(house.ROOT / name, folder / name)
        if name.endswith(".md"):
            text = ONLY_HERE.sub("", exercises.read(folder / name))
            exercises.write(folder / name, linked(text, name, links))
    title, rest = exercises.read(folder / "README.md").split("\n", maxsplit=1)
    exercises.write(folder / "README.md", f"{title}\n\n{NOTE}{rest}")
    for chapter in house.chapters():
        stub = exercises.stub(exercises.read(chapter.solution))
        for path in (chapter.mine, chapter.solution):
            exercises.write(folder / house.short(path), stub)
        exercises.write(folder / house.short(chapter.solution.with_name("answers.md")),
                        "Your teacher hands out the answers when the chapter is over.\n")
        run = folder / house.short(show.recorded(chapter))
        shutil.copytree(show.SOLUTIONS / chapter.folder, run)
    copy_mistakes(folder)
    if lacking := live.missing():
        print(folded(f"without ./wb live, which needs {' '.join(lacking)} here when it is handed "
                     "out"))
    else:
        live.build()
        for name in live.sources():
            path = folder / house.short(live.SHIPPED) / f"{name}.o"
            path.parent.mkdir(exist_ok=True)
            shutil.copy(live.object_of(name), path)


def update(folder):
    """Renews an edition: all but exercise files, and solutions that are handed out."""
    title = exercises.read(folder / "README.md") if (folder / "README.md").is_file() else ""
    if NOTE.split('**')[1] not in title:
        raise house.Trouble(f"hand-out: {folder} is no edition for students")
    with tempfile.TemporaryDirectory() as place:
        new = Path(place) / "edition"
        make(new)
        kept = {house.short(chapter.mine) for chapter in house.chapters()}
        for chapter in house.chapters():
            there = folder / house.short(chapter.solution)
            if there.is_file() and not any(map(exercises.is_open, exercises.regions(
                    exercises.read(there)))):
                kept |= {f"solutions/{chapter.folder}/{name}" for name in os.listdir(there.parent)}
        shutil.copytree(new, folder, dirs_exist_ok=True, ignore=lambda at, names: [
            name for name in names
            if str(Path(at, name).relative_to(new)) in kept and (
                folder / Path(at, name).relative_to(new)).exists()])
    print(f"{folder} is renewed; its exercise files are as they were.")
    return 0
