"""Draws figures with the scripts of plots/."""
import json
import re
import subprocess
import sys

from base import house

TABLE, STABILITY = house.OUT / "work_precision.csv", house.OUT / "stability.csv"
METHODS, OUT_OF_PEERS = house.OUT / "methods.csv", house.OUT / "peers.csv"
LOOP, SCALING = house.OUT / "loop.csv", house.OUT / "scaling.csv"
PEERS, THESIS = house.ROOT / "bench" / "peers.csv", house.ROOT / "bench" / "thesis_frames.csv"
FIGURES = house.OUT / "plots"


def draw(script, *arguments, figures=FIGURES):
    """Runs one script; returns the PNG files that it made."""
    return draw_all([(script, *arguments)], figures)


def draw_all(jobs, figures=FIGURES):
    """Runs several (script, arguments...) in one process; returns the PNG files that they made."""
    before = {path: path.stat().st_mtime_ns for path in figures.glob("*.png")}
    lines = "".join(json.dumps([*map(str, job), "--out", str(figures)]) + "\n" for job in jobs)
    with house.talking():
        process = subprocess.Popen([sys.executable, "-B", house.ROOT / "plots" / "several.py"],
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True)
        process.stdin.write(lines)
        process.stdin.close()
        script = "several.py"
        for line in process.stdout:
            if line.startswith("drawing "):
                script = line.split()[1]
                house.progress(f"drawing: plots/{script}")
        words = process.stderr.read().strip()
    if process.wait() != 0:
        raise house.Trouble(words or f"plots/{script} failed")
    return sorted(path for path in figures.glob("*.png")
                  if path.stat().st_mtime_ns != before.get(path))


def title_of(path):
    """What a figure says above its panels, which plots/files.py has put into the PNG."""
    data = path.read_bytes()
    at = data.find(b"iTXtTitle\0")
    if at < 0:
        return ""
    chunk = data[at + 4:at + 4 + int.from_bytes(data[at - 4:at], "big")]
    return re.sub(r"[$\\]", "", chunk.split(b"\0", 5)[-1].decode("utf-8"))


def of_chapter(chapter, solution, mine=None):
    """The job that draws a chapter's figures, of the recorded runs in these folders."""
    return (f"chapter_{chapter.number:02}.py", "--solution", solution,
            *(["--mine", mine] if mine else []))


def draw_methods():
    """Every method on every scene; out/ itself holds the figure."""
    return draw("methods.py", "--csv", METHODS, figures=house.OUT)


def draw_peers():
    """Ours beside the published engines, a figure a scene; stored figures are drawn apart."""
    return draw("peers.py", "--csv", OUT_OF_PEERS, "--stored", PEERS, figures=house.OUT / "peers")


def draw_loop():
    """The inner loop in its variants; out/ itself holds the figure, as it holds the table."""
    return draw("loop.py", "--csv", LOOP, "--thesis", THESIS, figures=house.OUT)
