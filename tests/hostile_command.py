# SPDX-License-Identifier: MIT
"""The command on damaged files: a process each, with limits. See hostile_files.py."""

import functools
import json
import pathlib
import resource
import subprocess
import tempfile

import hostile_oracles
import hostile_small_oracles as small

CORPUS = pathlib.Path(__file__).parent.parent / "fuzz" / "corpus"
CAMERA = ["--camera", "500 500 3.5 2.5", "--depth-scale", "1000"]
INFO = ["info", "--json", "-"]
# Of each kind: the file's name, the arguments, and what the file holds where the answer tells.
KINDS = {"ply": ("any.ply", INFO + ["FILE"], hostile_oracles.ply), "pcd": ("any.pcd", INFO + ["FILE"], hostile_oracles.pcd),
         "xyz": ("any.csv", INFO + ["FILE"], hostile_oracles.xyz), "npy": ("any.npy", INFO + ["FILE"], hostile_oracles.npy),
         "kitti": ("any.bin", INFO + ["FILE"], hostile_oracles.kitti),
         "depth_png": ("any.png", INFO + CAMERA + ["FILE"], small.depth_png),
         "grey_png": ("any.png", ["align", "DEPTH", "DEPTH", *CAMERA, "--source-image", "FILE", "--target-image", "FILE", "--intensity"], None),
         "trajectory": ("any.txt", ["evaluate", "FILE", "TRUTH"], None),
         "transform": ("any.txt", ["align", "CLOUD", "CLOUD", "--initial", "FILE"], None),
         "camera": ("any.json", INFO + ["DEPTH", "--camera", "FILE", "--depth-scale", "1000"], None),
         "image_list": ("depth.txt", ["odometry", "FOLDER", *CAMERA, "--output", "OUT"], None)}
FILES = {"DEPTH": CORPUS / "depth_png" / "depth", "TRUTH": CORPUS / "trajectory" / "tum", "CLOUD": CORPUS / "ply" / "little"}
GRANTED = 64 << 20
MAX_SECONDS = 1


def limit(memory):
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CPU, (MAX_SECONDS, MAX_SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def run(arguments, memory):
    # The outer limit stops what waits; only the processor's time is judged.
    return subprocess.run(arguments, capture_output=True, timeout=60, preexec_fn=lambda: limit(memory), text=True, errors="replace")


@functools.cache
def idle_memory(arguments):
    """The least address space in which an idle run ends well, to 1 MB."""
    low, high = 1, 4096
    while low < high:
        middle = (low + high) // 2
        low, high = (low, middle) if run(arguments, middle << 20).returncode == 0 else (middle + 1, high)
    return high << 20


class Command:
    def __init__(self, program):
        self.program = program
        self.folder = tempfile.TemporaryDirectory()
        for name, source in FILES.items():
            extension = {"DEPTH": ".png", "TRUTH": ".txt", "CLOUD": ".ply"}[name]
            (pathlib.Path(self.folder.name) / (name.lower() + extension)).write_bytes(source.read_bytes())
        self.names = {"DEPTH": "depth.png", "TRUTH": "truth.txt", "CLOUD": "cloud.ply", "FOLDER": ".", "OUT": "out"}

    def __call__(self, kind, data):
        """The exit code, and behind it what was said."""
        name, arguments, _ = KINDS[kind]
        folder = pathlib.Path(self.folder.name)
        (folder / name).write_bytes(data)
        paths = {key: str(folder / value) for key, value in {**self.names, "FILE": name}.items()}
        idle = idle_memory((self.program, "info", paths["CLOUD"]))
        threads = ["--threads", "1"] if arguments[0] in ("align", "odometry") else []
        done = run([self.program, *(paths.get(word, word) for word in arguments), *threads], idle + GRANTED + 3 * len(data))
        (folder / name).unlink()
        return f"{done.returncode} {name} {done.stdout if done.returncode == 0 else done.stderr}"


def complaint(kind, data, answer):
    code, name, said = answer.split(" ", 2)
    if code in ("2", "3"):
        # A list of images may be whole, and name images that are not there; a camera may not fit the image.
        others = {"image_list": "no image can be used", "camera": "depth.png: depth image is"}
        names_it = name in said or others.get(kind, name) in said
        return None if names_it and "terminate" not in said else "the error does not name the file"
    if code in ("4", "5") and KINDS[kind][1][0] in ("align", "odometry"):
        return None
    if code != "0":
        return "a crash, an internal error or a limit"
    return loss(KINDS[kind][2], data, said) if KINDS[kind][2] else None


def loss(oracle, data, said):
    """What of the file is missing in the answer."""
    info = json.loads(said)
    try:
        holds = oracle(data)
    except Exception as error:  # of whatever kind: the oracles are as short as they can be
        return f"was read, but is damaged ({type(error).__name__} {error})"
    if not info["num_points"] + info["num_invalid"] == info["num_declared"] == holds.points:
        return f"holds {holds.points}"
    return "holds more, and there is no warning" if holds.has_more and not info["warnings"] else None
