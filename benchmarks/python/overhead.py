#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""The cost of a call from Python against the same call from C++: two clouds of 300 000 points, ten runs of each in turn.

    cmake --build --preset release --target python_overhead_cpp augicp_python
    PYTHONPATH=build/release/python benchmarks/python/overhead.py build/release/benchmarks/python/python_overhead_cpp

In C++ the clouds are there before the clock starts; in Python they are float64 arrays, and taking them over counts. Prints
medians by the clock and of the processor's time, which other work on the machine disturbs less.
"""
import argparse
import subprocess
import tempfile
import time
from pathlib import Path

import numpy as np

import augicp


def room(random, count):
    """Points on the walls of a room with a bumpy floor, a millimetre of noise."""
    points = random.random((count, 3)) * [6, 5, 3]
    wall = random.integers(3, size=count)
    points[np.arange(count), wall] = 0
    floor = wall == 2
    points[floor, 2] += 0.2 * np.sin(2 * points[floor, 0]) * np.cos(3 * points[floor, 1])
    return points + random.normal(0, 0.001, points.shape)


def pair(count):
    random = np.random.default_rng(1)
    angle, motion = 0.1, np.eye(4)
    motion[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    motion[:3, 3] = 0.1, -0.05, 0.02
    source = (room(random, count) - motion[:3, 3]) @ motion[:3, :3]
    return [cloud.astype(np.float32).astype(np.float64) for cloud in (source, room(random, count))]


def timed(call):
    start, start_of_work = time.perf_counter(), time.process_time()
    x = call().T_target_source[0, 3]
    return time.perf_counter() - start, time.process_time() - start_of_work, x


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=Path)
    parser.add_argument("--points", type=int, default=300_000)
    parser.add_argument("--voxel-size", type=float, default=0.02)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--runs", type=int, default=10)
    given = parser.parse_args()
    source, target = pair(given.points)
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder, "source.npy"), Path(folder, "target.npy")]
        for path, cloud in zip(paths, (source, target)):
            np.save(path, cloud)
        words = [given.program, *paths, given.voxel_size, given.threads]
        with subprocess.Popen([str(word) for word in words], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as cpp:
            def from_cpp():
                cpp.stdin.write("\n")
                cpp.stdin.flush()
                return tuple(float(word) for word in cpp.stdout.readline().split())

            def from_python():
                return timed(lambda: augicp.align(source, target, voxel_size=given.voxel_size, threads=given.threads))

            assert from_cpp()[2] == from_python()[2], "not the same bits"  # also warms both up
            runs = np.array([(from_cpp()[:2], from_python()[:2]) for _ in range(given.runs)])
            cpp.stdin.close()
    cpp_s, python_s = np.median(runs, axis=0)
    for name, a, b in zip(("clock", "processor"), cpp_s, python_s):
        print(f"{name:10} C++ {a:.4f} s, Python {b:.4f} s: {100 * (b / a - 1):+.2f} %")


if __name__ == "__main__":
    main()
