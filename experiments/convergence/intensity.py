#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""The effect of brightness beside positions and directions: the tables of "Intensity" in docs/lab/convergence.md.

    experiments/convergence/intensity.py --data FOLDER [--starts 20] [--only images|lidar]

FOLDER holds tum/fr1_desk_a, whose first images have colour, and lidar/small_gicp_pair.
"""
import argparse
import bisect
import csv
import json
import math
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

CLOCK_OFFSET_S = -0.022  # of the depth images on fr1, see docs/lab/results.md
GAPS = (1, 10)
CHANNELS = {"without": (), "with": ("--intensity",)}
LOOPS = {"default": (), "iterations alone": ("--no-search", "--no-coarse-to-fine", "--no-rolling-shutter")}
IDENTITY = "0 0 0 0 0 0 1"


def stamped(path):
    """[(stamp, words)] of a list of the TUM benchmark."""
    rows = [line.split() for line in path.read_text().splitlines() if line and line[0] != "#"]
    return [(float(row[0]), row[1:]) for row in rows]


def product(a, b):
    """Of two quaternions x y z w."""
    (x, y, z, w), (i, j, k, r) = a, b
    return (w * i + x * r + y * k - z * j, w * j - x * k + y * r + z * i,
            w * k + x * j - y * i + z * r, w * r - x * i - y * j - z * k)


def turned(q, v):
    x, y, z, _ = product(product(q, (*v, 0.0)), (-q[0], -q[1], -q[2], q[3]))
    return (x, y, z)


def pose_at(poses, stamp):
    """Translation and quaternion, between the two nearest poses of the truth; they are 10 ms apart."""
    k = min(max(bisect.bisect([pose[0] for pose in poses], stamp), 1), len(poses) - 1)
    (t0, p), (t1, q) = ((stamp_k, [float(word) for word in words]) for stamp_k, words in poses[k - 1:k + 1])
    share = (stamp - t0) / (t1 - t0)
    sign = 1.0 if sum(a * b for a, b in zip(p[3:], q[3:])) >= 0.0 else -1.0
    mixed = [a + share * (b - a) for a, b in zip(p[:3], q[:3])]
    rotation = [a + share * (sign * b - a) for a, b in zip(p[3:], q[3:])]
    norm = math.hypot(*rotation)
    return tuple(mixed), tuple(a / norm for a in rotation)


def relative(target, source):
    """target_from_source of two poses in the world."""
    (a, p), (b, q) = target, source
    back = (-p[0], -p[1], -p[2], p[3])
    return turned(back, [v - u for u, v in zip(a, b)]), product(back, q)


def rotation_matrix(q):
    return [[turned(q, axis)[row] for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))] for row in range(3)]


def errors(found, translation, rotation):
    """Metres and degrees between a 4 x 4 matrix and a translation and a rotation matrix."""
    apart = math.hypot(*(found[i][3] - translation[i] for i in range(3)))
    trace = sum(found[i][j] * rotation[i][j] for i in range(3) for j in range(3))
    sine = math.sqrt(sum((found[i][j] - rotation[i][j]) ** 2 for i in range(3) for j in range(3)) / 8.0)
    return apart, math.degrees(2.0 * math.asin(min(1.0, sine)) if trace > 0.0 else math.acos(max(-1.0, (trace - 1.0) / 2.0)))


def align(augicp, *words):
    finished = subprocess.run([str(word) for word in (augicp, "align", *words, "--json", "-", "--threads", 1)],
                              capture_output=True, text=True, check=False)
    if finished.returncode not in (0, 4, 5):
        sys.exit(finished.stderr)
    return json.loads(finished.stdout)


def images_with_colour(folder):
    """[(stamp, depth image, colour image)], each with the colour nearest in time, where that is within 20 ms."""
    colours = [(stamp, folder / words[0]) for stamp, words in stamped(folder / "rgb.txt") if (folder / words[0]).exists()]
    found = []
    for stamp, words in stamped(folder / "depth.txt"):
        nearest = min(colours, key=lambda colour: abs(colour[0] - stamp))
        if abs(nearest[0] - stamp) <= 0.02:
            found.append((stamp, folder / words[0], nearest[1]))
    return found


def image_rows(augicp, folder):
    images, truth = images_with_colour(folder), stamped(folder / "groundtruth.txt")
    print(f"{len(images)} images with colour\n\n| gap | loop | intensity | within 5 cm, 2 deg | 2 cm, 1 deg | median error | ms |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for gap in GAPS:
        for loop, loop_words in LOOPS.items():
            for channel, words in CHANNELS.items():
                found, times = [], []
                for target, source in zip(images, images[gap:]):
                    result = align(augicp, source[1], target[1], "--camera", "tum-fr1", "--source-image", source[2],
                                   "--target-image", target[2], *loop_words, *words)
                    true = relative(*(pose_at(truth, image[0] + CLOCK_OFFSET_S) for image in (target, source)))
                    found.append(errors(result["T_target_source"], true[0], rotation_matrix(true[1])))
                    times.append(result["timing_ms"]["surface"] + result["timing_ms"]["align"])
                within = [sum(t < m and r < d for t, r in found) for m, d in ((0.05, 2.0), (0.02, 1.0))]
                print("| {} | {} | {} | {} of {} | {} | {:.1f} mm, {:.2f} deg | {:.0f} |".format(
                    gap, loop, channel, within[0], len(found), within[1], 1000 * statistics.median(t for t, _ in found),
                    statistics.median(r for _, r in found), statistics.median(times)), flush=True)


def lidar_rows(augicp, folder, num_starts):
    source, target, truth = folder / "source.ply", folder / "target.ply", folder / "T_target_source.txt"
    rows = [[float(word) for word in line.split()] for line in truth.read_text().splitlines() if line[0] != "#"]
    print("\n| intensity | from the identity | from the truth | successes, rotated by 5, 10, 20, 30, 45, 60 deg |\n| --- | --- | --- | --- |")
    for channel, words in CHANNELS.items():
        cells = []
        for guess in (IDENTITY, truth):
            result = align(augicp, source, target, "--initial", guess, "--no-search", *words)
            apart, angle = errors(result["T_target_source"], [row[3] for row in rows], rows)
            cells.append(f"{1000 * apart:.1f} mm, {angle:.3f} deg, {result['status']}")
        with tempfile.NamedTemporaryFile(suffix=".csv") as output:
            arguments = ("experiment", "basin", source, target, "--truth", truth, "--no-search", "--distances", "0.5,1,2",
                         "--starts", num_starts, "--limit", 0.05, "--limit-deg", 2, "--threads", 1, "--output", output.name)
            subprocess.run([str(word) for word in (augicp, *arguments, *words)], check=True)
            basin = list(csv.DictReader(line for line in Path(output.name).read_text().splitlines() if line[0] != "#"))
        angle_name = next(name for name in basin[0] if name.startswith("angle"))
        angles = sorted({float(row[angle_name]) for row in basin})
        counts = [round(sum(float(row["success"]) * num_starts for row in basin if float(row[angle_name]) == angle)) for angle in angles]
        print(f"| {channel} | {cells[0]} | {cells[1]} | {', '.join(map(str, counts))} of {3 * num_starts} |", flush=True)


def main():
    root = Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--augicp", type=Path, default=root / "build/release/apps/augicp/augicp")
    parser.add_argument("--starts", type=int, default=20)
    parser.add_argument("--only", choices=("images", "lidar"))
    arguments = parser.parse_args()
    if arguments.only != "lidar":
        image_rows(arguments.augicp, arguments.data / "tum/fr1_desk_a")
    if arguments.only != "images":
        lidar_rows(arguments.augicp, arguments.data / "lidar/small_gicp_pair", arguments.starts)


if __name__ == "__main__":
    main()
