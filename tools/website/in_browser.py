"""The part of check_docs.py that needs a browser, which opens each page once."""
import json
import os
import re
from concurrent.futures import ThreadPoolExecutor
from urllib.parse import quote_plus

from website import accessible, browser

TELEPHONE = 390  # [pixels]
CONTRAST = 4.5   # of words, at least: what the WCAG ask for
# What is asked, and the page that must be among the first three found.
SEARCHES = {
    "warmstart": "chapters_06", "XPBD": "docs_next_door", "breakable": "chapters_05",
    "1.4": "chapters_01_distance_hints.html#chapters_01_distance_hints-14",
    "Eq. 3-4": "chapters_03_hinge_README.html#eq-3-4", "max torque units": "docs_library",
    "how to add a hinge": "docs_library.html#docs_library-a-program", "baumgarte": "chapters_06",
    "effective mass": "chapters_01", "quaternion": "docs_before_you_start",
    "swing twist": "chapters_03", "piston": "chapters_04", "cantilever": "chapters_05",
    "roofline": "chapters_07", "restitution": "chapters_08", "bricard": "chapters_09",
    "erratum": "docs_errata", "friction": "chapters_08", "debugger": "docs_editor",
    "units": "docs_notation", "prismatic joint": "SliderJoint.html", "E5": "docs_errata-e5-",
    "mass ratio": "docs_which_method", "save state": "docs_library-save", "install": "docs_library",
    "hinge motor": "chapters_03", "explodes": "chapters_06", "HingeJoint": "HingeJoint.html",
    "how many iterations": "docs_which_method-how-many", "graph coloring": "chapters_07",
    "exercise 2.3": "chapters_02_ball_hints", "my chain stretches": "chapters_02",
    "why does my joint drift": "README-joints-drift", "getting started": "docs_before_you_start",
    "gauss seidel": "chapters_02", "angle limit": "chapters_03", "gear ratio": "chapters_10",
    "inertia tensor": "docs_before_you_start", "lagrange multiplier": "chapters_01",
    "time step too large": "README-beta-is-a-fraction", "box stacking": "which_method-stacks",
    "conservation of energy": "the-cost-energy", "is it deterministic": "docs_library-save",
    "how long does the course take": "index.html", "what is a jacobian": "chapters_01",
    "spring stiffness": "docs_library-springs", "install on windows": "docs_browser",
    "license": "docs_browser", "thread safe": "docs_library-what-you-may",
    "solver comparison": "beside-the-published-engines", "constraint": "chapters_01",
    "schur complement": "chapters_09", "changelog": "docs_upgrading",
    # In the words of somebody who has just come.
    "stability": "docs_which_method-how-far",
    "error against run time": "docs_which_method-error-against",
    "how do I start": "docs_before_you_start", "ipad": "docs_browser",
    "does it work on a tablet": "docs_browser", "on my phone": "docs_browser",
    "chromebook": "docs_browser", "without installing": "docs_browser",
    "what do I need to know": "docs_before_you_start", "prerequisites": "docs_before_you_start",
    "basics": "docs_before_you_start", "torque": "docs_before_you_start",
    "moment of inertia": "docs_before_you_start", "vscode": "docs_editor",
    "breakpoint": "docs_editor", "use my own editor": "docs_editor", "clion": "docs_editor",
    "I am stuck": "hints", "help": "hints", "homework": "docs_teaching",
    "for students": "docs_teaching", "exam": "docs_teaching", "lecture plan": "docs_teaching",
    "unity": "docs_next_door", "box2d": "docs_next_door", "jolt": "docs_next_door",
    "mujoco": "docs_next_door", "compare with bullet": "docs_measurements",
    "symbols": "docs_notation", "glossary": "docs_notation", "videos": "docs_gallery",
    "animation": "docs_gallery", "ragdoll": "chapters_05", "rope": "chapters_01",
    "motor too weak": "chapters_04", "my simulation blows up": "chapters_06",
    "it jitters": "chapters_06", "joint is too soft": "chapters_06", "featherstone": "chapters_11",
    "gears": "chapters_10", "which solver should I use": "docs_library-which-solver",
    "papers": "docs_references", "knee": "chapters_03", "why is it slow": "chapters_07",
    "how fast is it": "chapters_07", "cone limit": "chapters_10", "wheels": "chapters_08",
    "crane": "chapters_0", "substeps": "docs_next_door-substeps"}
# All that is asked of a page at the width of a telephone: how wide it is, which listings stand
# outside the text, which words can hardly be read, and which parts paper would leave out.
LOOK = """(() => {
  const root = document.documentElement, wide = root.scrollWidth, wrong = [];
  const style = element => getComputedStyle(element);
  for (const fold of document.querySelectorAll("details")) fold.open = true;
  for (const block of document.querySelectorAll("div.textblock .fragment"))
    if (block.getBoundingClientRect().left
        < block.closest("div.textblock").getBoundingClientRect().left - 1)
      wrong.push("a listing left of the text");
  const rgba = words => words.startsWith("rgb") ? words.match(/[\\d.]+/g).map(Number) : null;
  const light = ([r, g, b]) => [r, g, b].map(c => c / 255).map(
    c => c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
    .reduce((sum, c, k) => sum + c * [0.2126, 0.7152, 0.0722][k], 0);
  const over = (top, a, below) => below.map((c, k) => a * top[k] + (1 - a) * c);
  const contrast = theme => {
    const paper = new Map();
    const paper_of = element => {  // null where it is a picture
      if (!element) return [255, 255, 255];
      if (!paper.has(element)) {
        const one = style(element), colour = rgba(one.backgroundColor), a = colour?.[3] ?? 1;
        const below = a < 1 ? paper_of(element.parentElement) : colour;
        paper.set(element, one.backgroundImage !== "none" || !colour ? null
          : below && over(colour.slice(0, 3), a, below.slice(0, 3)));
      }
      return paper.get(element);
    };
    const texts = document.createTreeWalker(document.body, 4), seen = new Map();
    while (texts.nextNode()) {
      const element = texts.currentNode.parentElement;
      if (!texts.currentNode.data.trim() || element.closest("svg, script, style, iframe")) continue;
      const ink = rgba(style(element).color), below = paper_of(element);
      const to_see = {visibilityProperty: true, opacityProperty: true};
      if (!ink || !below || !element.checkVisibility(to_see)) continue;
      const [low, high] = [over(ink, ink[3] ?? 1, below), below].map(light).sort((a, b) => a - b);
      const found = (high + 0.05) / (low + 0.05);
      if (found < LEAST) seen.set(`${element.tagName}.${element.className}`,
        `${found.toFixed(1)} ${theme}: ${texts.currentNode.data.trim().slice(0, 30)}`);
    }
    for (const [element, words] of seen) wrong.push(`${element}, contrast ${words}`);
  };
  const top = document.getElementById("top"), text = document.getElementById("doc-content");
  root.classList.remove("dark-mode");
  root.classList.add("light-mode");
  contrast("light");
  root.classList.replace("light-mode", "dark-mode");
  contrast("dark");
  dispatchEvent(new Event("beforeprint"));
  if (text && root.classList.contains("dark-mode")) wrong.push("paper would be dark");
  for (const sheet of document.styleSheets)
    for (const rule of sheet.cssRules)
      if (rule.media?.mediaText === "print") rule.media.mediaText = "all";
  if (text && (style(top).display !== "none" || style(text).overflowY !== "visible"))
    wrong.push("paper would show the list of pages, or one screen of the text");
  return {wide, wrong: wrong.slice(0, 4).join("; ")};
})()""".replace("LEAST", str(CONTRAST))
LETTERS = """(all => (all.length ? all.filter(
  one => !(parseInt(one.style.getPropertyValue('--wide')) > 0 &&
           one.firstChild.offsetWidth >= parseInt(one.style.getPropertyValue('--wide')))).length
  : "no") + ' of ' + all.length)([...document.querySelectorAll('.drawing')])"""
PLAYS = """document.querySelector('canvas').getAttribute('aria-label')
  + document.getElementById('frame').textContent
  + (document.querySelector('figure output').value.includes('gap') ? '' : ', no readings')"""
LOADED = "performance.timing.loadEventEnd > 0"


def chapters_of(sources):
    return {page: html for page, html in sources.items()
            if re.fullmatch(r"chapters_\w+_README.html", page.name)}


def scenes_of(page):
    """The motions of a playing page, by name: title and what to watch; and its link back."""
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>',
                      page.read_text(encoding="utf-8"), re.S)
    data = json.loads(found[1]) if found else {"scenes": []}
    return {scene["name"]: scene for scene in data["scenes"]}, data.get("back")


def bad_motions(here, scenes):
    """Motions that do not play on their page, which shows frame 1 of the last of them."""
    found = here.ask(f"[{PLAYS}, ...[...document.getElementById('scenes').children].map(tab => {{"
                     f" tab.click(); go_to(scene.step); show(); return {PLAYS}; }})]")
    for name, said in zip([[*scenes][-1], *scenes], found, strict=True):
        if said != f"{scenes[name]['title']}, the solution: a picture that movesframe 1":
            yield f"does not play {name}: {said}"


def bad_searches(here, site):
    """Questions that do not find their page; the first one stands in the address."""
    look = ("[...document.querySelectorAll('#found a')].slice(0, 3)"
            ".map(a => a.getAttribute('href')).join(' ')")
    for k, (words, wanted) in enumerate(SEARCHES.items()):
        if k:
            here.type("#search", words)
        else:
            here.open(f"{(site / 'index.html').as_uri()}?search={quote_plus(words)}", ready=look)
        if wanted not in (found := here.ask(look)):
            yield f"searching for {words} does not find {wanted} first but {found}"


def bad_page(here, page, sources, wide):
    """What is wrong with a page; `wide` as accessible.of_today() has it, or None."""
    scenes = scenes_of(page)[0] if page.parent.name == "motion" else {}
    query = f"?scene={[*scenes][-1]}&f=1" if scenes else ""
    here.open(page.as_uri() + query, TELEPHONE, 800, still=True, ready=LOADED)
    if scenes:
        yield from bad_motions(here, scenes)
    if page in chapters_of(sources) and not (small := here.ask(LETTERS)).startswith("0 of "):
        yield f"{small} drawings too small for their letters"
    if wide is not None:
        here.dress(1280 if wide else TELEPHONE, 800, still=True)
        if found := accessible.serious(here):
            yield f"axe-core: {found}"
        here.dress(TELEPHONE, 800, still=True)
    seen = here.ask(LOOK)
    if seen["wide"] > TELEPHONE:
        yield f"{seen['wide']} pixels wide in {TELEPHONE}"
    if seen["wrong"]:
        yield seen["wrong"]


def bad_in_browser(site, sources, pages, checked):
    """What is wrong with what only a browser can tell; a browser for each processor."""
    count = os.cpu_count() or 1

    def look(k):
        with browser.Browser() as here:
            found = [f"{page.name}: {words}" for page in pages[k::count]
                     for words in bad_page(here, page, sources, checked.get(page))]
            return found + ([] if k else list(bad_searches(here, site)))
    with ThreadPoolExecutor(count) as pool:
        return [line for found in pool.map(look, range(count)) for line in found]
