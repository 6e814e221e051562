#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Table 3 at full resolution, as Markdown: when each method is within a tenth of its end, and where that is.

    experiments/table3/full.py --data FOLDER [--output FOLDER] [--every 3]

FOLDER holds fr1_desk_a, fr1_rpy_a, fr1_xyz_a. Every N-th image is a target; the truth is read 22 ms before the stamp.
Without --data the CSV files in --output are read.
"""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import figures
from run import GAPS, SEQUENCES

METHODS = ("point", "plane", "ndt", "gicp", "augmented")
NEAR = 1.1  # of the last error
OFFSET_S = -0.022


def measure(data, output, every):
    for name in SEQUENCES:
        figures.augicp("sequence", data / f"fr1_{name}_a", "--camera", "tum-fr1", "--every", every, "--pixel-step", 1,
                       f"--time-offset={OFFSET_S}", "--output", output / f"full_{name}.csv")


def iteration_near_end(errors):
    """The first iteration from which the error stays within NEAR of the last."""
    far = [k for k, error in enumerate(errors) if error > NEAR * errors[-1]]
    return far[-1] + 1 if far else 0


def cell(rows):
    """Medians over the pairs: the iteration for translation and for rotation; the last errors."""
    translations, rotations = ([row[column] for row in rows] for column in ("translation_median", "rotation_deg_median"))
    return (f"{iteration_near_end(translations)}, {iteration_near_end(rotations)}; "
            f"{1000 * translations[-1]:.1f} mm, {rotations[-1]:.2f} deg")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, help="folder of the sequences (default: only print)")
    parser.add_argument("--output", type=Path, default=Path(__file__).resolve().parent)
    parser.add_argument("--every", type=int, default=3)
    arguments = parser.parse_args()
    if arguments.data:
        measure(arguments.data, arguments.output, arguments.every)
    print("| sequence, gap, preset | " + " | ".join(METHODS) + " |\n|" + " --- |" * (1 + len(METHODS)))
    for name in SEQUENCES:
        rows = figures.read_rows(arguments.output / f"full_{name}.csv")
        for gap in GAPS:
            for preset in ("default", "paper"):
                cells = [cell(figures.chosen(rows, gap=gap, preset=preset, method=method)) for method in METHODS]
                print(f"| {name}, {gap:g}, {preset} | " + " | ".join(cells) + " |")


if __name__ == "__main__":
    main()
