"""The library fits into other people's projects: guest_test.py ROOT BUILD

Installs BUILD. No header gives a warning under strict flags, ordinary GLM compiles as without the
library, and a plug-in is linked with the static library and loaded by Python. What the page says of
wishes without a call of their own works. A file that was compiled with GLM_FORCE_CTOR_INIT does not
link. A common mistake gets a sentence from the compiler among its first lines. Another project
takes the library by FetchContent as a shared library, although it has targets with the workbook's
names; the shared library is linked from the objects of BUILD. What was installed can be removed.
Exit status 0 when all of that holds, 1 otherwise, 2 for a bad command line.
"""
import re
import shutil
import subprocess
import sys

from library_test import Wrong, call, compiler_of, prove, refused

STRICT = ["-std=c++20", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wsign-conversion",
          "-Wpedantic", "-Werror"]
# A statement with a mistake, and what the compiler says about it at once.
MISTAKES = {
    "world.add<HingeJoint>(a, b, vec3(0));": "J has no constructor with these arguments",
    "World copy = world;": "a World is not copied",
    "auto ball = world.add<BallJoint>(a, b, vec3(0));": "a joint is not copied: auto& joint =",
    "auto hinge = world.add<HingeJoint>(a, b, vec3(0), vec3(1));": "auto& joint = world.add",
    "v = 2 * vec3(1);": "write real(2) * v",
    "v = vec3(1) * 2;": "write v * real(2)",
    "v = vec3(1) / 2;": "write v / real(2)"}
BEFORE, FIRST = 6, 26  # lines of the compiler


def flags(prefix, library):
    """What pkg-config says, without it."""
    text = (prefix / "lib" / "pkgconfig" / f"{library}.pc").read_text()
    words = re.search(r"^Cflags: (.*)", text, re.M)[1].replace("${prefix}", str(prefix)).split()
    if any("GLM" in word for word in words):
        raise Wrong(f"{library}.pc sets a definition of GLM's")
    return words


def headers_are_clean(guest, area, prefix, compilers):
    """Every installed header, in both kinds of number, and ordinary GLM beside them."""
    include = prefix / "include" / "joints"
    source = area / "headers.cpp"
    names = sorted(str(path.relative_to(include)) for path in include.rglob("*.h")
                   if path.name not in ("bullet_contacts.h", "iterate.h"))  # Bullet; no header
    source.write_text("".join(f'#include "{name}"\n' for name in [*names, guest]))
    for compiler in compilers:
        for library in ("joints", "joints_float"):
            call(compiler, *STRICT, "-fsyntax-only", *flags(prefix, library), source)
            plain = ["-I" if word == "-isystem" else word for word in flags(prefix, library)]
            call(compiler, *STRICT, "-fsyntax-only", *plain, "-include", "joints.h", guest)
    print(f"{len(names)} headers without a warning from {len(compilers)} compilers")


def mistakes_get_a_sentence(area, prefix, compilers):
    """Each in a line of its own of one source: the sentence stands near the line's first mention.
    """
    source = area / "mistakes.cpp"
    source.write_text("#include <joints.h>\nusing namespace joints;\n"
                      "void make(World& world, BodyId a, BodyId b, vec3& v) {\n"
                      + "\n".join(MISTAKES) + "\n}\n")
    for compiler in compilers:
        made = subprocess.run([str(word) for word in (
            compiler, "-std=c++20", "-fsyntax-only", "-ferror-limit=0" if "clang" in compiler else
            "-fmax-errors=0", *flags(prefix, "joints"), source)], capture_output=True, text=True)
        lines = made.stderr.split("\n")
        for number, (mistake, sentence) in enumerate(MISTAKES.items(), 4):
            at = [k for k, line in enumerate(lines) if f"{source.name}:{number}:" in line]
            near = "\n".join(lines[max(0, at[0] - BEFORE):at[0] + FIRST]) if at else made.stderr
            if not at or sentence not in near:
                raise Wrong(f"{mistake}\n{compiler} does not say '{sentence}' at once:\n{near}")


def loaded(plugin):
    """Wrong unless the door of a plug-in that Python loads stands where its motor takes it."""
    # in a process of its own, which ends with the library
    said = float(call(sys.executable, "-c", "import ctypes, sys; library = ctypes.CDLL(sys.argv[1])"
                      "\nlibrary.angle_of_door.restype = ctypes.c_double"
                      "\nprint(library.angle_of_door())", plugin))
    if abs(said - 0.5) > 1e-6:
        raise Wrong(f"{plugin}: the door stands at {said}, not at 0.5")
    print(f"{plugin.name}, loaded by Python: the door stands at {said:.6f} rad")


def plugin_of_archive(plugged, area, prefix, compiler):
    """The static library becomes part of a shared object; with other vectors it does not."""
    archive = prefix / "lib" / "libjoints.a"
    options = [compiler, *flags(prefix, "joints"), "-std=c++20", "-fPIC", "-shared",
               "-Wl,--no-undefined"]
    call(*options, plugged, archive, "-o", area / "static_guest.so")
    loaded(area / "static_guest.so")
    other = area / "other.cpp"
    other.write_text("#include <joints.h>\n")
    refused("number_of_the_library(double, joints::GlmWithCtorInit*)", *options, other,
            "-DGLM_FORCE_CTOR_INIT", archive, "-o", area / "other.so")


def wishes_work(guest, area, prefix, compiler):
    """What docs/library.md says of wishes without a call of their own."""
    call(compiler, *flags(prefix, "joints"), *STRICT, guest.with_name("wishes.cpp"),
         prefix / "lib" / "libjoints.a", "-o", area / "wishes")
    call(area / "wishes")


def project_of_its_own(root, build, area, compiler):
    """FetchContent, with the targets' names taken, and -DBUILD_SHARED_LIBS=ON; the plug-in's
    object."""
    source, folder = area / "source", area / "build"
    shutil.copytree(root / "tests" / "library" / "guest", source)
    call("cmake", "-S", source, "-B", folder, "-G", "Ninja", f"-DJOINTS_SOURCE={root}",
         f"-DCMAKE_CXX_COMPILER={compiler}", "-DBUILD_SHARED_LIBS=ON",
         f"-DCMAKE_CXX_FLAGS={' '.join(STRICT[1:])}")
    plugin = folder / "libguest.so"
    commands = call("ninja", "-C", folder, "-t", "commands", "libguest.so").split("\n")
    shared, = (line for line in commands if re.search(r" -o \S*/libjoints\.so", line))
    # The objects of the library are those of BUILD: only what is linked is tried here.
    made, = re.findall(r" -o (\S*libjoints\.so\S*)", shared)
    linked = re.sub(r"\S*?-build/(\S*?)CMakeFiles/joints_(\w+)\.dir/", r"\1CMakeFiles/\2.dir/",
                    shared)
    (folder / made).parent.mkdir(parents=True, exist_ok=True)
    linked = linked.replace(f" -o {made}", f" -o {folder / made}")
    call("sh", "-c", f"cd {build} && {linked}")
    for line in commands:
        if "guest.dir" in line:
            call("sh", "-c", f"cd {folder} && {line}")
    loaded(plugin)
    return folder / "CMakeFiles" / "guest.dir" / "guest.cpp.o"


def can_be_removed(root, build, area, prefix):
    """By the list of what was installed."""
    if "uninstall.cmake" not in call("ninja", "-C", build, "-t", "commands", "uninstall"):
        raise Wrong("there is no target `uninstall`")
    kept = prefix / "lib" / "own.txt"
    files = [path for path in prefix.rglob("*") if not path.is_dir()]
    (area / "install_manifest.txt").write_text("\n".join(map(str, files)))
    kept.write_text("of somebody else\n")
    call("sh", "-c", f"cd {area} && cmake -P {root / 'library' / 'uninstall.cmake'}")
    if [path for path in prefix.rglob("*")] != [prefix / "lib", kept]:
        raise Wrong(f"left below {prefix}: {list(prefix.rglob('*'))}")


def guest_test(root, build, area):
    compiler, prefix = compiler_of(build), area / "installed"
    compilers = [compiler] + [other for other in ("clang++",) if shutil.which(other)
                              and "clang" not in compiler]
    guest = root / "tests" / "library" / "guest" / "guest.cpp"
    call("cmake", "--install", build, "--prefix", prefix)
    plugged = project_of_its_own(root, build, area, compiler)
    plugin_of_archive(plugged, area, prefix, compiler)
    wishes_work(guest, area, prefix, compiler)
    mistakes_get_a_sentence(area, prefix, compilers)
    headers_are_clean(guest, area, prefix, compilers)
    can_be_removed(root, build, area, prefix)
    return 0


if __name__ == "__main__":
    sys.exit(prove(__doc__, guest_test, sys.argv[1:]))
