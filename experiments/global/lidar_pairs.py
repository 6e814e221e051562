#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Lists of LiDAR pairs for `augicp experiment global --pairs`.

Each sequence is a folder with velodyne/*.bin and reference_pairs.txt, whose lines are: i j tx ty tz qx qy qz qw ...,
the pose of scan j in the frame of scan i (metres; scans in the order of their names).

    lidar_pairs.py OUT SEQUENCE...    writes OUT/near.txt, with the reference poses, and OUT/apart.txt, with scans of
                                      different sequences, which share nothing
"""
import itertools
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "results"))
from motions import from_quaternion  # noqa: E402

SCANS_APART = 5  # of each sequence


def scans_of(sequence):
    return sorted((sequence / "velodyne").glob("*.bin"))


def near_lines(sequence, out):
    scans = scans_of(sequence)
    for row in np.loadtxt(sequence / "reference_pairs.txt", ndmin=2):
        i, j = int(row[0]), int(row[1])
        truth = out / f"{sequence.name}_{i}_{j}.txt"
        np.savetxt(truth, from_quaternion(row[2:5], row[5:9]))
        place = "below10" if np.linalg.norm(row[2:5]) < 10.0 else "above10"
        yield f"{sequence.name}_{place} {scans[j]} {scans[i]} {truth}"


def apart_lines(sequences):
    def some(sequence):
        scans = scans_of(sequence)
        return scans[::max(1, len(scans) // SCANS_APART)][:SCANS_APART]

    for one, other in itertools.combinations(sequences, 2):
        for source, target in itertools.product(some(one), some(other)):
            yield f"apart {source} {target} -"


def main():
    out, sequences = pathlib.Path(sys.argv[1]).resolve(), [pathlib.Path(name).resolve() for name in sys.argv[2:]]
    out.mkdir(parents=True, exist_ok=True)
    with_truth = [sequence for sequence in sequences if (sequence / "reference_pairs.txt").exists()]
    near = [line for sequence in with_truth for line in near_lines(sequence, out)]
    (out / "near.txt").write_text("".join(f"{line}\n" for line in near))
    (out / "apart.txt").write_text("".join(f"{line}\n" for line in apart_lines(sequences)))


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main()
