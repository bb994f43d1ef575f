"""The course in a headless Chromium: page_test.py ROOT BUILD

Looks at out/course, which ./wb course writes: exercise 1.1 wrong, right and moving; a loop without
end, a crash, an error of the compiler; the file out and in; two tabs; without a network; the
one-file edition; a narrow window. Skipped, with exit status 77, where there is no browser or no
present out/course.
"""
import json
import statistics
import sys
import threading
import time
from difflib import unified_diff
from pathlib import Path

sys.dont_write_bytecode = True
HERE = Path(__file__).absolute().parent
sys.path[:0] = [str(HERE.parent / folder) for folder in ("workbook", "live")]
from proofs import exercises, house, main, notes, read  # noqa: E402

from course import packing, serving  # noqa: E402
from website.browser import Browser, there  # noqa: E402

PAGE = "chapters_01_distance_README.html"
WRONG = "  const vec3 n = direction(body2.x - body1.x);\n  return {n, vec3(0), n, vec3(0)};"
RIGHT = WRONG.replace("{n", "{-n")
PATIENCE = 120  # with the compiler on a busy machine [s]
MOST_IN_ONE_FILE = 50e6  # [bytes]
AT_MOST = 1.0  # from edit to verdict on a machine that is not busy [s]


class Reader:
    """A tab with a chapter's page, and one of its exercises."""

    def __init__(self, browser, address, id_="1.1", **window):
        self.browser, self.id = browser, id_
        self.place = f"document.querySelector('[data-exercise=\"{id_}\"]')"
        self.begin(address, **window)

    def begin(self, address, **window):
        self.browser.open(address, ready="document.documentElement?.dataset.course === 'ready'",
                          **window)

    def ask(self, code):
        return self.browser.ask(f"{self.place}{code}")

    def write(self, text):
        """Pastes it in place of the contents of the exercise's first editor, which its own key
        selects: it hears of the page's selection late where the machine is busy."""
        written = self.browser.ask(f"""(async () => {{
          const editor = {self.place}.querySelector(".cm-content"), data = new DataTransfer();
          const text = {json.dumps(text)}, dataType = "text/plain";
          data.setData(dataType, text);
          const paste = {{clipboardData: data, data: text, dataType}};  // Firefox: the last
          const lines = () => [...editor.querySelectorAll(".cm-line")].map(one => one.textContent);
          const all = {{bubbles: true, cancelable: true}};
          const send = event => editor.dispatchEvent(event);
          editor.focus();
          send(new KeyboardEvent("keydown", {{key: "a", keyCode: 65, ctrlKey: true, ...all}}));
          send(new ClipboardEvent("paste", {{...paste, ...all}}));
          await new Promise(then => setTimeout(then, 50));
          return lines().join("\\n") === text || lines().join("\\n"); }})()""")
        if written is not True:
            raise RuntimeError(f"the editor does not take the text, but has:\n{written}")

    def check(self):
        """The report."""
        self.browser.click(f'[data-exercise="{self.id}"] button.check')
        time.sleep(0.05)
        self.browser.wait(f"!{self.place}.querySelector('button.check').ariaDisabled", PATIENCE)
        return self.report()

    def report(self):
        return self.ask(".querySelector('.report').textContent")


def served():
    """The address of out/course, and the function that ends its server."""
    server = serving.server_of(packing.OUT, 8900)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return f"http://127.0.0.1:{server.server_port}/", server


def file_with(answer):
    """The stub of chapter 1 with an answer of 1.1."""
    stub = exercises.stub(read(house.chapter_of("1").solution))
    return exercises.replace(stub, lambda region, place:
                             answer.split("\n") if region.id == "1.1" else None)


def take_in(browser, text, page="document"):
    """Imports a file; `text` as JavaScript writes it."""
    browser.ask(f"""(async () => {{ const all = new DataTransfer();
      const field = {page}.querySelector(".exercise-file input");
      all.items.add(new File([{text}], "answers.cpp")); field.files = all.files;
      await field.onchange(); }})()""")


def lacks(report, *words):
    for one in words:
        if one not in report:
            yield f"the report lacks '{one}':\n{report}"


def the_first_exercise_can_be_done(root, build):
    """1.1 wrong, right and moving; the compiler is loaded by its button alone"""
    address, server = served()
    with Browser() as browser:
        reader = Reader(browser, address + PAGE)
        time.sleep(1)
        if any(url.endswith(".xz") for url in browser.requests):
            yield "the compiler is loaded before anybody asks for it"
        if "MB" not in reader.ask(".querySelector('button.check').textContent"):
            yield "the button does not say how much it loads"
        reader.write(WRONG)
        yield from lacks(reader.check(), "1.1  CentreDistance::jacobian: wrong",
                         "C, v1.x      0.600000     -0.600000      1.200000",
                         "Likely mistake: the sign of the block v1",
                         "3 more of its 6 tests fail")
        times = []
        for k in range(10):
            reader.write(RIGHT if k % 2 else WRONG)
            reader.check()
            times.append(float(reader.ask(".dataset.took")) / 1000)
        notes.append(f"course: edit to verdict {statistics.median(times):.2f} s, the median of 10 "
                     f"(aim {AT_MOST} s on a machine that is not busy)")
        yield from lacks(reader.report(), "done", "6 tests passed.")
        browser.wait(f"!!{reader.place}.querySelector('.scene iframe')", PATIENCE)
        browser.wait(f"{reader.place}.querySelector('.scene iframe').contentDocument"
                     "?.documentElement?.dataset.ready === 'yes'", PATIENCE)
        moving = reader.ask(".querySelector('.scene iframe').contentDocument.body.innerText")
        if "yours" not in moving or "stopped" in moving:
            yield f"the scene does not move with the reader's code: {moving[:200]}"
        yield from browser.console
    server.shutdown()


def what_goes_wrong_is_told(root, build, kind=Browser):
    """a loop without end, a crash, memory, what is thrown, an error of the compiler at its line"""
    address, server = served()
    with kind() as browser:
        reader = Reader(browser, address + PAGE)
        for code, words in {
                "  while (body1.x.x < 9) {}\n  return {};": "did not end within 2 seconds",
                "  std::vector<real> v;\n  return {vec3(v[3]), {}, {}, {}};":
                    "an index outside a vector",
                "  return CentreDistance::jacobian(body1, body2);": "the stack is full",
                '  throw std::runtime_error("too far");': "it threw an exception: too far",
                '  todo("1.1");': "not written yet",
                "  std::exit(3);\n  return {};": "does the code call exit()?",
                '  std::cout << "hello";\n  return {};': "| hello"}.items():
            reader.write(code)
            yield from lacks(reader.check(), words)
        broken = RIGHT.replace(");\n", ")\n")
        reader.write(broken)
        line = file_with(broken).split("\n").index(broken.strip("\n").split("\n")[0]) + 1
        yield from lacks(reader.check(), "does not compile", f"exercise 1.1, line {line}",
                         "expected ';'")
        if not reader.ask(".querySelectorAll('.cm-lintRange-error').length"):
            yield "the line of the error is not marked"
        for k in (1, 2, 3):
            browser.click('[data-exercise="1.1"] button.hint')
            if (count := reader.ask(".querySelectorAll('.hints details').length")) != k:
                yield f"after {k} hints {count} are there"
    server.shutdown()


def nothing_is_lost(root, build, kind=Browser):
    """what is written is there after a reload and without a network; the file goes out and in"""
    address, server = served()
    wanted = file_with(RIGHT)
    caught = """(() => { const made = URL.createObjectURL; URL.createObjectURL = blob => {
      blob.text().then(text => { window.exported = text; }); return made.call(URL, blob); }; })()"""
    with kind() as browser:
        reader = Reader(browser, address + PAGE)
        reader.write(RIGHT)
        reader.check()
        reader.begin(address + PAGE)
        browser.ask(caught)
        browser.click(".exercise-file button")
        browser.wait("window.exported")
        if (exported := browser.ask("window.exported")) != wanted:
            yield from ("the exported file is not the stub with the answer in it:", *unified_diff(
                wanted.split("\n"), exported.split("\n"), "wanted", "exported", lineterm="", n=1))
        # another tab
        browser.ask("(() => { window.other = document.createElement('iframe');"
                    "other.src = location.href; document.body.append(other); })()")
        browser.wait("other.contentDocument?.documentElement?.dataset.course === 'ready'")
        reader.write(WRONG)
        browser.wait("other.contentDocument.querySelector('[data-exercise=\"1.1\"] .cm-content')"
                     ".textContent.includes('{n,')")
        browser.ask("other.remove()")
        # import
        take_in(browser, "window.exported")
        if "-n" not in reader.ask(".querySelector('.cm-content').textContent"):
            yield "the imported file is not in the editor"
        reader.check()
        browser.wait("document.documentElement.dataset.offline", PATIENCE)
        kept = browser.ask("document.documentElement.dataset.offline")
        server.shutdown()
        server.server_close()
        if kept != "ready":
            yield f"without a network: {kept}"
            return
        began = time.time()
        reader.begin(address + PAGE)
        yield from lacks(reader.check(), "6 tests passed.")
        notes.append(f"course: from reload without a network to a verdict "
                     f"{time.time() - began:.1f} s")


def one_file_is_enough(root, build, kind=Browser):
    """the one-file edition judges from a disk, and leads to its other pages"""
    path = packing.write_one_file()
    address, size = path.as_uri(), path.stat().st_size
    notes.append(f"course: {size / 1e6:.1f} MB in one file")
    if size > MOST_IN_ONE_FILE:
        yield f"the file has {size / 1e6:.1f} MB"
    page = "document.querySelector('iframe')?.contentDocument"
    place = f"{page}.querySelector('[data-exercise=\"1.1\"]')"
    solution = json.dumps(read(house.chapter_of("1").solution))
    with kind() as browser:
        browser.open(f"{address}#{PAGE}",
                     ready=f"{page}?.documentElement?.dataset.course === 'ready'")
        for words in ("not written yet", "6 tests passed."):
            browser.ask(f"{place}.querySelector('button.check').click(), 0")
            browser.wait(f"!{place}.querySelector('button.check').ariaDisabled", PATIENCE)
            yield from lacks(browser.ask(f"{place}.querySelector('.report').textContent"), words)
            take_in(browser, solution, page)
        browser.wait(f"!!{place}.querySelector('.scene iframe')", PATIENCE)
        for selector in ("#pages a[href*=which_method]", "#pages a[href*=hinge_README]"):
            name = browser.ask(f"{page}.querySelector('{selector}').getAttribute('href')")
            browser.ask(f"{page}.querySelector('{selector}').click(), 0")
            browser.wait(f"document.querySelector('iframe').dataset.shows === '{name}'")
            lost = browser.ask(f"""(async () => {{ for (const one of {page}.images) {{
              one.loading = "eager";
              try {{ await one.decode(); }} catch {{ return one.outerHTML; }} }} }})()""")
            if lost:
                yield f"{name}: a picture is missing: {lost}"


def a_rope_moves_a_rope(root, build):
    """the scene below exercise 1.5, the rope's, is the bridge on ropes"""
    address, server = served()
    solution = json.dumps(read(house.chapter_of("1").solution))
    with Browser() as browser:
        reader = Reader(browser, address + PAGE, "1.5")
        take_in(browser, solution)
        yield from lacks(reader.check(), "done")
        browser.wait(f"{reader.place}.querySelector('.scene iframe')?.contentDocument"
                     "?.documentElement?.dataset.ready === 'yes'", PATIENCE)
        shown = reader.ask(".querySelector('.scene iframe').contentDocument"
                           ".querySelector('#scenes [aria-pressed=true]').textContent")
        if shown != "rope bridge":
            yield f"the scene is: {shown}"
    server.shutdown()


def a_telephone_shows_it(root, build):
    """at 390 pixels nothing is wider than the window; the report's table fits"""
    address, server = served()
    with Browser() as browser:
        reader = Reader(browser, address + PAGE, width=390, height=844)
        reader.write(WRONG)
        reader.check()
        if (wide := browser.ask("document.documentElement.scrollWidth")) > 390:
            yield f"the page is {wide} pixels wide"
        wide, room = (reader.ask(f".querySelector('.report').{side}Width")
                      for side in ("scroll", "client"))
        if wide > room:
            yield f"the report is {wide} pixels wide in {room}"
    server.shutdown()


def little_memory_is_told(root, build):
    """a device with less than 1 GB is told before the compiler is loaded"""
    address, server = served()
    with Browser() as browser:
        browser.call("Page.addScriptToEvaluateOnNewDocument", source=
                     "Object.defineProperty(Navigator.prototype, 'deviceMemory', {value: 0.5})")
        reader = Reader(browser, address + PAGE)
        yield from lacks(reader.check(), "less than 1 GB of memory")
        if any(url.endswith(".xz") for url in browser.requests):
            yield "the compiler is loaded all the same"
    server.shutdown()


PROOFS = [the_first_exercise_can_be_done, what_goes_wrong_is_told, nothing_is_lost,
          one_file_is_enough, a_rope_moves_a_rope, a_telephone_shows_it, little_memory_is_told]

if __name__ == "__main__":
    try:
        sizes = packing.manifest()["sizes"]
    except house.Trouble as trouble:
        lacking = str(trouble)
    else:
        lacking = "" if there() else "chromium missing (Debian package)"
        notes.append(f"course: {sum(sizes.values()) / 1e6:.1f} MB packed, for all chapters")
    if lacking:
        print(f"the course in a browser: {lacking}")
        sys.exit(77)
    sys.exit(main(__doc__, PROOFS, sys.argv[1:]))
