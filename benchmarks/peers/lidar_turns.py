#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""augicp and KISS-ICP in turn on the same scans: processor time a scan, medians, and their ratio.

usage: PYTHONPATH=build/release/python lidar_turns.py FOLDER [--deskew kitti] [--rounds 3]      needs the package kiss-icp (PyPI)
FOLDER holds KITTI .bin scans. Both have their defaults and one thread, and take each scan one after the other, so that a busy
machine slows both alike. augicp also finds the covariance of each pose and checks itself, as the command does. Reading apart.
"""
import argparse
import pathlib
import statistics
import time

import augicp
import numpy as np
from lidar_kiss import SHARES, kiss_with_defaults


def processor_ms(work):
    begin = time.process_time()
    work()
    return 1e3 * (time.process_time() - begin)


def times_of(paths, deskew):
    """[(augicp, KISS-ICP)]: milliseconds of each scan."""
    kiss = kiss_with_defaults(deskew is not None)
    odometry = augicp.LidarOdometry(covariance=True, threads=1)
    times_ms = []
    for path in paths:
        points = np.fromfile(path, np.float32).reshape(-1, 4)[:, :3]
        doubles = points.astype(np.float64)
        shares = SHARES[deskew](np.arctan2(doubles[:, 1], doubles[:, 0])) if deskew else np.empty(0)
        times_ms.append((processor_ms(lambda: odometry.add(points, times=shares if deskew else "none")),
                         processor_ms(lambda: kiss.register_frame(doubles, shares))))
    return times_ms


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--deskew", choices=SHARES, help="see lidar_kiss.py; not given: the times are unknown to both")
    parser.add_argument("--rounds", type=int, default=3, help="the whole sequence this often")
    arguments = parser.parse_args()
    paths = sorted(arguments.folder.glob("*.bin"))
    for _ in range(arguments.rounds):
        times_ms = times_of(paths, arguments.deskew)
        ours, theirs = (statistics.median(column) for column in zip(*times_ms))
        all_ours, all_theirs = (sum(column) for column in zip(*times_ms))
        print(f"augicp {ours:.1f} ms, KISS-ICP {theirs:.1f} ms, ratio {ours / theirs:.2f} (medians of {len(times_ms)} scans); "
              f"of the sums {all_ours / all_theirs:.2f}", flush=True)


if __name__ == "__main__":
    main()
