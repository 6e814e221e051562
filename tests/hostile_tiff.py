# SPDX-License-Identifier: MIT
"""The oracle of depth images in TIFF. See hostile_oracles.py."""

import math
import re
import struct
import zlib

from hostile_oracles import Damaged, Holds, require
from hostile_small_oracles import as_float

FORMS = {(16, 1): "H", (16, 2): "h", (32, 1): "I", (32, 3): "f", (64, 3): "d"}


def unpacked(data, size):
    content = b""
    while len(content) < size:
        n, data = data[0], data[1:]
        if n < 128:
            require(len(data) > n)
            content, data = content + data[:n + 1], data[n + 1:]
        elif n > 128:
            content, data = content + data[:1] * (257 - n), data[1:]
    return content


def unzipped(data, size):
    bits, at, content, table, last = "".join(f"{byte:08b}" for byte in data), 0, b"", [], None
    while len(content) < size:
        known = 258 + len(table)
        width = 9 if known < 511 else 10 if known < 1023 else 11 if known < 2047 else 12
        require(at + width <= len(bits))
        code, at = int(bits[at:at + width], 2), at + width
        if code == 256:
            table, last = [], None
            continue
        require(code != 257 and code <= known and (last is not None or code < 256))
        if last is None:
            last = bytes([code])
        else:
            string = bytes([code]) if code < 256 else table[code - 258] if code < known else last + last[:1]
            table.append(last + string[:1])
            last = string
        content += last
    return content


DECODERS = {1: lambda data, size: data, 5: unzipped, 8: lambda data, size: zlib.decompressobj().decompress(data, size),
            32946: lambda data, size: zlib.decompressobj().decompress(data, size), 32773: unpacked}


def tags_of(data, order):
    begin, = struct.unpack_from(order + "I", data, 4)
    count, = struct.unpack_from(order + "H", data, begin)
    require(struct.unpack_from(order + "I", data, begin + 2 + 12 * count) == (0,))
    tags = {}
    for entry in range(begin + 2, begin + 2 + 12 * count, 12):
        tag, kind, number = struct.unpack_from(order + "HHI", data, entry)
        form = {1: "B", 3: "H", 4: "I"}.get(kind)
        if form and 0 < number <= len(data) and tag not in tags:
            at = entry + 8
            if number * struct.calcsize(form) > 4:
                at, = struct.unpack_from(order + "I", data, at)
            if at + number * struct.calcsize(form) <= len(data):
                tags[tag] = struct.unpack_from(f"{order}{number}{form}", data, at)
    return tags


def row_values(row, form, order, width, predictor):
    if predictor == 3:
        summed, sums = 0, bytearray()
        for byte in row:
            summed = summed + byte & 255
            sums.append(summed)
        return struct.unpack(f">{width}{form}", bytes(sums[k * width + u] for u in range(width) for k in range(len(row) // width)))
    if predictor == 2:
        whole = {"H": "H", "h": "H", "I": "I", "f": "I", "d": "Q"}[form]
        values, top = list(struct.unpack(f"{order}{width}{whole}", row)), 1 << 8 * struct.calcsize(whole)
        for u in range(1, width):
            values[u] = (values[u] + values[u - 1]) % top
        row = struct.pack(f"{order}{width}{whole}", *values)
    return struct.unpack(f"{order}{width}{form}", row)


def tiff(data):
    order = {b"II": "<", b"MM": ">"}[data[:2]]
    require(struct.unpack_from(order + "H", data, 2) == (42,))
    tags = tags_of(data, order)
    one = lambda tag, otherwise: tags.get(tag, (otherwise,))[0]
    width, height, form = tags[256][0], tags[257][0], FORMS[one(258, 1), one(339, 1)]
    require(one(277, 1) == 1 and one(266, 1) == 1)
    tiles = one(322, 0) != 0
    across, down = (tags[322][0], tags[323][0]) if tiles else (width, min(one(278, height), height))
    offsets, sizes = (tags[324], tags[325]) if tiles else (tags[273], tags[279])
    rows = [[0.0] * width for _ in range(height)]
    places = [(top, left) for top in range(0, height, down) for left in range(0, width, across)]
    require(len(places) == len(offsets) == len(sizes))
    for (top, left), offset, size in zip(places, offsets, sizes):
        num_rows = down if tiles else min(down, height - top)
        stride = across * struct.calcsize(form)
        require(offset + size <= len(data))
        block = DECODERS[one(259, 1)](data[offset:offset + size], num_rows * stride)
        require(len(block) >= num_rows * stride)
        for v in range(min(num_rows, height - top)):
            values = row_values(block[v * stride:(v + 1) * stride], form, order, across, one(317, 1))
            rows[top + v][left:left + across] = values[:width - left]
    values = [value for row in rows for value in row]
    if form in "fd":
        return Holds(len(values), [value for value in map(as_float, values) if 0 < value < math.inf])
    return Holds(len(values), [value / 1000.0 for value in values if 0 < value != 65535])


def pfm(data):
    blank = rb"(?:[ \t\r\n]|#[^\n]*\n)*"
    header = re.match(rb"Pf" + blank + rb"(\d+)" + blank + rb"(\d+)" + blank + rb"([^ \t\r\n]+)(?s:.)", data)
    require(header and float(header[3]) != 0)
    count = int(header[1]) * int(header[2])
    require(count > 0 and len(data) - header.end() == 4 * count)
    values = struct.unpack_from(("<" if float(header[3]) < 0 else ">") + f"{count}f", data, header.end())
    return Holds(count, [value for value in values if 0 < value < math.inf])


__all__ = ["Damaged", "tiff", "pfm"]
