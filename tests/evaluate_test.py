#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`augicp evaluate` against an independent computation, on real and made trajectories; its messages and exit codes.

    evaluate_test.py AUGICP PROJECT
"""
import itertools
import json
import math
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

import evaluation_reference as reference

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
SAMPLE = PROJECT / "data/tum_fr1_desk_30/groundtruth.txt"
MORE_TRUTHS = sorted((PROJECT / "../shared/data/tum").resolve().glob("*/groundtruth.txt"))
KITTI = (PROJECT / "../shared/data/formats/kitti_trajectories").resolve()
TOLERANCE = 1e-9  # metres, and degrees
OPTIONS = [words for align, rpe in itertools.product(
    ("none", "origin", "rigid", "similarity"),
    (("--delta", 1), ("--delta", 10), ("--delta", 0.5, "--unit", "seconds"), ("--delta", 0.2, "--unit", "metres")))
    for words in (("--align", align, *rpe), ("--align", align, *rpe, "--consecutive"))]


def run(*words):
    return subprocess.run([str(AUGICP), "evaluate", *map(str, words)], capture_output=True, text=True, timeout=120, check=False)


def quaternion(rotation):
    """x y z w of a rotation matrix by less than pi."""
    w = math.sqrt(1 + np.trace(rotation)) / 2
    return np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1],
                     4 * w * w]) / (4 * w)


def turn(axis, angle):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def motion(axis=(0, 0, 1), angle=0.0, translation=(0, 0, 0)):
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = turn(axis, angle), translation
    return matrix


def wandering(rate, duration):
    """(stamps, poses) of a smooth walk that never turns far."""
    stamps = np.arange(round(rate * duration)) / rate
    return stamps + 100.0, [motion((math.sin(t), 1, math.cos(2 * t)), 0.4 * math.sin(t), (math.cos(t), t / 3, math.sin(2 * t)))
                            for t in stamps]


def with_smooth_error(stamps, poses, seed):
    """The poses with a drift and a slow wobble, in the camera's frame."""
    generator = np.random.default_rng(seed)
    axis, direction, phase = generator.normal(size=3), generator.normal(size=3), generator.uniform(0, 6)
    wobble = 0.02 * np.sin(3 * (stamps - stamps[0]) + phase) + 0.005 * (stamps - stamps[0])
    return [pose @ motion(axis, share, share * direction) for pose, share in zip(poses, wobble)]


class EvaluateTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="augicp wörk ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def write(self, name, stamps, poses):
        lines = [" ".join(map(repr, map(float, (stamp, *pose[:3, 3], *quaternion(pose[:3, :3])))))
                 for stamp, pose in zip(stamps, poses)]
        (self.folder / name).write_text("\n".join(lines) + "\n")
        return self.folder / name

    def evaluate(self, *words):
        """The JSON; what the errors leave out is warned of, and nothing else."""
        finished = run(*words, "--json", "-")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        found = json.loads(finished.stdout)
        counts = ("num_outside", "num_unmatched", "num_holes", "num_repeated_estimate", "num_repeated_truth")
        expected = sum(result.get(count, 0) > 0 for result in [found, *found.get("others", [])] for count in counts)
        self.assertEqual(finished.stderr.count("augicp: warning: "), expected, finished.stderr)
        self.assertEqual(len(finished.stderr.splitlines()), expected)
        return found

    def assert_same(self, found, expected, where):
        """All that is expected is found, numbers to within the tolerance."""
        if isinstance(expected, dict):
            for key, value in expected.items():
                self.assert_same(found[key], value, f"{where}.{key}")
        elif expected is None:
            self.assertIsNone(found, where)
        else:
            np.testing.assert_allclose(found, expected, rtol=TOLERANCE, atol=TOLERANCE, err_msg=where)

    def compare(self, estimate, truth, *words):
        found = self.evaluate(estimate, truth, *words)
        self.assert_same(found, reference.evaluate(estimate, truth, found["options"]), str(words))
        return found

    def disturbed(self, truth, every, seed):
        stamps, poses = reference.read(truth)
        stamps, poses = stamps[::every] + 0.002, poses[::every]
        moved = motion((1, 2, 3), 0.5, (3, -2, 1))
        # Back in the truth's own orientation, where all turns of TUM's cameras are: a quaternion needs w > 0 above.
        level = [np.linalg.inv(poses[0]) @ pose for pose in with_smooth_error(stamps, poses, seed)]
        return self.write("estimate.txt", stamps, [moved @ pose for pose in level])

    def test_sample_agrees_with_the_reference(self):
        estimate = self.disturbed(SAMPLE, 3, 1)
        for words in OPTIONS:
            found = self.compare(estimate, SAMPLE, *words)
            self.assertEqual(found["num_matched"], found["num_estimate"])
            self.assertGreater(found["rpe"]["translation"]["count"], 1)

    def test_interpolated_truth_agrees_with_the_reference(self):
        estimate = self.disturbed(SAMPLE, 3, 2)
        for unit in ("frames", "seconds", "metres"):
            self.compare(estimate, SAMPLE, "--truth", "interpolated", "--delta", 1, "--unit", unit)
        # Between the poses 8.9 to 11.2 ms apart some gaps are too long.
        found = self.compare(estimate, SAMPLE, "--truth", "interpolated", "--max-difference", 0.005)
        self.assertTrue(0 < found["num_matched"] < found["num_estimate"])

    def test_other_truths_agree_with_the_reference(self):
        if not MORE_TRUTHS:
            self.skipTest("no further TUM sequences beside the project")
        for seed, truth in enumerate(MORE_TRUTHS):
            estimate = self.disturbed(truth, 3, seed)
            for words in OPTIONS[::3]:
                self.compare(estimate, truth, *words)

    def test_pure_offset(self):
        stamps, poses = wandering(30, 4)
        truth = self.write("truth.txt", stamps, poses)
        estimate = self.write("estimate.txt", stamps, [motion(translation=(0.3, 0, -0.4)) @ pose for pose in poses])
        found = self.compare(estimate, truth)
        for key in ("rmse", "mean", "median", "min", "max"):
            self.assertAlmostEqual(found["ate"]["translation"][key], 0.5, 12)
            self.assertAlmostEqual(found["ate_aligned"]["translation"][key], 0, 12)
            self.assertAlmostEqual(found["rpe"]["translation"][key], 0, 12)

    def test_pure_rotation(self):
        stamps, poses = wandering(30, 4)
        truth = self.write("truth.txt", stamps, poses)
        estimate = self.write("estimate.txt", stamps, [motion((1, 1, 0), 0.3) @ pose for pose in poses])
        found = self.compare(estimate, truth)
        for key in ("rmse", "mean", "median", "min", "max"):
            self.assertAlmostEqual(found["ate"]["rotation_deg"][key], math.degrees(0.3), 10)
            self.assertAlmostEqual(found["ate_aligned"]["rotation_deg"][key], 0, 10)
            self.assertAlmostEqual(found["rpe"]["rotation_deg"][key], 0, 10)

    def test_missing_poses(self):
        stamps, poses = wandering(30, 4)
        truth = self.write("truth.txt", np.delete(stamps, range(60, 75)), np.delete(poses, range(60, 75), axis=0))
        poses = with_smooth_error(stamps, poses, 4)
        estimate = self.write("estimate.txt", np.delete(stamps, (3, 4, 62, 63)), np.delete(poses, (3, 4, 62, 63), axis=0))
        for words in OPTIONS:
            found = self.compare(estimate, truth, *words)
            self.assertEqual((found["num_estimate"], found["num_truth"], found["num_matched"]), (116, 105, 103))
            self.assertAlmostEqual(found["matched_share"], 103 / 116)
            counts = [found[name] for name in ("num_outside", "num_unmatched", "num_holes", "num_missing")]
            self.assertEqual(counts, [0, 13, 2, 4])
            self.assertAlmostEqual(found["longest_hole_s"], 0.1, 6)
        errors = run(estimate, truth).stderr
        self.assertIn("13 poses have no true pose of the same moment", errors)
        self.assertIn("about 4 poses are missing in 2 holes, the longest of 0.1 s", errors)

    def test_poses_outside_of_the_truth_s_time(self):
        stamps, poses = wandering(30, 4)
        estimate, truth = self.write("estimate.txt", stamps, poses), self.write("truth.txt", stamps[20:-5], poses[20:-5])
        finished = run(estimate, truth, "--json", "-")
        found = json.loads(finished.stdout)
        self.assertEqual([found[name] for name in ("num_outside", "num_unmatched", "num_matched")], [25, 0, 95])
        self.assertIn("25 poses lie outside of the truth's time and are not compared", finished.stderr)
        shifted = self.evaluate(estimate, truth, "--time-offset", -stamps[5] + stamps[0])
        self.assertEqual(shifted["num_outside"], 25)
        whole = run(truth, truth)
        self.assertEqual(whole.stderr, "")

    def test_repeated_stamps_are_counted(self):
        lines = [line for line in SAMPLE.read_text().splitlines(keepends=True) if not line.startswith("#")]
        twice = self.folder / "twice.txt"
        twice.write_text("".join(lines[:5] + lines[2:5][-1:] + lines[5:] + lines[-1:]))
        found = self.evaluate(twice, SAMPLE)
        self.assertEqual((found["num_repeated_estimate"], found["num_repeated_truth"]), (2, 0))
        self.assertEqual(found["num_estimate"], len(lines))
        self.assertIn("2 poses repeat the stamp before", run(twice, SAMPLE).stderr)
        beside = self.evaluate(SAMPLE, twice, "--beside", twice)
        self.assertEqual((beside["num_repeated_truth"], beside["others"][0]["num_repeated_estimate"]), (2, 2))

    def test_different_rates(self):
        truth = self.write("truth.txt", *wandering(97, 5))
        for rate in (7, 30, 97, 200):
            stamps, poses = wandering(rate, 6)
            estimate = self.write("estimate.txt", stamps + 40, with_smooth_error(stamps, poses, rate))
            for words in (("--unit", "seconds"), ("--unit", "metres", "--consecutive"), ("--max-difference", 0.004)):
                found = self.compare(estimate, truth, "--time-offset", -40, *words)
                self.assertLess(found["num_matched"], found["num_estimate"])

    def kitti_file(self, name, poses, stamps=()):
        rows = [[*before, *pose[:3].ravel()] for before, pose in zip([[s] for s in stamps] or [[]] * len(poses), poses)]
        np.savetxt(self.folder / name, rows, fmt="%.17g")
        return self.folder / name

    def assert_segments(self, found, expected):
        count, translation, rotation = expected
        self.assertEqual(found["num_segments"], count)
        self.assertAlmostEqual(found["translation_percent"], 100 * translation, 9)
        self.assertAlmostEqual(found["rotation_deg_per_100m"], 100 * math.degrees(rotation), 9)

    def test_kitti_s_segments_agree_with_the_reference(self):
        stamps, poses = wandering(30, 4)
        wrong = with_smooth_error(stamps, poses, 7)
        expected = reference.kitti_segments(wrong, poses, (0.5, 1, 2))
        truth = self.kitti_file("truth.txt", poses)
        for estimate in (self.kitti_file("estimate.txt", wrong), self.kitti_file("timed.txt", wrong, stamps),
                         self.write("tum.txt", stamps, wrong)):
            found = self.evaluate(estimate, truth, "--segments", "0.5,1,2")
            self.assertEqual(found["num_matched"], len(poses))
            self.assert_segments(found["segments"], expected)
            self.assertEqual([row["length_m"] for row in found["segments"]["lengths"]], [0.5, 1, 2])
        self.assertIsNone(self.evaluate(estimate, truth)["segments"])  # no 100 m
        short = self.kitti_file("short.txt", wrong[:-1])
        self.assertEqual(run(short, self.write("truth_tum.txt", stamps, poses)).returncode, 3)

    def test_kitti_00_agrees_with_the_reference(self):
        if not (KITTI / "KITTI_00_gt.txt").exists():
            self.skipTest("KITTI's trajectories are not beside the project")
        files = [KITTI / "KITTI_00_ORB.txt", KITTI / "KITTI_00_gt.txt"]
        estimate, truth = ([np.vstack([row.reshape(3, 4), [0, 0, 0, 1]]) for row in np.loadtxt(file)] for file in files)
        found = self.evaluate(*files)["segments"]
        count, translation, rotation = reference.kitti_segments(estimate, truth, range(100, 900, 100))
        self.assertEqual(found["num_segments"], count)
        self.assertAlmostEqual(found["translation_percent"], 100 * translation, 4)  # its files have few digits
        self.assertAlmostEqual(found["rotation_deg_per_100m"], 100 * math.degrees(rotation), 3)

    def test_known_motions_need_no_truth(self):
        stamps, poses = wandering(30, 4)
        pairs = [(0, 30), (30, 60), (0, 60), (60, 1000)]
        known = [np.linalg.inv(poses[i]) @ poses[min(j, len(poses) - 1)] for i, j in pairs]
        lines = [" ".join(map(repr, (i, j, *map(float, motion[:3, 3]), *map(float, quaternion(motion[:3, :3]))))) + " 0.2 nan"
                 for (i, j), motion in zip(pairs, known)]
        (self.folder / "pairs.txt").write_text("# i j ...\n" + "\n".join(lines) + "\n")
        exact = self.kitti_file("exact.txt", poses)
        wrong = with_smooth_error(stamps, poses, 8)
        found = self.evaluate(self.kitti_file("wrong.txt", wrong), "--pairs", self.folder / "pairs.txt", "--beside", exact)
        self.assertEqual([(row["gap"], row["num_pairs"]) for row in found["pairs"]], [(30, 2), (60, 1)])
        moved = np.linalg.inv(wrong[0]) @ wrong[60]
        error = np.linalg.norm((np.linalg.inv(known[2]) @ moved)[:3, 3])
        length = np.linalg.norm(known[2][:3, 3])
        self.assertAlmostEqual(found["pairs"][1]["translation_percent"], 100 * error / length, 9)
        self.assertAlmostEqual(found["pairs"][1]["bias_percent"], 100 * (np.linalg.norm(moved[:3, 3]) / length - 1), 9)
        for row in found["others"][0]["pairs"]:
            self.assertLess(row["translation_m"], 1e-9)
        text = run(self.folder / "wrong.txt", "--pairs", self.folder / "pairs.txt").stdout
        self.assertIn("3 of 4 are within the estimate", text)
        table = run(self.folder / "wrong.txt", "--pairs", self.folder / "pairs.txt", "--beside", exact).stdout.splitlines()
        self.assertEqual([Path(line.rsplit(None, 2)[0]).name for line in table[1:]], ["wrong.txt", "exact.txt"])

    def test_delta_longer_than_the_trajectory_gives_no_rpe(self):
        estimate = self.disturbed(SAMPLE, 3, 3)
        found = self.compare(estimate, SAMPLE, "--delta", 1000)
        self.assertIsNone(found["rpe"])
        self.assertIn("no two matched poses are 1000 frames apart", run(estimate, SAMPLE, "--delta", 1000).stdout)

    def test_text_and_files_say_what_the_json_says(self):
        estimate, written = self.disturbed(SAMPLE, 3, 5), self.folder / "errors.json"
        found = self.evaluate(estimate, SAMPLE)
        text = run(estimate, SAMPLE, "--json", written).stdout
        self.assertEqual(json.loads(written.read_text()), found)
        plain = run(estimate, SAMPLE, "--align", "none").stdout
        for title, key, shown in (("ATE not aligned", "ate", plain), ("ATE aligned", "ate_aligned", text), ("RPE", "rpe", text)):
            for unit, part in (("m", "translation"), ("deg", "rotation_deg")):
                row = next(line for line in shown.splitlines() if line.startswith(f"{title}, {unit} "))
                expected = [f"{found[key][part][name]:.6f}" for name in ("rmse", "mean", "median", "std", "min", "max")]
                self.assertEqual(row.split()[-6:], expected)
        self.assertEqual(run(estimate, SAMPLE, "--quiet").stdout, "")
        self.assertNotIn("ATE aligned", plain)

    def test_errors_without_alignment_are_shown_in_a_common_frame_only(self):
        self.assertIn("ATE not aligned, m ", run(SAMPLE, SAMPLE).stdout)
        stamps, poses = wandering(60, 3)
        truth = self.write("truth.txt", stamps, poses)
        elsewhere = motion(translation=(5, 0, 0)) @ motion((0, 0, 1), 2.0)
        moved = self.write("moved.txt", stamps, [elsewhere @ pose for pose in poses])
        text = run(moved, truth).stdout
        self.assertIn("different frames", text)
        self.assertNotIn("ATE not aligned, m ", text)

    def test_a_straight_path_says_that_its_alignment_is_not_unique(self):
        stamps, _ = wandering(30, 1)
        path = self.write("straight.txt", stamps, [motion(translation=(0, 0, t - 100)) for t in stamps])
        self.assertFalse(self.evaluate(path, path)["alignment"]["unique"])
        self.assertIn("not unique", run(path, path).stdout)

    # robustness 8
    def test_exit_codes_and_messages(self):
        stamps, poses = wandering(30, 2)
        truth = self.write("truth.txt", stamps, poses)
        zero = self.write("zero.txt", 1e-3 * np.arange(60), poses)
        zero_ms = self.write("zero_ms.txt", np.arange(60), poses)
        far = self.write("far.txt", stamps, [motion(translation=(1e200, 0, 0)) for _ in stamps])
        (self.folder / "seven.txt").write_text("1 2 3 4 0 0 1\n")
        (self.folder / "text.txt").write_text("# poses\n1 2 3 4 0 0 0 1\n2 x 3 4 0 0 0 1\n")
        (self.folder / "ms.txt").write_text("1305031452879 2 3 4 0 0 0 1\n")
        (self.folder / "names.csv").write_text("timestamp,x,y,z,roll,pitch,yaw\n1,2,3,4,0,0,0\n")
        cases = (
            (2, (truth,), "groundtruth"), (2, (truth, truth, "--delta", -1), "delta"), (2, (truth, truth, "--delta", 1.5), "frames"),
            (2, (truth, truth, "--unit", "feet"), "feet"), (2, (truth, truth, "--max-difference", -1), "--max-difference -1: must be"),
            (2, (truth, truth, "--align", "affine"), "affine"),
            (3, (self.folder / "none.txt", truth), "none.txt: no such file"), (3, (truth, self.folder), "found a directory"),
            (3, (self.folder / "seven.txt", truth), "seven.txt: line 1: expected 8 values"),
            (3, (truth, self.folder / "text.txt"), "text.txt: line 3: expected a number, found 'x'"),
            (3, (self.folder / "ms.txt", truth), "ms.txt: the stamps are read as milliseconds"),
            (3, (self.folder / "names.csv", truth), "names.csv: expected numbers, or columns with the names timestamp tx"),
            (3, (zero, truth), "no common timestamps within 0.020000 s: the estimate spans 0.000000 .. 0.059000 s, "
                               "the truth spans 100.000000 .. 101.966667 s; are both in seconds"),
            (3, (zero_ms, zero), "the stamps of the estimate are milliseconds, it seems"),
            (3, (zero, zero_ms), "the stamps of the truth are milliseconds, it seems"),
            (3, (far, truth), "not finite"), (3, (truth, truth, "--json", "/dev/full"), "/dev/full"),
            (2, (zero, truth, "--report", truth), "truth.txt: is an input, and would be replaced"),
            (2, (truth, truth, "--beside", zero, "--json", zero), "zero.txt: is an input, and would be replaced"),
        )
        for code, words, message in cases:
            finished = run(*words)
            self.assertEqual(finished.returncode, code, f"{words}: {finished.stdout}{finished.stderr}")
            self.assertIn(message, finished.stderr)
        self.assertEqual(self.evaluate(zero, truth, "--time-offset", 100)["num_matched"], 3)

    # robustness 1
    def test_a_last_line_without_an_end_is_warned_of(self):
        estimate = self.folder / "cut.txt"
        estimate.write_text(SAMPLE.read_text().rstrip("\n"))
        finished = run(estimate, SAMPLE)
        self.assertEqual(finished.returncode, 0)
        self.assertIn("the last line has no end", finished.stderr)


if __name__ == "__main__":
    if not MORE_TRUTHS:
        print("no further TUM sequences beside the project: the test of them is skipped")
    unittest.main(argv=sys.argv[:1])
