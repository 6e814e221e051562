#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Makes the comments of a header visible to doxygen, as its INPUT_FILTER: prints the file with `// ` before a declaration, and
behind one in its line, as `/// ` and `///< `.

    doxygen_filter.py HEADER

A block that is followed by an empty line is a comment of the file, and stays one. Comments inside of functions do not matter:
doxygen reads declarations. The lines stay where they are.
"""
import re
import sys
from pathlib import Path

WHOLE = re.compile(r"^(\s*)//(?!/)\s?(.*)$")
BEHIND = re.compile(r"^(?P<code>[^/\"]*[;,{}\w>)]\s*)//(?!/)(?P<text>\s.*)$")
# A comment that speaks to tools, and the licence.
NO_TEXT = re.compile(r"SPDX-License-Identifier|NOLINT|clang-format")


def blocks(lines):
    """Ranges of neighbouring comment lines."""
    begin = None
    for number, line in enumerate([*lines, ""]):
        is_comment = bool(WHOLE.match(line)) and not NO_TEXT.search(line)
        if is_comment and begin is None:
            begin = number
        elif not is_comment and begin is not None:
            yield begin, number
            begin = None


def escaped(text):
    """Text for doxygen, which has marks of its own."""
    return re.sub(r"`([^`]+)`", r"<tt>\1</tt>", re.sub(r"([<>@\\#%&])", r"\\\1", text))


def filtered(text):
    lines = text.split("\n")
    shown = list(lines)
    for begin, end in blocks(lines):
        if end >= len(lines) or not lines[end].strip() or lines[end].lstrip().startswith(("#", "}")):
            continue
        for number in range(begin, end):
            indent, words = WHOLE.match(lines[number]).groups()
            shown[number] = f"{indent}/// {escaped(words)}"
    for number, line in enumerate(lines):
        behind = BEHIND.match(line)
        if behind and not NO_TEXT.search(line) and not WHOLE.match(line):
            shown[number] = behind["code"] + "///<" + escaped(behind["text"])
    # A member's comment goes on in the lines below, at the same column.
    for number in range(1, len(lines)):
        above = shown[number - 1]
        if "///<" in above and shown[number].lstrip().startswith("/// ") and \
                shown[number].index("///") == above.index("///<"):
            shown[number] = shown[number].replace("///", "///<", 1)
    return "\n".join(shown)


if __name__ == "__main__":
    sys.stdout.write(filtered(Path(sys.argv[1]).read_text(encoding="utf-8")))
