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
    r"^(?P<indent>[ >]*)(?P<fence>```+|~~~+)(?P<language>[^\n]*)\n(?P<body>.*?)^[ >]*(?P=fence)[ ]*$"
    r"|(?P<code>(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`))"
    r"|\$\$(?P<display>.+?)\$\$"
    r"|(?<![\\$\w])\$(?P<inline>[^\s$](?:(?:(?!\n\n)[^$])*?[^\s$])?)\$(?![\d$])"
    r"|^(?P<heading>##+ +(?P<title>[^\n]+?)) *$"
    r"|^(?P<top># [^\n]+)$"
    r"|^[ ]*(?P<fold></?details[^>]*>(?:\s*<summary>.*?</summary>)?)[ ]*$"
    r"|\*\*(?P<bold>[^*\s](?:(?!\n\n)[^*])*)\*\*"
    r"|(?P<image>!?)\[(?P<text>(?:[^\[\]`]|`[^`]*`)*)\]\((?P<url>[^()\s]+)\)"
    r"|(?<=<img src=\")(?P<source>[^\"]+)", re.S | re.M)


def label(path, title):
    """The name of a heading on the whole site; on a code host its second half is enough."""
    slug = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
    return re.sub(r"\W", "_", os.path.splitext(path)[0]) + "-" + slug


def topic(header):
    """The group of the site in which a header's contents are documented."""
    with open(header, encoding="utf-8") as file:
        return re.search(r"\\(?:defgroup|addtogroup) (\w+)", file.read())[1]


def translate(text, path):
    """The text of the file `path` for Doxygen."""
    def link(piece):
        words = translate(piece["text"], path)
        file, _, place = piece["url"].partition("#")
        file = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
        if re.match(r"\w+:|@ref", piece["url"]):
            return piece[0]
        if piece["image"]:
            return f'<img src="{file}" alt="{html.escape(piece["text"])}">'
        if re.fullmatch(r"(engine|chapters/\w+)/\w+\.h", file):
            return f"[{words}](@ref {topic(file)})"
        if not re.fullmatch(r"docs/\w+\.md|chapters/\w+/README\.md", file):
            return words  # not a page of the site
        return f"[{words}](@ref {label(file, place)})" if place else f"[{words}]({piece['url']})"

    def replace(piece):
        if piece["language"] is not None and piece["language"].strip() == "math":
            return f"{piece['indent']}\\f[\n{piece['body']}{piece['indent']}\\f]"
        if piece["display"]:
            return f"\\f[{piece['display']}\\f]"
        if piece["inline"]:
            return f"\\f${piece['inline']}\\f$"
        if piece["heading"]:
            return f"{piece['heading']} {{#{label(path, piece['title'])}}}"
        if piece["top"]:
            return piece["top"] + "\n\n[TOC]\n"
        if piece["fold"]:
            return f"\n\\htmlonly[block]\n{piece['fold']}\n\\endhtmlonly\n"
        if piece["bold"]:  # Doxygen's own ** fails before a quotation mark
            return f"<b>{translate(piece['bold'], path)}</b>"
        if piece["url"]:
            return link(piece)
        if piece["source"]:
            return os.path.normpath(os.path.join(os.path.dirname(path), piece["source"]))
        return piece[0]

    return PIECES.sub(replace, text)


if __name__ == "__main__":
    name = os.path.relpath(sys.argv[1])
    with open(name, encoding="utf-8") as file:
        sys.stdout.reconfigure(encoding="utf-8")
        sys.stdout.write(translate(file.read(), name))
