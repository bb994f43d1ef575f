"""The page that ./wb tour ends with: out/index.html, all that was computed, drawn and recorded."""
import re
import time
from html import escape
from pathlib import Path

from base import house
from bench.measuring import read
from learn import show
from pictures import figures, pages, poster
from website import gallery

TEMPLATE = house.ROOT / "docs" / "report.html"
FIRST = ("08_ground", "ragdoll")  # the motion behind the findings
BENCH = {"work_precision": "Error against run time", "stability": "What holds, and up to where"}
ROUNDING = 1e-9  # [m], and as a fraction of the energy: smaller numbers are shown as 0
FAILED = 0.1  # [m]: joints that are so far apart do not hold
# The settings that their chapters show in order to let them fail: (scene, setting).
MEANT = {("pendulums", "beta 0"), ("drift", "beta 0"), ("side by side", "projection, 30"),
         ("whips", "colours"), ("drift", "gravity"), ("drift", "collision"),
         ("drift", "contact last"), ("Bricard", "neither")}
HEADINGS = ("scene", "setting", "time per step [µs]", "gap, root mean square [mm]",
            "largest gap [mm]", "drift of the energy")


def summary(chapter):
    """The rows of the tables that a chapter's programs have written."""
    folder = show.SOLUTIONS / chapter.folder
    return [row for path in (folder / "summary.csv", folder / "experiments" / "summary.csv")
            if path.is_file() for row in read(path)]


def figure_grid(paths):
    """Drawn figures, as seen from out/, each with a sentence on its content."""
    cells = "".join(
        f'<figure><a href="{path.relative_to(house.OUT)}">'
        f'<img loading="lazy" src="{path.relative_to(house.OUT)}" '
        f'alt="{escape(figures.title_of(path), quote=True)}"></a>'
        f"<figcaption>{escape(figures.title_of(path))}.</figcaption></figure>" for path in paths)
    return f'<div class="grid wide">{cells}</div>' if cells else ""


def failure(row):
    """What there is to say of a setting whose joints do not hold, or nothing."""
    if float(row["gap_rms_m"]) < FAILED:
        return ""
    return "meant to fail" if (row["scene"], row["setting"]) in MEANT else "fails"


def digits(value, unit, count):
    """A number in a unit; 0 where it is below rounding."""
    return "0" if abs(value) < ROUNDING else f"{value / unit:.{count}g}"


def table(rows):
    """A chapter's rows, folded; what fails says so, and whether it is meant to."""
    def cells(row):
        note = f" <b>{failure(row)}</b>" if failure(row) else ""
        return (escape(row["scene"]), escape(row["setting"]) + note,
                f"{float(row['us_per_step']):.2f}", digits(float(row["gap_rms_m"]), 1e-3, 3),
                digits(float(row["gap_max_m"]), 1e-3, 3), digits(float(row["energy_drift"]), 1, 2))
    head = "".join(f"<th>{word}</th>" for word in HEADINGS)
    return (f"<details><summary>{len(rows)} scenes and settings in numbers</summary>"
            f'<div class="table" tabindex="0"><table><tr>{head}</tr>' + "".join(
                "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells(row)) + "</tr>"
                for row in rows) + "</table></div></details>")


def chapter_part(chapter, rows):
    """A chapter: its motions, its figures, its table. `rows` are those of the gallery."""
    title = f"Chapter {chapter.number}: {chapter.name}"
    cards = "".join(gallery.card(row, gallery.inline(row, show.SOLUTIONS), "see") for row in rows
                    if row.folder == chapter.folder)
    drawn = sorted(figures.FIGURES.glob(f"{chapter.number:02}_*.png"))
    return (f'<h2 id="chapter{chapter.number}">{title}</h2><div class="grid">{cards}</div>'
            + figure_grid(drawn) + table(summary(chapter)))


def of_bench(name):
    """The figures of a benchmark that have been drawn."""
    return sorted(figures.FIGURES.glob(f"{name}*.png"))


def bench_parts():
    """Figures that belong to no chapter; none where nothing was measured."""
    return "".join(f'<h2 id="{name}">{title}</h2>' + figure_grid(of_bench(name))
                   for name, title in BENCH.items() if of_bench(name))


def measured(scene, solver, setting):
    """The rows of a method in the table of error against run time, by their iterations."""
    return sorted((row for row in read(figures.TABLE) if row["real"] == "double" and (
        row["scene"], row["solver"], row["setting"]) == (scene, solver, setting)),
        key=lambda row: int(row["iterations"]))


def length(metres):
    """A length as one says it."""
    for unit, words in ((1, "m"), (1e-3, "mm"), (1e-6, "µm")):
        if metres >= 0.1 * unit:
            return f"{metres / unit:.2g} {words}"
    return "less than a tenth of a micrometre"


def exact_or_iterated():
    """The cost of an exact solve beside iterations, and the errors of both: measured."""
    few, *_, many = measured("S1b", "sequential impulses", "cold")
    exact = measured("S1b", "direct", "velocities")[0]
    time, gap = (float(exact[name]) for name in ("us_per_step", "gap_rms_m"))
    beside = [float(row["us_per_step"]) / time for row in (few, many)]
    cost = (f"less than {few['iterations']} plain iterations" if beside[0] > 1 else
            f"{1 / beside[0]:.2g} times as much as {few['iterations']} plain iterations")
    return (f"An exact solve costs {cost}",
            f"Chains of a hundred cubes: {few['iterations']} iterations take {beside[0]:.2g} times "
            f"as long as the exact solve and leave gaps of {length(float(few['gap_rms_m']))}; "
            f"{many['iterations']} take {beside[1]:.2g} times as long and leave "
            f"{length(float(many['gap_rms_m']))}. The exact solve leaves {length(gap)}. In the "
            "figure, cold: each step begins without the impulses of the one before. SHAKE: poses "
            "are corrected, too. Runge-Kutta: a step of fourth order. Front: the settings that "
            "nothing beats both in time and in error (chapter 9).")


# Of the table that a tour ends with: a method in plain words, and the chapter that explains it.
PLAIN = {"cold": ("{} iterations", 2), "velocities": ("exact solve of the velocities", 9),
         "SHAKE": ("the same, poses corrected (SHAKE)", 9),
         "Runge-Kutta": ("exact, fourth order (Runge-Kutta)", 9)}


def six_lines():
    """The methods on ten chains of a hundred cubes, for a terminal: error, time, where to look."""
    yield f"{'ten chains of 100 cubes':<36}{'gap':>14}{'a step':>10}   look at"
    for row in read(figures.TABLE):
        if row["scene"] == "S1b" and row["setting"] in PLAIN and row["real"] == "double":
            words, chapter = PLAIN[row["setting"]]
            gap = float(row["gap_rms_m"])
            yield (f"{words.format(row['iterations']):<36}"
                   f"{length(gap) if gap >= 1e-7 else 'below 0.1 µm':>14}"
                   f"{float(row['us_per_step']) / 1000:>7.2f} ms   chapter {chapter}")


# The findings on top: a figure of out/plots/ and its finding; without one, the words above the
# figure.
FINDINGS = (("work_precision_S1b_double", exact_or_iterated),
            ("09_together", lambda: ("Under sideways load a chain of 100 hinges needs exact solves",
                                     "")),
            ("06_beta", lambda: ("Correcting more than twice the error makes it grow", "")))


def findings():
    """Three findings, each with its picture: error against run time first."""
    shown = ""
    for stem, words in FINDINGS:
        path = figures.FIGURES / f"{stem}.png"
        if path.exists():
            title, more = words()
            more = more or figures.title_of(path) + "."
            shown += (f"<section><h2>{escape(title)}</h2><p>{escape(more)}</p>"
                      f'<a href="{path.relative_to(house.OUT)}">'
                      f'<img src="{path.relative_to(house.OUT)}" '
                      f'alt="{escape(figures.title_of(path), quote=True)}"></a></section>')
    return f'<div id="findings">{shown}</div>'


def sentences(chapters):
    """What was computed, in two sentences."""
    rows = [row for chapter in chapters for row in summary(chapter)]
    failures = [failure(row) for row in rows if failure(row)]
    other = len(failures) - failures.count("meant to fail")
    recorded = len(list(show.SOLUTIONS.glob("*/*.motion.json")))
    return (f"The programs of {len(chapters)} chapters have simulated {len(rows)} scenes and "
            f"settings with the joints that the solutions build, and recorded {recorded} of them. "
            f"{len(failures) - other} are meant to fail, since their chapters show by them what "
            f"goes wrong; {other or 'no'} other fails.")


def machine():
    """The processor and the compiler, as far as they can be known."""
    info = Path("/proc/cpuinfo")
    model = re.search(r"model name\s*: (.+)", info.read_text()) if info.exists() else None
    cache = (house.BUILD / "CMakeCache.txt").read_text()
    compiler = re.search(r"^CMAKE_CXX_COMPILER:\w+=(.+)$", cache, re.M)
    return " · ".join([model[1] if model else "an unknown processor",
                       Path(compiler[1]).name if compiler else "an unknown compiler"])


def write(chapters, seconds, waited):
    """Writes out/index.html; `seconds` of processor time were used, `waited` on the clock."""
    rows = gallery.read_rows((house.ROOT / gallery.PAGE).read_text(encoding="utf-8"))
    links = "".join(f'<a href="#chapter{c.number}">{c.number} {c.name}</a>' for c in chapters)
    links += "".join(f'<a href="#{name}">{title}</a>' for name, title in BENCH.items()
                     if of_bench(name))
    body = f"""<h1>The Joint Workbook: what was computed</h1>
<p class="how">{time.strftime("%d %B %Y, %H:%M")}, {machine()}: {waited:.0f} s on the clock,
{seconds:.0f} s of processor time, which include building the programs.</p>
<p>Joints hold bodies together. An engine moves the bodies in small steps, and in each step it
computes the impulses that keep the joints closed: <b>iterations</b> go from joint to joint and come
nearer each time; an <b>exact solve</b> finds all impulses at once. What is left open is the
<b>gap</b>. Three findings:</p>
{findings()}
<h2>All of it</h2>
<p>{sentences(chapters)}</p>
<iframe src="see/{FIRST[0]}.html?scene={FIRST[1]}&amp;play=1" title="A ragdoll falls"></iframe>
<nav aria-label="Chapters">{links}</nav>
<p>A picture of a motion plays it; a figure opens in full. <b>Gap</b>: how far joints are apart.
<b>Drift</b>: change of energy over the run, as a fraction of a reference energy of the scene, about
that of its fall, which its program states. As in nature,
ropes that become taut and limits that stop a body take some, motors add their work, and a beam that
sags comes to rest lower. The method loses the rest. A setting <b>fails</b> if its joints are
more than {1000 * FAILED:.0f} mm apart (root mean square). 0 is less than rounding,
{ROUNDING:.0e} m.</p>
{"".join(chapter_part(chapter, rows) for chapter in chapters)}
{bench_parts()}
<h2 id="how">How this was measured</h2>
<p>Times per step are of one run each, on one core, beside whatever else the machine did: good to
about a tenth. All numbers are from <code>out/solutions/</code>. Which method still holds a stiff,
extreme or redundant scene is not part of a tour: <code>./wb bench --stability</code> measures it
in some minutes, and the next tour shows its maps here.</p>
<p>Your turn: <code>./wb</code> leads you to the first exercise. The texts stand in
<code>chapters/</code>, and <code>./wb docs</code> makes a site of them.</p>
{poster.BALLS}"""
    page = house.OUT / "index.html"
    page.write_text(pages.whole(TEMPLATE).replace("BODY", body, 1), encoding="utf-8")
    return page
