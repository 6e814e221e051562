#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""What a stop by certainty would save: the table of that name in docs/lab/convergence.md.

    experiments/convergence/certainty_stop.py --data FOLDER --kitti FOLDER_OF_BIN

The loop would end at the first step that is below a part of the pose's own standard deviation, by the covariance of the
result. Each pair is registered as it is, and once more with that number of iterations at most.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments/results"))
from approach import IMAGES, images, scan_pairs, short  # noqa: E402
from command import Align  # noqa: E402
from motions import error  # noqa: E402

PARTS = (0.02, 0.05, 0.1, 0.2)  # of the standard deviation
TIMED_PART, ROUNDS, KITTI_VOXEL_M = 0.1, 3, 0.5
RADII_PER_EXTENT = 30
ALONE = ("--no-search", "--no-coarse-to-fine", "--no-rolling-shutter")


def increment_between(before, after, reference):
    """Translation, then rotation vector, on the left, about a reference point."""
    motion = after @ np.linalg.inv(before)
    cosine = np.clip((np.trace(motion[:3, :3]) - 1) / 2, -1, 1)
    turn = motion[:3, :3] - motion[:3, :3].T
    axis = np.array([turn[2, 1], turn[0, 2], turn[1, 0]]) / 2
    angle = np.arctan2(np.linalg.norm(axis), cosine)
    rotation = axis * (angle / np.linalg.norm(axis) if np.linalg.norm(axis) > 0 else 0)
    moved = motion[:3, :3] @ reference + motion[:3, 3] - reference
    return np.concatenate([moved, rotation])


def deviations(before, after, result):
    """The motion in standard deviations of the pose."""
    step = increment_between(before, after, np.array(result["reference_point"]))
    return float(np.sqrt(step @ np.linalg.solve(np.array(result["covariance"]), step)))


def independent_deviations(before, after, result):
    """The same by H and the cost of the last iteration, as if the errors of all pairs were independent."""
    step = increment_between(before, after, np.array(result["reference_point"]))
    last = result["history"][-1]
    variance = 2 * last["cost"] / max(1, last["num_pairs"] - 6)
    return float(np.sqrt(step @ np.array(result["information"]) @ step / variance))


def is_small(before, after, result):
    """Below CAP times the step that ends the loop now."""
    step = increment_between(before, after, np.array(result["reference_point"]))
    least = CAP * result["options"]["min_step"]
    extent = RADII_PER_EXTENT * result["options"]["radius"]
    return np.linalg.norm(step[:3]) < least * extent and np.linalg.norm(step[3:]) < least


MEASURE, CAP = deviations, np.inf  # set by the command line


def stop_at(result, start, part):
    """The number of iterations after which the loop would end."""
    path = [start, *result["path"]]
    for k in range(1, len(path)):
        if is_small(path[k - 1], path[k], result) and MEASURE(path[k - 1], path[k], result) < part:
            return k
    return len(path) - 1


def align_ms(align, run, *words):
    """Median time of the iterations from the start and the verdict, and the last result."""
    results = [align(run[0], run[1], *ALONE, "--trace", *run[3], *words, initial=run[2]) for _ in range(ROUNDS)]
    return np.median([result["timing_ms"]["align"] for result in results]), results[-1]


def row(name, align, runs):
    saved = {part: [] for part in PARTS}
    iterations, times, off, strains = [], [], [], []
    for run in runs:
        ms, result = align_ms(align, run)
        if result["covariance"] is None:
            continue
        iterations.append(len(result["path"]))
        for part in PARTS:
            saved[part].append(iterations[-1] - stop_at(result, run[2], part))
        earlier = stop_at(result, run[2], TIMED_PART)
        early_ms, early = align_ms(align, run, "--max-iterations", earlier)
        times.append(early_ms / ms)
        off.append((1000 * error(early["T_target_source"], result["T_target_source"])[0],
                    deviations(early["T_target_source"], result["T_target_source"], result)))
        strains.append(abs(early["evidence"]["strain"] - result["evidence"]["strain"]))
    off = np.array(off).round(4)
    parts = ", ".join(f"{np.mean(saved[part]):.1f}" for part in PARTS)
    print(f"| {name} | {len(iterations)} | {np.mean(iterations):.1f} | {parts} | {np.median(times):.2f} | "
          f"{short(np.median(off[:, 0]))}, {short(off[:, 0].max())} | {np.median(off[:, 1]):.2f}, {off[:, 1].max():.2f} | "
          f"{max(strains):.3f} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--kitti", type=Path, required=True, help="consecutive scans, *.bin")
    parser.add_argument("--augicp", type=Path, default=ROOT / "build/release/apps/augicp/augicp")
    parser.add_argument("--only", default="", help="only pairs whose name contains this")
    parser.add_argument("--cap", type=float, default=np.inf, help="only steps below so many of the present limit")
    parser.add_argument("--independent", action="store_true", help="the deviation that the loop knows, from H and the cost")
    arguments = parser.parse_args()
    global CAP, MEASURE, PARTS, TIMED_PART
    CAP = arguments.cap
    if arguments.independent:
        MEASURE, PARTS, TIMED_PART = independent_deviations, (0.1, 0.25, 0.5, 1.0), 0.5
    align = Align(arguments.augicp)
    print(f"| pairs | number | iterations | saved at {', '.join(map(str, PARTS))} | time at {TIMED_PART} | off, mm | "
          "off, deviations | strain |\n|" + " --- |" * 8)
    scans = sorted(arguments.kitti.glob("*.bin"))
    families = {name: [(*run[:3], ())] for name, run in scan_pairs(arguments.data).items()}
    families["KITTI 0005"] = [(scans[k + 1], scans[k], np.eye(4), ("--voxel-size", KITTI_VOXEL_M))
                              for k in range(len(scans) - 1)]
    for name, (folder, camera, gap) in IMAGES.items():
        families[name] = [(source, target, np.eye(4), ("--camera", camera))
                          for source, target in images(arguments.data / folder, gap)]
    for name, runs in families.items():
        if arguments.only in name:
            row(name, align, runs)


if __name__ == "__main__":
    main()
