#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the programs people register point clouds with today on the same inputs, and prints what they reach as Markdown.

    benchmarks/peers/run.py odometry tum images lidar scans --data FOLDER --output FOLDER [--peers augicp opencv] [--starts 50]

README.md says what the data folder holds and with which settings each peer runs.
"""
import argparse
import sys
from pathlib import Path

import jobs
import cells
import odometry
import pairs
import starts
import tum_windows

PEERS = ("augicp", "opencv", "pcl", "open3d")
DEPTH_IMAGES_ONLY = ("opencv",)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="+", choices=("odometry", "tum", "images", "lidar", "scans"))
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True, help="folder for tables, results and trajectories")
    parser.add_argument("--programs", type=Path, default=jobs.ROOT / "build/release/benchmarks/peers")
    parser.add_argument("--peers", nargs="+", choices=PEERS, default=PEERS)
    parser.add_argument("--windows", nargs="+", choices=tum_windows.WINDOWS, default=tum_windows.WINDOWS)
    parser.add_argument("--pairs", type=int, default=15, help="of each TUM cell (default 15)")
    parser.add_argument("--starts", type=int, default=10, help="of each cell of images, LiDAR or scans (default 10)")
    parser.add_argument("--scenes", nargs="+", choices=starts.SCENES, default=tuple(starts.SCENES), help="of scans")
    return parser.parse_args()


def programs(options, what):
    return [options.programs / f"augicp_peer_{peer}" for peer in options.peers
            if what not in ("lidar", "scans") or peer not in DEPTH_IMAGES_ONLY]


def measure(options, what):
    progress = lambda text: print(f"done: {text}", file=sys.stderr)
    if what == "lidar":
        work = cells.lidar_cells(options.data, options.starts)
        return pairs.measure(programs(options, what), work, options.output / "lidar.csv", progress)
    if what == "scans":
        scenes = [starts.SCENES[name](options.data) for name in options.scenes]
        return starts.measure(programs(options, what), scenes, options.starts, options.output, progress)
    windows = [tum_windows.Window(options.data / "tum" / name) for name in options.windows]
    if what == "odometry":
        return odometry.measure(programs(options, what), windows, options.output, progress)
    work = cells.tum_cells(windows, options.pairs) if what == "tum" else cells.image_cells(windows, options.starts)
    return pairs.measure(programs(options, what), work, options.output / f"{what}.csv", progress)


def main():
    options = arguments()
    options.output.mkdir(parents=True, exist_ok=True)
    for what in options.what:
        lines = measure(options, what)
        (options.output / f"{what}.md").write_text("\n".join(lines) + "\n")
        print("\n".join(lines), flush=True)


if __name__ == "__main__":
    main()
