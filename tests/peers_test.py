#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Checks what benchmarks/peers computes itself: guesses, files of jobs and results, chained motions, errors, successes.
Needs no peer.

    peers_test.py ROOT
"""
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.path.append(str(Path(sys.argv[1]) / "benchmarks/peers"))
import jobs
import cells
import odometry
import pairs
import starts
from motions import angle_deg, error, from_axis_angle, from_quaternion, quaternion

STEP = from_axis_angle([1, 2, 3], 0.1)
STEP[:3, 3] = [0.1, -0.2, 0.3]


def motions():
    """The identity, half turns, where a quaternion's w is zero, and random ones."""
    generator = np.random.default_rng(1)
    return [np.eye(4), *(from_axis_angle(axis, np.pi) for axis in np.eye(3)),
            *(from_quaternion(generator.normal(size=3), generator.normal(size=4)) for _ in range(50))]


def test_quaternion_gives_the_rotation_back():
    for motion in motions():
        assert np.allclose(from_quaternion(motion[:3, 3], quaternion(motion)), motion, atol=1e-12)


def test_jobs_are_written_as_the_programs_read_them():
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "jobs.csv"
        sequence = jobs.Job("0-1", Path("b.png"), Path("a.png"), STEP, None, "depth", "tum-fr1", 5000)
        jobs.write_jobs(path, [sequence, jobs.Job("x", Path("s.ply"), Path("t.ply"), STEP, np.eye(4), "lidar")])
        assert path.read_text() == ("pair,source,target,scene,camera,depth_scale,guess\n"
                                    "0-1,b.png,a.png,depth,tum-fr1,5000,previous\n"
                                    "x,s.ply,t.ply,lidar,-,0.0,0 0 0 0 0 0 1\n")


def test_results_tell_a_pose_from_none():
    header = "pair,peer,method,verdict,score,tx,ty,tz,qx,qy,qz,qw,preprocess_ms,align_ms,iterations,threads\n"
    pose = jobs.motion_words(STEP).replace(" ", ",")
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "results.csv"
        path.write_text(f"{header}a,p,m,true,,{pose},1,2,3,1\nb,p,m,false,,,,,,,,,1,2,,1\n")
        found, none = jobs.read_results(path)
    assert np.allclose(found["pose"], STEP, atol=1e-15) and none["pose"] is None and none["verdict"] == "false"


def test_chain_adds_up_and_stands_still_where_a_peer_failed():
    poses = odometry.chain([STEP, None, STEP])
    assert np.allclose(poses[1], STEP) and np.allclose(poses[2], STEP) and np.allclose(poses[3], STEP @ STEP)


def test_relative_error_is_that_of_each_step():
    truth = odometry.chain([STEP] * 4)
    assert np.allclose(odometry.relative_error(truth, truth), 0, atol=1e-6)
    off = from_axis_angle([0, 0, 1], np.radians(2))
    off[:3, 3] = [0, 0.03, 0.04]
    assert np.allclose(odometry.relative_error(odometry.chain([STEP @ off] * 4), truth), (0.05, 2))
    still = odometry.relative_error(odometry.chain([None] * 4), truth)
    assert np.allclose(still, error(np.eye(4), STEP)) and np.isclose(still[1], angle_deg(STEP))


def test_absolute_error_forgives_a_rigid_motion_but_no_mirror():
    truth = odometry.chain([STEP, STEP @ STEP, STEP] * 3)
    for motion in motions():
        assert odometry.absolute_error([motion @ pose for pose in truth], truth) < 1e-12
    mirrored = [pose * np.array([[1, 1, 1, -1]]) for pose in truth]
    assert odometry.absolute_error(mirrored, truth) > 0.01


def test_lidar_guesses_are_as_far_off_as_they_say():
    for seed in range(20):
        job = cells.lidar_job((Path("s.ply"), Path("t.ply"), STEP), 30, seed)
        off_m, off_deg = error(job.guess, job.truth)
        assert np.isclose(off_deg, 30) and 0.5 <= off_m <= 2.0
        assert np.array_equal(job.guess, cells.lidar_job((None, None, STEP), 30, seed).guess)  # the same in every run


def scene(points):
    return starts.Scene("s", Path("s"), Path("t"), STEP, points, (0.1, 3.0))


def test_starts_turn_about_the_targets_centroid_and_move_by_up_to_half_its_extent():
    points = np.random.default_rng(3).normal(size=(500, 3)) + [5, 0, 0]
    at_centroid = np.append(points.mean(axis=0), 1)
    moved_m = []
    for seed in range(20):
        job = starts.start(scene(points), 30, seed)
        assert np.isclose(error(job.guess, job.truth)[1], 30)
        moved = job.guess @ np.linalg.inv(job.truth) @ at_centroid - at_centroid
        moved_m.append(np.linalg.norm(moved))
        assert np.array_equal(job.guess, starts.start(scene(points), 30, seed).guess)  # the same for every peer
    assert max(moved_m) <= starts.half_extent_m(points) and np.ptp(moved_m) > 0.5


def test_area_is_the_mean_over_the_cells():
    of_cell = lambda method, pose, angle: result(pose, method) | {"cell": f"{angle} deg"}
    rows = [of_cell("m", STEP, angle) for angle in starts.ANGLES_DEG] + [of_cell("n", None, 10)]
    counts = starts.counted(scene(np.eye(3)), rows)
    assert counts["p", "m"] == [1] * 6 and counts["p", "n"] == [0]
    lines = starts.table(scene(np.eye(3)), {("p", "m"): [2, 2, 2, 1, 0, 0]}, 2)
    assert lines[4] == "| p m | 2 | 2 | 2 | 1 | 0 | 0 | 0.58 |"


def result(pose, method="m"):
    job = jobs.Job("0", Path("s"), Path("t"), STEP, STEP, "lidar")  # from a perfect guess
    row = {"peer": "p", "method": method, "pose": pose, "align_ms": "1.5", "preprocess_ms": "2"}
    return pairs.judged(cells.Cell("c", [job]), job, row)


def test_only_a_pose_within_a_limit_is_a_success():
    near, turned, far = STEP.copy(), STEP @ from_axis_angle([0, 0, 1], np.radians(1.5)), STEP.copy()
    off = STEP.copy()
    near[0, 3] += 0.01
    off[0, 3] += 0.04
    far[0, 3] += 0.06
    for pose, expected in ((STEP, [1, 1, 1]), (near, [1, 1, 1]), (turned, [1, 1, 0]), (off, [1, 0, 0]), (far, [0, 0, 0]),
                           (None, [0, 0, 0])):
        assert [pairs.successes([result(pose)], *limits) for limits in pairs.LIMITS] == expected
    assert np.isclose(result(far)["error_m"], 0.06) and result(None)["error_m"] < 1e-12  # the guess stands


def test_tables_count_each_method_in_each_cell():
    rows = [result(STEP), result(None), result(STEP, "n"), result(None, "n") | {"cell": "d"}]
    assert pairs.overview(rows) == ["| peer | c | d |", "| --- | --- | --- |", "| p m | 1 / 1 / 1 | - |",
                                    "| p n | 1 / 1 / 1 | 0 / 0 / 0 |"]
    assert pairs.table(rows)[2] == "| c | p m | 1 of 2 | 1 of 2 | 1 of 2 | 0.0 mm, 0.00 deg | 0.0 mm, 0.00 deg | 2 | 4 |"


def test_windows_are_pooled_by_gap():
    of_cell = lambda cell, pose: result(pose) | {"cell": cell}
    far = STEP.copy()
    far[0, 3] += 0.06
    lines = pairs.errors_and_times([of_cell("a gap 1", STEP), of_cell("b gap 1", STEP), of_cell("c gap 1", far),
                                    of_cell("a gap 10", far)])
    assert lines[0] == "| peer | gap 1 | gap 10 | ms | ms with preprocessing |"
    assert lines[2] == "| p m | 20.0 mm, 0.00 deg / 0.0 mm, 0.00 deg | 60.0 mm, 0.00 deg / 60.0 mm, 0.00 deg | 2 | 4 |"


if __name__ == "__main__":
    for name, test in [item for item in globals().items() if item[0].startswith("test_")]:
        test()
        print(f"passed: {name}")
