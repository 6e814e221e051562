# SPDX-License-Identifier: MIT
"""Frame after frame: the motions a peer finds between neighbouring images, and the trajectory they add up to."""
import numpy as np

from cells import Cell
from motions import error, quaternion
from pairs import grouped, run_cell, write_results
from tum_windows import LAG_S

OFFSETS_S = (LAG_S, 0.0)  # both ways of reading the truth
GUESSES = {"identity": np.eye(4), "previous motion": None}


def chain(motions):
    """Poses from those between neighbours, the first the identity. None, where a peer failed: it did not move."""
    poses = [np.eye(4)]
    for motion in motions:
        poses.append(poses[-1] @ (np.eye(4) if motion is None else motion))
    return poses


def rms(values):
    return float(np.sqrt(np.mean(np.square(values))))


def relative_error(poses, truth):
    """RMS over neighbouring frames, metres and degrees."""
    step = lambda path, k: np.linalg.inv(path[k]) @ path[k + 1]
    errors = np.array([error(step(poses, k), step(truth, k)) for k in range(len(poses) - 1)])
    return rms(errors[:, 0]), rms(errors[:, 1])


def absolute_error(poses, truth):
    """RMS distance of positions in metres, after the rigid motion that makes it least (Umeyama, without scale)."""
    found, true = (np.array([pose[:3, 3] for pose in path]) for path in (poses, truth))
    found, true = found - found.mean(axis=0), true - true.mean(axis=0)
    u, _, vt = np.linalg.svd(true.T @ found)
    rotation = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    return rms(np.linalg.norm(true - found @ rotation.T, axis=1))


def write_trajectory(path, stamps, poses):
    lines = [f"{stamp:.6f} " + " ".join(f"{value:.9f}" for value in (*pose[:3, 3], *quaternion(pose)))
             for stamp, pose in zip(stamps, poses)]
    path.write_text("# timestamp tx ty tz qx qy qz qw, world: the first camera\n" + "\n".join(lines) + "\n")


def summary(window, rows):
    """One method on one window: the numbers of a line of the table, and the poses."""
    poses = chain([row["pose"] for row in rows])
    errors = []
    for offset_s in OFFSETS_S:
        truth = [window.world_from_camera(k, offset_s) for k in range(len(poses))]
        errors.append((*relative_error(poses, truth), absolute_error(poses, truth)))
    return {"errors": errors, "failed": sum(row["pose"] is None for row in rows)}, poses


HEADER = ["| window | guess | peer | RPE, truth 22 ms earlier | ATE | RPE, truth at the stamp | ATE | failed |",
          "| --- | --- | --- | --- | --- | --- | --- | --- |"]


def line(window, guess, name, numbers):
    cells = [cell for metres, degrees, ate_m in numbers["errors"]
             for cell in (f"{1000 * metres:.2f} mm, {degrees:.3f} deg", f"{1000 * ate_m:.1f} mm")]
    failed = f"{numbers['failed']} of {len(window.frames) - 1}"
    return f"| {' | '.join([window.name, guess, name, *cells, failed])} |"


def measure(programs, windows, output, progress):
    """Lines of a Markdown table; trajectories and a CSV of the results go to the output folder."""
    lines, results = list(HEADER), []
    for window in windows:
        for guess_name, guess in GUESSES.items():
            cell = Cell(f"{window.name} {guess_name}", [window.job(k, k + 1, guess) for k in range(len(window.frames) - 1)])
            for program in programs:
                rows = run_cell(cell, program)
                results += rows
                for (peer, method), of_method in grouped(rows, "peer", "method").items():
                    numbers, poses = summary(window, of_method)
                    lines.append(line(window, guess_name, f"{peer} {method}", numbers))
                    file = f"{window.name}_{peer}_{method}_{guess_name}.txt".replace(" ", "_")
                    write_trajectory(output / file, [stamp for stamp, _ in window.frames], poses)
                progress(f"{cell.name}: {program.name}")
    write_results(output / "odometry.csv", results)
    return lines
