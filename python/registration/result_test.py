# SPDX-License-Identifier: MIT
"""What people of Python expect of a result, and of what they hand over."""
import copy
import json
import multiprocessing
import pickle
import re

import numpy as np
import pytest

import augicp
from conftest import DESK, ROOM, run_command


@pytest.fixture(scope="module")
def result():
    return augicp.align(ROOM / "source.ply", ROOM / "target.ply")


def numbers(result):
    return {name: np.array(getattr(result, name)) for name in ("T_target_source", "covariance", "information", "observability",
                                                              "reference_point", "iterations", "num_pairs", "overlap", "rmse")}


@pytest.mark.parametrize("copied", (copy.copy, copy.deepcopy, lambda it: pickle.loads(pickle.dumps(it))))
def test_copies_are_equal(result, copied):
    other = copied(result)
    for name, value in numbers(result).items():
        np.testing.assert_array_equal(value, numbers(other)[name], name)
    assert (other.status, other.doubts, other.options, bool(other)) == (result.status, result.doubts, result.options, True)
    assert [step.cost for step in other.history] == [step.cost for step in result.history]
    assert other.evidence.strain == result.evidence.strain
    assert other.evidence.source_in_target.num_points == result.evidence.source_in_target.num_points
    assert str(other) == str(result)


def parts(result):
    """All that a result is made of, with what is in it."""
    evidence = result.evidence
    return [evidence, evidence.source_in_target, evidence.residuals, evidence.residuals.normal, *result.history[:2], *result.free_motions,
            *result.runners_up]


def shown(value):
    """Every number that a value shows, in nested dicts."""
    names = [name for name in dir(type(value)) if isinstance(vars(type(value)).get(name), property)]
    if not names:
        return value.tolist() if isinstance(value, np.ndarray) else value
    return {name: shown(getattr(value, name)) for name in names}


def test_parts_print_their_numbers_and_copy(result):
    wall = np.random.default_rng(1).uniform(-1, 1, (20000, 3)) * (1, 1, 0)
    for part in parts(result) + parts(augicp.align(wall, wall)):
        assert re.search(r"^<augicp\.\w+ .*\w.*>$", repr(part)) and " object at " not in repr(part)
        assert shown(part) == shown(copy.deepcopy(part)) == shown(pickle.loads(pickle.dumps(part)))
    assert f"{result.evidence.strain:g}" in repr(result.evidence)


def test_copies_have_free_motions_and_doubts():
    wall = np.random.default_rng(1).uniform(-1, 1, (20000, 3)) * (1, 1, 0)
    free = augicp.align(wall, wall)
    other = pickle.loads(pickle.dumps(free))
    assert free.status == "degenerate" and other.covariance is None
    assert [motion.kind for motion in other.free_motions] == [motion.kind for motion in free.free_motions] != []
    np.testing.assert_array_equal(other.free_motions[0].axis, free.free_motions[0].axis)


def test_a_damaged_state_is_refused(result):
    version, values, options = result.__getstate__()
    for state in ((version + 1, values, options), (version, values[:-1], options), (version, np.append(values, 0), options)):
        with pytest.raises((ValueError, RuntimeError)):
            type(result).__new__(type(result)).__setstate__(state)


def test_its_report_is_the_command_s(result, tmp_path):
    page = tmp_path / "page.html"
    if run_command("align", ROOM / "source.ply", ROOM / "target.ply", "--quiet", "--report", tmp_path / "expected.html").returncode:
        pytest.fail("the command failed")
    result.report(page)
    # The script is the command's own: a build may have none of it.
    assert page.read_text() == (tmp_path / "expected.html").read_text()
    with pytest.raises(augicp.ArgumentError, match="no clouds"):
        copy.copy(result).report(page)
    with pytest.raises(augicp.FileError):
        result.report(tmp_path / "nowhere/page.html")


def test_reports_of_arrays_and_failures(tmp_path):
    nothing = augicp.align([[0, 0, 0]], [[9, 9, 9]])
    assert not nothing
    nothing.report(str(tmp_path / "page.html"))
    assert "1 points" in (tmp_path / "page.html").read_text()


def test_millimetres_beside_metres_are_a_warning(small):
    with pytest.warns(UserWarning, match="target is about 1000 times as large"):
        augicp.align(small[0], small[1] * 1000)


def test_text_and_dict_have_matrix_and_verdict(result):
    for text in (str(result), result._repr_html_()):
        assert "converged" in text and f"{result.T_target_source[0, 3]:.9f}" in text
    read = json.loads(json.dumps(result.to_dict()))
    assert read["status"] == "converged" and read["options"] == result.options
    np.testing.assert_array_equal(read["T_target_source"], result.T_target_source)
    np.testing.assert_array_equal(read["covariance"], result.covariance)


def align_room(_):
    return augicp.align(ROOM / "source.ply", ROOM / "target.ply", threads=1)


def test_results_cross_processes(result):
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        np.testing.assert_array_equal(pool.map(align_room, [0])[0].T_target_source, result.T_target_source)


def test_paths_are_clouds(result):
    clouds = [augicp.read(ROOM / name) for name in ("source.ply", "target.ply")]
    np.testing.assert_array_equal(augicp.align(str(ROOM / "source.ply"), clouds[1]).T_target_source, result.T_target_source)
    with pytest.raises(augicp.FileError):
        augicp.align(ROOM / "nothing.ply", clouds[1])


def test_clouds_of_other_packages_are_recognised():
    class PointCloud:
        points = [[0.0, 0.0, 0.0]]

    with pytest.raises(augicp.ArgumentTypeError, match=r"source: found .*PointCloud; give numpy.asarray\(source.points\)"):
        augicp.align(PointCloud(), [[0.0, 0.0, 0.0]])


def test_a_camera_is_a_matrix():
    matrix = [[525.0, 0, 319.5], [0, 520.0, 239.5], [0, 0, 1]]
    camera = augicp.Camera.from_matrix(matrix, width=640, height=480)
    assert (camera.fx, camera.fy, camera.cx, camera.cy, camera.width) == (525.0, 520.0, 319.5, 239.5, 640)
    depth = np.ones((480, 640), np.float32)
    np.testing.assert_array_equal(augicp.Cloud.from_depth(depth, np.array(matrix)).points, augicp.Cloud.from_depth(depth, camera).points)
    for own in (augicp.Camera(matrix, width=640, height=480), augicp.Camera(np.array(matrix), width=640, height=480),
                augicp.Camera(np.float32(525), np.array(520), 319.5, 239.5, 640, 480)):
        assert repr(own) == repr(camera)
    for wrong in (np.eye(4), np.ones((3, 3))):
        for make in (augicp.Camera.from_matrix, augicp.Camera):
            with pytest.raises(augicp.ArgumentError):
                make(wrong)


@pytest.mark.parametrize("given", [(525,), (525, 525), ("tum-fr1",), (np.eye(3), 640, 480), (525, "520", 1, 1), (None, 1, 1, 1)])
def test_a_camera_names_what_it_needs(given):
    with pytest.raises(augicp.ArgumentTypeError, match="fx, fy, cx and cy, or a .3, 3. matrix alone"):
        augicp.Camera(*given)


def test_sequences_iterate():
    poses = np.stack([np.eye(4)] * 3)
    trajectory = augicp.Trajectory([0.0, 1.0, 2.0], poses)
    assert [stamp for stamp, _ in trajectory] == [0.0, 1.0, 2.0]
    assert trajectory[-1][0] == 2.0 and trajectory[0][1].shape == (4, 4)
    for past in (3, -4, 2**100):
        with pytest.raises(IndexError):
            trajectory[past]
    with pytest.raises(TypeError):
        trajectory["first"]


@pytest.mark.parametrize("part", [slice(1, None), slice(None, -1), slice(0, 4, 2), slice(3, 3), slice(-2, 9)], ids=str)
def test_sequences_have_parts(part):
    trajectory = augicp.Trajectory(np.arange(4.0), np.stack([np.eye(4)] * 4))
    np.testing.assert_array_equal(trajectory[part].stamps, trajectory.stamps[part])
    assert trajectory[part].poses.shape == trajectory.poses[part].shape
    images = augicp.read_depth_sequence(DESK)
    assert images[part] == images.frames[part]


def test_a_trajectory_copies():
    trajectory = augicp.read_trajectory(DESK / "groundtruth.txt")
    for other in (copy.deepcopy(trajectory), pickle.loads(pickle.dumps(trajectory))):
        np.testing.assert_array_equal(other.stamps, trajectory.stamps)
        np.testing.assert_array_equal(other.poses, trajectory.poses)


def test_degrees_are_not_radians():
    with pytest.raises(augicp.ArgumentError, match="radians, not degrees"):
        augicp.align([[0.0, 0.0, 0.0]], [[0.0, 0.0, 0.0]], max_angle=45)


def test_a_report_has_the_colours_of_the_clouds(tmp_path):
    source, target = (augicp.read(ROOM / f"{name}.ply") for name in ("source", "target"))
    coloured = augicp.Cloud(source.points, colors=np.full((len(source.points), 3), 200, dtype=np.uint8))
    for number, (cloud, expected) in enumerate(((coloured, 1), (source, 0))):
        page = tmp_path / f"{number}.html"
        augicp.align(cloud, target).report(page)
        text = page.read_text()
        if "<script" not in text:
            pytest.skip("the module was built without the script of the reports")
        assert text.count('"colours":') == expected
