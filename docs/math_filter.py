#!/usr/bin/env python3
"""Doxygen's input filter for *.md: what a code host understands, said in Doxygen's words.

$..$, $$..$$ and ```math blocks become formulas; <details> stays raw HTML; headings get the names
by which links reach them; pictures and links are found from the root of the site. Code is code.
Used by docs/Doxyfile; by hand: math_filter.py FILE, from the root of the repository.
"""
import html
import os
import re
import sys

PIECES = re.compile(
    r"^(?P<indent>[ >]*)(?P<fence>```+|~~~+)(?P<language>[^\n]*)\n(?P<body>.*?)"
    r"^[ >]*(?P=fence)[ ]*$"
    r"|(?P<code>(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`))"
    r"|\$\$(?P<display>.+?)\$\$"
    r"|(?<![\\$\w])\$(?P<inline>[^\s$](?:(?:(?!\n\n)[^$])*?[^\s$])?)\$(?![\d$])"
    r"|(?P<comment>\n?[ >]*<!--.*?-->)"
    r"|^(?P<heading>##+ +(?P<title>[^\n]+?)) *$"
    r"|^(?P<top># [^\n]+)$"
    r"|^[ ]*(?P<fold></?details[^>]*>(?:\s*<summary>.*?</summary>)?)[ ]*$"
    r"|(?P<tag></?[a-zA-Z][^<>]*>)"
    r"|\*\*(?P<bold>[^*\s](?:(?!\n\n)[^*])*)\*\*"
    r"|(?P<image>!?)\[(?P<text>(?:[^\[\]`]|`[^`]*`)*)\]\((?P<url>[^()\s]+)\)"
    r"|(?P<quotation>\")", re.S | re.M)


MAIN = "docs/mainpage.md"
EXAMPLES = "library/examples/"
LIVE = "docs/live/README.md?"  # on a code host; behind it a state of the live page


def page_of(path):
    """The name of a page on the site, said in its heading: Doxygen's own differ by version."""
    return re.sub(r"\W", "_", os.path.splitext(path)[0])


def label(path, title):
    """The name of a heading on the whole site; on a code host its second half is enough."""
    slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
    return page_of(path) + "-" + slug


def topic(header):
    """The group of the site in which a header's contents are documented."""
    with open(header, encoding="utf-8") as file:
        return re.search(r"\\(?:defgroup|addtogroup) (\w+)", file.read())[1]


def translate(text, path):
    """The text of the file `path` for Doxygen."""
    def place(url):
        return os.path.normpath(os.path.join(os.path.dirname(path), url)) if url else path

    def link(piece):
        words = " ".join(re.sub("[$`]", "", piece["text"]).split())  # Doxygen wants them plain
        url, _, heading = piece["url"].partition("#")
        if re.match(r"\w+:|@ref", url):
            return piece[0]
        if piece["image"]:
            return f'<img src="{place(url)}" alt="{html.escape(piece["text"])}">'
        if place(url).startswith(LIVE):
            return f'<a href="live.html#{html.escape(place(url)[len(LIVE):])}">{words}</a>'
        if re.fullmatch(r"(engine|chapters/\w+)/\w+\.h", place(url)):
            return f"[{words}](@ref {topic(place(url))})"
        if place(url).startswith(EXAMPLES):  # as they are: programs that a reader copies
            return f'<a href="{os.path.basename(url)}.txt">{words}</a>'
        if not re.fullmatch(r"docs/\w+\.md|CONTRIBUTING\.md|chapters/\w+/(README|hints)\.md"
                            r"|solutions/\w+/answers\.md", place(url)):
            return words  # not a page of the site
        if heading:
            return f"[{words}](@ref {label(place(url), heading)})"
        return f"[{words}](@ref {'index' if place(url) == MAIN else page_of(place(url))})"

    def replace(piece):
        if piece["language"] is not None and piece["language"].strip() == "math":
            return f"{piece['indent']}\\f[\n{piece['body']}{piece['indent']}\\f]"
        if piece["comment"]:  # with its lines: an empty one would part the items of a list
            return ""
        if piece["display"]:
            return f"\\f[{piece['display']}\\f]"
        if piece["inline"]:
            return f"\\f${piece['inline']}\\f$"
        if piece["heading"]:
            return f"{piece['heading'].replace('`', '')} {{#{label(path, piece['title'])}}}"
        if piece["top"]:
            name = "" if path == MAIN else f" {{#{page_of(path)}}}"
            return f"{piece['top']}{name}\n\n[TOC]\n"
        if piece["fold"]:
            return f"\n\\htmlonly[block]\n{piece['fold']}\n\\endhtmlonly\n"
        if piece["bold"]:  # Doxygen's own ** fails before a quotation mark
            return f"<b>{translate(piece['bold'], path)}</b>"
        if piece["url"]:
            return link(piece)
        if piece["tag"]:
            return re.sub(r'(?<=\bsrc=")(?!\w+:)[^"]+', lambda at: place(at[0]), piece["tag"])
        if piece["quotation"]:  # between plain ones Doxygen sees no formulas
            return "&quot;"
        return piece[0]

    return PIECES.sub(replace, text)


if __name__ == "__main__":
    name = os.path.relpath(sys.argv[1])
    with open(name, encoding="utf-8") as file:
        sys.stdout.reconfigure(encoding="utf-8")
        sys.stdout.write(translate(file.read(), name))
