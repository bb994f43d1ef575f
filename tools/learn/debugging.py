"""./wb test --debug: builds the tests of an exercise for a debugger, and says how it is called."""
import shlex
import shutil

from base import exercises, house
from judge import reading
from learn import testing


def debug(word):
    """Exit status 0 when there is something to debug."""
    chapter, id_ = house.asked(word)
    reading.look(chapter).refuse()
    house.use_build("debug")
    target = f"{chapter.folder}_test_mine"
    if log := house.build([target], "building for a debugger"):
        testing.tell_broken(chapter, house.compiler_words(log))
        return 1
    program = house.short(house.BUILD / "tests" / target)
    ids = [id_] if id_ else chapter.ids()
    # What .vscode/launch.json passes on; the names of an exercise's tests begin with its number.
    exercises.write(house.BUILD / "exercise.txt", "".join(f"{one} *\n" for one in ids))
    print(f"built for a debugger: {program}; it stops where your code begins:\n")
    print(call_of(places(chapter, ids), [program, f"[{id_}]"] if id_ else [program]))
    if not debugger():
        print("\nNo debugger is installed here; on Debian and Ubuntu: apt-get install gdb")
    return 0


def places(chapter, ids):
    """file:line of the first line of every answer."""
    return [f"{house.short(chapter.mine)}:{region.begin + len(region.task()) + 1}"
            for region in exercises.regions(chapter.mine_text()) if region.id in ids]


def debugger():
    return next(filter(shutil.which, ("gdb", "lldb")), None)


def call_of(stops, command):
    """The debugger's command, in lines that a shell reads as one."""
    if debugger() == "lldb":
        lines = ["lldb", *(f"-o 'breakpoint set --file {path} --line {line}'"
                           for path, line in (stop.split(":") for stop in stops)), "-o run --"]
    else:
        lines = ["gdb -q", *(f"-ex 'break {stop}'" for stop in stops), "-ex run --args"]
    return " \\\n  ".join(["  " + lines[0], *lines[1:], shlex.join(command)])
