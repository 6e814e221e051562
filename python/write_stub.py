#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the type stub of the package: a template, with the keyword options of the library's tables filled in.

    write_stub.py TEMPLATE OUTPUT    with the built package on PYTHONPATH

In the template `@options FUNCTION but NAME...@`, on a line of its own, stands for the keywords of default_options(FUNCTION)
without those named, and `@type FUNCTION NAME@` for the type of one of them.
"""
import re
import sys
import textwrap
from pathlib import Path

from augicp import _augicp

WIDTH = 120


def keywords(match):
    indent, function, left_out = match[1], match[2], (match[3] or "").split()
    listed = [f"{name}: {kind} = ..." for name, kind in _augicp._option_types(function).items() if name not in left_out]
    glued = ", ".join(text.replace(" ", "\0") for text in listed)  # a keyword stays on one line
    lines = textwrap.wrap(glued, WIDTH - 1, initial_indent=indent, subsequent_indent=indent)
    return "\n".join(lines).replace("\0", " ")


def main():
    template, output = map(Path, sys.argv[1:])
    text = re.sub(r"^( *)@options (\w+)(?: but ([\w ]+))?@", keywords, template.read_text(), flags=re.MULTILINE)
    text = re.sub(r"@type (\w+) (\w+)@", lambda match: _augicp._option_types(match[1])[match[2]], text)
    output.write_text(text)


if __name__ == "__main__":
    main()
