# SPDX-License-Identifier: MIT
"""Odometry and evaluation: the command's numbers, and what happens to frames that cannot be placed."""
import copy
import math
import pickle
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import augicp
from conftest import DESK, command_json, run_command


@pytest.fixture(scope="module")
def images():
    return [(stamp, augicp.read_depth(path, 5000)) for stamp, path in augicp.read_depth_sequence(DESK).frames]


@pytest.fixture(scope="module")
def tracked(images):
    odometry = augicp.Odometry("tum-fr1")
    poses = [odometry.add(image, stamp) for stamp, image in images]
    return odometry, poses


@pytest.fixture(scope="module")
def command_folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("odometry")
    finished = run_command("odometry", DESK, "--camera", "tum-fr1", "--output", folder, "--quiet")
    assert finished.returncode == 0, finished.stderr
    return folder


def test_the_trajectory_is_the_command_s(tracked, command_folder, tmp_path):
    odometry, poses = tracked
    augicp.write_trajectory(tmp_path / "trajectory.txt", odometry.trajectory)
    assert (tmp_path / "trajectory.txt").read_text() == (command_folder / "trajectory.txt").read_text()
    assert np.array_equal(odometry.trajectory.poses, poses)


def test_the_evaluation_is_the_command_s(tracked, command_folder):
    told = command_json("evaluate", command_folder / "trajectory.txt", DESK / "groundtruth.txt", "--json", "-")
    for estimate in (tracked[0].trajectory, command_folder / "trajectory.txt"):
        evaluation = augicp.evaluate(estimate, DESK / "groundtruth.txt")
        for name in ("num_estimate", "num_truth", "num_matched", "matched_share", "num_outside", "num_unmatched", "num_holes", "num_missing",
                     "options"):
            assert getattr(evaluation, name) == told[name], name
        assert (evaluation.first_stamp, evaluation.last_stamp) == (told["first_stamp_s"], told["last_stamp_s"])
        assert evaluation.T_truth_estimate.tolist() == told["alignment"]["T_truth_estimate"]
        assert (evaluation.scale, evaluation.is_unique) == (told["alignment"]["scale"], told["alignment"]["unique"])
        for name, key in (("absolute", "ate"), ("aligned", "ate_aligned"), ("relative", "rpe")):
            errors = getattr(evaluation, name)
            assert {field: getattr(errors.translation, field) for field in told[key]["translation"]} == told[key]["translation"]
            assert math.degrees(errors.rotation.rmse) == pytest.approx(told[key]["rotation_deg"]["rmse"], rel=1e-12)


def copies(value):
    return copy.deepcopy(value), pickle.loads(pickle.dumps(value))


def test_frames_and_evaluations_copy_and_print(tracked, command_folder):
    frame = tracked[0].last_frame
    for other in copies(frame):
        assert repr(other) == repr(frame) and (other.num_pairs, other.registration) == (frame.num_pairs, frame.registration)
        assert np.array_equal(other.T_world_camera, frame.T_world_camera)
    evaluation = augicp.evaluate(command_folder / "trajectory.txt", DESK / "groundtruth.txt")
    assert f"{evaluation.aligned.translation.rmse:g} m" in str(evaluation) and "object at" not in repr(evaluation.absolute)
    for other in copies(evaluation):
        assert str(other) == str(evaluation) and other.options == evaluation.options
        assert np.array_equal(other.T_truth_estimate, evaluation.T_truth_estimate)
        assert (other.relative.rotation.sse, other.first_stamp) == (evaluation.relative.rotation.sse, evaluation.first_stamp)
    assert f"{len(tracked[1])} poses, last frame {frame.status}" in repr(tracked[0])


def test_a_frame_without_a_pose_copies():
    odometry = augicp.Odometry("tum-fr1")
    assert odometry.add(np.zeros((480, 640), np.float32)) is None
    for other in copies(odometry.last_frame):
        assert (other.status, other.problem, other.T_world_camera) == ("no_readings", odometry.last_frame.problem, None)


def test_paths_are_images(tracked):
    odometry = augicp.Odometry("tum-fr1", 5000)
    for (stamp, path), expected in list(zip(augicp.read_depth_sequence(DESK), tracked[1]))[:2]:
        assert np.array_equal(odometry.add(path, stamp), expected)
        cloud = augicp.Cloud.from_depth(str(path), "tum-fr1", 5000)
        assert np.array_equal(cloud.points, augicp.read(path, "tum-fr1", 5000).points)
    with pytest.raises(augicp.ArgumentTypeError, match="depth_scale"):
        augicp.Cloud.from_depth(path, "tum-fr1")


def test_metres_with_a_scale_are_a_mistake_with_advice(images):
    with pytest.raises(augicp.ArgumentError, match="needs no depth_scale"):
        augicp.Cloud.from_depth(images[0][1], "tum-fr1", 5000)


def test_integers_and_metres_give_the_same(images, tracked):
    odometry = augicp.Odometry("tum-fr1", 5000, threads=1)
    for (stamp, image), expected in list(zip(images, tracked[1]))[:4]:
        values = np.nan_to_num(image.astype(float) * 5000).round().astype(np.uint16)
        assert np.array_equal(odometry.add(values, stamp), expected)


def test_frames_that_cannot_be_placed_are_no_errors(images):
    odometry = augicp.Odometry("tum-fr1")
    assert odometry.last_frame is None and len(odometry.trajectory) == 0
    assert odometry.add(np.zeros_like(images[0][1])) is None
    assert odometry.last_frame.status is augicp.FrameStatus.NO_READINGS and "0 readings" in odometry.last_frame.problem
    assert np.array_equal(odometry.add(images[0][1]), np.eye(4))
    assert odometry.last_frame.stamp == 1 / 30 and odometry.last_frame
    assert odometry.add(images[1][1], 0.0) is None
    assert odometry.last_frame.status == "out_of_order" and not odometry.last_frame
    assert odometry.add(images[1][1]) is not None
    assert odometry.last_frame.status == "tracked" and odometry.last_frame.registration == "converged"
    assert odometry.add(images[2][1], math.nan) is None


def test_the_wrong_size_and_the_wrong_scale_are_errors(images):
    odometry = augicp.Odometry("525 525 319.5 239.5")
    with pytest.raises(augicp.ArgumentError, match="is the depth scale"):
        odometry.add(images[0][1] * 1000)
    assert odometry.last_frame is None
    fixed = augicp.Odometry(augicp.Camera(525, 525, 319.5, 239.5, 640, 480))
    with pytest.raises(augicp.ArgumentError, match="320 x 480"):
        fixed.add(images[0][1][:, ::2])


def test_calls_from_several_threads_follow_one_another(images):
    odometry = augicp.Odometry("tum-fr1")
    with ThreadPoolExecutor(4) as pool:
        list(pool.map(lambda frame: odometry.add(frame[1], frame[0]), images[:8]))
    assert 1 <= len(odometry.trajectory) <= 8


def test_what_an_evaluation_leaves_out():
    truth = augicp.read_trajectory(DESK / "groundtruth.txt")
    kept = [k for k in range(len(truth)) if k not in (50, 51, 90)]
    estimate = augicp.Trajectory(truth.stamps[kept], truth.poses[kept])
    part = augicp.Trajectory(truth.stamps[10:-20], truth.poses[10:-20])
    found = augicp.evaluate(estimate, part, max_difference_s=0.001)
    assert (found.num_outside, found.num_unmatched, found.num_holes, found.num_missing) == (30, 0, 2, 3)
    assert found.longest_hole == pytest.approx(0.03, abs=0.003)
    assert "30 poses lie outside of the truth's time" in str(found) and "about 3 poses are missing" in str(found)
    for other in copies(found):
        assert str(other) == str(found) and other.longest_hole == found.longest_hole


def test_options_of_odometry():
    assert augicp.Odometry("tum-fr1", max_lost=3, method="plane", max_depth=4.0).options["max_lost"] == 3
    for options in ({"max_lost": 0}, {"min_overlap": 2.0}, {"max_depth": -1.0}, {"radius": 0.0}, {"reference": "last"}):
        with pytest.raises(augicp.ArgumentError):
            augicp.Odometry("tum-fr1", **options)


def test_trajectories_that_cannot_be_compared(tracked):
    truth = augicp.read_trajectory(DESK / "groundtruth.txt")
    with pytest.raises(augicp.ArgumentError):
        augicp.evaluate(augicp.Trajectory(truth.stamps + 1e6, truth.poses), truth)
    with pytest.raises(augicp.ArgumentError, match="delta"):
        augicp.evaluate(truth, truth, delta=-1.0)
    with pytest.raises(augicp.ArgumentTypeError, match="estimate"):
        augicp.evaluate(truth.poses, truth)
    same = augicp.evaluate(truth, truth, align="none")
    assert same.aligned is None and same.absolute.translation.rmse == 0
