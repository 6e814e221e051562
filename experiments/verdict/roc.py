#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws what other limits of the verdict would accept and refuse, from the CSV of `augicp experiment verdict --roc`.

    roc.py OUTPUT.png LABEL=roc.csv [LABEL=roc.csv ...]
"""
import csv
import sys

import matplotlib

matplotlib.use("agg")
import matplotlib.pyplot as plt  # noqa: E402


def column(rows, name):
    return [float(row[name]) for row in rows]


def main(output, inputs):
    figure, axes = plt.subplots(figsize=(6.0, 4.0))
    for k, argument in enumerate(inputs):
        label, path = argument.split("=", 1)
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        used = min(rows, key=lambda row: abs(float(row["max_strain"]) - 1.0))
        for name, style in (("apart_accepted", "-"), ("wrong_accepted", "--")):
            if max(column(rows, name)) == 0.0:
                continue
            axes.plot(column(rows, "right_refused"), column(rows, name), style, color=f"C{k}",
                      label=f"{label}: {name.split('_')[0]}")
            axes.plot(float(used["right_refused"]), float(used[name]), "o", color=f"C{k}")
    axes.set_xlim(0.0, 0.2)
    axes.set_ylim(0.0, 0.06)
    axes.set_xlabel("share of right results refused")
    axes.set_ylabel("share of others called converged")
    axes.legend(fontsize=8)
    axes.grid(alpha=0.3)
    figure.savefig(output, bbox_inches="tight", dpi=110)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])
