# SPDX-License-Identifier: MIT
"""Second readers of recordings, as short as they can be: the lengths of all messages. Chunks of lz4 and zstd hold what
the first reader says of them: Python has no library for them."""
import bz2
import contextlib
import pathlib
import sqlite3
import struct
import tempfile

from hostile_oracles import Holds, Unknown, require


class Bytes:
    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, count):
        require(count <= len(self.data) - self.at)
        self.at += count
        return self.data[self.at - count:self.at]

    def number(self, size):
        return int.from_bytes(self.take(size), "little")

    def text(self):
        return self.take(self.number(4))

    def is_at_end(self):
        return self.at == len(self.data)


def decompressed(kind, stored, size):
    if kind in (b"lz4", b"zstd"):
        raise Unknown
    require(kind in (b"", b"none", b"bz2"))
    if kind == b"bz2":
        stored = bz2.decompress(stored)
    require(len(stored) == size)
    return stored


def holds_of(sizes):
    return Holds(len(sizes), [float(size) for size in sizes])


def mcap_records(source, channels, sizes, in_chunk):
    while not (in_chunk and source.is_at_end()):
        opcode, content = source.number(1), None
        length = source.number(8)
        if opcode in (2, 15) and not in_chunk:
            return
        content = Bytes(source.take(length))
        if opcode == 3:
            content.take(2)
            content.text()
        elif opcode == 4:
            channels.add(content.number(2))
            content.take(2)
            content.text(), content.text()
        elif opcode == 5:
            require(content.number(2) in channels)
            content.take(20)
            sizes.append(len(content.data) - content.at)
        elif opcode == 6:
            require(not in_chunk)
            content.take(16)
            size = content.number(8)
            content.take(4)
            kind = content.text()
            mcap_records(Bytes(decompressed(kind, content.take(content.number(8)), size)), channels, sizes, True)


def mcap(data):
    source, sizes = Bytes(data), []
    require(source.take(8) == b"\x89MCAP0\r\n")
    mcap_records(source, set(), sizes, False)
    return holds_of(sizes)


def header_of(data):
    source, fields = Bytes(data), {}
    while not source.is_at_end():
        name, equals, value = source.text().partition(b"=")
        require(equals)
        fields.setdefault(name, value)
    return fields


def number_in(fields, name, size):
    require(len(fields[name]) >= size)
    return int.from_bytes(fields[name][:size], "little")


def rosbag1_records(source, connections, sizes, in_chunk):
    while not source.is_at_end():
        fields, data = header_of(source.text()), source.text()
        operation = number_in(fields, b"op", 1)
        require(operation != 3 or number_in(fields, b"index_pos", 8) != 0)
        if operation == 7:
            require(b"topic" in fields and b"type" in header_of(data))
            connections.add(number_in(fields, b"conn", 4))
        elif operation == 2:
            require(number_in(fields, b"conn", 4) in connections and len(fields[b"time"]) >= 8)
            sizes.append(len(data))
        elif operation == 5:
            require(not in_chunk)
            stored = decompressed(fields[b"compression"], data, number_in(fields, b"size", 4))
            rosbag1_records(Bytes(stored), connections, sizes, True)


def rosbag1(data):
    source, sizes = Bytes(data), []
    require(source.take(13) == b"#ROSBAG V2.0\n")
    rosbag1_records(source, set(), sizes, False)
    return holds_of(sizes)


def rosbag2(data):
    """By Python's own SQLite, table by table. A message compressed by zstd is one that only the first reader can read."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "any.db3")
        path.write_bytes(data)
        with contextlib.closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as database:
            database.text_factory = bytes
            topics = {number: (name, kind) for number, name, kind in database.execute("SELECT id, name, type FROM topics")}
            messages = list(database.execute("SELECT topic_id, timestamp, data FROM messages"))
    for topic, stamp, content in messages:
        require(all(isinstance(word, bytes) for word in topics[topic]))
        require(isinstance(stamp, int) and isinstance(content, bytes))
        if content[:4] == b"\x28\xb5\x2f\xfd":
            raise Unknown
    return holds_of([len(content) for _, _, content in messages])
