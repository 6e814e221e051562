#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Runs the programs people register point clouds with today on the same inputs, and prints what they reach as Markdown.

    benchmarks/peers/run.py odometry --data FOLDER --output FOLDER [--peers augicp opencv]

README.md says what the data folder holds and with which settings each peer runs.
"""
import argparse
import sys
from pathlib import Path

from jobs import ROOT
import odometry
import tum_windows

PEERS = ("augicp", "opencv")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("odometry",))
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--output", type=Path, required=True, help="folder for trajectories and results")
    parser.add_argument("--programs", type=Path, default=ROOT / "build/release/benchmarks/peers")
    parser.add_argument("--peers", nargs="+", choices=PEERS, default=PEERS)
    parser.add_argument("--windows", nargs="+", choices=tum_windows.WINDOWS, default=tum_windows.WINDOWS)
    return parser.parse_args()


def main():
    options = arguments()
    options.output.mkdir(parents=True, exist_ok=True)
    progress = lambda text: print(f"done: {text}", file=sys.stderr)
    programs = [options.programs / f"augicp_peer_{peer}" for peer in options.peers]
    windows = [tum_windows.Window(options.data / "tum" / name) for name in options.windows]
    lines = odometry.measure(programs, windows, options.output, progress)
    (options.output / f"{options.what}.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
