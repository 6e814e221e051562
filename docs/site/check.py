#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks a built site: each link within it leads to a file and an anchor, and no page asks for anything from elsewhere.

    check.py FOLDER    prints each fault; exit code 1 if there is one

Links to other sites are followed by readers, not by pages, and are allowed.
"""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# Attributes whose address a browser fetches by itself.
FETCHED = {("img", "src"), ("script", "src"), ("iframe", "src"), ("source", "src"), ("video", "src"), ("audio", "src"), ("embed", "src"),
           ("object", "data"), ("link", "href"), ("img", "srcset"), ("source", "srcset")}
NOT_FETCHED_LINKS = {"next", "prev", "search", "index", "canonical", "author", "license", "help", "copyright"}
CSS_ADDRESS = re.compile(r"url\(\s*['\"]?([^'\")]+)|@import\s+['\"]([^'\"]+)")


class Page(HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.anchors, self.links, self.fetched, self.in_style = {""}, [], [], False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        self.in_style = tag == "style"
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        is_plain_link = tag == "link" and set((values.get("rel") or "").split()) & NOT_FETCHED_LINKS
        for name, value in attributes:
            if (tag, name) in FETCHED and value and not is_plain_link:
                self.fetched.append(value)
        self.fetched += [a or b for a, b in CSS_ADDRESS.findall(values.get("style") or "")]

    def handle_data(self, data):
        if self.in_style:
            self.fetched += [a or b for a, b in CSS_ADDRESS.findall(data)]
            self.in_style = False


def is_elsewhere(address):
    return address.startswith("//") or urlsplit(address).scheme not in ("", "data")


def faults(folder):
    pages = {path.resolve(): Page(path.read_text(encoding="utf-8")) for path in sorted(folder.rglob("*.html"))}
    for path, page in pages.items():
        where = path.relative_to(folder.resolve())
        for address in page.fetched:
            if is_elsewhere(address):
                yield f"{where}: asks for {address}"
        for link in page.links + [a for a in page.fetched if not a.startswith("data:")]:
            if is_elsewhere(link) or link.startswith("data:"):
                continue
            target = (path.parent / unquote(urlsplit(link).path)).resolve() if urlsplit(link).path else path
            target = target / "index.html" if target.is_dir() else target
            if not target.exists():
                yield f"{where}: {link} does not exist"
            elif target in pages and unquote(urlsplit(link).fragment) not in pages[target].anchors:
                yield f"{where}: {link}: no such place"
    for style in sorted(folder.rglob("*.css")):
        for found in CSS_ADDRESS.findall(style.read_text(encoding="utf-8")):
            address = found[0] or found[1]
            if is_elsewhere(address):
                yield f"{style.relative_to(folder)}: asks for {address}"


def check_self():
    """A page with one fault of each kind is found out."""
    import tempfile
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "a.html").write_text('<a href="b.html">x</a><a href="#no">x</a><a href="https://x.y">x</a><p id="here"></p>'
                                       '<a href="#here">x</a><img src="https://x.y/z.png"><style>p{background:url(//x.y/a)}</style>')
        (folder / "s.css").write_text("@import 'http://x.y/s.css'; p{background:url(data:image/png;base64,AA)}")
        expected = {"a.html: asks for https://x.y/z.png", "a.html: asks for //x.y/a", "a.html: b.html does not exist",
                    "a.html: #no: no such place", "s.css: asks for http://x.y/s.css"}
        found = set(faults(folder))
        assert found == expected, found ^ expected


def main():
    check_self()
    found = list(faults(Path(sys.argv[1])))
    print(*(found or ["every link leads somewhere, and no page asks for anything from elsewhere"]), sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
