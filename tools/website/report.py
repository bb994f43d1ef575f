"""The page that ./wb tour ends with: out/index.html, all that was computed, drawn and recorded."""
import csv
import re
import statistics
import time
from html import escape
from pathlib import Path

from base import house
from learn import show
from pictures import figures, pages, poster
from website import gallery

TEMPLATE = house.ROOT / "docs" / "report.html"
FIRST = ("08_ground", "ragdoll")  # the motion on top of the page
BENCH = {"work_precision": "Error against run time", "stability": "What holds, and up to where"}
STABILITY_NOTE = ("Which method still holds a stiff, extreme or redundant scene is not part of a "
                  "tour: <code>./wb bench --stability</code> measures it in some minutes, and the "
                  "next tour shows its maps here.")
HEADINGS = ("scene", "setting", "time per step [µs]", "gap, root mean square [mm]",
            "largest gap [mm]", "drift of the energy")


def summary(chapter):
    """The rows of the table that a chapter's program has written."""
    with open(show.SOLUTIONS / chapter.folder / "summary.csv", newline="") as file:
        return list(csv.DictReader(file))


def mentioned(text):
    """What a chapter's text calls its figures: {03_door: the door}."""
    return {name: words.lower() for words, name in
            re.findall(r"\*\*([^*]+?)\.?\*\*\s+\((\d\d_\w+)", text)}


def caption(stem, names):
    words = names.get(stem) or re.sub(r"^\d+_", "", stem).replace("_", " ")
    return f"<figcaption>{escape(words[:1].upper() + words[1:])}</figcaption>"


def figure_grid(paths, names=None):
    """Drawn figures, as seen from out/."""
    cells = "".join(
        f'<figure><a href="{path.relative_to(house.OUT)}">'
        f'<img loading="lazy" src="{path.relative_to(house.OUT)}" alt="{path.stem}"></a>'
        f"{caption(path.stem, names or {})}</figure>" for path in paths)
    return f'<div class="grid wide">{cells}</div>' if cells else ""


def table(rows):
    cells = [(row["scene"], row["setting"], f"{float(row['us_per_step']):.2f}",
              f"{1000 * float(row['gap_rms_m']):.3g}", f"{1000 * float(row['gap_max_m']):.3g}",
              f"{float(row['energy_drift']):.2g}") for row in rows]
    head = "".join(f"<th>{word}</th>" for word in HEADINGS)
    return (f'<div class="table"><table><tr>{head}</tr>' + "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in cells)
        + "</table></div>")


def chapter_part(chapter, rows):
    """A chapter: its motions, its figures, its table. `rows` are those of the gallery."""
    title = f"Chapter {chapter.number}: {chapter.name}"
    cards = "".join(gallery.card(row, gallery.inline(row, show.SOLUTIONS), "see") for row in rows
                    if row.folder == chapter.folder)
    drawn = sorted(figures.FIGURES.glob(f"{chapter.number:02}_*.png"))
    return (f'<h2 id="chapter{chapter.number}">{title}</h2><div class="grid">{cards}</div>'
            + figure_grid(drawn, mentioned(chapter.text.read_text(encoding="utf-8")))
            + table(summary(chapter)))


def bench_parts(chapters):
    """Figures that belong to no chapter, with what they are."""
    of_chapters = {f"{chapter.number:02}" for chapter in chapters}
    for name, title in BENCH.items():
        drawn = sorted(path for path in figures.FIGURES.glob(f"{name}*.png")
                       if path.name[:2] not in of_chapters)
        if drawn:
            yield f'<h2 id="{name}">{title}</h2>' + figure_grid(drawn)
        elif name == "stability":
            yield f'<h2 id="{name}">{title}</h2><p>{STABILITY_NOTE}</p>'


def sentences(chapters):
    """What was computed, in three sentences."""
    rows = [row for chapter in chapters for row in summary(chapter)]
    gaps = [1000 * float(row["gap_rms_m"]) for row in rows]
    costs = [float(row["us_per_step"]) for row in rows]
    recorded = len(list(show.SOLUTIONS.glob("*/*.motion.json")))
    return (f"The programs of {len(chapters)} chapters have simulated {len(rows)} scenes and "
            f"settings with the joints that the solutions build, and recorded {recorded} of them. "
            f"In half of the {len(rows)} the joints are less than {statistics.median(gaps):.2g} mm "
            "apart (root mean square over the run); the tables below say where it is more, and the "
            f"chapters why. Half of the steps take less than {statistics.median(costs):.2g} µs.")


def machine():
    """The processor and the compiler, as far as they can be known."""
    info = Path("/proc/cpuinfo")
    model = re.search(r"model name\s*: (.+)", info.read_text()) if info.exists() else None
    cache = (house.BUILD / "CMakeCache.txt").read_text()
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$", cache, re.M)
    return " · ".join([model[1] if model else "an unknown processor",
                       Path(compiler[1]).name if compiler else "an unknown compiler"])


def write(chapters, seconds):
    """Writes out/index.html; `seconds` of processor time were used."""
    rows = gallery.read_rows((house.ROOT / gallery.PAGE).read_text(encoding="utf-8"))
    links = "".join(f'<a href="#chapter{c.number}">{c.number} {c.name}</a>' for c in chapters)
    body = f"""<h1>The Joint Workbook: all that was computed</h1>
<p>{sentences(chapters)}</p>
<iframe src="see/{FIRST[0]}.html?scene={FIRST[1]}&amp;play=1" title="A ragdoll falls"></iframe>
<nav>{links}{"".join(f'<a href="#{name}">{title}</a>' for name, title in BENCH.items())}</nav>
<p>A picture of a motion plays it; a figure opens in full. <b>Gap</b>: how far joints are apart.
<b>Drift</b>: change of energy over the run, as a share of the energy to hand. Ropes that become
taut and limits that stop a body take some, as in nature, motors add their work, and what sags has
come to rest lower; what is lost else, the method loses.</p>
{"".join(chapter_part(chapter, rows) for chapter in chapters)}
{"".join(bench_parts(chapters))}
<h2 id="how">How this was measured</h2>
<p>{time.strftime("%d %B %Y, %H:%M")}, {machine()}. Times per step are of one run each, on one
core, beside whatever else the machine did: good to about a tenth. Processor time of the tour,
with what had to be built: {seconds:.0f} s. All numbers are from <code>out/solutions/</code>.</p>
<p>Your turn: <code>./wb</code> leads you to the first exercise. The texts stand in
<code>chapters/</code>, and <code>./wb docs</code> makes a site of them.</p>
{poster.BALLS}"""
    page = house.OUT / "index.html"
    page.write_text(pages.whole(TEMPLATE).replace("BODY", body, 1), encoding="utf-8")
    return page
