"""Runs a benchmark program: what the commands that measure have in common."""
import subprocess

from base import house
from pictures import figures


def run_bench(program, options, table=figures.TABLE):
    """One run of a benchmark program; its progress is shown."""
    house.OUT.mkdir(exist_ok=True)
    process = subprocess.Popen([house.BUILD / "bench" / program, "--csv", table, *options],
                               stderr=subprocess.PIPE, text=True)
    said = ""
    for line in process.stderr:
        said = line.strip()
        house.progress(f"{program}: {said}")
    if process.wait() != 0:
        raise house.Trouble(said.removeprefix("error: "))
    house.progress_done()
