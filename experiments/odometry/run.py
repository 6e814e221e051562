#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures augicp odometry on TUM sequences, as it is and with one part of it left out at a time (docs/lab/results.md).

    experiments/odometry/run.py --data FOLDER [--augicp build/release/apps/augicp/augicp] [--output OUTPUT]

FOLDER holds the TUM sequences fr1_desk_a, fr1_xyz_a, fr1_rpy_a (see experiments/results/README.md). Prints Markdown.
"""
import argparse
import json
import subprocess
import sys
import tempfile
from pathlib import Path

SEQUENCES = ("fr1_desk_a", "fr1_xyz_a", "fr1_rpy_a")
PINHOLE_ONLY = "517.3 516.5 318.6 255.3"  # tum-fr1 without its lens and shutter
LENS_ONLY = PINHOLE_ONLY + " 0.2624 -0.9531 -0.0054 0.0026 1.1633"
VARIANTS = {
    "default": ("--camera", "tum-fr1"),
    "to the previous frame": ("--camera", "tum-fr1", "--reference", "previous"),
    "GICP's objective": ("--camera", "tum-fr1", "--method", "gicp"),
    "twice the columns": ("--camera", "tum-fr1", "--pixel-step", "2"),
    "no rolling shutter": ("--camera", LENS_ONLY),
    "no lens either": ("--camera", PINHOLE_ONLY),
    "and to the previous frame": ("--camera", PINHOLE_ONLY, "--reference", "previous"),
}
CLOCK_OFFSET_S = "-0.022"  # of the depth images on fr1, see docs/lab/results.md


def run(*words):
    finished = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, check=False)
    if finished.returncode not in (0, 5):
        sys.exit(f"{' '.join(map(str, words))}: exit code {finished.returncode}")
    return finished.stdout


def errors(augicp, trajectory, truth, *words):
    found = json.loads(run(augicp, "evaluate", trajectory, truth, "--json", "-", *words))
    return (found["ate_aligned"]["translation"]["rmse"] * 100, found["rpe"]["translation"]["rmse"] * 1000,
            found["rpe"]["rotation_deg"]["rmse"])


def measure(augicp, sequence, words, output):
    run(augicp, "odometry", sequence, "--output", output, "--quiet", *words)
    metrics = json.loads((output / "metrics.json").read_text())
    truth = sequence / "groundtruth.txt"
    trajectory = output / "trajectory.txt"
    ate, _, _ = errors(augicp, trajectory, truth)
    _, rpe_mm, rpe_deg = errors(augicp, trajectory, truth, "--truth", "interpolated", "--time-offset", CLOCK_OFFSET_S)
    tracked = metrics["num_tracked"] + metrics["num_started"]
    lost = metrics["num_frames"] - tracked
    return f"{ate:.2f} cm, {rpe_mm:.2f} mm, {rpe_deg:.3f} deg" + (f" ({lost} frames lost)" if lost else "")


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--augicp", type=Path, default=root / "build/release/apps/augicp/augicp")
    parser.add_argument("--output", type=Path, help="keep the results here (default: nowhere)")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        output = arguments.output or Path(scratch)
        print("| variant | " + " | ".join(SEQUENCES) + " |\n| --- |" + " --- |" * len(SEQUENCES))
        for name, words in VARIANTS.items():
            cells = [measure(arguments.augicp, arguments.data / sequence, words, output / f"{name} {sequence}".replace(" ", "_"))
                     for sequence in SEQUENCES]
            print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
