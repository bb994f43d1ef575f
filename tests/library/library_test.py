"""The library serves a program outside: library_test.py ROOT BUILD

Installs BUILD into a folder of its own, copies library/examples next to it, builds the copy against
the installed files and runs it, once in double and once in float: each program prints what its
first comment says. Nothing that is compiled may come from ROOT, nothing that is installed may name
it, and the program of a hinge may carry no slider, no weld and no ground, that of a crate on the
ground no hinge joint, that of two shafts no slider either, that of a chain of ball joints none of
all these. The examples in the headers' comments compile. The names that its headers export are
those of names.txt. For a part that lacks a member the compiler prints a sentence. Double and float
do not link into one program, and headers say in which C++ they compile. The library is configured
without the packages that only the workbook needs.
Exit status 0 when all of that holds, 1 otherwise, 2 for a bad command line.
"""
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[2] / "tools"))
from keep import exported  # noqa: E402

# Of each program: the symbols that it must contain, and those that it must not.
OTHERS = r"Line|Slide|RotationLock|Weld|SliderJoint|FixedJoint"
CONTACTS = r"Corner|\w*Contact\w*"
PROGRAMS = {"door": ("Axis::error", rf"{OTHERS}|{CONTACTS}"),
            "crate": ("Corner::error", rf"{OTHERS}|HingeJoint"),
            "arm": ("Axis::error", rf"{OTHERS}|{CONTACTS}"),
            "drives": ("Slide::error", rf"Weld|FixedJoint|{CONTACTS}"),
            "shafts": ("Axis::error", rf"{OTHERS}|{CONTACTS}"),
            "gear": ("check_functions", rf"SliderJoint|FixedJoint|{CONTACTS}"),
            "cylinder": ("Slide::error", rf"SliderJoint|Weld|FixedJoint|{CONTACTS}"),
            "saved": ("restore", rf"{OTHERS}|Axis|HingeJoint|{CONTACTS}|Scene"),
            "lift": ("Corner::error", rf"{OTHERS}|HingeJoint"),
            "hoist": ("Reduced::step", rf"Corner|Scene")}
EXAMPLES_FOLDER = Path("library") / "examples"


# The functions of exercises that inline functions of the installed headers call; and functions of
# the engine that have the name of one.
CALLED_EXERCISES = {"about", "carried", "coupling", "impact_speed", "inverse_pivot", "limit_row",
                    "tangents", "unwrapped"}
NAMESAKES = {"bias", "step"}

# What the examples in the headers' comments name. A link is the program's own struct.
EXAMPLES = """#include <joints.h>
using namespace joints;
struct Link { int body1, body2; };
Link link_of_mine{1, 2};
void examples(World& world, Solver& solver, real h, BodyId a, BodyId b, vec3 anchor, vec3 axis) {
%s}
"""


class Wrong(Exception):
    """One line that says what does not hold."""


def call(*command):
    """What a command prints; Wrong with all of its words if it fails."""
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode != 0:
        raise Wrong(" ".join(map(str, command)) + f"\n{result.stdout}{result.stderr}")
    return result.stdout


def refused(said, *command):
    """Wrong unless a command fails and says that."""
    result = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if result.returncode == 0 or said not in result.stderr:
        raise Wrong(" ".join(map(str, command)) + f"\nis not refused with '{said}':\n"
                    + result.stderr)


def printed(source):
    """What a program prints by its own first comment."""
    comment = re.search(r"^// Prints:\n((?://.*\n)+)", source.read_text(), re.M)
    if not comment:
        raise Wrong(f"{source.name} does not say what it prints")
    return re.sub(r"^//(   )?", "", comment[1], flags=re.M).rstrip("\n")


def look_at_installed(root, build, prefix):
    """The installed files name no file of ROOT or BUILD, and include only each other."""
    include = prefix / "include" / "joints"
    for path in sorted(p for p in prefix.rglob("*") if p.suffix in (".h", ".cmake", ".pc")):
        text = path.read_text()
        if any(re.search(rf"(?<![\w/.]){re.escape(str(place))}/", text) for place in (root, build)):
            raise Wrong(f"{path.relative_to(prefix)} names the folder it was made in")
        for header in re.findall(r'^\s*#include "([^"]+)"', text, re.M):
            if not (include / header).is_file():
                raise Wrong(f"{path.relative_to(prefix)} includes {header}, not installed")
    outside = [p for p in (prefix / "include").rglob("*.h") if include not in p.parents]
    if outside:
        raise Wrong(f"{outside[0]} lies outside include/joints")


def examples_of(prefix):
    """A source with the code that the headers' comments quote: what has a bracket and is not, as
    an & shows, a signature."""
    lines = []
    for path in sorted(prefix.rglob("*.h")):
        comments = re.sub(r"\s+", " ", " ".join(re.findall(r"///<? ?(.*)", path.read_text())))
        lines += [f"  static_cast<void>({code});  // {path.relative_to(prefix)}\n"
                  for code in re.findall(r"`([^`]*)`", comments)
                  if re.search(r"[({]", code) and "&" not in code]
    if not lines:
        raise Wrong("no header quotes code in backquotes any more")
    return EXAMPLES % "".join(lines)


def look_at_build(root, area, folder):
    """The compiler was pointed at, and has read, nothing of ROOT but `area`."""
    for entry in json.loads((folder / "compile_commands.json").read_text()):
        words = re.split(r"\s|(?<=-I)|(?<=-isystem)", entry["command"])
        read = re.findall(r"^    (.+)$", call("ninja", "-C", folder, "-t", "deps"), re.M)
        if not any("joints.h" in name for name in read):
            raise Wrong("ninja -t deps does not say which headers were read")
        for name in words + read:
            path = (folder / name).resolve()
            if path.is_relative_to(root) and not path.is_relative_to(area):
                raise Wrong(f"the program outside uses {path}")


def build_and_run(root, area, prefix, compiler, library):
    """Builds a copy of the programs with one of the two libraries; each says what it promises."""
    source, folder = area / f"{library}_source", area / f"{library}_build"
    shutil.copytree(root / EXAMPLES_FOLDER, source)
    (source / "examples.cpp").write_text(examples_of(prefix))
    lists = source / "CMakeLists.txt"
    text = lists.read_text() + ("add_library(examples OBJECT examples.cpp)\n"
                                "target_link_libraries(examples joints::joints)\n")
    for name in ("joints", "checker"):
        text = text.replace(f"joints::{name}", f"joints::{name}{library.removeprefix('joints')}")
    lists.write_text(text)
    call("cmake", "-S", source, "-B", folder, "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}",
         f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
         "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON",
         "-DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF")
    call("cmake", "--build", folder)
    look_at_build(root, area, folder)
    for program, (used, foreign) in PROGRAMS.items():
        symbols = call("nm", "-C", folder / program)
        if f"joints::{used}" not in symbols:
            raise Wrong(f"{program}: nm shows no joints::{used}")
        if found := re.search(rf"joints::({foreign})\b", symbols):
            raise Wrong(f"{program} carries {found[0]}")
        said = call(folder / program).rstrip("\n")
        print(f"{library}: {said}")
        if (program, library) != ("gear", "joints_float") and \
                said != printed(source / f"{program}.cpp"):  # that report shows many digits
            raise Wrong(f"{program} does not print what its first comment says")


def definitions(prefix, library):
    """The preprocessor definitions that come with an installed library."""
    return re.findall(r"-D[\w=]+", (prefix / "lib" / "pkgconfig" / f"{library}.pc").read_text())


def kinds_do_not_mix(area, prefix, compiler):
    """A program of one kind of number with the library of the other, or of both, does not link."""
    door, crate = area / "double_door.o", area / "float_crate.o"
    shutil.copy(area / "joints_build" / "CMakeFiles" / "door.dir" / "door.cpp.o", door)
    shutil.copy(area / "joints_float_build" / "CMakeFiles" / "crate.dir" / "crate.cpp.o", crate)
    in_double, in_float = (prefix / "lib" / f"libjoints{end}.a" for end in ("", "_float"))
    for number, own, library in (("double", door, in_float), ("float", crate, in_double)):
        refused(f"undefined reference to `joints::step(joints::World&, joints::Solver&, {number}",
                compiler, own, library, "-o", area / "mixed")
    # even a file that calls no function of numbers
    source, empty = area / "empty.cpp", area / "empty.o"
    source.write_text("#include <joints.h>\nint main() { return joints::World().bodies.size(); }\n")
    call(compiler, "-std=c++20", "-c", *definitions(prefix, "joints_float"),
         f"-I{prefix}/include/joints", source, "-o", empty)
    refused("undefined reference to `joints::number_of_the_library(float", compiler, empty,
            in_double, "-o", area / "mixed")
    call("objcopy", "--redefine-sym", "main=other", crate)
    for libraries in ((in_double, in_float), (in_float, in_double)):
        refused("multiple definition of `joints::", compiler, door, crate, *libraries,
                "-o", area / "mixed")
    lists = area / "joints_source" / "CMakeLists.txt"
    lists.write_text(lists.read_text() + "target_link_libraries(door joints::joints_float)\n")
    refused("INTERFACE_JOINTS_REAL", "cmake", area / "joints_build")


def bare_headers_say_so(area, prefix, compiler):
    """A header with another order of quaternions, or in an older C++, says what to do."""
    source = area / "bare.cpp"
    source.write_text("#include <joints.h>\n")
    for said, option in (("quaternion as x, y, z, w", "-DGLM_FORCE_QUAT_DATA_WXYZ"),
                         ("compile with -std=c++20", "-std=c++17")):
        refused(said, compiler, "-std=c++20", "-E", f"-I{prefix}/include/joints", option, source)


def parts_say_what_is_missing(root, area, prefix, compiler):
    """Without one of the members of a part, the first error is a sentence that names it."""
    header = root / EXAMPLES_FOLDER / "universal_joint.h"
    source, whole = area / "part.cpp", header.read_text().replace("#pragma once", "")
    needed = definitions(prefix, "joints")
    for said, member in (("needs `static constexpr int rows`", r"  static constexpr int rows.*?\n"),
                         ("`static constexpr bool one_sided`", r"  static constexpr bool.*?\n"),
                         ("`static constexpr Form form`", r"  static constexpr Form.*?\n"),
                         ("`error(body1, body2)`", r"  real error\(.*?\n  }\n"),
                         ("`jacobian(body1, body2)`", r"  Row jacobian\(.*?\n  }\n"),
                         ("`void check(const P& part)`", r"inline void check\(.*?\n}\n")):
        left, count = re.subn(member, "", whole, count=1, flags=re.S)
        source.write_text(left + "\ntemplate class joints::PartJoint<joints::Composite<"
                          "joints::Point, mine::RightAngle>>;\n")
        command = [compiler, "-std=c++20", "-fsyntax-only", f"-I{prefix}/include/joints", *needed,
                   source]
        errors = subprocess.run([str(word) for word in command], capture_output=True,
                                text=True).stderr
        first = next((line for line in errors.split("\n") if "error:" in line), "")
        if count != 1 or said not in first:
            raise Wrong(f"a part without {said}: the first error is\n{first}")


def names_are_listed(root, area, prefix, compiler):
    """The installed headers bring the names of names.txt into joints, and no exercise beyond those
    that they call themselves."""
    text = call(compiler, "-std=c++20", "-E", "-P", *definitions(prefix, "joints"),
                f"-I{prefix}/include/joints", area / "bare.cpp")
    found = exported.names(text)
    if found != set((root / exported.LIST).read_text().split()):
        raise Wrong(f"{exported.LIST} is not the list of the exported names: ./wb keep listings")
    function = re.compile(r"^/// Exercise (?:.*\n///)*.*\n(?:template .*\n)?\S[^(;]*?(\w+)\(", re.M)
    exercises = {name for header in (root / "chapters").glob("*/*.h")
                 for name in function.findall(header.read_text())}
    if (exercises & found) - NAMESAKES != CALLED_EXERCISES:
        raise Wrong(f"exported exercises: {sorted(exercises & found)}")
    print(f"{len(found)} names are exported; of {len(exercises)} functions of exercises "
          f"{len(CALLED_EXERCISES)}, which the headers call")


def older_programs_run(root, area, prefix, compiler):
    """Programs of older states of the page compile, apart from the changes that docs/upgrading.md
    lists, and run. Each old form gives a warning that says what to write."""
    advice = "write world.add<J>(body1, body2, ...)"
    flags = ["-std=c++20", "-O1", "-Wall", "-Wextra", *definitions(prefix, "joints"),
             "-isystem", prefix / "include" / "joints"]
    older = root / "tests" / "library" / "older"
    shafts = (older / "0.10-first" / "shafts.cpp").read_text()
    own = area / "own_shafts.cpp"  # as the page on upgrading says
    for old, new in (("\nnamespace joints {", "\nnamespace mine {\nusing namespace joints;"),
                     ("add<UniversalJoint>", "add<mine::UniversalJoint>"),
                     ("Composite<Point, RightAngle>{", "Composite<Point, mine::RightAngle>{")):
        shafts = shafts.replace(old, new)
    own.write_text(shafts)
    refused("joints::RightAngle", compiler, *flags, "-c",
            older / "0.10-first" / "shafts.cpp", "-o", area / "older.o")
    for source in (older / "0.9" / "machines.cpp", own):
        made = subprocess.run([str(word) for word in (
            compiler, *flags, source, prefix / "lib" / "libjoints.a", "-o", area / "older")],
            capture_output=True, text=True)
        warnings = [line for line in made.stderr.split("\n") if "warning:" in line]
        if made.returncode or len(warnings) != source.read_text().count("(world.bodies, ") or \
           not all(advice in line for line in warnings):
            raise Wrong(f"{source} does not compile with its warnings:\n{made.stderr}")
        call(area / "older")


def compiled(root, folder, *question):
    """The sources that ninja's answer compiles, named from ROOT or from the build folder."""
    sources = re.findall(r' -c ([^\s"]+)', call("ninja", "-C", folder, "-t", *question))
    return {source.removeprefix(f"{folder}/").removeprefix(f"{root}/") for source in sources}


def library_stands_alone(root, build, area, compiler):
    """Without the workbook's packages the same sources are compiled into it, and nothing else."""
    alone = area / "alone"
    configure = ["cmake", "-S", root, "-B", alone, "-G", "Ninja",
                 f"-DCMAKE_CXX_COMPILER={compiler}"]
    configure += [f"-DCMAKE_DISABLE_FIND_PACKAGE_{name}=ON"
                  for name in ("Catch2", "Eigen3", "Python3")]
    call(*configure, "-DWORKBOOK_LIBRARY_ONLY=ON")
    differ = compiled(root, alone, "compdb") ^ compiled(root, build, "commands", "library")
    if differ:
        raise Wrong(f"compiled in one of {alone.name} and the workbook only: {sorted(differ)}")
    refused("Catch2", *configure, "-DWORKBOOK_LIBRARY_ONLY=OFF")


def compiler_of(build):
    """The C++ compiler of a build folder."""
    cache = (build / "CMakeCache.txt").read_text()
    return re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$", cache, re.M)[1]


def prove(document, proof, arguments):
    """Runs a proof of this folder, NAME_test.py ROOT BUILD, in an empty folder of its own."""
    if len(arguments) != 2 or not all(Path(argument).is_dir() for argument in arguments):
        print(document.split("\n", maxsplit=1)[0], file=sys.stderr)
        return 2
    root, build = (Path(argument).resolve() for argument in arguments)
    area = build / proof.__name__
    shutil.rmtree(area, ignore_errors=True)
    area.mkdir()
    try:
        return proof(root, build, area)
    except Wrong as wrong:
        print(wrong, file=sys.stderr)
        return 1


def library_test(root, build, area):
    compiler, prefix = compiler_of(build), area / "installed"
    call("cmake", "--install", build, "--prefix", prefix)
    look_at_installed(root, build, prefix)
    for library in ("joints", "joints_float"):
        build_and_run(root, area, prefix, compiler, library)
    kinds_do_not_mix(area, prefix, compiler)
    bare_headers_say_so(area, prefix, compiler)
    names_are_listed(root, area, prefix, compiler)
    older_programs_run(root, area, prefix, compiler)
    parts_say_what_is_missing(root, area, prefix, compiler)
    library_stands_alone(root, build, area, compiler)
    return 0


if __name__ == "__main__":
    sys.exit(prove(__doc__, library_test, sys.argv[1:]))
