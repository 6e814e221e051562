#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The command as somebody meets it who does not know it yet: wrong words, no words, and what it says meanwhile.

    first_hour_test.py AUGICP PROJECT
"""
import json
import random
import re
import shlex
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
ROOM, DESK = PROJECT / "data/room_pair", PROJECT / "data/tum_fr1_desk_30"


def run(*words, timeout=120):
    return subprocess.run([str(AUGICP), *map(str, words)], capture_output=True, text=True, timeout=timeout, check=False)


def options_of(*subcommand):
    """The long options in a subcommand's help, without the dashes."""
    heads = re.findall(r"^  (--?\S.*?)(?:  |$)", run(*subcommand, "--help").stdout, re.MULTILINE)
    return sorted({name for head in heads for name in re.findall(r"--([a-z][a-z-]+)", head)})


def numbers_of(*subcommand):
    """The options in a subcommand's help that take numbers, with their kind: UINT, INT or FLOAT."""
    return re.findall(r"^  (?:\S+,)?--([a-z][a-z-]+)(?:,\S+)? (UINT|INT|FLOAT)", run(*subcommand, "--help").stdout, re.MULTILINE)


EXPERIMENTS = ("synthetic", "sequence", "basin", "global", "verdict", "trust", "town")
SUBCOMMANDS = [("align", "missing.ply", "missing.ply"), ("evaluate", "missing.txt", "missing.txt"), ("info", "missing.ply"),
               ("odometry", "missing"), ("surface", "missing.ply", "--output", "missing/o.ply")]


class WrongWordsTest(unittest.TestCase):
    def refused(self, *words):
        finished = run(*words)
        self.assertEqual((finished.returncode, finished.stdout), (2, ""), words)
        return finished.stderr

    def test_alone_it_shows_examples_that_its_own_help_confirms(self):
        finished = run()
        self.assertEqual(finished.returncode, 2)
        examples = [shlex.split(line) for line in finished.stdout.splitlines() if line.startswith("  augicp ")]
        subcommands = re.findall(r"^  (\w+)  ", run("--help").stdout.split("Subcommands:")[1], re.MULTILINE)
        self.assertEqual({words[1] for words in examples}, set(subcommands))
        self.assertGreaterEqual(len(subcommands), 6)
        for words in examples:
            subcommand = words[1:3] if words[1] == "experiment" else words[1:2]
            known = options_of(*subcommand)
            for option in (word[2:] for word in words if word.startswith("--")):
                self.assertIn(option, known, words)

    def test_a_mistyped_subcommand_is_recognised(self):
        for wrong, right in (("algin", "align"), ("Align", "align"), ("odometri", "odometry"), ("eval", "evaluate"), ("surfaces", "surface")):
            self.assertIn(f"Did you mean {right}?", self.refused(wrong, "a.ply", "b.ply"))
        self.assertIn("augicp experiment has no subcommand basn. Did you mean basin?", self.refused("experiment", "basn"))
        self.assertNotIn("Did you mean", self.refused("zzzzzz"))

    def test_every_option_is_recognised_without_one_of_its_letters(self):
        draw = random.Random(28)
        for subcommand in ("align", "odometry", "evaluate"):
            known = options_of(subcommand)
            self.assertGreater(len(known), 5)
            for option in (option for option in known if len(option) > 6 and not option.startswith("no-")):
                at = draw.randrange(1, len(option) - 1)
                wrong = option[:at] + option[at + 1:]
                if wrong.replace("-", "") != option.replace("-", "") and wrong not in known:
                    self.assertIn(f"has no option --{wrong}. Did you mean --{option}?", self.refused(subcommand, "a", "b", "--" + wrong))

    def test_options_of_other_libraries_and_places_are_recognised(self):
        for words, part in ((("align", "a", "b", "--voxelsize", 1), "Did you mean --voxel-size?"),
                            (("align", "a", "--Voxel_Size=1"), "Did you mean --voxel-size?"),
                            (("align", "a", "b", "--max-correspondence-distance", 1), "Did you mean --max-distance?"),
                            (("align", "a", "b", "--map", "m.ply"), "augicp odometry has it"),
                            (("align", "a", "b", "--config", "c"), "before the subcommand"),
                            (("align", "a", "b", "--initial", "-1 0 0", "--frobnicate"), "no option --frobnicate."),
                            (("align", "a"), "augicp align scan_b.ply scan_a.ply")):
            self.assertIn(part, self.refused(*words))

    def test_words_of_other_programs_lead_to_ours(self):
        for words, part in ((("register", "a", "b"), "Did you mean align?"), (("icp", "a", "b"), "Did you mean align?"),
                            (("slam", "a"), "Did you mean odometry?"), (("help",), "Did you mean --help?"),
                            (("align", "a", "b", "--leaf-size", 1), "Did you mean --voxel-size?"),
                            (("align", "a", "b", "--downsample", 1), "Did you mean --voxel-size?"),
                            (("align", "a", "b", "--guess", "T"), "Did you mean --initial?"),
                            (("odometry", "a", "--deskew"), "Did you mean --point-times?"),
                            (("odometry", "a", "--voxel-size", 1), "Did you mean --map-voxel?"),
                            (("odometry", "a", "--sensor", "camera"), "Did you mean depth?"),
                            (("align", "a", "b", "--method", "point_to_plane"), "Did you mean plane?"),
                            (("align", "a", "b", "--method", "ICP"), "Did you mean point?"),
                            (("align", "a", "b", "-leaf", "0.01"), "Did you mean --voxel-size?"),
                            (("align", "a", "b", "-ITER", 9), "Did you mean --max-iterations?"),
                            (("align", "a", "b", "--max_correspondence_distance", 1), "Did you mean --max-distance?"),
                            (("evaluate", "a", "b", "--t_max_diff", 1), "Did you mean --max-difference?"),
                            (("evaluate", "a", "b", "--correct_scale"), "Did you mean --align?"),
                            (("odometry", "a", "--n-scans", 9), "Did you mean --last?"),
                            (("align", "a", "b", "-o", "c"), "no option -o. Options are written out: --output"),
                            (("align", "a", "b", "-v", 1), "--voxel-size, --verbose")):
            self.assertIn(part, self.refused(*words))

    def test_values_are_refused_with_their_option_and_a_remedy(self):
        rooms = (ROOM / "source.ply", ROOM / "target.ply")
        for words, part in ((("--voxel-size", "5cm"), "--voxel-size: expected a number, found '5cm'; units are not written"),
                            (("--voxel-size", "0,05"), "decimals follow a point"),
                            (("--max-iterations", 1.5), "--max-iterations: expected a whole number, found '1.5'"),
                            (("--voxel-size",), "--voxel-size: expected a value"),
                            (("--voxel-size", -1), "--voxel-size -1: must be finite and above 0"),
                            (("--threads", -1), "--threads -1: must be at least 0"),
                            (("--initial", 0, 0, 0, 0, 0, 0, 1), "go into quotes"),
                            (("out.ply",), "found out.ply as well. A file to write follows its option: --output FILE"),
                            (("--report", "out.pdf"), "give out.html"),
                            (("--output", "a.ply", "--transform", "./a.ply"), "two outputs would be written to it")):
            self.assertIn(part, self.refused("align", *rooms, *words))
        for words, missing in ((("align", rooms[0]), "target"), (("info",), "file"), (("unpack",), "bag"), (("odometry",), "sequence"),
                               (("surface", "--output", "o.ply"), "input"), (("evaluate",), "estimate")):
            self.assertTrue(self.refused(*words).startswith(f"augicp: {missing} is required"), words)

    def test_no_number_of_any_option_is_taken_for_another(self):
        """Inputs are missing, so that 2 is a refused number, and 3 one that was taken."""
        count = 0
        for words in SUBCOMMANDS:
            numbers = numbers_of(words[0])
            self.assertGreater(len(numbers), 1, words)
            for option, kind in numbers:
                count += 1
                for value in ("nan", "NaN", "1e9999", "1x", "", "0x10", "9" * 30 if kind != "FLOAT" else "-1e9999"):
                    self.assertIn("--" + option, self.refused(*words, f"--{option}", value), (words, option, value))
                finished = run(*words, f"--{option}=-1")
                self.assertIn(finished.returncode, (2, 3), (words, option))
                self.assertNotRegex(finished.stderr, r"\d{12}", (words, option))
                if finished.returncode == 2:
                    self.assertIn("--" + option, finished.stderr)
                if kind == "UINT":
                    self.assertIn(f"--{option}: must not be negative, found -1", finished.stderr)
        self.assertGreater(count, 40)

    def test_numbers_of_experiments_are_none_of_other_kinds(self):
        for name in EXPERIMENTS:
            for option, kind in numbers_of("experiment", name):
                finished = run("experiment", name, "missing", "missing", f"--{option}=" + ("-1" if kind == "UINT" else "nan"))
                self.assertEqual(finished.returncode, 2, (name, option))
                self.assertIn("--" + option, finished.stderr)

    def test_zeros_in_front_are_no_octal_number(self):
        with tempfile.TemporaryDirectory() as folder:
            run("odometry", DESK, "--camera", "tum-fr1", "--first", "0010", "--last", "000012", "--output", folder, "--quiet")
            frames = (Path(folder) / "frames.csv").read_text().splitlines()
        self.assertEqual([line.split(",")[0] for line in frames[1:]], ["10", "11"])

    def test_version_names_commit_and_instructions(self):
        text = run("--version").stdout
        self.assertEqual(text, run("-V").stdout)
        lines = dict(line.split(maxsplit=1) for line in text.splitlines())
        self.assertEqual(lines["augicp"], (PROJECT / "VERSION").read_text().strip())
        if (PROJECT / ".git").exists():
            commit = lines["commit"].removesuffix("-modified")
            self.assertEqual(subprocess.run(["git", "-C", PROJECT, "cat-file", "-e", commit], check=False).returncode, 0, text)
        flags = Path("/proc/cpuinfo").read_text().split()
        for instructions, flag in (("AVX-512", "avx512vl"), ("AVX2", "avx2")):
            if lines["instructions"] == instructions:
                self.assertIn(flag, flags)
        self.assertIn(lines["instructions"], ("AVX-512", "AVX2", "baseline"))
        self.assertIn("compiler", lines)
        self.assertIn("reports", lines)


class WorkTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="augicp first hour ")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def align(self, *words):
        finished = run("align", ROOM / "source.ply", ROOM / "target.ply", *words)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        return finished

    def test_progress_for_programs_names_each_step(self):
        finished = self.align("--progress", "json", "--json", "-")
        steps = [json.loads(line) for line in finished.stderr.splitlines()]
        names = [step["step"] for step in steps]
        self.assertEqual(names[:5], ["reading", "surfaces", "indexing", "aligning", "verdict"])
        self.assertIn("rivals", names)
        self.assertEqual(sorted(step["elapsed_s"] for step in steps), [step["elapsed_s"] for step in steps])
        self.assertEqual(self.align("--progress", "json", "--quiet").stderr, "")
        frames = run("odometry", DESK, "--camera", "tum-fr1", "--last", 3, "--output", self.folder / "o", "--progress", "json").stderr
        self.assertEqual([json.loads(line)["done"] for line in frames.splitlines()], [1, 2, 3])

    def test_progress_names_what_is_searched_and_written(self):
        points = random.Random(7)
        noise = self.folder / "noise.xyz"
        noise.write_text("".join(f"{points.random()} {points.random()} {points.random()}\n" for _ in range(3000)))
        output, page = self.folder / "o.ply", self.folder / "page.html"
        finished = run("align", noise, ROOM / "target.ply", "--progress", "json", "--output", output, "--report", page)
        steps = [json.loads(line) for line in finished.stderr.splitlines()]
        names = [step["step"] for step in steps]
        self.assertLess({"search", "descriptors", "aligning", "verdict", "output", "report"}, set(names))
        self.assertEqual(sorted(step["elapsed_s"] for step in steps), [step["elapsed_s"] for step in steps])
        several = [step for step in steps if "total" in step]
        self.assertTrue(several)
        self.assertTrue(all(step["done"] < step["total"] for step in several))

    def test_progress_of_the_other_commands(self):
        self.assertEqual([json.loads(line)["step"] for line in run("info", ROOM / "source.ply", "--progress", "json").stderr.splitlines()], ["reading"])
        page = self.folder / "page.html"
        finished = run("odometry", DESK, "--camera", "tum-fr1", "--last", 2, "--output", self.folder / "o", "--report", page, "--progress", "json")
        lines = [json.loads(line) for line in finished.stderr.splitlines()]
        self.assertEqual([line.get("step", line.get("done")) for line in lines], [1, 2, "report"])

    def test_too_much_memory_is_refused_before_the_work(self):
        """A small bound in the place of a large cloud. What the message advises then works, with each command."""
        for words in (("align", ROOM / "source.ply", ROOM / "target.ply"),
                      ("surface", ROOM / "source.ply", "--output", self.folder / "o.ply")):
            given = ("--voxel-size", 0.01, "--radius", 0.5)
            refused = run(*words, *given, "--max-memory", 0.03)
            self.assertEqual((refused.returncode, refused.stdout), (2, ""), refused.stderr)
            advice = re.search(r"use --voxel-size (\S+) or --radius (\S+), or a larger --max-memory", refused.stderr)
            self.assertIsNotNone(advice, refused.stderr)
            for voxel_size, radius in ((advice[1], 0.5), (0.01, advice[2])):
                finished = run(*words, "--voxel-size", voxel_size, "--radius", radius, "--max-memory", 0.03)
                self.assertNotEqual(finished.returncode, 2, finished.stderr)

    def test_what_was_written_is_named(self):
        files = [self.folder / name for name in ("T.txt", "o.ply", "page.html")]
        options = [word for pair in zip(("--transform", "--output", "--report"), files) for word in pair]
        last = self.align(*options).stdout.splitlines()[-1]
        self.assertTrue(last.startswith("written  "), last)
        for file in files:
            self.assertIn(str(file), last)
        self.assertNotIn("written", self.align().stdout)
        self.assertEqual(self.align(*options, "--quiet").stdout, "")
        page = self.folder / "frames.html"
        frames = run("odometry", DESK, "--camera", "tum-fr1", "--last", 3, "--output", self.folder / "o", "--report", page)
        self.assertIn(str(page), frames.stdout.splitlines()[-1])
        for printed, file in ((last, files[2]), (frames.stdout, page)):
            self.assertEqual("no 3D views" in printed, "<script" not in file.read_text())

    def test_verbose_explains_the_lengths_and_the_end(self):
        finished = self.align("--verbose", "--json", "-", "--max-distance", 1)
        options = json.loads(finished.stdout)["options"]
        self.assertRegex(finished.stderr, rf"radius +{options['radius']:.4g} m: 0.7 of what was derived from the extent")
        self.assertRegex(self.align("--verbose", "--no-final-pass").stderr, r"radius +\S+ m: derived from the extent")
        self.assertIn("max distance  1 m: given", finished.stderr)
        self.assertIn("25392 points read", finished.stderr)
        self.assertRegex(finished.stderr, r"last step +\S+ of the extent")

    def test_a_fine_voxel_alone_brings_its_radius(self):
        options = json.loads(self.align("--voxel-size", 0.005, "--json", "-").stdout)["options"]
        usual = json.loads(self.align("--json", "-", "--no-final-pass").stdout)["options"]
        self.assertGreater(options["radius"], 4 * 0.005)  # the points are sparser than that
        self.assertLess(options["radius"], usual["radius"])

    def test_a_wrong_depth_scale_is_suspected(self):
        image = sorted((DESK / "depth").glob("*.png"))[0]
        for scale, is_wrong in ((1000, True), (5000, False), (5000 * 1.035, False)):
            finished = run("info", image, "--camera", "tum-fr1", "--depth-scale", scale)
            self.assertEqual(finished.returncode, 0)
            self.assertEqual("unusual for a depth camera" in finished.stderr, is_wrong, finished.stderr)

    def test_folders_and_files_in_each_others_place_are_sent_on(self):
        finished = run("align", DESK, ROOM / "target.ply")
        self.assertEqual(finished.returncode, 3)
        self.assertIn(f"augicp odometry {DESK}", finished.stderr)
        finished = run("odometry", ROOM / "source.ply")
        self.assertEqual(finished.returncode, 3)
        self.assertIn("augicp align", finished.stderr)
        (self.folder / "scan.e57").write_bytes(b"ASTM-E57")
        self.assertIn("pdal translate", run("info", self.folder / "scan.e57").stderr)

    def test_the_advice_on_a_folder_works(self):
        for folder in (ROOM, DESK, PROJECT / "data"):  # of the folders below, the one with the most files
            finished = run("align", folder, ROOM / "target.ply")
            self.assertEqual(finished.returncode, 3)
            advice = shlex.split(re.search(r": augicp (.*)", finished.stderr)[1])
            more = ["--camera", "tum-fr1", "--last", 2, "--output", self.folder / folder.name] if advice[0] == "odometry" else []
            self.assertEqual(run(*advice, *more).returncode, 0, advice)

    def test_what_cannot_be_written_is_said_before_the_work(self):
        for option in ("--output", "--transform", "--json", "--report", "--mcap"):
            path = self.folder / "missing" / ("o.mcap" if option == "--mcap" else "o.ply")
            finished = run("align", ROOM / "source.ply", ROOM / "target.ply", option, path)
            self.assertEqual((finished.returncode, finished.stdout), (3, ""), option)
            self.assertIn(f"there is no folder {path.parent}", finished.stderr)

    def test_a_guess_that_is_not_there_is_no_number(self):
        finished = run("align", ROOM / "source.ply", ROOM / "target.ply", "--initial", self.folder / "T.txt")
        self.assertEqual(finished.returncode, 3)
        self.assertIn("T.txt: no such file, and no pose", finished.stderr)

    def test_lengths_that_leave_nothing_are_named(self):
        for option in ("--voxel-size", "--radius"):
            finished = run("align", ROOM / "source.ply", ROOM / "target.ply", option, 1000)
            self.assertEqual((finished.returncode, finished.stderr), (4, ""))
            self.assertRegex(finished.stdout, rf"left of 25392 and \d+, one a voxel of \d+ m: use a smaller {option}")
        few = self.folder / "few.xyz"
        few.write_text("1 2 3\n2 3 5\n")
        self.assertIn("points   2 of the source", run("align", few, ROOM / "target.ply").stdout)
        finished = run("align", ROOM / "source.ply", ROOM / "target.ply", "--radius", 0.001, "--no-search")
        self.assertIn("hardly any point has a normal: balls of 0.001 m", finished.stderr)

    def test_folders_without_frames_name_those_that_have_them(self):
        inner = self.folder / "drive" / "scans"
        inner.mkdir(parents=True)
        for k in range(3):
            (inner / f"{k}.ply").write_bytes((ROOM / "source.ply").read_bytes())
        finished = run("odometry", inner.parent)
        self.assertEqual(finished.returncode, 3)
        self.assertIn(f"3 scans are tracked by: augicp odometry {inner}", finished.stderr)
        others = self.folder / "tiles"
        others.mkdir()
        for name in ("0.las", "1.las", "2.xyz"):
            (others / name).write_text("")
        self.assertIn("it has 2 .las, 1 .xyz, which no sequence is read from", run("odometry", others).stderr)
        self.assertIn("no such folder", run("odometry", self.folder / "missing").stderr)
        self.assertIn(f"its folder is tracked by: augicp odometry {DESK}", run("odometry", DESK / "depth.txt").stderr)
        self.assertIn("expected a trajectory", run("evaluate", ROOM / "source.ply", ROOM / "target.ply").stderr)

    def test_a_recording_that_is_not_there_is_none(self):
        for name in ("missing.mcap", "missing.bag", "missing.db3#3"):
            self.assertIn("No such file", run("align", self.folder / name, ROOM / "target.ply").stderr)

    def test_a_failed_run_leaves_no_folder(self):
        output = self.folder / "made"
        finished = run("odometry", DESK, "--camera", "500 500 9 9", "--depth-scale", 1, "--last", 2, "--output", output)
        self.assertEqual(finished.returncode, 3, finished.stderr)
        self.assertFalse(output.exists())
        output.mkdir()
        run("odometry", DESK, "--camera", "500 500 9 9", "--depth-scale", 1, "--last", 2, "--output", output)
        self.assertTrue(output.exists())

    def test_uncertainty_does_not_depend_on_the_zero(self):
        near = json.loads(self.align("--json", "-").stdout)
        paths = []
        for name in ("source", "target"):
            points = struct.iter_unpack("<fff", (ROOM / f"{name}.ply").read_bytes().split(b"end_header\n", 1)[1])
            paths.append(self.folder / f"{name}.xyz")
            paths[-1].write_text("".join(f"{x + 4e5!r} {y + 5e6!r} {z!r}\n" for x, y, z in points))
        far = json.loads(run("align", *paths, "--json", "-").stdout)
        for name in ("translation_m", "rotation_deg"):
            self.assertAlmostEqual(far["uncertainty"][name] / near["uncertainty"][name], 1.0, delta=0.2)
        self.assertLess(abs(far["reference_point"][0] - 4e5), 1e3)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
