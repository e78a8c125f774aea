#!/usr/bin/python3
"""Writes the files of README.md that NumPy makes, into this folder."""
import os

import numpy

os.chdir(os.path.dirname(os.path.abspath(__file__)))
heights = numpy.loadtxt("heights.csv", delimiter=",")
codes = numpy.round(heights * 1e11).astype("<i2")


def save(name, array, version=(1, 0)):
    with open(name, "wb") as file:
        numpy.lib.format.write_array(file, array, version=version)


save("numpy_f8.npy", heights)
save("numpy_f4.npy", heights.astype("<f4"))
save("numpy_big_f8.npy", heights.astype(">f8"))
save("numpy_big_f4.npy", heights.astype(">f4"))
save("numpy_fortran.npy", numpy.asfortranarray(heights))
save("numpy_version2.npy", heights, (2, 0))
save("numpy_version3.npy", heights, (3, 0))
save("numpy_i2.npy", codes)
save("numpy_big_u2.npy", (codes.astype("i4") + 32768).astype(">u2"))
save("numpy_u1.npy", (numpy.arange(35) * 7 % 256).astype("u1").reshape(5, 7))
save("numpy_i8.npy", codes.astype("<i8"))
numpy.savetxt("codes.csv", codes, fmt="%d", delimiter=",")
