#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Draws what `augicp surface` found in depth images: planar blue (shaded by the normal), edge orange, none grey.

    experiments/results/structure_picture.py --output FILE.png IMAGE.png [IMAGE.png ...]    (camera tum-fr1)
"""
import argparse
import subprocess
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from ply import read_vertices

WIDTH, HEIGHT = 640, 480
FX, FY, CX, CY = 517.3, 516.5, 318.6, 255.3  # tum-fr1
PLANAR = 1


def structure_image(augicp, image, folder):
    output = Path(folder) / "extended.ply"
    subprocess.run([str(augicp), "surface", str(image), "--camera", "tum-fr1", "--output", str(output), "--quiet"], check=True)
    points = read_vertices(output)
    u = np.rint(FX * points["x"] / points["z"] + CX).astype(int).clip(0, WIDTH - 1)
    v = np.rint(FY * points["y"] / points["z"] + CY).astype(int).clip(0, HEIGHT - 1)
    shade = np.where(points["structure"] == PLANAR, 0.35 + 0.65 * np.abs(points["nz"]), 1.0)
    picture = np.zeros((HEIGHT, WIDTH, 3))
    picture[v, u] = np.stack([points[colour] for colour in ("red", "green", "blue")], axis=1) / 255 * shade[:, None]
    return picture


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", type=Path, nargs="+")
    parser.add_argument("--augicp", type=Path, default=root / "build/release/apps/augicp/augicp")
    parser.add_argument("--output", type=Path, required=True)
    arguments = parser.parse_args()
    figure, axes = plt.subplots(1, len(arguments.images), figsize=(6 * len(arguments.images), 5), squeeze=False)
    with tempfile.TemporaryDirectory() as folder:
        for axis, image in zip(axes[0], arguments.images):
            axis.imshow(structure_image(arguments.augicp, image, folder))
            axis.set_title(image.stem)
            axis.axis("off")
    figure.tight_layout()
    figure.savefig(arguments.output, dpi=60)


if __name__ == "__main__":
    main()
