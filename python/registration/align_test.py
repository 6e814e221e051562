# SPDX-License-Identifier: MIT
"""align: bit-identical to the command, from any thread and for any memory layout."""
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

import augicp
from conftest import IMAGES, ROOM, command_json


def same_bits(result, other):
    return all(np.array_equal(getattr(result, name), getattr(other, name))
               for name in ("T_target_source", "information", "observability", "covariance", "rmse", "num_pairs"))


def assert_equals_command(result, told):
    assert str(result.status) == told["status"]
    for name in ("iterations", "num_pairs", "overlap", "rmse"):
        assert getattr(result, name) == told[name], name
    for name in ("T_target_source", "information", "covariance", "observability"):
        value = getattr(result, name)
        assert (None if value is None else value.tolist()) == told[name], name
    assert [[str(motion.kind), motion.axis.tolist(), motion.point.tolist(), motion.pitch]
            for motion in result.free_motions] == [list(motion.values()) for motion in told["free_motions"]]
    evidence = told["evidence"]
    assert result.evidence.strain == evidence["strain"]
    assert [str(doubt) for doubt in result.doubts] == evidence["doubts"]
    for name in ("source_in_target", "target_in_source"):
        side = getattr(result.evidence, name)
        assert {key: getattr(side, key) for key in evidence[name]} == evidence[name]
    for name, numbers in evidence["residuals"].items():
        residual = getattr(result.evidence.residuals, name)
        assert {"count": residual.count, "median": residual.median} == numbers
    assert len(result.history) == len(told["history"])
    for iteration, row in zip(result.history, told["history"]):
        told_here = {key: np.asarray(getattr(iteration, key)).tolist() for key in row}
        told_here = {key: None if value == np.inf else value for key, value in told_here.items()}  # no kernel: null
        assert told_here == row


def test_clouds_as_the_command(room):
    told = command_json("align", ROOM / "source.ply", ROOM / "target.ply", "--json", "-", "--trace")
    result = augicp.align(*room)
    assert result and result.status is augicp.Status.CONVERGED
    assert_equals_command(result, told)


def test_ndt_meets_the_sample_pairs_as_the_command(room):
    told = command_json("align", ROOM / "source.ply", ROOM / "target.ply", "--method", "ndt", "--json", "-", "--trace")
    result = augicp.align(*room, method="ndt")
    assert result.status is augicp.Status.CONVERGED and result.options["method"] == "ndt"
    wrong = np.linalg.inv(np.loadtxt(ROOM / "T_target_source.txt")) @ result.T_target_source
    assert np.linalg.norm(wrong[:3, 3]) < 0.02
    assert_equals_command(result, told)
    images = [augicp.read(path, "tum-fr1", 5000) for path in IMAGES]
    assert augicp.align(*images, method="ndt").status is augicp.Status.CONVERGED


def test_bare_arrays_as_the_command_on_a_file_of_them(tmp_path, room):
    paths = [tmp_path / "source.npy", tmp_path / "target.npy"]
    arrays = [cloud.points_from_origin for cloud in room]
    for path, array in zip(paths, arrays):
        np.save(path, array)
    initial = np.loadtxt(ROOM / "T_target_source.txt")
    told = command_json("align", *paths, "--initial", ROOM / "T_target_source.txt", "--method", "gicp", "--json", "-",
                        "--trace", "--max-iterations", 20)
    assert_equals_command(augicp.align(*arrays, initial, "gicp", max_iterations=20), told)


def test_depth_images_as_the_command():
    told = command_json("align", *IMAGES, "--camera", "tum-fr1", "--json", "-", "--trace")
    by_name = [augicp.read(path, "tum-fr1", 5000) for path in IMAGES]
    by_metres = [augicp.Cloud.from_depth(augicp.read_depth(path, 5000), augicp.Camera.read("tum-fr1")) for path in IMAGES]
    for clouds in (by_name, by_metres):
        assert_equals_command(augicp.align(*clouds), told)


def test_a_doubtful_result_is_false_but_has_a_pose(small):
    source, target, _ = small
    result = augicp.align(source, target + [0, 0, 50.0])
    assert not result
    assert result.T_target_source.shape == (4, 4)
    degenerate = augicp.align(target[:400], target[:400])
    assert degenerate.status == "degenerate" and not degenerate
    assert degenerate.covariance is None
    assert {str(motion.kind) for motion in degenerate.free_motions} <= {"translation", "rotation", "screw"}


@pytest.mark.parametrize("points", [np.empty((0, 3)), np.full((5, 3), np.nan), np.zeros((5, 3)), np.ones((1, 3))])
def test_what_the_data_are_like_is_no_error(points, small):
    assert augicp.align(points, small[1]).status == "too_few_pairs"
    assert augicp.align(small[0], points).status == "too_few_pairs"
    assert not augicp.align(points, points)


def layouts(points):
    wide = np.zeros((2 * len(points), 5))
    wide[::2, 1:4] = points
    frozen = points.copy()
    frozen.flags.writeable = False
    misaligned = np.frombuffer(b"x" + points.tobytes(), dtype=np.float64, offset=1).reshape(-1, 3)
    return {
        "columns of a larger array": wide[::2, 1:4],
        "read-only": frozen,
        "Fortran order": np.asfortranarray(points),
        "backwards": points[::-1].copy()[::-1],
        "columns backwards": points[:, ::-1].copy()[:, ::-1],
        "big endian": points.astype(">f8"),
        "long double": points.astype(np.longdouble),
        "not aligned": misaligned,
        "a list": points.tolist(),
        "a subclass": points.view(type("Sub", (np.ndarray,), {})),
    }


def test_the_layout_in_memory_does_not_matter(small):
    source, target, motion = small
    expected = augicp.align(source, target)
    assert np.allclose(expected.T_target_source, motion, atol=1e-3)
    for name, given in layouts(source).items():
        assert same_bits(augicp.align(given, target), expected), name
    in_float = source.astype(np.float32)
    assert same_bits(augicp.align(in_float, target), augicp.align(in_float.astype(np.float64), target))


def test_what_is_not_finite_is_left_out(small):
    source, target, _ = small
    spoiled = np.concatenate([source, [[np.nan, 0, 0], [0, np.inf, 0], [0, 0, -np.inf], [1e30, 0, 0]]])
    assert same_bits(augicp.align(spoiled, target), augicp.align(source, target))
    masked = np.ma.masked_array(np.concatenate([source, [[9.0, 9.0, 9.0]]]), mask=False)
    masked[-1, 0] = np.ma.masked
    assert same_bits(augicp.align(masked, target), augicp.align(source, target))


def test_anything_with_array_will_do(small):
    class Points:
        def __init__(self, points):
            self.points = points

        def __array__(self, dtype=None, copy=None):
            return self.points

    source, target, _ = small
    assert same_bits(augicp.align(Points(source), Points(target)), augicp.align(source, target))
    assert same_bits(augicp.align(augicp.Cloud(source), target), augicp.align(source, target))


def test_any_number_of_threads_gives_the_same_bits(small):
    source, target, _ = small
    expected = augicp.align(source, target, threads=1)
    assert all(same_bits(augicp.align(source, target, threads=count), expected) for count in (0, 2, 5))


def test_calls_at_once_give_the_same_bits(small):
    source, target, _ = small
    shared = augicp.Cloud(source)
    expected = augicp.align(shared, target)
    with ThreadPoolExecutor(6) as pool:
        results = list(pool.map(lambda k: augicp.align(shared if k % 2 else source, target, threads=k % 3), range(24)))
    assert all(same_bits(result, expected) for result in results)


def test_arrays_may_change_afterwards_and_results_are_not_shared(small):
    source, target, _ = (np.array(array) for array in small)
    cloud = augicp.Cloud(source)
    result = augicp.align(cloud, target)
    source[:] = np.nan
    result.T_target_source[:] = 0
    assert same_bits(augicp.align(cloud, target), result)
    assert result.T_target_source[3, 3] == 1


def test_options_repeat_the_call(small):
    source, target, _ = small
    result = augicp.align(source, target, search=False, max_angle=0.5)
    assert not result.options["search"] and result.options["radius"] > 0
    assert same_bits(augicp.align(source, target, **result.options), result)


def turned(cloud):
    """The cloud in another frame: a half turn about a slanting axis, and 3 m."""
    axis = np.array([1.0, 2.0, 2.0]) / 3.0
    motion = np.eye(4)
    motion[:3, :3] = 2.0 * np.outer(axis, axis) - np.eye(3)
    motion[:3, 3] = [1.0, -2.0, 2.0]
    return cloud.transformed(motion), motion


def test_without_a_guess_as_the_command(tmp_path, room):
    moved, _ = turned(room[0])
    paths = [tmp_path / "source.npy", tmp_path / "target.npy"]
    arrays = [moved.points_from_origin, room[1].points_from_origin]
    for path, array in zip(paths, arrays):
        np.save(path, array)
    told = command_json("align", *paths, "--global", "--json", "-", "--trace")
    result = augicp.align(*arrays, initial="global")
    assert_equals_command(result, told)
    assert same_bits(augicp.align(*arrays, global_=True), result)
    found = augicp.find_pose(*arrays)
    assert same_bits(found[0], result) and found[0].status == result.status
    assert all(other.evidence.strain >= found[0].evidence.strain for other in found)


def test_without_a_guess_the_frame_of_the_source_does_not_matter(room):
    truth = np.loadtxt(ROOM / "T_target_source.txt")
    moved, motion = turned(room[0])
    result = augicp.align(moved, room[1], initial="global")
    assert result
    assert np.allclose(result.T_target_source @ motion, truth, atol=0.02)


def test_words_for_a_guess_are_refused(room):
    with pytest.raises(augicp.ArgumentError, match="initial.*global"):
        augicp.align(*room, initial="anywhere")
    with pytest.raises(augicp.ArgumentError, match="global"):
        augicp.align(*room, initial="global", preset="paper")
    assert augicp.find_pose(np.zeros((0, 3)), room[1]) == []
