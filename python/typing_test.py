# SPDX-License-Identifier: MIT
"""The examples and the package satisfy mypy --strict."""
import os
import subprocess
import sys
from pathlib import Path

import pytest

import augicp
from conftest import PROJECT

PACKAGE = Path(augicp.__file__).parent
CONFIGURATION = "[mypy]\nstrict = true\n[mypy-matplotlib.*]\nignore_missing_imports = true\n"


def faults(folder, *files):
    """What mypy finds, a line each. It takes twenty seconds without what it remembers of NumPy."""
    (folder / "mypy.ini").write_text(CONFIGURATION)
    words = ["--config-file", folder / "mypy.ini", "--cache-dir", PACKAGE.parent / ".mypy_cache", "--no-error-summary", *files]
    finished = subprocess.run([sys.executable, "-m", "mypy", *map(str, words)], capture_output=True, text=True, check=False,
                              cwd=folder, env=os.environ | {"MYPYPATH": str(PACKAGE.parent)})
    assert not finished.stderr
    return finished.stdout.splitlines()


def test_examples_and_package_are_typed(tmp_path):
    pytest.importorskip("mypy")
    wrong = tmp_path / "wrong.py"
    wrong.write_text("import augicp\n\naugicp.align([[0.0, 0.0, 0.0]], 'b.ply', threads='two')\n")
    found = faults(tmp_path, wrong, *sorted((PROJECT / "examples").glob("*.py")), PACKAGE / "__init__.pyi", PACKAGE / "_word.py")
    assert len(found) == 1 and found[0].startswith("wrong.py:3:") and "threads" in found[0], found
