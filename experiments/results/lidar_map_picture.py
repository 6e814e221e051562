#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws the map of a LiDAR run from above, coloured by height, with the trajectory.

    experiments/results/lidar_map_picture.py --output FILE.png MAP.ply TRAJECTORY.txt      (augicp odometry FOLDER --map MAP.ply)
"""
import argparse
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from ply import positions, read_vertices

MAX_HEIGHT = 8.0  # above the lowest hundredth of the map, metres; higher points have the last colour


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("map", type=Path)
    parser.add_argument("trajectory", type=Path)
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    points = positions(read_vertices(arguments.map))
    points = points[np.argsort(points[:, 2])]
    heights = points[:, 2] - np.quantile(points[:, 2], 0.01)
    path = np.loadtxt(arguments.trajectory)[:, 1:3]
    figure, axes = plt.subplots(figsize=(9, 6))
    axes.scatter(points[:, 0], points[:, 1], c=heights, s=0.6, cmap="viridis", vmin=0.0, vmax=MAX_HEIGHT, linewidths=0)
    axes.plot(path[:, 0], path[:, 1], color="#d55e00", linewidth=1.2)
    axes.set_aspect("equal")
    axes.set_xlabel("x, m")
    axes.set_ylabel("y, m")
    figure.tight_layout()
    figure.savefig(arguments.output, dpi=75, metadata={"Software": None})


if __name__ == "__main__":
    main()
