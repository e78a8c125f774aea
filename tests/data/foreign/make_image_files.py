#!/usr/bin/python3
"""Writes the TIFF, OpenEXR, X3P and binary SDF files of this folder, and CSVs of their values.

Needs numpy and tifffile (python3-numpy, python3-tifffile), tiffcp (libtiff-tools) and exrmaketiled
and exrstdattr (openexr). The values are the same from run to run; some files hold a date.
Usage: ./make_image_files.py
"""
import hashlib
import pathlib
import struct
import subprocess
import zipfile

import numpy as np
import tifffile

here = pathlib.Path(__file__).parent
rows, cols = 11, 17  # no multiple of a tile or of a block of lines
row, col = np.mgrid[0:rows, 0:cols]
# No symmetry: a mirrored or transposed reading differs in every row.
relief = np.sin(0.7 * col + 0.2 * row * row) + 0.05 * row + 0.013 * col


def codes(kind):
    """The relief over the whole range of an integer type, both ends included."""
    low, high = np.iinfo(kind).min, np.iinfo(kind).max
    unit = (relief - relief.min()) / np.ptp(relief)
    return np.clip(np.round(low + unit * (high - low)), low, high).astype(kind)


fields = {
    "uint8": codes(np.uint8),
    "uint16": codes(np.uint16),
    "uint32": codes(np.uint32),
    "int8": codes(np.int8),
    "int16": codes(np.int16),
    "int32": codes(np.int32),
    "float16": (relief * 1e-3).astype(np.float16),
    "float32": (relief * 1e-7).astype(np.float32),
    "float64": relief * 1e-7,
    # The range of the type and its edges: subnormal, smallest normal, largest, and a hole.
    "float32_edges": np.array([[1e-45, -1e-45, 1.17549435e-38, 3.4028235e38],
                               [-3.4028235e38, np.nan, 0.1, -0.0]], np.float32),
}
for name, values in fields.items():
    # 17 digits hold every double.
    np.savetxt(here / f"{name}.csv", values.astype(np.float64), fmt="%.17g", delimiter=",")


def tiff(name, values, **options):
    tifffile.imwrite(here / name, values, metadata=None, software="", **options)


def tiffcp(options, source, *targets):
    subprocess.run(["tiffcp", *options.split(), *[here / t for t in (source, *targets)]], check=True)


for name in ("uint8", "uint16", "uint32", "int8", "int16", "int32", "float32", "float64",
             "float32_edges"):
    tiff(f"tifffile_{name}.tif", fields[name], photometric="minisblack")
tiff("tifffile_uint16_big_endian.tif", fields["uint16"], byteorder=">", photometric="minisblack")
tiff("tifffile_float32_deflate.tif", fields["float32"], compression="zlib", rowsperstrip=4,
     photometric="minisblack")
tiff("tifffile_rgb.tif", np.repeat(fields["uint8"][:, :, None], 3, 2), photometric="rgb")
tiff("tifffile_two.tif", np.stack([fields["uint16"], fields["uint16"][::-1]]),
     photometric="minisblack")
tiff("tifffile_nodata.tif", fields["int16"], photometric="minisblack",
     extratags=[(42113, "s", 0, str(fields["int16"][3, 5]), True)])
tiffcp("-c lzw:2 -r 3", "tifffile_uint16.tif", "tiffcp_uint16_lzw.tif")
tiffcp("-c packbits -r 5", "tifffile_uint8.tif", "tiffcp_uint8_packbits.tif")
tiffcp("-c none -t -w 16 -l 16", "tifffile_uint8.tif", "tiffcp_uint8_tiles.tif")
tiffcp("-c zip:3 -t -w 16 -l 16", "tifffile_float32.tif", "tiffcp_float32_tiles.tif")
tiffcp("-c zip:3", "tifffile_float64.tif", "tiffcp_float64_deflate.tif")
tiffcp("-8 -c lzw", "tifffile_uint16.tif", "tiffcp_uint16_bigtiff.tif")


def exr(name, channels, corner=(0, 0)):
    """Scan lines without compression, by the layout of "OpenEXR File Layout" (openexr.com)."""
    types = {np.uint32: 0, np.float16: 1, np.float32: 2}
    box = struct.pack("<4i", corner[0], corner[1], corner[0] + cols - 1, corner[1] + rows - 1)

    def attribute(key, kind, value):
        return key.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(value)) + value

    listed = b"".join(key.encode() + b"\0" + struct.pack("<i4B2i", types[v.dtype.type], 0, 0, 0, 0, 1, 1)
                      for key, v in sorted(channels.items()))
    header = (struct.pack("<2i", 20000630, 2) + attribute("channels", "chlist", listed + b"\0")
              + attribute("compression", "compression", b"\0") + attribute("dataWindow", "box2i", box)
              + attribute("displayWindow", "box2i", box) + attribute("lineOrder", "lineOrder", b"\0")
              + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
              + attribute("screenWindowCenter", "v2f", struct.pack("<2f", 0, 0))
              + attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0")
    lines = [b"".join(v[i].tobytes() for _, v in sorted(channels.items())) for i in range(rows)]
    first = len(header) + 8 * rows
    offsets = [first + sum(8 + len(line) for line in lines[:i]) for i in range(rows)]
    (here / name).write_bytes(header + struct.pack(f"<{rows}Q", *offsets) + b"".join(
        struct.pack("<2i", corner[1] + i, len(line)) + line for i, line in enumerate(lines)))


def exr_tool(*command):
    subprocess.run([str(word) for word in command], check=True)


# Halves as floats are half zeros, so that there is something to compress.
exr("scratch.exr", {"Z": fields["float16"].astype(np.float32)}, corner=(-3, 40))
exr_tool("exrmaketiled", "-t", 16, 8, "-z", "zip", here / "scratch.exr", here / "exrmaketiled_zip.exr")
exr_tool("exrmaketiled", "-t", 32, 32, "-z", "piz", here / "scratch.exr", here / "exrmaketiled_piz.exr")
exr_tool("exrmaketiled", "-m", "-t", 8, 4, here / "scratch.exr", here / "exrmaketiled_mipmap.exr")
exr("scratch.exr", {"Z": fields["float32"]}, corner=(-3, 40))
exr_tool("exrstdattr", "-owner", "grating", here / "scratch.exr", here / "exrstdattr_float32.exr")
exr("scratch.exr", {"R": fields["float16"], "Y": fields["float32"], "code": fields["uint32"]})
exr_tool("exrstdattr", "-owner", "grating", here / "scratch.exr", here / "exrstdattr_channels.exr")
exr_tool("exrmultipart", "-combine", "-i", f"{here / 'scratch.exr'}:0", here / "exrstdattr_channels.exr",
         "-o", here / "exrmultipart_two.exr")
(here / "scratch.exr").unlink()


def x3p(name, values, kind, z_increment, valid=None, compression=zipfile.ZIP_DEFLATED):
    """A matrix surface by ISO 25178-72: steps of 0.5 and 0.25 um, heights in metres."""
    data = values.tobytes()
    link = f"""<DataLink><PointDataLink>bindata/data.bin</PointDataLink>
<MD5ChecksumPointData>{hashlib.md5(data).hexdigest().upper()}</MD5ChecksumPointData>"""
    if valid is not None:
        bits = np.packbits(valid.ravel(), bitorder="little").tobytes()
        link += f"""<ValidPointsLink>bindata/valid.bin</ValidPointsLink>
<MD5ChecksumValidPoints>{hashlib.md5(bits).hexdigest()}</MD5ChecksumValidPoints>"""
    xml = f"""<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">
<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>
<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>5e-7</Increment><Offset>0</Offset></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>2.5e-7</Increment><Offset>0</Offset></CY>
<CZ><AxisType>A</AxisType><DataType>{kind}</DataType><Increment>{z_increment}</Increment><Offset>0</Offset></CZ>
</Axes></Record1>
<Record3><MatrixDimension><SizeX>{cols}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
{link}</DataLink></Record3>
<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>
</p:ISO5436_2>
""".encode()
    with zipfile.ZipFile(here / name, "w", compression) as archive:
        archive.writestr("main.xml", xml)
        archive.writestr("bindata/data.bin", data)
        if valid is not None:
            archive.writestr("bindata/valid.bin", bits)
        archive.writestr("md5checksum.hex", f"{hashlib.md5(xml).hexdigest()} *main.xml\n")


def sdf(name, values, kind):
    """Binary by ISO 25178-71, steps of 0.5 and 0.25 um; without a compression or a check sum."""
    (here / name).write_bytes(
        struct.pack("<8s10s12s12s2H4d3B", b"bBCR-1.0", b"numpy     ", b"290120260000", b"290120260000",
                    cols, rows, 5e-7, 2.5e-7, 1e-9, -1, 0, kind, 0) + values.tobytes())


for kind, name in enumerate(("uint8", "uint16", "uint32", "float32", "int8", "int16", "int32", "float64")):
    sdf(f"numpy_{name}.sdf", fields[name], kind)

holed = fields["float64"].copy()
holed[4, 2] = np.nan
x3p("zipfile_float64.x3p", holed, "D", 1)
x3p("zipfile_float32.x3p", fields["float32"], "F", 1, compression=zipfile.ZIP_STORED)
x3p("zipfile_int16.x3p", fields["int16"], "I", 1e-10, valid=(row != 4) | (col != 2))
x3p("zipfile_int32.x3p", fields["int32"], "L", 1e-16)
