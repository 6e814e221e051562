#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""robustness 18: Ctrl-C and kill during every subcommand. The command ends, says so by its exit code, and files are whole or
absent.

    interruption_test.py AUGICP PROJECT
"""
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
ROOM = (PROJECT / "data/room_pair/source.ply", PROJECT / "data/room_pair/target.ply")
DESK = (PROJECT / "data/tum_fr1_desk_30", "--camera", "tum-fr1")
INTERRUPTED, TERMINATED = 130, 143
ENDLESS = 10**9  # iterations, starts, points: more than any machine does while a test runs
TICKS_PER_S = os.sysconf("SC_CLK_TCK")


class Command:
    """A running command. Tests wait for its state; a limit only ends a test that hangs."""

    def __init__(self, *words, before=()):
        self.process = subprocess.Popen([*before, str(AUGICP), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def until(self, reached):
        while not reached():
            if self.process.poll() is not None:
                raise self.ended_early()

    def ended_early(self):
        return AssertionError(f"ended by itself, with {self.process.returncode}: {self.process.communicate()[1]}")

    def until_busy_for(self, seconds):
        """Processor time, independent of the load of the machine."""
        def reached():
            fields = Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
            return int(fields[11]) + int(fields[12]) >= seconds * TICKS_PER_S
        while not reached():
            try:
                self.process.wait(timeout=0.01)
            except subprocess.TimeoutExpired:
                continue
            raise self.ended_early()

    def ends_on(self, number):
        self.process.send_signal(number)
        try:
            self.process.communicate(timeout=60)
        except subprocess.TimeoutExpired:
            self.process.kill()  # it would work for ever
            raise
        return self.process.returncode


def partial_files(folder):
    return list(folder.glob("**/.augicp-*.partial"))


class InterruptionTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="augicp-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def long_cloud(self):
        """Text that takes seconds to read."""
        path = self.folder / "long.xyz"
        path.write_bytes(b"1.25 2.5 3.75\n" * 5_000_000)
        return path

    def check_each_signal(self, *words):
        for number, code in ((signal.SIGINT, INTERRUPTED), (signal.SIGTERM, TERMINATED)):
            command = Command(*words)
            command.until_busy_for(0.1)
            self.assertEqual(command.ends_on(number), code, words)
        self.assertEqual(partial_files(self.folder), [])

    def test_align(self):
        output = self.folder / "T.txt"
        output.write_text("of an earlier run")
        self.check_each_signal("align", *ROOM, "--max-iterations", ENDLESS, "--min-step", 0, "--transform", output)
        self.assertEqual(output.read_text(), "of an earlier run")

    def test_odometry(self):
        output = self.folder / "run"
        self.check_each_signal("odometry", *DESK, "--pixel-step", 1, "--output", output)
        self.assertEqual([path.name for path in output.iterdir()], ["config.toml"])
        again = subprocess.run([AUGICP, "--config", output / "config.toml", "odometry", "--last", "2", "--quiet"], timeout=120, check=False)
        self.assertEqual(again.returncode, 0, "what was written is whole")

    def test_lidar_odometry_keeps_what_was_done(self):
        """The scans repeat one another, so that there is always more to do."""
        scans, output = self.folder / "scans", self.folder / "run"
        scans.mkdir()
        shutil.copy(ROOM[0], scans / "000000.ply")
        for k in range(1, 3000):
            os.link(scans / "000000.ply", scans / f"{k:06}.ply")
        command = Command("odometry", scans, "--sensor", "lidar", "--output", output, "--map", self.folder / "map.ply",
                          "--mcap", self.folder / "run.mcap", "--report", self.folder / "run.html")
        command.until_busy_for(1.0)
        self.assertEqual(command.ends_on(signal.SIGINT), INTERRUPTED)
        num_scans = len((output / "frames.csv").read_text().splitlines()) - 1
        self.assertGreater(num_scans, 0)
        self.assertLess(num_scans, 3000)
        self.assertIn("interrupted before scan", json.loads((output / "metrics.json").read_text())["ended_early"])
        for path in ("map.ply", "run.mcap"):
            subprocess.run([AUGICP, "info", self.folder / path], check=True, timeout=120, stdout=subprocess.DEVNULL)
        self.assertTrue((self.folder / "run.html").exists())
        self.assertEqual(partial_files(self.folder), [])

    def test_surface(self):
        output = self.folder / "extended.ply"
        self.check_each_signal("surface", self.long_cloud(), "--output", output)
        self.assertFalse(output.exists())

    def test_info(self):
        self.check_each_signal("info", self.long_cloud())

    def test_evaluate(self):
        path = self.folder / "long.txt"
        path.write_text("".join(f"{i}.5 {i % 7} 0 0 0 0 0 1\n" for i in range(2_000_000)))
        self.check_each_signal("evaluate", path, path)

    def test_experiments(self):
        output = self.folder / "rows.csv"
        for words in (("synthetic", "--seeds", ENDLESS), ("sequence", *DESK, "--iterations", ENDLESS),
                      ("basin", *ROOM, "--starts", ENDLESS), ("verdict", *DESK, "--gaps", "1,2,3,4,5,6,7,8,9,10")):
            self.check_each_signal("experiment", *words, "--output", output)
            self.assertFalse(output.exists())

    def test_a_signal_that_the_parent_ignores_is_ignored(self):
        """As under nohup, and for what a shell script starts in the background."""
        words = ("experiment", "synthetic", "--seeds", ENDLESS)
        command = Command(*words, before=("sh", "-c", 'trap "" INT; exec "$@"', "sh"))
        command.until_busy_for(0.2)
        command.process.send_signal(signal.SIGINT)
        command.until_busy_for(0.6)
        self.assertEqual(command.ends_on(signal.SIGTERM), TERMINATED)


class WritingTest(unittest.TestCase):
    """A signal that comes while a file is written."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory(prefix="augicp-")
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.output = self.folder / "moved.ply"
        cloud = self.folder / "source.xyz"
        cloud.write_text("".join(f"{i % 100 * 0.01} {i // 100 % 100 * 0.02} {i // 10000 * 0.03}\n" for i in range(400_000)))
        self.words = ("align", cloud, cloud, "--no-search", "--initial", "0 0 0 0 0 0 1", "--output", self.output)

    def writing(self):
        """A command that is writing its output: it may be quicker than the look at the folder, and then another is started."""
        while True:
            command = Command(*self.words)
            try:
                command.until(lambda: partial_files(self.folder))
                return command
            except AssertionError:
                self.assertTrue(self.output.exists())

    def test_the_file_is_finished_first(self):
        whole = Command(*self.words)
        whole.process.communicate()
        expected = self.output.read_bytes()
        self.output.unlink()
        for number, code in ((signal.SIGINT, INTERRUPTED), (signal.SIGTERM, TERMINATED)):
            # The file may be there just before the signal is: then the command has nothing left to do.
            self.assertIn(self.writing().ends_on(number), (code, whole.process.returncode))
            self.assertEqual(self.output.read_bytes(), expected)
            self.assertEqual(partial_files(self.folder), [])
            self.output.unlink()

    def test_killed_while_writing_nothing_has_the_final_name(self):
        self.output.write_text("of an earlier run")
        self.assertEqual(self.writing().ends_on(signal.SIGKILL), -signal.SIGKILL)
        self.assertIn(self.output.stat().st_size, (len("of an earlier run"), self.whole_size()))

    def whole_size(self):
        Command(*self.words).process.communicate()
        return self.output.stat().st_size


if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell that starts this in the background leaves it ignored
    unittest.main(argv=sys.argv[:1])
