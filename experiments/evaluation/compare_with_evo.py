#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Compares `augicp evaluate` with evo (https://github.com/MichaelGrupp/evo, `pip install evo`) on disturbed true trajectories.

    compare_with_evo.py AUGICP GROUNDTRUTH...    prints the largest differences; exit code 1 above 1e-12 m or degrees
"""
import itertools
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from evo.core.metrics import APE, RPE, PoseRelation, Unit
from evo.core.sync import associate_trajectories
from evo.core.trajectory import PoseTrajectory3D

LIMIT = 1e-12
NAMES = ("rmse", "mean", "median", "std", "min", "max")
RELATIONS = {"translation": PoseRelation.translation_part, "rotation_deg": PoseRelation.rotation_angle_deg}
UNITS = {"frames": Unit.frames, "metres": Unit.meters}
DELTAS = (("frames", 1, False), ("frames", 10, False), ("frames", 10, True), ("metres", 0.3, False))


def trajectory(rows):
    return PoseTrajectory3D(rows[:, 1:4], np.roll(rows[:, 4:], 1, axis=1), rows[:, 0])


def disturbed(truth):
    """Every third pose, 2 ms late, with slow errors of some centimetres and degrees."""
    rows = truth[::3].copy()
    time = rows[:, 0] - rows[0, 0]
    rows[:, 0] += 0.002
    rows[:, 1:4] = 0.98 * rows[:, 1:4] + 0.03 * np.sin(np.outer(time, (1.0, 1.7, 2.3)))
    rows[:, 4:] += 0.03 * np.sin(np.outer(time, (0.9, 1.3, 1.9, 0.5)))
    rows[:, 4:] /= np.linalg.norm(rows[:, 4:], axis=1)[:, None]
    return rows


def largest(found, metric, data):
    """The largest difference between our numbers and evo's."""
    metric.process_data(data)
    expected = metric.get_all_statistics()
    return max(abs(found[name] - expected[name]) for name in NAMES)


def differences(augicp, estimate_path, rows, truth):
    """(name, largest difference) for each kind of error."""
    for align, (unit, delta, consecutive) in itertools.product(("none", "rigid", "similarity"), DELTAS):
        reference, estimate = associate_trajectories(trajectory(truth), trajectory(rows), max_diff=0.02)
        if align != "none":
            estimate.align(reference, correct_scale=align == "similarity")
        words = [augicp, "evaluate", *estimate_path, "--align", align, "--unit", unit, "--delta", str(delta), "--json", "-"]
        found = json.loads(subprocess.run(words + ["--consecutive"] * consecutive, capture_output=True, check=True).stdout)
        assert found["num_matched"] == estimate.num_poses
        for part, relation in RELATIONS.items():
            ate = found["ate" if align == "none" else "ate_aligned"][part]
            yield f"ATE {part}", largest(ate, APE(relation), (reference, estimate))
            rpe = RPE(relation, delta, UNITS[unit], 0.1, all_pairs=not consecutive, pairs_from_reference=True)
            yield f"RPE {part}", largest(found["rpe"][part], rpe, (reference, estimate))


def main():
    worst = {}
    with tempfile.TemporaryDirectory() as folder:
        for truth_path in sys.argv[2:]:
            truth = np.loadtxt(truth_path)
            rows = disturbed(truth)
            estimate_path = Path(folder) / "estimate.txt"
            np.savetxt(estimate_path, rows, fmt="%.17g")
            for name, value in differences(sys.argv[1], (estimate_path, truth_path), rows, truth):
                worst[name] = max(worst.get(name, 0.0), value)
    for name, value in worst.items():
        print(f"{name}: {value:.1e}")
    return 0 if worst and max(worst.values()) <= LIMIT else 1


if __name__ == "__main__":
    sys.exit(main())
