# SPDX-License-Identifier: MIT
"""Writes the seeds of the fuzz targets, fuzz/corpus/TARGET/: small files, together all that the readers know.

make_corpus.py [FOLDER]    run again after a change; what was found (regression-*) stays
"""

import base64
import bz2
import contextlib
import pathlib
import sqlite3
import struct
import sys
import tempfile
import zlib

import numpy

import corpus_texts

POINTS = numpy.random.default_rng(1).uniform(-2, 2, (12, 3)).astype("f4")


def ply(encoding, order, body, vertex="property float x\nproperty float y\nproperty float z\n", count=4, other=""):
    return (f"ply\nformat {encoding} 1.0\ncomment a seed\nelement vertex {count}\n{vertex}{other}end_header\n").encode() + body


def ply_files():
    rows = [(0, 0, 0), (1, 0.5, 2), (-1, 1e-3, 3), (2, "nan", 1)]
    text = "".join("%s %s %s\n" % row for row in rows).encode()
    faces = "element face 2\nproperty list uchar int vertex_indices\n"
    yield "ascii", ply("ascii", "", text)
    yield "ascii-faces", ply("ascii", "", text + b"3 0 1 2\n3 1 2 3\n", other=faces)
    for name, encoding, order in (("little", "binary_little_endian", "<"), ("big", "binary_big_endian", ">")):
        body = POINTS[:4].astype(order + "f4").tobytes()
        lists = b"".join(struct.pack(order + "B3i", 3, i, i + 1, i + 2) for i in range(2))
        yield name, ply(encoding, order, body + lists, other=faces)
    columns = "property double x\nproperty double y\nproperty double z\nproperty float nx\nproperty float ny\nproperty float nz\n"
    columns += "property uchar structure\nproperty ushort intensity\n"
    body = b"".join(struct.pack("<3d3fBH", 5e5 + i, 4e6 - i, i * i, 0, i, 1, i % 3, 100 * i) for i in range(6))
    yield "columns", ply("binary_little_endian", "<", body, columns, 6)
    before = b"ply\r\nformat ascii 1.0\r\nobj_info none\r\nelement camera 1\r\nproperty list char float v\r\nelement vertex 2\r\n"
    yield "element-before", before + b"property int x\r\nproperty int y\r\nproperty int8 z\r\nend_header\r\n2 0.5 1\r\n1 2 3\r\n4 5 6\r\n"


def gltf_files():
    corners = numpy.array([(0, 0, 3), (2, 0, 3), (0, 2, 3), (2, 2, 3)], "<f4").tobytes()
    buffer = corners + numpy.array([0, 1, 2, 2, 1, 3], "<u2").tobytes()
    inside = '"uri": "data:application/octet-stream;base64,' + base64.b64encode(buffer).decode() + '", '

    def document(uri, node="", primitive='"indices": 1, '):
        return ('{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{%s"mesh": 0}, {}], "meshes": '
                '[{"primitives": [{%s"attributes": {"POSITION": 0}}]}], "accessors": [{"bufferView": 0, "componentType": 5126, '
                '"count": 4, "type": "VEC3"}, {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}], "bufferViews": '
                '[{"buffer": 0, "byteLength": 48, "byteStride": 12}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}], "buffers": '
                '[{%s"byteLength": 60}]}' % (node, primitive, uri)).encode()
    text = document("")
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text + struct.pack("<II", len(buffer), 0x004E4942) + buffer
    yield "binary", struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
    yield "embedded", document(inside)
    yield "moved", document(inside, '"children": [1], "translation": [1, 2, 3], "rotation": [0, 0, 0.6, 0.8], "scale": [1, -1, 2], ')
    yield "matrix-strip", document(inside, '"matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1], ', '"mode": 5, ')
    yield "points", document(inside, primitive='"mode": 0, ')
    yield "beside", document('"uri": "a.bin", ')


def lzf_literals(data):
    """LZF without any matches: runs of up to 32 bytes behind their length."""
    runs = [data[i:i + 32] for i in range(0, len(data), 32)]
    return b"".join(bytes([len(run) - 1]) + run for run in runs)


def pcd(data, body, fields="x y z", size="4 4 4", types="F F F", count="1 1 1", width=4, height=1, more=""):
    return (f"# .PCD v0.7\nVERSION 0.7\nFIELDS {fields}\nSIZE {size}\nTYPE {types}\nCOUNT {count}\nWIDTH {width}\n"
            f"HEIGHT {height}\n{more}POINTS {width * height}\nDATA {data}\n").encode() + body


def pcd_files():
    yield "ascii", pcd("ascii", b"0 0 0\n1 2 3\n0.5 nan 1\n-1 -2 1e-3\n", more="VIEWPOINT 0 0 0 1 0 0 0\n")
    yield "binary", pcd("binary", POINTS[:4].tobytes(), more="VIEWPOINT 1 2 3 1 0 0 0\n")
    organised = POINTS[:6].copy()
    organised[2] = numpy.nan
    yield "organised", pcd("binary", organised.tobytes(), width=3, height=2)
    soa = POINTS[:4].T.tobytes()
    yield "compressed", pcd("binary_compressed", struct.pack("<II", len(lzf_literals(soa)), len(soa)) + lzf_literals(soa))
    matched = struct.pack("<II", 6, 24) + b"\x00\x00" + b"\xe0\x0c\x00" + b"\x00"  # 1 zero, 21 copies of it: cut
    yield "compressed-match", pcd("binary_compressed", matched, width=2)
    body = b"".join(struct.pack("<3f3f2B2x", i, 2 * i, -i, 0, 0, 2, i, 7) for i in range(4))
    yield "fields", pcd("binary", body, "x y z normal_x normal_y normal_z intensity _", "4 4 4 4 4 4 1 1", "F F F F F F U U",
                        "1 1 1 1 1 1 1 3")
    body = b"".join(struct.pack("<qQhB3f", -i, 2**40 + i, i, i, 0, 0, i - 1) for i in range(3))
    yield "integers-viewpoint", pcd("binary", body, "x y z rgb normal_x normal_y normal_z", "8 8 2 1 4 4 4", "I U I U F F F",
                                    "1 1 1 1 1 1 1", 3, more="VIEWPOINT 0 0 -9 1 0 0 0\n")
    yield "ascii-counts", pcd("ascii", b"1 2 3 9 8\n4 5 6 7 6\n", "x y z extra", "8 4 2 2", "F F I I", "1 1 1 2", 2)


def npy(array, version=1):
    header = repr({"descr": array.dtype.str, "fortran_order": bool(array.ndim > 1 and array.flags.f_contiguous), "shape": array.shape})
    header = header.ljust(64 if version == 1 else 68) + "\n"
    length = struct.pack("<H" if version == 1 else "<I", len(header))
    return b"\x93NUMPY" + bytes([version, 0]) + length + header.encode() + array.tobytes("A")


def npy_structured(array):
    header = repr({"descr": array.dtype.descr, "fortran_order": False, "shape": array.shape}) + "\n"
    return b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header.encode() + array.tobytes()


def npy_files():
    yield "f4", npy(POINTS[:4])
    yield "f8-version-2", npy(POINTS[:4].astype("f8"), 2)
    yield "big-endian", npy(POINTS[:4].astype(">f4"))
    yield "fortran", npy(numpy.asfortranarray(POINTS[:4]))
    yield "half", npy(POINTS[:4].astype("f2"))
    yield "integers", npy((100 * POINTS[:4]).astype(">i4"))
    structured = numpy.zeros(3, [("x", "<f8"), ("y", "<f4"), ("intensity", "<u2"), ("z", "<f4"), ("rgb", "u1", (3,))])
    structured["x"], structured["y"], structured["z"] = POINTS[:3].T
    yield "structured", npy_structured(structured)
    yield "grid", npy(numpy.resize(POINTS, (2, 3, 4)))


LAS_SIZES = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)


def las(minor, point_format, count=3, extra=b"", evlrs=b"", legacy=None):
    """Points whose records have another byte everywhere, behind the description of extra bytes if there are some."""
    size, length = (227, 227, 227, 235, 375)[minor], LAS_SIZES[point_format] + len(extra)
    vlr = b""
    if extra:
        vlr = struct.pack("<H16sHH32s", 0, b"LASF_Spec", 4, 192, b"") + struct.pack("<2xBB32s156x", 6, 8, b"height")
    head = bytearray(size)
    head[:4], head[24:26] = b"LASF", bytes((1, minor))
    struct.pack_into("<HIIBHI", head, 94, size, size + len(vlr), bool(vlr), point_format, length, count if legacy is None else legacy)
    struct.pack_into("<6d", head, 131, 0.01, 0.01, 0.001, 5e5, 4e6, 0)
    records = b"".join(struct.pack("<iii", 100 * i, -50 * i * i, 7 * i) + bytes((31 * i + k) % 256 for k in range(length - 12)) for i in range(count))
    if minor == 4:
        struct.pack_into("<QIQ", head, 235, size + len(vlr) + len(records) if evlrs else 0, bool(evlrs), count)
    return bytes(head) + vlr + records + evlrs


def las_files():
    yield "1.0-0", las(0, 0)
    yield "1.2-3", las(2, 3)
    yield "1.3-5", las(3, 5)
    yield "1.4-7-extra", las(4, 7, extra=b"abcd", legacy=0)
    yield "1.4-6-evlr", las(4, 6, evlrs=struct.pack("<H16sHQ32s", 0, b"text", 7, 5, b"") + b"12345")
    yield "1.4-10", las(4, 10, 2)
    yield "undescribed", las(1, 1, extra=b"xy")[:-2] + b"zz"
    compressed = bytearray(las(2, 1))
    compressed[104] |= 0x80
    yield "compressed", bytes(compressed)


def stl_files():
    corners = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], "f4")
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    body = b"".join(bytes(12) + corners[list(face)].tobytes() + bytes(2) for face in faces)
    yield "binary", b"solid, or not".ljust(80) + struct.pack("<I", 4) + body
    text = "".join("facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % tuple(corners[i]) for i in face) +
                   "endloop\nendfacet\n" for face in faces)
    yield "ascii", f"solid a\n{text}endsolid a\n".encode()


def ply_mesh_files():
    corners = numpy.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], "f4")
    faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)]
    lists = "element face 4\nproperty list uchar int vertex_indices\n"
    text = "".join("%g %g %g\n" % tuple(c) for c in corners) + "".join("3 %d %d %d\n" % face for face in faces)
    yield "ascii", ply("ascii", "<", text.encode(), other=lists)
    for name, order in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
        body = corners.astype(order + "f4").tobytes() + b"".join(struct.pack(order + "B3i", 3, *face) for face in faces)
        yield name, ply(name, order, body, other=lists)


def obj_files():
    yield "polygons", (b"# a box\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nvn 0 0 1\nvt 0 0\n"
                       b"f 4 3 2 1\nf -5/1/1 -4/1/1 -1/1/1\nf 2//1 3//1 5//1\n")
    yield "vertices", b"o points\nv 1 2 3 0.5 0.5 0.5\nv 4 5 6\n"


def text_in_bag(text):
    return struct.pack("<I", len(text)) + text


def message_of(cdr):
    """A PointCloud2 of three points x y z ring."""
    out = bytearray(b"\0\1\0\0" if cdr else b"")

    def number(value):
        out.extend(b"\0" * (-len(out) % 4 if cdr else 0) + struct.pack("<I", value))

    def text(value):
        number(len(value) + cdr)
        out.extend(value + b"\0" * cdr)
    for value in (() if cdr else (9,)) + (7, 8):
        number(value)
    text(b"lidar")
    for value in (1, 3, 4):
        number(value)
    for i, name in enumerate((b"x", b"y", b"z", b"ring")):
        text(name)
        number(4 * i)
        out.append(7 if i < 3 else 6)
        number(1)
    out.append(0)
    data = b"".join(struct.pack("<3fI", *point, i) for i, point in enumerate(POINTS[:3]))
    for value in (16, 48, len(data)):
        number(value)
    return bytes(out) + data + b"\1"


def point_cloud2_files():
    yield "cdr", b"\0" + message_of(True)
    yield "ros1", b"\1" + message_of(False)


def depth_message_files():
    """Behind a byte for form and type: images, compressed ones, a camera."""
    def header(cdr):
        return (b"\0\1\0\0" if cdr else bytes(4)) + struct.pack("<II", 7, 8) + (struct.pack("<I", 4) + b"cam\0" if cdr else text_in_bag(b"cam"))
    for cdr in (True, False):
        for name, encoding, pixels in (("16UC1", b"16UC1", struct.pack("<6H", 900, 0, 800, 65535, 7, 1000)),
                                       ("32FC1", b"32FC1", struct.pack("<6f", 1, 0, 2, numpy.nan, 3, 0.5))):
            out = header(cdr) + struct.pack("<II", 2, 3) + text_in_bag(encoding + (b"\0" if cdr else b"")) + b"\0"
            out += bytes(-len(out) % 4 if cdr else 0) + struct.pack("<II", len(pixels) // 2, len(pixels)) + pixels
            yield f"{name}-{'cdr' if cdr else 'ros1'}", bytes([0 if cdr else 1]) + out
    png = dict(depth_png_files())
    png = png[min(png, key=lambda name: len(png[name]))]
    for name, words, head in (("compressed", b"16UC1; compressedDepth png", bytes(12)),
                              ("inverse", b"32FC1; compressedDepth", struct.pack("<Iff", 0, 5000, 100)), ("png", b"16UC1; png compressed ", b"")):
        yield name, b"\3" + header(False) + text_in_bag(words) + text_in_bag(head + png)
    yield "rvl", b"\3" + header(False) + text_in_bag(b"16UC1; compressedDepth rvl") + text_in_bag(bytes(12) + struct.pack("<3I", 2, 2, 0x21a10150))
    k = (500, 0, 320, 0, 500, 240, 0, 0, 1)
    yield "camera", (b"\5" + header(False) + struct.pack("<II", 480, 640) + text_in_bag(b"plumb_bob") +
                     struct.pack("<I5d", 5, 0.1, -0.2, 0, 0, 0.1) + struct.pack("<30d", *k, *(0,) * 9, 450, 0, 310, 0, 0, 450, 230, 0, 0, 0, 1, 0))


def lz4_frame(content):
    """One block as it is."""
    return b"\x04\x22\x4d\x18\x60\x40\x82" + struct.pack("<I", len(content) | 1 << 31) + content + bytes(4)


def zstd_frame(content):
    """One block as it is, and then a run of zeros."""
    begin, zeros = content.rstrip(b"\0"), len(content) - len(content.rstrip(b"\0"))
    return b"\x28\xb5\x2f\xfd\0\x58" + struct.pack("<I", len(begin) << 3)[:3] + begin + struct.pack("<I", zeros << 3 | 3)[:3] + b"\0"


COMPRESS = {b"": bytes, b"none": bytes, b"lz4": lz4_frame, b"zstd": zstd_frame, b"bz2": bz2.compress, b"xz": bytes}


def mcap_files():
    def record(opcode, content):
        return struct.pack("<BQ", opcode, len(content)) + content
    start = b"\x89MCAP0\r\n" + record(1, text_in_bag(b"ros2") + text_in_bag(b""))
    schema = record(3, struct.pack("<H", 1) + text_in_bag(b"sensor_msgs/msg/PointCloud2") + text_in_bag(b"ros2msg") + text_in_bag(b""))
    channel = record(4, struct.pack("<HH", 1, 1) + text_in_bag(b"/points") + text_in_bag(b"cdr") + struct.pack("<I", 0))
    message = record(5, struct.pack("<HIQQ", 1, 0, 5, 5) + message_of(True))
    end = record(15, bytes(4)) + record(2, bytes(20)) + b"\x89MCAP0\r\n"
    yield "plain", start + schema + channel + message + end
    for name, compression in (("chunk", b""), ("zstd", b"zstd"), ("lz4", b"lz4"), ("xz", b"xz")):
        content = schema + channel + message
        stored = COMPRESS[compression](content)
        chunk = struct.pack("<QQQI", 5, 5, len(content), 0) + text_in_bag(compression) + struct.pack("<Q", len(stored)) + stored
        yield name, start + record(6, chunk) + end


def rosbag1_files():
    def header(**values):
        return text_in_bag(b"".join(text_in_bag(name.encode() + b"=" + value) for name, value in values.items()))
    connection = header(op=b"\7", conn=bytes(4), topic=b"/points") + header(topic=b"/points", type=b"sensor_msgs/PointCloud2")
    message = header(op=b"\2", conn=bytes(4), time=bytes(8)) + text_in_bag(message_of(False))
    for name, compression in (("plain", b"none"), ("bz2", b"bz2"), ("lz4", b"lz4")):
        chunk = connection + message
        yield name, (b"#ROSBAG V2.0\n" + header(op=b"\3", index_pos=struct.pack("<Q", 99)) + text_in_bag(b" " * 20) +
                     header(op=b"\5", compression=compression, size=struct.pack("<I", len(chunk))) + text_in_bag(COMPRESS[compression](chunk)))


def rosbag2_files():
    """Pages of 512 bytes. The version of the SQLite that wrote it is left out: the same seeds everywhere."""
    topics = "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT)"
    messages = "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)"
    index = "CREATE INDEX timestamp_idx ON messages(timestamp ASC)"
    rows = [(1, 6, b"ab"), (1, 5, b"cde"), (2, 7, b""), (1, 5, zstd_frame(b"fgh"))]
    for name, statements, rows in (("plain", [], [(1, 5, message_of(True))]), ("index", [index], rows)):
        with tempfile.TemporaryDirectory() as folder, contextlib.closing(sqlite3.connect(pathlib.Path(folder, "a"))) as database:
            database.execute("PRAGMA page_size = 512")
            for statement in [topics, messages] + statements:
                database.execute(statement)
            for number, topic in enumerate(("/points", "/b")[:max(row[0] for row in rows)], 1):
                database.execute("INSERT INTO topics VALUES(?, ?, 'sensor_msgs/msg/PointCloud2')", (number, topic))
            database.executemany("INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", rows)
            database.commit()
            content = pathlib.Path(folder, "a").read_bytes()
        yield name, content[:96] + bytes(4) + content[100:]


def kitti_files():
    sweep = numpy.hstack([POINTS[:6], numpy.arange(6, dtype="f4")[:, None] / 6])
    yield "sweep", sweep.tobytes()
    for columns in (5, 6):
        more = numpy.arange(6 * (columns - 3), dtype="f4").reshape(6, -1)
        yield f"columns-{columns}", numpy.hstack([POINTS[:6], more]).tobytes()
    yield "bare", POINTS[:5].tobytes()
    sweep[1, 0] = numpy.nan
    sweep[2, 3] = numpy.inf
    yield "not-finite", sweep.tobytes()


def png(pixels, bits, colour, chunks=(), interlace=0):
    """pixels: rows of bytes."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    channels = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[colour]
    width = len(pixels[0]) * 8 // (bits * channels)
    header = struct.pack(">IIBBBBB", width, len(pixels), bits, colour, 0, 0, interlace)
    lines = b"".join(bytes([i % 5 if i else 0]) + row for i, row in enumerate(pixels))
    middle = b"".join(chunk(kind, data) for kind, data in chunks)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + middle + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def depth_rows():
    values = numpy.arange(5000, 5000 + 7 * 48, 7, dtype=">u2").reshape(6, 8)
    values[2, 3], values[4, 4] = 0, 65535
    return [row.tobytes() for row in values]


def depth_png_files():
    yield "depth", png(depth_rows(), 16, 0)
    yield "chunks", png(depth_rows()[:2], 16, 0, ((b"gAMA", struct.pack(">I", 45455)), (b"tEXt", b"Title\0depth")))
    yield "near", png([struct.pack(">4H", 1, 2, 3, 4)], 16, 0)
    yield "grey-8", png([bytes(range(8))] * 2, 8, 0)


def depth_pgm_files():
    yield "depth", b"P5\n# depth\n8 6\n65535\n" + b"".join(depth_rows())
    yield "small", b"P5 2 1 300\n\x01\x00\x00\x00"
    yield "grey-8", b"P5 2 1 255\n\x01\x00"


def depth_pfm_files():
    values = numpy.arange(12, dtype="f4").reshape(3, 4) / 4
    values[1, 1] = numpy.inf
    yield "little", b"Pf\n4 3\n-1.0\n" + values.tobytes()
    yield "big", b"Pf\n4 3\n1\n" + values.astype(">f4").tobytes()


def tiff(values, order, compression=1, predictor=1, tile=None):
    """Strips of two rows, or square tiles."""
    height, width = values.shape
    across, down = (tile, tile) if tile else (width, 2)
    padded = numpy.pad(values, ((0, -height % down if tile else 0), (0, -width % across)))
    body, places = b"", []
    for top in range(0, height, down):
        for left in range(0, width, across):
            block = padded[top:top + down, left:left + across]
            if predictor == 2:
                block = numpy.diff(block, axis=1, prepend=block.dtype.type(0))
            if predictor == 3:
                planes = numpy.moveaxis(block.astype(">f4").copy().view("u1").reshape(len(block), across, 4), 2, 1).reshape(len(block), -1)
                block = numpy.diff(planes, axis=1, prepend=numpy.uint8(0))
            raw = block.astype(block.dtype.newbyteorder(order)).tobytes()
            packed = {1: raw, 8: zlib.compress(raw), 5: lzw_literals(raw), 32773: bytes([len(raw) - 1]) + raw}[compression]
            places.append((8 + len(body), len(packed)))
            body += packed
    lists = 8 + len(body)
    body += b"".join(struct.pack(f"{order}{len(places)}I", *column) for column in zip(*places))
    bits, form = 8 * values.itemsize, {"u": 1, "i": 2, "f": 3}[values.dtype.kind]
    tags = [(256, 1, width), (257, 1, height), (258, 1, bits), (259, 1, compression), (277, 1, 1), (317, 1, predictor), (339, 1, form)]
    tags += [(322, 1, tile), (323, 1, tile)] if tile else [(278, 1, down)]
    for k, tag in enumerate((324, 325) if tile else (273, 279)):
        tags.append((tag, len(places), places[0][k] if len(places) == 1 else lists + 4 * k * len(places)))
    entries = b"".join(struct.pack(order + "HHII", tag, 4, count, value) for tag, count, value in tags)
    mark = b"II" if order == "<" else b"MM"
    return mark + struct.pack(order + "HI", 42, 8 + len(body)) + body + struct.pack(order + "H", len(tags)) + entries + bytes(4)


def lzw_literals(raw):
    """LZW without any strings: codes of 9 bits, cleared before they would grow."""
    codes = [code for i, byte in enumerate(raw) for code in (([256] if i % 200 == 0 else []) + [byte])] + [257]
    bits = "".join(f"{code:09b}" for code in codes)
    return bytes(int(bits[i:i + 8].ljust(8, "0"), 2) for i in range(0, len(bits), 8))


def depth_tiff_files():
    whole = numpy.arange(500, 535, dtype="u2").reshape(5, 7)
    metres = (whole / 100).astype("f4")
    metres[2, 2] = numpy.nan
    yield "plain", tiff(whole, "<")
    yield "big", tiff(whole, ">", predictor=2)
    yield "lzw", tiff(whole, "<", 5)
    yield "packed", tiff(whole, "<", 32773)
    yield "floats", tiff(metres, "<", 8, predictor=3)
    yield "tiles", tiff(metres, ">", 8, tile=4)


def depth_npy_files():
    values = numpy.arange(12, dtype="f4").reshape(3, 4) / 4
    values[1, 1] = numpy.nan
    for name in ("f2", "f4", ">f8"):
        yield name.strip(">"), npy(values.astype(name))
    yield "fortran", npy(numpy.asfortranarray(values))
    yield "integers", npy(numpy.arange(500, 512, dtype="u2").reshape(3, 4))


def grey_png_files():
    row = bytes(range(0, 240, 10))
    yield "grey", png([row] * 3, 8, 0)
    yield "rgb", png([row] * 5, 8, 2)
    yield "rgba", png([row] * 2, 8, 6)
    yield "palette", png([row[:4]] * 2, 8, 3, ((b"PLTE", bytes(90)),))
    yield "grey-alpha", png([row] * 2, 8, 4)
    yield "interlaced", png([row] * 2, 8, 0, interlace=1)


def folder_of(files):
    return b"".join(b"@" + name.encode() + b"\n" + content + b"\n" for name, content in files)


def sequence_files():
    image = png(depth_rows()[:2], 16, 0)
    names = ("camera.json", "groundtruth.txt")
    camera, truth = corpus_texts.CAMERA["open3d"], corpus_texts.TRAJECTORY["tum"]
    index = b"# stamp path\n1.0 1.png\n1.5 missing.png\n"
    yield "tum", folder_of((("1.png", image), ("depth.txt", index), *zip(names, (camera, truth))))
    yield "tum-damaged-truth", folder_of((("depth.txt", index), ("groundtruth.txt", b"1 2 3\n")))
    pose = corpus_texts.TRANSFORM["matrix"]
    yield "7-scenes", folder_of((("frame-000000.depth.png", image), ("frame-000000.pose.txt", pose), ("frame-000001.depth.png", b""),
                                 ("frame-000001.pose.txt", b"-1.#IND 0 0 0"), ("camera.txt", b"500 500 320 240")))
    yield "numbered", folder_of((("depth1.png", image), ("1305031453.374112.PNG", b"x"), ("a.png", b"")))
    yield "twice", folder_of((("1.png", image), ("01.png", image)))
    yield "empty", folder_of((("readme", b""),))


def align_files():
    guess = struct.pack("<7f", 0.01, 0, 0, 0, 0, 0, 1)
    plane = numpy.array([(x, y, 0 if x < 500 else y) for x in range(0, 1000, 125) for y in range(0, 1000, 125)], dtype="<i2")
    for name, head in (("augmented", (0, 128, 2, 0x80)), ("paper-gicp", (0, 128, 1, 0xf1)), ("lengths", (0, 128, 62, 0x50))):
        lengths = struct.pack("<3f", 0.3, 0.05, 0.4) if name == "lengths" else b""
        yield name, bytes(head) + lengths + guess + plane.tobytes() + (plane[::-1] + 5).astype("<i2").tobytes()
    yield "floats", bytes((1, 100, 0, 0x43)) + guess + POINTS.tobytes()
    yield "line", bytes((0, 128, 2, 0x83)) + guess + b"".join(struct.pack("<3h", i, 0, 0) for i in range(40))
    yield "equal-points", bytes((0, 128, 2, 0x83)) + guess + struct.pack("<3h", 7, 7, 7) * 40
    yield "outlier", bytes((1, 200, 2, 0x40)) + guess + POINTS.tobytes() + struct.pack("<3f", 1e17, 0, 0) + POINTS.tobytes()


FILES = {"ply": ply_files, "pcd": pcd_files, "las": las_files, "stl": stl_files, "obj": obj_files, "gltf": gltf_files, "ply_mesh": ply_mesh_files, "point_cloud2": point_cloud2_files, "depth_message": depth_message_files, "mcap": mcap_files,
         "rosbag1": rosbag1_files, "rosbag2": rosbag2_files, "npy": npy_files, "kitti": kitti_files, "depth_png": depth_png_files, "depth_pgm": depth_pgm_files, "depth_npy": depth_npy_files, "depth_pfm": depth_pfm_files, "depth_tiff": depth_tiff_files,
         "grey_png": grey_png_files, "sequence": sequence_files, "align": align_files,
         "xyz": corpus_texts.XYZ.items, "image_list": corpus_texts.IMAGE_LIST.items, "trajectory": corpus_texts.TRAJECTORY.items,
         "poses": corpus_texts.POSES.items, "transform": corpus_texts.TRANSFORM.items, "camera": corpus_texts.CAMERA.items,
         "command_line": corpus_texts.COMMAND_LINE.items}


def main():
    corpus = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent / "corpus"
    for target, files in FILES.items():
        (corpus / target).mkdir(parents=True, exist_ok=True)
        for name, content in files():
            assert len(content) <= 2048, (target, name)
            (corpus / target / name).write_bytes(content)


if __name__ == "__main__":
    main()
