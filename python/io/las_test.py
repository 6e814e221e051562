# SPDX-License-Identifier: MIT
"""LAS files against laspy, a second reader and writer. Skipped where it is not installed."""
import numpy as np
import pytest

import augicp
from conftest import run_command

laspy = pytest.importorskip("laspy", reason="laspy is not installed: LAS files have no second opinion here")
POINTS = 100 * np.random.default_rng(5).random((200, 3))


def las_of(version, point_format):
    header = laspy.LasHeader(version=version, point_format=point_format)
    header.scales, header.offsets = (0.001, 0.001, 0.001), (500000, 4000000, 0)
    header.add_extra_dim(laspy.ExtraBytesParams("height", "float32"))
    las = laspy.LasData(header)
    las.xyz = POINTS + header.offsets
    random = np.random.default_rng(7)
    for name in ("intensity", "user_data", "point_source_id"):
        las[name] = random.integers(0, 200, len(POINTS))
    las.height = random.random(len(POINTS), dtype="f4")
    return las


KINDS = [("1.2", 0), ("1.2", 3), ("1.3", 1), ("1.4", 6), ("1.4", 7)]


@pytest.mark.parametrize("version, point_format", KINDS)
def test_positions(tmp_path, version, point_format):
    las = las_of(version, point_format)
    las.write(tmp_path / "a.las")
    assert np.allclose(augicp.read(tmp_path / "a.las").points, las.xyz, rtol=0, atol=1e-5)


@pytest.mark.parametrize("version, point_format", KINDS)
def test_an_aligned_file_is_one_again(tmp_path, version, point_format):
    las = las_of(version, point_format)
    las.write(tmp_path / "a.las")
    (tmp_path / "T.txt").write_text("1 0 0 0.5\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
    run_command("align", tmp_path / "a.las", tmp_path / "a.las", "--output", tmp_path / "b.las", "--quiet")
    found = laspy.read(tmp_path / "b.las")
    assert np.abs(found.xyz - las.xyz).max() < 0.0015
    assert list(found.header.scales) == [0.001] * 3 and found.header.version == las.header.version
    for name in las.point_format.dimension_names:
        if name not in ("X", "Y", "Z"):
            assert np.array_equal(found[name], las[name]), name


def test_any_cloud(tmp_path):
    augicp.write(tmp_path / "a.las", augicp.Cloud(POINTS, POINTS - 50))
    found = laspy.read(tmp_path / "a.las")
    assert np.allclose(found.xyz, POINTS, rtol=0, atol=1e-5)
    normals = np.column_stack([found["nx"], found["ny"], found["nz"]])
    assert np.allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)


def test_compressed(tmp_path):
    if not laspy.LazBackend.detect_available():
        pytest.skip("laspy has no backend for LAZ here")
    las = las_of("1.4", 6)
    las.write(tmp_path / "a.laz")
    assert np.allclose(augicp.read(tmp_path / "a.laz").points, las.xyz, rtol=0, atol=1e-5)
    assert "laspy decompress" in run_command("info", tmp_path / "a.laz").stderr
    (tmp_path / "b.laz").write_bytes((tmp_path / "a.laz").read_bytes()[:500])
    with pytest.raises(augicp.FileError, match="b.laz"):
        augicp.read(tmp_path / "b.laz")
