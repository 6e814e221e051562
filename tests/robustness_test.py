#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Each row of the robustness promises is named by a test, and the tests that docs/reliability.md names for a row name it.

    robustness_test.py ROOT

A test names its rows in a comment: "robustness 12: corridor", "robustness 1, 7", "robustness 1 to 7".
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

ROOT = Path(sys.argv[1])
NUM_ROWS = 18
TESTS = ("src/augicp/*/*_test.cpp", "tests/*.py", "python/**/*_test.py")
MENTION = re.compile(r"robustness ?(\d+)(?: to (\d+))?((?:, ?\d+)*)", re.IGNORECASE)
TABLE_ROW = re.compile(r"^\| (\d+) \|(.*)\|$", re.MULTILINE)


def rows_of(text):
    rows = set()
    for first, last, others in MENTION.findall(text):
        rows.update(range(int(first), int(last or first) + 1), map(int, re.findall(r"\d+", others)))
    return rows


def files_naming():
    naming = defaultdict(set)
    for pattern in TESTS:
        for path in ROOT.glob(pattern):
            if path.resolve() == Path(__file__).resolve():
                continue
            for row in rows_of(path.read_text()):
                naming[row].add(path.relative_to(ROOT).as_posix().removeprefix("src/augicp/"))
    return naming


def test_mentions_are_read():
    assert rows_of("// robustness 3") == {3}
    assert rows_of("# Robustness13, robustness 1, 7: both") == {13, 1, 7}
    assert rows_of("robustness 1 to 4") == {1, 2, 3, 4}
    assert rows_of("the robustness of 5") == set()


def test_each_row_is_named():
    naming = files_naming()
    missing = set(range(1, NUM_ROWS + 1)) - set(naming)
    assert not missing, f"no test names {sorted(missing)}"
    assert set(naming) <= set(range(1, NUM_ROWS + 1)), "a test names a row that there is not"


def test_the_table_is_true():
    naming = files_naming()
    section = (ROOT / "docs/reliability.md").read_text().split("## Rows and their tests", 1)[1]
    table = {int(number): set(re.findall(r"`([^`]+_test\.(?:cpp|py))`", cells)) for number, cells in TABLE_ROW.findall(section)}
    assert sorted(table) == list(range(1, NUM_ROWS + 1)), sorted(table)
    for row, files in table.items():
        assert files, f"row {row} names no test"
        assert files <= naming[row], f"row {row}: {sorted(files - naming[row])} do not name it"


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
