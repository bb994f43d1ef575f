"""Pages as a browser shows them, many in one start of a headless Chromium: each in a frame, one
after the other, and what a piece of JavaScript makes of it."""
import json
import re
import shutil
import subprocess
import tempfile
from html import unescape
from pathlib import Path

NAMES = ("chromium", "chromium-browser", "google-chrome")
# A page of the disk may look into the frames that it opens; nothing is fetched from elsewhere.
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-web-security", "--allow-file-access-from-files", "--dump-dom"]
HARNESS = """<!DOCTYPE html><meta charset="utf-8"><body><pre id="answer"></pre><script>
"use strict";
const jobs = JOBS, answers = [];
async function ask({address, width, height, look, wait}) {
  const frame = document.createElement("iframe");
  Object.assign(frame.style, {width: width + "px", height: height + "px", border: 0});
  const loaded = new Promise(done => { frame.onload = done; setTimeout(done, 20000); });
  frame.src = address;
  document.body.append(frame);
  await loaded;
  const page = frame.contentWindow, body = new Function("page", "document", `return ${look};`);
  let answer = null;
  for (let left = wait; ; left -= 50) {  // until it has something to say
    try { answer = body(page, page.document); } catch (error) { answer = {error: String(error)}; }
    if (left <= 0 || (answer && !answer.error)) break;
    await new Promise(done => setTimeout(done, 50));
  }
  frame.remove();
  return answer;
}
(async () => {
  for (const job of jobs) answers.push(await ask(job));
  document.getElementById("answer").textContent = JSON.stringify(answers);
})();
</script>"""


def there():
    """The browser's path, or None."""
    return next(filter(None, map(shutil.which, NAMES)), None)


def job(address, look, width=1280, height=900, wait=3000):
    """Open `address`; the answer is the JavaScript expression `look`, of page and document."""
    return {"address": address, "look": look, "width": width, "height": height, "wait": wait}


def ask(jobs, dark=False):
    """The answers to these jobs, in their order; None where a page had none."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        page = Path(folder, "harness.html")
        page.write_text(HARNESS.replace("JOBS", json.dumps(jobs).replace("<", "\\u003c")),
                        encoding="utf-8")
        flags = [*FLAGS, f"--virtual-time-budget={20000 + 4000 * len(jobs)}",
                 f"--user-data-dir={folder}/profile"]
        seen = subprocess.run([there(), *flags, page.as_uri()], capture_output=True, text=True,
                              timeout=600).stdout
    found = re.search(r'<pre id="answer">(.+?)</pre>', seen, re.S)
    return json.loads(unescape(found[1])) if found else [None] * len(jobs)
