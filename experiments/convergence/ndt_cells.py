#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""NDT with Gaussians in balls around the target's points, or in the cells of a grid: the table of "NDT" in
docs/lab/convergence.md. One loop for all, in NumPy: pairs, kernel at 8 medians, one Gauss-Newton step.

    PYTHONPATH=build/release/python experiments/convergence/ndt_cells.py --data FOLDER [--only NAME]

The pairs and starts are those of approach.py.
"""
import argparse
from pathlib import Path

import numpy as np
import augicp

from approach import after, iterations_to_end, scan_pairs, short
from motions import error

LEAST_VARIANCE = 1e-3  # of the largest, as in surface/gaussians.h
MIN_POINTS, SOURCE_POINTS, ITERATIONS, KERNEL_PER_MEDIAN = 8, 3000, 40, 8.0
RADII_PER_EXTENT, VOXELS_PER_RADIUS, GATES_PER_EXTENT = 30, 4, 4
FACES = np.vstack([np.zeros((1, 3)), np.eye(3), -np.eye(3)]).astype(np.int64)


def extent_of(points):
    return 2 * np.quantile(np.linalg.norm(points - np.median(points, axis=0), axis=1), 0.8)


def keys_of(cells):
    return (cells[:, 0] << 42) + (cells[:, 1] << 21) + cells[:, 2]


def sums_by(groups, values, count):
    return np.stack([np.bincount(groups, column, count) for column in values.T], axis=1)


def evenly(points, most):
    return points[::max(1, -(-len(points) // most))]


def downsampled(points, voxel):
    _, groups = np.unique(keys_of(np.floor((points - points.min(0)) / voxel).astype(np.int64)), return_inverse=True)
    count = groups.max() + 1
    return sums_by(groups, points, count) / np.bincount(groups)[:, None]


def gaussians(count, total, outer):
    """Means and inverse covariances from sums; zero where there are too few points."""
    mean = total / count[:, None]
    values, vectors = np.linalg.eigh(outer / count[:, None, None] - mean[:, :, None] * mean[:, None, :])
    values = np.maximum(values, LEAST_VARIANCE * values[:, 2:])
    good = (count >= MIN_POINTS) & (values[:, 2] > 0)
    inverse = np.divide(1.0, values, out=np.zeros_like(values), where=good[:, None])
    return mean, np.einsum("nik,nk,njk->nij", vectors, inverse, vectors)


def blocks(points, others, size=1000):
    """Squared distances of some points to all others, block by block; in float, about the middle of the others."""
    middle = others.mean(0)
    points, others = ((values - middle).astype(np.float32) for values in (points, others))
    squares = (others**2).sum(1)
    for begin in range(0, len(points), size):
        block = points[begin:begin + size]
        yield begin, squares - 2 * block @ others.T + (block**2).sum(1)[:, None]


class Balls:
    def __init__(self, target, radius):
        self.target = target
        count, total, outer = np.zeros(len(target)), np.zeros((len(target), 3)), np.zeros((len(target), 9))
        outers = np.einsum("ni,nj->nij", target, target).reshape(-1, 9)
        for begin, squares in blocks(target, target):
            near = (squares < radius**2).astype(np.float32)
            rows = slice(begin, begin + len(near))
            count[rows], total[rows], outer[rows] = near.sum(1), near @ target, near @ outers
        self.mean, self.information = gaussians(count, total, outer.reshape(-1, 3, 3))

    def pairs(self, moved, gate):
        """Indices of points and of their Gaussians."""
        found = [(begin + np.arange(len(squares)), squares.argmin(1), squares.min(1))
                 for begin, squares in blocks(moved, self.target)]
        point, nearest, squares = (np.concatenate(parts) for parts in zip(*found))
        return point[squares < gate**2], nearest[squares < gate**2]


class Cells:
    def __init__(self, target, size, neighbours):
        self.size, self.neighbours, self.corner = size, neighbours, target.min(0) - 100 * size
        keys, groups = np.unique(keys_of(self.cells(target)), return_inverse=True)
        count = np.bincount(groups).astype(float)
        outer = sums_by(groups, np.einsum("ni,nj->nij", target, target).reshape(-1, 9), len(keys))
        self.keys = keys
        self.mean, self.information = gaussians(count, sums_by(groups, target, len(keys)), outer.reshape(-1, 3, 3))

    def cells(self, points):
        return np.floor((points - self.corner) / self.size).astype(np.int64)

    def pairs(self, moved, _):
        own, found = self.cells(moved), []
        for offset in FACES[:self.neighbours]:
            keys = keys_of(own + offset)
            place = np.minimum(np.searchsorted(self.keys, keys), len(self.keys) - 1)
            there = (self.keys[place] == keys) & (self.information[place].trace(axis1=1, axis2=2) > 0)
            found.append((np.flatnonzero(there), place[there]))
        return tuple(np.concatenate(parts) for parts in zip(*found))


def step(moved, mean, information):
    """The increment of Eq. (2) with the kernel of Eq. (13): translation, rotation vector, on the left."""
    errors = mean - moved
    weighted = np.einsum("nij,nj->ni", information, errors)
    chi2 = (errors * weighted).sum(1)
    kernel = max(KERNEL_PER_MEDIAN * np.median(chi2), 1e-12)
    gamma = np.minimum(1.0, kernel / np.maximum(chi2, 1e-30))
    jacobian = np.zeros((len(moved), 3, 6))
    jacobian[:, :, :3] = np.eye(3)
    for row, column, axis, sign in ((0, 4, 2, 1), (0, 5, 1, -1), (1, 3, 2, -1), (1, 5, 0, 1), (2, 3, 1, 1), (2, 4, 0, -1)):
        jacobian[:, row, column] = sign * moved[:, axis]  # r x q
    H = np.einsum("nki,n,nkl,nlj->ij", jacobian, gamma, information, jacobian, optimize=True)
    return np.linalg.solve(H + 1e-9 * H.trace() * np.eye(6), np.einsum("nki,n,nk->i", jacobian, gamma, weighted))


def retracted(pose, increment):
    angle = np.linalg.norm(increment[3:])
    axis = increment[3:] / angle if angle > 0 else np.zeros(3)
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    turn = np.eye(4)
    turn[:3, :3] += np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
    turn[:3, 3] = increment[:3]
    return turn @ pose


def path_of(source, model, start, gate):
    path = [start]
    for _ in range(ITERATIONS):
        moved = source @ path[-1][:3, :3].T + path[-1][:3, 3]
        point, of = model.pairs(moved, gate)
        path.append(retracted(path[-1], step(moved[point], model.mean[of], model.information[of])))
    return path


def cell_of(path, truth):
    distances = [error(pose, path[-1])[0] for pose in path]
    mm = ", ".join(short(1000 * after(distances, k)) for k in (1, 2, 3))
    return f"{mm}; {iterations_to_end(distances)}; {short(1000 * error(path[-1], truth)[0])} mm"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--only", default="", help="only pairs whose name contains this")
    arguments = parser.parse_args()
    print("| pair | balls | own cell, 2 radii | own cell, 4 radii | 7 cells, 2 radii |\n| --- | --- | --- | --- | --- |")
    for name, (source, target, start, truth) in scan_pairs(arguments.data).items():
        if arguments.only not in name:
            continue
        clouds = [np.asarray(augicp.read(str(path)).points, float) for path in (source, target)]
        extent = np.sqrt(extent_of(clouds[0]) * extent_of(clouds[1]))
        radius = extent / RADII_PER_EXTENT
        source, target = (downsampled(points, radius / VOXELS_PER_RADIUS) for points in clouds)
        models = (Balls(target, radius), Cells(target, 2 * radius, 1), Cells(target, 4 * radius, 1), Cells(target, 2 * radius, 7))
        source = evenly(source, SOURCE_POINTS)
        cells = [cell_of(path_of(source, model, start, extent / GATES_PER_EXTENT), truth) for model in models]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
