# SPDX-License-Identifier: MIT
"""The content of a file by a second reader: short, slow readers that share nothing with the library's.

Each gives Holds for a file that is whole, and raises Damaged for one that is not. A reader that reads a damaged file, or
fewer points than the file without a warning, has lost data silently.
"""

import dataclasses
import math
import re
import struct

FORMATS = {"char": "b", "int8": "b", "uchar": "B", "uint8": "B", "short": "h", "int16": "h", "ushort": "H", "uint16": "H",
           "int": "i", "int32": "i", "uint": "I", "uint32": "I", "float": "f", "float32": "f", "double": "d", "float64": "d"}


class Damaged(Exception):
    pass


class Unknown(Exception):
    """What only the first reader can say."""


@dataclasses.dataclass
class Holds:
    points: int           # records the file declares, or has where it declares nothing
    sizes: list           # of each that is finite, the sum of its coordinates' magnitudes
    has_more: bool = False  # than it declares: a reader must warn


def require(holds):
    if not holds:
        raise Damaged


def holds_of(positions, has_more=False):
    sizes = [sum(map(abs, p)) for p in positions if all(abs(x) < 1e18 for x in p)]
    return Holds(len(positions), sizes, has_more)


def text_of(data):
    return data.decode("latin-1")


def split_lines(text):
    """Lines end in LF or CR LF, or all in CR if the first line does."""
    first = re.search("[\r\n]", text)
    if first and first[0] == "\r" and text[first.end():first.end() + 1] != "\n":
        found = text.split("\r")
    else:
        found = [line[:-1] if line.endswith("\r") else line for line in text.split("\n")]
    return found[:-1] if found[-1] == "" else found


def words_of(line):
    """The words between blanks; other white space is part of a word."""
    return re.split("[ \t]+", line.strip(" \t")) if line.strip(" \t") else []


def not_blank(found):
    return [line for line in found if line.strip(" \t")]


def number(word):
    require(re.fullmatch(r"[+-]?(\d+\.?\d*([eE][+-]?\d+)?|\.\d+([eE][+-]?\d+)?|inf(inity)?|nan(\(\w*\))?)", word, re.I | re.A))
    return float(re.sub(r"\(.*", "", word))


def count(word):
    require(re.fullmatch(r"\d+", word, re.A) and int(word) < 2**64)
    return int(word)


def separator(line):
    outside = "".join(line.split('"')[::2])
    return next((mark for mark in ";," if mark in outside), None)


def fields(line):
    return fields_of(line, separator(line))


def fields_of(line, mark):
    """Words between blanks, or fields between commas or semicolons, of which the last may be absent."""
    if mark is None:
        return words_of(line)
    found, rest = [], line.lstrip(" \t")
    while rest:
        quoted = re.match(r'"((?:[^"]|"")*)"[ \t]*(?:' + mark + "|$)", rest)
        plain = rest if rest[0] == '"' else rest.split(mark)[0]
        found.append(quoted[1] if quoted else plain.strip(" \t") if rest[0] != '"' else plain)
        rest = rest[len(quoted[0]) if quoted else len(plain) + 1:].lstrip(" \t")
    return found


def decimal(word, mark):
    """A number, between semicolons also with a comma."""
    return number(word.replace(",", ".") if mark == ";" and word.count(",") == 1 and "." not in word else word)


def without_bom(data):
    return data[3:] if data.startswith(b"\xef\xbb\xbf") else data


def take(data, at, form):
    size = struct.calcsize(form)
    require(at + size <= len(data))
    return struct.unpack_from(form, data, at)[0], at + size


OTHER_AXES = [tuple(stem + axis for axis in "012") for stem in ("points:", "points_", "points_m_xyz:")]
OTHER_AXES += [("easting", "northing", "elevation"), ("easting", "northing", "height")]


def columns_of(names):
    lower = [re.sub(r"[\[(]m[\])]$", "", name.lower()).rstrip(" ") for name in names]
    axes = next((axes for axes in OTHER_AXES if set(axes) <= set(lower)), "xyz")
    axes = "xyz" if set(lower) & set("xyz") else axes
    require(all(lower.count(axis) == 1 for axis in axes))
    return [lower.index(axis) for axis in axes]


# ---- PLY

def ply_header(data):
    """The elements [name, count, [(name, type, length type)]], the encoding, and where the body begins."""
    elements, encoding = [], None
    match = re.search(rb"(?:^|[\r\n])[ \t]*end_header[ \t]*(\r\n|\r|\n|$)", data)
    require(match)
    for line in not_blank(split_lines(text_of(data[:match.start()]))):
        words = words_of(line)
        if words[0] == "format":
            encoding = words[1]
        elif words[0] == "element":
            elements.append([words[1], count(words[2]), []])
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].append((words[4], FORMATS[words[3]], FORMATS[words[2]]))
        elif words[0] == "property":
            elements[-1][2].append((words[2], FORMATS[words[1]], None))
    return elements, encoding, match.end()


def ply_records(data, at, element, order):
    """The values of each record, lists left out, and where the next element begins."""
    records = []
    for _ in range(element[1] if element[2] else 0):
        record = []
        for _, form, length_form in element[2]:
            length = None
            if length_form:
                length, at = take(data, at, order + length_form)
                require(length >= 0 and at + int(length) * struct.calcsize(form) <= len(data))
                at += int(length) * struct.calcsize(form)
            else:
                value, at = take(data, at, order + form)
                record.append(value)
        records.append(record)
    return records, at


def ply_text_records(found, element):
    records = []
    for _ in range(element[1] if element[2] else 0):
        require(found)
        words, record = words_of(found.pop(0)), []
        for _, _, length_form in element[2]:
            require(words)
            word = words.pop(0)
            if length_form:
                require(len(words) >= count(word))
                del words[:count(word)]
            else:
                record.append(word)
        records.append(record)
    return records


def ply(data):
    elements, encoding, at = ply_header(data)
    vertex = next(e for e in elements if e[0] == "vertex")
    axes = columns_of([name for name, _, _ in vertex[2]])
    require(not any(length for _, _, length in vertex[2]))
    if encoding == "ascii":
        found = not_blank(split_lines(text_of(data[at:])))
        records = {id(e): ply_text_records(found, e) for e in elements}
        positions = [[number(record[axis]) for axis in axes] for record in records[id(vertex)]]
        return holds_of(positions, bool(found))
    order = {"binary_little_endian": "<", "binary_big_endian": ">"}[encoding]
    for element in elements:
        records, at = ply_records(data, at, element, order)
        if element is vertex:
            positions = [[record[axis] for axis in axes] for record in records]
    return holds_of(positions, at < len(data))


# ---- PCD

def lzf(data, size):
    out, at = bytearray(), 0
    while at < len(data):
        control, at = data[at], at + 1
        if control < 32:
            out += data[at:at + control + 1]
            at += control + 1
            continue
        length = control >> 5
        if length == 7:
            length, at = length + data[at], at + 1
        back, at = ((control & 31) << 8) + data[at] + 1, at + 1
        require(back <= len(out))
        for _ in range(length + 2):
            out.append(out[-back])
    require(len(out) == size)
    return bytes(out)


def pcd(data):
    start = 3 if data.startswith(b"\xef\xbb\xbf") else 0
    match = re.search(rb"(?:^|[\r\n])[ \t]*DATA[ \t]+(\w+)[ \t]*(\r\n|\r|\n|$)", data[start:])
    require(match)
    entries = {}
    for line in not_blank(split_lines(text_of(data[start:start + match.start()]))):
        if not line.strip(" \t").startswith("#"):
            entries[words_of(line)[0]] = words_of(line)[1:]
    names = entries.get("FIELDS", entries.get("COLUMNS"))
    counts = [count(word) for word in entries.get("COUNT", ["1"] * len(names))]
    forms = [{"F4": "f", "F8": "d", "I1": "b", "I2": "h", "I4": "i", "I8": "q", "U1": "B", "U2": "H", "U4": "I", "U8": "Q"}[kind + size]
             for kind, size in zip(entries["TYPE"], ("%d" % count(size) for size in entries["SIZE"]))]
    require(len(names) == len(counts) == len(forms))
    points = count(entries["POINTS"][0]) if "POINTS" in entries else None
    width = count(entries["WIDTH"][0]) if "WIDTH" in entries else points
    total = width * count(entries.get("HEIGHT", ["1"])[0])
    require(points in (None, total) and total < 10**6)
    axes, body = columns_of(names), data[start + match.end():]
    return PCD_BODIES[match[1]](body, total, axes, counts, forms, names)


def pcd_ascii(body, total, axes, counts, forms, names):
    found = not_blank(split_lines(text_of(body)))
    mark = separator(found[0]) if found else None
    found = [line for line in found if not line.strip(" \t").startswith("#")]
    starts = [sum(counts[:axis]) for axis in axes]
    require(len(found) >= total)
    rows = [fields_of(line, mark) for line in found[:total]]
    require(all(len(row) == sum(counts) for row in rows))
    return holds_of([[number(row[start]) for start in starts] for row in rows], len(found) > total)


def pcd_binary(body, total, axes, counts, forms, names):
    sizes = [n * struct.calcsize("<" + form) for n, form in zip(counts, forms)]
    require(total * sum(sizes) <= len(body))
    positions = [[take(body, i * sum(sizes) + sum(sizes[:axis]), "<" + forms[axis])[0] for axis in axes] for i in range(total)]
    return holds_of(positions, total * sum(sizes) < len(body))


def pcd_compressed(body, total, axes, counts, forms, names):
    require(len(body) >= 8)
    compressed, size = struct.unpack("<II", body[:8])
    require(compressed <= len(body) - 8)
    starts, at = {}, 0
    for column, (name, n, form) in enumerate(zip(names, counts, forms)):
        starts[column] = at
        at += 0 if name == "_" else total * n * struct.calcsize("<" + form)
    require(size == at)
    raw = lzf(body[8:8 + compressed], size)
    positions = [[take(raw, starts[axis] + i * struct.calcsize("<" + forms[axis]), "<" + forms[axis])[0] for axis in axes]
                 for i in range(total)]
    return holds_of(positions, any(body[8 + compressed:]))  # PCL pads with zeros


PCD_BODIES = {b"ascii": pcd_ascii, b"binary": pcd_binary, b"binary_compressed": pcd_compressed}


# ---- the others

def is_number(word, mark=None):
    try:
        decimal(word, mark)
        return True
    except Damaged:
        return False


def names_of(line):
    line = re.sub("^(//|#|%)", "", line.strip(" \t"))
    return [word[1:-1] if len(word) > 1 and word[0] == word[-1] == '"' else word for word in fields(line)]


def axes_of_comment(comments, first_point):
    """The columns that the last comment before the first point which names x, y and z states."""
    named = [names for names in map(names_of, comments) if all([name.lower() for name in names].count(axis) == 1 for axis in "xyz")]
    if not named:
        return [0, 1, 2]
    names = named[-1]
    axes, num_numbers = columns_of(names), len(fields(first_point))
    require(len(names) == num_numbers or axes == [0, 1, 2])
    return axes


def xyz(data):
    lines = not_blank(split_lines(text_of(without_bom(data))))
    is_comment = [line.strip(" \t").startswith(("#", "%", "//")) for line in lines]
    found = [line for line, skip in zip(lines, is_comment) if not skip]
    require(found)
    if re.fullmatch("sep=.?", found[0], re.I):
        found = found[1:]
        require(found)
    before = lines[:is_comment.index(False)]
    axes, declared = None, None
    if not is_number((fields(found[0]) + [""])[0], separator(found[0])):
        axes, found = columns_of(names_of(found[0])), found[1:]
    if found and len(fields(found[0])) == 1 and re.fullmatch(r"\d+", fields(found[0])[0], re.A):
        declared, found = count(fields(found[0])[0]), found[1:]
    require(found and (declared is None or len(found) >= declared))
    if axes is None:
        axes = axes_of_comment(before, found[0])
    mark = separator(found[0])
    rows = [fields_of(line, mark) for line in found[:declared]]
    require(all(len(row) > max(axes) for row in rows))
    text = "".join(row[axis] for row in rows for axis in axes)
    require(mark != ";" or "," not in text or "." not in text)
    return holds_of([[decimal(row[axis], mark) for axis in axes] for row in rows], declared is not None and len(found) > declared)


def kitti(data):
    require(data)
    possible = []
    for columns in (4, 5, 6):
        if len(data) % (4 * columns) == 0:
            points = list(struct.iter_unpack(f"<{columns}f", data))
            possible += [points] if not any(x < 0 for point in points for x in point[3:]) else []
    return holds_of([point[:3] for point in possible[0]], len(possible) > 1)


NUMBERS = {"f2": "e", "f4": "f", "f8": "d", "b1": "B", "i1": "b", "i2": "h", "i4": "i", "i8": "q", "u1": "B", "u2": "H", "u4": "I", "u8": "Q"}


def npy_members(descr):
    """The size of an item, and the form and the place of x, y and z."""
    size, found = 0, {}
    for name, order, kind, length, repeat in re.findall(
            r"\([ \t]*'([^']*)'[ \t]*,[ \t]*'([<>|=])(.)(\d+)'[ \t]*(?:,[ \t]*\([ \t]*(\d+)[ \t]*,?[ \t]*\)[ \t]*)?\)", descr):
        number_form = NUMBERS.get(kind + length.lstrip("0"))
        require(number_form or kind == "V")
        if number_form and name.lower() in ("x", "y", "z"):
            require(repeat == "" or int(repeat) == 1)
            require(name.lower() not in found)
            found[name.lower()] = ((">" if order == ">" else "<") + number_form, size)
        size += int(length) * int(repeat or 1)
    return size, [found[axis] for axis in "xyz"]


def npy_header(data):
    require(data[:6] == b"\x93NUMPY" and len(data) >= 12 and data[6] in (1, 2, 3))
    length, begin = take(data, 8, "<H" if data[6] == 1 else "<I")
    require(begin + length <= len(data))
    header = text_of(data[begin:begin + length])
    fortran = re.search(r"'fortran_order'[ \t]*:[ \t]*(True|False)", header)[1] == "True"
    shape = [int(side) for side in re.search(r"'shape'[ \t]*:[ \t]*\(([^)]*)\)", header)[1].strip(" \t,").split(",")]
    return header, fortran, shape, begin + length


def npy(data):
    header, fortran, shape, begin = npy_header(data)
    plain = re.search(r"'descr'[ \t]*:[ \t]*'([<>|=])(\w)0*(\d+)'", header)
    if plain:
        require(len(shape) in (2, 3) and shape[-1] >= 3)
        require(not (len(shape) == 2 and shape[0] in (3, 4) and shape[1] > 8))  # coordinates as rows
        form = (">" if plain[1] == ">" else "<") + NUMBERS[plain[2] + plain[3]]
        size, num_points = struct.calcsize(form), math.prod(shape[:-1])
        step, across = (size, num_points * size) if fortran else (shape[-1] * size, size)
        axes, total = [(form, axis * across) for axis in range(3)], math.prod(shape) * size
    else:
        require(len(shape) in (1, 2))
        step, axes = npy_members(re.search(r"'descr'[ \t]*:[ \t]*(\[.*)", header)[1].split("]")[0])
        num_points = math.prod(shape)
        total = num_points * step
    require(begin + total <= len(data) and num_points)
    positions = [[take(data, begin + i * step + at, form)[0] for form, at in axes] for i in range(num_points)]
    return holds_of(positions, begin + total < len(data))
