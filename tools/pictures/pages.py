"""Pages of one file: what a template links to is put into the place of the link.

A template is a page that works where it lies, in docs/, with its parts beside it; the reader gets
one file that can be moved anywhere.
"""
import json
import re

LINK = re.compile(r'<link rel="stylesheet" href="([\w./]+)">')
SLOT = ">PLACEHOLDER<"
SCRIPT = re.compile(r'<script src="([\w./]+)"([^>]*)></script>')


def whole(template):
    """The text of a template with the style sheets and scripts that it names put into it."""
    def part(name):
        return (template.parent / name).read_text(encoding="utf-8")
    text = template.read_text(encoding="utf-8")
    text = LINK.sub(lambda link: f"<style>\n{part(link[1])}</style>", text)
    return SCRIPT.sub(lambda link: f"<script{link[2]}>\n{part(link[1])}</script>", text)


def filled(template, data):
    """The same with data, as JSON, in its data element."""
    # Inside a script element a "<" could end it early; to JSON \u003c is the same.
    words = json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    before, after = whole(template).split(SLOT)
    return f"{before}>{words}<{after}"
