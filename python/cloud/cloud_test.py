# SPDX-License-Identifier: MIT
"""Cloud: what goes in comes out, views live as long as they are looked at, depth images of every kind."""
import gc
import pickle
import weakref

import numpy as np
import pytest

import augicp
from conftest import IMAGES

RANDOM = np.random.default_rng(3)
POINTS = RANDOM.random((100, 3)).astype(np.float32)


def test_points_come_back():
    cloud = augicp.Cloud(POINTS)
    assert len(cloud) == 100
    assert cloud.points.dtype == np.float64 and np.array_equal(cloud.points, POINTS)
    assert np.array_equal(np.asarray(cloud), POINTS) and np.asarray(cloud, np.float32).dtype == np.float32
    assert cloud.directions is cloud.structures is cloud.weights is cloud.viewpoint is cloud.image_shape is None
    assert repr(cloud) == "Cloud(100 points)"


def test_far_from_zero_nothing_is_lost():
    far = POINTS.astype(np.float64) + [4e5, 5.5e6, 100.0]
    cloud = augicp.Cloud(far)
    assert np.abs(cloud.origin).max() > 1e6
    assert np.abs(cloud.points - far).max() < 1e-6


def test_normals_belong_to_their_points():
    normals = np.tile([0, 0, 2.0], (100, 1))
    points = POINTS.copy()
    points[3, 0] = np.nan
    normals[5] = 0
    cloud = augicp.Cloud(points, normals, viewpoint=[0, 0, -9])
    assert len(cloud) == 99
    assert np.array_equal(cloud.directions[0], [0, 0, -1])  # turned to the viewpoint
    assert cloud.structures[4] == 0 and cloud.structures.sum() == 98
    assert np.array_equal(cloud.viewpoint, [0, 0, -9])
    assert list(augicp.Cloud(points[:3], normals[:3], [0, 1, 2]).structures) == [0, 1, 2]
    for wrong in ({"normals": normals[:5]}, {"normals": normals[:, :2]}, {"structures": [1] * 100},
                  {"normals": normals, "structures": [1]}, {"viewpoint": [0, 0]}, {"viewpoint": [0, 0, np.inf]}):
        with pytest.raises(augicp.ArgumentError, match=list(wrong)[-1]):
            augicp.Cloud(points, **wrong)


@pytest.mark.parametrize("suffix", ["ply", "pcd", "las"])
def test_intensities_and_colours_stay_with_their_points(suffix, tmp_path):
    points, colours = POINTS.astype(float), RANDOM.integers(0, 256, (100, 3), np.uint8)
    brightness = RANDOM.integers(0, 1000, 100).astype(np.float32)
    points[7] = np.nan
    kept = np.arange(100) != 7
    cloud = augicp.Cloud(points, viewpoint=[0, 0, 9], intensities=brightness, colors=colours)
    aligned = cloud.transformed(augicp.align(cloud, cloud).T_target_source)
    augicp.write(tmp_path / f"a.{suffix}", aligned)
    for found in (cloud, pickle.loads(pickle.dumps(cloud)), aligned, augicp.read(tmp_path / f"a.{suffix}")):
        assert np.array_equal(found.colors, colours[kept]) and found.colors.dtype == np.uint8
        assert np.array_equal(found.intensities, brightness[kept])


def test_colours_are_bytes_or_shares():
    rows = np.array([[0, 51, 255], [102, 0, 0]])
    for same in (rows.astype(np.uint8), rows, rows / 255, rows.astype(np.float32), (rows * 257).astype(np.uint16)):
        assert np.array_equal(augicp.Cloud(POINTS[:2], colors=same).colors, rows)
    for wrong in (rows[:1], np.zeros((2, 4)), np.zeros(2)):
        with pytest.raises(augicp.ArgumentError, match="colors"):
            augicp.Cloud(POINTS[:2], colors=wrong)
    with pytest.raises(augicp.ArgumentError, match="intensities"):
        augicp.Cloud(POINTS[:2], intensities=[1])


def test_views_are_read_only_and_keep_the_cloud_alive():
    cloud = augicp.Cloud(POINTS, POINTS)
    owner = weakref.ref(cloud) if hasattr(cloud, "__weakref__") else lambda: None
    views = [cloud.points_from_origin, cloud.directions, cloud.structures]
    copies = [view.copy() for view in views]
    assert views[0].ctypes.data == cloud.points_from_origin.ctypes.data
    del cloud
    gc.collect()
    spoil = [augicp.Cloud(RANDOM.random((100, 3))) for _ in range(50)]
    assert all(np.array_equal(view, copy) for view, copy in zip(views, copies)), (owner(), spoil)
    for view in views:
        with pytest.raises(ValueError):
            view[0] = 0
        with pytest.raises(ValueError):
            view.flags.writeable = True


def test_an_empty_cloud_has_empty_arrays():
    cloud = augicp.Cloud(np.empty((0, 3)))
    assert cloud.points.shape == cloud.points_from_origin.shape == (0, 3)
    assert len(augicp.Cloud(np.full((9, 3), np.nan))) == 0


def test_it_moves():
    motion = np.array([[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1.0]])
    cloud = augicp.Cloud(POINTS, np.tile([1, 0, 0], (100, 1)))
    moved = cloud.transformed(motion)
    assert np.allclose(moved.points, POINTS @ motion[:3, :3].T + motion[:3, 3], atol=1e-6)
    assert np.allclose(moved.directions[0], [0, 1, 0], atol=1e-6)
    assert np.array_equal(cloud.points, POINTS)
    with pytest.raises(augicp.ArgumentError, match="matrix"):
        cloud.transformed(np.zeros((4, 4)))


def images_of_a_slope():
    millimetres = np.add.outer(np.arange(48), np.arange(64)).astype(np.uint16) + 500
    millimetres[3, 4], millimetres[5, 6] = 0, 65535
    metres = millimetres.astype(np.float32) / 1000
    metres[3, 4], metres[5, 6] = np.nan, -1
    wide = np.zeros((48, 128), np.uint16)
    wide[:, ::2] = millimetres
    masked = np.ma.masked_equal(np.where(millimetres == 65535, 0, millimetres), 0)
    return {"uint16": (millimetres, 1000), "int32": (millimetres.astype(np.int32), 1000),
            "big endian": (millimetres.astype(">u2"), 1000), "every other column": (wide[:, ::2], 1000),
            "Fortran": (np.asfortranarray(millimetres), 1000), "metres": (metres, None), "float64": (metres.astype(float), None),
            "list": (millimetres.tolist(), 1000), "masked": (masked, 1000), "float mm": (metres * 1000, 1000)}


def test_depth_images_of_every_kind_give_the_same_cloud():
    camera = augicp.Camera(50, 50, 31.5, 23.5)
    clouds = {name: augicp.Cloud.from_depth(image, camera, scale) for name, (image, scale) in images_of_a_slope().items()}
    expected = clouds["uint16"]
    assert len(expected) == 48 * 64 - 2 and expected.image_shape == (48, 64)
    assert expected.weights.max() <= 1 and np.array_equal(expected.viewpoint, [0, 0, 0])
    assert np.array_equal(expected.points[0], np.float32([0.5 * -31.5 / 50, 0.5 * -23.5 / 50, 0.5]).astype(float))
    for name, cloud in clouds.items():
        assert np.allclose(cloud.points, expected.points, rtol=1e-6), name


def test_a_black_image_is_an_empty_cloud():
    cloud = augicp.Cloud.from_depth(np.zeros((4, 5), np.uint16), "50 50 2 2", 1000)
    assert len(cloud) == 0 and not augicp.align(cloud, cloud)
    assert len(augicp.Cloud.from_depth(np.zeros((0, 0), np.uint16), "50 50 2 2", 1000)) == 0


def test_pickles_hold_the_same_bits():
    for cloud in (augicp.Cloud(POINTS + 1000, POINTS, viewpoint=[1, 2, 3]), augicp.read(IMAGES[0], "tum-fr1", 5000)):
        again = pickle.loads(pickle.dumps(cloud))
        for name in ("points_from_origin", "origin", "directions", "structures", "weights", "viewpoint", "image_shape"):
            assert np.array_equal(getattr(again, name), getattr(cloud, name)), name
        assert augicp.align(again, cloud).T_target_source.tolist() == augicp.align(cloud, cloud).T_target_source.tolist()
    state = list(augicp.Cloud(POINTS).__reduce_ex__(2)[2])
    state[1] = state[1][:-1]
    with pytest.raises(augicp.ArgumentError, match="pickled"):
        augicp.Cloud.__new__(augicp.Cloud).__setstate__(tuple(state))


def test_a_surface_has_directions(room):
    extended = augicp.estimate_surface(room[0].points, voxel_size=0.05)
    assert len(extended) < len(room[0])
    lengths = np.linalg.norm(extended.directions, axis=1)
    assert np.allclose(lengths[extended.structures > 0], 1, atol=1e-5) and not lengths[extended.structures == 0].any()
    assert (extended.structures == 1).mean() > 0.5
    with pytest.raises(augicp.ArgumentError, match="points are equal"):
        augicp.estimate_surface(np.ones((9, 3)))


def test_cameras():
    camera = augicp.Camera.read("tum-fr1")
    assert camera.distortion[0] != 0 and "tum-fr1" in augicp.Camera.names()
    assert repr(pickle.loads(pickle.dumps(camera))) == repr(camera)
