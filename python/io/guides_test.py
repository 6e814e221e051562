# SPDX-License-Identifier: MIT
"""Every block of Python in the README and the guides runs as it stands, pasted one after the other where its files are."""
import doctest
import importlib.util
import re
import shutil
import sys
import types

import numpy as np
import pytest

import augicp
from conftest import DESK, PROJECT
from scans_test import message_of, write_mcap

PAGES = {"README.md": 1, "docs/python.md": 5, "docs/moving.md": 1}  # the least number of blocks
pytestmark = pytest.mark.skipif(not (PROJECT / "docs").exists(), reason="the guides are not beside the tests")


def blocks(page):
    """Indented blocks that call the module. C++ has augicp:: in its place."""
    text = (PROJECT / page).read_text(encoding="utf-8")
    indented = re.findall(r"(?:^    .*\n|^\n(?=    ))+", text, re.MULTILINE)
    return [re.sub("^    ", "", block, flags=re.MULTILINE) for block in indented if re.search(r"\baugicp\.\w+\(", block)]


class Bar:
    """What the guide uses of tqdm, where that is not installed."""
    n = 0

    def __enter__(self):
        return self

    def __exit__(self, *_):
        assert self.n > 0

    def set_description(self, text):
        assert isinstance(text, str)

    def reset(self, total):
        self.n, self.total = 0, total

    def update(self, more):
        self.n += more


@pytest.fixture
def desk_with_files(tmp_path, monkeypatch, room):
    """The names and files that the guides leave to their reader."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "data").symlink_to(PROJECT / "data")
    shutil.copy(DESK / "groundtruth.txt", tmp_path)
    sequence = augicp.read_depth_sequence(DESK)[:3]
    shutil.copy(sequence[0][1], "1.png")
    write_mcap(tmp_path / "drive.mcap", {"/points": [message_of(k, with_times=True) for k in range(3)]})
    if importlib.util.find_spec("tqdm") is None:
        monkeypatch.setitem(sys.modules, "tqdm", types.SimpleNamespace(tqdm=Bar))
    images = [(stamp, augicp.read_depth(path, 5000)) for stamp, path in sequence]
    in_values = [(stamp, np.nan_to_num(metres * 5000).astype(np.uint16)) for stamp, metres in images]
    points = room[0].points
    cloud = types.SimpleNamespace(points=points, normals=np.eye(3)[np.arange(len(points)) % 3], colors=np.ones((len(points), 3)) / 2)
    return {"source": points, "target": room[1].points, "image": in_values[0][1], "metres": images[0][1], "images": in_values,
            "K": np.array([[525, 0, 319.5], [0, 525, 239.5], [0, 0, 1]]), "cloud": cloud, "numpy": np, "augicp": augicp}


def run(block, names):
    examples = doctest.DocTestParser().get_examples(block)
    if not examples:
        exec(compile(block, "block", "exec"), names)
    for example in examples:
        if not example.want:
            exec(compile(example.source, "block", "single"), names)
        else:
            assert repr(eval(example.source, names)) == example.want.strip()


@pytest.mark.filterwarnings("ignore:.*drive.mcap")
@pytest.mark.parametrize("page", PAGES)
def test_blocks_run_as_they_stand(page, desk_with_files):
    found = blocks(page)
    assert len(found) >= PAGES[page]
    for block in found:
        run(block, desk_with_files)


def test_a_wrong_block_fails(desk_with_files):
    for block in ("augicp.aline(source, target)\n", ">>> bool(augicp.align(source, target))\nFalse\n"):
        with pytest.raises((AttributeError, AssertionError)):
            run(block, dict(desk_with_files))
