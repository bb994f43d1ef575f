"""A headless Firefox that is told what to do over its own port (Marionette), in the words of
browser.py. No package of Python's and no driver is needed."""
import json
import os
import re
import shutil
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from website.browser import PATIENCE, READY, Page

NAMES = ("firefox-esr", "firefox")
ENTER, TAB, CONTROL, SHIFT = "\ue007", "\ue004", "\ue009", "\ue008"


def there():
    """The browser's path, or None."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Firefox(Page):
    """One page."""

    def __init__(self):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        Path(self.folder.name, "user.js").write_text("".join(
            f'user_pref("{name}", {json.dumps(value)});\n' for name, value in {
                "marionette.port": 0, "datareporting.policy.dataSubmissionEnabled": False,
                "dom.quotaManager.temporaryStorage.fixedLimit": 1 << 20,  # 1 GB on any disk
                "app.update.enabled": False, "network.captive-portal-service.enabled": False,
                "network.connectivity-service.enabled": False, "browser.shell.checkDefaultBrowser":
                False, "toolkit.telemetry.reportingpolicy.firstRun": False}.items()))
        self.process = subprocess.Popen(
            [there(), "--headless", "--marionette", "--no-remote", "--profile", self.folder.name],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            env={**os.environ, "HOME": self.folder.name, "MOZ_HEADLESS_WIDTH": "1280",
                 "MOZ_HEADLESS_HEIGHT": "900"})
        self.text, self.number = b"", 0
        self.socket = socket.create_connection(("127.0.0.1", self.port()), timeout=2 * PATIENCE)
        self.receive("its greeting")
        self.call("WebDriver:NewSession", capabilities={"alwaysMatch": {}})
        self.call("WebDriver:SetTimeouts", script=1000 * PATIENCE, pageLoad=1000 * PATIENCE)

    def port(self):
        """The free one that it has found: it says so in a file, once it listens there."""
        said, end = Path(self.folder.name, "MarionetteActivePort"), time.time() + PATIENCE
        while not (said.exists() and said.read_text()):
            if self.process.poll() is not None or time.time() > end:
                raise TimeoutError(f"Firefox opens no port; exit status {self.process.poll()}")
            time.sleep(0.05)
        return int(said.read_text())

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.socket.close()
        self.process.kill()
        self.process.wait()
        self.folder.cleanup()

    def receive(self, name):
        """A message: its length, a colon, JSON."""
        while True:
            if found := re.match(rb"(\d+):", self.text):
                end = found.end() + int(found[1])
                if len(self.text) >= end:
                    one, self.text = self.text[found.end():end], self.text[end:]
                    return json.loads(one)
            try:
                more = self.socket.recv(1 << 20)
            except TimeoutError:
                raise TimeoutError(f"Firefox says nothing for {2 * PATIENCE} s: {name}") from None
            if not more:
                raise TimeoutError(f"Firefox has gone: {name}")
            self.text += more

    def call(self, name, **parameters):
        self.number += 1
        message = json.dumps([0, self.number, name, parameters]).encode()
        self.socket.sendall(b"%d:" % len(message) + message)
        _, _, error, result = self.receive(name)
        if error:
            raise RuntimeError(f"{name}: {error['error']}: {error['message'][:300]}")
        return result

    # ---- a page ----------------------------------------------------------------------------------

    def open(self, address, ready=READY, **_):
        """Opens a page and waits until it is ready."""
        self.call("WebDriver:Navigate", url="about:blank")
        self.call("WebDriver:Navigate", url=address)
        self.wait(ready)

    def ask(self, code):
        """The value of an expression of the page's."""
        script = f"return window.eval({json.dumps(code)})"
        return self.call("WebDriver:ExecuteScript", script=script, args=[], sandbox=None)["value"]

    def click(self, selector):
        self.ask(f"document.querySelector({json.dumps(selector)}).click(), 0")

    def keys(self, *keys):
        """Presses keys, one after the other, wherever the focus is."""
        actions = [{"type": kind, "value": key} for key in keys for kind in ("keyDown", "keyUp")]
        self.call("WebDriver:PerformActions", actions=[
            {"type": "key", "id": "keys", "actions": actions}])

    def chord(self, held, key):
        """Presses a key while another one is held."""
        self.call("WebDriver:PerformActions", actions=[{"type": "key", "id": "keys", "actions": [
            {"type": kind, "value": value} for kind, value in (
                ("keyDown", held), ("keyDown", key), ("keyUp", key), ("keyUp", held))]}])
