#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Raw points to pose: augicp by default, augicp without its search, and small_gicp with its defaults, in turn in one process.

usage: raw_to_pose.py SOURCE TARGET VOXEL_SIZE [--runs 15] [--threads 1 2] [--clock wall|processor]
       needs the module augicp and the package small_gicp (PyPI) on PYTHONPATH; files: .ply of points, or KITTI's .bin
Reading is not timed. Prints the median and the least time of each in milliseconds, and the medians beside small_gicp's.
"""
import argparse
import statistics
import time

import augicp
import numpy as np
import small_gicp

CLOCKS = {"wall": time.perf_counter, "processor": time.process_time}


def points_of(path):
    if path.endswith(".bin"):
        return np.fromfile(path, np.float32).reshape(-1, 4)[:, :3].astype(np.float64)
    return augicp.read(path).points.astype(np.float64)


def jobs_for(source, target, voxel_size, threads):
    return {
        "augicp": lambda: augicp.align(source, target, voxel_size=voxel_size, threads=threads),
        "augicp, search=False": lambda: augicp.align(source, target, voxel_size=voxel_size, threads=threads, search=False),
        "small_gicp": lambda: small_gicp.align(target, source, downsampling_resolution=voxel_size, num_threads=threads),
    }


def times_in_turn(jobs, num_runs, clock):
    for job in jobs.values():  # memory and threads are there afterwards
        job()
    times_ms = {name: [] for name in jobs}
    for _ in range(num_runs):
        for name, job in jobs.items():
            begin = clock()
            job()
            times_ms[name].append(1e3 * (clock() - begin))
    return times_ms


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("source")
    parser.add_argument("target")
    parser.add_argument("voxel_size", type=float)
    parser.add_argument("--runs", type=int, default=15)
    parser.add_argument("--threads", type=int, nargs="+", default=[1, 2])
    parser.add_argument("--clock", choices=CLOCKS, default="wall")
    arguments = parser.parse_args()
    source, target = points_of(arguments.source), points_of(arguments.target)
    for threads in arguments.threads:
        times_ms = times_in_turn(jobs_for(source, target, arguments.voxel_size, threads), arguments.runs,
                                 CLOCKS[arguments.clock])
        of_peer = statistics.median(times_ms["small_gicp"])
        for name, times in times_ms.items():
            median = statistics.median(times)
            print(f"{threads} threads  {name:22} {median:6.1f} ms  (least {min(times):6.1f})  {median / of_peer:5.2f}")


if __name__ == "__main__":
    main()
