#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The filter that shows comments to doxygen, the page of the command, and the check of the built site, without building it.

    site_test.py PROJECT
"""
import re
import sys
import unittest
from pathlib import Path

PROJECT = Path(sys.argv[1])
sys.path.insert(0, str(PROJECT / "docs/site"))
import check  # noqa: E402
import command_page  # noqa: E402
import doxygen_filter  # noqa: E402
import pages  # noqa: E402


def unmarked(text):
    """Without what the filter adds."""
    text = re.sub(r"///<?( ?)", r"//\1", text)
    return re.sub(r"\\([<>@\\#%&])", r"\1", re.sub(r"</?tt>", "`", text))


class FilterTest(unittest.TestCase):
    def test_nothing_but_marks_is_changed_in_the_public_headers(self):
        for header in pages.public_headers():
            text = (PROJECT / "src" / header).read_text(encoding="utf-8")
            shown = doxygen_filter.filtered(text)
            strip = re.compile(r"[ \t]+$", re.MULTILINE)
            self.assertEqual(strip.sub("", unmarked(shown)), strip.sub("", text), header)

    def test_comments_before_and_behind_declarations_are_shown(self):
        self.assertEqual(doxygen_filter.filtered("// What it is.\n// More `code`, a < b.\nstruct A {\n  int x = 0;  // metres\n};"),
                         "/// What it is.\n/// More <tt>code</tt>, a \\< b.\nstruct A {\n  int x = 0;  ///< metres\n};")
        self.assertEqual(doxygen_filter.filtered("int x;  // metres,\n        // in a\nint y;"), "int x;  ///< metres,\n        ///< in a\nint y;")

    def test_comments_of_the_file_stay(self):
        for text in ("// SPDX-License-Identifier: MIT\n#pragma once\n", "// About the file.\n\nint x;", "// The end.\n}", "// Last."):
            self.assertEqual(doxygen_filter.filtered(text), text)

    def test_most_types_of_the_public_headers_have_a_comment(self):
        text = "\n".join(doxygen_filter.filtered((PROJECT / "src" / header).read_text(encoding="utf-8")) for header in pages.public_headers())
        self.assertGreater(text.count("///<"), 100)
        types = re.findall(r"^(.*)\n(?:template <[^\n]*>\n)?(?:class|struct|enum class) \w+ .*\{$", text, re.MULTILINE)
        self.assertGreater(sum(line.startswith("///") for line in types) / len(types), 0.5)


HELP = """Find the motion
Usage: augicp align [OPTIONS] source

Options:
  -h,--help                   Print this, see --quiet
  --source TEXT REQUIRED      T_a <b> | `c`


Method:
  --preset ENUM:{default,paper}=default
                              default, or paper
  --depth-scale FLOAT=that of the camera, or 5000
                              One metre
  --every UINT:INT in [1 - 9]=1
                              Every N-th
  --json TEXT:{-}             With -: to stdout
  --intensity,--no-intensity{false}
                              Brightness counts

Exit codes: 0 success.
  More of the same.
Examples:
  augicp align b.ply
"""


class CommandPageTest(unittest.TestCase):
    def test_every_option_has_its_values_default_and_text(self):
        parts = dict(command_page.sections(HELP))
        self.assertEqual(command_page.definitions(parts["Options"]),
                         ["`-h, --help`", ": Print this, see `--quiet`", "", "`--source TEXT`", ": T\\_a \\<b\\> \\| `c`", ""])
        self.assertEqual(command_page.definitions(parts["Method"]),
                         ["`--preset {default,paper}`, by default `default`", ": default, or paper", "",
                          "`--depth-scale FLOAT`, by default that of the camera, or 5000", ": One metre", "",
                          "`--every UINT`, by default `1`", ": Every N-th", "", "`--json {-}`", ": With -: to stdout", "",
                          "`--intensity, --no-intensity`", ": Brightness counts", ""])

    def test_what_follows_the_options_is_text_and_examples_are_code(self):
        titles = [title for title, _ in command_page.sections(HELP)]
        self.assertEqual(titles, [None, "Options", "Method", None, "Examples"])
        last = command_page.sections(HELP)[-1]
        self.assertEqual(command_page.part_of(*last, ["augicp", "align"]), ["Examples:", "", "```sh", "augicp align b.ply", "```", ""])


class PagesTest(unittest.TestCase):
    def test_links_to_what_is_no_page_become_text(self):
        text = "[a](b.md#c) [code](../src/x.h) `[no](y.h)` ![p](q.png) [w](https://x.y)\n```sh\n[k](z.h)\n```\n"
        self.assertEqual(pages.resolved(text, "docs/a.md", {"docs/b.md"}),
                         "[a](b.md#c) code `[no](y.h)` ![p](q.png) [w](https://x.y)\n```sh\n[k](z.h)\n```\n")

    def test_the_check_finds_what_it_is_for(self):
        check.check_self()


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
