#!/usr/bin/env python3
"""How much the colours of pictures vary: variance.py LEAST PICTURE...

Prints for each PNG of 8-bit RGB the standard deviations of red - green and blue - green, added up, in the rows between
the window's panel and its keys. Fails if a sum is below LEAST: nothing but ground and shadows is drawn, or nothing at all.
"""
import struct
import sys
import zlib


FILTERS = (
    lambda left, up, corner: 0,
    lambda left, up, corner: left,
    lambda left, up, corner: up,
    lambda left, up, corner: (left + up) // 2,
    lambda left, up, corner: min((left, up, corner), key=lambda value: abs(left + up - corner - value)))


def rows(path):
    """The rows of a picture, each the bytes of its pixels."""
    data = open(path, "rb").read()
    at, packed, width = 8, b"", 0
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        if kind == b"IHDR":
            width = struct.unpack(">I", data[at + 8:at + 12])[0]
        if kind == b"IDAT":
            packed += data[at + 8:at + 8 + size]
        at += size + 12
    filtered, before = zlib.decompress(packed), bytes(3 * width)
    for start in range(0, len(filtered), 3 * width + 1):
        row = bytearray(filtered[start + 1:start + 1 + 3 * width])
        for i in range(3 * width):  # the filters of PNG, section 9
            left, up, corner = row[i - 3] if i > 2 else 0, before[i], before[i - 3] if i > 2 else 0
            row[i] = (row[i] + FILTERS[filtered[start]](left, up, corner)) & 255
        yield row
        before = row


def deviation(values):
    mean = sum(values) / len(values)
    return (sum(value * value for value in values) / len(values) - mean * mean) ** 0.5


least, low = float(sys.argv[1]), 0
for path in sys.argv[2:]:
    picture = list(rows(path))
    seen = b"".join(picture[len(picture) // 2:len(picture) * 17 // 20])
    red, green, blue = (seen[channel::3] for channel in range(3))
    varies = sum(deviation([a - b for a, b in zip(other, green)]) for other in (red, blue))
    print(f"{path} {varies:.1f}")
    low += varies < least
sys.exit(low > 0)
