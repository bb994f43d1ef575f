"""A headless Chromium that is told what to do over a pair of pipes, with its own clock running:
looks at pages, real clicks, keys and fingers. No package of Python's is needed.

It waits for states, never for a time: on a busy machine everything takes longer."""
import atexit
import functools
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome")
# A page of the disk may look into the frames that it opens; nothing is fetched from elsewhere.
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-3d-apis", "--disable-quic",
         "--no-first-run", "--disable-background-networking", "--disable-component-update",
         "--disable-sync",
         "--disable-web-security", "--allow-file-access-from-files", "--remote-debugging-pipe",
         "--hide-scrollbars", "--disable-site-isolation-trials",
         "--disable-features=BackForwardCache,SpareRendererForSitePerProcess"]
# In place of these: WebGL, which the processor draws.
NO_WEBGL = {"--disable-gpu", "--disable-3d-apis"}
WEBGL = ["--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
PATIENCE = 300  # with a state that does not come [s]
READY = "document.documentElement?.dataset.ready === 'yes'"
STATE = """[location.href, document.readyState, JSON.stringify(document.documentElement.dataset),
  document.body?.innerText.slice(0, 500)].join(" | ")"""


def there():
    """The browser's path, or None."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Page:
    """Of any browser; ask(code) gives the value of an expression of the page's."""
    console = ()

    def wait(self, code, look=STATE, patience=PATIENCE):
        """The value of an expression, once it is true; it may throw while the page is not all
        there. If it does not come true, the error says what is there instead: `look`. On a busy
        machine it is waited for as many times as long as it is slower."""
        busy = max(1, os.getloadavg()[0] / os.cpu_count())  # how many want each processor
        end, pause = time.time() + busy * patience, 0.005
        while True:
            try:
                if seen := self.ask(code):
                    return seen
            except RuntimeError as error:
                seen = error
            if time.time() > end:
                raise TimeoutError(f"awaited for {busy * patience:.0f} s: {code}\nit is: {seen}\n"
                                   f"there is: {self.ask(look)}\nconsole: {self.console}")
            time.sleep(pause)
            pause = min(1.2 * pause, 0.1)

    def frame(self):
        """Until the page has been painted once more."""
        self.ask("new Promise(done => requestAnimationFrame(() => done(0)))")

    def text_of(self, id_):
        return self.ask(f"document.getElementById('{id_}').textContent")


class Browser(Page):
    """The output of the page's console and its requests to the network are kept."""

    def __init__(self, webgl=False):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        read_end, self.out = os.pipe()
        self.back, write_end = os.pipe()
        flags = [*set(FLAGS) - NO_WEBGL, *WEBGL] if webgl else FLAGS
        command = [there(), *flags, f"--user-data-dir={self.profile.name}", "about:blank"]
        self.process = subprocess.Popen(  # the browser reads at 3 and writes at 4
            ["bash", "-c", f'exec "$@" 3<&{read_end} 4>&{write_end}', "bash", *command],
            pass_fds=(read_end, write_end), stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(read_end)
        os.close(write_end)
        self.text, self.number, self.session, self.loaded = b"", 0, None, None
        self.console, self.requests = [], []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target,
                                 flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log", "Inspector"):
            self.call(f"{domain}.enable")

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.process.kill()
        self.process.wait()
        os.close(self.out)
        os.close(self.back)
        self.profile.cleanup()

    def call(self, method, **parameters):
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters}
        if self.session and not method.startswith("SystemInfo"):
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive(method)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def receive(self, method):
        while b"\0" not in self.text:
            if not select.select([self.back], [], [], PATIENCE)[0]:
                raise TimeoutError(f"the browser has been silent for {PATIENCE} s: {method}")
            more = os.read(self.back, 1 << 20)
            if not more:
                raise TimeoutError(f"the browser has gone: {method}")
            self.text += more
        one, self.text = self.text.split(b"\0", 1)
        message = json.loads(one)
        said, method = message.get("params", {}), message.get("method")
        if method == "Runtime.exceptionThrown":
            self.console.append(json.dumps(said["exceptionDetails"])[:600])
        elif method == "Runtime.consoleAPICalled":
            self.console.append(" ".join(str(one.get("value", one.get("description")))
                                         for one in said["args"]))
        elif method == "Log.entryAdded":
            self.console.append(said["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(said["request"]["url"])
        elif method == "Page.frameNavigated" and "parentId" not in said["frame"]:
            self.loaded, self.console, self.requests = said["frame"]["loaderId"], [], []
        elif method == "Inspector.targetCrashed":
            raise TimeoutError("the page has crashed")
        return message

    def processor_time(self):
        """What its processes have used so far [s]."""
        return sum(one["cpuTime"] for one in self.call("SystemInfo.getProcessInfo")["processInfo"])

    # ---- a page ----------------------------------------------------------------------------------

    def dress(self, width, height=900, dark=False, still=False):
        """The window, what the reader prefers: colours, nothing that moves by itself."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=width < 600)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"},
            {"name": "prefers-reduced-motion", "value": "reduce" if still else "no-preference"}])

    def open(self, address, width=1280, height=900, dark=False, still=False, ready=READY):
        """Loads a page and waits until it is ready."""
        self.dress(width, height, dark, still)
        here = self.ask("location.href.split('#')[0]")  # a new place in it would not load it anew
        for to in ["about:blank"] * (address.partition("#")[0] == here) + [address]:
            before, answer = self.loaded, self.call("Page.navigate", url=to)
            if "errorText" in answer:
                raise RuntimeError(f"{address}: {answer['errorText']}")
            while self.loaded == before:
                self.receive("Page.navigate")
        self.wait(ready)

    def ask(self, code):
        """The value of an expression of the page's."""
        answer = self.call("Runtime.evaluate", expression=code, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            thrown = answer["exceptionDetails"]
            raise RuntimeError(thrown.get("exception", {}).get("description") or thrown["text"])
        return answer["result"].get("value")

    def place_of(self, selector):
        """The middle of an element, scrolled into view, once it stands still."""
        return self.wait(f"""(async () => {{
          const one = document.querySelector({json.dumps(selector)});
          const middle = () => {{ const box = one.getBoundingClientRect();
            return [box.left + box.width / 2, box.top + box.height / 2]; }};
          one.scrollIntoView({{block: "center"}});
          for (let before = ""; before !== String(middle());) {{
            before = String(middle());
            await new Promise(requestAnimationFrame);
          }}
          window.hit = false;
          one.addEventListener("click", () => {{ window.hit = true; }}, {{capture: true}});
          return middle(); }})()""")

    def mouse(self, kind, x, y):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                  buttons=0 if kind == "mouseReleased" else 1, clickCount=1)

    def click(self, selector):
        """Again where the page moved just then and the click went beside it."""
        for _ in range(9):
            place = self.place_of(selector)
            self.mouse("mousePressed", *place)
            self.mouse("mouseReleased", *place)
            if self.ask("window.hit"):
                return
        raise RuntimeError(f"clicks do not reach {selector}: it is at {place}")

    def type(self, selector, text):
        """Puts a text into a field and leaves it."""
        self.ask(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
          e.focus(); e.value = {json.dumps(text)};
          e.dispatchEvent(new Event("input", {{bubbles: true}}));
          e.dispatchEvent(new Event("change", {{bubbles: true}})); }})()""")

    def drag(self, points, finger=False, until="true"):
        """With the mouse or a finger from the first point to the last, painted at each; lets go
        once `until` is true."""
        for k, (x, y) in enumerate(points):
            if finger:
                self.call("Input.dispatchTouchEvent", type="touchMove" if k else "touchStart",
                          touchPoints=[{"x": x, "y": y}])
            else:
                self.mouse("mouseMoved" if k else "mousePressed", x, y)
            self.frame()
        self.wait(until)
        if finger:
            self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        else:
            self.mouse("mouseReleased", x, y)


@functools.cache
def shared():
    """One browser for all proofs of a script: its start costs more than many a proof."""
    here = Browser()
    atexit.register(here.__exit__)
    return here
