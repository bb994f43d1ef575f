"""What axe-core finds on the pages of the site: nothing serious. The package is fetched from npm
once, pinned by its hash, and only for this check."""
import re
import shutil
from datetime import date

from course import parts

AXE = {"version": "4.14.1", "take": "axe.min.js", "integrity":
       "sha512-FHfa+lmNjQZfJz1q8wKqIDwC6DExcHt/pkjNQb09a3NPjCKg2rhu5qb2S4r76ASyFNNtuFooJpZe37OgudVG"
       "tQ=="}
REFERENCE = re.compile("(class|struct|group_|namespace|concept)")
# check_docs.py computes contrasts itself, in light and dark.
LOOK = """(async () => {
  for (const fold of document.querySelectorAll("details")) fold.open = true;
  await new Promise((onload, onerror) => document.head.append(Object.assign(
    document.createElement("script"), {src: "ADDRESS", onload, onerror})));
  const {violations} = await axe.run({include: [["html"]], exclude: [["iframe"]]},
    {resultTypes: ["violations"], iframes: false, rules: {"color-contrast": {enabled: false}}});
  return violations.filter(one => ["serious", "critical"].includes(one.impact))
    .map(one => `${one.id} (${one.nodes.length}): ${one.nodes[0].html.slice(0, 120)}`).join("; ");
})()"""


def lacking():
    """What is lacking for the check, in words; "" where nothing is."""
    return "" if shutil.which("npm") else "no npm here (Debian package: npm)"


def of_today(pages):
    """All pages of texts, and of the reference, which are made alike, another eighth each day:
    {page: whether in a wide window}, which another one of each kind is."""
    day = date.today().toordinal()
    chosen = [page for k, page in enumerate(pages) if page.exists() and
              (not REFERENCE.match(page.name) or (k + day) % 8 == 0)]
    wide = {re.match("[a-z]*", page.name)[0]: page for page in
            chosen[day % len(chosen):] + chosen[:day % len(chosen)]}
    return {page: page in wide.values() for page in chosen}


def serious(here):
    """What is serious on the page that a browser shows, in words."""
    return here.ask(LOOK.replace("ADDRESS", parts.package("axe-core", AXE).as_uri()))
