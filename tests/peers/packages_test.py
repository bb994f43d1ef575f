#!/usr/bin/env python3
"""The adapters of published engines are proved where the engines are installed: packages_test.py
ROOT BUILD. Exit status 77: none of them is here."""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(sys.argv[1]) / "tools"))
from bench import peers  # noqa: E402

lacking = peers.lacking()
if len(lacking) == len(peers.PACKAGES):
    print("no published engine is installed; ./wb bench --peers installs them")
    sys.exit(77)
listed = (Path(sys.argv[2]) / "tests" / "programs.txt").read_text()
if " peers " not in listed:
    print("engines are installed, but their tests were not configured: rm build/CMakeCache.txt")
    sys.exit(77)
print("holds: the adapters of the installed engines are built and tested")
