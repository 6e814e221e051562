#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Whether a trajectory or its reference errs: pairs of its scans are registered directly, by augicp and by small_gicp.

usage: PYTHONPATH=build/release/python lidar_reference.py FOLDER TRAJECTORY --pairs 0-20 0-44
needs the package small-gicp (PyPI)

FOLDER holds KITTI .bin scans and reference_tum.txt; TRAJECTORY is of all of them, as augicp odometry writes it. Both programs
start from the reference, augicp with its defaults, small_gicp with voxels of 0.25 m. Prints Markdown: by how much the motion of
each pair differs between the reference, the trajectory and the two direct registrations, mm and degrees.
"""
import argparse
import pathlib

import augicp
import numpy as np
import small_gicp

VOXEL_M = 0.25
MAX_DISTANCE_M = 1.0


def pose_of(row):
    """T (4, 4) of a line of a TUM trajectory."""
    x, y, z, w = row[4:8] / np.linalg.norm(row[4:8])
    pose = np.eye(4)
    pose[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                    [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                    [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    pose[:3, 3] = row[1:4]
    return pose


def apart(a, b):
    off = np.linalg.inv(a) @ b
    angle = np.arccos(np.clip(0.5 * (np.trace(off[:3, :3]) - 1.0), -1.0, 1.0))
    return f"{1e3 * np.linalg.norm(off[:3, 3]):.0f}, {np.degrees(angle):.2f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("trajectory", type=pathlib.Path)
    parser.add_argument("--pairs", nargs="+", required=True)
    given = parser.parse_args()
    reference, found = ([pose_of(row) for row in np.loadtxt(path)]
                        for path in (given.folder / "reference_tum.txt", given.trajectory))
    paths = sorted(given.folder.rglob("*.bin"))
    print("| scans | length, m | trajectory to reference | trajectory to augicp align | reference to augicp align "
          "| small_gicp to augicp align |\n| --- | --- | --- | --- | --- | --- |")
    for pair in given.pairs:
        i, j = map(int, pair.split("-"))
        target, source = (np.fromfile(paths[k], np.float32).reshape(-1, 4)[:, :3].astype(np.float64) for k in (i, j))
        known, chain = (np.linalg.inv(poses[i]) @ poses[j] for poses in (reference, found))
        ours = augicp.align(source, target, initial=known).T_target_source
        other = small_gicp.align(target, source, known, downsampling_resolution=VOXEL_M,
                                 max_correspondence_distance=MAX_DISTANCE_M).T_target_source
        print(f"| {pair} | {np.linalg.norm(known[:3, 3]):.2f} | {apart(known, chain)} | {apart(ours, chain)} "
              f"| {apart(ours, known)} | {apart(ours, other)} |")


if __name__ == "__main__":
    main()
