# SPDX-License-Identifier: MIT
"""The cells of the comparison: named lists of jobs that are alike."""
from dataclasses import dataclass

import numpy as np

from jobs import Job
from scans import disturbed, lidar

GAPS = (1, 10, 20)
ANGLES_DEG = (5, 10, 20, 30, 45, 60)
DISTANCES_M = (0.5, 2.0)
IMAGE_ANGLES_DEG = (5, 10, 20, 30, 45)
IMAGE_DISTANCES_M = (0.1, 0.5)


@dataclass
class Cell:
    name: str
    jobs: list


def tum_cells(windows, num_pairs):
    """Target k, source k + gap, identity guess, k spread evenly over the window."""
    cells = []
    for window in windows:
        for gap in GAPS:
            first = np.linspace(0, len(window.frames) - gap - 1, num_pairs).astype(int)
            cells.append(Cell(f"{window.name} gap {gap}", [window.job(k, k + gap, np.eye(4)) for k in first]))
    return cells


def lidar_job(scans, angle_deg, seed):
    """The truth disturbed about the sensor: an angle about a random axis, and a random distance in a random direction."""
    source, target, truth = scans
    distance_m = np.random.default_rng((seed, angle_deg)).uniform(*DISTANCES_M)
    return Job(str(seed), source, target, truth, disturbed(truth, np.zeros(3), angle_deg, distance_m, seed), "lidar")


def lidar_cells(data, num_starts):
    scans = lidar(data)
    return [Cell(f"lidar {angle_deg} deg", [lidar_job(scans, angle_deg, seed) for seed in range(num_starts)])
            for angle_deg in ANGLES_DEG]


def image_job(window, target, angle_deg, seed):
    """The truth between neighbouring images disturbed about the camera, in the same way."""
    distance_m = np.random.default_rng((seed, angle_deg)).uniform(*IMAGE_DISTANCES_M)
    job = window.job(target, target + 1, np.eye(4))
    job.guess = disturbed(job.truth, np.zeros(3), angle_deg, distance_m, seed)
    return job


def image_cells(windows, num_starts):
    """Targets spread evenly over the window, one a start."""
    cells = []
    for window in windows:
        targets = np.linspace(0, len(window.frames) - 2, num_starts).astype(int)
        cells += [Cell(f"{window.name} {angle_deg} deg",
                       [image_job(window, target, angle_deg, seed) for seed, target in enumerate(targets)])
                  for angle_deg in IMAGE_ANGLES_DEG]
    return cells
