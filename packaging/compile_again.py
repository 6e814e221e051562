# SPDX-License-Identifier: MIT
"""Compiles some objects of a Debian build once more, elsewhere, and compares every byte.

    compile_again.py TREE ELSEWHERE [COUNT]

TREE is a built source tree. It is copied to ELSEWHERE, without what was made of its sources. COUNT objects are drawn at random, by
the state of the sources, so that another commit draws others; without COUNT all of them. They are compiled without ccache, in another
time zone and language. Exit code 1: an object differs.
"""
import hashlib
import json
import os
import random
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

BUILD = "build/debian"
ELSEWHERE_IN_THE_WORLD = {"TZ": "Pacific/Apia", "LC_ALL": "C", "LANGUAGE": "fr", "CCACHE_DISABLE": "1"}


def compilations(tree):
    """Those of objects, by the object's path below the build folder."""
    listed = subprocess.run(["ninja", "-C", tree / BUILD, "-t", "compdb"], capture_output=True, text=True, check=True).stdout
    listed = listed[listed.index("["):]  # behind what Ninja prints of the folder
    return {one["output"]: one["command"] for one in json.loads(listed)
            if one["output"].endswith(".o") and (tree / BUILD / one["output"]).exists()}


def compile_elsewhere(command, tree, elsewhere):
    words = shlex.split(command.replace(str(tree), str(elsewhere)))
    words = words[next(i for i, word in enumerate(words) if Path(word).name != "ccache"):]
    subprocess.run(words, cwd=elsewhere / BUILD, env=os.environ | ELSEWHERE_IN_THE_WORLD, check=True)


def main():
    tree, elsewhere = (Path(word).resolve() for word in sys.argv[1:3])
    shutil.rmtree(elsewhere, ignore_errors=True)
    shutil.copytree(tree, elsewhere, symlinks=True, ignore=shutil.ignore_patterns("*.o", "*.a", "*.so*", "*.deb"))
    all_of_them = compilations(tree)
    count = int(sys.argv[3]) if len(sys.argv) > 3 else len(all_of_them)
    seed = hashlib.sha256(b"".join((tree / BUILD / name).read_bytes() for name in sorted(all_of_them))).hexdigest()
    drawn = random.Random(seed).sample(sorted(all_of_them), min(count, len(all_of_them)))
    with ThreadPoolExecutor(int(os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", os.cpu_count()))) as pool:
        list(pool.map(lambda name: compile_elsewhere(all_of_them[name], tree, elsewhere), drawn))
    other = [name for name in drawn if (tree / BUILD / name).read_bytes() != (elsewhere / BUILD / name).read_bytes()]
    if other:
        sys.exit("\n".join(["other bytes when compiled again:", *other]))
    print(f"{len(drawn)} of {len(all_of_them)} objects, compiled again in another folder, time zone and language, have the same bytes")


if __name__ == "__main__":
    main()
