#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Parts of LiDAR odometry left out: the table "Parts left out" in docs/lab/lidar_odometry.md.

    experiments/odometry/lidar_ablation.py FOLDER[:TIMES] ... [--build build/release]

Each FOLDER has the scans of a sequence and reference_pairs.txt or reference_tum.txt; TIMES is order (the default), azimuth or
none. Prints Markdown: the error of the motion between the scans of the pairs in % of its length, or the drift over the whole
sequence in % of the path; scans that are not tracked; processor time of a scan.
"""
import argparse
import subprocess
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]


def poses_of(rows):
    """(N, 4, 4) of rows tx ty tz qx qy qz qw."""
    x, y, z, w = (rows[:, 3:7] / np.linalg.norm(rows[:, 3:7], axis=1, keepdims=True)).T
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3, :3] = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                                 [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                                 [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]).transpose(2, 0, 1)
    poses[:, :3, 3] = rows[:, :3]
    return poses


def motion(poses, first, second):
    return np.linalg.inv(poses[first]) @ poses[second]


def error_percent(found, folder):
    """The mean over the pairs with the largest gap, each in % of its own length; or the drift over a reference trajectory."""
    if (folder / "reference_pairs.txt").exists():
        rows = np.atleast_2d(np.loadtxt(folder / "reference_pairs.txt"))
        rows = rows[rows[:, 1] < len(found)]
        rows = rows[rows[:, 1] - rows[:, 0] == (rows[:, 1] - rows[:, 0]).max()]
        truths, ends = poses_of(rows[:, 2:]), rows[:, :2].astype(int)
        lengths = np.linalg.norm(truths[:, :3, 3], axis=1)
    else:
        reference = poses_of(np.loadtxt(folder / "reference_tum.txt")[:, 1:])
        ends = np.array([[0, min(len(reference), len(found)) - 1]])
        truths = motion(reference, *ends[0])[None]
        lengths = np.linalg.norm(np.diff(reference[:, :3, 3], axis=0), axis=1).sum(keepdims=True)
    errors = [np.linalg.norm((np.linalg.inv(truth) @ motion(found, *pair))[:3, 3]) for truth, pair in zip(truths, ends)]
    return 100.0 * np.mean(errors / lengths)


def measured(program, folder, times):
    """{variant: text of a cell}"""
    cells = {}
    with tempfile.TemporaryDirectory() as output:
        finished = subprocess.run([program, folder, output, times], capture_output=True, text=True, check=True)
        for line in finished.stdout.splitlines():
            variant, _, _, num_degenerate, num_others, time_ms = line.split()
            found = poses_of(np.loadtxt(Path(output) / f"{variant}.txt")[:, 1:])
            error = f"{error_percent(found, folder):.2f}" if list(folder.glob("reference_*.txt")) else ""
            counts = [f"{count} {word}" for count, word in ((num_degenerate, "degenerate"), (num_others, "astray")) if count != "0"]
            cells[variant] = ", ".join(filter(None, [error, *counts, f"{float(time_ms):.0f} ms"]))
    return cells


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--build", type=Path, default=ROOT / "build/release")
    arguments = parser.parse_args()
    program = arguments.build / "experiments/odometry/lidar_ablation"
    columns = {}
    for word in arguments.folders:
        folder, _, times = word.partition(":")
        columns[" ".join(filter(None, [Path(folder).name, times]))] = measured(program, Path(folder), times or "order")
    print("| variant | " + " | ".join(columns) + " |\n| --- |" + " --- |" * len(columns))
    for variant in next(iter(columns.values())):
        print(f"| {variant.replace('_', ' ')} | " + " | ".join(column[variant] for column in columns.values()) + " |")


if __name__ == "__main__":
    main()
