# SPDX-License-Identifier: MIT
"""Ways in which files are damaged. Each takes bytes and a random.Random, and gives bytes."""

import re
import struct
import zlib

NUMBERS = [b"0", b"-1", b"1", b"2", b"3", b"2147483647", b"4294967296", b"9223372036854775808", b"18446744073709551616",
           b"1000000000", b"1e9", b"1e308", b"1e-320", b"nan", b"-inf", b"", b"0x10", b"1,5", b"x"]
FLOATS = [struct.pack("<f", value) for value in (0.0, -1.0, 1e30, float("nan"), float("inf"), -float("inf"), 1e-40)]
COUNTS = [struct.pack("<I", value) for value in (0, 1, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 1000000000)]
WORDS = [b"nan", b"x", b"y", b"ply", b"list", b"double", b"char", b"ascii", b"binary", b"#", b",", b";", b"\t", b"\r", b"\0", b" ",
         b"\xef\xbb\xbf", b"property float x\n", b"element vertex 9\n", b"end_header\n", b"COUNT 1 1 1\n", b"1 2 3\n", b"{", b"[", b"-", b"e"]


def number(data, rng):
    found = list(re.finditer(rb"\d+", data))
    if not found:
        return data
    at = rng.choice(found)
    new = at[0] + b"0" if rng.random() < 0.2 else rng.choice(NUMBERS)
    return data[:at.start()] + new + data[at.end():]


def truncation(data, rng):
    return data[:rng.randrange(len(data) + 1)]


def byte_flips(data, rng):
    damaged = bytearray(data)
    for _ in range(rng.randint(1, 4) if data else 0):
        damaged[rng.randrange(len(damaged))] ^= 1 << rng.randrange(8)
    return bytes(damaged)


def other_bytes(data, rng):
    at, new = rng.randrange(len(data) + 1), rng.choice(FLOATS + COUNTS)
    return data[:at] + new + data[at + 4:]


def deletion(data, rng):
    at = rng.randrange(len(data) + 1)
    return data[:at] + data[at + rng.randint(1, 16):]


def insertion(data, rng):
    at, begin = rng.randrange(len(data) + 1), rng.randrange(len(data) + 1)
    new = rng.choice(WORDS) if rng.random() < 0.5 else data[begin:begin + rng.randint(1, 16)]
    return data[:at] + new + data[at:]


def line_ends(data, rng):
    new = rng.choice((b"\r\n", b"\r", b"\n\n", b" \n"))
    return data.replace(b"\r\n", b"\n").replace(b"\n", new)


def one_line_end(data, rng):
    ends = [at for at, byte in enumerate(data) if byte == 10]
    if not ends:
        return data
    at = rng.choice(ends)
    return data[:at] + rng.choice((b"\r\n", b"\r", b" ")) + data[at + 1:]


def swapped_words(data, rng):
    """The other endianness, of the file's end behind a random place."""
    begin, size = rng.randrange(len(data) + 1), rng.choice((2, 4, 8))
    words = (data[at:at + size] for at in range(begin, len(data), size))
    return data[:begin] + b"".join(word[::-1] for word in words)


def lines(data, rng):
    """One line twice, missing, or in another's place."""
    every = data.splitlines(keepends=True)
    if not every:
        return data
    i, j = rng.randrange(len(every)), rng.randrange(len(every))
    change = rng.randrange(3)
    if change == 0:
        every.insert(j, every[i])
    elif change == 1:
        del every[i]
    else:
        every[i], every[j] = every[j], every[i]
    return b"".join(every)


MUTATIONS = (number, number, truncation, byte_flips, other_bytes, deletion, insertion, line_ends, one_line_end, swapped_words, lines)


def with_right_checksums(data):
    """A PNG whose chunks are whole again, so that damage reaches what lies behind the check of them."""
    at = 8
    while at + 12 <= len(data):
        end = at + 8 + struct.unpack(">I", data[at:at + 4])[0]
        if end + 4 > len(data):
            break
        data = data[:end] + struct.pack(">I", zlib.crc32(data[at + 4:end])) + data[end + 4:]
        at = end + 4
    return data


def mutant(data, kind, rng):
    for _ in range(1 if rng.random() < 0.7 else rng.randint(2, 4)):
        data = rng.choice(MUTATIONS)(data, rng)
    return with_right_checksums(data) if kind.endswith("_png") and rng.random() < 0.6 else data


def every_truncation(data):
    return (data[:length] for length in range(len(data)))
