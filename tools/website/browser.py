"""A headless Chromium that is told what to do over a pair of pipes, with its own clock running:
looks at pages, real clicks, keys and fingers. No package of Python's is needed."""
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome")
# A page of the disk may look into the frames that it opens; nothing is fetched from elsewhere.
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-web-security", "--allow-file-access-from-files", "--remote-debugging-pipe",
         "--hide-scrollbars"]


def there():
    """The browser's path, or None."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """One page; the output of its console and its requests to the network are kept."""

    def __init__(self):
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        read_end, self.out = os.pipe()
        self.back, write_end = os.pipe()
        command = [there(), *FLAGS, f"--user-data-dir={self.profile.name}", "about:blank"]
        self.process = subprocess.Popen(  # the browser reads at 3 and writes at 4
            ["sh", "-c", f'exec "$@" 3<&{read_end} 4>&{write_end}', "sh", *command],
            pass_fds=(read_end, write_end), stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(read_end)
        os.close(write_end)
        self.text, self.number, self.session = b"", 0, None
        self.console, self.requests = [], []
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target,
                                 flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
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
        if self.session:
            message["sessionId"] = self.session
        os.write(self.out, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.receive()
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def receive(self, patience=60):
        while b"\0" not in self.text:
            if not select.select([self.back], [], [], patience)[0]:
                raise TimeoutError("the browser does not answer")
            self.text += os.read(self.back, 1 << 20)
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
        return message

    # ---- a page ----------------------------------------------------------------------------------

    def open(self, address, width=1280, height=900, dark=False,
             ready="document.documentElement?.dataset.ready === 'yes'"):
        """Opens a page and waits until it says that it is ready; returns the seconds it took."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=width < 600)
        self.call("Emulation.setEmulatedMedia", features=[
            {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])
        self.call("Page.navigate", url="about:blank")
        self.console, self.requests = [], []
        began = time.time()
        self.call("Page.navigate", url=address)
        self.wait(ready)
        return time.time() - began

    def ask(self, code):
        """The value of an expression of the page's."""
        answer = self.call("Runtime.evaluate", expression=code, returnByValue=True,
                           awaitPromise=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(json.dumps(answer["exceptionDetails"])[:500])
        return answer["result"].get("value")

    def look(self, address, look, width, height, patience):
        """What a page says, as soon as it says something."""
        self.open(address, width, height, ready="performance.timing.loadEventEnd > 0")
        end = time.time() + patience
        while True:
            try:
                if said := self.ask(look):
                    return said
            except RuntimeError as error:  # it is not all there yet
                said = str(error)
            if time.time() > end:
                return said
            time.sleep(0.02)

    def wait(self, code, patience=20):
        end = time.time() + patience
        while not self.ask(code):
            if time.time() > end:
                raise TimeoutError(f"never true: {code}; console: {self.console}")
            time.sleep(0.02)

    def text_of(self, id_):
        return self.ask(f"document.getElementById('{id_}').textContent")

    def place_of(self, selector):
        """The middle of an element, scrolled into view."""
        return self.ask(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
          e.scrollIntoView({{block: "center"}}); const b = e.getBoundingClientRect();
          return [b.left + b.width / 2, b.top + b.height / 2]; }})()""")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                  buttons=0 if kind == "mouseReleased" else 1, clickCount=1, **more)

    def click(self, selector):
        x, y = self.place_of(selector)
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)

    def type(self, selector, text):
        """Puts a text into a field and leaves it."""
        self.ask(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
          e.focus(); e.value = {json.dumps(text)};
          e.dispatchEvent(new Event("input", {{bubbles: true}}));
          e.dispatchEvent(new Event("change", {{bubbles: true}})); }})()""")

    def drag(self, points, finger=False, pause=0.02):
        """With the mouse or a finger from the first point to the last."""
        for k, (x, y) in enumerate([*points, points[-1]]):
            last = k == len(points)
            if finger:
                self.call("Input.dispatchTouchEvent",
                          type="touchEnd" if last else "touchMove" if k else "touchStart",
                          touchPoints=[] if last else [{"x": x, "y": y}])
            else:
                self.mouse("mouseReleased" if last else "mouseMoved" if k else "mousePressed", x, y)
            time.sleep(pause)


def job(address, look, width=1280, height=900, wait=3):
    """Open `address`; the answer is the JavaScript expression `look`, once it is true, or after
    `wait` seconds."""
    return {"address": address, "look": look, "width": width, "height": height, "patience": wait}


def ask(jobs):
    """The answers to these jobs, in their order."""
    with Browser() as here:
        return [here.look(**one) for one in jobs]
