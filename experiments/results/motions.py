# SPDX-License-Identifier: MIT
"""Rigid motions as 4x4 arrays, and trajectories in TUM format."""
import numpy as np


def from_quaternion(translation, xyzw):
    x, y, z, w = np.asarray(xyzw, float) / np.linalg.norm(xyzw)
    motion = np.eye(4)
    motion[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    motion[:3, 3] = translation
    return motion


def from_axis_angle(axis, angle_rad):
    axis = np.asarray(axis, float) / np.linalg.norm(axis)
    return from_quaternion(np.zeros(3), np.append(np.sin(angle_rad / 2) * axis, np.cos(angle_rad / 2)))


def quaternion(motion):
    """x y z w of the rotation: the eigenvector that any rotation matrix gives without cases (Bar-Itzhack)."""
    (a, b, c), (d, e, f), (g, h, i) = motion[:3, :3]
    k = np.array([[a - e - i, b + d, c + g, h - f],
                  [b + d, e - a - i, f + h, c - g],
                  [c + g, f + h, i - a - e, d - b],
                  [h - f, c - g, d - b, a + e + i]])
    xyzw = np.linalg.eigh(k)[1][:, -1]
    return xyzw if xyzw[3] >= 0 else -xyzw


def angle_deg(motion):
    r = motion[:3, :3]
    sine = np.linalg.norm([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
    return float(np.degrees(np.arctan2(sine, np.trace(r) - 1)))


def error(found, truth):
    """Metres and degrees between two motions."""
    difference = np.linalg.inv(truth) @ found
    return float(np.linalg.norm(difference[:3, 3])), angle_deg(difference)


def read_rows(path):
    return [line.split() for line in path.read_text().splitlines() if line.strip() and not line.startswith("#")]


class Trajectory:
    """World from camera over time, straight between neighbouring poses."""

    def __init__(self, path):
        rows = np.array([[float(value) for value in row] for row in read_rows(path)])
        self.stamps, self.positions, self.quaternions = rows[:, 0], rows[:, 1:4], rows[:, 4:8]

    def at(self, stamp):
        i = int(np.clip(np.searchsorted(self.stamps, stamp), 1, len(self.stamps) - 1))
        share = (stamp - self.stamps[i - 1]) / (self.stamps[i] - self.stamps[i - 1])
        before, after = self.quaternions[i - 1], self.quaternions[i]
        if before @ after < 0:
            after = -after
        return from_quaternion((1 - share) * self.positions[i - 1] + share * self.positions[i],
                               (1 - share) * before + share * after)
