#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Writes the inside of a funnel as an STL file in millimetres, as a CAD program would: vessel.py FILE"""
import math
import sys

AROUND = 48
RINGS = [(20, 0), (20, 10), (50, 60), (50, 100)]  # radius and height, mm


def point(radius, height, k):
    angle = 2 * math.pi * k / AROUND
    return radius * math.cos(angle), radius * math.sin(angle), height


def triangles():
    for k in range(AROUND):
        yield (0, 0, 0), point(*RINGS[0], k + 1), point(*RINGS[0], k)
        for low, high in zip(RINGS, RINGS[1:]):
            a, b, c, d = point(*low, k), point(*low, k + 1), point(*high, k + 1), point(*high, k)
            yield a, b, c
            yield a, c, d
        yield (0, 0, RINGS[-1][1]), point(*RINGS[-1], k), point(*RINGS[-1], k + 1)


with open(sys.argv[1], "w", encoding="ascii") as file:
    file.write("solid vessel\n")
    for corners in triangles():
        file.write("facet normal 0 0 0\nouter loop\n")
        for x, y, z in corners:
            file.write(f"vertex {x:.9g} {y:.9g} {z:.9g}\n")
        file.write("endloop\nendfacet\n")
    file.write("endsolid vessel\n")
