"""Ours beside the published engines that Debian packages: the same scenes and measures, one run."""
import os
import platform
from pathlib import Path

from base import house
from pictures import figures
from bench.measuring import MEASURED, cells, heading, read, run_bench, tell

PROGRAM = "bench/peers/peers"
PACKAGES = {"libbullet-dev": "bullet/btBulletDynamicsCommon.h", "libode-dev": "ode/ode.h",
            "libmujoco-dev": "mujoco/mujoco.h", "libsimbody-dev": "simbody/Simbody.h"}
INCLUDE = Path("/usr/include")
OURS = "ours"
BUSY = 0.5       # of the load average: what else runs is said above it
ROUGH = 0.25     # of the spread: above it the times of a row are said to be rough
HOLDS = 10       # [mm]; below it ours should be on the front
EXACT = 1e-7     # [m]; what is better counts as alike: rounding is no merit
MEASURES = {"gap_max_m": ("largest gap", 1000, "mm"), "tip_error_m": ("tip error", 1000, "mm"),
            "found": ("finding", 1, ""), "energy_drift": ("energy gained or lost", 100, "%")}


def lacking():
    """The packages that are not installed."""
    return [name for name, header in PACKAGES.items() if not (INCLUDE / header).exists()]


def machine():
    """The processor and the compiler of the programs, without a comma."""
    name = platform.processor() or platform.machine()
    try:
        with open("/proc/cpuinfo") as file:
            name = next((line.split(":")[1].strip() for line in file
                         if line.startswith("model name")), name)
    except OSError:
        pass
    compiled = (house.BUILD / "compiled_with.txt").read_text().strip()
    words = f"{name}; {os.cpu_count()} processors; load {load():.1f}; {compiled}"
    return words.replace(",", "")


def load():
    return os.getloadavg()[0] if hasattr(os, "getloadavg") else 0.0


def programs():
    """Those that CMake has set up, once more if packages came since."""
    house.configure()
    targets = [name for name in ("peers", "peers_float") if f"bench/peers/{name}:" in ninja()]
    if len(targets) < 2:
        house.configure(again=True)
        targets = [name for name in ("peers", "peers_float") if f"bench/peers/{name}:" in ninja()]
    return targets


def ninja():
    return (house.BUILD / "build.ninja").read_text()


# ---- the front -----------------------------------------------------------------------------------

def size(row, measure):
    """How far off a row is; infinite where it is lost or has no such measure."""
    if row["status"] in ("nan", "refused", "exploded", "energy+") or not row[measure]:
        return float("inf")
    if measure == "energy_drift" and row["finding"]:
        return float("inf")  # it is meant to lose some
    expected = float(row["expected"]) if measure == "found" and row["expected"] else 0.0
    return max(EXACT, abs(float(row[measure]) - expected))


def front(rows, measure):
    """Those that nothing beats in both, fastest first. A thousandth better is no merit."""
    best, out = float("inf"), []
    for row in sorted(rows, key=lambda row: (float(row["us_per_step"]), size(row, measure))):
        if size(row, measure) < 0.999 * best:
            best = size(row, measure)
            out.append(row)
    return out


def called(row):
    version = f" {row['version']}" if row["version"] else ""
    return f"{row['engine']}{version}, {row['real']}, {row['setting']}"


COLUMNS = [*MEASURED, ("memory", "[kB]", "bytes", 1e-3, "8.0f")]


def print_scene(scene, rows):
    name, titles, units = heading(rows, COLUMNS)
    print(f"\n{scene}{name}\n  {titles}  engine and setting\n  {units}")
    for row in sorted(rows, key=lambda row: float(row["us_per_step"])):
        print(f"  {cells(row, COLUMNS)}  {called(row)}, {row['status']}")


def print_front(scene, rows):
    """The front of every measure that the scene has, and in words where a peer is on it."""
    for measure, (words, factor, unit) in MEASURES.items():
        line = [row for row in front(rows, measure) if size(row, measure) < float("inf")]
        if not line:
            continue
        print(f"  front, {words}:")
        for row in line:
            print(f"    {float(row['us_per_step']):9.1f} us a step "
                  f"{factor * size(row, measure):9.3g} {unit:2}  {called(row)}")
        for row in line:
            if row["engine"] == OURS or factor * size(row, measure) > HOLDS:
                continue
            as_good = [float(one["us_per_step"]) for one in rows if one["engine"] == OURS
                       and size(one, measure) <= size(row, measure)]
            print(f"    a peer wins: {called(row)}; ours as good takes "
                  + (f"{min(as_good) / float(row['us_per_step']):.2f} times as long" if as_good
                     else "longer than any that was tried"))


def print_scaling(rows):
    """What a joint costs, and takes of memory, in scenes of more and more of them."""
    print("\ntime of a joint and step [ns] and memory of a joint [bytes], by the number of "
          "joints of S1:")
    sizes = sorted({int(row["joints"]) for row in rows})
    print(f"  {'':48}" + "".join(f"{count:>16,}" for count in sizes))
    for name in dict.fromkeys(called(row) for row in rows):
        cells = {int(row["joints"]): row for row in rows if called(row) == name}
        print(f"  {name:48}" + "".join(
            f"{1000 * float(cells[n]['us_per_step']) / n:9.0f}{float(cells[n]['bytes']) / n:7.0f}"
            if n in cells else f"{'-':>16}" for n in sizes))


def main(options):
    missing = lacking()
    if missing:
        print("not installed: " + ", ".join(missing) + "; sudo apt-get install "
              "--no-install-recommends " + " ".join(missing))
    if len(missing) == len(PACKAGES):
        raise house.Trouble("bench --peers: none of the engines is installed")
    long = "four" if "--quick" in options else "twenty"
    print(f"the published engines beside ours: about {long} minutes; leave the machine alone "
          "meanwhile", flush=True)
    busy = load()
    if busy > BUSY:
        print(f"the machine is busy (load {busy:.1f}): times are rough, errors are not")
    targets = programs()
    house.must_build(targets)
    words = machine()
    for name, more in zip(targets, ([], ["--append"])):
        run_bench(f"peers/{name}", ["--machine", words, *more, *options], figures.OUT_OF_PEERS)
    rows = read(figures.OUT_OF_PEERS)
    scaled = [row for row in rows if row["scene"].endswith(" hinges")]
    for scene in dict.fromkeys(row["scene"] for row in rows):
        mine = [row for row in rows if row["scene"] == scene]
        if mine[0] in scaled:
            continue
        print_scene(scene, mine)
        print_front(scene, mine)
    if scaled:
        print_scaling(scaled)
    rough = sum(float(row["spread"]) > ROUGH for row in rows)
    print(f"\n{len(rows)} rows on {words}")
    if rough:
        print(f"{rough} of them have times that spread by more than {100 * ROUGH:.0f} % between "
              "their quartiles: something else ran, repeat them")
    print("gap: the largest of all joints in the last two thirds of a run; energy: gained or lost, "
          "by the\nscene's own scale, with velocities by differences of the poses; spread: between "
          "the quartiles of\nthe times, by the median; found: what the scene is for.\n")
    return tell(figures.draw_peers(), figures.OUT_OF_PEERS)
