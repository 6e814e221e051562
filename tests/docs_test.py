#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks the documents: relative links and their anchors resolve, and prose is at most 100 columns wide.

    docs_test.py ROOT    prints each fault; exit code 1 if there is one

Tables, code blocks, headings and single words longer than a line are exempt from the width. Before it looks at ROOT it
checks itself on a small tree with one fault of each kind.
"""
import re
import sys
from pathlib import Path

from fault_tree import expect_faults, report

MAX_WIDTH = 100
PAGES = ("*.md", "docs/**/*.md", "data/*.md", "benchmarks/**/*.md", "experiments/**/*.md", "examples/**/*.md")
WRAPPED = ("README.md", "CONTRIBUTING.md", "docs/")
LINK = re.compile(r"\[[^\]]*\]\(([^)\s]+)\)")


def pages(root):
    return sorted({path for pattern in PAGES for path in root.glob(pattern) if "node_modules" not in path.parts})


def without_code(text):
    """The text with its code blocks and code spans blanked; the lines stay where they are."""
    kept, fenced, after_blank = [], False, True
    for line in text.split("\n"):
        fence = line.startswith("```")
        fenced = fenced != fence
        is_code = fence or fenced or (after_blank and line.startswith("    "))
        kept.append("" if is_code else line)
        after_blank = is_code or not line.strip()
    return re.sub(r"`[^`]*`", lambda span: re.sub(r"[^\n]", "x", span[0]), "\n".join(kept))


def anchors(path):
    """The anchors of a page's headings, as GitHub makes them."""
    found = set()
    for title in re.findall(r"^#+ (.*)$", path.read_text(), flags=re.MULTILINE):
        words = re.sub(r"[^\w\- ]", "", title.strip().lower())
        found.add(words.replace(" ", "-"))
    return found


def link_faults(root, page, text):
    for target in LINK.findall(text):
        if re.match(r"\w+:", target):
            continue
        name, _, anchor = target.partition("#")
        path = (page.parent / name).resolve() if name else page
        if not path.exists():
            yield f"{page.relative_to(root)}: {target} does not exist"
        elif anchor and anchor not in anchors(path):
            yield f"{page.relative_to(root)}: {target}: no such heading"


def width_faults(root, page, text):
    for number, line in enumerate(text.split("\n"), 1):
        exempt = line.startswith(("|", "#", "!")) or " " not in line.strip(" -*")
        if len(line) > MAX_WIDTH and not exempt:
            yield f"{page.relative_to(root)}:{number}: {len(line)} columns, wrap at {MAX_WIDTH}"


def faults(root):
    for page in pages(root):
        text = without_code(page.read_text())
        yield from link_faults(root, page, text)
        if page.relative_to(root).as_posix().startswith(WRAPPED):
            yield from width_faults(root, page, text)


def check_self():
    """Every kind of fault is found in a tree made for it, and nothing else."""
    long = "word " * 30
    tree = {
        "README.md": "[a](docs/a.md#two-words-11) [web](https://x.y/z) [b](docs/b.md)\n[c](docs/a.md#no)\n",
        "docs/a.md": f"# Two words: 1.1\n\n[up](../README.md) [here](#nowhere) `[no](link.md)`\n\n| {long} |\n"
        f"\n    {long}\n\n{long}\n",
        "data/d.md": f"{long}\n",
    }
    expected = {
        "README.md: docs/b.md does not exist",
        "README.md: docs/a.md#no: no such heading",
        "docs/a.md: #nowhere: no such heading",
        "docs/a.md:9: 150 columns, wrap at 100",
    }
    expect_faults(faults, tree, expected)


def main():
    check_self()
    return report(list(faults(Path(sys.argv[1]))), "every link resolves, every line fits")


if __name__ == "__main__":
    sys.exit(main())
