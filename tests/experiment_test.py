#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The experiments of the paper in small: their order must hold, and they repeat bit for bit.

    experiment_test.py AUGICP PROJECT
"""
import csv
import io
import subprocess
import sys
import unittest
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
DESK = PROJECT / "data/tum_fr1_desk_30"
ROOM = PROJECT / "data/room_pair"


def run(*words):
    return subprocess.run([str(AUGICP), "experiment", *map(str, words)], capture_output=True, text=True, timeout=250, check=False)


def rows(*words):
    finished = run(*words)
    assert finished.returncode == 0, finished.stderr
    return list(csv.DictReader(io.StringIO(finished.stdout)))


def rotations(table, **kind):
    """Mean rotation error by iteration, degrees."""
    column = "rotation_deg_mean"
    return [float(row[column]) for row in table if all(row[name] == value for name, value in kind.items())]


SYNTHETIC = ("synthetic", "--points", 5000, "--seeds", 3, "--iterations", 8, "--outliers-percent", 50, "--point-noise", 0.01,
             "--normal-noise-deg", 5, "--kernel", 1000)
SEQUENCE = ("sequence", DESK, "--camera", "tum-fr1", "--gaps", "1,10", "--pairs", 5, "--pixel-step", 4, "--presets", "paper",
            "--time-offset", -0.03)


class ExperimentTest(unittest.TestCase):
    def test_synthetic_order(self):
        """Before they meet at the truth, that is in the first three iterations."""
        table = rows(*SYNTHETIC)
        point, gicp, augmented = (rotations(table, method=method) for method in ("point", "gicp", "augmented"))
        for i in (1, 2, 3):
            self.assertLess(augmented[i], gicp[i], i)
            self.assertLess(gicp[i], point[i], i)

    def test_sequence_order(self):
        """With the paper's weights and statistics, at gap 1, in the middle of the run: the first step is ruled by the guess's
        pairs, and at gap 10 five pairs are too few for a mean that single failures do not decide. Not with the default: its
        GICP has the same good normals' gates and weights, and stays within a hundredth of a degree."""
        table = rows(*SEQUENCE)
        gicp, augmented = (rotations(table, gap="1", method=method) for method in ("gicp", "augmented"))
        for i in (2, 3, 4):
            self.assertLess(augmented[i], gicp[i], i)

    def test_repeats_bit_for_bit(self):
        for words in (SYNTHETIC, (*SEQUENCE, "--methods", "augmented"),
                      ("basin", ROOM / "source.ply", ROOM / "target.ply", "--truth", ROOM / "T_target_source.txt",
                       "--angles-deg", "5,20", "--distances", 0.1, "--starts", 2, "--max-iterations", 20)):
            outputs = {run(*words, "--threads", threads).stdout for threads in (1, 3, 3)}
            self.assertEqual(len(outputs), 1)
            self.assertGreater(len(outputs.pop()), 60)

    def test_another_seed_is_another_run(self):
        self.assertNotEqual(run(*SYNTHETIC).stdout, run(*SYNTHETIC, "--seed", 7).stdout)

    def test_wrong_usage(self):
        cases = ((2, ()), (0, ("--help",)), (2, ("synthetic", "--outliers-percent", 120)), (2, ("sequence", DESK)),
                 (2, ("sequence", DESK, "--camera", "tum-fr1", "--gaps", 40)),
                 (2, ("sequence", DESK, "--camera", "tum-fr1", "--time-offset", "nan")),
                 (3, ("sequence", DESK / "nowhere", "--camera", "tum-fr1")),
                 (3, ("basin", ROOM / "source.ply", ROOM / "nothing.ply")))
        for code, words in cases:
            self.assertEqual(run(*words).returncode, code, words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
