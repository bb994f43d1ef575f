"""Grades one exercise file that somebody has handed in, in a process of its own that ./wb grade
starts and may end: submission.py FOLDER NN_name

FOLDER is laid out as the workbook is: chapters/NN_name/name.cpp, and build/, which links with the
workbook's. A line of the output that begins with [ is the grades in JSON; the last one counts.
"""
import json
import resource
import sys
from dataclasses import asdict, dataclass
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from classroom import fence  # noqa: E402
from judge import grade as grading  # noqa: E402
from base import house  # noqa: E402
from judge import reading  # noqa: E402
from learn import status  # noqa: E402

# Of every process: processor time [s], a file, memory [bytes]. Tests have less, see runs.py.
LIMITS = {resource.RLIMIT_CPU: 60, resource.RLIMIT_FSIZE: 64 << 20, resource.RLIMIT_AS: 4 << 30,
          resource.RLIMIT_CORE: 0}


@dataclass
class HandedIn(house.Chapter):
    """A chapter of the workbook, with somebody else's exercise file."""
    home: Path = Path()

    @property
    def mine(self):
        return self.home / "chapters" / self.folder / f"{self.name}.cpp"


def say(grades, folder):
    """The grades as a line of JSON, without the folder's name."""
    print(json.dumps([asdict(one) for one in grades]).replace(f"{folder}/", ""), flush=True)


def main(folder, chapter):
    for limit, most in LIMITS.items():
        resource.setrlimit(limit, (most, most))
    fence.close(folder)
    house.BUILD = folder / "build"
    look = reading.look(HandedIn(chapter.number, chapter.folder, chapter.name, folder))
    say([ended(one, look) for one in look.chapter.ids()], folder)  # if this process is ended, too
    try:
        grades = status.grades_of([look])[chapter.number]
    except house.Trouble as trouble:
        grades = [grading.Grade(id_, grading.BROKEN if id_ in look.written() else grading.OPEN,
                                str(trouble)) for id_ in look.chapter.ids()]
    for one in grades:
        if look.faults:
            one.detail = look.faults[0][1]
    say(grades, folder)


def ended(id_, look):
    """The grade of an exercise whose tests never come to an end."""
    if id_ not in look.written():
        return grading.Grade(id_, grading.OPEN)
    return grading.Grade(id_, grading.WRONG, failures=[
        ("", "its tests did not end, or ended what runs them: a loop without an end, kill()?")])


if __name__ == "__main__":
    main(Path(sys.argv[1]), house.chapter_of(sys.argv[2]))
