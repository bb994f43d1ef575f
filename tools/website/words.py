"""The words of the site's pages, for docs/search.js to look them up: search_words.js."""
import json
import re
import unicodedata
from collections import Counter
from html import unescape

NOT_READ = re.compile(r'<(script|style|svg|title|nav)\b.*?</\1>|<div class="(?:toc|tex)".*?</div>'
                      r'|<span class="tex[^"]*".*?</span>|<!--.*?-->', re.S)
PLACE = re.compile(r'<a class="anchor" id="([^"]+)"></a>\s*(.*?)</h\d>'
                   r'|<a id="([^"]+)"[^>]*></a>\s*<h2 class="memtitle">(.*?)</h2>', re.S)
# Too common to tell one place from another.
COMMON = set("""the a an of and or in on is are to it its that this with for by as at be not no from
    one two what which has have was were if so but than then only all each per into out
    can""".split())
BOLD = re.compile(r"<(?:b|strong)>(.*?)</(?:b|strong)>", re.S)
TITLE_WEIGHT, TEXT_WEIGHT = 6, 3  # of a word in a heading, and in a text


def words_of(html):
    text = unescape(re.sub(r"<[^>]+>", " ", html))
    plain = unicodedata.normalize("NFKD", text.lower())
    return [word for word in re.findall(r"[a-z0-9_]{2,}", plain)
            if word not in COMMON and not re.fullmatch(r"\d+", word)]


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


def index_of(texts, titles):
    """What search_words.js says. `texts` and `titles`: of each page, by its file's name."""
    places, words = [], {}
    for page, title in titles.items():
        if page.startswith("namespace"):
            continue  # it names everything
        weight = (TEXT_WEIGHT if page.endswith("_README.html") else
                  2 if page.startswith("docs") else 1)
        for place, heading, html in sections(texts[page]):
            count = Counter(words_of(html))
            for word in words_of(" ".join(BOLD.findall(html))):  # where a word is explained
                count[word] += TITLE_WEIGHT
            for word in words_of(heading or title):
                count[word] += TITLE_WEIGHT
            if not count:
                continue
            if page.endswith("_hints.html") and re.match(r"\d\.\d", heading):
                heading = f"Exercise {heading}"
            for word, times in count.items():
                words.setdefault(word, []).extend((len(places), weight * min(times, 9)))
            places.append([f"{page}#{place}" if place else page, title, heading])
    return {"places": places, "words": words}


def write(html, texts, titles):
    data = json.dumps(index_of(texts, titles), separators=(",", ":"), ensure_ascii=False)
    (html / "search_words.js").write_text(f"search_words({data})\n", encoding="utf-8")
