#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""`augicp odometry` on recordings: the scans of lidar_test.py's hall as bags of ROS 1 and ROS 2 and as MCAP, against the
same scans in a folder.

    bag_test.py COMMAND PROJECT
"""
import bz2
import contextlib
import json
import sqlite3
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

from lidar_test import distances, rows_of, run, scan, world_from_sensor

NUM_SCANS, START_S, GAP_S = 5, 1_700_000_000, 0.1
FIELDS = [("x", "<f4", 7), ("y", "<f4", 7), ("z", "<f4", 7), ("intensity", "<f4", 7), ("t", "<u4", 6)]


def stamp_ns(k):
    return START_S * 10**9 + k * round(GAP_S * 1e9)


class Message:
    """Bytes of a message; CDR aligns numbers from behind its first four bytes, and ends texts with a zero."""

    def __init__(self, is_cdr):
        self.is_cdr, self.data = is_cdr, bytearray(b"\0\1\0\0" if is_cdr else b"")

    def numbers(self, *values):
        self.data.extend(bytes(-len(self.data) % 4 if self.is_cdr else 0) + struct.pack(f"<{len(values)}I", *values))

    def text(self, words):
        self.numbers(len(words) + self.is_cdr)
        self.data.extend(words.encode() + b"\0" * self.is_cdr)

    def header(self, stamp, frame):
        self.numbers(*(() if self.is_cdr else (0,)), stamp // 10**9, stamp % 10**9)
        self.text(frame)


def point_cloud2(is_cdr, k, points):
    """times: of 0 to 0.1 s, nanoseconds."""
    rows = np.zeros(len(points), np.dtype({"names": [f[0] for f in FIELDS], "formats": [f[1] for f in FIELDS]}))
    for i, name in enumerate(("x", "y", "z", "intensity")):
        rows[name] = points[:, i]
    rows["t"] = np.linspace(0, 1e8, len(points))
    message = Message(is_cdr)
    message.header(stamp_ns(k), "lidar")
    message.numbers(1, len(points), len(FIELDS))
    for name, _, kind in FIELDS:
        message.text(name)
        message.numbers(rows.dtype.fields[name][1])
        message.data.append(kind)
        message.numbers(1)
    message.data.append(0)
    message.numbers(rows.itemsize, rows.nbytes, rows.nbytes)
    return bytes(message.data) + rows.tobytes() + b"\1"


NUM_COLUMNS, NUM_RINGS = 480, 32


def skewed_scan(k):
    """(N, 4) points of a sweep that begins half a scan before the pose k, column after column."""
    elevations = np.deg2rad(np.linspace(-30.0, 20.0, NUM_RINGS))
    columns = []
    for share, azimuth in zip(np.linspace(0.0, 1.0, NUM_COLUMNS), np.linspace(-np.pi, np.pi, NUM_COLUMNS, endpoint=False) + 1e-3):
        rays = np.stack([np.cos(elevations) * np.cos(azimuth), np.cos(elevations) * np.sin(azimuth), np.sin(elevations)], axis=-1)
        pose = world_from_sensor(k + share - 0.5)
        columns.append(rays * distances(pose[:3, 3], rays @ pose[:3, :3].T)[:, None])
    points = np.concatenate(columns)
    return np.column_stack([points, np.full(len(points), 0.5)]).astype("<f4")


def text(words):
    return struct.pack("<I", len(words)) + words


def mcap(topics):
    """topics: of each its name, its type, and (stamp, message)."""
    def record(opcode, content):
        return struct.pack("<BQ", opcode, len(content)) + content
    magic = b"\x89MCAP0\r\n"
    out = magic + record(1, text(b"ros2") + text(b""))
    for i, (topic, kind, messages) in enumerate(topics, 1):
        out += record(3, struct.pack("<H", i) + text(kind) + text(b"ros2msg") + text(b""))
        out += record(4, struct.pack("<HH", i, i) + text(topic) + text(b"cdr") + struct.pack("<I", 0))
        out += b"".join(record(5, struct.pack("<HIQQ", i, 0, stamp, 0) + data) for stamp, data in messages)
    return out + record(15, bytes(4)) + record(2, bytes(20)) + magic


def rosbag1(messages):
    def header(**values):
        return text(b"".join(text(name.encode() + b"=" + value) for name, value in values.items()))
    chunk = header(op=b"\7", conn=bytes(4), topic=b"/points") + header(topic=b"/points", type=b"sensor_msgs/PointCloud2")
    for k, data in enumerate(messages):
        time = struct.pack("<II", stamp_ns(k) // 10**9, stamp_ns(k) % 10**9)
        chunk += header(op=b"\2", conn=bytes(4), time=time) + text(data)
    return (b"#ROSBAG V2.0\n" + header(op=b"\3", index_pos=struct.pack("<Q", 99)) + text(b" " * 20) +
            header(op=b"\5", compression=b"bz2", size=struct.pack("<I", len(chunk))) + text(bz2.compress(chunk)))


def write_db3(path, messages):
    with sqlite3.connect(path) as database:
        database.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT)")
        database.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)")
        database.execute("INSERT INTO topics VALUES(1, '/points', 'sensor_msgs/msg/PointCloud2')")
        for k, data in messages:
            database.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(1, ?, ?)", (stamp_ns(k), data))
    database.close()


def write_folder(folder, clouds):
    """Ordinary scans, PCD with the same fields."""
    folder.mkdir()
    for k, points in enumerate(clouds):
        rows = np.frombuffer(point_cloud2(False, k, points)[:-1][-20 * len(points):], np.uint8)
        head = (f"VERSION 0.7\nFIELDS x y z intensity t\nSIZE 4 4 4 4 4\nTYPE F F F F U\nCOUNT 1 1 1 1 1\n"
                f"WIDTH {len(points)}\nHEIGHT 1\nPOINTS {len(points)}\nDATA binary\n")
        (folder / f"{k}.pcd").write_bytes(head.encode() + rows.tobytes())
    (folder / "times.txt").write_text("".join(f"{stamp_ns(k) / 1e9:.9f}\n" for k in range(len(clouds))))


def counts_of(bag):
    info = subprocess.run([sys.argv[1], "info", bag, "--json", "-"], capture_output=True, text=True, check=True)
    return {topic["name"]: topic["num_messages"] for topic in json.loads(info.stdout)["topics"]}


def messages_of(bag, topic):
    """(stamp in nanoseconds, message), by another reader: mcap and mcap-ros2-support, from the index and the summary."""
    try:
        from mcap.reader import make_reader
        from mcap_ros2.decoder import DecoderFactory
    except ImportError:
        raise unittest.SkipTest("needs mcap and mcap-ros2-support of PyPI: no second reader of recordings here")
    with open(bag, "rb") as file:
        reader = make_reader(file, decoder_factories=[DecoderFactory()])
        return [(message.log_time, ros) for _, _, message, ros in reader.iter_decoded_messages(topics=[topic])]


class Bags(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.root = Path(cls.scratch.name)
        generator = np.random.default_rng(27)
        clouds = [scan(k, generator) for k in range(NUM_SCANS)]
        write_folder(cls.root / "scans", clouds)
        cdr, ros1 = ([point_cloud2(is_cdr, k, points) for k, points in enumerate(clouds)] for is_cdr in (True, False))
        kind = b"sensor_msgs/msg/PointCloud2"
        stamped = [(stamp_ns(k) + 5, data) for k, data in enumerate(cdr)]
        (cls.root / "a.mcap").write_bytes(mcap([(b"/points", kind, stamped), (b"/others", kind, stamped[:1])]))
        (cls.root / "a.bag").write_bytes(rosbag1(ros1))
        write_db3(cls.root / "a.db3", list(enumerate(cdr)))
        folder = cls.root / "rosbag2"
        folder.mkdir()
        (folder / "metadata.yaml").write_text("rosbag2_bagfile_information:\n")
        write_db3(folder / "rosbag2_2.db3", list(enumerate(cdr))[:2])
        write_db3(folder / "rosbag2_10.db3", list(enumerate(cdr))[2:])
        cls.clouds = clouds
        cls.plain = run(cls.root / "scans", "--output", cls.root / "out", "--quiet")

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def track(self, bag, *options):
        output = self.root / f"{bag}-out"
        return run(self.root / bag, "--output", output, "--quiet", *options), output

    def test_a_recording_gives_the_trajectory_of_its_scans(self):
        self.assertEqual(self.plain.returncode, 0, self.plain.stderr)
        expected = (self.root / "out/trajectory.txt").read_text()
        self.assertEqual(len([line for line in expected.splitlines() if not line.startswith("#")]), NUM_SCANS)
        for bag in ("a.mcap", "a.bag", "a.db3", "rosbag2"):
            finished, output = self.track(bag, "--topic", "/points")
            if "built without" in finished.stderr or "this build lacks" in finished.stderr:
                print(f"skipped: {finished.stderr.strip()}")
                continue
            self.assertEqual((finished.returncode, finished.stderr), (0, ""), bag)
            self.assertEqual((output / "trajectory.txt").read_text(), expected, bag)
            self.assertIn("field t, nanoseconds", json.loads((output / "metrics.json").read_text())["point_times"])
            self.assertTrue(rows_of(output / "frames.csv")[3]["image"].endswith("points#3"))

    def test_results_become_a_recording(self):
        """Poses with covariances, scans and map, by our own reader and by another."""
        result = self.root / "result.mcap"
        finished = run(self.root / "scans", "--output", self.root / "with", "--quiet", "--mcap", result, "--point-times", "none")
        self.assertEqual((finished.returncode, finished.stderr), (0, ""))
        self.assertEqual(counts_of(result), {"/map": 1, "/odometry": NUM_SCANS, "/points": NUM_SCANS, "/tf": NUM_SCANS})
        poses = np.loadtxt(self.root / "with/trajectory.txt")
        odometry, tf = messages_of(result, "/odometry"), messages_of(result, "/tf")
        for row, (stamp, odom), (_, transforms) in zip(poses, odometry, tf, strict=True):
            self.assertAlmostEqual(stamp / 1e9, row[0], 5)
            p, q = odom.pose.pose.position, odom.pose.pose.orientation
            np.testing.assert_allclose([p.x, p.y, p.z, q.x, q.y, q.z, q.w], row[1:], atol=1e-8)
            self.assertEqual((odom.header.frame_id, odom.child_frame_id), ("map", "sensor"))
            t = transforms.transforms[0]
            self.assertEqual((t.header.frame_id, t.child_frame_id, t.transform.translation.x), ("map", "sensor", p.x))
        # A pose moved by its twist meets the middle of its neighbours' motion: R v = dp / dt, and the angle is that between them.
        for k in range(1, NUM_SCANS - 1):
            twist, w = odometry[k][1].twist.twist, lambda v: np.array([v.x, v.y, v.z])
            duration = poses[k + 1, 0] - poses[k - 1, 0]
            x, y, z, s = poses[k, 4:]
            rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * s), 2 * (x * z + y * s)],
                                 [2 * (x * y + z * s), 1 - 2 * (x * x + z * z), 2 * (y * z - x * s)],
                                 [2 * (x * z - y * s), 2 * (y * z + x * s), 1 - 2 * (x * x + y * y)]])
            np.testing.assert_allclose(rotation @ w(twist.linear) * duration, poses[k + 1, 1:4] - poses[k - 1, 1:4], atol=1e-6)
            cosine = abs(poses[k + 1, 4:] @ poses[k - 1, 4:])
            self.assertAlmostEqual(np.linalg.norm(w(twist.angular)) * duration, 2 * np.arccos(min(1.0, cosine)), 4)
        # The file's are about the last keyframe, those of the recording about the sensor.
        listed = np.genfromtxt(self.root / "with/covariances.csv", delimiter=",", skip_header=1)[:, 1:]
        keyframes = [row["keyframe"] == "1" for row in rows_of(self.root / "with/frames.csv")]
        for k, (_, odom) in enumerate(odometry[1:], 1):
            keyframe = max(i for i in range(k) if keyframes[i])
            x, y, z = poses[k, 1:4] - poses[keyframe, 1:4]
            about_sensor = np.eye(6)
            about_sensor[:3, 3:] = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]  # t + r x offset
            covariance = np.zeros((6, 6))
            covariance[np.triu_indices(6)] = listed[k - 1]
            covariance += np.triu(covariance, 1).T
            expected = about_sensor @ covariance @ about_sensor.T
            np.testing.assert_allclose(np.reshape(odom.pose.covariance, (6, 6)), expected, rtol=1e-3, atol=1e-4 * expected.max())
        for k, (_, cloud) in enumerate(messages_of(result, "/points")):
            names = [(field.name, field.offset, field.datatype) for field in cloud.fields]
            self.assertEqual(names, [("x", 0, 7), ("y", 4, 7), ("z", 8, 7), ("intensity", 12, 7)])
            rows = np.frombuffer(cloud.data, "<f4").reshape(-1, 4)
            np.testing.assert_array_equal(rows[:, :3], self.clouds[k][:, :3])

    def test_scans_of_a_recording_are_deskewed_as_their_poses_have_them(self):
        """Sweeps of a moving sensor, with times; in the result each is what the sensor would have seen from its pose."""
        shares = np.repeat(np.linspace(0.0, 1.0, NUM_COLUMNS), NUM_RINGS)
        swept = [skewed_scan(k) for k in range(2 * NUM_SCANS)]
        kind, drive, result = b"sensor_msgs/msg/PointCloud2", self.root / "swept.mcap", self.root / "straight.mcap"
        drive.write_bytes(mcap([(b"/points", kind, [(stamp_ns(k), point_cloud2(True, k, points)) for k, points in enumerate(swept)])]))
        for pose_at, share in (("middle", 0.5), ("end", 1.0)):
            finished = run(drive, "--output", self.root / "swept", "--quiet", "--mcap", result, "--pose-at", pose_at)
            self.assertEqual((finished.returncode, finished.stderr), (0, ""))
            for k, (_, cloud) in list(enumerate(messages_of(result, "/points")))[NUM_SCANS:]:
                found = np.frombuffer(cloud.data, "<f4").reshape(-1, 4)[:, :3]
                now_from_world = np.linalg.inv(world_from_sensor(k + share - 0.5))
                poses = np.array([now_from_world @ world_from_sensor(k + s - 0.5) for s in shares])
                expected = np.einsum("nij,nj->ni", poses[:, :3, :3], swept[k][:, :3]) + poses[:, :3, 3]
                error, before = (np.sqrt(np.mean((points - expected) ** 2)) for points in (found, swept[k][:, :3]))
                self.assertLess(error, 0.1 * before, (pose_at, k))

    def test_aligned_clouds_become_a_recording(self):
        project, result = Path(sys.argv[2]), self.root / "pair.mcap"
        pair = [project / "data/room_pair" / name for name in ("source.ply", "target.ply")]
        finished = subprocess.run([sys.argv[1], "align", *pair, "--mcap", result, "--json", "-"], capture_output=True, text=True)
        self.assertEqual((finished.returncode, finished.stderr), (0, ""))
        self.assertEqual(counts_of(result), {"/odometry": 1, "/source": 1, "/target": 1, "/tf": 1})
        pose = np.array(json.loads(finished.stdout)["T_target_source"])
        given = [np.frombuffer(path.read_bytes().split(b"end_header\n", 1)[1], "<f4").reshape(-1, 3) for path in pair]
        moved, target = (np.frombuffer(messages_of(result, topic)[0][1].data, "<f4").reshape(-1, 3) for topic in ("/source", "/target"))
        np.testing.assert_array_equal(target, given[1])
        np.testing.assert_allclose(moved, given[0] @ pose[:3, :3].T + pose[:3, 3], atol=1e-4)
        p = messages_of(result, "/odometry")[0][1].pose.pose.position
        np.testing.assert_allclose([p.x, p.y, p.z], pose[:3, 3], atol=1e-12)

    def test_compressed_recordings_of_another_writer(self):
        try:
            from mcap.writer import CompressionType, Writer
        except ImportError:
            self.skipTest("needs mcap of PyPI: no second writer of recordings here")
        clouds = [point_cloud2(True, k, points) for k, points in enumerate(self.clouds)]
        for compression in (CompressionType.LZ4, CompressionType.ZSTD):
            path = self.root / f"{compression.name}.mcap"
            with open(path, "wb") as file:
                writer = Writer(file, compression=compression, chunk_size=1 << 16)
                writer.start(profile="ros2")
                schema = writer.register_schema("sensor_msgs/msg/PointCloud2", "ros2msg", b"")
                channel = writer.register_channel("/points", "cdr", schema)
                for k, data in enumerate(clouds):
                    writer.add_message(channel, stamp_ns(k), data, stamp_ns(k))
                writer.finish()
            finished = subprocess.run([sys.argv[1], "unpack", path, "--output", self.root / compression.name],
                                      capture_output=True, text=True)
            if "this build lacks" in finished.stderr:
                print(f"skipped: {finished.stderr.strip()}")
                continue
            self.assertEqual((finished.returncode, finished.stderr), (0, ""))
            for k, points in enumerate(self.clouds):
                body = (self.root / compression.name / f"{k:06}.pcd").read_bytes().split(b"DATA binary\n", 1)[1]
                np.testing.assert_array_equal(np.frombuffer(body, "<f4").reshape(len(points), -1)[:, :4], points)

    def test_parts_of_a_recording_are_chosen(self):
        finished, output = self.track("a.bag", "--first", 1, "--last", 4, "--every", 2)
        if "this build lacks" in finished.stderr:
            self.skipTest(finished.stderr)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual([row["frame"] for row in rows_of(output / "frames.csv")], ["1", "3"])

    def test_scans_of_a_recording_are_inputs(self):
        """`drive.mcap#3` is what its file is: the same pose, the same surface, the same words of info."""
        def said(*arguments):
            finished = subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True)
            return finished.returncode, finished.stdout, finished.stderr
        def pose_of(source, target, *options):
            code, stdout, stderr = said("align", source, target, "--json", "-", *options)
            self.assertEqual((code, stderr), (0, ""))
            return json.loads(stdout)["T_target_source"]
        expected = pose_of(self.root / "scans/3.pcd", self.root / "scans/1.pcd")
        for bag, options in (("a.mcap", ("--topic", "/points")), ("a.bag", ()), ("a.db3", ()), ("rosbag2", ())):
            if any(words in said("info", self.root / bag)[2] for words in ("built without", "this build lacks")):
                print(f"skipped: {bag}")
                continue
            self.assertEqual(pose_of(f"{self.root / bag}#3", f"{self.root / bag}#1", *options), expected, bag)
        scan = f"{self.root / 'a.mcap'}#/points#3"
        self.assertEqual(pose_of(scan, self.root / "scans/1.pcd"), expected)
        for command in ("info", "surface"):
            output = ["--output", self.root / f"{command}.ply"] if command == "surface" else []
            one, other = (said(command, path, *output) for path in (scan, self.root / "scans/3.pcd"))
            self.assertEqual([line for line in one[1].splitlines() if line[:4] not in ("file", "form")],
                             [line for line in other[1].splitlines() if line[:4] not in ("file", "form")])
            self.assertEqual((one[0], one[2]), (0, ""))

    def test_a_recording_for_a_cloud_is_told_what_to_do(self):
        finished = subprocess.run([sys.argv[1], "align", self.root / "a.mcap", self.root / "scans/1.pcd"], capture_output=True, text=True)
        self.assertEqual(finished.returncode, 3)
        for words in ("expected one cloud or depth image", f"{self.root / 'a.mcap'}#0", "augicp info", "--topic", "augicp odometry"):
            self.assertIn(words, finished.stderr)
        for arguments, code, words in ((["info", f"{self.root / 'a.mcap'}#0"], 3, "which topic? It has /others (1), /points (5)"),
                                       (["info", f"{self.root / 'a.mcap'}#last"], 3, "expected the number of a message"),
                                       (["info", f"{self.root / 'a.mcap'}#/points#9"], 3, "has no message 9 of /points: the last of its 5 messages is 4"),
                                       (["info", self.root / "scans/1.pcd", "--topic", "/points"], 2, "goes with a recording"),
                                       (["info", f"{self.root / 'a.mcap'}#/points#0", "--camera", "tum-fr1"], 2, "is a cloud")):
            finished = subprocess.run([sys.argv[1], *map(str, arguments)], capture_output=True, text=True)
            self.assertEqual(finished.returncode, code, finished.stderr)
            self.assertIn(words, finished.stderr)

    def test_a_recording_is_not_replaced_by_a_result(self):
        drive = self.root / "kept.mcap"
        drive.write_bytes((self.root / "a.mcap").read_bytes())
        other = self.root / "scans/../kept.mcap"
        for words in (["odometry", drive, "--topic", "/points", "--output", self.root / "not kept", "--mcap", other],
                      ["align", f"{drive}#/points#1", f"{drive}#/points#0", "--mcap", other]):
            finished = subprocess.run([sys.argv[1], *map(str, words)], capture_output=True, text=True)
            self.assertEqual(finished.returncode, 2, finished.stderr)
            self.assertIn("is an input, and would be replaced", finished.stderr)
        self.assertEqual(drive.read_bytes(), (self.root / "a.mcap").read_bytes())

    def test_the_topic_is_asked_for(self):
        output = self.root / "not made"
        finished = run(self.root / "a.mcap", "--output", output)
        self.assertEqual(finished.returncode, 3)
        self.assertIn("which topic? It has /others (1), /points (5)", finished.stderr)
        self.assertFalse(output.exists())
        self.assertIn("none", run(self.root / "scans", "--topic", "/points").stderr)

    def test_damage_is_said(self):
        (self.root / "cut.mcap").write_bytes((self.root / "a.mcap").read_bytes()[:-100000])
        finished, output = self.track("cut.mcap", "--topic", "/points")
        self.assertEqual(finished.returncode, 3)
        self.assertIn("cut.mcap", finished.stderr)
        self.assertFalse(output.exists())


    def test_no_message_of_a_database_is_left_out(self):
        damage = {"of no topic": ("UPDATE messages SET topic_id = 2 WHERE id = 3", "'name'"),
                  "no stamp": ("UPDATE messages SET timestamp = 'now' WHERE id = 3", "'timestamp'"),
                  "no bytes": ("UPDATE messages SET data = NULL WHERE id = 3", "'data'"),
                  "endless": ("DROP TABLE messages; CREATE VIEW messages AS WITH RECURSIVE n(id) AS (SELECT 1 UNION ALL SELECT id + 1 FROM n) "
                              "SELECT id, 1 AS topic_id, id AS timestamp, x'00' AS data FROM n", "interrupted")}
        for what, (statements, words) in damage.items():
            path = self.root / f"{what}.db3"
            path.write_bytes((self.root / "a.db3").read_bytes())
            with contextlib.closing(sqlite3.connect(path)) as database:
                database.executescript(statements)
                database.commit()
            finished = subprocess.run([sys.argv[1], "info", path], capture_output=True, text=True)
            if "built without" in finished.stderr:
                self.skipTest(finished.stderr)
            self.assertEqual(finished.returncode, 3, what)
            self.assertIn(words, finished.stderr, what)


    def test_a_database_is_read_without_a_trace(self):
        """No file appears beside one, of which SQLite makes two in the mode WAL; names that mean something in URIs are none."""
        folder = self.root / "100%25 #1?"
        folder.mkdir()
        path = folder / "a.db3"
        path.write_bytes((self.root / "a.db3").read_bytes())
        with contextlib.closing(sqlite3.connect(path)) as database:
            database.execute("PRAGMA journal_mode = WAL")
        self.assertEqual(counts_of(path), {"/points": NUM_SCANS})
        self.assertEqual([entry.name for entry in folder.iterdir()], ["a.db3"])
        # What is in the log of changes alone, after a recording that did not end, is read too.
        database = sqlite3.connect(path)
        database.execute("INSERT INTO messages(topic_id, timestamp, data) SELECT topic_id, timestamp + 1, data FROM messages")
        database.commit()
        try:
            self.assertEqual(counts_of(path), {"/points": 2 * NUM_SCANS})
        finally:
            database.close()


class DepthBags(unittest.TestCase):
    """Images of data/ in a recording and in a folder."""

    def test_a_recording_gives_the_trajectory_of_its_images(self):
        images = sorted((Path(sys.argv[2]) / "data/tum_fr1_desk_30/depth").glob("*.png"))[:4]
        with tempfile.TemporaryDirectory() as scratch:
            root = Path(scratch)
            (root / "folder").mkdir()
            depth, infos, colours = [], [], []
            for path in images:
                (root / "folder" / path.name).write_bytes(path.read_bytes())
                stamp = int(path.stem.replace(".", "")) * 1000
                for messages, fill in ((depth, self.depth), (infos, self.camera_info), (colours, self.colour)):
                    message = Message(True)
                    message.header(stamp, "camera")
                    fill(message, path)
                    messages.append((stamp, bytes(message.data)))
            (root / "a.mcap").write_bytes(mcap([
                (b"/camera/depth/image_raw/compressedDepth", b"sensor_msgs/msg/CompressedImage", depth),
                (b"/camera/depth/camera_info", b"sensor_msgs/msg/CameraInfo", infos),
                (b"/camera/rgb/image_raw", b"sensor_msgs/msg/Image", colours)]))
            options = ("--depth-scale", 5000, "--quiet")
            plain = run(root / "folder", "--camera", "517 516 318 255 0.26 -0.95 0 0 1.16", "--output", root / "plain", *options)
            self.assertEqual((plain.returncode, plain.stderr), (0, ""))
            of_bag = run(root / "a.mcap", "--output", root / "bag", "--mcap", root / "out.mcap", "--report", root / "report.html", *options)
            self.assertEqual((of_bag.returncode, of_bag.stderr), (0, ""))
            self.assertEqual((root / "bag/trajectory.txt").read_text(), (root / "plain/trajectory.txt").read_text())
            self.assertEqual(counts_of(root / "out.mcap"), {"/odometry": 4, "/points": 4, "/tf": 4})
            self.assertIn("has no topic of sensor_msgs/PointCloud2", run(root / "a.mcap", "--sensor", "lidar").stderr)
            # An image of it, with the recording's camera, is the image of the folder with that camera.
            camera = ("--camera", "517 516 318 255 0.26 -0.95 0 0 1.16", "--depth-scale", 5000)
            poses = [json.loads(subprocess.run([sys.argv[1], "align", *map(str, arguments), "--json", "-"], capture_output=True,
                                               text=True, check=True).stdout)["T_target_source"]
                     for arguments in ((f"{root / 'a.mcap'}#2", f"{root / 'a.mcap'}#0", *camera[2:]),
                                       (root / "folder" / images[2].name, root / "folder" / images[0].name, *camera))]
            self.assertEqual(*poses)

    @staticmethod
    def depth(message, path):
        message.text("16UC1; compressedDepth png")
        data = bytes(12) + path.read_bytes()
        message.numbers(len(data))
        message.data.extend(data)

    @staticmethod
    def camera_info(message, _):
        message.numbers(480, 640)
        message.text("plumb_bob")
        message.numbers(5)
        message.data.extend(bytes(-(len(message.data) - 4) % 8))
        k = [517, 0, 318, 0, 516, 255, 0, 0, 1]
        message.data.extend(np.array([0.26, -0.95, 0, 0, 1.16] + k + [0] * 9 + [0] * 12, "<f8").tobytes())

    @staticmethod
    def colour(message, _):
        message.numbers(1, 1)
        message.text("rgb8")
        message.data.append(0)
        message.numbers(3, 3)
        message.data.extend(b"abc")


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
