#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the fragments of redkitchen under the stated truth and under augicp's pose, with the distances between them.

    experiments/results/redkitchen_picture.py --data FOLDER [--augicp build/release/apps/augicp/augicp] --output FILE.png
"""
import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import scans
from command import Align
from motions import error
from ply import positions, read_vertices

def draw_slice(axes, points, others, motion, title, centre):
    """A slab 6 cm thick, seen from above the target's xz plane."""
    moved = points @ motion[:3, :3].T + motion[:3, 3]
    for cloud, colour, name in ((others, "#0072b2", "target"), (moved, "#d55e00", "source")):
        slab = cloud[np.abs(cloud[:, 1] - centre) < 0.03]
        axes.plot(slab[:, 0], slab[:, 2], ".", color=colour, markersize=0.8, label=name)
    axes.set(title=title, xlabel="x (m)", ylabel="z (m)", aspect="equal")
    axes.legend(markerscale=8)


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--augicp", type=Path, default=root / "build/release/apps/augicp/augicp")
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    source, target, truth = scans.redkitchen(arguments.data)
    found = Align(arguments.augicp)(source, target, initial=truth)["T_target_source"]
    points, others = positions(read_vertices(source)), positions(read_vertices(target))

    figure, axes = plt.subplots(1, 3, figsize=(16, 5.2))
    centre = float(np.median(others[:, 1]))
    draw_slice(axes[0], points, others, truth, "slice under the stated truth", centre)
    draw_slice(axes[1], points, others, found, "the same under augicp's pose", centre)
    for motion, name in ((truth, "stated truth"), (found, "augicp")):
        moved = points[::40] @ motion[:3, :3].T + motion[:3, 3]
        distances = np.sort(scans.nearest_distances(moved, others[::2]))
        axes[2].plot(1000 * distances, np.linspace(0, 100, len(distances)), label=name)
        print(f"{name}: {100 * np.mean(distances < 0.02):.1f} % of the source within 2 cm of the target")
    axes[2].set(title="distance from source points to the target", xlabel="mm", ylabel="share of points (%)", xlim=(0, 100))
    axes[2].legend()
    print("difference: {:.1f} mm, {:.2f} deg".format(*(scale * value for scale, value in zip((1000, 1), error(found, truth)))))
    figure.tight_layout()
    figure.savefig(arguments.output, dpi=80)


if __name__ == "__main__":
    main()
