#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Registration without a guess by Open3D (FPFH with RANSAC, and FGR) and KISS-Matcher, on the pairs of `augicp experiment global`.

usage: without_guess.py LIST... [--rotations N] [--seed N]      needs open3d (PyPI); kiss_matcher too if it is there

LIST has lines "family source target truth", as `augicp experiment global --pairs`. Each source is moved by a uniformly random
rotation and a translation first. A pose is found within 30 cm and 15 degrees. One row per family and method: pairs, found,
fine (5 cm and 3 degrees), and the median processor time in milliseconds, downsampling and normals included.

Settings, as recommended: the voxel v is a sixtieth of the target's extent, as augicp's own; normals within 2 v (30 points), FPFH
within 5 v (100 points); RANSAC with mutual pairs, 3 points, 100 000 iterations, confidence 0.999, edges alike to 0.9,
inliers within 1.5 v; FGR within v / 2. KISS-Matcher has its defaults for the voxel v.
"""
import argparse
import pathlib
import statistics
import time

import numpy as np
import open3d as o3d

REGISTRATION = o3d.pipelines.registration


def extent(points):
    """Twice the 80th percentile of the distances from the median point, as augicp's lengths."""
    return 2.0 * np.quantile(np.linalg.norm(points - np.median(points, axis=0), axis=1), 0.8)


def random_motion(generator, reach):
    q = generator.normal(size=4)
    x, y, z, w = q / np.linalg.norm(q)
    motion = np.eye(4)
    motion[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    direction = generator.normal(size=3)
    motion[:3, 3] = generator.uniform(0, reach) * direction / np.linalg.norm(direction)
    return motion


def described(points, v):
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points)).voxel_down_sample(v)
    cloud.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(2 * v, 30))
    return cloud, REGISTRATION.compute_fpfh_feature(cloud, o3d.geometry.KDTreeSearchParamHybrid(5 * v, 100))


def by_ransac(source, target, v):
    (a, fa), (b, fb) = described(source, v), described(target, v)
    checks = [REGISTRATION.CorrespondenceCheckerBasedOnEdgeLength(0.9),
              REGISTRATION.CorrespondenceCheckerBasedOnDistance(1.5 * v)]
    return REGISTRATION.registration_ransac_based_on_feature_matching(
        a, b, fa, fb, True, 1.5 * v, REGISTRATION.TransformationEstimationPointToPoint(False), 3, checks,
        REGISTRATION.RANSACConvergenceCriteria(100000, 0.999)).transformation


def by_fgr(source, target, v):
    (a, fa), (b, fb) = described(source, v), described(target, v)
    option = REGISTRATION.FastGlobalRegistrationOption(maximum_correspondence_distance=0.5 * v)
    return REGISTRATION.registration_fgr_based_on_feature_matching(a, b, fa, fb, option).transformation


def by_kiss_matcher(source, target, v):
    import kiss_matcher
    # It refuses voxels of a few millimetres: lengths are in voxels.
    matcher = kiss_matcher.KISSMatcher(kiss_matcher.KISSMatcherConfig(1.0))
    result = matcher.estimate((source / v).astype(np.float32), (target / v).astype(np.float32))
    pose = np.eye(4)
    pose[:3, :3], pose[:3, 3] = np.asarray(result.rotation), v * np.asarray(result.translation).ravel()
    return pose


def methods():
    known = {"open3d ransac": by_ransac, "open3d fgr": by_fgr}
    try:
        import kiss_matcher  # noqa: F401
        known["kiss-matcher"] = by_kiss_matcher
    except ImportError:
        pass
    return known


def read_points(path):
    if path.suffix == ".npy":
        return np.load(path).astype(np.float64)
    return np.asarray(o3d.io.read_point_cloud(str(path)).points)


def pairs_of(path):
    for line in path.read_text().splitlines():
        words = line.split()
        if words and not words[0].startswith("#") and words[3] != "-":
            yield words[0], *(path.parent / word for word in words[1:4])


def errors(found, truth):
    turn = np.clip((np.trace(found[:3, :3].T @ truth[:3, :3]) - 1) / 2, -1, 1)
    return np.linalg.norm(found[:3, 3] - truth[:3, 3]), np.degrees(np.arccos(turn))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lists", nargs="+", type=pathlib.Path)
    parser.add_argument("--rotations", type=int, default=1)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    generator = np.random.default_rng(arguments.seed)
    rows = {}
    for family, source_path, target_path, truth_path in (pair for path in arguments.lists for pair in pairs_of(path)):
        source, target, truth = read_points(source_path), read_points(target_path), np.loadtxt(truth_path)
        for _ in range(arguments.rotations):
            motion = random_motion(generator, extent(target))
            moved = source @ motion[:3, :3].T + motion[:3, 3]
            v = np.sqrt(extent(moved) * extent(target)) / 60.0
            for name, method in methods().items():
                o3d.utility.random.seed(arguments.seed)
                begin = time.process_time()
                found = method(moved, target, v) @ motion
                rows.setdefault((family, name), []).append((*errors(found, truth), 1000 * (time.process_time() - begin)))
    print(f"{'family':<20}{'method':<16}{'pairs':>6}{'found':>7}{'fine':>6}{'ms':>9}")
    for (family, name), results in rows.items():
        found = sum(distance < 0.3 and angle < 15 for distance, angle, _ in results)
        fine = sum(distance < 0.05 and angle < 3 for distance, angle, _ in results)
        ms = statistics.median(ms for _, _, ms in results)
        print(f"{family:<20}{name:<16}{len(results):>6}{found:>7}{fine:>6}{ms:>9.0f}")


if __name__ == "__main__":
    main()
