#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the ground of the example: a gully of 32 degrees that bends, and a plain with a dam across half of it.

    ground.py FOLDER [cell in m]      writes FOLDER/ground.asc and FOLDER/release.asc
"""

import sys
from math import exp, pi, radians, sin, tan
from pathlib import Path

STEEP, FLAT, BEND = tan(radians(32)), tan(radians(2)), 300.0  # slopes; where the slope ends, m


def line(x):
    """The middle of the gully."""
    return 200 + 40 * sin(pi * min(x, BEND) / BEND)


def height(x, y):
    # Along x: 32 degrees, then over 120 m into a plain of 2 degrees.
    begin = BEND - 60
    part = min(max((x - begin) / 120, 0), 1)
    fall = STEEP * min(x, begin) + 120 * (STEEP * part - (STEEP - FLAT) * part**2 / 2) + FLAT * max(x - begin - 120, 0)
    # A gully across, 25 m deep, which fades out on the plain.
    gully = 25 * exp(-(((y - line(x)) / 50) ** 2)) * min(max((BEND + 60 - x) / 120, 0), 1)
    # A dam of 12 m on one side of the plain.
    dam = 12 * exp(-(((x - 430) / 15) ** 2)) / (1 + exp((y - 205) / 6))
    return 260 - fall - gully + dam


def depth(x, y):
    d = 12 * (1 - ((x - 70) / 45) ** 2 - ((y - line(x)) / 40) ** 2)
    return d if d > 0.5 else 0


def write(file, value, cell):
    """An ESRI ASCII grid, its first row in the north."""
    columns, rows = int(700 / cell + 0.5) + 1, int(400 / cell + 0.5) + 1
    head = f"ncols {columns}\nnrows {rows}\nxllcorner {500000 - cell / 2}\nyllcorner {4600000 - cell / 2}\ncellsize {cell}\n"
    lines = (" ".join(f"{value(i * cell, j * cell):.3f}" for i in range(columns)) for j in reversed(range(rows)))
    file.write_text(head + "NODATA_value -9999\n" + "\n".join(lines) + "\n")


def main():
    folder, cell = Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 5.0
    folder.mkdir(parents=True, exist_ok=True)
    write(folder / "ground.asc", height, cell)
    write(folder / "release.asc", depth, cell)


main()
