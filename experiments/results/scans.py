# SPDX-License-Identifier: MIT
"""Scans with known motion: LiDAR, room fragments, Stanford bunny."""
from pathlib import Path

import numpy as np

from motions import error, from_axis_angle, from_quaternion, read_rows

STARTS = 10  # disturbed guesses of each pair
OVERLAP_M = 0.001  # bunny: nearer than this under the truth counts as overlapping; points are 0.5 mm apart


def read_matrix(rows):
    return np.array([[float(value) for value in row[:4]] for row in rows])


def lidar(data):
    folder = data / "lidar/small_gicp_pair"
    return folder / "source.ply", folder / "target.ply", read_matrix(read_rows(folder / "T_target_source.txt"))


def car(data):
    """The list's row of car_cloud401 is 16 numbers that map it into car_cloud400."""
    folder = data / "lidar/libpointmatcher_car"
    for line in (folder / "carCloudList.csv").read_text().splitlines():
        words = [word.strip() for word in line.split(",")]
        if words[0].endswith("car_cloud401.csv"):
            truth = np.array([float(word) for word in words if is_number(word)][-16:]).reshape(4, 4)
    return folder / "car_cloud401.csv", folder / "car_cloud400.csv", truth


def is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def redkitchen(data):
    folder = data / "pairs/teaser_3dmatch"
    rows = read_rows(folder / "redkitchen_gt.log")
    start = next(i for i, row in enumerate(rows) if row[:2] == ["0", "4"] and len(row) == 3)
    return folder / "cloud_bin_4.ply", folder / "cloud_bin_0.ply", read_matrix(rows[start + 1:start + 5])


def bunny(data, name):
    """bun.conf: world from scan as translation and the conjugate of the quaternion as written."""
    folder, world_from = data / "bunny", {}
    for row in read_rows(folder / "bun.conf"):
        if row[0] == "bmesh":
            numbers = [float(value) for value in row[2:9]]
            conjugate = np.append(-np.array(numbers[3:6]), numbers[6])
            world_from[row[1]] = from_quaternion(numbers[:3], conjugate)
    target = "bun000.ply"
    return folder / name, folder / target, np.linalg.inv(world_from[target]) @ world_from[name]


def disturbed(truth, centre, angle_deg, distance_m, seed):
    """The truth moved by an angle about a random axis through the source's centre, and a distance another way."""
    generator = np.random.default_rng(seed)
    turn = from_axis_angle(generator.normal(size=3), np.radians(angle_deg))
    direction = generator.normal(size=3)
    turn[:3, 3] = centre - turn[:3, :3] @ centre + distance_m * direction / np.linalg.norm(direction)
    return truth @ turn


def read_ply_points(path):
    """Positions of an ascii PLY whose vertices come first and begin with x y z (the bunny's)."""
    lines = path.read_text().split("\n")
    count = next(int(line.split()[2]) for line in lines if line.startswith("element vertex"))
    start = next(i for i, line in enumerate(lines) if line.strip() == "end_header") + 1
    return np.array([[float(value) for value in line.split()[:3]] for line in lines[start:start + count]])


def nearest_distances(points, others):
    squares = (others**2).sum(axis=1)
    nearest = [np.min(squares - 2 * block @ others.T, axis=1) + (block**2).sum(axis=1)
               for block in np.array_split(points, max(1, len(points) // 500))]
    return np.sqrt(np.maximum(np.concatenate(nearest), 0))


def overlap_rmse(source, target, found, truth):
    """RMS distance to the target of those source points that lie on it under the truth, metres."""
    points, others = read_ply_points(source), read_ply_points(target)
    moved = lambda motion: points @ motion[:3, :3].T + motion[:3, 3]
    overlapping = nearest_distances(moved(truth), others) < OVERLAP_M
    return float(np.sqrt(np.mean(nearest_distances(moved(found)[overlapping], others) ** 2)))


CASES = {  # name: reader, disturbance (deg, m), centre of the turn from the extent of the scene, (limit m, limit deg)
    "lidar pair": (lidar, None),
    "car": (car, (5.0, 0.1)),
    "redkitchen 4 -> 0": (redkitchen, (5.0, 0.1)),
    "bunny 045 -> 000": (lambda data: bunny(data, "bun045.ply"), (10.0, 0.01)),
    "bunny 315 -> 000": (lambda data: bunny(data, "bun315.ply"), (10.0, 0.01)),
}


def table(align, data, progress):
    lines = ["### Scans", "",
             f"Guess: identity for the LiDAR pair, else the truth disturbed {STARTS} times about random axes; worst of "
             "these. Defaults throughout.", "",
             "| pair | guess off by | status | error | RMSE of the overlapping part |", "| --- | --- | --- | --- | --- |"]
    for name, (read, disturbance) in CASES.items():
        source, target, truth = read(Path(data))
        starts = [np.eye(4)]
        if disturbance:
            starts = [disturbed(truth, np.zeros(3), *disturbance, seed) for seed in range(STARTS)]
        results = [align(source, target, initial=start) for start in starts]
        errors = np.array([error(result["T_target_source"], truth) for result in results])
        statuses = " ".join(sorted({result["status"] for result in results}))
        rmse = "-"
        if name.startswith("bunny"):
            worst = results[int(errors[:, 1].argmax())]["T_target_source"]
            rmse = f"{1000 * overlap_rmse(source, target, worst, truth):.3f} mm (truth: " \
                   f"{1000 * overlap_rmse(source, target, truth, truth):.3f} mm)"
        guess = f"{disturbance[0]:g} deg, {1000 * disturbance[1]:g} mm" if disturbance else "{:.2f} m, {:.2f} deg".format(
            *error(np.eye(4), truth))
        lines.append(f"| {name} | {guess} | {statuses} | {1000 * errors[:, 0].max():.1f} mm, {errors[:, 1].max():.3f} deg "
                     f"| {rmse} |")
        progress(name)
    return lines + [""]
