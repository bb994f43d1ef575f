"""Builds all and runs the workbook's own tests: ./wb check."""
import os
import re
import subprocess
import time

import house


def check():
    """The workbook's own tests."""
    house.must_build(["all"], "building the tests")
    process = subprocess.Popen(["ctest", "--test-dir", house.BUILD, "--no-tests=error",
                                "--output-on-failure", "-j", str(os.cpu_count() or 1)],
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    last = time.time()
    for line in process.stdout:
        if match := re.match(r"\s*(\d+)/(\d+) Test +#\d+: (.*?) \.*\s+Passed", line):
            if house.TERMINAL or time.time() - last > 20:
                house.progress(f"tests {match[1]} of {match[2]}: {match[3]}")
                last = time.time()
        elif not re.match(r"\s*Start +\d+:|Internal ctest|\s*$", line):
            house.progress_done()
            print(line, end="", flush=True)
    return process.wait()
