#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures and draws the paper's Table 3 on real depth images; README.md has the command lines."""
import argparse
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import figures

HERE = Path(__file__).resolve().parent
SEQUENCES = ("desk", "rpy", "xyz")
GAPS = (1.0, 10.0, 20.0)
PANELS = [(preset, column, scale, label) for preset in ("default", "paper")
          for column, scale, label in (("rotation_deg_mean", 1, "rotation (deg)"), ("translation_mean", 1000, "translation (mm)"))]


def measure(data, output):
    for name in SEQUENCES:
        figures.augicp("sequence", data / f"fr1_{name}_a", "--camera", "tum-fr1", "--every", 5, "--pixel-step", 2,
                       "--time-offset", "0,auto", "--output", output / f"table3_{name}.csv")


def best_offset(rows):
    """The offset found from the data, of the two in the file."""
    return next(row["time_offset_s"] for row in rows if row["time_offset_s"] != 0)


def draw(name, output):
    rows = figures.read_rows(output / f"table3_{name}.csv")
    rows = figures.chosen(rows, time_offset_s=best_offset(rows))
    figure, axes = figures.plt.subplots(len(PANELS), len(GAPS), figsize=(12, 11), sharex=True)
    for line, (preset, column, scale, label) in zip(axes, PANELS):
        for axis, gap in zip(line, GAPS):
            figures.draw_curves(axis, figures.chosen(rows, preset=preset, gap=gap), column, scale)
            axis.set_title(f"{preset}, gap {gap:g}", fontsize=9)
            axis.set_ylim(bottom=0)
        line[0].set_ylabel(f"mean {label}")
    axes[0][0].legend(fontsize=8)
    figure.suptitle(f"fr1/{name}, {rows[0]['pairs']:g} pairs")
    figures.save(figure, output / f"table3_{name}")


def catch_up(rows):
    """{(gap, preset): first iteration at which augmented's mean rotation is at most GICP's last, of how many}"""
    found = {}
    for gap in GAPS:
        for preset in ("default", "paper"):
            curves = {method: [row["rotation_deg_mean"] for row in figures.chosen(rows, gap=gap, preset=preset, method=method)]
                      for method in ("gicp", "augmented")}
            last = curves["gicp"][-1]
            reached = [i for i, error in enumerate(curves["augmented"]) if error <= last]
            # The guess may be better than where GICP ends: then there is nothing to reach.
            found[gap, preset] = "diverged" if last >= curves["gicp"][0] else reached[0] if reached else "never"
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, help="folder of fr1_desk_a, fr1_rpy_a, fr1_xyz_a (default: only draw)")
    parser.add_argument("--output", type=Path, default=HERE)
    arguments = parser.parse_args()
    if arguments.data:
        measure(arguments.data, arguments.output)
    for name in SEQUENCES:
        draw(name, arguments.output)
        rows = figures.read_rows(arguments.output / f"table3_{name}.csv")
        for kind, iteration in catch_up(figures.chosen(rows, time_offset_s=best_offset(rows))).items():
            print(f"fr1/{name} gap {kind[0]:g} {kind[1]}: augmented reaches GICP's last rotation at iteration {iteration}")
    figures.check(lambda name: figures.read_rows(arguments.output / name), HERE / "expected.json")


if __name__ == "__main__":
    main()
