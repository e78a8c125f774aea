#!/usr/bin/python3
"""The codes of a 16-bit grey PNG as CSV, by zlib alone. Usage: png_codes.py FILE.png > FILE.csv"""
import struct
import sys
import zlib

data = open(sys.argv[1], "rb").read()
packed, at = b"", 8
while at < len(data):
    (length,) = struct.unpack(">I", data[at:at + 4])
    if data[at + 4:at + 8] == b"IHDR":
        columns, rows = struct.unpack(">II", data[at + 8:at + 16])
    if data[at + 4:at + 8] == b"IDAT":
        packed += data[at + 8:at + 8 + length]
    at += 12 + length
lines, width = zlib.decompress(packed), 2 * columns
above = bytes(width)
for row in range(rows):
    begin = row * (width + 1)
    kind, line = lines[begin], bytearray(lines[begin + 1:begin + 1 + width])
    for i in range(width):
        left, corner = (line[i - 2], above[i - 2]) if i >= 2 else (0, 0)
        guess = left + above[i] - corner
        paeth = min((left, above[i], corner), key=lambda near: abs(guess - near))
        line[i] = (line[i] + (0, left, above[i], (left + above[i]) // 2, paeth)[kind]) % 256
    above = line
    print(",".join(str(256 * line[i] + line[i + 1]) for i in range(0, width, 2)))
