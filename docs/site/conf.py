# SPDX-License-Identifier: MIT
"""Sphinx's settings for the pages that pages.py has laid out. Built by scripts/docs."""
import os
import re
from pathlib import Path

PROJECT = Path(os.environ["AUGICP_PROJECT"])

project = "augicp"
author = copyright = "the augicp authors"
release = version = (PROJECT / "VERSION").read_text(encoding="utf-8").strip()
extensions = ["myst_parser", "sphinx.ext.autodoc", "breathe"]
myst_heading_anchors = 6
myst_enable_extensions = ["colon_fence", "deflist"]
# Each header opens the namespace again, and so declares it again.
suppress_warnings = ["myst.header", "misc.highlighting_failure", "duplicate_declaration.cpp"]
highlight_language = "none"
# Quotes and options are copied from the pages.
smartquotes = False
html_theme = "furo"
html_title = f"augicp {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sphinx = False
html_extra_path = ["extra"]
# The fonts of the reader's own system: no page asks for anything from elsewhere.
html_theme_options = {
    "light_css_variables": {"font-stack": "system-ui, sans-serif", "font-stack--monospace": "ui-monospace, monospace"},
    "footer_icons": [],
}
breathe_projects = {"augicp": os.environ["AUGICP_DOXYGEN_XML"]}
breathe_default_project = "augicp"
breathe_default_members = ("members",)
breathe_show_include = False
autodoc_member_order = "bysource"
autodoc_docstring_signature = True


def as_rst(app, what, name, item, options, lines):
    """Docstrings are plain text: paragraphs, lists of `name: text`, and tables of options."""
    text = "\n".join(lines).strip("\n")
    lines[:] = "\n\n".join(paragraph_as_rst(part.split("\n")) for part in re.split(r"\n\s*\n", text) if part.strip()).split("\n") + [""]


def paragraph_as_rst(lines):
    is_code = all(re.match(r"\s*>>>|\s*\.\.\. |\w+ {2,}\S", line) for line in lines)
    if is_code:
        return "\n".join(["::", "", *("   " + line.strip() for line in lines)])
    items, are_items = [], bool(re.match(r"\w+(, \w+)*: ", lines[0]))
    for line in lines:
        starts = are_items and re.match(r"(\w+(?:, \w+)*): (.*)", line)
        if starts:
            items.append(f"* **{escaped(starts[1])}**: {escaped(starts[2])}")
        elif items and line.startswith("  "):
            items[-1] += " " + escaped(line.strip())
        else:
            items.append(("\n" if are_items else "") + escaped(line.strip()))
    return "\n".join(items)


def escaped(text):
    parts = re.split(r"(``[^`]+``)", text)
    return "".join(part if number % 2 else re.sub(r"([\\*`_|])", r"\\\1", part) for number, part in enumerate(parts))


def setup(app):
    app.connect("autodoc-process-docstring", as_rst)
