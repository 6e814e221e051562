# SPDX-License-Identifier: MIT
"""LiDAR odometry: scans of a generated hall along a known path, and the command's numbers."""
import csv
import math

import numpy as np
import pytest

import augicp
from conftest import run_command

HALL = np.array([[-3.0, -6.0, -1.2], [17.0, 6.0, 2.0]])  # corners, metres
BOX = np.array([[6.0, 2.0, -1.2], [8.0, 4.0, 1.0]])


def true_pose(k):
    pose = np.eye(4)
    pose[:2, :2] = [[math.cos(0.02 * k), -math.sin(0.02 * k)], [math.sin(0.02 * k), math.cos(0.02 * k)]]
    pose[:2, 3] = 0.4 * k, 0.1 * k
    return pose


def scan(k, generator):
    azimuth, elevation = np.meshgrid(np.linspace(-np.pi, np.pi, 480, endpoint=False) + 1e-3, np.deg2rad(np.linspace(-30, 20, 48)))
    rays = np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)], -1).reshape(-1, 3)
    pose = true_pose(k)
    directions, origin = rays @ pose[:3, :3].T, pose[:3, 3]
    walls = np.max((HALL - origin)[:, None] / directions, axis=0).min(axis=1)
    faces = (BOX - origin)[:, None] / directions
    enter, leave = faces.min(axis=0).max(axis=1), faces.max(axis=0).min(axis=1)
    ranges = np.where((enter > 0) & (enter < leave), np.minimum(walls, enter), walls)
    return (rays * (ranges + generator.normal(0.0, 0.01, len(rays)))[:, None]).astype(np.float32)


@pytest.fixture(scope="module")
def scans():
    generator = np.random.default_rng(24)
    return [scan(k, generator) for k in range(5)]


@pytest.fixture(scope="module")
def tracked(scans):
    odometry = augicp.LidarOdometry()
    return odometry, [odometry.add(points, 0.1 * k, "none") for k, points in enumerate(scans)]


def test_the_poses_are_the_true_ones(tracked):
    for k, pose in enumerate(tracked[1]):
        assert np.linalg.norm(pose[:3, 3] - true_pose(k)[:3, 3]) < 0.03, k
    odometry = tracked[0]
    assert np.array_equal(odometry.trajectory.poses, tracked[1])
    assert odometry.last_frame.status == "tracked" and odometry.last_frame
    assert len(odometry.map) > 200 and odometry.options["max_lost"] == 10


def test_the_voxel_size_is_told(scans, tracked):
    assert augicp.LidarOdometry().voxel_size is None
    derived = tracked[0].voxel_size
    assert 0.2 <= derived <= 0.7 and tracked[0].options["voxel_size"] is None
    given = augicp.LidarOdometry(voxel_size=0.3)
    given.add(scans[0], 0.0, "none")
    assert given.voxel_size == 0.3


def test_the_trajectory_is_the_command_s(scans, tracked, tmp_path):
    (tmp_path / "scans").mkdir()
    for k, points in enumerate(scans):
        np.column_stack([points, np.zeros(len(points), np.float32)]).astype("<f4").tofile(tmp_path / "scans" / f"{k}.bin")
    finished = run_command("odometry", tmp_path / "scans", "--point-times", "none", "--output", tmp_path / "out", "--quiet")
    assert finished.returncode == 0, finished.stderr
    command = augicp.read_trajectory(tmp_path / "out" / "trajectory.txt")
    # The quaternions in the file are normalised again when it is read.
    assert np.allclose(command.poses, tracked[0].trajectory.poses, rtol=0, atol=1e-12)


def test_the_drift_of_checked_frames_is_the_command_s(scans, tmp_path):
    (tmp_path / "scans").mkdir()
    odometry = augicp.LidarOdometry(check_every=2, covariance=True)
    drifts = []
    for k, points in enumerate(scans):
        np.column_stack([points, np.zeros(len(points), np.float32)]).astype("<f4").tofile(tmp_path / "scans" / f"{k}.bin")
        odometry.add(points, 0.1 * k, "none")
        drifts.append(odometry.last_frame.drift)
    finished = run_command("odometry", tmp_path / "scans", "--point-times", "none", "--check-every", "2", "--output", tmp_path / "out",
                           "--quiet")
    assert finished.returncode == 0, finished.stderr
    with open(tmp_path / "out" / "frames.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    assert [k for k, drift in enumerate(drifts) if drift] == [k for k, row in enumerate(rows) if row["drift_m"]] == [2, 4]
    for k in (2, 4):
        assert drifts[k]["drift_m"] == pytest.approx(float(rows[k]["drift_m"]), rel=1e-3)
        assert drifts[k]["drift_deg"] == pytest.approx(float(rows[k]["drift_deg"]), rel=1e-3, abs=1e-4)
        assert drifts[k]["distance_m"] == pytest.approx(np.linalg.norm(true_pose(k)[:3, 3]), abs=0.03)
        assert drifts[k]["keyframe_stamp"] == 0.0 and not drifts[k]["contradicts"]
        assert drifts[k]["drift_m"] < drifts[k]["expected_m"] + 0.02


def test_times_of_points_in_any_unit(scans):
    count = len(scans[0])
    poses = []
    for scale in (1.0, 1e9):
        odometry = augicp.LidarOdometry(threads=1)
        poses.append([odometry.add(points, times=scale * np.arange(count) / 1024) for points in scans[:3]])
    assert np.allclose(poses[0], poses[1], atol=1e-6)
    odometry = augicp.LidarOdometry()
    for times in (np.arange(count - 1), "sometimes", np.full(count, math.nan)):
        with pytest.raises(augicp.ArgumentError):
            odometry.add(scans[0], times=times)
    assert odometry.last_frame is None


def test_points_without_a_reading_are_dropped_with_their_times(scans):
    """Organized clouds have them."""
    def poses(points_of, times_of):
        odometry = augicp.LidarOdometry()
        return [odometry.add(points_of(points), 0.1 * k, times_of(len(points))) for k, points in enumerate(scans[:3])]

    def with_holes(points):
        holed = np.full((2 * len(points), 3), np.nan, np.float32)
        holed[::2] = points
        return holed

    whole = poses(lambda points: points, lambda n: np.linspace(0.0, 0.1, n))
    holed = poses(with_holes, lambda n: np.repeat(np.linspace(0.0, 0.1, n), 2))
    assert all(np.array_equal(one, other) for one, other in zip(whole, holed))
    with pytest.raises(augicp.ArgumentError, match="one a point"):
        augicp.LidarOdometry().add(with_holes(scans[0]), 0.0, np.linspace(0.0, 0.1, len(scans[0]) + 1))


def test_scans_that_cannot_be_placed_are_no_errors(scans):
    odometry = augicp.LidarOdometry()
    assert odometry.add(scans[0][:20]) is None and odometry.last_frame.status == "no_readings"
    assert np.array_equal(odometry.add(scans[0]), np.eye(4))
    assert odometry.add(scans[1], 0.0) is None and odometry.last_frame.status == "out_of_order"


def test_options_of_lidar_odometry():
    assert augicp.LidarOdometry(pose_at="end", voxel_size=0.3).options["pose_at"] == "end"
    for options in ({"max_lost": 0}, {"voxel_size": -1.0}, {"pose_at": "noon"}):
        with pytest.raises(augicp.ArgumentError):
            augicp.LidarOdometry(**options)


def test_a_scan_beyond_the_memory_is_refused_with_advice(scans):
    odometry = augicp.LidarOdometry(voxel_size=0.05, max_memory_gb=0.03)
    with pytest.raises(augicp.ArgumentError, match="use voxel_size [0-9.]+, or a larger max_memory_gb"):
        odometry.add(scans[0])
    assert odometry.last_frame is None
