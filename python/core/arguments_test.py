# SPDX-License-Identifier: MIT
"""Unusable arguments are refused by name, with the right kind of exception, and nothing else happens."""
import threading
from fractions import Fraction

import numpy as np
import pytest

import augicp

POINTS = np.random.default_rng(1).random((50, 3))

NO_NUMBERS = [
    None, "points", b"points", object(), {"x": 1}, {1.0, 2.0}, [["a", "b", "c"]], [[1, 2], [3]], [[None] * 3],
    np.array([["1", "2", "3"]]), np.array([[1, 2, 3]], dtype=object), np.ones((4, 3), dtype=bool),
    np.ones((4, 3), dtype=complex), np.zeros(4, dtype=[("x", "f4"), ("y", "f4"), ("z", "f4")]),
    np.zeros((4, 3), dtype="datetime64[s]"), np.zeros((4, 3), dtype="V8"), [[Fraction(1, 2)] * 3],
    np.ma.masked_array([["a"] * 3]),
]
WRONG_SHAPES = [
    1.0, np.float64(2), np.array(3.0), np.zeros(3), np.zeros(0), np.zeros((3, 50)), np.zeros((50, 4)), np.zeros((480, 640)),
    np.zeros((48, 64, 3)), np.zeros((1, 1, 1, 3)), np.zeros((0, 0)), np.zeros((4, 0)),
]


@pytest.mark.parametrize("given", NO_NUMBERS, ids=repr)
def test_what_are_no_numbers(given):
    for call in (augicp.Cloud, augicp.estimate_surface, lambda points: augicp.align(points, POINTS),
                 lambda points: augicp.align(POINTS, points), lambda points: augicp.Cloud(POINTS, normals=points or [["a"]])
                 if not isinstance(points, np.ndarray) else augicp.Cloud(POINTS, normals=points)):
        # Text is the path of a file in the place of a cloud.
        wrong = (augicp.ArgumentTypeError, augicp.FileError) if isinstance(given, str) else augicp.ArgumentTypeError
        with pytest.raises(wrong, match="points|source|target|cloud|normals"):
            call(given)
    if given is not None:
        with pytest.raises(augicp.ArgumentError if isinstance(given, str) else augicp.ArgumentTypeError, match="initial"):
            augicp.align(POINTS, POINTS, given)
    with pytest.raises(augicp.ArgumentTypeError, match="depth image"):
        augicp.Cloud.from_depth(given, "tum-fr1")


@pytest.mark.parametrize("given", WRONG_SHAPES, ids=lambda given: str(np.shape(given)))
def test_wrong_shapes(given):
    for call in (augicp.Cloud, lambda points: augicp.align(points, POINTS), lambda points: augicp.align(POINTS, points)):
        with pytest.raises(augicp.ArgumentError, match=r"(points|source|target): expected shape \(N, 3\), found"):
            call(given)
    with pytest.raises(augicp.ArgumentError, match="initial: expected a 4 x 4 matrix"):
        augicp.align(POINTS, POINTS, given)


def test_hints_say_what_was_probably_meant():
    for array, hint in ((np.zeros((3, 9)), "points.T"), (np.zeros((9, 4)), r"points\[:, :3\]"),
                        (np.zeros((9, 9, 3)), "reshape"), (np.zeros((480, 640)), "from_depth")):
        with pytest.raises(augicp.ArgumentError, match=hint):
            augicp.Cloud(array)


def test_huge_arrays_that_take_no_memory_are_refused_at_once():
    for dtype in (np.float32, np.float64, np.int8):
        huge = np.broadcast_to(np.zeros(3, dtype), (10**12, 3))
        with pytest.raises(augicp.ArgumentError, match="at most 100000000"):
            augicp.align(huge, POINTS)
    with pytest.raises(augicp.ArgumentError, match="too large"):
        augicp.Cloud.from_depth(np.broadcast_to(np.uint16(5), (10**6, 10**6)), "tum-fr1", 5000)
    with pytest.raises(augicp.ArgumentError, match="too many"):
        augicp.Trajectory(np.broadcast_to(0.0, 10**12), np.broadcast_to(np.eye(4), (10**12, 4, 4)))
    overlapping = np.lib.stride_tricks.as_strided(POINTS, shape=(40, 3), strides=(8, 8))
    assert len(augicp.Cloud(overlapping)) == 40


@pytest.mark.parametrize("matrix", [np.zeros((4, 4)), np.full((4, 4), np.nan), np.diag([1, 1, -1, 1.0]),
                                    np.diag([2, 2, 2, 1.0]), np.eye(4)[::-1]])
def test_a_guess_that_is_no_rigid_motion(matrix):
    with pytest.raises(augicp.ArgumentError, match="initial"):
        augicp.align(POINTS, POINTS, matrix)


@pytest.mark.parametrize("options", [
    {"radius": -1}, {"radius": 0}, {"radius": float("nan")}, {"voxel_size": float("inf")}, {"max_distance": 0.0},
    {"max_iterations": 0}, {"max_iterations": 2**40}, {"max_iterations": 2**100}, {"min_step": -1.0}, {"threads": -1},
    {"method": "icp"}, {"preset": "Default"}, {"association": ""}, {"damping": -1.0}, {"method": "\udcff"}, {"classifier": "x"},
    {"association": "projective"}])
def test_options_out_of_their_range(options):
    with pytest.raises(augicp.ArgumentError, match=next(iter(options))):
        augicp.align(POINTS, POINTS, **options)


@pytest.mark.parametrize("options", [
    {"radius": "1"}, {"radius": True}, {"radius": 1j}, {"radius": [1]}, {"max_iterations": 2.5}, {"max_iterations": True},
    {"max_iterations": None}, {"search": 1}, {"search": "no"}, {"method": None}, {"method": 1}, {"threads": "all"},
    {"max_angle": None}, {"classifier": 0}, {"radius": object()}])
def test_options_of_the_wrong_kind(options):
    with pytest.raises(augicp.ArgumentTypeError, match=next(iter(options)) + ": expected"):
        augicp.align(POINTS, POINTS, **options)


def test_numbers_of_any_kind_are_numbers():
    options = augicp.align(POINTS, POINTS, radius=np.float32(0.5), max_iterations=np.int64(3), search=np.bool_(False),
                           max_distance=Fraction(1, 2), voxel_size=None).options
    assert (options["radius"], options["max_iterations"], options["search"], options["max_distance"]) == (0.5, 3, False, 0.5)


def test_unknown_options_name_those_that_look_alike():
    for call in (lambda **options: augicp.align(POINTS, POINTS, **options),
                 lambda **options: augicp.estimate_surface(POINTS, **options),
                 lambda **options: augicp.Odometry("tum-fr1", **options)):
        with pytest.raises(TypeError, match="'max_iteration'; did you mean max_iterations"):
            call(max_iteration=3)
        with pytest.raises(augicp.ArgumentTypeError, match="there are .*voxel_size"):
            call(xyzzy=3)
    with pytest.raises(augicp.ArgumentTypeError, match="did you mean .*max_difference_s"):
        augicp.evaluate("a", "b", max_difference=1)


def test_exceptions_have_one_base_and_python_s_own():
    for made, own in ((augicp.ArgumentError, ValueError), (augicp.ArgumentTypeError, TypeError), (augicp.FileError, OSError)):
        assert issubclass(made, augicp.Error) and issubclass(made, own)
        assert str(made("text")) == "text"


def test_wrong_depth_images():
    metres = np.ones((480, 640), np.float32)
    for image in (np.ones(5), np.ones((4, 4, 1)), np.float32(1)):
        with pytest.raises(augicp.ArgumentError, match="height, width"):
            augicp.Cloud.from_depth(image, "525 525 319.5 239.5")
    with pytest.raises(augicp.ArgumentTypeError, match="depth_scale"):
        augicp.Cloud.from_depth(metres.astype(np.uint16), "525 525 319.5 239.5")
    with pytest.raises(augicp.ArgumentError, match="65535, found -1"):
        augicp.Cloud.from_depth(np.full((4, 4), -1), "525 525 319.5 239.5", 1000)
    with pytest.raises(augicp.ArgumentError, match="is the depth scale"):
        augicp.Cloud.from_depth(metres * 1000, "525 525 319.5 239.5")
    for scale in (0, -1, float("nan"), float("inf")):
        with pytest.raises(augicp.ArgumentError, match="depth_scale"):
            augicp.Cloud.from_depth(metres, "525 525 319.5 239.5", scale)
    with pytest.raises(augicp.ArgumentError, match="640 x 480"):
        augicp.Cloud.from_depth(metres, augicp.Camera(525, 525, 319.5, 239.5, width=320, height=240))


def test_wrong_cameras():
    for camera in (None, 1, [525, 525, 319.5, 239.5], object()):
        with pytest.raises(augicp.ArgumentTypeError, match="camera"):
            augicp.Odometry(camera)
    with pytest.raises(augicp.FileError, match="tum-fr1"):
        augicp.Odometry("no such camera")
    for numbers in ((0, 525, 0, 0), (525, float("nan"), 0, 0)):
        with pytest.raises(augicp.ArgumentError):
            augicp.Camera(*numbers)
    with pytest.raises(augicp.ArgumentError, match="distortion"):
        augicp.Camera(525, 525, 320, 240, distortion=[0.1])


def test_an_array_that_another_thread_changes_breaks_nothing():
    points, done = POINTS.repeat(40, axis=0), threading.Event()

    def change():
        values = [np.nan, 1e30, 0.0, 5e6]
        while not done.is_set():
            points[:] = values[0]
            points[::2] = values[-1]
            values.append(values.pop(0))

    changer = threading.Thread(target=change)
    changer.start()
    try:
        for _ in range(20):
            assert len(augicp.Cloud(points)) <= len(points)
            augicp.align(points, POINTS, threads=2, search=False, max_iterations=2)
    finally:
        done.set()
        changer.join()
