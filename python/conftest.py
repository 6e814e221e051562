# SPDX-License-Identifier: MIT
"""Shared by the tests. Run by ctest, with the module on PYTHONPATH and the command in AUGICP_COMMAND."""
import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

import augicp

PROJECT = Path(__file__).resolve().parents[1]
ROOM = PROJECT / "data/room_pair"
DESK = PROJECT / "data/tum_fr1_desk_30"
IMAGES = [DESK / "depth/1305031455.374120.png", DESK / "depth/1305031455.210307.png"]


def run_command(*words):
    """The finished command; skips the test where it was not built."""
    command = os.environ.get("AUGICP_COMMAND")
    if not command:
        pytest.skip("the command was not built (AUGICP_COMMAND is not set)")
    return subprocess.run([command, *map(str, words)], capture_output=True, text=True, check=False)


def command_json(*words):
    finished = run_command(*words)
    assert finished.stdout, finished.stderr
    return json.loads(finished.stdout)


@pytest.fixture(scope="session")
def room():
    """The sample's two clouds, source and target."""
    return augicp.read(ROOM / "source.ply"), augicp.read(ROOM / "target.ply")


@pytest.fixture(scope="session")
def small():
    """Two small arrays that fit each other, and the motion between them: a box's corner seen twice."""
    random = np.random.default_rng(7)
    sides = [np.insert(random.random((400, 2)), axis, 0.0, axis=1) for axis in range(3)]
    target = np.concatenate(sides)
    motion = np.eye(4)
    motion[:3, 3] = 0.02, -0.01, 0.015
    return target - motion[:3, 3], target, motion
