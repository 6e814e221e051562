#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The command as somebody meets it who does not know it yet: wrong words, no words, and what it says meanwhile.

    first_hour_test.py AUGICP PROJECT
"""
import random
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]), Path(sys.argv[2])
SUBCOMMANDS = ("align", "evaluate", "experiment", "info", "odometry", "surface", "unpack")


def run(*words, timeout=120):
    return subprocess.run([str(AUGICP), *map(str, words)], capture_output=True, text=True, timeout=timeout, check=False)


def options_of(*subcommand):
    """The long options in a subcommand's help, without the dashes."""
    heads = re.findall(r"^  (--?\S.*?)(?:  |$)", run(*subcommand, "--help").stdout, re.MULTILINE)
    return sorted({name for head in heads for name in re.findall(r"--([a-z][a-z-]+)", head)})


class WrongWordsTest(unittest.TestCase):
    def refused(self, *words):
        finished = run(*words)
        self.assertEqual((finished.returncode, finished.stdout), (2, ""), words)
        return finished.stderr

    def test_alone_it_shows_examples_that_its_own_help_confirms(self):
        finished = run()
        self.assertEqual(finished.returncode, 2)
        examples = [shlex.split(line) for line in finished.stdout.splitlines() if line.startswith("  augicp ")]
        self.assertEqual({words[1] for words in examples}, set(SUBCOMMANDS))
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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
