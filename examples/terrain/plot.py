#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a run of terrain: the depth at six times over the ground, and how deep and when it came anywhere.

    plot.py OUT      from the folder of the rasters that OUT/case.toml names; writes OUT/terrain.png
"""

import sys
from pathlib import Path

import matplotlib
import numpy as np
import tomllib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.colors import LightSource  # noqa: E402


def corner_of(file):
    with open(file) as lines:
        head = dict(line.lower().split() for line in (next(lines) for _ in range(6)))
    return float(head["xllcorner"]), float(head["yllcorner"])


def read(file, corner):
    """Values with rows from south to north, their extent (m from a corner) for imshow, and the edge of a cell."""
    with open(file) as lines:
        head = dict(line.split() for line in (next(lines) for _ in range(6)))
        values = np.loadtxt(lines)[::-1]
    head = {key.lower(): float(value) for key, value in head.items()}
    values[values == head["nodata_value"]] = np.nan
    cell = head["cellsize"]
    x, y = head["xllcorner"] - corner[0], head["yllcorner"] - corner[1]
    return values, (x, x + cell * values.shape[1], y, y + cell * values.shape[0]), cell


def main():
    out = Path(sys.argv[1])
    case = tomllib.loads((out / "case.toml").read_text())
    corner = corner_of(case["ground"]["heights"])
    ground, extent, cell = read(case["ground"]["heights"], corner)
    shade = LightSource(315, 45).hillshade(ground, dx=cell, dy=cell)
    least = case["output"]["least"]
    maps = sorted(out.glob("depth_*.asc"))
    chosen = [maps[round(k * (len(maps) - 1))] for k in np.linspace(0, 1, 6)]
    figure, axes = plt.subplots(4, 2, figsize=(11, 13), layout="constrained")
    step = case["output"]["maps"]

    def draw(axis, values, where, title, label, **style):
        axis.imshow(shade, cmap="gray", extent=extent, origin="lower", vmin=-0.3, vmax=1)
        axis.contour(ground, 15, extent=extent, origin="lower", colors="k", linewidths=0.3, alpha=0.5)
        picture = axis.imshow(values, extent=where, origin="lower", **style)
        figure.colorbar(picture, ax=axis, label=label, shrink=0.8)
        axis.set(title=title, xlim=extent[:2], ylim=extent[2:])
        axis.set(xlabel="east (m)", ylabel="north (m)")

    deepest = np.nanmax(read(maps[0], corner)[0])
    for axis, file in zip(axes.flat, chosen):
        depth, where, _ = read(file, corner)
        draw(axis, np.where(depth > least, depth, np.nan), where, f"t = {int(file.stem[6:]) * step:g} s", "depth (m)",
             cmap="YlOrRd", vmin=0, vmax=deepest)
    depth, where, _ = read(out / "largest_depth.asc", corner)
    draw(axes[3, 0], np.where(depth > least, depth, np.nan), where, "greatest depth", "depth (m)", cmap="YlOrRd",
         vmin=0, vmax=deepest)
    arrival, where, _ = read(out / "arrival.asc", corner)
    draw(axes[3, 1], arrival, where, "arrival", "time (s)", cmap="viridis_r")
    figure.savefig(out / "terrain.png", dpi=80)


try:
    main()
except FileNotFoundError as error:
    sys.exit(f"plot.py: {error}")
