# SPDX-License-Identifier: MIT
"""Files: what is written is read again, with the command's words for what is wrong."""
import numpy as np
import pytest

import augicp
from conftest import DESK, IMAGES, ROOM, run_command

POINTS = np.random.default_rng(5).random((20, 3))


@pytest.mark.parametrize("name", ["a.ply", "a.pcd", "ä b.ply"])
def test_clouds(tmp_path, name):
    cloud = augicp.Cloud(POINTS, POINTS - 0.5)
    augicp.write(tmp_path / name, cloud)
    again = augicp.read(str(tmp_path / name))
    assert np.array_equal(again.points, cloud.points)
    assert np.allclose(again.directions, cloud.directions, atol=1e-7)
    augicp.write(tmp_path / name, POINTS)
    assert np.array_equal(augicp.read(tmp_path / name).points, POINTS.astype(np.float32))


def test_depth_images(tmp_path):
    image = augicp.read_depth(IMAGES[0], 5000)
    assert image.shape == (480, 640) and image.dtype == np.float32 and np.isnan(image).any()
    augicp.write_depth(tmp_path / "a.png", image, 5000)
    assert np.array_equal(augicp.read_depth(tmp_path / "a.png", 5000), image, equal_nan=True)
    with pytest.raises(augicp.ArgumentTypeError, match="camera and depth_scale"):
        augicp.read(IMAGES[0])
    with pytest.raises(augicp.FileError, match="is the depth scale"):
        augicp.read(IMAGES[0], "tum-fr1", 5)


def test_depth_images_of_other_forms(tmp_path):
    image = augicp.read_depth(IMAGES[0], 5000)
    readings = np.nan_to_num(image)
    np.save(tmp_path / "a.npy", readings)
    height, width = image.shape
    (tmp_path / "a.pfm").write_bytes(b"Pf\n%d %d\n-1\n" % (width, height) + readings[::-1].astype("<f4").tobytes())
    (tmp_path / "a.pgm").write_bytes(b"P5\n%d %d\n65535\n" % (width, height) + np.round(5000 * readings).astype(">u2").tobytes())
    expected = augicp.read(IMAGES[0], "tum-fr1").points  # its name brings the scale
    for name, options in (("a.npy", {}), ("a.pfm", {}), ("a.pgm", {"depth_scale": 5000})):
        assert np.array_equal(augicp.read_depth(tmp_path / name, 5000), image, equal_nan=True), name
        assert np.array_equal(augicp.read(tmp_path / name, "tum-fr1", **options).points, expected), name
    augicp.write(tmp_path / "a.ply", POINTS)
    with pytest.raises(augicp.ArgumentError, match="goes with a depth image"):
        augicp.read(tmp_path / "a.ply", "tum-fr1")


def test_transforms(tmp_path):
    motion = augicp.read_transform(ROOM / "T_target_source.txt")
    augicp.write_transform(tmp_path / "T.txt", motion)
    assert np.allclose(augicp.read_transform(tmp_path / "T.txt"), motion, rtol=0, atol=1e-15)


def test_trajectories(tmp_path):
    truth = augicp.read_trajectory(DESK / "groundtruth.txt")
    augicp.write_trajectory(tmp_path / "t.txt", truth)
    again = augicp.read_trajectory(tmp_path / "t.txt")
    assert np.array_equal(again.poses, truth.poses) and np.array_equal(again.stamps, truth.stamps)
    made = augicp.Trajectory(truth.stamps, truth.poses)
    assert len(made) == len(truth) and np.allclose(made.poses, truth.poses, atol=1e-12)
    for stamps, poses, what in (([1, 0], truth.poses[:2], "increase"), ([0], truth.poses[:2], r"expected shape \(1, 4, 4\)"),
                                ([[0]], truth.poses[:1], "stamps"), ([0], [np.zeros((4, 4))], r"poses\[0\]")):
        with pytest.raises(augicp.ArgumentError, match=what):
            augicp.Trajectory(stamps, poses)


def test_sequences():
    sequence = augicp.read_depth_sequence(DESK)
    assert (sequence.layout, len(sequence), sequence.depth_scale) == ("TUM", 30, 5000)
    stamp, path = sequence.frames[0]
    assert path.name == "1305031455.040446.png" and stamp == 1305031455.040446
    assert len(sequence.truth) > 0 and not sequence.truth_problem


@pytest.mark.parametrize("call", [augicp.read, augicp.read_transform, augicp.read_trajectory, augicp.read_depth_sequence,
                                  lambda path: augicp.read_depth(path, 5000), lambda path: augicp.evaluate(path, path)])
def test_files_that_are_not_there(call, tmp_path):
    with pytest.raises(OSError, match="nothing.ply") as raised:
        call(tmp_path / "nothing.ply")
    assert isinstance(raised.value, augicp.FileError)


def test_the_message_is_the_command_s(tmp_path):
    bad = tmp_path / "bad.ply"
    bad.write_text("ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n")
    with pytest.raises(augicp.FileError) as raised:
        augicp.read(bad)
    assert run_command("info", bad).stderr == f"augicp: {raised.value}\n"
    with pytest.raises(augicp.ArgumentError, match="without points|no points|points"):
        augicp.write(tmp_path / "a.ply", np.empty((0, 3)))
    with pytest.raises(augicp.FileError):
        augicp.write(tmp_path / "no folder/a.ply", POINTS)


def test_warnings_are_python_s(tmp_path):
    cut = tmp_path / "a.xyz"
    cut.write_text("0 0 0\n1 1 1")
    with pytest.warns(UserWarning, match="a.xyz"):
        assert len(augicp.read(cut)) == 2


def test_names_that_are_no_text(tmp_path):
    name = str(tmp_path / "\udcff.ply")
    with pytest.raises(augicp.FileError, match="\udcff.ply"):
        augicp.read(name)
    augicp.write(name, POINTS)
    assert len(augicp.read(name)) == len(POINTS)


def test_paths_of_the_wrong_kind():
    for path in (None, 1, 2.5, object()):
        with pytest.raises(TypeError):
            augicp.read(path)
