# SPDX-License-Identifier: MIT
"""Shared by the figures: CSV of `augicp experiment`, the look of curves, expected numbers."""
import csv
import json
import subprocess
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
matplotlib.rcParams["svg.hashsalt"] = "augicp"  # the same picture is the same file
import matplotlib.pyplot as plt

ROOT = Path(__file__).resolve().parents[1]
AUGICP = ROOT / "build/release/apps/augicp/augicp"
STYLES = {"point": ("#999999", ":"), "plane": ("#009e73", "-."), "ndt": ("#cc79a7", (0, (3, 1, 1, 1))),
          "gicp": ("#0072b2", "--"), "augmented": ("#d55e00", "-")}


def augicp(*words):
    subprocess.run([str(AUGICP), "experiment", *map(str, words)], check=True)


def read_rows(path):
    """Numbers as numbers, words as words."""
    with open(path, newline="") as file:
        return [{key: number(value) for key, value in row.items()} for row in csv.DictReader(file)]


def number(text):
    try:
        return float(text)
    except ValueError:
        return text


def chosen(rows, **where):
    return [row for row in rows if all(row[key] == value for key, value in where.items())]


def draw_curves(axis, rows, column, scale=1.0):
    """The column over the iterations, a line a method."""
    for method, (colour, line) in STYLES.items():
        curve = chosen(rows, method=method)
        if curve:
            axis.plot([row["iteration"] for row in curve], [scale * row[column] for row in curve], linestyle=line,
                      color=colour, label=method, linewidth=1.5)
    axis.grid(alpha=0.3)


def save(figure, stem):
    figure.tight_layout()
    figure.savefig(f"{stem}.png", dpi=60)
    figure.savefig(f"{stem}.svg", metadata={"Date": None})
    plt.close(figure)


def check(rows_of, path):
    """Compares CSVs with a list of {"file", "where", "column", "value", "tolerance"}; exits with 1 where one is off."""
    num_off = 0
    for item in json.loads(Path(path).read_text()):
        found = chosen(rows_of(item["file"]), **item["where"])
        is_off = len(found) != 1 or not abs(found[0][item["column"]] - item["value"]) <= item["tolerance"]
        num_off += is_off
        if is_off:
            print(f"expected {item}, found {[row[item['column']] for row in found]}", file=sys.stderr)
    sys.exit(1 if num_off else 0)
