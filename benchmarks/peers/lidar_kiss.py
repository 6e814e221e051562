#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""KISS-ICP on a folder of KITTI .bin scans, with its defaults: poses in TUM format, and its processor time a scan.

usage: lidar_kiss.py FOLDER TRAJECTORY [--deskew kitti|counterclockwise] [--times FILE]      needs the package kiss-icp (PyPI)
One thread. The time is that of register_frame(), reading apart; the median over the scans is printed in milliseconds.
"""
import argparse
import pathlib
import statistics
import time

import numpy as np
from kiss_icp.config import KISSConfig
from kiss_icp.kiss_icp import KissICP

# By the azimuths of points, radians: the share of the sweep after which each was measured.
SHARES = {"kitti": lambda azimuths: 0.5 * (1.0 - azimuths / np.pi),
          "counterclockwise": lambda azimuths: np.mod(0.5 * azimuths / np.pi, 1.0)}


def kiss_with_defaults(deskew):
    config = KISSConfig()
    config.data.deskew = deskew
    config.registration.max_num_threads = 1
    config.mapping.voxel_size = config.data.max_range / 100.0  # what its own loader sets
    return KissICP(config=config)


def quaternion(rotation):
    """x y z w of a rotation matrix, by the largest of the four."""
    trace = np.array([rotation[0, 0] - rotation[1, 1] - rotation[2, 2], rotation[1, 1] - rotation[0, 0] - rotation[2, 2],
                      rotation[2, 2] - rotation[0, 0] - rotation[1, 1], np.trace(rotation)])
    m = rotation
    k = int(np.argmax(trace))
    if k == 3:
        q = np.array([m[2, 1] - m[1, 2], m[0, 2] - m[2, 0], m[1, 0] - m[0, 1], 1.0 + trace[3]])
    else:
        i, j, l = k, (k + 1) % 3, (k + 2) % 3
        q = np.empty(4)
        q[i], q[j], q[l], q[3] = 1.0 + trace[k], m[j, i] + m[i, j], m[l, i] + m[i, l], m[l, j] - m[j, l]
    return q / np.linalg.norm(q)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("trajectory", type=pathlib.Path)
    parser.add_argument("--deskew", choices=SHARES, help="when the points were measured: by azimuth, clockwise from behind the "
                        "sensor (KITTI), or counterclockwise from the x axis (augicp experiment town)")
    parser.add_argument("--times", type=pathlib.Path, help="the stamps of the trajectory, one a line (default: 0, 1, 2...)")
    arguments = parser.parse_args()
    odometry = kiss_with_defaults(arguments.deskew is not None)
    stamps = arguments.times.read_text().split() if arguments.times else None
    times_ms, lines = [], []
    for place, path in enumerate(sorted(arguments.folder.glob("*.bin"))):
        points = np.fromfile(path, np.float32).reshape(-1, 4)[:, :3].astype(np.float64)
        shares = SHARES[arguments.deskew](np.arctan2(points[:, 1], points[:, 0])) if arguments.deskew else np.empty(0)
        begin = time.process_time()
        odometry.register_frame(points, shares)
        times_ms.append(1e3 * (time.process_time() - begin))
        pose = odometry.last_pose
        stamp = float(stamps[place]) if stamps else place
        lines.append(" ".join(f"{x:.9g}" for x in (stamp, *pose[:3, 3], *quaternion(pose[:3, :3]))))
    arguments.trajectory.write_text("\n".join(lines) + "\n")
    print(f"{statistics.median(times_ms):.1f} ms a scan (processor time, median of {len(times_ms)})")


if __name__ == "__main__":
    main()
