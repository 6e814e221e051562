#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Memory of LiDAR odometry over many scans: the figures "Memory" in docs/lab/lidar_odometry.md.

    PYTHONPATH=build/release/python experiments/odometry/lidar_memory.py FOLDER [--scans 10000] [--every 8]

Goes forwards and backwards over the KITTI .bin scans of a folder, with every N-th of their points. Prints, ten times, the number
of scans so far, how many of them were tracked, the points of the map, and the resident memory of the process in MB.
"""
import argparse
from pathlib import Path

import numpy as np

import augicp


def resident_mb():
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return pages * 4096 / 1e6


def forwards_and_backwards(count):
    while True:
        yield from range(count - 1)
        yield from range(count - 1, 0, -1)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--scans", type=int, default=10000)
    parser.add_argument("--every", type=int, default=8)
    arguments = parser.parse_args()
    scans = [np.fromfile(path, "<f4").reshape(-1, 4)[::arguments.every, :3].copy() for path in sorted(arguments.folder.glob("*.bin"))]
    odometry = augicp.LidarOdometry(threads=1)
    num_tracked = 0
    for number, place in zip(range(1, arguments.scans + 1), forwards_and_backwards(len(scans))):
        odometry.add(scans[place], 0.1 * number, "none")
        num_tracked += odometry.last_frame.status == "tracked"
        if number % max(1, arguments.scans // 10) == 0:
            print(f"{number} scans, {num_tracked} tracked, {len(odometry.map)} points in the map, {resident_mb():.1f} MB", flush=True)


if __name__ == "__main__":
    main()
