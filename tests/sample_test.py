#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks that the sample in data/ is whole, and that scripts/summarize-alignment measures errors rightly.

    sample_test.py ROOT
"""
import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(sys.argv[1])
SEQUENCE = ROOT / "data/tum_fr1_desk_30"
TRUTH = ROOT / "data/room_pair/T_target_source.txt"
IDENTITY = [[float(row == column) for column in range(4)] for row in range(4)]
MAX_BYTES = 8_000_000  # of data/, so that a clone stays small


def rows(path):
    return [line.split() for line in path.read_text().splitlines() if not line.startswith("#")]


def test_images_are_there_in_order_and_inside_the_truth():
    images = rows(SEQUENCE / "depth.txt")
    stamps = [float(stamp) for stamp, _ in images]
    poses = rows(SEQUENCE / "groundtruth.txt")
    assert len(images) == 30 and stamps == sorted(stamps)
    assert float(poses[0][0]) < stamps[0] - 0.4 and stamps[-1] + 0.4 < float(poses[-1][0])
    for _, name in images:
        header = (SEQUENCE / name).read_bytes()[:26]
        assert header[:8] == b"\x89PNG\r\n\x1a\n", name
        assert struct.unpack(">IIBB", header[16:26]) == (640, 480, 16, 0), name  # 16 bits, grey


def test_scans_hold_what_they_declare():
    for name in ("source.ply", "target.ply"):
        content = (ROOT / "data/room_pair" / name).read_bytes()
        header, points = content.split(b"end_header\n", 1)
        assert b"binary_little_endian" in header and len(points) == 12 * 25392, name


def test_sample_is_small():
    assert sum(path.stat().st_size for path in (ROOT / "data").rglob("*") if path.is_file()) < MAX_BYTES


def summary(transform, *options):
    result = {"status": "converged", "iterations": 3, "num_pairs": 10, "T_target_source": transform}
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(result, file)
        file.flush()
        command = [sys.executable, ROOT / "scripts/summarize-alignment", file.name, *options]
        return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def test_error_is_the_motion_left():
    exact = [[float(value) for value in row] for row in rows(TRUTH)]
    assert "error      0.0000 m  0.000 deg" in summary(exact, "--truth", TRUTH)
    assert "error      0.3354 m  14.988 deg" in summary(IDENTITY, "--truth", TRUTH)


# 5.993 degrees and 6.9 cm: under this motion 90 % of the source's points lie within 2 cm of the target's depth; under its
# inverse 3 % do.
def test_truth_of_a_sequence():
    images = [name for _, name in rows(SEQUENCE / "depth.txt")]
    assert "error      0.0000 m  0.000 deg" in summary(IDENTITY, "--sequence", SEQUENCE, images[4], images[4])
    assert "error      0.0691 m  5.993 deg" in summary(IDENTITY, "--sequence", SEQUENCE, images[10], images[5])


if __name__ == "__main__":
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            test()
            print(name, "passed")
