# SPDX-License-Identifier: MIT
"""ATE and RPE computed a second time from their definitions, with 4 x 4 matrices, as a reference for the command."""
import numpy as np


def rotation_of_quaternion(x, y, z, w):
    """The matrix of q v q*, from Hamilton's product; any length."""
    matrix = np.array([[x * x - y * y - z * z + w * w, 2 * (x * y - z * w), 2 * (x * z + y * w)],
                       [2 * (x * y + z * w), y * y - x * x - z * z + w * w, 2 * (y * z - x * w)],
                       [2 * (x * z - y * w), 2 * (y * z + x * w), z * z - x * x - y * y + w * w]])
    return matrix / (x * x + y * y + z * z + w * w)


def angle(rotation):
    """Radians in [0, pi]: its sine and cosine are in the skew part and the trace."""
    skew = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]])
    return np.arctan2(np.linalg.norm(skew), np.trace(rotation) - 1)


def power(rotation, share):
    """The rotation about the same axis by a share of the angle; for angles below pi."""
    turn = angle(rotation)
    if turn < 1e-9:
        return np.eye(3) + share * (rotation - np.eye(3))
    axis = (rotation - rotation.T) / (2 * np.sin(turn))  # as a cross product
    return np.eye(3) + np.sin(share * turn) * axis + (1 - np.cos(share * turn)) * axis @ axis


def read(path):
    """(stamps, poses as matrices)"""
    rows = np.loadtxt(path, ndmin=2)
    poses = np.tile(np.eye(4), (len(rows), 1, 1))
    poses[:, :3, 3] = rows[:, 1:4]
    poses[:, :3, :3] = [rotation_of_quaternion(*row[4:]) for row in rows]
    return rows[:, 0], poses


def closest_pairs(stamps_a, stamps_b, max_difference):
    """[(index in a, index in b)]: of what is free, the closest two, until none is close enough."""
    differences = np.abs(stamps_a[:, None] - stamps_b[None, :])
    pairs, (free_a, free_b) = [], (set(range(len(stamps_a))), set(range(len(stamps_b))))
    for a, b in sorted(np.argwhere(differences <= max_difference), key=lambda pair: differences[tuple(pair)]):
        if a in free_a and b in free_b:
            pairs.append((a, b))
            free_a.remove(a)
            free_b.remove(b)
    return sorted(pairs)


def interpolated(stamps, poses, stamp, max_gap):
    """The pose at a stamp, or None outside and in a gap."""
    for i in range(len(stamps) - 1):
        if stamps[i] == stamp:
            return poses[i]
        if stamps[i] < stamp < stamps[i + 1] and stamps[i + 1] - stamps[i] <= max_gap:
            share = (stamp - stamps[i]) / (stamps[i + 1] - stamps[i])
            pose = np.eye(4)
            pose[:3, 3] = (1 - share) * poses[i, :3, 3] + share * poses[i + 1, :3, 3]
            pose[:3, :3] = poses[i, :3, :3] @ power(poses[i, :3, :3].T @ poses[i + 1, :3, :3], share)
            return pose
    return poses[-1] if stamps[-1] == stamp else None


def match(estimate, truth, options):
    """(stamps, estimated poses, true poses) of the same moments."""
    stamps = estimate[0] + options["time_offset_s"]
    if options["truth"] == "nearest":
        pairs = closest_pairs(stamps, truth[0], options["max_difference_s"])
        first, second = [a for a, _ in pairs], [b for _, b in pairs]
        return stamps[first], estimate[1][first], truth[1][second]
    found = [interpolated(*truth, stamp, 2 * options["max_difference_s"]) for stamp in stamps]
    there = [i for i, pose in enumerate(found) if pose is not None]
    return stamps[there], estimate[1][there], np.array([found[i] for i in there])


def umeyama(source, target, with_scale):
    """(scale, rotation, translation) with the least sum of |target - (scale rotation source + translation)|^2."""
    centred_source, centred_target = source - source.mean(axis=0), target - target.mean(axis=0)
    u, values, vt = np.linalg.svd(centred_target.T @ centred_source)
    signs = np.array([1, 1, np.sign(np.linalg.det(u @ vt))])
    rotation = u @ np.diag(signs) @ vt
    scale = values @ signs / np.sum(centred_source ** 2) if with_scale else 1.0
    return scale, rotation, target.mean(axis=0) - scale * rotation @ source.mean(axis=0)


def align(estimate, truth, how):
    """(scale, motion as a matrix) from the estimate's world to the true one."""
    motion = np.eye(4)
    if how == "origin":
        return 1.0, truth[0] @ np.linalg.inv(estimate[0])
    if how == "none":
        return 1.0, motion
    scale, motion[:3, :3], motion[:3, 3] = umeyama(estimate[:, :3, 3], truth[:, :3, 3], how == "similarity")
    return scale, motion


def scaled(poses, scale):
    return [np.block([[pose[:3, :3], scale * pose[:3, 3:]], [np.zeros(3), 1]]) for pose in poses]


def delta_pairs(stamps, truth, options):
    """[(first, second)] of the poses that RPE compares."""
    delta, unit = options["delta"], options["unit"]
    steps = {"frames": np.ones(len(stamps) - 1), "seconds": np.diff(stamps),
             "metres": np.linalg.norm(np.diff(truth[:, :3, 3], axis=0), axis=1)}[unit]
    distance = np.concatenate([[0], np.cumsum(steps)]) if unit != "seconds" else stamps
    if options["consecutive"]:
        chosen = [0]
        for i in range(len(stamps)):
            if distance[i] - distance[chosen[-1]] >= delta:
                chosen.append(i)
        return list(zip(chosen, chosen[1:]))
    pairs, tolerance = [], 0 if unit == "frames" else 0.1 * delta
    for i in range(len(stamps) - 1):
        off = np.abs(distance[i + 1:] - distance[i] - delta)
        if off.min() <= tolerance:
            pairs.append((i, i + 1 + int(np.argmin(off))))
    return pairs


def statistics(errors):
    errors = np.array(errors)
    return {"rmse": np.sqrt(np.mean(errors ** 2)), "mean": errors.mean(), "median": np.median(errors), "std": np.std(errors),
            "min": errors.min(), "max": errors.max(), "sse": np.sum(errors ** 2), "count": len(errors)}


def pose_statistics(errors):
    """Errors from 4 x 4 matrices that would be the identity without an error."""
    if not errors:
        return None
    return {"translation": statistics([np.linalg.norm(error[:3, 3]) for error in errors]),
            "rotation_deg": statistics([np.degrees(angle(error[:3, :3])) for error in errors])}


def evaluate(estimate_path, truth_path, options):
    """The expected output of the command for the two files, with the options that it reports."""
    stamps, estimate, truth = match(read(estimate_path), read(truth_path), options)
    scale, motion = align(estimate, truth, options["align"])
    absolute = lambda poses: pose_statistics([np.linalg.inv(b) @ a for a, b in zip(poses, truth)])
    at_scale, inverse = scaled(estimate, scale), np.linalg.inv
    steps = [(inverse(truth[i]) @ truth[j], inverse(at_scale[i]) @ at_scale[j])
             for i, j in delta_pairs(stamps, truth, options)]
    return {"num_matched": len(stamps), "first_stamp_s": stamps[0], "last_stamp_s": stamps[-1],
            "ate": absolute(estimate),
            "alignment": {"T_truth_estimate": motion.tolist(), "scale": scale},
            "ate_aligned": absolute([motion @ pose for pose in at_scale]) if options["align"] != "none" else None,
            "rpe": pose_statistics([inverse(true_step) @ step for true_step, step in steps])}


def kitti_segments(estimate, truth, lengths, step=10):
    """KITTI's metric of poses that correspond one to one: (number of segments, mean error / length, mean radians / length)."""
    path = np.concatenate([[0.0], np.cumsum([np.linalg.norm(b[:3, 3] - a[:3, 3]) for a, b in zip(truth, truth[1:])])])
    translations, rotations = [], []
    for length in lengths:
        for first in range(0, len(truth), step):
            beyond = np.flatnonzero(path > path[first] + length)
            if not len(beyond):
                break
            error = np.linalg.inv(np.linalg.inv(estimate[first]) @ estimate[beyond[0]]) @ np.linalg.inv(truth[first]) @ truth[beyond[0]]
            translations.append(np.linalg.norm(error[:3, 3]) / length)
            rotations.append(angle(error[:3, :3]) / length)
    return len(translations), np.mean(translations), np.mean(rotations)
