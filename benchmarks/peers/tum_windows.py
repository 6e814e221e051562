# SPDX-License-Identifier: MIT
"""Pairs of depth images of TUM RGB-D with the motion-capture truth between them."""
import numpy as np

from jobs import Job
from motions import Trajectory, read_rows

WINDOWS = ("fr1_desk_a", "fr1_xyz_a", "fr1_rpy_a")
CAMERA, DEPTH_SCALE = "tum-fr1", 5000

# The depth images of TUM fr1 lag the motion-capture clock (docs/lab/results.md): this is when the truth is read.
LAG_S = -0.022


class Window:
    """A stretch of a sequence: image k is frames[k], (stamp in seconds, path)."""

    def __init__(self, folder):
        self.name = folder.name
        self.frames = [(float(stamp), folder / path) for stamp, path in read_rows(folder / "depth.txt")]
        self.trajectory = Trajectory(folder / "groundtruth.txt")

    def world_from_camera(self, k, offset_s):
        return self.trajectory.at(self.frames[k][0] + offset_s)

    def truth(self, target, source, offset_s):
        return np.linalg.inv(self.world_from_camera(target, offset_s)) @ self.world_from_camera(source, offset_s)

    def job(self, target, source, guess):
        return Job(f"{target}-{source}", self.frames[source][1], self.frames[target][1],
                   self.truth(target, source, LAG_S), guess, "depth", CAMERA, DEPTH_SCALE)
