#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""docs/method.md names the code truly: each name stands in its file, and each equation marked in the code has its row.

    method_test.py ROOT    prints each fault; exit code 1 if there is one

A row of a table whose last cell is a file (under src/augicp) gives names in the cell before. A row that begins with
equation numbers gives the file that marks them, as `Eq. (12)`; every other mark in the sources must be of such a row.
Before it looks at ROOT it checks itself on a small tree with one fault of each kind.
"""
import re
import sys
from pathlib import Path

from fault_tree import expect_faults, report

ROW = re.compile(r"^\| (.*) \| ([^|]*) \| `([\w/]+\.(?:h|cpp))` \|$", re.MULTILINE)
NUMBERS = re.compile(r"\((\d+)\)")
MARK = re.compile(r"\bEq\. \((\d+)\)(?:(?:, | and )\((\d+)\))?")


def code_names(cell):
    return re.findall(r"`([^`]+)`", cell)


def stands_in(name, text):
    return re.search(rf"(?<![\w]){re.escape(name)}(?![\w])", text) is not None


def marks_in(text):
    """The numbers of the equations that a source marks; a mark may be broken by the end of a comment line."""
    joined = re.sub(r"\n\s*//\s*", " ", text)
    return {int(number) for pair in MARK.findall(joined) for number in pair if number}


def row_faults(sources, first_cells, names, file):
    path = sources / file
    if not path.exists():
        yield f"docs/method.md: {file} does not exist"
        return
    text = path.read_text()
    if not names:
        yield f"docs/method.md: a row of {file} names nothing"
    for name in names:
        if not stands_in(name, text):
            yield f"docs/method.md: `{name}` does not stand in {file}"
    for number in sorted(set(map(int, NUMBERS.findall(first_cells))) - marks_in(text)):
        yield f"docs/method.md: {file} does not mark Eq. ({number})"


def faults(root):
    sources, listed = root / "src/augicp", set()
    rows = ROW.findall((root / "docs/method.md").read_text())
    if not rows:
        yield "docs/method.md: no row with a file found"
    for first_cells, cell, file in rows:
        equation = first_cells.split(" | ")[0] if re.match(r"\(\d", first_cells) else ""
        listed |= set(map(int, NUMBERS.findall(equation)))
        yield from row_faults(sources, equation, code_names(cell), file)
    for path in sorted(path for suffix in ("h", "cpp") for path in sources.rglob(f"*.{suffix}")):
        for number in sorted(marks_in(path.read_text()) - listed):
            yield f"{path.relative_to(root)}: Eq. ({number}) has no row in docs/method.md"


def check_self():
    """Every kind of fault is found in a tree made for it, and nothing else."""
    tree = {
        "docs/method.md": "| paper | code | file |\n| --- | --- | --- |\n"
        "| p | `points`, `point` | `cloud/a.h` |\n| q | `gone` | `cloud/no.h` |\n| r | words | `cloud/a.h` |\n"
        "| (4), (7) | moves | `operator*` | `cloud/a.h` |\n| (8) | sums | `points` | `cloud/a.h` |\n",
        "src/augicp/cloud/a.h": "// Eq. (4)\n// and (7).\nint points; void operator*();\n",
        "src/augicp/cloud/b.cpp": "// Eq. (9) of the paper, Eq. (4)\n",
    }
    expected = {
        "docs/method.md: `point` does not stand in cloud/a.h",
        "docs/method.md: cloud/no.h does not exist",
        "docs/method.md: a row of cloud/a.h names nothing",
        "docs/method.md: cloud/a.h does not mark Eq. (8)",
        "src/augicp/cloud/b.cpp: Eq. (9) has no row in docs/method.md",
    }
    expect_faults(faults, tree, expected)


def main():
    check_self()
    return report(list(faults(Path(sys.argv[1]))), "every name stands in its file, every marked equation has a row")


if __name__ == "__main__":
    sys.exit(main())
