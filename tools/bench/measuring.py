"""Runs a benchmark program and prints its tables: what the commands that measure share."""
import csv
import subprocess
from pathlib import Path

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


def read(path):
    """The rows of a table."""
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def tell(drawn, *tables):
    """The figures that were drawn, and the tables."""
    for path in drawn:
        print(house.short(path))
    print(f"the table{'s' * (len(tables) > 1)}: {', '.join(map(house.short, tables))}")
    return 0


def prints(name, *programs, words=""):
    """The main function of programs that print a table themselves, with words before each, and
    write it one after the other."""
    def main(options):
        house.must_build([Path(program).name for program in programs])
        house.OUT.mkdir(exist_ok=True)
        table = house.OUT / f"{name}.csv"
        for program in programs:
            if words:
                print(f"\n{Path(program).name}: {words}", flush=True)
            more = [] if program == programs[0] else ["--append"]
            if subprocess.run([house.BUILD / program, "--csv", table, *more, *options]).returncode:
                return 1
        return tell([], table)
    return main


# What the tables of whole scenes show of a row: title, unit, the table's column, factor, form.
MEASURED = [("a step", "[us]", "us_per_step", 1, "9.1f"), ("spread", "[%]", "spread", 100, "7.0f"),
            ("gap max", "[mm]", "gap_max_m", 1000, "9.3g"),
            ("gap RMS", "[mm]", "gap_rms_m", 1000, "9.3g"),
            ("tip off", "[mm]", "tip_error_m", 1000, "9.3g"),
            ("energy", "[1]", "energy_drift", 1, "9.1e"), ("found", "", "found", 1, "9.3g")]


def width(form):
    return int(form.partition(".")[0])


def heading(rows, columns):
    """A scene's name, what is to be found in it, and over each column its title and its unit."""
    found = rows[0]["finding"]
    what, _, unit = found.rstrip("]").partition(" [")
    units = [f"[{unit}]" if name == "found" and unit else at for _, at, name, _, _ in columns]
    return (f", {rows[0]['joints']} joints"
            + (f"; found: {what}, expected {float(rows[0]['expected']):.4g}" if found else "")
            + f" {unit}".rstrip(),
            "".join(f"{title:>{width(form)}}" for title, _, _, _, form in columns),
            "".join(f"{unit:>{width(form)}}" for unit, (*_, form) in zip(units, columns)))


def cells(row, columns):
    """A line of a table; a dash where a measure has no meaning."""
    return "".join(format(factor * float(row[name]), form) if row[name] else f"{'-':>{width(form)}}"
                   for _, _, name, factor, form in columns)
