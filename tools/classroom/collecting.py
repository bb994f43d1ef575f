"""What a class has handed in: folders, archives and single files, with whatever names.

An archive is opened within a fence by this file as a program, collecting.py BAG: it reads the
archive, adds to the bag, which is in JSON, what is in it, and prints the bag.
"""
import bz2
import gzip
import io
import json
import lzma
import os
import re
import resource
import subprocess
import sys
import tarfile
import zipfile
from collections import Counter
from dataclasses import asdict, dataclass, field
from pathlib import Path, PurePosixPath

sys.dont_write_bytecode = True
TOOLS = Path(__file__).absolute().parents[1]
sys.path.insert(0, str(TOOLS))
from base import exercises, house  # noqa: E402
from base.talk import folded  # noqa: E402
from classroom import fence  # noqa: E402
from judge import grade as grading  # noqa: E402

MISSING = "not handed in"
LARGEST = 200_000  # exercise file [bytes]; they have some ten thousand
LARGEST_ARCHIVE = 50_000_000  # also of all that is unpacked of a submission
MOST = 20_000        # files that are looked at in a submission
DEEPEST = 3          # archives in archives
SECONDS, MEMORY = 10, 1 << 29  # processor time and memory in which an archive is opened [s, bytes]
MOST_NOTES, LONGEST_NOTE = 20, 300  # of a submission; letters
OPENED = re.compile(r"\.(zip|tar|tgz|tar\.(gz|xz|bz2))$", re.I)
CLOSED = re.compile(r"\.(rar|7z|gz|xz|bz2|zst)$", re.I)  # archives that are not opened
SOURCE = re.compile(r"\.(cpp|cc|cxx|txt)$", re.I)
# What a browser, a system or a reader adds to a name: "Copy of distance (1)_final".
ADDED = re.compile(r"^copy of |[ _-]*(\(\d+\)|\d+|copy|final|v\d+)$", re.I)
# Folders of the workbook with files of the same names, and folders that systems add.
NOT_THEIRS = re.compile(r"^(\..*|__.*|solutions|tests|out|(cmake-)?build([-_.].*)?)$", re.I)
HIDDEN = re.compile(r"\.|__")  # of a system; a student may be called "Out"
EXPECTED = ("A submission is a folder, a zip or a file with exercises, such as distance.cpp or "
            "chapters/01_distance/distance.cpp. Name submissions, or a folder of them: "
            "./wb grade class")


@dataclass
class File:
    """An exercise file that was found."""
    where: str  # in the submission
    text: str
    named: str  # the chapter's folder that its name tells; "": none

    def number(self):
        """Of the chapter that most of its markers name; "": there are none."""
        found = Counter(re.findall(r"// (?:begin|end) \[exercise (\d+)\.\d+\]", self.text))
        return found.most_common(1)[0][0] if found else ""


@dataclass
class Submission:
    """A submission of one of the class, and its result."""
    name: str
    files: dict                                 # folder of a chapter: File
    notes: list = field(default_factory=list)   # sentences
    grades: dict = field(default_factory=dict)  # exercise: Grade
    alike: str = ""                             # whose file is like it

    def grade(self, id_):
        return self.grades.get(id_) or grading.Grade(id_, MISSING)

    def done(self, ids):
        return sum(self.grade(id_).status == grading.DONE for id_ in ids)


# ---- files ---------------------------------------------------------------------------------------

@dataclass
class Bag:
    """The exercise files below a place, and sentences on the files that cannot be read."""
    found: list = field(default_factory=list)
    notes: list = field(default_factory=list)
    others: list = field(default_factory=list)
    count: int = 0
    unpacked: int = 0

    def fill(self, place):
        if place.is_dir():
            self.walk(place)
        else:
            self.add(PurePosixPath(place.name), place.stat().st_size, place.read_bytes)
        return self

    def walk(self, place):
        for at, folders, names in os.walk(place, onerror=lambda error: self.notes.append(
                f"A folder cannot be read: {error.strerror}.")):
            folders[:] = sorted(name for name in folders if not NOT_THEIRS.match(name))
            for path in (Path(at, name) for name in sorted(names)):
                inner = PurePosixPath(path.relative_to(place))
                if not path.resolve().is_relative_to(place.resolve()):
                    self.notes.append(f"{inner} is a link that leads out of the submission.")
                elif path.is_file():
                    try:
                        self.add(inner, path.stat().st_size, path.read_bytes)
                    except OSError as error:
                        self.notes.append(f"{inner} cannot be read: {error.strerror}.")

    def add(self, inner, size, read, depth=0):
        self.count += 1
        if self.count == MOST + 1:
            self.notes.append(f"It has more than {MOST} files; the others were not looked at.")
        if self.count > MOST or depth and self.unpacked > LARGEST_ARCHIVE or (
                inner.name.startswith((".", "._"))):
            return
        inner, is_archive = PurePosixPath(printable(str(inner))), OPENED.search(inner.name)
        self.unpacked += size if depth and (is_archive or SOURCE.search(inner.name)) else 0
        if depth and self.unpacked > LARGEST_ARCHIVE:
            self.notes.append(f"{inner} was not read, nor what follows it: more than "
                              f"{LARGEST_ARCHIVE} bytes would be unpacked.")
        elif is_archive and depth < DEEPEST and size <= LARGEST_ARCHIVE:
            (self.open if depth else self.open_fenced)(inner, read(), depth)
        elif is_archive or CLOSED.search(inner.name):
            self.notes.append(f"{inner} cannot be opened here; ask for a zip.")
        elif SOURCE.search(inner.name) and size > LARGEST:
            self.notes.append(f"{inner} is larger than {LARGEST} bytes and was not read.")
        elif SOURCE.search(inner.name) and (
                one := File(str(inner), text_of(read()), named(inner.name))) and (
                one.named or one.number()):
            self.found.append(one)
        else:
            self.others.append(str(inner))

    def open_fenced(self, inner, data, _):
        """What is in an archive of the submission."""
        bag = json.dumps([str(inner), self.count, self.unpacked])
        within = fence.Fence("/", [str(TOOLS), str(house.ROOT / "solutions"), sys.base_prefix],
                             quiet=False)
        python = os.path.realpath(sys.executable)
        said = subprocess.run(within.around([python, __file__, bag]), input=data,
                              capture_output=True)
        if said.returncode:
            return self.notes.append(f"{inner} cannot be opened in {SECONDS} s of processor time "
                                     f"and {MEMORY} bytes of memory.")
        found, notes, others, self.count, self.unpacked = json.loads(said.stdout)
        self.found += [File(**one) for one in found]
        self.notes += notes
        self.others += others

    def open(self, inner, data, depth):
        """What is in an archive, without ever writing it anywhere."""
        try:
            if inner.suffix.lower() == ".zip":
                archive = zipfile.ZipFile(io.BytesIO(data))
                members = [(one.filename, one.file_size, lambda one=one: archive.read(one))
                           for one in archive.infolist() if not one.is_dir()]
            else:
                plain = decompressed(data)
                self.unpacked += len(plain)
                if self.unpacked > LARGEST_ARCHIVE:
                    return self.notes.append(f"{inner} is larger than {LARGEST_ARCHIVE} bytes "
                                             "when it is unpacked, and was not read.")
                archive = tarfile.open(fileobj=io.BytesIO(plain), mode="r:")
                members = [(one.name, one.size, lambda one=one: archive.extractfile(one).read())
                           for one in archive if one.isreg() and one.size >= 0]
            for name, size, read in members:
                parts = [part for part in re.split(r"[/\\]", name) if part not in ("", ".", "..")]
                if parts and not any(map(NOT_THEIRS.match, parts[:-1])):
                    self.add(inner / PurePosixPath(*parts), size, read, depth + 1)
        except Exception as error:  # there are many ways in which it may be damaged
            self.notes.append(f"{inner} cannot be opened: {error or 'it is too large'}.")

    def submission(self, name):
        """The file of each chapter: the one that is best named and lies least deep."""
        files, notes = {}, self.notes[:]
        folders = {str(chapter.number): chapter.folder for chapter in house.chapters()}
        for one in sorted(self.found, key=lambda one: (
                not one.number(), exact(one) < 2, -exact(one), one.where.count("/"), one.where)):
            folder = folders.get(one.number()) or one.named
            if not folder:
                continue
            if one.named and folder != one.named:
                notes.append(f"{one.where} holds exercises of {folder}, not of {one.named}.")
            if folder not in files:
                files[folder] = one
                if exact(one) < 2 and one.named:
                    notes.append(f"{one.where} was taken for {folder}.")
            elif one.text != files[folder].text:
                notes.append(f"{one.where} was not graded: {files[folder].where} was.")
        if not files and self.others:
            more = f" and {len(self.others) - 3} more" * (len(self.others) > 3)
            notes.append(f"There is no exercise file, but {', '.join(self.others[:3])}{more}.")
        return Submission(name, files, [printable(note)[:LONGEST_NOTE]
                                        for note in notes[:MOST_NOTES]])


def decompressed(data):
    """What is in it, but not much more of it than may be unpacked."""
    for magic, opener in ((b"\x1f\x8b", gzip), (b"BZh", bz2), (b"\xfd7zXZ", lzma)):
        if data.startswith(magic):
            with opener.open(io.BytesIO(data)) as file:
                return file.read(LARGEST_ARCHIVE + 1)
    return data


def named(name):
    """The folder of the chapter that a file's name tells, "" for none."""
    stem = SOURCE.sub("", SOURCE.sub("", name)).strip().lower()
    while (shorter := ADDED.sub("", stem).strip()) != stem:
        stem = shorter
    return next((chapter.folder for chapter in house.chapters() if chapter.name == stem), "")


def exact(one):
    """2: the name is as it should be; 1: but for the case of letters; 0: it is not."""
    name, wanted = PurePosixPath(one.where).name, f"{one.named[3:]}.cpp"
    return (name == wanted) + (name.lower() == wanted)


def text_of(data):
    """A text as an editor may have saved it."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")) or data[1:2] == b"\0":
        return data.decode("utf-16", errors="replace").replace("\r\n", "\n")
    return data.removeprefix(b"\xef\xbb\xbf").decode("utf-8", errors="surrogateescape").replace(
        "\r\n", "\n")


# ---- submissions ---------------------------------------------------------------------------------

def is_one(folder):
    """True where exercise files lie in the places of the workbook, so that it is no class."""
    places = {chapter.folder for chapter in house.chapters()} | {"chapters"}
    return any(entry.name in places if entry.is_dir() else named(entry.name) and SOURCE.search(
        entry.name) for entry in folder.iterdir())


def places_in(place):
    """(where each submission lies, whether they are a class) of a named place."""
    if not place.exists():
        raise house.Trouble(f"grade: {house.short(place)}: there is no such folder")
    if place.is_file() or is_one(place):
        return [place], False
    inner = [entry for entry in sorted(place.iterdir()) if not HIDDEN.match(entry.name) and (
        entry.is_dir() or entry.is_file() and (OPENED.search(entry.name) or CLOSED.search(
            entry.name) or SOURCE.search(entry.name) and Bag().fill(entry).found))]
    return inner, True


def submissions_in(place):
    """(the submissions, whether it is a class). Their names differ."""
    places, is_class = places_in(place)
    found = [Bag().fill(one).submission(plain_name(one)) for one in places]
    if not any(one.files for one in found):
        notes = "\n".join(folded(note) for one in found[:3] for note in one.notes)
        raise house.Trouble(f"grade: {place}: there is no exercise file\n{folded(EXPECTED)}\n"
                            + notes)
    count = Counter(one.name for one in found)
    for one, where in zip(found, places):
        if count[one.name] > 1:
            one.name = printable(where.name)
    return found, is_class


def plain_name(place):
    return printable(OPENED.sub("", CLOSED.sub("", SOURCE.sub("", place.name)))
                     if place.is_file() else place.name)


def printable(name):
    return "".join(letter if letter.isprintable() else "?" for letter in name)


def is_untouched(one, chapter):
    return one.text.strip() == exercises.stub(exercises.read(chapter.solution)).strip()


def main(name, count, unpacked):
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    bag = Bag(count=count, unpacked=unpacked)
    bag.open(PurePosixPath(name), sys.stdin.buffer.read(), 0)
    print(json.dumps(list(asdict(bag).values())))


if __name__ == "__main__":
    main(*json.loads(sys.argv[1]))
