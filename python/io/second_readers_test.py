# SPDX-License-Identifier: MIT
"""Depth images in TIFF and scenes in glTF against other writers. Skipped where these are not installed."""
import numpy as np
import pytest

import augicp

RANDOM = np.random.default_rng(11)
ROWS, COLUMNS = np.mgrid[:150, :200]
MILLIMETRES = (1500 + 5 * COLUMNS + 3 * ROWS + RANDOM.integers(0, 9, ROWS.shape)).astype("u2")
MILLIMETRES[20:40, 30:70] = 0


def expect_image(path, metres, atol=1e-6):
    found = augicp.read_depth(path, 1000)
    expected = np.where(metres > 0, metres, np.nan)
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=atol)


@pytest.mark.parametrize("compression", (None, "tiff_lzw", "tiff_adobe_deflate", "packbits"))
def test_tiff_of_libtiff(tmp_path, compression):
    images = pytest.importorskip("PIL.Image", reason="Pillow is not installed")
    images.fromarray(MILLIMETRES).save(tmp_path / "a.tif", compression=compression)
    expect_image(tmp_path / "a.tif", MILLIMETRES / 1000)
    images.fromarray((MILLIMETRES / 1000).astype("f4")).save(tmp_path / "b.tiff", compression=compression)
    expect_image(tmp_path / "b.tiff", MILLIMETRES / 1000)


@pytest.mark.parametrize("options", ({}, {"byteorder": ">"}, {"rowsperstrip": 7}, {"tile": (32, 48)}, {"compression": "zlib"},
                                     {"compression": "zlib", "tile": (64, 64), "byteorder": ">"}))
def test_tiff_of_tifffile(tmp_path, options):
    tifffile = pytest.importorskip("tifffile", reason="tifffile is not installed")
    for values in (MILLIMETRES, (MILLIMETRES / 1000).astype("f4"), MILLIMETRES / 1000):
        tifffile.imwrite(tmp_path / "a.tif", values, **options)
        expect_image(tmp_path / "a.tif", MILLIMETRES / 1000)
    tifffile.imwrite(tmp_path / "big.tif", MILLIMETRES, bigtiff=True)
    with pytest.raises(augicp.FileError, match="BigTIFF"):
        augicp.read_depth(tmp_path / "big.tif", 1000)


def scene_of_trimesh(trimesh):
    scene = trimesh.Scene()
    turned = trimesh.transformations.rotation_matrix(0.7, (1, 2, 3), (0.5, 0, 0))
    scene.add_geometry(trimesh.creation.box((1, 2, 3)), transform=turned)
    scene.add_geometry(trimesh.creation.cylinder(0.5, 2.0, sections=16), transform=trimesh.transformations.translation_matrix((4, 0, 1)))
    scene.add_geometry(trimesh.creation.icosphere(1), transform=np.diag((-2.0, 1.0, 1.0, 1.0)))
    return scene


def test_gltf_of_trimesh(tmp_path):
    trimesh = pytest.importorskip("trimesh", reason="trimesh is not installed")
    scene = scene_of_trimesh(trimesh)
    scene.export(tmp_path / "a.glb")
    for name, content in scene.export(file_type="gltf").items():
        (tmp_path / name).write_bytes(content)
    loaded = trimesh.load(tmp_path / "a.glb")
    triangles = np.concatenate([mesh.triangles for mesh in loaded.dump()])
    binary, text = augicp.read(tmp_path / "a.glb"), augicp.read(tmp_path / "model.gltf")
    for cloud in (binary, text):
        some = cloud.points[RANDOM.choice(len(cloud.points), 200, replace=False)]
        repeated = np.repeat(some, len(triangles), axis=0), np.tile(triangles, (len(some), 1, 1))
        nearest = trimesh.triangles.closest_point(repeated[1], repeated[0])
        distances = np.linalg.norm(nearest - repeated[0], axis=1).reshape(len(some), -1).min(axis=1)
        assert distances.max() < 1e-5
        reach = cloud.points.max(axis=0) - cloud.points.min(axis=0)
        assert np.allclose(cloud.points.min(axis=0), loaded.bounds[0], atol=0.02 * reach.max())
        assert np.allclose(cloud.points.max(axis=0), loaded.bounds[1], atol=0.02 * reach.max())
