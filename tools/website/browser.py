"""Pages as a browser shows them, many in one start of a headless Chromium: each in a frame, one
after the other, and the result of a piece of JavaScript in it."""
import json
import re
import shutil
import subprocess
import tempfile
import threading
from pathlib import Path
from urllib.parse import unquote

NAMES = ("chromium", "chromium-browser", "google-chrome")
# A page of the disk may look into the frames that it opens; nothing is fetched from elsewhere.
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
         "--disable-background-networking", "--disable-component-update", "--disable-sync",
         "--disable-web-security", "--allow-file-access-from-files", "--enable-logging=stderr"]
LONGEST = 300  # of all looks together [s]
HARNESS = """<!DOCTYPE html><meta charset="utf-8"><body><script>
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
  console.log("ANSWERS" + encodeURIComponent(JSON.stringify(answers)) + "END");
})();
</script>"""


def there():
    """The browser's path, or None."""
    return next(filter(None, map(shutil.which, NAMES)), None)


def job(address, look, width=1280, height=900, wait=3000):
    """Open `address`; the answer is the JavaScript expression `look`, of page and document."""
    return {"address": address, "look": look, "width": width, "height": height, "wait": wait}


def ask(jobs):
    """The answers to these jobs, in their order; None where a page had none."""
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        page = Path(folder, "harness.html")
        page.write_text(HARNESS.replace("JOBS", json.dumps(jobs).replace("<", "\\u003c")),
                        encoding="utf-8")
        process = subprocess.Popen(
            [there(), *FLAGS, f"--user-data-dir={folder}/profile", page.as_uri()],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, errors="replace")
        watch = threading.Timer(LONGEST, process.kill)
        watch.start()
        try:
            for line in process.stderr:  # what the page says to its console
                if found := re.search(r"ANSWERS(.+?)END", line):
                    return json.loads(unquote(found[1]))
        finally:
            watch.cancel()
            process.kill()
            process.wait()
    return [None] * len(jobs)
