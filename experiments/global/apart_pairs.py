#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""A list of clouds that share nothing for `augicp experiment global --pairs`: all pairs of clouds of different places.

    apart_pairs.py OUT.txt PLACE...    a PLACE is FOLDER, or FOLDER,FOLDER,... of one place, with clouds as
                                       `augicp experiment global --save` writes them
"""
import itertools
import pathlib
import sys


def clouds_of(place):
    return [cloud for folder in place.split(",") for cloud in sorted(pathlib.Path(folder).resolve().glob("cloud_*.ply"))]


def lines(places):
    for one, other in itertools.combinations(map(clouds_of, places), 2):
        for source, target in itertools.product(one, other):
            yield f"fragments_apart {source} {target} -\n"


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    pathlib.Path(sys.argv[1]).write_text("".join(lines(sys.argv[2:])))
