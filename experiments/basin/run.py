#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures and draws from how far away two depth images still find their motion; README.md has the command lines."""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import figures

HERE = Path(__file__).resolve().parent
METHODS = ("gicp", "augmented")


def measure(data, output):
    images = sorted((data / "fr1_desk_a/depth").glob("*.png"))
    for method in METHODS:
        figures.augicp("basin", images[10], images[5], "--camera", "tum-fr1", "--angles-deg", "20,30,45,60", "--distances",
                       "0,0.3,0.6", "--starts", 4, "--max-iterations", 30, "--method", method,
                       "--no-search", "--no-coarse-to-fine", "--no-rolling-shutter", "--output",
                       output / f"basin_{method}.csv")


def draw(output):
    figure, axes = figures.plt.subplots(1, len(METHODS), figsize=(9, 3.5))
    for axis, method in zip(axes, METHODS):
        rows = figures.read_rows(output / f"basin_{method}.csv")
        angles, distances = sorted({row["angle_deg"] for row in rows}), sorted({row["distance"] for row in rows})
        surface = [[figures.chosen(rows, angle_deg=angle, distance=distance)[0]["success"] for angle in angles]
                   for distance in distances]
        picture = axis.imshow(surface, origin="lower", vmin=0, vmax=1, cmap="viridis", aspect="auto")
        axis.set(title=method, xlabel="rotated by (deg)", ylabel="moved by (m)")
        axis.set_xticks(range(len(angles)), [f"{angle:g}" for angle in angles])
        axis.set_yticks(range(len(distances)), [f"{distance:g}" for distance in distances])
    figure.colorbar(picture, ax=list(axes), label="share of successes")
    figure.savefig(output / "basin.png", dpi=60)
    figure.savefig(output / "basin.svg", metadata={"Date": None})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, help="folder of fr1_desk_a (default: only draw)")
    parser.add_argument("--output", type=Path, default=HERE)
    arguments = parser.parse_args()
    if arguments.data:
        measure(arguments.data, arguments.output)
    draw(arguments.output)
    figures.check(lambda name: figures.read_rows(arguments.output / name), HERE / "expected.json")


if __name__ == "__main__":
    main()
