#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs every block of docs/tutorials, page by page, in a folder with the samples of data/.

    tutorials_test.py AUGICP PROJECT [PAGE...]    with the Python module on PYTHONPATH

The blocks of a page run in order: those marked `sh` each in a shell of its own that ends at the first failure, those marked
`python` in one interpreter. A page without blocks is a fault, and so is a block with another mark.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
# Blocks of Python in one interpreter, with those of the shell between them.
RUNNER = """
import subprocess, sys
namespace = {"__name__": "__main__"}
for path in sys.argv[1:]:
    text = open(path, encoding="utf-8").read()
    if path.endswith(".sh"):
        subprocess.run(["sh", "-e", path], check=True)
    else:
        exec(compile(text, path, "exec"), namespace)
"""


def blocks(page):
    found = BLOCK.findall(page.read_text(encoding="utf-8"))
    unknown = {mark for mark, _ in found} - {"sh", "python"}
    if unknown or not found:
        sys.exit(f"{page.name}: expected blocks of sh and python, found {sorted(unknown) or 'none'}")
    return found


def run_page(page, folder):
    shutil.copytree(PROJECT / "data", folder / "data")
    scripts = []
    for number, (mark, text) in enumerate(blocks(page), 1):
        scripts.append(folder / f"block_{number}.{'sh' if mark == 'sh' else 'py'}")
        scripts[-1].write_text(text, encoding="utf-8")
    environment = os.environ | {"PATH": f"{AUGICP.parent}:{os.environ['PATH']}"}
    return subprocess.run([sys.executable, "-c", RUNNER, *scripts], cwd=folder, env=environment, capture_output=True, text=True,
                          check=False)


def main():
    pages = [page for page in sorted((PROJECT / "docs/tutorials").glob("*.md")) if page.name != "README.md"]
    failed = 0
    for page in pages:
        if sys.argv[3:] and page.stem not in sys.argv[3:]:
            continue
        with tempfile.TemporaryDirectory() as folder:
            finished = run_page(page, Path(folder))
        print(f"{page.name}: {'passed' if finished.returncode == 0 else 'FAILED'}")
        if finished.returncode:
            failed += 1
            print(finished.stdout[-2000:], finished.stderr[-3000:], sep="\n")
    return 1 if failed or not pages else 0


if __name__ == "__main__":
    sys.exit(main())
