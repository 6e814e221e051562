#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lays out the sources of the documentation site: the guides with their links resolved, and the pages that are made.

    pages.py OUTPUT AUGICP REPORTS

OUTPUT gets the sources for Sphinx. AUGICP is the command, whose help texts become its page. REPORTS is a folder of HTML reports,
with a line `file<tab>title<tab>text` each in gallery.tsv.
"""
import html
import re
import shutil
import sys
from pathlib import Path

import command_page

PROJECT = Path(__file__).resolve().parents[2]
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")
CODE = re.compile(r"(^```.*?^```$|`[^`\n]*`)", re.MULTILINE | re.DOTALL)
START = ["install", "python", "tutorials/README", "moving"]
OTHER_PAGES = ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "SECURITY.md", "data/README.md", "packaging/README.md",
               "benchmarks/peers/README.md")


def sources():
    """The documents of the site, by their place in the project. Indented blocks alone are code in them, and fences."""
    found = [path for path in (PROJECT / "docs").rglob("*.md") if "site" not in path.relative_to(PROJECT / "docs").parts]
    found += [PROJECT / name for name in OTHER_PAGES if (PROJECT / name).exists()]
    found += sorted((PROJECT / "experiments").rglob("*.md"))
    return {path.relative_to(PROJECT).as_posix() for path in found}


def resolved(text, place, known):
    """Links to what is no page of the site become their text: the files of the project are beside the reader of a clone alone."""
    def replace(match):
        mark, words, target = match.groups()
        name, _, _ = target.partition("#")
        if re.match(r"\w+:", target) or not name:
            return match[0]
        path = (PROJECT / place).parent / name
        relative = Path(*path.resolve().relative_to(PROJECT).parts).as_posix()
        return match[0] if mark or relative in known else words

    parts = CODE.split(text)
    return "".join(part if number % 2 else LINK.sub(replace, part) for number, part in enumerate(parts))


def copy_pages(output):
    known = sources()
    for place in known:
        target = output / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(resolved((PROJECT / place).read_text(encoding="utf-8"), place, known), encoding="utf-8")
    shutil.copytree(PROJECT / "docs/images", output / "docs/images")
    for image in (PROJECT / "docs").rglob("*.png"):
        copy = output / image.relative_to(PROJECT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(image, copy)


def toctree(caption, names):
    return "\n".join(["```{toctree}", f":caption: {caption}", ":maxdepth: 1", "", *names, "```", ""])


def write_index(output):
    guides = sorted(path.stem for path in (PROJECT / "docs").glob("*.md"))
    start = [f"docs/{name}" for name in START]
    others = sorted(place.removesuffix(".md") for place in sources() if not place.startswith("docs/") and place != "README.md")
    text = "# augicp\n\n```{include} README.md\n:start-after: '# augicp'\n:relative-images:\n:relative-docs: .\n```\n\n"
    text += toctree("Start", start + ["gallery"])
    text += toctree("Guides", [f"docs/{name}" for name in guides if name not in START])
    text += toctree("Reference", ["reference/command", "reference/python", "reference/cpp"])
    text += toctree("Project", ["docs/lab/README", *others])
    (output / "index.md").write_text(text, encoding="utf-8")
    write_children(output / "docs/lab/README.md", sorted(path.stem for path in (PROJECT / "docs/lab").glob("*.md")))
    write_children(output / "docs/tutorials/README.md", sorted(path.stem for path in (PROJECT / "docs/tutorials").glob("*.md")))
    (output / "README.md").write_text("---\norphan: true\n---\n" + (output / "README.md").read_text(encoding="utf-8"), encoding="utf-8")


def write_children(page, names):
    with page.open("a", encoding="utf-8") as file:
        file.write("\n```{toctree}\n:hidden:\n\n" + "\n".join(name for name in names if name != "README") + "\n```\n")


def write_command(output, command):
    (output / "reference").mkdir(parents=True)
    (output / "reference/command.md").write_text(command_page.page(command), encoding="utf-8")


def write_python(output):
    text = ("# Python\n\nUnits are metres, radians and seconds. [The guide](../docs/python.md) has the rules for arrays, threads "
            "and errors.\n\n```{eval-rst}\n.. automodule:: augicp\n\n")
    from augicp import __all__ as names
    import augicp
    for name in names:
        item = getattr(augicp, name)
        text += f".. autoclass:: augicp.{name}\n   :members:\n\n" if isinstance(item, type) else f".. autofunction:: augicp.{name}\n\n"
    (output / "reference/python.md").write_text(text + "```\n", encoding="utf-8")


def public_headers():
    """augicp.h and what it includes, as CMake computes what is installed."""
    found, waiting = [], ["augicp/augicp.h"]
    while waiting:
        header = waiting.pop()
        if header in found:
            continue
        found.append(header)
        text = (PROJECT / "src" / header).read_text(encoding="utf-8")
        waiting += re.findall(r'^#include "(augicp/[\w./]+)"', text, re.MULTILINE)
    names = [Path(header).name for header in found]
    assert len(set(names)) == len(names), "breathe finds files by their names alone"
    return sorted(found)


def write_cpp(output):
    modules = {}
    for header in public_headers():
        modules.setdefault(header.split("/")[1] if header.count("/") > 1 else "", []).append(header)
    modules.pop("")
    (output / "reference/cpp").mkdir()
    lead = "# C++\n\nThe headers that are installed, by module; `augicp/augicp.h` includes all.\n\n"
    (output / "reference/cpp.md").write_text(lead + toctree("Modules", [f"cpp/{name}" for name in modules]), encoding="utf-8")
    for name, headers in modules.items():
        text = f"# {name}\n\n"
        for header in headers:
            text += f"## {header}\n\n```{{eval-rst}}\n.. doxygenfile:: {Path(header).name}\n   :sections: briefdescription detaileddescription innerclass "
            text += "innernamespace enum typedef var func public-type public-attrib public-func public-static-func public-static-attrib\n```\n\n"
        (output / f"reference/cpp/{name}.md").write_text(text, encoding="utf-8")


def write_gallery(output, reports):
    cards = ""
    (output / "extra/reports").mkdir(parents=True)
    for line in (reports / "gallery.tsv").read_text(encoding="utf-8").splitlines():
        file, title, text = line.split("\t")
        shutil.copy(reports / file, output / "extra/reports" / file)
        cards += f'<a href="reports/{file}"><strong>{html.escape(title)}</strong><br>{html.escape(text)}</a>\n'
    text = f"# Gallery\n\nReports that the command has written of the samples: live, and complete in one file each.\n\n" \
           f'```{{raw}} html\n<div class="gallery">\n{cards}</div>\n```\n'
    (output / "gallery.md").write_text(text, encoding="utf-8")


def main():
    output, command, reports = (Path(word).resolve() for word in sys.argv[1:])
    shutil.rmtree(output, ignore_errors=True)
    output.mkdir(parents=True)
    copy_pages(output)
    write_index(output)
    write_command(output, command)
    write_python(output)
    write_cpp(output)
    write_gallery(output, reports)
    for name in ("conf.py", "_static"):
        source = PROJECT / "docs/site" / name
        shutil.copytree(source, output / name) if source.is_dir() else shutil.copy(source, output / name)
    print(*(str(PROJECT / "src" / header) for header in public_headers()), sep="\n", file=(output.parent / "headers.txt").open("w"))


if __name__ == "__main__":
    main()
