#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The effect of each choice of the paper preset on twelve pairs of fr1/desk, as Markdown: one change in each row."""
import argparse
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import figures

OFFSET_S = -0.0325  # the clock of fr1/desk, found by run.py
GAPS, ITERATIONS, METHODS = (1.0, 10.0), (1.0, 10.0), ("gicp", "augmented")
COMMON = ("--camera", "tum-fr1", "--presets", "paper", "--methods", ",".join(METHODS), "--gaps", "1,10", "--pairs", 12,
          "--pixel-step", 2, "--time-offset", OFFSET_S)
VARIANTS = ((), ("--surroundings", "square"), ("--surroundings", "ball"), ("--kernel", 30), ("--kernel", 1000), ("--lever", 0.2),
            ("--damping", 0), ("--damping", 0.01), ("--damping", 0.1), ("--damping", 1), ("--classifier", "normals"))


def rotations(rows, method):
    """Mean rotation errors (deg) of both gaps: after the first and the last iteration."""
    found = lambda gap, iteration: figures.chosen(rows, method=method, gap=gap, iteration=iteration)[0]["rotation_deg_mean"]
    return " / ".join(", ".join(f"{found(gap, iteration):.3f}" for iteration in ITERATIONS) for gap in GAPS)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, required=True, help="folder of fr1_desk_a")
    parser.add_argument("--output", type=Path, default=Path(__file__).resolve().parent)
    arguments = parser.parse_args()
    print("| changed | gicp | augmented |\n| --- | --- | --- |")
    for words in VARIANTS:
        name = "_".join(map(str, words)).replace("--", "") or "nothing"
        file = arguments.output / f"variant_{name}.csv"
        figures.augicp("sequence", arguments.data / "fr1_desk_a", *COMMON, *words, "--output", file)
        rows = figures.read_rows(file)
        changed = f"`{' '.join(map(str, words))}`" if words else "nothing"
        print(f"| {changed} | " + " | ".join(rotations(rows, method) for method in METHODS) + " |", flush=True)


if __name__ == "__main__":
    main()
