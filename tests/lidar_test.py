#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`augicp odometry` on folders of LiDAR scans, by the files it writes: scans of a hall, ray-cast here, along a known path.

    lidar_test.py COMMAND PROJECT
"""
import csv
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

COMMAND = Path(sys.argv[1])
HALL = np.array([[-3.0, -6.0, -1.2], [17.0, 6.0, 2.0]])  # corners, metres
BOXES = [np.array(box) for box in (
    [[2.0, 2.5, -1.2], [3.0, 4.0, 1.0]], [[6.0, -4.0, -1.2], [6.8, -3.2, 2.0]],
    [[9.0, 3.0, -1.2], [11.0, 3.6, 0.6]], [[13.0, -2.5, -1.2], [13.6, -1.5, 2.0]], [[-2.0, -5.0, -1.2], [-1.0, -3.0, 0.4]])]
NUM_SCANS, STEP_M, STEP_RAD, NOISE_M = 10, 0.4, 0.02, 0.01


def world_from_sensor(k):
    c, s = np.cos(STEP_RAD * k), np.sin(STEP_RAD * k)
    pose = np.eye(4)
    pose[:3, :3] = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]
    pose[:3, 3] = [STEP_M * k, 0.3 * np.sin(0.5 * k), 0.0]
    return pose


def distances(origin, directions):
    """Along each ray to the nearest wall: out of the hall, or into a box."""
    with np.errstate(divide="ignore", invalid="ignore"):
        nearest = np.max((HALL - origin)[:, None] / directions, axis=0).min(axis=1)
        for box in BOXES:
            planes = (box - origin)[:, None] / directions
            enter, leave = planes.min(axis=0).max(axis=1), planes.max(axis=0).min(axis=1)
            hit = (enter > 0.0) & (enter < leave)
            nearest = np.where(hit, np.minimum(nearest, enter), nearest)
    return nearest


def distances_to_walls(points):
    """Of each point to the nearest wall of the hall or face of a box, metres."""
    nearest = np.abs(points[:, None] - HALL).min(axis=(1, 2))
    for box in BOXES:
        outside = np.linalg.norm(np.maximum(0.0, np.maximum(box[0] - points, points - box[1])), axis=1)
        inside = np.minimum(points - box[0], box[1] - points).min(axis=1)
        nearest = np.minimum(nearest, np.where(inside > 0.0, inside, outside))
    return nearest


def scan(k, generator):
    """(N, 4) points of a sensor of 64 rings in its own frame, and their intensity."""
    azimuths = np.linspace(-np.pi, np.pi, 480, endpoint=False) + 1e-3
    elevations = np.deg2rad(np.linspace(-30.0, 20.0, 64))
    e, a = np.meshgrid(elevations, azimuths)
    rays = np.stack([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)], axis=-1).reshape(-1, 3)
    pose = world_from_sensor(k)
    ranges = distances(pose[:3, 3], rays @ pose[:3, :3].T) + generator.normal(0.0, NOISE_M, len(rays))
    return np.column_stack([rays * ranges[:, None], np.full(len(rays), 0.5)]).astype("<f4")


def run(*arguments):
    return subprocess.run([COMMAND, "odometry", *map(str, arguments)], capture_output=True, text=True)


def rows_of(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def points_of(path):
    header, body = path.read_bytes().split(b"end_header\n", 1)
    forms = {"float": "<f4", "double": "<f8", "uchar": "u1"}
    properties = [line.split()[1:] for line in header.decode().splitlines() if line.startswith("property")]
    rows = np.frombuffer(body, np.dtype([(name, forms[kind]) for kind, name in properties]))
    return np.column_stack([rows[axis] for axis in "xyz"]).astype(float)


class Lidar(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.root = Path(cls.folder.name)
        cls.scans = cls.root / "scans"
        cls.scans.mkdir()
        generator = np.random.default_rng(24)
        for k in range(NUM_SCANS):
            scan(k, generator).tofile(cls.scans / f"{k}.bin")
        cls.output = cls.root / "out"
        cls.result = run(cls.scans, "--output", cls.output, "--point-times", "none", "--map", cls.root / "map.ply", "--quiet")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_a_folder_of_scans_is_taken_for_a_lidar(self):
        self.assertEqual(self.result.returncode, 0, self.result.stderr)
        rows = rows_of(self.output / "frames.csv")
        self.assertEqual(len(rows), NUM_SCANS)
        self.assertEqual(rows[0]["status"], "started")
        self.assertTrue(all(row["status"] == "tracked" for row in rows[1:]), rows)

    def test_the_trajectory_is_the_true_one(self):
        poses = np.loadtxt(self.output / "poses_kitti.txt").reshape(-1, 3, 4)
        tum = np.loadtxt(self.output / "trajectory.txt")
        first = np.linalg.inv(world_from_sensor(0))
        for k, pose in enumerate(poses):
            true = first @ world_from_sensor(k)
            self.assertLess(np.linalg.norm(pose[:, 3] - true[:3, 3]), 0.03, k)
            self.assertLess(np.arccos(min(1.0, (np.trace(pose[:, :3] @ true[:3, :3].T) - 1.0) / 2.0)), 0.006, k)
            self.assertLess(np.abs(tum[k, 1:4] - pose[:, 3]).max(), 1e-6)
        self.assertLess(abs(tum[1, 0] - tum[0, 0] - 0.1), 1e-9)  # 10 scans a second

    def test_scans_taken_at_once_are_not_deskewed(self):
        """Their points are in the order of a sweep's, so that they could be one."""
        result = run(self.scans, "--output", self.root / "auto", "--map", self.root / "auto.ply")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("by the order of the points", result.stdout)
        poses = np.loadtxt(self.root / "auto/poses_kitti.txt").reshape(-1, 3, 4)
        for k, pose in enumerate(poses):
            true = np.linalg.inv(world_from_sensor(0)) @ world_from_sensor(k)
            self.assertLess(np.linalg.norm(pose[:, 3] - true[:3, 3]), 0.03, k)
        self.assertGreater(np.mean(distances_to_walls(points_of(self.root / "auto.ply")) < 0.05), 0.9)

    def timed_scans(self, name, times):
        """The scans as text PLY files with the time of each point in a field t."""
        folder = self.root / name
        folder.mkdir()
        for k in range(3):
            points = np.fromfile(self.scans / f"{k}.bin", "<f4").reshape(-1, 4)
            rows = np.column_stack([points[:, :3], times[:len(points)]])
            fields = "".join(f"property {kind} {field}\n" for kind, field in
                             (("float", "x"), ("float", "y"), ("float", "z"), ("double", "t")))
            with open(folder / f"{k}.ply", "w") as file:
                file.write(f"ply\nformat ascii 1.0\nelement vertex {len(rows)}\n{fields}end_header\n")
                np.savetxt(file, rows, fmt="%.9g")
        return folder

    def test_times_of_a_field_are_used_and_their_unit_is_said(self):
        count = len(np.fromfile(self.scans / "0.bin", "<f4")) // 4
        for name, unit, scale in (("ns", "nanoseconds", 1e9), ("us", "microseconds", 1e6), ("s", "seconds", 1.0)):
            folder = self.timed_scans(name, np.linspace(0.0, 0.1 * scale, count))
            for times in ("auto", "T"):
                out = self.root / f"{name} {times}"
                result = run(folder, "--output", out, "--point-times", times)
                self.assertEqual(result.returncode, 0, result.stderr)
                self.assertIn(f"field t, {unit}: sweeps of 0.1 s", result.stdout)
                self.assertIn(unit, json.loads((out / "metrics.json").read_text())["point_times"])
        self.assertEqual((self.root / "ns auto/trajectory.txt").read_text(), (self.root / "us T/trajectory.txt").read_text())
        refused = run(folder, "--output", self.root / "refused", "--point-times", "stamp")
        self.assertIn("expected a field 'stamp'", refused.stderr)
        self.assertFalse((self.root / "refused").exists())

    def test_scans_are_checked_against_keyframes_farther_back(self):
        out = self.root / "checked"
        result = run(self.scans, "--output", out, "--point-times", "none", "--check-every", 3)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = rows_of(out / "frames.csv")
        drifts = {k: float(row["drift_m"]) for k, row in enumerate(rows) if row["drift_m"]}
        self.assertEqual(sorted(drifts), [3, 6, 9])
        self.assertTrue(all(row["status"] == "tracked" for row in rows[1:]))
        check = json.loads((out / "metrics.json").read_text())["self_check"]
        self.assertEqual((check["num_checked"], check["num_contradicted"]), (3, 0))
        self.assertAlmostEqual(check["max_drift_m"], max(drifts.values()), 4)
        self.assertLess(check["max_drift_m"], 0.02)
        self.assertIn("drift      3 scans", result.stdout)
        unchecked = run(self.scans, "--output", out, "--point-times", "none", "--check-every", 0)
        self.assertNotIn("drift", unchecked.stdout)
        self.assertNotIn("self_check", json.loads((out / "metrics.json").read_text()))

    def test_every_pose_but_the_first_has_a_covariance(self):
        rows = np.genfromtxt(self.output / "covariances.csv", delimiter=",", names=True)
        self.assertEqual(len(rows), NUM_SCANS - 1)
        self.assertTrue((rows["c00"] > 0.0).all())

    def test_the_map_is_where_the_walls_are(self):
        points = points_of(self.root / "map.ply")
        self.assertGreater(len(points), 500)
        # The world is the frame of the first scan, in which the hall is given.
        self.assertGreater(np.mean(distances_to_walls(points) < 0.05), 0.9)

    def test_tiles_of_the_map_are_its_squares(self):
        whole = points_of(self.root / "map.ply")
        folder = self.root / "tiles"
        folder.mkdir()
        result = run(self.scans, "--output", self.root / "tiled", "--point-times", "none", "--map", folder / "map.ply",
                     "--map-tile", 8, "--quiet")
        self.assertEqual(result.returncode, 0, result.stderr)
        tiles = {tuple(map(int, path.stem.split("_")[1:])): points_of(path) for path in folder.iterdir()}
        squares = {tuple(square) for square in np.floor(whole[:, :2] / 8.0).astype(int)}
        self.assertEqual(set(tiles), squares)
        self.assertGreater(len(squares), 2)
        for square, points in tiles.items():
            self.assertTrue((np.abs(points[:, :2] - 8.0 * (np.array(square) + 0.5)) <= 4.0 + 1e-4).all(), square)
        together = np.vstack(list(tiles.values()))
        order = [np.lexsort(np.round(points, 3).T) for points in (whole, together)]
        self.assertTrue(np.allclose(whole[order[0]], together[order[1]], atol=2e-3))

    def test_scans_in_other_units_or_frames_are_named(self):
        for name, change, words in (("mm", lambda points: points * 1000.0, "millimetres"),
                                    ("utm", lambda points: points + [4e5, 5.4e6, 0.0], "frame of the sensor")):
            folder = self.root / name
            folder.mkdir()
            for k in range(4):
                points = np.fromfile(self.scans / f"{k}.bin", "<f4").reshape(-1, 4)
                points[:, :3] = change(points[:, :3].astype(float))
                points.tofile(folder / f"{k}.bin")
            result = run(folder, "--output", self.root / f"{name}_run")
            self.assertNotEqual(result.returncode, 0)
            self.assertIn(words, result.stdout)

    def test_the_map_may_go_into_the_folder_that_is_made(self):
        output = self.root / "made"
        result = run(self.scans, "--output", output, "--point-times", "none", "--map", output / "map.ply", "--map-tile", 8)
        self.assertEqual(result.returncode, 0, result.stderr)
        tiles = list(output.glob("map_*.ply"))
        self.assertGreater(len(tiles), 1)
        self.assertIn(f"{output / 'map_*.ply'} ({len(tiles)} tiles)", result.stdout)

    def copied_scans(self, name):
        folder = self.root / name
        folder.mkdir()
        for k in range(NUM_SCANS):
            (folder / f"{k}.bin").write_bytes((self.scans / f"{k}.bin").read_bytes())
        return folder

    def tracked(self, folder, name, *words):
        """The finished run, its rows and its metrics."""
        output = self.root / name
        result = run(folder, "--output", output, "--point-times", "none", *words)
        return result, rows_of(output / "frames.csv"), json.loads((output / "metrics.json").read_text())

    def test_a_scan_out_of_order_is_reported_and_the_run_goes_on(self):
        folder = self.copied_scans("swapped")
        times = [f"{0.1 * k:.1f}" for k in range(NUM_SCANS)]
        times[4], times[5] = times[5], times[4]
        (folder / "times.txt").write_text("\n".join(times) + "\n")
        result, rows, metrics = self.tracked(folder, "swapped_run")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual([row["status"] for row in rows], ["started"] + ["tracked"] * 4 + ["out_of_order"] + ["tracked"] * 4)
        self.assertIn("0.400000 s, is not after 0.500000 s", rows[5]["problem"])
        self.assertEqual((metrics["num_out_of_order"], metrics["num_poses"]), (1, NUM_SCANS - 1))
        self.assertIn("problem    its stamp, 0.400000 s", result.stdout)

    def test_times_in_nanoseconds_are_read_as_such_and_said(self):
        folder = self.copied_scans("nanoseconds")
        for first, name in ((0, "relative"), (1403636579763555584, "unix")):
            (folder / "times.txt").write_text("".join(f"{first + 100_000_000 * k}\n" for k in range(NUM_SCANS)))
            result, rows, metrics = self.tracked(folder, f"ns_{name}", "--map-voxel", 0.3)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("times.txt: the stamps are read as nanoseconds", result.stderr)
            self.assertEqual(result.stderr, "".join(f"augicp: warning: {warning}\n" for warning in metrics["warnings"]))
            self.assertAlmostEqual(float(rows[-1]["stamp_s"]), first / 1e9 + 0.1 * (NUM_SCANS - 1), 5)
        (folder / "times.txt").write_text("".join(f"{k}e15\n" for k in range(NUM_SCANS)))
        refused = run(folder, "--output", self.root / "refused", "--point-times", "none")
        self.assertEqual(refused.returncode, 3)
        self.assertIn("times.txt: expected seconds, found stamps that are 1e+15 apart", refused.stderr)

    def test_scans_of_another_kind_are_not_left_out_in_silence(self):
        folder = self.copied_scans("mixed")
        for name in ("7.pcd", "8.ply", "9.ply"):
            (folder / name).write_text("")
        result, rows, metrics = self.tracked(folder, "mixed_run")
        words = "10 .bin scans are read, and 1 .pcd, 2 .ply left out"
        self.assertIn(words, result.stderr)
        self.assertIn(words, metrics["warnings"][0])
        self.assertEqual(len(rows), NUM_SCANS)
        self.assertEqual(run(folder, "--output", self.root / "mixed_quiet", "--point-times", "none", "--quiet").stderr, "")

    def test_scans_beside_depth_images_are_named(self):
        folder = self.copied_scans("both")
        images = sorted((Path(sys.argv[2]) / "data/tum_fr1_desk_30/depth").glob("*.png"))[:2]
        for k, image in enumerate(images):
            (folder / f"{k}.png").write_bytes(image.read_bytes())
        result = run(folder, "--camera", "tum-fr1", "--depth-scale", 5000, "--output", self.root / "both_depth")
        self.assertIn("its depth images are tracked, and its 10 .bin scans left out: --sensor lidar tracks these", result.stderr)
        self.assertEqual(len(rows_of(self.root / "both_depth/frames.csv")), len(images))
        result, rows, _ = self.tracked(folder, "both_lidar", "--sensor", "lidar", "--last", 2)
        self.assertEqual((result.stderr, len(rows)), ("", 2))

    def test_the_derived_voxel_size_is_recorded(self):
        result, _, metrics = self.tracked(self.scans, "derived", "--report", self.root / "derived.html")
        voxel = metrics["map_voxel"]
        self.assertTrue(voxel["derived"] and 0.2 <= voxel["size_m"] <= 0.7)
        for text in (result.stdout, (self.root / "derived.html").read_text(), (self.root / "derived/config.toml").read_text()):
            self.assertIn(f"{voxel['size_m']:.4g} m, derived from the first scan", text)
        _, _, metrics = self.tracked(self.scans, "given", "--map-voxel", 0.35)
        self.assertEqual(metrics["map_voxel"], {"size_m": 0.35, "derived": False})

    def test_the_metrics_name_the_sequence(self):
        self.assertEqual(json.loads((self.output / "metrics.json").read_text())["sequence"], str(self.scans))

    def test_the_config_repeats_the_run(self):
        again = self.root / "again"
        config = (self.output / "config.toml").read_text()
        (self.root / "config.toml").write_text(config.replace(str(self.output), str(again)))
        self.assertEqual(subprocess.run([COMMAND, "--config", self.root / "config.toml", "odometry"], capture_output=True).returncode, 0)
        self.assertEqual((again / "trajectory.txt").read_text(), (self.output / "trajectory.txt").read_text())

    def test_threads_change_no_bit(self):
        alone = self.root / "alone"
        self.assertEqual(run(self.scans, "--output", alone, "--point-times", "none", "--threads", 1, "--quiet").returncode, 0)
        self.assertEqual((alone / "trajectory.txt").read_text(), (self.output / "trajectory.txt").read_text())

    def test_what_cannot_be_tracked_is_said(self):
        empty = self.root / "empty"
        empty.mkdir(exist_ok=True)
        for arguments in ([empty], [empty, "--sensor", "lidar"], [self.scans, "--first", "99"],
                          [self.scans, "--point-times", "sometimes"], [self.scans, "--map", "map.xyz"],
                          [self.scans, "--map", "map.ply", "--map-tile", 0],
                          [self.scans, "--map", "map.ply", "--map-tile", "nan"],
                          [self.scans, "--max-depth", 10], [self.scans, "--method", "point"]):
            refused = run(*arguments, "--output", self.root / "refused")
            self.assertNotIn(refused.returncode, (0, 4, 5), arguments)
            self.assertTrue(refused.stderr)
            self.assertFalse((self.root / "refused").exists())

    def test_memory_is_bounded_before_and_during_the_run(self):
        output = self.root / "bounded"
        tiny = ("--map-voxel", 0.05, "--point-times", "none", "--output", output)
        refused = run(self.scans, *tiny, "--max-memory", 0.022)
        self.assertEqual(refused.returncode, 2, refused.stderr)
        self.assertRegex(refused.stderr, r"need about .* GB are allowed: use .*, or a larger --max-memory")
        self.assertFalse(output.exists())
        ended = run(self.scans, *tiny, "--max-memory", 0.05, "--map", self.root / "bounded.ply")
        self.assertEqual(ended.returncode, 5, ended.stderr)
        self.assertRegex(ended.stderr, r"ended before scan \d+: .*use --map-voxel 0\.\d+, or a larger --max-memory")
        poses = sum(not line.startswith("#") for line in (output / "trajectory.txt").read_text().splitlines())
        metrics = json.loads((output / "metrics.json").read_text())
        self.assertEqual((metrics["num_frames"], metrics["num_poses"]), (poses, poses))
        self.assertIn(f"before scan {poses}", metrics["ended_early"])
        self.assertTrue((self.root / "bounded.ply").exists())

    def test_a_scan_that_cannot_be_read_does_not_end_the_run(self):
        broken = self.root / "broken"
        broken.mkdir(exist_ok=True)
        for k in range(4):
            content = (self.scans / f"{k}.bin").read_bytes()
            (broken / f"{k}.bin").write_bytes(content if k != 2 else content[:-7])
        self.assertIn(run(broken, "--output", self.root / "b", "--point-times", "none", "--quiet").returncode, (0, 5))
        rows = rows_of(self.root / "b/frames.csv")
        self.assertEqual([row["status"] for row in rows], ["started", "tracked", "unreadable", "tracked"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
