#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Completion of the command in bash, zsh and fish offers what the help texts have. Shells that are not installed are skipped.

    completion_test.py AUGICP PROJECT
"""
import os
import re
import shlex
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

AUGICP, PROJECT = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
FOLDER = PROJECT / "packaging/completion"
ENVIRONMENT = os.environ | {"PATH": f"{AUGICP.parent}:{os.environ['PATH']}"}
CASES = [[], ["align"], ["experiment"], ["experiment", "basin"]]


def run(*words):
    finished = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=True, env=ENVIRONMENT)
    return finished.stdout.splitlines()


def words_of_help(words, mark):
    """The options of a help text, or its subcommands."""
    text = "\n".join(run(AUGICP, *words, "--help"))
    if mark == "-":
        return set(re.findall(r"^  (?:-\w,)?(--[a-z][-a-z]*)", text, re.MULTILINE))
    return set(re.findall(r"^  ([a-z]+)  ", (text + "\n").partition("Subcommands:\n")[2].partition("\n\n")[0], re.MULTILINE))


def bash(words, typed):
    line = ["augicp", *words, typed]
    script = f"source {FOLDER}/augicp.bash; COMP_WORDS=({shlex.join(line)}); COMP_CWORD={len(line) - 1}; _augicp augicp {shlex.quote(typed)}; " \
             'printf "%s\\n" "${COMPREPLY[@]}"'
    return set(run("bash", "-c", script))


def zsh(words, typed):
    """Without a terminal zsh completes nothing: the list from which it would choose."""
    script = f"source {FOLDER}/augicp.zsh; _augicp_help_words {shlex.join(words)}"
    return {line.partition(":")[0] for line in run("zsh", "-f", "-c", script) if line.startswith(typed)}


def fish(words, typed):
    script = f"source {FOLDER}/augicp.fish; complete -C {shlex.quote(shlex.join(['augicp', *words, '']) if not typed else shlex.join(['augicp', *words, typed]))}"
    return {line.partition("\t")[0] for line in run("fish", "--no-config", "-c", script)}


class CompletionTest(unittest.TestCase):
    def check(self, shell):
        if not shutil.which(shell.__name__):
            self.skipTest(f"{shell.__name__} is not installed")
        for words in CASES:
            expected = words_of_help(words, "-")
            self.assertTrue(expected)
            self.assertEqual({word for word in shell(words, "--")} - {""}, expected, words)
        for words in ([], ["experiment"]):
            expected = words_of_help(words, "")
            self.assertGreater(len(expected), 5)
            self.assertLessEqual(expected, shell(words, ""), words)

    def test_bash(self):
        self.check(bash)

    def test_zsh(self):
        self.check(zsh)

    def test_fish(self):
        self.check(fish)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
