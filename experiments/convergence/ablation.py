#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Each part of the default off: the table "Each part of the loop off" in docs/lab/convergence.md.

    experiments/convergence/ablation.py --data FOLDER

The pairs and starts are those of approach.py, three generated rooms as clouds beside them.
"""
import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments/results"))
from approach import IMAGES, after, images, iterations_to_end, scan_pairs, short  # noqa: E402
from motions import Trajectory, error  # noqa: E402

SEEDS = (1, 2, 3, 4, 5)
OFFSET_S = -0.022  # the truth of fr1 is read this much before the stamp
FAMILIES = {"LiDAR pair": ("LiDAR pair",), "car": ("car",), "bunny": ("bunny 045", "bunny 315", "bunny 090"),
            "redkitchen": ("redkitchen",)}


def paths_of(program, *words):
    """{variant: poses}"""
    lines = subprocess.run([program, *map(str, words)], capture_output=True, text=True, check=True).stdout.splitlines()
    return {line.split()[0]: np.array(line.split()[1:], float).reshape(-1, 4, 4) for line in lines}


def from_start(program, source, target, start, *words):
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        np.savetxt(file.name, start)
        return paths_of(program, source, target, file.name, *words)


def image_truths(folder, gap):
    """The true motions of the pairs of images()."""
    truth = Trajectory(folder / "groundtruth.txt")
    at = lambda image: truth.at(float(image.stem) + OFFSET_S)
    return [np.linalg.inv(at(target)) @ at(source) for source, target in images(folder, gap)]


def cell_of(paths, truths):
    """Medians: mm from the own end after 1, 2 and 3 iterations; the first within a tenth; mm from the truth."""
    distances = [[error(pose, path[-1])[0] for pose in path] for path in paths]
    mm = ", ".join(short(1000 * np.median([after(of_pair, k) for of_pair in distances])) for k in (1, 2, 3))
    tenth = np.median([iterations_to_end(of_pair) for of_pair in distances])
    return f"{mm}; {tenth:.0f}; {short(1000 * np.median([error(path[-1], truth)[0] for path, truth in zip(paths, truths)]))} mm"


def column_of(runs, truths):
    """{variant: cell}"""
    return {name: cell_of([run[name] for run in runs], truths) for name in runs[0] if name != "truth"}


def columns(program, data):
    pairs, found = scan_pairs(data), {}
    for family, names in FAMILIES.items():
        runs = [from_start(program, *pairs[name][:3]) for name in names]
        found[family] = column_of(runs, [pairs[name][3] for name in names])
    rooms = [paths_of(program, "room", seed) for seed in SEEDS]
    found["generated rooms"] = column_of(rooms, [run["truth"][0] for run in rooms])
    for name, (folder, camera, gap) in IMAGES.items():
        runs = [from_start(program, *pair, np.eye(4), camera) for pair in images(data / folder, gap)]
        found[name] = column_of(runs, image_truths(data / folder, gap))
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/experiments/convergence/ablation")
    arguments = parser.parse_args()
    found = columns(arguments.program, arguments.data)
    print("| off | " + " | ".join(found) + " |\n|" + " --- |" * (1 + len(found)))
    for variant in next(iter(found.values())):
        print(f"| {variant.replace('_', ' ')} | " + " | ".join(column[variant] for column in found.values()) + " |")


if __name__ == "__main__":
    main()
