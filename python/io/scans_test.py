# SPDX-License-Identifier: MIT
"""Scans of folders and recordings: the same clouds by name and one after the other, and the command's trajectory."""
import struct

import numpy as np
import pytest

import augicp
from conftest import run_command

NUM_SCANS = 3


def points_of(k):
    """A room's walls from a place that moves, in the order of their azimuth; the last scan has no finite point."""
    if k == NUM_SCANS:
        return np.full((4, 3), np.nan, np.float32)
    azimuth, elevation = np.meshgrid(np.linspace(0, 2 * np.pi, 240, endpoint=False) + 1e-3, np.deg2rad(np.linspace(-25, 25, 32)), indexing="ij")
    rays = np.stack([np.cos(elevation) * np.cos(azimuth), np.cos(elevation) * np.sin(azimuth), np.sin(elevation)], -1).reshape(-1, 3)
    place = np.array([0.1 * k, 0.05 * k, 0.0])
    corners = np.array([[-4.0, -3.0, -1.5], [5.0, 4.0, 1.5]])
    reach = np.max((corners - place)[:, None] / rays, axis=0).min(axis=1)
    return (rays * reach[:, None]).astype(np.float32)


def message_of(k, with_times):
    """PointCloud2 in CDR."""
    points = points_of(k)
    names = ["x", "y", "z"] + (["t"] if with_times else [])
    rows = np.zeros(len(points), [(name, "<u4" if name == "t" else "<f4") for name in names])
    for axis, name in enumerate("xyz"):
        rows[name] = points[:, axis]
    if with_times:
        rows["t"] = np.linspace(0, 1e8, len(points))

    def text(words):
        return pad() + struct.pack("<I", len(words) + 1) + words + b"\0"

    def pad():
        return bytes(-len(out) % 4)
    out = b"\0\1\0\0" + struct.pack("<II", 100 + k, 0)
    out += text(b"lidar")
    out += pad() + struct.pack("<III", 1, len(rows), len(names))
    for name in names:
        out += text(name.encode())
        out += pad() + struct.pack("<IB", rows.dtype.fields[name][1], 6 if name == "t" else 7)
        out += pad() + struct.pack("<I", 1)
    out += b"\0"
    out += pad() + struct.pack("<III", rows.itemsize, rows.nbytes, rows.nbytes)
    return out + rows.tobytes() + b"\1"


def write_mcap(path, topics):
    def record(opcode, content):
        return struct.pack("<BQ", opcode, len(content)) + content

    def text(words):
        return struct.pack("<I", len(words)) + words
    magic = b"\x89MCAP0\r\n"
    out = magic + record(1, text(b"ros2") + text(b"")) + record(3, struct.pack("<H", 1) + text(b"sensor_msgs/msg/PointCloud2") + text(b"ros2msg") + text(b""))
    for number, (topic, messages) in enumerate(topics.items(), 1):
        out += record(4, struct.pack("<HH", number, 1) + text(topic.encode()) + text(b"cdr") + struct.pack("<I", 0))
        out += b"".join(record(5, struct.pack("<HIQQ", number, 0, 7, 7) + message) for message in messages)
    path.write_bytes(out + record(15, bytes(4)) + record(2, bytes(20)) + magic)
    return path


@pytest.fixture(scope="module")
def drive(tmp_path_factory):
    messages = [message_of(k, with_times=True) for k in range(NUM_SCANS + 1)]
    return write_mcap(tmp_path_factory.mktemp("drive") / "a.mcap", {"/points": messages})


def test_clouds_of_a_recording_have_names(drive):
    for name in ("#1", "#/points#1"):
        assert np.array_equal(augicp.read(f"{drive}{name}").points, points_of(1))
    expected = augicp.align(points_of(1), points_of(0))
    assert np.array_equal(augicp.align(f"{drive}#1", f"{drive}#0").T_target_source, expected.T_target_source)
    for path, words in ((drive, "the first of its clouds is"), (f"{drive}#9", "has no message 9 of /points: the last of its 4 messages is 3"),
                        (f"{drive}#last", "expected the number of a message"), (f"{drive}#3", "no point|finite")):
        with pytest.raises(augicp.FileError, match=words):
            augicp.read(path)


def test_a_recording_is_a_sequence(drive):
    sequence = augicp.read_scan_sequence(drive)
    assert (sequence.layout, sequence.topic, len(sequence)) == ("recording", "/points", NUM_SCANS + 1)
    assert list(sequence.stamps) == [100, 101, 102, 103]
    with pytest.warns(UserWarning, match="a.mcap#/points#3: .*: left out"):
        scans = list(sequence)
    assert len(scans) == NUM_SCANS
    for k, (stamp, cloud, times) in enumerate(scans):
        assert stamp == sequence.stamps[k] and np.array_equal(cloud.points, points_of(k))
        assert np.array_equal(times, np.linspace(0, 1e8, len(cloud)).astype(np.uint32))
        assert np.array_equal(augicp.read(sequence.paths[k]).points, cloud.points)
    first, second = iter(sequence), iter(sequence)
    assert next(first)[0] == next(second)[0] == 100 and next(first)[0] == 101


@pytest.mark.filterwarnings("ignore:.*left out")
def test_a_recording_gives_the_command_s_trajectory(drive, tmp_path):
    odometry = augicp.LidarOdometry(sweep_s=0.1)
    for stamp, cloud, times in augicp.read_scan_sequence(drive):
        assert odometry.add(cloud, stamp, times) is not None, stamp
    finished = run_command("odometry", drive, "--output", tmp_path / "out", "--quiet")
    assert finished.returncode == 0, finished.stderr
    command = augicp.read_trajectory(tmp_path / "out/trajectory.txt")
    assert np.allclose(command.poses, odometry.trajectory.poses, rtol=0, atol=1e-9)


def test_scans_of_a_folder(tmp_path):
    for k in range(2):
        np.column_stack([points_of(k), np.zeros(len(points_of(k)), np.float32)]).astype("<f4").tofile(tmp_path / f"{k}.bin")
    sequence = augicp.read_scan_sequence(tmp_path, scans_per_s=20)
    assert [(stamp, times) for stamp, _, times in sequence] == [(0, "order"), (0.05, "order")]
    assert sequence.topic == "" and sequence.paths[1].endswith("1.bin") and "2 scans" in repr(sequence)
    with pytest.raises(augicp.FileError, match="expected a recording"):
        augicp.read_scan_sequence(tmp_path, topic="/points")


def test_what_a_folder_leaves_out_is_a_warning(tmp_path):
    for k in range(3):
        np.zeros((200, 4), "<f4").tofile(tmp_path / f"{k}.bin")
    augicp.write(tmp_path / "map.ply", points_of(0))
    (tmp_path / "times.txt").write_text("0\n200000000\n100000000\n")
    with pytest.warns(UserWarning) as caught:
        sequence = augicp.read_scan_sequence(tmp_path)
    assert [str(warning.message) for warning in caught] == sequence.warnings
    left_out, unit = sequence.warnings
    assert "3 .bin scans are read, and 1 .ply left out" in left_out and "read as nanoseconds" in unit
    assert np.allclose(sequence.stamps, [0, 0.2, 0.1])


def test_what_a_folder_of_images_leaves_out_is_a_warning(tmp_path):
    for name in ("1.png", "2.png", "1.pgm"):
        (tmp_path / name).write_bytes(b"")
    with pytest.warns(UserWarning, match="2 .png images are read, and left out are 1 .pgm"):
        sequence = augicp.read_depth_sequence(tmp_path)
    assert len(sequence.warnings) == 1


def test_the_topic_is_asked_for(tmp_path):
    path = write_mcap(tmp_path / "two.mcap", {"/a": [message_of(0, False)], "/b": [message_of(1, False)] * 2})
    for call in (augicp.read_scan_sequence, lambda bag: augicp.read(f"{bag}#0")):
        with pytest.raises(augicp.FileError, match=r"which topic\? It has /a \(1\), /b \(2\)"):
            call(path)
    (_, cloud, times), _ = augicp.read_scan_sequence(path, "/b")
    assert times == "order" and np.array_equal(cloud.points, augicp.read(f"{path}#/b#1").points)
