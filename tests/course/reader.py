"""What a reader does with the course in a tab of a browser, and out/course for it from a server."""
import atexit
import json
import sys
import threading
from functools import cache
from pathlib import Path

sys.dont_write_bytecode = True
sys.path += [str(Path(__file__).absolute().parents[1] / folder) for folder in ("workbook", "live")]
from proofs import exercises, house, read  # noqa: E402

from course import packing, serving  # noqa: E402

PAGE = "chapters_01_distance_README.html"
READY = "document.documentElement?.dataset.course === 'ready'"
WRONG = "  const vec3 n = direction(body2.x - body1.x);\n  return {n, vec3(0), n, vec3(0)};"
RIGHT = WRONG.replace("{n", "{-n")
MOVES = """document.documentElement.dataset.ready &&
  (panels.some(one => one.stopped) ? $("again").click() : playing || play(true),
   time > 0.2 && !panels.some(one => one.stopped))"""
ENDLESS = "did not end within 2 seconds"
TRIES = 9       # where a busy machine lets code look endless
PATIENCE = 600  # with the compiler, or with all that is kept for use without a network [s]
asked = []      # of the server, in lines


class Exercise:
    """An exercise in a page, or in a frame of it."""

    def __init__(self, browser, id_="1.1", page="document"):
        self.browser, self.page = browser, page
        self.place = f"{page}.querySelector('[data-exercise=\"{id_}\"]')"

    def ask(self, code):
        return self.browser.ask(f"{self.place}{code}")

    def pasting(self, text):
        """Code that puts it in place of the contents of the exercise's first editor, which its own
        key selects: it hears of the page's selection late where the machine is busy."""
        return f"""(() => {{
          const editor = {self.place}.querySelector(".cm-content"), data = new DataTransfer();
          const text = {json.dumps(text)}, dataType = "text/plain";
          data.setData(dataType, text);
          const paste = {{clipboardData: data, data: text, dataType}};  // Firefox: the last
          const all = {{bubbles: true, cancelable: true}};
          const send = event => editor.dispatchEvent(event);
          editor.focus();
          send(new KeyboardEvent("keydown", {{key: "a", keyCode: 65, ctrlKey: true, ...all}}));
          send(new ClipboardEvent("paste", {{...paste, ...all}})); }})()"""

    def write(self, text):
        self.browser.ask(self.pasting(text))
        self.await_text(text)

    def await_text(self, text):
        """In its first editor, whatever the indents."""
        words = f"{self.place}.querySelector('.cm-content').innerText.replace(/\\s+/g, ' ').trim()"
        self.browser.wait(f"{words} === {json.dumps(' '.join(text.split()))}", words)

    def check(self, press=None, wanted=""):
        """The report, once the button, or press(), has led to one and can be pressed again."""
        for _ in range(TRIES):
            self.ask(".querySelector('.report').textContent = ''")
            if press:
                press()
            else:
                self.ask(".querySelector('button.check').click(), 0")
            report = self.browser.wait(
                f"!{self.place}.querySelector('button.check').ariaDisabled && "
                f"{self.place}.querySelector('.report').textContent", f"{self.place}.innerText",
                PATIENCE)
            if ENDLESS not in report or wanted == ENDLESS:
                break
        return report

    def is_done(self):
        return self.ask(".querySelector('h3').classList.contains('done')")

    def is_reported(self):
        """Whether a report is shown, and of the text in the editors."""
        return self.ask(".querySelector('.report:not([hidden]):not(.stale)') !== null")

    def click(self, name):
        self.ask(f".querySelector('button.{name}').click(), 0")

    def other_tab(self):
        """The same exercise in another document; its frame, `other`, is to be removed."""
        self.browser.ask("(() => { window.other = document.createElement('iframe');"
                         "other.src = location.href; document.body.append(other); })()")
        self.browser.wait("other.contentDocument.documentElement.dataset.course === 'ready'")
        return Exercise(self.browser, page="other.contentDocument")

    def unkept(self):
        """What is seen of the sentence that the browser keeps nothing."""
        return self.ask(".innerText.match(/.*keeps nothing.*/)?.[0] || ''")

    def take_in(self, text, allowed=True):
        """Imports a file, `text` as JavaScript writes it; \returns the questions before it."""
        return self.browser.ask(f"""(async () => {{ const all = new DataTransfer(), asked = [];
          confirm = question => {{ asked.push(question); return {json.dumps(allowed)}; }};
          const field = {self.page}.querySelector(".exercise-file input");
          all.items.add(new File([{text}], "answers.cpp")); field.files = all.files;
          await field.onchange(); return asked; }})()""")

    def scene(self, state=MOVES):
        """The words of the scene below, once it moves."""
        frame = f"{self.place}.querySelector('.scene iframe')"
        self.browser.wait(f"{frame}.contentWindow.eval({json.dumps(state)})",
                          f"{frame}?.contentDocument?.body?.innerText")
        return self.browser.ask(f"{frame}.contentDocument.body.innerText")


def served():
    """A server of out/course, at a port that no other has had, and its address."""
    serving.Handler.log_message = lambda self, form, line, *_: asked.append(line)
    server = serving.server_of(packing.OUT, 0)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server, f"http://127.0.0.1:{server.server_port}/"


def compiler_asked_for(browser):
    """Whether the server was asked for it, or for its worker, before a file that is not large."""
    browser.ask("fetch('course/course.css').then(answer => answer.text())")
    return any("compile" in line for line in asked)


@cache
def tab(kind):
    """Exercise 1.1 in a tab that the proofs share, since nothing costs as much as to load the
    compiler; and what served() gives."""
    server, address = served()
    browser = kind()
    atexit.register(browser.__exit__)
    browser.open(address + PAGE, ready=READY, still=True)
    return Exercise(browser), server, address


STUB = exercises.stub(read(house.chapter_of("1").solution))  # of chapter 1


def file_with(answer):
    """The stub with an answer of 1.1."""
    return exercises.replace(STUB, lambda region, place:
                             answer.split("\n") if region.id == "1.1" else None)


def solution():
    """Of chapter 1, as JavaScript writes it."""
    return json.dumps(read(house.chapter_of("1").solution))


def lacks(report, *words):
    for one in words:
        if one not in report:
            yield f"the report lacks '{one}':\n{report}"
