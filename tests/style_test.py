#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""scripts/check-style accepts a formatted file and refuses another one, and names what it could not check.

    style_test.py ROOT
"""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

FORMATTED = "int one() { return 1; }\n"


def git(folder, *arguments):
    subprocess.run(["git", "-c", "user.name=test", "-c", "user.email=test@localhost", *arguments], cwd=folder, check=True,
                   capture_output=True)


def check(folder):
    return subprocess.run(["scripts/check-style"], cwd=folder, capture_output=True, text=True, check=False)


def make_project(folder, root):
    (folder / "scripts").mkdir()
    shutil.copy(root / "scripts/check-style", folder / "scripts")
    shutil.copy(root / ".clang-format", folder)
    (folder / "one.cpp").write_text(FORMATTED)
    git(folder, "init", "--quiet", "--initial-branch=other")
    git(folder, "add", ".")
    git(folder, "commit", "--quiet", "--message=first")


def main():
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        make_project(folder, Path(sys.argv[1]))
        formatted = check(folder)
        assert formatted.returncode == 0, formatted
        assert "clang-tidy: skipped" in formatted.stdout, formatted.stdout
        if "clang-format: skipped" in formatted.stdout:
            print(formatted.stdout)
            return
        (folder / "one.cpp").write_text(FORMATTED.replace(" {", "\n{"))
        other = check(folder)
        assert other.returncode != 0 and "one.cpp" in other.stderr, other


if __name__ == "__main__":
    main()
