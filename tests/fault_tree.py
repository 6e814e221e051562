# SPDX-License-Identifier: MIT
"""What the checks of the project's own files have in common: each prints its faults, and first checks itself on a small tree."""
import tempfile
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def written(tree):
    """A folder with these files, {name: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in tree.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        yield Path(folder)


def expect_faults(faults, tree, expected):
    """faults(root) finds every kind of fault in a tree made for it, and nothing else."""
    with written(tree) as root:
        found = list(faults(root))
    assert sorted(found) == sorted(expected), f"found {found}"


def report(found, fine):
    """Prints the faults, or that all is fine; the exit code."""
    print("\n".join(found) if found else fine)
    return 1 if found else 0
