"""./wb course: the site with the whole course in it, as a folder that any web server can serve."""
import base64
import hashlib
import json
import re
import shutil
import subprocess
from pathlib import Path

from base import exercises, house
from course import parts
from judge import crashes
from website import docs, shell

OUT = house.OUT / "course"
HERE = parts.HERE
SCRIPTS = [path.name for path in sorted(HERE.glob("*.js"))
           if path.name not in ("offline_worker.js", "one_file.js")]


# ---- what is loaded ------------------------------------------------------------------------------

def precompile(program, headers, out, units=False):
    """A precompiled header, made by the compiler that will read it; anew when either changes."""
    stamp = hashlib.sha256(headers.read_bytes() + (HERE / "compiler.js").read_bytes()
                           + str(program).encode()).hexdigest()
    known = out.with_suffix(".stamp")
    if not out.exists() or not known.exists() or known.read_text() != stamp:
        house.progress(f"reading the headers once: {out.name}")
        result = subprocess.run(
            ["node", Path(__file__).parent / "precompile.js", program, headers, out]
            + ["units"] * units, capture_output=True, text=True)
        if result.returncode:
            raise house.Trouble(f"the compiler refuses the headers:\n{result.stderr[-2000:]}")
        known.write_text(stamp)
    return out.read_bytes()


def write_packs(folder):
    """The compiler and its packs."""
    parts.build_objects()
    program = parts.package("@yowasp/clang")
    parts.packed(folder / "compiler.xz", program.read_bytes())
    headers = parts.headers()
    probe = parts.BUILD / "headers.gz"
    parts.pack(probe, headers)
    parts.pack(folder / "common.xz", {**headers, **parts.libraries(), **parts.shared_objects(),
                                      **parts.objects("checker", "module")})
    parts.pack(folder / "header.xz", {
        "/course.pch": precompile(program, probe, parts.BUILD / "course.pch")})
    parts.pack(folder / "units.xz", {**parts.units_objects(), "/units.pch": precompile(
        program, probe, parts.BUILD / "units.pch", units=True)})
    parts.pack(folder / "live.xz", parts.live_objects())
    for chapter in house.chapters():
        parts.pack(folder / f"{chapter.folder}.xz", parts.objects(
            *(f"{kind}_{chapter.folder}" for kind in ("tests", "where", "mistakes"))))


# ---- the pages -----------------------------------------------------------------------------------

def hints_of(chapter, html):
    """{exercise: its three hints as HTML}, from the site's page of hints."""
    text = (html / chapter.page_name.replace("README", "hints")).read_text(encoding="utf-8")
    found = {}
    for part in re.split(r"<h2>", text)[1:]:
        if match := re.match(r"<a class=\"anchor\"[^>]*></a>\s*(\d+\.\d+)</h2>", part):
            found[match[1]] = re.findall(r"<details>.*?</details>", part, re.S)
    return found


def about(chapter, html=None, students=False):
    """What the page has to know of a chapter; its hints are in the site's pages. Students get no
    solution."""
    solution = exercises.read(chapter.solution)
    return {"number": chapter.number, "folder": chapter.folder, "path": house.short(chapter.mine),
            "version": house.version(), "ids": chapter.ids(), "titles": chapter.titles(),
            "stub": exercises.stub(solution), "solution": "" if students else solution,
            "hints": hints_of(chapter, html) if html else {},
            "words": {"meanings": [[pattern.pattern, words] for pattern, words in crashes.MEANINGS],
                      "clues": crashes.CLUES, "refused": list(crashes.REFUSED.items())}}


def with_exercises(text, chapter):
    """A chapter's page with a place for every exercise: where the text says that it can be done, or
    else at its line of the list."""
    for id_ in chapter.ids():
        place = f'<div class="exercise" id="exercise-{id_}" data-exercise="{id_}"></div>'
        within = "(?:(?!</p>).)*"
        now = re.search(rf"<p ?>You can do {within}\b{re.escape(id_)}\b{within}</p>", text,
                        re.S)
        listed = re.search(rf'<li><a class="el" href="[^"]*hints[^"]*">{re.escape(id_)}</a>'
                           r".*?(?=</li>)", text, re.S)
        at = now or listed
        if not at:
            raise house.Trouble(f"{chapter.folder}: the page has no place for exercise {id_}")
        text = text[:at.end()] + place + text[at.end():]
    at = text.index("</ul>", re.search(r">\s*Exercises</h2>", text).end()) + len("</ul>")
    text = text[:at] + '<div class="exercise-file"></div>' + text[at:]
    modules = {name: f"./course/npm/{name}.js" for name in parts.PACKAGES}
    head = (f'<link rel="stylesheet" href="course/course.css">\n'
            f'<script type="importmap">{json.dumps({"imports": modules})}</script>\n'
            '<script src="course/regions.js"></script><script src="course/report.js"></script>\n'
            '<script type="module" src="course/course.js" '
            f'data-chapter="{chapter.number}"></script>\n')
    first = chapter.ids()[0]
    text = text.replace(shell.SKIP, f'{shell.SKIP}<a href="#exercise-{first}">'
                                    f"Skip to exercise {first}</a>", 1)
    return re.sub(r"(?=</head>\s*<body)", lambda _: head, text, count=1)


def write_pages(folder, students):
    """The scripts, the editor, what is known of the chapters, the chapters' pages."""
    for name in [*SCRIPTS, "course.css"]:
        shutil.copyfile(HERE / name, folder / name)
    shutil.copyfile(HERE / "offline_worker.js", OUT / "offline_worker.js")
    for name in parts.PACKAGES:
        if name != "@yowasp/clang":
            target = folder / "npm" / f"{name}.js"
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(parts.package(name), target)
    (folder / "licences.txt").write_text(parts.licences(), encoding="utf-8")
    for chapter in house.chapters():
        (folder / f"chapter_{chapter.number}.json").write_text(
            json.dumps(about(chapter, OUT, students)), encoding="utf-8")
        page = OUT / chapter.page_name
        page.write_text(with_exercises(page.read_text(encoding="utf-8"), chapter),
                        encoding="utf-8")


def write_front():
    """The front page leads to the first exercise."""
    page, first = OUT / "index.html", house.chapters()[0]
    text = page.read_text(encoding="utf-8")
    way = (f'<a class="button" href="{first.page_name}#exercise-{first.ids()[0]}">'
           f"Try exercise {first.ids()[0]} now, in this page</a>")
    page.write_text(text.replace('<p class="ways">', f'<p class="ways">{way}', 1), encoding="utf-8")


def sources():
    """A digest of what is packed: chapters, engine, checker, solvers, tests and the page."""
    digest = hashlib.sha256()
    for top in ("chapters", "engine", "joints", "contacts", "direct", "reduced", "checker",
                "solutions", "tests", "docs/course"):
        for path in sorted((house.ROOT / top).rglob("*")):
            if path.suffix in (".h", ".cpp", ".js", ".css", ".md"):
                digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def manifest():
    """What out/course says of itself. \throws house.Trouble without it, or if it is out of date"""
    path = OUT / "course" / "manifest.json"
    known = json.loads(path.read_text()) if path.exists() else {}
    if known.get("sources") != sources():
        raise house.Trouble(("out/course is older than its sources" if known else "out/course is "
                             "missing") + ": ./wb course --no-serve")
    return known


def write_manifest(folder):
    """Sizes, and all files for use without a network."""
    files = sorted(path for path in OUT.rglob("*") if path.is_file())
    digest = hashlib.sha256()
    for path in files:
        digest.update(path.read_bytes())
    names = [str(path.relative_to(OUT)) for path in files] + ["course/manifest.json"]
    (folder / "manifest.json").write_text(json.dumps({
        "version": house.version(), "sources": sources(),
        "cache": f"joint-workbook-{digest.hexdigest()[:16]}",
        "sizes": {path.name: path.stat().st_size for path in sorted(folder.glob("*.xz"))},
        "chapters": [{"folder": chapter.folder, "page": chapter.page_name, "ids": chapter.ids()}
                     for chapter in house.chapters()],
        "files": names}), encoding="utf-8")


def pack(students=False):
    """Writes out/course from the site; returns the folder."""
    site = house.OUT / "docs" / "html"
    if OUT.exists():
        shutil.rmtree(OUT)
    shutil.copytree(site, OUT)
    folder = OUT / "course"
    folder.mkdir()
    write_packs(folder)
    write_pages(folder, students)
    write_front()
    write_manifest(folder)
    house.progress_done()
    return OUT


def refuse():
    """Without the packages: one line that says which."""
    if lacking := parts.missing():
        raise house.Trouble(f"course needs {' '.join(lacking)} (Debian packages)")


def write_one_file():
    """The one-file edition: the site and the packs in a page that works from a disk; its path."""
    inside, site = OUT / "course", parts.BUILD / "site.xz"
    parts.pack(site, {str(path.relative_to(OUT)): path.read_bytes() for path in
                      sorted(OUT.rglob("*")) if path.is_file() and path.suffix != ".xz"})
    packs = "\n".join(f'<script type="text/plain" id="{path.name}">'
                      f"{base64.b64encode(path.read_bytes()).decode()}</script>"
                      for path in [site, *sorted(inside.glob("*.xz"))])
    scripts = "\n".join(path.read_text(encoding="utf-8") for path in (
        parts.package("xz-decompress"), HERE / "pack.js", HERE / "one_file.js"))
    target = house.OUT / "joint_workbook.html"
    target.write_text((HERE / "one_file.html").read_text(encoding="utf-8")
                      .replace("SCRIPTS", scripts).replace("PACKS", packs), encoding="utf-8")
    return target


def command(serve=True, one_file=False, students=False):
    """Packs the course, and serves it to this computer's browser."""
    from course import serving
    refuse()
    if docs.command():
        return 1
    with house.talking():
        pack(students)
    size = sum(path.stat().st_size for path in (OUT / "course").glob("*.xz"))
    print(f"course: {house.short(OUT)}, {size / 1e6:.1f} MB of it for the compiler")
    if one_file:
        path = write_one_file()
        print(f"the same in one file: {house.short(path)}, {path.stat().st_size / 1e6:.0f} MB; "
              "any browser opens it from a disk")
        return 0
    return serving.serve(OUT) if serve else 0
