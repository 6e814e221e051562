# SPDX-License-Identifier: MIT
"""Pairs of scans from disturbed starts: from how far away each peer still finds the truth, as CSV and as Markdown."""
import csv
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from cells import Cell
from jobs import Job
from pairs import grouped, run_cell, successes, write_results
from ply import positions, read_vertices
from scans import bunny, car, disturbed, read_ply_points, redkitchen

ANGLES_DEG = (10, 20, 30, 45, 60, 90)


@dataclass
class Scene:
    name: str
    source: Path
    target: Path
    truth: np.ndarray  # T_target_source
    target_points: np.ndarray
    limit: tuple  # metres and degrees below which a start counts as a success


def redkitchen_scene(data):
    source, target, truth = redkitchen(data)
    return Scene("redkitchen", source, target, truth, positions(read_vertices(target)), (0.1, 3.0))


def car_scene(data):
    source, target, truth = car(data)
    points = np.loadtxt(target, delimiter=",", skiprows=1, usecols=(0, 1, 2))
    return Scene("car", source, target, truth, points, (0.2, 2.0))


def bunny_scene(data):
    source, target, truth = bunny(data, "bun045.ply")
    return Scene("bunny", source, target, truth, read_ply_points(target), (0.002, 2.0))


SCENES = {"redkitchen": redkitchen_scene, "car": car_scene, "bunny": bunny_scene}


def half_extent_m(points):
    """The median distance from the centroid: a few far points of a LiDAR scan do not make it large."""
    return float(np.median(np.linalg.norm(points - points.mean(axis=0), axis=1)))


def start(scene, angle_deg, seed):
    """The truth turned about a random axis through the target's centroid and moved by up to half the target's extent."""
    distance_m = np.random.default_rng((seed, angle_deg)).uniform(0, half_extent_m(scene.target_points))
    source_from_target = np.linalg.inv(scene.truth)
    centre = source_from_target[:3, :3] @ scene.target_points.mean(axis=0) + source_from_target[:3, 3]
    guess = disturbed(scene.truth, centre, angle_deg, distance_m, seed)
    return Job(str(seed), scene.source, scene.target, scene.truth, guess, scene.name)


def cells_of(scene, num_starts):
    return [Cell(f"{angle_deg} deg", [start(scene, angle_deg, seed) for seed in range(num_starts)])
            for angle_deg in ANGLES_DEG]


def counted(scene, rows):
    """{(peer, method): successes of each cell}"""
    return {peer_method: [successes(of_cell, *scene.limit) for of_cell in grouped(group, "cell").values()]
            for peer_method, group in grouped(rows, "peer", "method").items()}


def table(scene, counts, num_starts):
    limit_m, limit_deg = scene.limit
    lines = [f"{scene.name}, within {100 * limit_m:g} cm and {limit_deg:g} deg, of {num_starts} in each cell; moved by up to "
             f"{half_extent_m(scene.target_points):.2g} m:", "",
             "| peer | " + " | ".join(f"{angle} deg" for angle in ANGLES_DEG) + " | area |",
             "| --- |" + " --- |" * (len(ANGLES_DEG) + 1)]
    for (peer, method), of_cell in counts.items():
        cells = [*map(str, of_cell), f"{np.mean(of_cell) / num_starts:.2f}"]
        lines.append(f"| {peer} {method} | {' | '.join(cells)} |")
    return lines + [""]


def write_successes(path, counts_of_scene, num_starts):
    """A line for each scene, method and angle, and one with the mean share, the area under the success surface."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("scene", "peer", "method", "angle_deg", "successes", "starts"))
        for scene, counts in counts_of_scene.items():
            for (peer, method), of_cell in counts.items():
                writer.writerows((scene, peer, method, angle, count, num_starts) for angle, count in zip(ANGLES_DEG, of_cell))
                writer.writerow((scene, peer, method, "all", sum(of_cell), num_starts * len(of_cell)))


def measure(programs, scenes, num_starts, output, progress):
    """Markdown lines; every result goes to scans.csv, the successes to scans_successes.csv."""
    lines, results, counts_of_scene = [], [], {}
    for scene in scenes:
        rows = []
        for program in programs:
            for cell in cells_of(scene, num_starts):
                rows += run_cell(cell, program)
            progress(f"{scene.name}: {program.name}")
        counts_of_scene[scene.name] = counted(scene, rows)
        lines += table(scene, counts_of_scene[scene.name], num_starts)
        results += [row | {"cell": f"{scene.name} {row['cell']}"} for row in rows]
    write_results(output / "scans.csv", results)
    write_successes(output / "scans_successes.csv", counts_of_scene, num_starts)
    return lines
