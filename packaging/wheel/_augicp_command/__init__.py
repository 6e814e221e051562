# SPDX-License-Identifier: MIT
"""Starts the command that a wheel of augicp brings.

Beside the package augicp and not in it: the command needs no NumPy, and importing NumPy takes longer than a small alignment.
"""
import os
import sys
from pathlib import Path

COMMAND = Path(__file__).resolve().parent.parent / "augicp/bin/augicp"


def main():
    """Becomes the command: same process, so that signals and exit codes are the command's own."""
    os.execv(COMMAND, [sys.argv[0], *sys.argv[1:]])
