#!/usr/bin/env python3
"""Builds the site: docs.py OUT_DIR [RECORDINGS]. The page to open is OUT_DIR/html/index.html, no
network needed. RECORDINGS, out/solutions if it is not said, has the motions that the chapters'
programs have recorded; ./wb docs sees to it that they are there.

Exit status: 0 the site stands, 1 Doxygen had something to say, 2 something is missing.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).absolute().parents[1]))
from base import house  # noqa: E402
from learn import show  # noqa: E402
from pictures import figures, motion, pages as parts  # noqa: E402
from website import (classes, experiments, formulas, front, gallery, links, live,  # noqa: E402
                     shell, texts, words)

ROOT = Path(__file__).absolute().parents[2]
THEME = Path("/usr/share/doxygen-awesome-css/doxygen-awesome.css")
# The versions whose HTML finish() reads: where they come from, and the name of the page of topics.
PROVED = {"1.9.4": ("Debian 12", "modules"), "1.9.8": ("Debian 13 and Ubuntu 24.04", "topics")}


def stop(message, status=2):
    print(f"docs: {message}", file=sys.stderr)
    sys.exit(status)


def copy(source, target):
    """A file, into a folder that is made."""
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(source, target)


def name_of_topics():
    """What this Doxygen calls the page of topics; versions that nobody has tried are refused."""
    version = subprocess.run(["doxygen", "--version"], check=True, capture_output=True,
                             text=True).stdout.split()[0]
    if version not in PROVED:
        known = " and ".join(f"{one} ({where})" for one, (where, _) in PROVED.items())
        stop(f"Doxygen {version} is here; the pages are made from the HTML of {known}. Take one of"
             " these, or add yours to PROVED in tools/website/docs.py and see what"
             " tools/website/check_docs.py finds")
    return PROVED[version][1]


def make_header(out):
    """Doxygen's own page header, of whatever version it is, with docs/head.html put into it."""
    header = out / "header.html"
    scrap = [str(out / name) for name in ("footer.html", "style.css")]
    subprocess.run(["doxygen", "-w", "html", str(header), *scrap], check=True,
                   capture_output=True)
    for name in scrap:
        os.remove(name)
    extra = (ROOT / "docs/head.html").read_text()
    header.write_text(header.read_text().replace("</head>", extra + "</head>"))


def copy_pictures(html, pages):
    """Pictures and programs beside the pages, named as the filter names them."""
    for page, text in pages.items():
        for name in set(re.findall(r'<img src="([\w./-]+/[\w.-]+)"', text)):
            if not (ROOT / name).is_file():
                stop(f"{page} shows {name}, which does not exist", 1)
            copy(ROOT / name, html / name)
    for figure in figures.FIGURES.glob("[0-9]*.png"):
        copy(figure, html / "plots" / figure.name)
    for program in classes.EXAMPLES:  # as text, so that a browser shows it
        copy(program, html / f"{program.name}.txt")


def short_names(pages, tags):
    """Pages and tags with short names in place of Doxygen's long ones: a tenth of their size."""
    names = {}

    def short(name):
        return names.setdefault(name[0], f"m{len(names)}")
    long = re.compile(r"\b[ag]a?[0-9a-f]{32}\b")
    pages = {page: re.sub(r"\n +(?=</?t[adrhb])", "\n", long.sub(short, text))
             for page, text in pages.items()}
    return pages, long.sub(short, tags)


def finish(html, recordings, tags):
    """What Doxygen has written becomes the site: motions, figures, links, formulas, search."""
    gallery.fill(html, recordings)
    pages = {path.name: path.read_text(encoding="utf-8") for path in sorted(html.glob("*.html"))
             if path.name != "live.html"}
    pages, tags = short_names(pages, tags.read_text(encoding="utf-8"))
    pages = {page: re.sub(r'(href="(\w+)\.html)#\2"', r'\1"', text) for page, text in pages.items()}
    copy_pictures(html, pages)
    rows = gallery.read_rows((ROOT / gallery.PAGE).read_text(encoding="utf-8"))
    for chapter in house.chapters():
        page = chapter.page_name
        pages[page] = texts.finished(pages[page], chapter, rows)
    pages = {page: texts.with_drawings(text, ROOT) for page, text in pages.items()}
    pages = {page: text if 'name="nested-classes"' in text else
             re.sub(r'<a href="#nested-classes">.*?</a> &#124;\s*', "", text)
             for page, text in pages.items()}
    pages["index.html"] = front.finished(pages["index.html"], rows, (html / "live.html").exists())
    pages = {page: re.sub(r'(?<=[(\["]) (?=\\\()', "", text) for page, text in pages.items()}
    pages["annotated.html"] = classes.list_of_types(pages["annotated.html"])
    pages = raw = classes.with_formulas(classes.with_uses(pages))
    pages = formulas.draw(pages, html)
    if (html / "live.html").exists():
        for chapter in house.chapters():
            page = chapter.page_name
            pages[page] = experiments.with_experiments(pages[page])
    else:
        pages = {page: links.without("live.html", text) for page, text in pages.items()}
    everything = "namespacejoints.html"  # in other words: all that the topics list
    pages = {page: links.without(everything, text) for page, text in pages.items()}
    targets = links.Targets(pages, tags)
    pages = {page: links.linked(text, page, targets) for page, text in pages.items()}
    pages, titles = shell.surround(pages, {path.name for path in html.glob("live.html")})
    words.write(html, raw, titles)
    for page in raw:
        (html / page).unlink()
    for page, text in pages.items():
        (html / page).write_text(text, encoding="utf-8")


def build(out, recordings):
    html = out / "html"
    if (html / "doxygen.css").exists():
        shutil.rmtree(html)  # pages of chapters that are gone
    out.mkdir(parents=True, exist_ok=True)
    topics = name_of_topics()
    (out / "layout.xml").write_text((ROOT / "docs/layout.xml").read_text()
                                    .replace('type="topics"', f'type="{topics}"'))
    make_header(out)
    # The filters of the pages are this Python itself: they start 300 times, a wrapper takes longer.
    path = f"{Path(sys.executable).parent}{os.pathsep}{os.environ.get('PATH', os.defpath)}"
    result = subprocess.run(["doxygen", "docs/Doxyfile"], cwd=ROOT, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            env={**os.environ, "WORKBOOK_DOCS_OUT": str(out), "PATH": path})
    if result.stdout.strip():
        print(result.stdout.strip().replace(f"{ROOT}/", ""), file=sys.stderr)
    if result.returncode != 0:
        stop("the site has warnings, see above", 1)
    (html / f"{topics}.html").rename(html / "topics.html")
    if (house.OUT / "live.html").exists() and not live.missing():
        live.write_page(html / "live.html", "The engine, live",
                        [("the solution", house.BUILD / "live" / "solution.wasm")],
                        parts.beside(html), note="", chapter=0,
                        back={"href": "index.html", "textContent": "the workbook"})
    finish(html, recordings, out / "tags.xml")
    return html / "index.html"


def draw_figures(chapters):
    """The figures of the chapters that have none, or older ones than their tables."""
    jobs = []
    for chapter in chapters:
        drawn = list(figures.FIGURES.glob(f"{chapter.number:02}_*.png"))
        table = show.SOLUTIONS / chapter.folder / "summary.csv"
        if not drawn or min(path.stat().st_mtime for path in drawn) < table.stat().st_mtime:
            jobs.append(figures.of_chapter(chapter, show.SOLUTIONS / chapter.folder))
    figures.FIGURES.mkdir(parents=True, exist_ok=True)
    if jobs:
        figures.draw_all(jobs)


def command():
    """./wb docs. Programs that have not run since they were built run first, for the gallery."""
    chapters = house.chapters()
    house.must_build(house.programs(), "building")
    for chapter in chapters:
        if show.stale(show.SOLUTIONS / chapter.folder, chapter.programs):
            house.progress(f"chapter {chapter.number}: running")
            show.run_solution(chapter)
    draw_figures(chapters)
    if lacking := live.missing():
        print(f"without the live page, which needs {' '.join(lacking)}: a recorded motion instead")
    else:
        live.write_page(house.OUT / "live.html", "The engine, live",
                        [("the solution", live.build() / "solution.wasm")], note="", chapter=0)
    house.progress_done()
    return main([str(house.OUT / "docs"), str(show.SOLUTIONS)])


def main(arguments):
    if not 1 <= len(arguments) <= 2 or arguments[0].startswith("-"):
        stop("usage: docs.py OUT_DIR [RECORDINGS]")
    missing = [package for package, there in (("doxygen", shutil.which("doxygen")),
                                              ("doxygen-awesome-css", THEME.exists()),
                                              ("libjs-mathjax",
                                               (formulas.MATHJAX / "MathJax.js").exists()),
                                              ("nodejs", shutil.which("node")))
               if not there]
    if missing:
        stop("missing: " + " ".join(missing)
             + "  (Debian packages: doxygen doxygen-awesome-css libjs-mathjax nodejs)")
    try:
        recordings = Path(arguments[1]) if len(arguments) > 1 else ROOT / "out" / "solutions"
        print(f"site: {build(Path(arguments[0]).resolve(), recordings)}")
    except (gallery.GalleryError, motion.MotionError, formulas.FormulaError) as error:
        stop(str(error), 1)
    except (OSError, subprocess.CalledProcessError) as error:
        stop(str(error))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
