"""Pages of one file: what a template links to is put into the place of the link.

A template is a page that works where it lies, in docs/, with its parts beside it; the reader gets
one file that can be moved anywhere.
"""
import json
import re
from pathlib import Path

LINK = re.compile(r'<link rel="stylesheet" href="([\w./]+)">')
SLOT = ">PLACEHOLDER<"
SCRIPT = re.compile(r'<script src="([\w./]+)"([^>]*)></script>')
THREE = Path("/usr/share/javascript/three/three.min.js")  # three.js, Debian's libjs-three
TERMS = Path("/usr/share/doc/libjs-three/copyright")


def three():
    """three.js with its terms before it; nothing where it is not there."""
    terms, script = (path.read_text(encoding="utf-8") if path.exists() else ""
                     for path in (TERMS, THREE))
    return script and f"/*\n{terms}*/\n{script}"


def whole(template, beside=""):
    """The text of a template with the style sheets and scripts that it names put into it; three.js
    stays `beside` the page where that says how to reach it. Without it pages draw flat."""
    def part(name):
        return three() if name == THREE.name else (template.parent / name).read_text(
            encoding="utf-8")
    text = template.read_text(encoding="utf-8")
    text = LINK.sub(lambda link: f"<style>\n{part(link[1])}</style>", text)
    return SCRIPT.sub(lambda link: f'<script src="{beside}"></script>'
                      if beside and link[1] == THREE.name else
                      f"<script{link[2]}>\n{part(link[1])}</script>", text)


def beside(folder, way=""):
    """Puts three.js into the folder of a site; returns how its pages reach it, if it is there."""
    if script := three():
        (folder / THREE.name).write_text(script, encoding="utf-8")
    return script and way + THREE.name


def filled(template, data, beside=""):
    """The same with data, as JSON, in its data element."""
    # Inside a script element a "<" could end it early; to JSON \u003c is the same.
    words = json.dumps(data, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    before, after = whole(template, beside).split(SLOT)
    return f"{before}>{words}<{after}"
