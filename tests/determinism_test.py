#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""robustness 16: the same input gives the same bytes, on any number of threads and in every process.

    determinism_test.py AUGICP AUGICP_WITH_THREADS PROJECT

The second program starts as many threads as it is asked to: the first never has more than the machine has cores.
"""
import csv
import io
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAMS, PROJECT = sys.argv[1:3], Path(sys.argv[3])
ROOM = (PROJECT / "data/room_pair/source.ply", PROJECT / "data/room_pair/target.ply")
DESK = (PROJECT / "data/tum_fr1_desk_30", "--camera", "tum-fr1")
IMAGES = tuple(DESK[0] / "depth" / name for name in ("1305031455.374120.png", "1305031455.210307.png"))
NUMBERS_OF_THREADS = (1, 2, 3, 4, 8, 16, 64)


def without_times(path):
    """The bytes of a result, except its times, number of threads and path."""
    content = path.read_bytes()
    if path.suffix == ".json":
        result = json.loads(content)
        for name in ("timing_ms", "frames_per_s"):
            result.pop(name, None)
        result.get("options", {}).pop("threads", None)
        return json.dumps(result)
    if path.name == "frames.csv":
        rows = list(csv.reader(io.StringIO(content.decode())))
        column = rows[0].index("time_ms")
        return [row[:column] + row[column + 1:] for row in rows]
    if path.name == "config.toml":
        return None
    return content


def results(program, threads, words):
    """The contents of the files that a run writes into its own folder; FOLDER in words stands for it."""
    with tempfile.TemporaryDirectory(prefix="augicp-") as name:
        arguments = [str(word).replace("FOLDER", name) for word in words]
        finished = subprocess.run([program, *arguments, "--threads", str(threads)], capture_output=True, text=True,
                                  timeout=250, check=False)
        files = {path.name: without_times(path) for path in sorted(Path(name).iterdir())}
    assert files and finished.returncode == 0, finished.stderr
    return files


class DeterminismTest(unittest.TestCase):
    def check(self, *words):
        expected = results(PROGRAMS[0], 1, words)
        for program in PROGRAMS:
            for threads in NUMBERS_OF_THREADS:
                found = results(program, threads, words)
                differing = [name for name in expected if found.get(name) != expected[name]]
                self.assertEqual((sorted(found), differing), (sorted(expected), []), (program, threads, words))

    def test_addresses_are_random(self):
        """Otherwise an order by address would be the same in all processes, and not be seen."""
        self.assertEqual(Path("/proc/sys/kernel/randomize_va_space").read_text().strip(), "2")

    def test_align_scans(self):
        self.check("align", *ROOM, "--trace", "--json", "FOLDER/result.json", "--transform", "FOLDER/T.txt", "--output",
                   "FOLDER/moved.ply")

    def test_align_images(self):
        self.check("align", *IMAGES, "--camera", "tum-fr1", "--trace", "--json", "FOLDER/result.json")

    def test_surface(self):
        self.check("surface", ROOM[0], "--output", "FOLDER/scan.ply")
        self.check("surface", IMAGES[0], "--camera", "tum-fr1", "--output", "FOLDER/image.ply")

    def test_odometry(self):
        self.check("odometry", *DESK, "--last", 5, "--output", "FOLDER")

    def test_experiments(self):
        self.check("experiment", "synthetic", "--points", 5000, "--seeds", 1, "--iterations", 4, "--output", "FOLDER/rows.csv")
        self.check("experiment", "sequence", *DESK, "--pixel-step", 4, "--pairs", 2, "--gaps", 3, "--methods", "augmented",
                   "--curves", "FOLDER/curves.csv", "--output", "FOLDER/rows.csv")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
