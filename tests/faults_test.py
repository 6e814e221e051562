#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""robustness 9: if an output cannot be written, the command reports it, ends with 3, and leaves nothing partial.

    faults_test.py AUGICP PROJECT
"""
import contextlib
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
ROOM = (PROJECT / "data/room_pair/source.ply", PROJECT / "data/room_pair/target.ply")
DESK = (PROJECT / "data/tum_fr1_desk_30", "--camera", "tum-fr1")
SMALL = ("synthetic", "--points", 500, "--seeds", 1, "--iterations", 2)
FRAMES = ("--pixel-step", 4, "--pairs", 1, "--gaps", 1, "--methods", "augmented")

# Each option that names a file to write, with the rest of a short run of its subcommand.
OUTPUTS = (
    (("align", *ROOM), "--json"), (("align", *ROOM), "--transform"), (("align", *ROOM), "--output"), (("align", *ROOM), "--report"),
    (("surface", ROOM[0]), "--output"), (("info", ROOM[0]), "--json"),
    (("evaluate", DESK[0] / "groundtruth.txt", DESK[0] / "groundtruth.txt"), "--json"),
    (("experiment", *SMALL), "--output"), (("experiment", *SMALL), "--report"),
    (("experiment", "sequence", *DESK, *FRAMES), "--curves"),
    (("experiment", "basin", *ROOM, "--angles-deg", 1, "--distances", 0, "--starts", 1), "--output"),
    (("experiment", "verdict", *DESK, "--gaps", 29), "--table"), (("experiment", "verdict", *DESK, "--gaps", 29), "--roc"))


def run(*words):
    return subprocess.run([str(AUGICP), *map(str, words)], capture_output=True, text=True, timeout=250, check=False)


@contextlib.contextmanager
def mounted(folder, options):
    """A separate file system; without the right to make one, the test is skipped with a message."""
    made = subprocess.run(["mount", "-t", "tmpfs", "-o", options, "augicp-test", folder], capture_output=True, check=False)
    if made.returncode != 0:
        raise unittest.SkipTest("a small file system needs root")
    try:
        yield
    finally:
        subprocess.run(["umount", folder], check=True)


class FaultsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="augicp-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def check_refused(self, words, path):
        finished = run(*words, path)
        self.assertEqual(finished.returncode, 3, f"{words}: {finished.stderr}")
        self.assertIn(str(path), finished.stderr)
        self.assertEqual(len(finished.stderr.splitlines()), 1, finished.stderr)

    def test_a_directory_in_the_place_of_an_output(self):
        for words, option in OUTPUTS:
            path = self.folder / "taken.ply"
            path.mkdir(exist_ok=True)
            self.check_refused((*words, option), path)
            self.assertEqual(list(self.folder.iterdir()), [path])

    def test_no_folder_for_an_output(self):
        for words, option in OUTPUTS:
            self.check_refused((*words, option), self.folder / "missing" / "output.ply")
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_a_full_device(self):
        full = self.folder / "full.ply"  # the name decides the format
        full.symlink_to("/dev/full")
        for words, option in OUTPUTS:
            self.check_refused((*words, option), full)

    def test_a_full_disk(self):
        with mounted(self.folder, "size=64k"):
            kept = self.folder / "output.ply"
            kept.write_text("of an earlier run")
            (self.folder / "filling").write_bytes(bytes(56 * 1024))  # leaves room for a name, not for a result
            for words, option in OUTPUTS:
                finished = run(*words, option, kept)
                if finished.returncode == 0:  # as little as fits the last page
                    self.assertLessEqual(kept.stat().st_size, 4096, words)
                    kept.write_text("of an earlier run")
                self.assertIn(finished.returncode, (0, 3), finished.stderr)
                self.assertEqual(kept.read_text(), "of an earlier run", (words, option))
                self.assertEqual(len(list(self.folder.iterdir())), 2, (words, option))
            self.assertEqual(run("surface", ROOM[0], "--output", kept).returncode, 3)
            self.assertEqual(run("odometry", *DESK, "--last", 30, "--output", self.folder / "run").returncode, 3)
            left = self.folder / "run"  # a run that failed before its first file leaves no folder
            self.assertLessEqual({path.name for path in left.iterdir()} if left.exists() else set(), {"config.toml", "trajectory.txt"})

    def test_a_folder_that_is_read_only(self):
        with mounted(self.folder, "size=64k,ro"):
            for words, option in OUTPUTS:
                self.check_refused((*words, option), self.folder / "output.ply")
            self.assertEqual(run("odometry", *DESK, "--last", 3, "--output", self.folder).returncode, 3)

    def test_a_folder_without_permission(self):
        if os.geteuid() == 0:
            self.skipTest("root may write everywhere")
        self.folder.chmod(0o500)
        for words, option in OUTPUTS:
            self.check_refused((*words, option), self.folder / "output.ply")
        self.folder.chmod(0o700)

    def test_an_option_is_no_file_name(self):
        for words, option in OUTPUTS:
            finished = run(*words, option, "--quiet")
            self.assertEqual(finished.returncode, 2, finished.stderr)
            self.assertIn("expected a value, found --quiet", finished.stderr)
        self.assertFalse(Path("--quiet").exists())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
