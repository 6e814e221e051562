#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""How fast each method approaches its own end: the table of "The approach to the end" in docs/lab/convergence.md.

    experiments/convergence/approach.py --data FOLDER [--only NAME] [--one-sided]

Iterations alone, one thread, until steps below 1e-7 of the extent. Scans start from the true motion disturbed by 5 degrees
and 0.1 m (bunny: 5 mm), the LiDAR pair and depth images from the identity.
"""
import argparse
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments/results"))
from command import Align  # noqa: E402
from motions import error, read_rows  # noqa: E402
from scans import bunny, car, disturbed, lidar, redkitchen  # noqa: E402

ALONE = ("--no-search", "--no-coarse-to-fine", "--no-rolling-shutter", "--no-final-pass", "--no-covariance")
METHODS = {"augmented": (), "gicp": ("--method", "gicp"), "plane": ("--method", "plane"), "point": ("--method", "point"),
           "ndt": ("--method", "ndt"), "paper": ("--preset", "paper")}
ONE_SIDED = {  # with the target's information alone
    "gicp": ("--preset", "paper", "--method", "gicp"), "ndt": ("--preset", "paper", "--method", "ndt"),
    "gicp, no K": ("--preset", "paper", "--method", "gicp", "--kernel", "1e9"),
    "ndt, no K": ("--preset", "paper", "--method", "ndt", "--kernel", "1e9"), "ndt, default preset": ("--method", "ndt")}
TO_THE_END = ("--min-step", "1e-7", "--max-iterations", "60", "--trace")
NEAR = 0.1  # of the distance at the start

IMAGES = {  # folder, camera, gap
    "fr1/desk": ("tum/fr1_desk_a", "tum-fr1", 1), "fr1/desk, gap 10": ("tum/fr1_desk_a", "tum-fr1", 10),
    "fr1/xyz": ("tum/fr1_xyz_a", "tum-fr1", 1), "fr1/rpy": ("tum/fr1_rpy_a", "tum-fr1", 1),
}
PAIRS_PER_SEQUENCE = 5


def images(folder, gap):
    """Pairs of paths, evenly spread over a sequence."""
    frames = [folder / row[1] for row in read_rows(folder / "depth.txt")]
    first = np.unique(np.linspace(0, len(frames) - gap - 1, PAIRS_PER_SEQUENCE).astype(int))
    return [(frames[k + gap], frames[k]) for k in first]


def scan_pairs(data):
    """{name: (source, target, start, truth)}"""
    found = {}
    for name, read, distance in (("LiDAR pair", lidar, None), ("car", car, 0.1), ("redkitchen", redkitchen, 0.1),
                                 ("bunny 045", lambda d: bunny(d, "bun045.ply"), 0.005),
                                 ("bunny 315", lambda d: bunny(d, "bun315.ply"), 0.005),
                                 ("bunny 090", lambda d: bunny(d, "bun090.ply"), 0.005)):
        source, target, truth = read(data)
        start = np.eye(4) if distance is None else disturbed(truth, np.zeros(3), 5.0, distance, 0)
        found[name] = (source, target, start, truth)
    room = ROOT / "data/room_pair"
    truth = np.loadtxt(room / "T_target_source.txt")
    found["room"] = (room / "source.ply", room / "target.ply", disturbed(truth, np.zeros(3), 5.0, 0.1, 0), truth)
    return found


def path_of(align, source, target, start, words):
    return [start, *align(source, target, *ALONE, *TO_THE_END, *words, initial=start)["path"]]


def approach(align, source, target, start, words):
    """Metres from the end at the start and after each iteration."""
    path = path_of(align, source, target, start, words)
    return [error(pose, path[-1])[0] for pose in path]


def after(distances, k):
    return distances[min(k, len(distances) - 1)]


def iterations_to_end(distances):
    """The first iteration from which the distance stays below NEAR of that at the start."""
    far = [k for k, distance in enumerate(distances) if distance > NEAR * distances[0]]
    return far[-1] + 1 if far else 0


def short(value):
    """Two digits, without an exponent."""
    return np.format_float_positional(value, precision=2, fractional=False, trim="-")


def row(name, align, runs, methods):
    cells = []
    for words in methods.values():
        paths = [approach(align, *run[:3], (*run[3], *words)) for run in runs]
        mm = [1000 * np.median([after(path, k) for path in paths]) for k in (1, 2, 3)]
        cells.append(", ".join(map(short, mm)) + f"; {np.median([iterations_to_end(p) for p in paths]):.0f}")
    return f"| {name} | " + " | ".join(cells) + " |"


def print_one_sided(align, pairs, only):
    """The first iteration within NEAR, and the error of the end in mm."""
    print("| pair | " + " | ".join(ONE_SIDED) + " |\n|" + " --- |" * (1 + len(ONE_SIDED)))
    for name, (source, target, start, truth) in pairs.items():
        if only not in name:
            continue
        paths = [path_of(align, source, target, start, words) for words in ONE_SIDED.values()]
        cells = [f"{iterations_to_end([error(pose, path[-1])[0] for pose in path])}; "
                 f"{short(1000 * error(path[-1], truth)[0])}" for path in paths]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--augicp", type=Path, default=ROOT / "build/release/apps/augicp/augicp")
    parser.add_argument("--only", default="", help="only pairs whose name contains this")
    parser.add_argument("--one-sided", action="store_true", help="gicp and ndt with the target's information alone")
    arguments = parser.parse_args()
    align = Align(arguments.augicp)
    if arguments.one_sided:
        return print_one_sided(align, scan_pairs(arguments.data), arguments.only)
    print("| pair | " + " | ".join(METHODS) + " |\n|" + " --- |" * (1 + len(METHODS)))
    for name, (source, target, start, _) in scan_pairs(arguments.data).items():
        if arguments.only in name:
            print(row(name, align, [(source, target, start, ())], METHODS), flush=True)
    for name, (folder, camera, gap) in IMAGES.items():
        if arguments.only in name:
            runs = [(source, target, np.eye(4), ("--camera", camera))
                    for source, target in images(arguments.data / folder, gap)]
            print(row(name, align, runs, METHODS), flush=True)


if __name__ == "__main__":
    main()
