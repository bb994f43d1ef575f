"""The words of the site's pages, for docs/search.js to look them up: search_words.js."""
import json
import re
import unicodedata
from collections import Counter
from html import unescape

NOT_READ = re.compile(r'<(script|style|svg|title|nav)\b.*?</\1>|<div class="(?:toc|tex)".*?</div>'
                      r'|<span class="tex[^"]*".*?</span>|<!--.*?-->', re.S)
PLACE = re.compile(r'<a class="anchor" id="([^"]+)"></a>\s*((?:(?!</?h\d).)*)</h\d>'
                   r'|<a id="([^"]+)"[^>]*></a>\s*<h2 class="memtitle">(.*?)</h2>', re.S)
EQUATION = re.compile(r"\\tag\{(\d+-\d+)\}")
EXERCISE = re.compile(r"\d\.\d+$")
# Too common to tell one place from another.
COMMON = set("""the a an of and or in on is are to it its that this with for by as at be not no from
    one two what which has have was were if so but than then only all each per into out
    can how do does my i me should would could use want there am are you your against""".split())
# What other engines and readers call it, and the words of the site.
SYNONYMS = {
    "actuator": "motor", "android": "course browser", "animation": "every motion",
    "animations": "every motion", "basics": "before start", "begin": "before start",
    "beginner": "before start", "bibliography": "references", "blows": "grow beta",
    "books": "references", "bounce": "restitution", "bouncy": "restitution",
    "breakpoint": "debugger", "breakpoints": "debugger", "cable": "rope", "cfm": "softness",
    "changelog": "upgrading", "checkpoint": "save restore", "chromebook": "course browser",
    "cite": "references", "clion": "other environments", "collision": "contact ground",
    "collisions": "contact ground", "coloring": "colours", "compare": "beside",
    "comparison": "beside", "compliance": "softness", "constraint": "jacobian row",
    "constraints": "rows joints", "determinism": "bit identical", "deterministic": "bit identical",
    "diverges": "grow beta", "docker": "container", "download": "install", "erp": "beta",
    "erratum": "errata", "exam": "teaching grading", "explode": "grow beta",
    "explodes": "grow beta", "gdb": "debugger", "gears": "gear", "getting": "before",
    "glossary": "notation words", "havok": "engines contacts", "help": "hints",
    "homework": "handing out teaching", "ide": "editor", "installing": "install browser",
    "ipad": "course browser", "iphone": "course browser", "jitter": "grow beta",
    "jitters": "grow beta", "know": "before start", "lcp": "bounds direct solver",
    "lecture": "lectures teaching", "license": "licence", "mac": "macos", "math": "mathematics",
    "maths": "mathematics", "max": "strength", "maximum": "strength", "mistake": "errata",
    "multithreading": "threads", "nullspace": "dependent rows", "offline": "browser network",
    "online": "course browser", "paper": "references", "papers": "references",
    "pbd": "position projection", "pgs": "sequential impulses", "phone": "course browser",
    "physx": "engines contacts", "prerequisites": "before start", "prismatic": "slider",
    "revise": "before start", "revolute": "hinge", "schur": "elimination",
    "serialize": "save restore", "servo": "motor", "setup": "install", "shaking": "grow beta",
    "simulation": "step", "slow": "time goes", "socket": "ball", "soft": "softness",
    "sor": "over relaxation",
    "spherical": "ball", "spring": "softness", "stability": "far method holds",
    "start": "before start", "started": "before start", "stiff": "softness", "stuck": "hints",
    "student": "teaching", "students": "teaching", "symbol": "notation letters",
    "symbols": "notation letters", "tablet": "course browser", "take": "hours",
    "teacher": "teaching", "telephone": "course browser", "thread": "threads", "timestep": "step",
    "torn": "drift", "units": "conventions", "unity": "engines contacts",
    "unreal": "engines contacts", "unstable": "far method holds", "vectorized": "simd lanes",
    "video": "every motion", "videos": "every motion", "vim": "any editor", "vs": "visual studio",
    "vscode": "visual studio code", "weld": "fixed", "wsl": "windows", "xpbd": "substeps softness"}
# What the words of a page weigh, the first name that it has; by this a text and a heading are
# weighed.
WEIGHTS = ((r"^docs_library", 4), (r"_README|which_method", 3), (r"chapter\d_1_1", 0.3),
           (r"errata|thesis|references|gallery|teaching|CONTRIBUTING|^group|^annotated"
            r"|topics|^concept", 1),
           ("", 2))
LESS = ("Further reading", "A printed formula that is wrong: find it")  # half of that
TEXT, HEADING, TERM = 10, 12, 9
TEXTS = re.compile("chapters_.*README|docs_")  # which explain their terms where these are bold


def words_of(html):
    text = unescape(re.sub(r"<[^>]+>", " ", html))
    plain = unicodedata.normalize("NFKD", text.lower())
    return [word for word in re.findall(r"[a-z0-9_]{2,}", plain)
            if word not in COMMON and not re.fullmatch(r"\d+", word)]


def words_of_heading(heading):
    """Its words, the parts of a name that is written together, and a number with a point."""
    parts = re.sub(r"([a-z])([A-Z])", r"\1 \2", heading)
    return {*words_of(heading), *words_of(parts), *re.findall(r"\d[.-]\d+", heading)}


def plain(html):
    return " ".join(unescape(re.sub(r"<[^>]+>", "", NOT_READ.sub("", html))).replace("◆", "")
                    .split())


def sections(text):
    """(place, heading, html) of a page's beginning and of each of its headings."""
    body = text[text.index('<div class="contents">'):] if '<div class="contents">' in text else ""
    body = NOT_READ.sub(" ", body)
    at, place, heading = 0, "", ""
    for found in PLACE.finditer(body):
        yield place, heading, body[at:found.start()]
        at, place, heading = found.end(), found[1] or found[3], plain(found[2] or found[4])
    yield place, heading, body[at:]


def weight_of(page):
    """What a page's words weigh: texts for readers come before remarks and members of types."""
    return next(weight for name, weight in WEIGHTS if re.search(name, page))


def index_of(texts, titles):
    """What search_words.js says. `texts` and `titles`: of each page, by its file's name."""
    pages, places, words, last = list(titles), [], {}, {}

    def add(page, place, heading, weights):
        here = len(places)
        for word, weight in weights.items():
            words.setdefault(word, []).extend((here - last.get(word, 0), weight))
            last[word] = here
        places.append([pages.index(page), re.sub(f"^{re.escape(page[:-5])}-", "-", place),
                       heading])

    for page, title in titles.items():
        if page.startswith("namespace"):
            continue  # it names everything
        for place, heading, html in sections(texts[page]):
            weight = weight_of(page) / (2 if heading in LESS else 1)
            if heading == f"{title}()":
                continue  # a constructor stands beside its type
            count = Counter(words_of(html))
            # A word is worth less where there are many, and hardly more when it comes again.
            long = 1 + sum(count.values()) / 300
            weights = {word: max(1, round(weight * TEXT * times / (times + 2 * long)))
                       for word, times in count.items()}
            if page.endswith("_hints.html") and EXERCISE.match(heading):
                heading = f"Exercise {heading}"
            terms = re.findall(r"<b>([^<.,:]{3,30})</b>", html) if TEXTS.match(page) else []
            for words_, worth in (words_of_heading(heading or title), HEADING), (
                    set(words_of(" ".join(terms))), TERM):
                for word in words_:
                    weights[word] = weights.get(word, 0) + max(1, round(worth * weight))
            if weights:
                add(page, place, heading, weights)
        for number in EQUATION.findall(texts[page]):
            add(page, f"eq-{number}", f"Eq. {number}", {number: 50, "eq": 1, "equation": 1})
    return {"pages": [[page, titles[page]] for page in pages], "places": places, "words": words,
            "common": sorted(COMMON), "synonyms": SYNONYMS}


def write(html, texts, titles):
    data = json.dumps(index_of(texts, titles), separators=(",", ":"), ensure_ascii=False)
    (html / "search_words.js").write_text(f"search_words({data})\n", encoding="utf-8")
