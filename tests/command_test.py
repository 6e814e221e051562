#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The command as its users meet it: numbers in the files it writes, exit codes, flag over file over default.

    command_test.py AUGICP PROJECT
"""
import csv
import json
import math
import random
import sqlite3
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
ROOM = PROJECT / "data/room_pair"
DESK = PROJECT / "data/tum_fr1_desk_30/depth"
IMAGES = (DESK / "1305031455.374120.png", DESK / "1305031455.210307.png")


def run(*words, timeout=120):
    return subprocess.run([str(AUGICP), *map(str, words)], capture_output=True, text=True, timeout=timeout, check=False)


def write_grey_png(path, width, height, brightness):
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
    rows = b"".join(b"\0" + bytes(brightness(u, v) for u in range(width)) for v in range(height))
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))


def write_wall(path, shift):
    """A flat wall of 2 x 2 m with blots, seen by a sensor that stands `shift` metres further to the right and up."""
    draw = random.Random(path.name)
    lines = ["x,y,z,intensity"]
    for _ in range(20000):
        x, y = draw.uniform(-1, 1), draw.uniform(-1, 1)
        bright = 100 + 50 * math.sin(9 * x + 2 * y) + 50 * math.cos(11 * y - 4 * x) + draw.gauss(0, 2)
        lines.append(f"{x - shift:.5f},{y - shift:.5f},{2 + draw.gauss(0, 0.002):.5f},{bright:.2f}")
    path.write_text("\n".join(lines) + "\n")


def binary_points(path):
    """Of a PLY file with three floats a point, as data/room_pair has them."""
    return struct.iter_unpack("<fff", path.read_bytes().split(b"end_header\n", 1)[1])


def point_cloud2(stamp_s, points):
    """The message in CDR: points x y z ring."""
    message = bytearray(b"\0\1\0\0")

    def numbers(*values):
        message.extend(bytes(-len(message) % 4) + struct.pack(f"<{len(values)}I", *values))
    numbers(stamp_s, 500000000, 6)
    message.extend(b"lidar\0")
    numbers(1, len(points), 4)
    for i, name in enumerate((b"x\0", b"y\0", b"z\0", b"ring\0")):
        numbers(len(name))
        message.extend(name)
        numbers(4 * i)
        message.append(7 if i < 3 else 6)
        numbers(1)
    message.append(0)
    numbers(16, 16 * len(points), 16 * len(points))
    return bytes(message) + b"".join(struct.pack("<3fI", *point, i) for i, point in enumerate(points)) + b"\1"


def matrix(path):
    rows = [line.split() for line in Path(path).read_text().splitlines() if not line.startswith("#")]
    return [[float(value) for value in row] for row in rows]


def distance(a, b):
    return math.hypot(*(a[i][3] - b[i][3] for i in range(3)))


class CommandTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="augicp wörk ")  # a blank and an umlaut in every path
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def align(self, *words):
        finished = run("align", ROOM / "source.ply", ROOM / "target.ply", "--json", "-", *words)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        return json.loads(finished.stdout)

    def test_scans_are_registered(self):
        result = self.align("--transform", self.folder / "T.txt")
        truth = matrix(ROOM / "T_target_source.txt")
        self.assertEqual(result["status"], "converged")
        self.assertLess(distance(result["T_target_source"], truth), 0.004)
        first = self.align("--no-final-pass", "--output", self.folder / "moved.ply")
        self.assertGreater(distance(first["T_target_source"], truth), 0.004)
        self.assertEqual(matrix(self.folder / "T.txt"), result["T_target_source"])
        # The moved cloud lies where the target is: aligning it again moves it by next to nothing.
        again = run("align", self.folder / "moved.ply", ROOM / "target.ply", "--no-final-pass",
                    "--json", self.folder / "again.json")
        self.assertEqual(again.returncode, 0, again.stderr)
        identity = [[float(i == j) for j in range(4)] for i in range(4)]
        self.assertLess(distance(json.loads((self.folder / "again.json").read_text())["T_target_source"], identity), 0.005)

    def test_the_json_shows_what_was_done(self):
        steps = ("search", "final_pass", "coarse_to_fine", "rolling_shutter")
        for words, done in (((), (True, True)), (("--radius", 0.2), (True, False)), (("--no-search", "--no-final-pass"), (False, False)),
                            (("--preset", "paper"), (False, False))):
            finished = run("align", ROOM / "source.ply", ROOM / "target.ply", *words, "--json", "-")
            options = json.loads(finished.stdout)["options"]
            self.assertEqual((options["search"], options["final_pass"]), done, words)
        self.assertFalse(any(options[step] for step in steps))
        images = run("align", *IMAGES, "--camera", "tum-fr1", "--json", "-")
        self.assertFalse(json.loads(images.stdout)["options"]["final_pass"])

    def test_far_coordinates_keep_their_millimetres(self):  # robustness 15
        source, target = (list(binary_points(ROOM / name)) for name in ("source.ply", "target.ply"))
        truth = matrix(ROOM / "T_target_source.txt")
        for offset in (1e3, 1e6, 1e7):
            paths = self.folder / "far_source.xyz", self.folder / "far_target.xyz"
            for path, points in zip(paths, (source, target)):
                path.write_text("".join(f"{x + offset!r} {y - offset!r} {z!r}\n" for x, y, z in points))
            moved = self.folder / "moved.ply"
            finished = run("align", *paths, "--json", "-", "--output", moved)
            self.assertEqual(finished.returncode, 0, finished.stderr)
            pose = json.loads(finished.stdout)["T_target_source"]
            place = [sum(pose[i][k] * offset * (1, -1, 0)[k] for k in range(3)) + pose[i][3] for i in range(3)]
            expected = [truth[i][3] + offset * (1, -1, 0)[i] for i in range(3)]
            self.assertLess(math.dist(place, expected), 0.02)
            # The moved cloud is written where the target is, and is read again without loss.
            again = run("align", moved, paths[1], "--json", "-")
            self.assertEqual(again.returncode, 0, again.stderr)

    def test_swapping_gives_the_inverse(self):  # robustness 16
        truth = matrix(ROOM / "T_target_source.txt")
        turned = [[truth[j][i] for j in range(3)] for i in range(3)]
        inverse = [turned[i] + [-sum(turned[i][k] * truth[k][3] for k in range(3))] for i in range(3)] + [[0, 0, 0, 1]]
        guess = self.folder / "guess.txt"
        guess.write_text("\n".join(" ".join(map(str, row)) for row in inverse))
        there = self.align("--initial", ROOM / "T_target_source.txt")["T_target_source"]
        finished = run("align", ROOM / "target.ply", ROOM / "source.ply", "--json", "-", "--initial", guess)
        back = json.loads(finished.stdout)["T_target_source"]
        product = [[sum(there[i][k] * back[k][j] for k in range(4)) for j in range(4)] for i in range(4)]
        self.assertLess(math.hypot(*(product[i][3] for i in range(3))), 0.02)

    def test_depth_images_are_registered(self):
        finished = run("align", *IMAGES, "--camera", "tum-fr1", "--json", "-", "--trace")
        result = json.loads(finished.stdout)
        self.assertEqual((finished.returncode, result["status"]), (0, "converged"))
        self.assertEqual(len(result["history"]), result["iterations"])
        self.assertEqual(result["history"][-1]["T_target_source"], result["T_target_source"])

    def test_brightness_holds_a_flat_wall(self):
        source, target = self.folder / "source.csv", self.folder / "target.csv"
        write_wall(source, 0.03)
        write_wall(target, 0.0)
        finished = run("align", source, target, "--json", "-")
        result = json.loads(finished.stdout)
        self.assertEqual((finished.returncode, result["status"]), (5, "degenerate"))
        self.assertNotIn("intensity", result)
        finished = run("align", source, target, "--intensity", "--json", "-")
        result = json.loads(finished.stdout)
        self.assertEqual((finished.returncode, result["status"]), (0, "converged"))
        self.assertTrue(result["intensity"]["used"])
        self.assertGreater(result["intensity"]["num_pairs"], result["num_pairs"] / 10)
        self.assertLess(math.dist([row[3] for row in result["T_target_source"][:3]], (0.03, 0.03, 0.0)), 0.005)

    def test_images_beside_depth_images(self):
        colour, small = self.folder / "colour.png", self.folder / "small.png"
        write_grey_png(colour, 640, 480, lambda u, v: (u // 40 + v // 40) % 2 * 200 + u % 7)
        write_grey_png(small, 320, 240, lambda u, v: 0)
        words = ("align", IMAGES[0], IMAGES[0], "--camera", "tum-fr1", "--no-search", "--intensity")
        both = ("--source-image", colour, "--target-image", colour)
        result = json.loads(run(*words, *both, "--json", "-").stdout)
        self.assertEqual((result["status"], result["intensity"]["used"]), ("converged", True))
        result = json.loads(run(*words, "--source-image", colour, "--json", "-").stdout)
        self.assertEqual((result["status"], result["intensity"]["used"]), ("converged", False))
        for code, part, arguments in ((3, "expected 640 x 480 pixels", (*words, "--source-image", small)),
                                      (3, "8-bit grey", (*words, "--target-image", IMAGES[0])),
                                      (2, "not with a cloud", ("align", ROOM / "source.ply", IMAGES[0], "--source-image", colour))):
            finished = run(*arguments)
            self.assertEqual(finished.returncode, code, finished.stderr)
            self.assertIn(part, finished.stderr)

    def test_an_image_unlike_its_camera_is_named(self):
        camera = self.folder / "camera.json"
        camera.write_text('{"width": 320, "height": 240, "intrinsic_matrix": [260, 0, 0, 0, 260, 0, 160, 120, 1]}')
        finished = run("info", IMAGES[0], "--camera", camera)
        self.assertEqual(finished.returncode, 3)
        self.assertIn(f"{IMAGES[0]}: depth image is 640 x 480 pixels, the camera's are 320 x 240", finished.stderr)

    def test_same_bits_for_any_number_of_threads(self):
        for words in ((ROOM / "source.ply", ROOM / "target.ply"), (*IMAGES, "--camera", "tum-fr1")):
            outputs = set()
            for threads in (1, 2, 3, 8):
                json_path = self.folder / f"{threads}.json"
                finished = run("align", *words, "--threads", threads, "--trace", "--json", json_path)
                self.assertEqual(finished.returncode, 0, finished.stderr)
                result = json.loads(json_path.read_text())
                del result["timing_ms"], result["options"]
                outputs.add(json.dumps(result))
            self.assertEqual(len(outputs), 1)

    def test_reports_have_the_same_bytes_for_any_number_of_threads(self):
        desk = DESK.parent
        (self.folder / "few.xyz").write_text("1 2 3\nnan 1 1\n4 5 6\n")
        cases = (("align", *IMAGES, "--camera", "tum-fr1"), ("align", self.folder / "few.xyz", self.folder / "few.xyz"),
                 ("odometry", desk, "--camera", "tum-fr1", "--last", 4, "--output", self.folder / "odometry"),
                 ("experiment", "synthetic", "--points", 500, "--seeds", 1, "--iterations", 3, "--output", self.folder / "rows.csv"))
        for words in cases:
            pages = []
            for threads in (1, 2, 5):
                page = self.folder / "page.html"
                finished = run(*words, "--threads", threads, "--report", page)
                self.assertIn(finished.returncode, (0, 4, 5), finished.stderr)
                pages.append(page.read_bytes())
            self.assertEqual(len(set(pages)), 1, words)
            self.assertLess(len(pages[0]), 15e6)
            self.assertNotIn(b"http-equiv=\"refresh\"", pages[0])
            self.assertIn(b"default-src 'none'", pages[0])

    def test_reports_escape_names_and_fail_as_files_do(self):
        folder = self.folder / "<"
        folder.mkdir()
        hostile = folder / "script><!--\u2028&.ply"
        hostile.write_bytes((ROOM / "source.ply").read_bytes())
        page = self.folder / "page.html"
        self.assertEqual(run("align", hostile, ROOM / "target.ply", "--report", page).returncode, 0)
        text = page.read_text()
        self.assertIn("&lt;/script&gt;&lt;!--\u2028&amp;.ply", text)
        self.assertNotIn("</script><!--", text)
        self.assertEqual(run("align", ROOM / "source.ply", ROOM / "target.ply", "--report", "/dev/full").returncode, 3)

    def test_flag_wins_over_file_wins_over_default(self):
        config = self.folder / "augicp.toml"
        config.write_text("[align]\nmethod = \"gicp\"\nmax-iterations = 7\n")
        words = ("--config", config, "align", ROOM / "source.ply", ROOM / "target.ply", "--json", "-")
        from_file = json.loads(run(*words).stdout)["options"]
        self.assertEqual((from_file["method"], from_file["max_iterations"]), ("gicp", 7))
        from_flag = json.loads(run(*words, "--method", "plane").stdout)["options"]
        self.assertEqual((from_flag["method"], from_flag["max_iterations"]), ("plane", 7))
        config.write_text("[align]\nmehtod = \"gicp\"\n")
        self.assertEqual(run(*words).returncode, 2)

    def test_every_option_in_the_json_has_its_flag(self):
        text = run("align", "--help").stdout
        options = self.align("--max-angle-deg", 45)["options"]
        self.assertEqual(round(options["max_angle_deg"], 9), 45)
        for name in options:
            self.assertIn("--" + name.removesuffix("_chi2").removesuffix("_gb").replace("_", "-"), text)

    def test_initial_guess_is_taken(self):
        near = self.align("--no-search", "--initial", ROOM / "T_target_source.txt", "--max-iterations", 50)
        self.assertLess(near["iterations"], self.align("--no-search")["iterations"])

    def test_exit_codes(self):
        cloud = ROOM / "source.ply"
        (self.folder / "one.xyz").write_text("1 2 3\n")
        (self.folder / "same.xyz").write_text("1 2 3\n" * 5000)
        (self.folder / "short.ply").write_bytes(cloud.read_bytes()[:1000])
        (self.folder / "mirror.txt").write_text("-1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
        far = "0 0 1000 0 0 0 1"
        cases = (
            (0, ("--version",)), (0, ("align", "--help")), (2, ()), (2, ("align", cloud)), (2, ("align", cloud, cloud, "--radius", -1)),
            (2, ("align", cloud, cloud, "--method", "magic")), (2, ("align", cloud, cloud, "--initial", "1 2 3")),
            (2, ("align", *IMAGES)), (2, ("align", cloud, cloud, "--association", "projective")),
            (3, ("align", self.folder / "nothing.ply", cloud)), (3, ("align", self.folder / "short.ply", cloud)),
            (3, ("align", self.folder, cloud)), (3, ("align", cloud, cloud, "--initial", self.folder / "mirror.txt")),
            (3, ("align", cloud, cloud, "--transform", "/dev/full")), (3, ("align", *IMAGES, "--camera", "tum-fr9")),
            (3, ("align", *IMAGES, "--camera", "tum-fr1", "--depth-scale", 1)),
            (2, ("align", cloud, cloud, "--output", self.folder / "a.xyz")), (2, ("align", cloud, cloud, "--camera", "tum-fr1")),
            (2, ("info", cloud, "--camera", "tum-fr1")), (2, ("surface", cloud, "--camera", "tum-fr1", "--output", self.folder / "a.ply")),
            (2, ("surface", cloud, "--output", self.folder / "a.pcd")),
            (3, ("surface", self.folder / "same.xyz", "--output", self.folder / "a.ply")),
            (3, ("align", *IMAGES, "--camera", "525 525 1e300 2")),
            (3, ("align", *IMAGES, "--camera", "tum-fr1", "--depth-scale", 1e-300)),
            (4, ("align", self.folder / "one.xyz", cloud)), (4, ("align", cloud, self.folder / "same.xyz")),
            (4, ("align", self.folder / "same.xyz", self.folder / "same.xyz")),
            (4, ("align", cloud, cloud, "--initial", far, "--no-search")),
            (5, ("align", ROOM / "source.ply", ROOM / "target.ply", "--max-iterations", 2)),
        )
        for expected, words in cases:
            finished = run(*words)
            self.assertEqual(finished.returncode, expected, f"{words}: {finished.stdout}{finished.stderr}")
            if expected in (2, 3):
                self.assertNotEqual(finished.stderr, "", words)

    def test_a_cloud_against_itself_stays(self):  # robustness 10
        finished = run("align", ROOM / "source.ply", ROOM / "source.ply", "--json", "-")
        result = json.loads(finished.stdout)
        self.assertEqual((finished.returncode, result["status"]), (0, "converged"))
        self.assertLess(distance(result["T_target_source"], [[float(i == j) for j in range(4)] for i in range(4)]), 1e-9)

    def test_info_counts(self):
        info = json.loads(run("info", IMAGES[0], "--camera", "tum-fr1", "--json", "-").stdout)
        self.assertEqual(info["num_declared"], 640 * 480)
        self.assertEqual(info["num_points"] + info["num_invalid"], 640 * 480)
        (self.folder / "nan.xyz").write_text("0 0 0\nnan 1 1\n1 2 3\n")
        (self.folder / "columns.csv").write_text("x,y,z,r,g,b,time\n1,2,3,255,0,7,0.5\n")
        info = json.loads(run("info", self.folder / "columns.csv", "--json", "-").stdout)
        self.assertEqual([(column["name"], column["type"]) for column in info["columns"]],
                         [("red", "uint8"), ("green", "uint8"), ("blue", "uint8"), ("time", "float64")])
        self.assertIn("red uint8, green uint8", run("info", self.folder / "columns.csv").stdout)
        info = json.loads(run("info", self.folder / "nan.xyz", "--json", "-").stdout)
        self.assertEqual((info["num_points"], info["num_invalid"], info["max"]), (2, 1, [1.0, 2.0, 3.0]))

    def test_surface_writes_what_it_says(self):
        output = self.folder / "extended.ply"
        finished = run("surface", IMAGES[0], "--camera", "tum-fr1", "--output", output)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        points = int(finished.stdout.split("points")[1].split(",")[0])
        header = output.read_bytes()[:2000].decode("latin-1")
        for words in (f"element vertex {points}", "property float nx", "property uchar red", "property uchar structure"):
            self.assertIn(words, header)

    def test_columns_of_the_source_reach_the_output(self):
        """Colour, ring and stamp of each point, float positions, and a row a point in the order of the file."""
        points = list(binary_points(ROOM / "source.ply"))
        rows = b"".join(struct.pack("<fffBBBHd", *point, i % 256, i % 7, 3, i % 64, 0.1 * i) for i, point in enumerate(points))
        names = ("float x", "float y", "float z", "uchar red", "uchar green", "uchar blue", "ushort ring", "double stamp")
        head = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\n" + "".join(f"property {n}\n" for n in names)
        (self.folder / "s.ply").write_bytes(head.encode() + b"end_header\n" + rows)
        moved = self.folder / "moved.ply"
        finished = run("align", self.folder / "s.ply", ROOM / "target.ply", "--output", moved)
        self.assertEqual((finished.returncode, finished.stderr), (0, ""))
        written, body = moved.read_bytes().split(b"end_header\n", 1)
        self.assertEqual(written.decode() + "end_header\n", head + "end_header\n")
        given, found = struct.iter_unpack("<fffBBBHd", rows), struct.iter_unpack("<fffBBBHd", body)
        self.assertTrue(all(a[3:] == b[3:] for a, b in zip(given, found, strict=True)))
        finished = run("surface", self.folder / "s.ply", "--output", self.folder / "extended.ply")
        self.assertEqual((finished.returncode, finished.stderr), (0, ""))
        header = (self.folder / "extended.ply").read_bytes().split(b"end_header")[0].decode()
        for name in ("uchar red", "ushort ring", "double stamp", "float nx", "float tangent_x"):
            self.assertEqual(header.count(f"property {name}\n"), 1, name)

    def test_recordings_become_scans(self):
        bag = self.folder / "drive.db3"
        database = sqlite3.connect(bag)
        database.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, offered_qos_profiles TEXT)")
        database.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)")
        for i, name in ((1, "/points"), (2, "/more_points"), (3, "/words")):
            kind = "std_msgs/msg/String" if i == 3 else "sensor_msgs/msg/PointCloud2"
            database.execute("INSERT INTO topics VALUES(?, ?, ?, 'cdr', '')", (i, name, kind))
        clouds = [point_cloud2(second, [(second, 0, 1), (2, 3, 4)] if second != 11 else []) for second in (12, 10, 11)]
        for topic, stamp, data in ((1, 3, clouds[0]), (1, 1, clouds[1]), (1, 2, clouds[2]), (2, 4, clouds[0]), (3, 5, b"x")):
            database.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", (topic, stamp, data))
        database.commit()
        database.close()
        info = json.loads(run("info", bag, "--json", "-").stdout) if "built without" not in run("info", bag).stderr else self.skipTest("no SQLite")
        self.assertEqual([(topic["name"], topic["num_messages"]) for topic in info["topics"]], [("/more_points", 1), ("/points", 3), ("/words", 1)])
        self.assertIn("which topic? It has /more_points (1), /points (3)", run("unpack", bag).stderr)
        scans = self.folder / "scans"
        watched = run("unpack", bag, "--topic", "/points", "--output", scans.with_name("watched"), "--progress", "json")
        reports = [json.loads(line) for line in watched.stderr.splitlines() if line.startswith("{")]
        self.assertEqual([(report["done"], report["total"]) for report in reports], [(1, 3), (2, 3), (3, 3)])
        finished = run("unpack", bag, "--topic", "/points", "--output", scans)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertIn("#/points#1: holds no points", finished.stderr)
        self.assertEqual((scans / "times.txt").read_text().split(), ["10.500000000", "12.500000000"])
        self.assertEqual(sorted(path.name for path in scans.iterdir()), ["000000.pcd", "000001.pcd", "times.txt"])
        self.assertIn(b"FIELDS x y z ring\n", (scans / "000000.pcd").read_bytes())
        self.assertEqual(json.loads(run("info", scans / "000001.pcd", "--json", "-").stdout)["max"], [12.0, 3.0, 4.0])
        self.assertEqual(run("unpack", bag, "--topic", "/points", "--output", scans).returncode, 3, "the folder is not empty")
        bag.write_bytes(bag.read_bytes()[:5000])
        self.assertEqual(run("info", bag).returncode, 3)

    def test_units_that_differ_are_said(self):
        points = list(binary_points(ROOM / "source.ply"))[::20]
        for name, scale in (("m.xyz", 1), ("mm.xyz", 1000)):
            (self.folder / name).write_text("".join("%g %g %g\n" % tuple(scale * x for x in point) for point in points))
        for source, target, says in (("m", "mm", "the target is about 1000 times"), ("mm", "m", "the source is about 1000 times")):
            finished = run("align", self.folder / f"{source}.xyz", self.folder / f"{target}.xyz", "--quiet")
            self.assertIn(says, finished.stderr)
        self.assertEqual(run("align", self.folder / "mm.xyz", self.folder / "mm.xyz", "--quiet").stderr, "")

    def test_what_an_output_cannot_keep_is_said(self):
        grid = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 40\nHEIGHT 40\nDATA ascii\n"
        grid += "".join(f"{i % 40} {i // 40} {(i % 40) ** 2 / 80}\n" for i in range(1600))
        (self.folder / "grid.pcd").write_text(grid)
        cloud = self.folder / "grid.pcd"
        self.assertIn("not kept: the grid of 40 x 40", run("align", cloud, cloud, "--output", self.folder / "m.ply").stderr)
        self.assertEqual(run("align", cloud, cloud, "--output", self.folder / "m.pcd").stderr, "")
        self.assertIn(b"WIDTH 40\nHEIGHT 40\n", (self.folder / "m.pcd").read_bytes())

    def odometry(self, name, *words):
        """Runs odometry on the first images of the sample; gives the folder of its results."""
        output = self.folder / name
        finished = run("odometry", DESK.parent, "--camera", "tum-fr1", "--last", 12, "--output", output, *words)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual(finished.stderr, "", "no progress bar where stderr is no terminal")
        return output

    def test_odometry_tracks_the_sample(self):
        output = self.odometry("run")
        self.assertEqual({path.name for path in output.iterdir()},
                         {"trajectory.txt", "frames.csv", "metrics.json", "config.toml"})
        metrics = json.loads((output / "metrics.json").read_text())
        self.assertEqual((metrics["num_frames"], metrics["num_tracked"], metrics["num_started"]), (12, 11, 1))
        self.assertLess(metrics["evaluation"]["ate_aligned"]["translation"]["rmse"], 0.015)
        self.assertLess(metrics["evaluation"]["rpe"]["translation"]["rmse"], 0.008)
        with open(output / "frames.csv", newline="", encoding="utf-8") as rows:
            frames = list(csv.DictReader(rows))
        self.assertEqual([row["status"] for row in frames], ["started"] + 11 * ["tracked"])
        for row in frames[1:]:
            self.assertGreater(float(row["strain"]), 0.0)
            self.assertLess(float(row["strain"]), 1.0)
        # What the metrics say of the trajectory is what evaluate says of the file.
        finished = run("evaluate", output / "trajectory.txt", DESK.parent / "groundtruth.txt", "--json", "-")
        self.assertEqual(json.loads(finished.stdout)["ate_aligned"], metrics["evaluation"]["ate_aligned"])

    def test_odometry_gives_the_same_bits_on_any_number_of_threads_and_from_its_config(self):
        trajectories = set()
        for threads in (1, 2, 5):
            output = self.odometry(f"threads{threads}", "--threads", threads, "--quiet")
            trajectories.add((output / "trajectory.txt").read_bytes())
        (output / "trajectory.txt").unlink()
        finished = run("--config", output / "config.toml", "odometry", "--quiet")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        trajectories.add((output / "trajectory.txt").read_bytes())
        self.assertEqual(len(trajectories), 1)

    def test_odometry_goes_on_after_damaged_repeated_and_late_images(self):  # robustness 17
        sequence = self.folder / "sequence"
        sequence.mkdir()
        lines = [line.split() for line in (DESK.parent / "depth.txt").read_text().splitlines() if line[0] != "#"][:8]
        for _, image in lines:
            (sequence / image).parent.mkdir(exist_ok=True)
            (sequence / image).write_bytes((DESK.parent / image).read_bytes())
        damaged = sequence / lines[3][1]
        damaged.write_bytes(damaged.read_bytes()[:5000])
        listed = lines[:6] + [lines[5], lines[2]] + lines[6:]
        (sequence / "depth.txt").write_text("\n".join(" ".join(line) for line in listed))
        output = self.folder / "run"
        finished = run("odometry", sequence, "--camera", "tum-fr1", "--output", output)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        with open(output / "frames.csv", newline="", encoding="utf-8") as rows:
            frames = list(csv.DictReader(rows))
        expected = ["started"] + 2 * ["tracked"] + ["unreadable"] + 2 * ["tracked"] + 2 * ["out_of_order"] + 2 * ["tracked"]
        self.assertEqual([row["status"] for row in frames], expected)
        self.assertIn(damaged.name, frames[3]["problem"])
        poses = [line for line in (output / "trajectory.txt").read_text().splitlines() if line[0] != "#"]
        self.assertEqual(len(poses), 7)

    def test_odometry_says_what_it_lacks(self):
        for words, code, part in ((("odometry", DESK.parent), 2, "which camera"),
                                  (("odometry", self.folder), 3, "found no image"),
                                  (("odometry", DESK.parent, "--camera", "tum-fr1", "--first", 99), 2, "--first 99: no frame"),
                                  (("odometry", DESK.parent, "--camera", "500 500 9 9", "--depth-scale", 1), 3, "depth scale"),
                                  (("odometry", DESK.parent, "--camera", "tum-fr1", "--output", "/dev/null/x"), 3, "/dev/null/x")):
            output = () if "--output" in words else ("--output", self.folder / "none")
            finished = run(*words, "--last", 3, *output) if part == "depth scale" else run(*words, *output)
            self.assertEqual(finished.returncode, code, finished.stderr)
            self.assertIn(part, finished.stderr)

    def test_full_standard_output_is_an_error(self):
        with open("/dev/full", "w", encoding="ascii") as full:
            cloud = str(ROOM / "source.ply")
            for words in (("info", cloud), ("align", cloud, cloud, "--trace", "--json", "-")):  # little and much
                finished = subprocess.run([str(AUGICP), *words], stdout=full, stderr=subprocess.PIPE, timeout=60, check=False)
                self.assertEqual(finished.returncode, 3, finished.stderr)
                self.assertIn(b"standard output cannot be written", finished.stderr)

    def test_failed_writing_leaves_nothing(self):
        target = self.folder / "sub" / "T.txt"
        self.assertEqual(run("align", ROOM / "source.ply", ROOM / "target.ply", "--transform", target).returncode, 3)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
