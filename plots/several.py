#!/usr/bin/env python3
"""Runs scripts of this folder in one process, because loading matplotlib takes as long as a figure.

several.py < lines, each a JSON list: the script's name and its arguments. Says "drawing" and the
name of each as it begins. Exit status 2 at the first that fails.
"""
import json
import runpy
import sys
from pathlib import Path

import matplotlib
import style  # noqa: F401  its settings are those of every script

HERE = Path(__file__).absolute().parent


def main():
    for line in sys.stdin:
        script, *sys.argv[1:] = json.loads(line)
        sys.argv[0] = script
        print("drawing", script, flush=True)
        with matplotlib.rc_context():
            runpy.run_path(str(HERE / script), run_name="__main__")


if __name__ == "__main__":
    main()
