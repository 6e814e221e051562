#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures and draws the paper's Table 4 on generated scenes; README.md has the command lines."""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import figures

HERE = Path(__file__).resolve().parent
KERNELS = {"k1": ("--points", 300000, "--kernel", 1),
           "k1000": ("--points", 100000, "--kernel", 1000),
           "k100": ("--points", 100000, "--kernel", 100, "--methods", "gicp,augmented")}
OUTLIERS, NORMAL_NOISES, POINT_NOISE = (0.0, 50.0, 90.0), (0.0, 5.0, 20.0), 0.01
REACHED_DEG = 1.0


def draw(name, output):
    rows = figures.chosen(figures.read_rows(output / f"table4_{name}.csv"), point_noise=POINT_NOISE)
    figure, axes = figures.plt.subplots(2 * len(OUTLIERS), len(NORMAL_NOISES), figsize=(12, 15), sharex=True)
    for i, outliers in enumerate(OUTLIERS):
        for j, noise in enumerate(NORMAL_NOISES):
            cell = figures.chosen(rows, outliers_percent=outliers, normal_noise_deg=noise)
            for axis, column, label in ((axes[2 * i, j], "rotation_deg_mean", "rotation (deg)"),
                                        (axes[2 * i + 1, j], "translation_mean", "translation (m)")):
                figures.draw_curves(axis, cell, column)
                axis.set(yscale="log", xlim=(0, 20))
                axis.set_title(f"{outliers:g} % false, normals {noise:g} deg", fontsize=9)
                if j == 0:
                    axis.set_ylabel(label)
    axes[0][0].legend(fontsize=8)
    figure.suptitle(f"known pairs, points {1000 * POINT_NOISE:g} mm, {name}")
    figures.save(figure, output / f"table4_{name}")


def iterations_needed(rows):
    """The first iteration with a mean rotation error below REACHED_DEG."""
    return next((int(row["iteration"]) for row in rows if row["rotation_deg_mean"] < REACHED_DEG), "never")


def print_table(name, output):
    rows = figures.read_rows(output / f"table4_{name}.csv")
    methods = [method for method in figures.STYLES if figures.chosen(rows, method=method)]
    print(f"\n{name}: iterations until {REACHED_DEG:g} deg; last translation (mm)\n| false, normals | {' | '.join(methods)} |")
    print("| --- |" + " --- |" * len(methods))
    for outliers in OUTLIERS:
        for noise in NORMAL_NOISES:
            cells = [figures.chosen(rows, outliers_percent=outliers, normal_noise_deg=noise, point_noise=POINT_NOISE,
                                    method=method) for method in methods]
            print(f"| {outliers:g} %, {noise:g} deg | " + " | ".join(
                f"{iterations_needed(cell)}; {1000 * cell[-1]['translation_mean']:.2f}" for cell in cells) + " |")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--measure", action="store_true", help="default: only draw what was measured before")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--output", type=Path, default=HERE)
    arguments = parser.parse_args()
    for name, words in KERNELS.items():
        if arguments.measure:
            figures.augicp("synthetic", "--seeds", arguments.seeds, *words, "--output", arguments.output / f"table4_{name}.csv")
        draw(name, arguments.output)
        print_table(name, arguments.output)
    figures.check(lambda name: figures.read_rows(arguments.output / name), HERE / "expected.json")


if __name__ == "__main__":
    main()
