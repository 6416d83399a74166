#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the inside of a blender as an STL file in millimetres: vessel.py v|tote FILE [size]

The blender turns about the x axis. `v`: two tubes of 200 mm that meet at 80 degrees, as two shells that overlap; 10.9
litres. `tote`: a bin of 300 x 300 mm with a hopper below, 18.3 litres. `size` scales all lengths."""
import math
import sys

AROUND = 96


def tube(middle, axis, radius, length):
    """A closed cylinder from `middle` along the unit vector `axis` of the x-z plane."""
    side = (axis[1], -axis[0])  # in the plane, and y

    def point(k, along):
        a = 2 * math.pi * k / AROUND
        s, y = radius * math.cos(a), radius * math.sin(a)
        return middle[0] + along * axis[0] + s * side[0], y, middle[1] + along * axis[1] + s * side[1]

    low, high = (middle[0], 0, middle[1]), (middle[0] + length * axis[0], 0, middle[1] + length * axis[1])
    for k in range(AROUND):
        a, b, c, d = point(k, 0), point(k + 1, 0), point(k + 1, length), point(k, length)
        yield from ((low, b, a), (high, d, c), (a, c, d), (a, b, c))


def v_blender():
    half, radius, length = math.radians(40), 100, 260
    # Each tube starts beyond the plane between both, so that they overlap; the axis goes through the middle of the V.
    for sign in (-1, 1):
        axis = (sign * math.sin(half), math.cos(half))
        start = (-sign * 40 * math.sin(half), -120)
        yield from tube(start, axis, radius, length)


def tote():
    rings = [(40, -160), (150, -40), (150, 160)]  # half the width and height
    corners = [[(sx * w, sy * w, z) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))] for w, z in rings]
    for low, high in zip(corners, corners[1:]):
        for k in range(4):
            a, b, c, d = low[k], low[(k + 1) % 4], high[(k + 1) % 4], high[k]
            yield from ((a, b, c), (a, c, d))
    a, b, c, d = corners[0]
    yield from ((a, c, b), (a, d, c))
    a, b, c, d = corners[-1]
    yield from ((a, b, c), (a, c, d))


kind, name, size = sys.argv[1], sys.argv[2], float(sys.argv[3]) if len(sys.argv) > 3 else 1.0
with open(name, "w", encoding="ascii") as file:
    file.write(f"solid {kind}\n")
    for triangle in {"v": v_blender, "tote": tote}[kind]():
        file.write("facet normal 0 0 0\nouter loop\n")
        for x, y, z in triangle:
            file.write(f"vertex {size * x:.9g} {size * y:.9g} {size * z:.9g}\n")
        file.write("endloop\nendfacet\n")
    file.write(f"endsolid {kind}\n")
