# SPDX-License-Identifier: MIT
"""The oracles of what is no cloud: images, trajectories, lists, poses and cameras. See hostile_oracles.py."""

import json
import math
import re
import struct
import zlib

from hostile_oracles import NUMBERS, Damaged, Holds, Unknown, fields, not_blank, npy_header, number, require, split_lines, text_of, without_bom


def png_rows(data):
    """Width, depth of a channel, channels, and the rows of a PNG, freed of their filters."""
    require(data[:8] == b"\x89PNG\r\n\x1a\n")
    at, packed, head = 8, b"", None
    while True:
        require(at + 12 <= len(data))
        length, kind = struct.unpack_from(">I4s", data, at)
        content = data[at + 8:at + 8 + length]
        require(at + 12 + length <= len(data) and zlib.crc32(kind + content) == struct.unpack_from(">I", data, at + 8 + length)[0])
        at += 12 + length
        if kind == b"IHDR":
            head = struct.unpack(">IIBBBBB", content)
        packed += content if kind == b"IDAT" else b""
        if kind == b"IEND":
            break
    width, height, bits, colour = head[:4]
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
    stride = width * channels * bits // 8
    # No more than the pixels: what lies behind them concerns nobody, damaged or not.
    raw = zlib.decompressobj().decompress(packed, height * (stride + 1))
    return width, bits, channels, unfiltered(raw, stride, height, channels * bits // 8)


def unfiltered(raw, stride, height, step):
    require(len(raw) >= height * (stride + 1))
    rows, above = [], bytes(stride)
    for row in range(height):
        kind, line = raw[row * (stride + 1)], bytearray(raw[row * (stride + 1) + 1:(row + 1) * (stride + 1)])
        for i in range(stride):
            left, corner = (line[i - step], above[i - step]) if i >= step else (0, 0)
            line[i] = line[i] + (0, left, above[i], (left + above[i]) // 2, paeth(left, above[i], corner))[kind] & 255
        rows.append(bytes(line))
        above = bytes(line)
    return rows


def paeth(left, above, corner):
    guess = left + above - corner
    return min((left, above, corner), key=lambda value: abs(guess - value))


def depth_png(data):
    width, bits, channels, rows = png_rows(data)
    require(bits == 16 and channels == 1)
    values = [value for row in rows for (value,) in struct.iter_unpack(">H", row)]
    return Holds(len(values), [value / 1000.0 for value in values if value not in (0, 65535)])


def depth_pgm(data):
    header = re.match(rb"P5" + 3 * rb"(?:[ \t\r\n]|#[^\n]*\n)*(\d+)" + rb"(?s:.)", data)
    require(header and 255 < int(header[3]) < 65536)
    count = int(header[1]) * int(header[2])
    require(count > 0 and len(data) - header.end() == 2 * count)
    values = struct.unpack_from(f">{count}H", data, header.end())
    return Holds(count, [value / 1000.0 for value in values if value not in (0, 65535)])


def depth_npy(data):
    """Floats are metres."""
    header, _, shape, begin = npy_header(data)
    descr = re.search(r"'descr'[ \t]*:[ \t]*'([<>|=])(\w)0*(\d+)'", header)
    form, count = (">" if descr[1] == ">" else "<") + NUMBERS[descr[2] + descr[3]], math.prod(shape)
    require(len(shape) == 2 and count > 0 and len(data) - begin == count * struct.calcsize(form))
    values = [value for (value,) in struct.iter_unpack(form, data[begin:])]
    if descr[2] != "f":
        return Holds(count, [value / 1000.0 for value in values if 0 < value != 65535])
    return Holds(count, [value for value in map(as_float, values) if 0 < value < math.inf])


def as_float(value):
    """Of 32 bits."""
    try:
        return struct.unpack("<f", struct.pack("<f", value))[0]
    except OverflowError:
        return math.inf


def grey_png(data):
    width, bits, channels, rows = png_rows(data)
    require(bits == 8 and channels != 2)
    pixels = [row[i:i + channels] for row in rows for i in range(0, len(row), channels)]
    return Holds(len(pixels), [(p[0] if channels == 1 else 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]) / 255.0 for p in pixels])


def rows_of_numbers(data, has_brackets=False):
    """Of each line that is more than a comment."""
    contents = [line.split("#")[0] for line in split_lines(text_of(without_bom(data)))]
    if not has_brackets:  # of poses
        contents = ["" if content.strip(" \t").startswith(("%", "//")) else content for content in contents]
    if has_brackets:
        contents = [re.sub(r"[\[\]]", " ", content) for content in contents]
    return [[number(word) for word in fields(line)] for line in not_blank(contents)]


def trajectory(data):
    rows = rows_of_numbers(data)
    require(rows and all(len(row) == 8 for row in rows))
    stamps = [row[0] for row in rows]
    require(all(first <= second for first, second in zip(stamps, stamps[1:])))
    rows = [row for row, before in zip(rows, [None] + stamps) if row[0] != before]  # of equal stamps the first is kept
    return Holds(len(rows), [sum(map(abs, row[1:4])) for row in rows])


def poses(data):
    """TUM's and KITTI's numbers. Tables with names and JSON are what only the first reader can read."""
    try:
        rows = rows_of_numbers(data)
    except Damaged:
        raise Unknown
    if any("q" in line.partition("#")[2] for line in split_lines(text_of(data))):
        raise Unknown  # names in a comment
    require(rows and len(rows[0]) in (8, 12, 13, 16, 17) and all(len(row) == len(rows[0]) for row in rows))
    if len(rows[0]) == 8 and abs(rows[0][0]) > 1e11:
        raise Unknown  # another unit
    if len(rows[0]) == 8:
        return trajectory(data)
    if len(rows[0]) > 13:
        require(all(row[-4:] == [0, 0, 0, 1] for row in rows))
        rows = [row[:-4] for row in rows]
    if len(rows[0]) == 12:
        return Holds(len(rows), [sum(map(abs, row[3::4])) for row in rows])
    stamps = [row[0] for row in rows]
    require(all(first <= second for first, second in zip(stamps, stamps[1:])))
    rows = [row for row, before in zip(rows, [None] + stamps) if row[0] != before]
    return Holds(len(rows), [sum(map(abs, row[4::4])) for row in rows])


def image_list(data):
    found = [line.strip(" \t") for line in not_blank(split_lines(text_of(without_bom(data))))]
    found = [line.replace("\t", " ").split(" ", 1) for line in found if not line.startswith("#")]
    require(all(len(line) == 2 for line in found))
    return Holds(len(found), [abs(number(line[0])) for line in found])


def numbers_under(data, key):
    """The numbers in the array, of rows or flat, under a key of a JSON object."""
    value = json.loads(without_bom(data).decode("utf-8"))[key]
    return [float(x) for row in value for x in (row if isinstance(row, list) else [row])]


def is_json(data):
    return without_bom(data).lstrip(b" \t\r\n").startswith(b"{")


def transform(data):
    numbers = numbers_under(data, "T_target_source") if is_json(data) else sum(rows_of_numbers(data, has_brackets=True), [])
    require(len(numbers) in (7, 12, 16))
    position = numbers[:3] if len(numbers) == 7 else numbers[3:12:4]
    return Holds(1, [sum(map(abs, position))])


def json_camera(data):
    """fx, fy, cx, cy."""
    found = json.loads(without_bom(data).decode("utf-8"))
    found = found["intrinsic"] if isinstance(found.get("intrinsic"), dict) else found
    names = [name for name in ("intrinsic_matrix", "camera_matrix", "K") if name in found]
    if not names:
        return [float(found[key]) for key in ("fx", "fy", "ppx" if "ppx" in found else "cx", "ppy" if "ppx" in found else "cy")]
    k = numbers_under(json.dumps(found).encode(), names[0])
    require(len(k) == 9)
    by_rows = k[6] == k[7] == 0 and (k[2] or k[5])
    return [k[0], k[4], k[2], k[5]] if by_rows else [k[0], k[4], k[6], k[7]]


def yaml_list(text, keys):
    """The numbers under the first of these keys, or None."""
    for key in keys:
        behind = re.search(rf"(?:^|[\r\n])[ \t]*(?:Camera[^:= \t\r\n]*\.)?{key}[ \t]*[:=]([^\r\n]*)(.*)", text, re.S)
        if not behind:
            continue
        line, rest = behind[1].strip(" \t"), behind[1] + behind[2]
        items = re.match(r"((?:\s*[\r\n][ \t]*-[^\r\n]*)+)", behind[2])
        if line == "" and items:
            return [number(word) for item in not_blank(split_lines(items[1])) for word in [item.strip(" \t")[1:].strip(" \t")]]
        if line == "" or line.startswith(("!!", "{")):
            rest = re.search(r"(?:^|[\r\n])[ \t]*data:(.*)", rest, re.S)[1]
        elif not line.startswith("["):
            return [number(word) for word in line.split("#")[0].replace(",", " ").split()]
        return [number(word) for word in re.search(r"\[([^\]]*)\]", rest, re.S)[1].replace(",", " ").split()]
    return None


def camera(data):
    text = text_of(data)
    if is_json(data):
        return Holds(1, [sum(map(abs, json_camera(data)))])
    if yaml_list(text, ("camera_matrix", "K", "k")) is not None:
        numbers = yaml_list(text, ("camera_matrix", "K", "k"))
        require(len(numbers) == 9 and yaml_list(text, ("distortion_coefficients", "D", "d")) is not None)
    elif yaml_list(text, ("intrinsics",)) is not None:
        numbers = yaml_list(text, ("intrinsics",))
        require(len(numbers) == 4)
    elif yaml_list(text, ("fx",)) is not None:
        numbers = [one for key in ("fx", "fy", "cx", "cy") for one in yaml_list(text, (key,))]
        require(len(numbers) == 4)
    else:
        numbers = sum(rows_of_numbers(data, has_brackets=True), [])
    require(len(numbers) in (4, 9, 12, 16))
    if len(numbers) == 12:
        numbers += [0, 0, 0, 1]
    if len(numbers) == 16:
        numbers = [numbers[i] for i in (0, 1, 2, 4, 5, 6, 8, 9, 10)]
    if len(numbers) == 9 and abs(numbers[1]) <= 10:
        numbers = [numbers[0], numbers[4], numbers[2], numbers[5]]
    return Holds(1, [sum(map(abs, numbers[:4]))])


__all__ = ["Damaged", "depth_png", "grey_png", "trajectory", "image_list", "transform", "camera"]
