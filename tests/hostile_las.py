# SPDX-License-Identifier: MIT
"""The oracle of LAS files. See hostile_oracles.py."""

import struct

from hostile_oracles import holds_of, require, take

RECORDS = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)
HEADERS = (227, 227, 227, 235, 375)


def end_of_evlrs(data, at, count, points_end):
    require(points_end <= at)
    for _ in range(count):
        length, _ = take(data, at + 20, "<Q")
        at += 60 + length
        require(at <= len(data))
    return at


def check_vlrs(data, at, count, begin):
    for _ in range(count):
        require(at + 54 <= begin)
        at += 54 + take(data, at + 20, "<H")[0]
        require(at <= begin)


def las(data):
    require(data[:4] == b"LASF" and len(data) >= 227)
    major, minor = data[24], data[25]
    require(major == 1 and minor <= 4)
    size, begin, num_vlrs, kind, length, legacy = struct.unpack_from("<HIIBHI", data, 94)
    require(HEADERS[minor] <= size <= begin <= len(data) and HEADERS[minor] <= len(data))
    require(kind <= 10 and length >= RECORDS[kind])
    count = take(data, 247, "<Q")[0] if minor == 4 else legacy
    require(legacy in (0, count) or minor < 4)
    require(count and begin + count * length <= len(data))
    check_vlrs(data, size, num_vlrs, begin)
    scale, offset = struct.unpack_from("<3d", data, 131), struct.unpack_from("<3d", data, 155)
    require(all(s != 0 and abs(s) * 2**31 + abs(o) < 1e18 for s, o in zip(scale, offset)))
    end = points_end = begin + count * length
    if minor >= 3 and data[6] & 2 and take(data, 227, "<Q")[0]:
        end = max(end, end_of_evlrs(data, take(data, 227, "<Q")[0], 1, points_end))
    if minor == 4 and take(data, 243, "<I")[0]:
        end = max(end, end_of_evlrs(data, take(data, 235, "<Q")[0], take(data, 243, "<I")[0], points_end))
    records = (struct.unpack_from("<3i", data, begin + i * length) for i in range(count))
    positions = [[x * s + o for x, s, o in zip(record, scale, offset)] for record in records]
    return holds_of(positions, end < len(data))
