#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Makes the ground of the example: a gully of 32 degrees that bends, and a plain with a dam across half of it.

    ground.py FOLDER [cell in m]      writes FOLDER/ground.asc and FOLDER/release.asc
"""

import sys
from pathlib import Path

import numpy as np


def write(file, values, cell):
    """An ESRI ASCII grid; the rows of `values` run from south to north."""
    rows, columns = values.shape
    head = f"ncols {columns}\nnrows {rows}\nxllcorner {500000 - cell / 2}\nyllcorner {4600000 - cell / 2}\ncellsize {cell}\n"
    lines = (" ".join(f"{value:.3f}" for value in row) for row in values[::-1])
    file.write_text(head + "NODATA_value -9999\n" + "\n".join(lines) + "\n")


def main():
    folder, cell = Path(sys.argv[1]), float(sys.argv[2]) if len(sys.argv) > 2 else 5.0
    x, y = np.meshgrid(np.arange(0, 700 + cell / 2, cell), np.arange(0, 400 + cell / 2, cell))
    # Along x: 32 degrees, then over 120 m into a plain of 2 degrees.
    steep, flat, bend = np.tan(np.radians(32)), np.tan(np.radians(2)), 300.0
    part = np.clip((x - (bend - 60)) / 120, 0, 1)
    slope_integral = steep * np.minimum(x, bend - 60) + np.where(
        x > bend - 60, (steep * part - (steep - flat) * part**2 / 2) * 120 + flat * np.maximum(x - bend - 60, 0), 0)
    height = 260 - slope_integral
    # A gully across, 25 m deep, which fades out on the plain; its line bends.
    line = 200 + 40 * np.sin(np.pi * np.minimum(x, bend) / bend)
    height -= 25 * np.exp(-(((y - line) / 50) ** 2)) * np.clip((bend + 60 - x) / 120, 0, 1)
    # A dam of 12 m on one side of the plain.
    height += 12 * np.exp(-(((x - 430) / 15) ** 2)) / (1 + np.exp((y - 205) / 6))
    depth = 12 * (1 - ((x - 70) / 45) ** 2 - ((y - line) / 40) ** 2)
    folder.mkdir(parents=True, exist_ok=True)
    write(folder / "ground.asc", height, cell)
    write(folder / "release.asc", np.where(depth > 0.5, depth, 0), cell)


main()
