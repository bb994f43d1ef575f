"""What surrounds a page of the site: the bar with search, the list of pages, the way on."""
import re
from html import escape, unescape

from base import house

# The list of pages, in its order; chapters stand behind "Before you start".
BEFORE = ["index.html", "docs_before_you_start.html"]
AFTER = ["docs_gallery.html", "docs_notation.html", "docs_errata.html",
         "docs_thesis.html", "docs_references.html", "docs_which_method.html",
         "docs_measurements.html", "docs_next_door.html", "docs_library.html",
         "docs_editor.html", "docs_browser.html", "docs_teaching.html", "docs_architecture.html"]
CODE = [("topics.html", "The code, by topic"), ("annotated.html", "All types")]
SKIP = '<a id="skip" href="#doc-content">Skip to the text</a>'
BAR = """<a id="home" href="index.html">The Joint Workbook</a>
<div id="MSearchBox"><input id="search" type="search" placeholder="Search"
  aria-label="Search" autocomplete="off" data-words="search_words.js"><ol id="found" hidden></ol>
</div>
<input id="menu-open" type="checkbox" aria-label="Show the list of pages">
<label for="menu-open">Chapters and pages</label>
"""


def chapter_pages(chapter):
    """A chapter's own pages beside its text: (file, words)."""
    return [(f"chapters_{chapter.folder}_hints.html", "Exercises and hints"),
            (f"solutions_{chapter.folder}_answers.html", "Answers"),
            (f"group__chapter{chapter.number}.html", "Its code"),
            (f"motion/{chapter.folder}.html", "Its motions")]


def entry(page, words, here, more=""):
    mark = ' aria-current="page"' if page == here else ""
    return f'<li><a href="{page}"{mark}>{escape(words)}</a>{more}</li>'


def page_list(here, titles, chapters, texts):
    """The list of all pages, as seen from one of them."""
    rows = [entry(page, titles[page], here) for page in BEFORE]
    for chapter in chapters:
        own = chapter_pages(chapter)
        inside = here == chapter.page_name or here in [page for page, _ in own]
        more = "<ul>" + "".join(entry(*one, here) for one in own) + "</ul>" if inside else ""
        rows.append(entry(chapter.page_name, titles[chapter.page_name], here, more))
    rows += [entry(page, titles[page], here) for page in AFTER]
    if "live.html" in texts:
        rows.append(entry("live.html", "The engine, live", here))
    rows += [entry(page, words, here) for page, words in CODE]
    return f'<nav id="pages" aria-label="All pages"><ul>{"".join(rows)}</ul></nav>'


def way_on(here, titles, chapters, where):
    """The bar that leads to the chapter before and the one behind, for a chapter's text. `where`
    it stands, in words."""
    order = [BEFORE[1], *(chapter.page_name for chapter in chapters), AFTER[0]]
    if here not in order[1:-1]:
        return ""
    k = order.index(here)
    return (f'<nav class="way" aria-label="{where}">'
            f'<a rel="prev" href="{order[k - 1]}">← {titles[order[k - 1]]}</a>'
            f'<a rel="next" href="{order[k + 1]}">{titles[order[k + 1]]} →</a></nav>')


def title_of(text):
    found = re.search(r'<div class="title">(.*?)</div>', text, re.S)
    words = re.sub(r'<div class="ingroups">.*', "", found[1], flags=re.S) if found else ""
    words = re.sub(r" (?:Class|Struct)(?: Template)? Reference.*", "", words, flags=re.S)
    return unescape(" ".join(re.sub(r"<[^>]+>", "", words).split()))


def with_headings(text):
    """The page's title as its first heading, those of the text below it."""
    head, mark, body = text.partition('<div class="contents">')
    head = re.sub(r'<div class="title">(.*?)(<div class="ingroups">.*?</div>)?</div>',
                  r'<h1 class="title">\1</h1>\2', head, count=1, flags=re.S)
    if re.search(r"<h1\b", body):
        body = re.sub(r"(</?h)([1-5])\b", lambda tag: f"{tag[1]}{int(tag[2]) + 1}", body)
    return head + mark + body


def surround(texts, extra=()):
    """All pages, {file: text}, with bar, list and way on. `extra`: pages made elsewhere."""
    chapters = house.chapters()
    titles = {page: title_of(text) for page, text in texts.items()}
    titles["index.html"] = "Start"
    titles["docs_which_method.html"] = "Which method"
    made = {}
    for page, text in texts.items():
        side = BAR + page_list(page, titles, chapters, extra)
        text = re.sub(r"<html\b[^>]*>", '<html lang="en">', text, count=1)
        text = re.sub(r'<div id="titlearea">.*?<!-- end header part -->',
                      lambda _: f'<header id="side">{side}</header><!-- end header part -->', text,
                      flags=re.S)
        text = re.sub(r'<div id="nav-path".*?</ul>\s*</div>', "", text, flags=re.S)
        text = with_headings(text)
        text = text.replace("<body>", f"<body>{SKIP}", 1)
        text = text.replace("</div><!-- top -->",
                            '</div><!-- top --><main id="doc-content" tabindex="-1">', 1)
        text = text.replace('<hr class="footer"/>', '</main><hr class="footer"/>', 1)
        before, after = (way_on(page, titles, chapters, where)
                         for where in ("Chapters, above the text", "Chapters, below the text"))
        text = re.sub(r"(</div>\s*</div><!-- contents -->)", lambda end: after + end[1], text,
                      count=1)
        made[page] = text.replace('<div class="textblock">', '<div class="textblock">' + before, 1)
    kept = reachable(made)
    return {page: made[page] for page in kept}, {page: titles[page] for page in kept}


def reachable(texts):
    """The pages to which links lead from the first one: Doxygen writes more."""
    found, waiting = {"index.html"}, ["index.html"]
    while waiting:
        for page in re.findall(r'href="([\w.-]+\.html)', texts[waiting.pop()]):
            if page in texts and page not in found:
                found.add(page)
                waiting.append(page)
    return [page for page in texts if page in found]
