"""The library is a package of Debian: package_test.py ROOT BUILD

Packs BUILD, reads what `lintian` says of the package where it is installed, unpacks it into a
folder, and builds and runs programs of library/examples with the unpacked files alone. Exit status
0 when the package holds what an installation holds, and the programs print what they promise; 1
otherwise, 2 for a bad command line, 77 where there is no dpkg or
pkg-config.
"""
import shutil
import sys

from library_test import Wrong, call, compiler_of, prove
from pkg_config_test import build_and_run


def files_below(folder):
    return {str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file()}


def package_test(root, build, area):
    for needed in ("dpkg-deb", "pkg-config"):
        if not shutil.which(needed):
            print(f"{needed} is not there")
            return 77
    call("cpack", "-G", "DEB", "-B", area, "--config", build / "CPackConfig.cmake",
         "-D", "CPACK_PACKAGE_CONTACT=A Teacher <teacher@school.edu>")
    package, = area.glob("libjoints-dev_*.deb")
    if shutil.which("lintian"):
        call("lintian", "--allow-root", "--fail-on", "error,warning",
             "--suppress-tags", "pkg-config-unavailable-for-cross-compilation",  # below /usr alone
             package)
    else:
        print("without lintian, which is not there")
    call("dpkg-deb", "-x", package, area / "unpacked")
    call("cmake", "--install", build, "--prefix", area / "installed")
    differ = files_below(area / "unpacked" / "usr") ^ files_below(area / "installed")
    if differ:
        raise Wrong(f"only in the package or only installed: {sorted(differ)}")
    for library in ("joints", "joints_float"):
        build_and_run(root, area, compiler_of(build), library, area / "unpacked" / "usr")
    return 0


if __name__ == "__main__":
    sys.exit(prove(__doc__, package_test, sys.argv[1:]))
