"""The library serves a program that is not built with CMake: pkg_config_test.py ROOT BUILD

Installs BUILD, moves what is installed elsewhere, and builds and runs programs of library/examples
with nothing but the compiler and the output of pkg-config, in double and in float. Exit status 0
when they print what they promise, 1 otherwise, 2 for a bad command line, 77 where there is no
pkg-config.
"""
import os
import shutil
import subprocess
import sys

from library_test import EXAMPLES_FOLDER, Wrong, call, compiler_of, printed, prove


def build_and_run(root, area, compiler, library, prefix):
    """Two programs that pkg-config helps to build with the files below a prefix say their lines."""
    os.environ["PKG_CONFIG_PATH"] = str(prefix / "lib" / "pkgconfig")
    flags, libs = (call("pkg-config", what, library).split() for what in ("--cflags", "--libs"))
    for program in ("door", "arm"):
        source = root / EXAMPLES_FOLDER / f"{program}.cpp"
        made = area / f"{program}_{library}"
        call(compiler, "-std=c++20", "-Wall", "-Wextra", "-Werror",
             source, *flags, *libs, "-o", made)
        said = call(made).rstrip("\n")
        print(f"{library}: {said}")
        if said != printed(source):
            raise Wrong(f"{program} does not print what its first comment says")


def contacts_from_bullet(root, area, compiler):
    """Where Bullet is, the program of docs/contacts.md needs its collision part alone."""
    if subprocess.run(["pkg-config", "--exists", "bullet-float64"]).returncode != 0:
        print("bullet-float64 is not there")
        return
    flags = call("pkg-config", "--cflags", "--libs", "joints").split()
    flags += call("pkg-config", "--cflags", "bullet-float64").split()
    call(compiler, "-std=c++20", "-O2", root / "tests" / "bullet" / "heap.cpp", *flags,
         "-lBulletCollision-float64", "-lLinearMath-float64", "-o", area / "heap")
    said = call(area / "heap").strip()
    print(f"heap: {said}")
    if said not in (root / "docs" / "contacts.md").read_text():
        raise Wrong("docs/contacts.md says that a program says something else")


def pkg_config_test(root, build, area):
    if not shutil.which("pkg-config"):
        print("pkg-config is not there")
        return 77
    call("cmake", "--install", build, "--prefix", area / "first")
    (area / "first").rename(area / "moved")
    for library in ("joints", "joints_float"):
        build_and_run(root, area, compiler_of(build), library, area / "moved")
    contacts_from_bullet(root, area, compiler_of(build))
    return 0


if __name__ == "__main__":
    sys.exit(prove(__doc__, pkg_config_test, sys.argv[1:]))
