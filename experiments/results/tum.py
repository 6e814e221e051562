# SPDX-License-Identifier: MIT
"""Depth images of TUM RGB-D against motion capture, identity guess, errors after every iteration."""
from concurrent.futures import ThreadPoolExecutor

import numpy as np

from motions import Trajectory, error, read_rows

ITERATIONS = 10
# The depth images of TUM fr1 lag behind the motion-capture clock; see docs/lab/results.md.
OFFSETS_S = (-0.022, 0.0)
ITERATIONS_ALONE = ("--no-search", "--no-coarse-to-fine", "--no-rolling-shutter")
METHODS = {
    "augmented": ITERATIONS_ALONE,
    "gicp": (*ITERATIONS_ALONE, "--method", "gicp"),
    "paper preset, augmented": ("--preset", "paper"),
    "paper preset, gicp": ("--preset", "paper", "--method", "gicp"),
}


def errors_of_pair(align, folder, frames, truth, k, gap, options):
    """Array (offset, iteration 0..10, [m, deg])."""
    (target_stamp, target), (source_stamp, source) = frames[k], frames[k + gap]
    result = align(folder / source, folder / target, "--camera", "tum-fr1", "--trace", "--min-step", 0,
                   "--max-iterations", ITERATIONS, *options)
    # A run that had to stop keeps its last pose.
    path = [np.eye(4), *result["path"]]
    path += [path[-1]] * (ITERATIONS + 1 - len(path))
    return [[error(pose, np.linalg.inv(truth.at(float(target_stamp) + offset)) @ truth.at(float(source_stamp) + offset))
             for pose in path] for offset in OFFSETS_S]


def measure(align, folder, gap, num_pairs, progress):
    """{method: array (pair, offset, iteration, 2)}"""
    frames, truth = read_rows(folder / "depth.txt"), Trajectory(folder / "groundtruth.txt")
    first = np.linspace(0, len(frames) - gap - 1, num_pairs).astype(int)
    measured = {}
    for method, options in METHODS.items():
        with ThreadPoolExecutor() as pool:
            runs = [pool.submit(errors_of_pair, align, folder, frames, truth, k, gap, options) for k in first]
            measured[method] = np.array([run.result() for run in runs])
        progress(f"{folder.name} gap {gap}: {method}")
    return measured


def table(measured, folder, gap):
    shown = [0, 1, 2, 3, 5, 10]
    count = len(next(iter(measured.values())))
    lines = [f"### {folder.name}, gap {gap}, {count} pairs", "",
             "Mean error after iteration (mm / deg), truth at stamp - 22 ms; last columns: median after 10, share within "
             "5 cm and 2 deg, and the mean after 10 with the truth at the stamp itself.", "",
             "| method | " + " | ".join(map(str, shown)) + " | median | success | mean, no offset |",
             "| --- |" + " --- |" * (len(shown) + 3)]
    for method, errors in measured.items():
        mean, last = errors[:, 0].mean(axis=0), errors[:, 0, -1]
        cells = [f"{1000 * mean[i, 0]:.2f} / {mean[i, 1]:.3f}" for i in shown]
        median, uncorrected = np.median(last, axis=0), errors[:, 1, -1].mean(axis=0)
        success = np.mean((last[:, 0] < 0.05) & (last[:, 1] < 2.0))
        cells += [f"{1000 * median[0]:.2f} / {median[1]:.3f}", f"{100 * success:.0f} %",
                  f"{1000 * uncorrected[0]:.2f} / {uncorrected[1]:.3f}"]
        lines.append(f"| {method} | " + " | ".join(cells) + " |")
    return lines + [""]
