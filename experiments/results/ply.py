# SPDX-License-Identifier: MIT
"""Little-endian binary PLY whose vertices come first and have no lists."""
import numpy as np

TYPES = {"float": "<f4", "double": "<f8", "uchar": "u1", "int": "<i4"}


def read_vertices(path):
    """One record a vertex, a field a property."""
    content = path.read_bytes()
    start = content.index(b"end_header\n") + len(b"end_header\n")
    header = [line.split() for line in content[:start].decode("latin-1").splitlines()]
    count = next(int(words[2]) for words in header if words[:2] == ["element", "vertex"])
    layout = np.dtype([(words[2], TYPES[words[1]]) for words in header if words[0] == "property" and words[1] != "list"])
    return np.frombuffer(content, layout, count, start)


def positions(vertices):
    return np.stack([vertices[axis] for axis in "xyz"], axis=1).astype(float)
