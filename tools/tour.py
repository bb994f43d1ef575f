"""./wb tour: everything computed, drawn, moving and summarised, from the solutions."""
import csv
import resource

import figures
import house
import show
from measuring import run_bench
from talk import bold


def tour():
    chapters = house.chapters()
    print("every chapter's program, every figure, every motion: " + cost(), flush=True)
    house.must_build([f"{c.folder}_run" for c in chapters] + ["work_precision"], "building")
    pages = []
    with house.talking():
        for chapter in chapters:
            house.progress(f"running chapter {chapter.number}")
            show.call_program(f"{chapter.folder}_run", show.SOLUTIONS / chapter.folder, [], True)
            pages.append(show.make_page(chapter, show.SOLUTIONS / chapter.folder, None))
        house.progress("error against run time, the short form")
        run_bench("work_precision", ["--quick", "1"])
    made = figures.draw_all(
        [figures.of_chapter(chapter, show.SOLUTIONS / chapter.folder) for chapter in chapters]
        + [("work_precision.py", "--csv", figures.TABLE, "--peers", figures.PEERS)])
    house.progress_done()
    print()
    summary_table(chapters)
    print("""
gap: how far joints are apart; drift: change of energy over the run, as a share
of the energy to hand. Ropes that become taut and limits that stop a body take
some, as in nature, motors add their work, and what sags has come to rest lower;
what is lost else, the method loses.
""")
    print(bold("pictures"))
    for path in made:
        print(f"  {house.short(path)}")
    print(bold("motion, open in a browser"))
    for page in pages:
        print(f"  {house.short(page)}")
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    print(f"\nprocessor time: {used.ru_utime + used.ru_stime:.0f} s\n\n"
          "Your turn: ./wb leads you to the first exercise.")
    return 0


def cost():
    """What a tour takes, said before it begins."""
    if (house.BUILD / "build.ninja").exists():
        return "half a\nminute, and what has to be built."
    return "one to\nfour minutes the first time, most of it to build; 25 MB in build/ and out/."


def summary_table(chapters):
    print(f"{'scene':12} {'setting':25} {'us/step':>8} {'gap, mm':>9} {'largest':>9} "
          f"{'drift':>9}")
    for chapter in chapters:
        with open(show.SOLUTIONS / chapter.folder / "summary.csv", newline="") as file:
            for row in csv.DictReader(file):
                print(f"{row['scene']:12} {row['setting']:25} {float(row['us_per_step']):8.2f} "
                      f"{1000 * float(row['gap_rms_m']):9.3g} "
                      f"{1000 * float(row['gap_max_m']):9.3g} "
                      f"{float(row['energy_drift']):9.2g}")
