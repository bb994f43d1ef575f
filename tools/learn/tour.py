"""./wb tour: everything computed, drawn and moving, from the solutions, on one page."""
import resource
import time

from base import house
from learn import show
from pictures import figures
from website import report
from bench.measuring import run_bench


def tour():
    chapters, began = house.chapters(), time.monotonic()
    print("every chapter's program, every figure, every motion: " + cost(), flush=True)
    house.must_build([*house.programs(), "work_precision"], "building")
    with house.talking():
        for chapter in chapters:
            house.progress(f"running chapter {chapter.number}")
            show.call_programs(chapter.programs, show.SOLUTIONS / chapter.folder, [], True)
            show.make_page(chapter, show.SOLUTIONS / chapter.folder, None)
        house.progress("error against run time, the short form")
        run_bench("work_precision", ["--quick", "1"])
    jobs = [figures.of_chapter(chapter, show.SOLUTIONS / chapter.folder) for chapter in chapters]
    jobs.append(("work_precision.py", "--csv", figures.TABLE, "--peers", figures.PEERS))
    if figures.STABILITY.exists():
        jobs.append(("stability.py", "--csv", figures.STABILITY))
    figures.draw_all(jobs)
    house.progress_done()
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    page = report.write(chapters, used.ru_utime + used.ru_stime,
                        time.monotonic() - began)
    print("", *report.six_lines(), sep="\n")
    print(f"\nAll of it on one page: {house.short(page)}\n"
          "Your turn: ./wb leads you to the first exercise.")
    return 0


def cost():
    """What a tour takes, said before it begins."""
    if (house.BUILD / "build.ninja").exists():
        return "half a\nminute, and the time of the build."
    return "one to\nfour minutes the first time, most of it to build; 25 MB in build/ and out/."

