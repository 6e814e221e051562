#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures augicp's registration figures on real data and prints them as Markdown (docs/lab/results.md).

    experiments/results/run.py --data FOLDER [--augicp build/release/apps/augicp/augicp] [--pairs 50] [--output FILE]

FOLDER holds tum/, lidar/, pairs/ and bunny/ as experiments/results/README.md lists them.
"""
import argparse
import sys
from pathlib import Path

import scans
import tum
from command import Align

SEQUENCES = ("fr1_desk_a", "fr1_rpy_a")
GAPS = (1, 10)


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--augicp", type=Path, default=root / "build/release/apps/augicp/augicp")
    parser.add_argument("--pairs", type=int, default=50, help="pairs of each sequence and gap (default 50)")
    parser.add_argument("--only", choices=("scans", "tum"), help="half of it")
    parser.add_argument("--output", type=Path, help="default: stdout")
    arguments = parser.parse_args()
    align = Align(arguments.augicp)
    progress = lambda text: print(f"done: {text}", file=sys.stderr)

    lines = []
    if arguments.only != "tum":
        lines += scans.table(align, arguments.data, progress)
    for sequence in SEQUENCES if arguments.only != "scans" else ():
        for gap in GAPS:
            folder = arguments.data / "tum" / sequence
            lines += tum.table(tum.measure(align, folder, gap, arguments.pairs, progress), folder, gap)
    text = "\n".join(lines)
    arguments.output.write_text(text) if arguments.output else print(text)


if __name__ == "__main__":
    main()
