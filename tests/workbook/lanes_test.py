"""What works on lanes is built for several processors: lanes_test.py ROOT BUILD"""
import re
import sys

from proofs import main, symbols_of


def lanes_stay_at_home(root, build):
    """what is compiled for one kind of processor shares no function with the rest"""
    for kind, room, entry in (("simd", "engine", "run_pass_avx2("),
                              ("simd_float", "engine", "run_pass_avx2("),
                              ("reduced", "reduced", "runge_kutta_avx2("),
                              ("reduced_float", "reduced", "runge_kutta_avx2(")):
        folder = build / room / "CMakeFiles" / f"{kind}.dir"
        if not folder.is_dir():
            yield f"{folder} is not there"
        for path in folder.rglob("*avx2*.o"):
            lines = symbols_of(path).splitlines()
            if not any(entry in line for line in lines):
                yield f"{path.name}: nm shows no symbols"
            for line in lines:  # W, V, u: one definition of several, whichever the linker takes
                if re.match(r"[0-9a-f]* ?[WVu] ", line.strip()) and "LanesFor<2," not in line:
                    yield f"{kind}, {path.name}: {line.strip()}"


if __name__ == "__main__":
    sys.exit(main(__doc__, [lanes_stay_at_home], sys.argv[1:]))
