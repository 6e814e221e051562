#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Success of registrations from the identity, with each part beyond the paper switched off, and from the true pose.

    experiments/convergence/run.py --data FOLDER [--pixel-step 2] [--targets 60]

FOLDER holds tum/fr1_desk_a, tum/fr1_xyz_a and tum/fr1_rpy_a. Prints one table: pairs within 5 cm and 2 degrees (within
2 cm and 1 degree), and the median errors, for gaps of 1, 10 and 20 images.
"""
import argparse
import csv
import subprocess
import sys
import tempfile
from pathlib import Path

SEQUENCES = ("fr1_desk_a", "fr1_xyz_a", "fr1_rpy_a")
ALL = ("--search", "--coarse-to-fine", "--rolling-shutter")
VARIANTS = {
    "default": ALL,
    "default, from the true pose": (*ALL, "--from-truth"),
    "no search": ALL[1:],
    "no rolling shutter": ALL[:2],
    "not coarse to fine": ("--search", "--rolling-shutter"),
    "only the search": ("--search",),
    "only coarse to fine": ("--coarse-to-fine",),
    "only the rolling shutter": ("--rolling-shutter",),
    "iterations alone": (),
    "iterations alone, from the true pose": ("--from-truth",),
    "default, gicp's objective": (*ALL, "--methods", "gicp"),
    "paper preset": ("--presets", "paper"),
}
ITERATIONS = 20
CLOCK_OFFSET_S = "-0.022"  # of the depth images on fr1, see docs/lab/results.md


def rows(augicp, sequence, arguments, words):
    with tempfile.NamedTemporaryFile(suffix=".csv") as output:
        base = ["--camera", "tum-fr1", "--gaps", "1,10,20", "--iterations", ITERATIONS, "--pairs", arguments.targets,
                "--pixel-step", arguments.pixel_step, "--threads", 1, "--time-offset", CLOCK_OFFSET_S, "--output", output.name]
        for option, value in (("--methods", "augmented"), ("--presets", "default")):
            base += [] if option in words else [option, value]
        finished = subprocess.run([str(word) for word in (augicp, "experiment", "sequence", sequence, *base, *words)],
                                  check=False)
        if finished.returncode:
            sys.exit(finished.returncode)
        return list(csv.DictReader(line for line in Path(output.name).read_text().splitlines() if line[0] != "#"))


def cell(found):
    last = [row for row in found if int(row["iteration"]) == ITERATIONS][0]
    return "{:.0f} ({:.0f}) %, {:.1f} mm, {:.2f} deg".format(
        100 * float(last["success"]), 100 * float(last["success_narrow"]),
        1000 * float(last["translation_median"]), float(last["rotation_deg_median"]))


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--augicp", type=Path, default=root / "build/release/apps/augicp/augicp")
    parser.add_argument("--targets", type=int, default=60)
    parser.add_argument("--pixel-step", type=int, default=2)
    parser.add_argument("--sequences", nargs="+", default=SEQUENCES)
    parser.add_argument("--variants", nargs="+", default=VARIANTS, choices=VARIANTS)
    arguments = parser.parse_args()
    print("| sequence | variant | gap 1 | gap 10 | gap 20 |\n| --- | --- | --- | --- | --- |")
    for sequence in arguments.sequences:
        for variant in arguments.variants:
            found = rows(arguments.augicp, arguments.data / "tum" / sequence, arguments, VARIANTS[variant])
            cells = [cell([row for row in found if row["gap"] == gap]) for gap in ("1", "10", "20")]
            print(f"| {sequence} | {variant} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
