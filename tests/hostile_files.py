# SPDX-License-Identifier: MIT
"""Damages files and looks at what becomes of them: each is refused with an error that names it, or all of it is read.

hostile_files.py --readers PROGRAM --count N    N files for fuzz/read_many.cpp, which has all readers in one process
hostile_files.py --command AUGICP --count N     N files for the command, a process each

Never: a crash, another exception, more than a second, more memory than three times the file and 64 MB (--limit-memory; not
with sanitizers), or a success with fewer points than the file holds (hostile_oracles.py) and no warning. Seeds are the
fuzzers', all of whose beginnings are tried too. Files with a finding are kept in --keep. The same --seed, the same files.
"""

import argparse
import collections
import math
import multiprocessing
import pathlib
import random
import re
import subprocess
import sys
import time

import hostile_bags
import hostile_command
import hostile_las
import hostile_mutations
import hostile_oracles
import hostile_small_oracles as small
import hostile_tiff

CORPUS = pathlib.Path(__file__).parent.parent / "fuzz" / "corpus"
KINDS = {"ply": (".ply", hostile_oracles.ply), "pcd": (".pcd", hostile_oracles.pcd), "las": (".las", hostile_las.las), "xyz": (".csv", hostile_oracles.xyz),
         "npy": (".npy", hostile_oracles.npy), "kitti": (".bin", hostile_oracles.kitti), "depth_png": (".depth_png", small.depth_png),
         "depth_pgm": (".depth_pgm", small.depth_pgm), "depth_npy": (".depth_npy", small.depth_npy),
         "depth_pfm": (".depth_pfm", hostile_tiff.pfm), "depth_tiff": (".depth_tiff", hostile_tiff.tiff), "poses": (".poses", small.poses),
         "grey_png": (".grey_png", small.grey_png), "trajectory": (".trajectory", small.trajectory),
         "image_list": (".image_list", small.image_list), "transform": (".transform", small.transform),
         "camera": (".camera", small.camera), "mcap": (".mcap", hostile_bags.mcap), "rosbag1": (".bag", hostile_bags.rosbag1),
         "rosbag2": (".db3", hostile_bags.rosbag2),
         "point_cloud2": (".point_cloud2", None), "depth_message": (".depth_message", None), "stl": (".stl", None), "obj": (".obj", None), "gltf": (".gltf", None), "ply_mesh": (".ply_mesh", None)}
TASK_SIZE = 2000


class Readers:
    """The program with all readers; started again after a crash."""

    def __init__(self, program, limits_memory):
        self.command = [program] + (["--limit-memory"] if limits_memory else [])
        self.process = None

    def __call__(self, kind, data):
        if not self.process:
            self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, bufsize=0)
        self.process.stdin.write(b"%s %d\n" % (KINDS[kind][0].encode(), len(data)) + data)
        answer = self.process.stdout.readline().decode(errors="replace").strip()
        if answer:
            return answer
        code, self.process = self.process.wait(), None
        return f"died with code {code}"


def complaint(kind, data, answer):
    """The fault of an answer to a file, or nothing."""
    word, _, rest = answer.partition(" ")
    if word == "refused":
        names_file = re.match(rf"any{re.escape(KINDS[kind][0])}(\.\w+)?: ", rest)  # some kinds get the extension of users
        return None if kind == "transform" or names_file else "the error does not name the file"
    if word != "read":
        return answer
    kept, dropped, warnings = map(int, rest.split()[:3])
    if not KINDS[kind][1]:  # no second reader: neither crashes nor hangs, and errors name the file
        return None
    try:
        holds = KINDS[kind][1](data)
    except hostile_oracles.Unknown:
        return None
    except Exception as error:  # of whatever kind: the oracles are as short as they can be
        return f"was read, but is damaged ({type(error).__name__} {error})"
    if kept + dropped != holds.points or kept != len(holds.sizes):
        return f"holds {holds.points} of which {len(holds.sizes)} finite"
    if not math.isclose(float(rest.split()[3]), sum(holds.sizes), rel_tol=1e-5, abs_tol=1e-30):
        return f"holds other numbers, sum {sum(holds.sizes)}"
    return "holds more, and there is no warning" if holds.has_more and not warnings else None


def mutants(kind, seed, count):
    """The seeds as they are and all their beginnings (seed 0), or damaged ones."""
    seeds = [path.read_bytes() for path in sorted((CORPUS / kind).iterdir())]
    rng = random.Random(f"{kind} {seed}")
    for data in seeds if seed == 0 else ():
        yield data
        yield from hostile_mutations.every_truncation(data)
    for _ in range(count if seed else 0):
        yield hostile_mutations.mutant(rng.choice(seeds), kind, rng)


def run_task(task):
    kind, seed, count, arguments = task
    ask = hostile_command.Command(arguments.command) if arguments.command else Readers(arguments.readers, arguments.limit_memory)
    judge = hostile_command.complaint if arguments.command else complaint
    tally, findings = collections.Counter(), []
    for i, data in enumerate(mutants(kind, seed, count)):
        begin = time.monotonic()
        answer = ask(kind, data)
        tally["slowest_s"] = max(tally["slowest_s"], time.monotonic() - begin)
        tally[answer.split()[0]] += 1
        if problem := judge(kind, data, answer):
            findings.append((f"{kind}-{seed}-{i}", data, f"{answer[:200]}: {problem}"))
    return kind, tally, findings


def tasks_of(arguments):
    kinds = arguments.kinds or (hostile_command.KINDS if arguments.command else KINDS)
    if not arguments.command:
        yield from ((kind, 0, 0, arguments) for kind in kinds)
    each = -(-arguments.count // len(kinds))
    for begin in range(0, each, TASK_SIZE):
        for kind in kinds:
            yield kind, arguments.seed + begin, min(TASK_SIZE, each - begin), arguments


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    program = parser.add_mutually_exclusive_group(required=True)
    program.add_argument("--readers")
    program.add_argument("--command")
    parser.add_argument("--count", type=int, default=10000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kinds", nargs="*", choices=KINDS)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--limit-memory", action="store_true")
    parser.add_argument("--keep", type=pathlib.Path, default=pathlib.Path("hostile"))
    return parser.parse_args()


def main():
    arguments, begin = parsed_arguments(), time.monotonic()
    tallies, num_findings = collections.defaultdict(collections.Counter), 0
    with multiprocessing.Pool(arguments.jobs) as pool:
        for kind, tally, findings in pool.imap_unordered(run_task, tasks_of(arguments)):
            slowest = max(tallies[kind].pop("slowest_s", 0), tally.pop("slowest_s", 0))
            tallies[kind].update(tally)
            tallies[kind]["slowest_s"] = slowest
            for name, data, problem in findings:
                arguments.keep.mkdir(parents=True, exist_ok=True)
                (arguments.keep / name).write_bytes(data)
                num_findings += 1
                if num_findings <= 20:
                    print(f"{arguments.keep / name}: {problem}")
    for kind, tally in sorted(tallies.items()):
        slowest = tally.pop("slowest_s")
        print(f"{kind:11}", *(f"{word} {n}" for word, n in sorted(tally.items())), f"slowest {1000 * slowest:.0f} ms")
    num_files = sum(sum(tally.values()) for tally in tallies.values())
    print(f"{num_files} files in {time.monotonic() - begin:.0f} s, {num_findings} findings")
    return 1 if num_findings else 0


if __name__ == "__main__":
    sys.exit(main())
