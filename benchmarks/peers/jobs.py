# SPDX-License-Identifier: MIT
"""The work that all peers get, as files: jobs go out, results come back."""
import csv
import os
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments/results"))  # motions, scans, ply: read truth here as for docs/lab/results.md
from motions import from_quaternion, quaternion

JOB_FIELDS = ("pair", "source", "target", "scene", "camera", "depth_scale", "guess")
POSE_FIELDS = ("tx", "ty", "tz", "qx", "qy", "qz", "qw")


@dataclass
class Job:
    pair: str  # unique within a file of jobs
    source: Path
    target: Path
    truth: np.ndarray  # T_target_source; stays here
    guess: np.ndarray | None  # T_target_source; None: what the peer found for the job before
    scene: str  # by its name each peer finds its settings
    camera: str = "-"  # clouds have none
    depth_scale: float = 0.0


def motion_words(motion):
    return " ".join(f"{value:.17g}" for value in (*motion[:3, 3], *quaternion(motion)))


def guess_words(job):
    return "previous" if job.guess is None else motion_words(job.guess)


def job_row(job):
    return job.pair, job.source, job.target, job.scene, job.camera, job.depth_scale, guess_words(job)


def write_jobs(path, jobs):
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerows([JOB_FIELDS, *map(job_row, jobs)])


def read_results(path):
    """A dictionary a line; "pose" is T_target_source, or None where the peer gave none."""
    with open(path, newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        numbers = [row[field] for field in POSE_FIELDS]
        row["pose"] = from_quaternion(*np.split(np.array(numbers, float), [3])) if all(numbers) else None
    return rows


def run_program(program, jobs, methods=()):
    """The results of a peer's program, which keeps to one thread: in the order of the jobs, methods within."""
    if not program.exists():
        raise FileNotFoundError(f"{program}: configure with -DAUGICP_BUILD_PEERS=ON and build it")
    with tempfile.TemporaryDirectory() as folder:
        jobs_file, results_file = Path(folder) / "jobs.csv", Path(folder) / "results.csv"
        write_jobs(jobs_file, jobs)
        subprocess.run([program, jobs_file, results_file, *methods], check=True, env=os.environ | {"OMP_NUM_THREADS": "1"})
        return read_results(results_file)
