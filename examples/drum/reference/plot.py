#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws the tables of this folder, beside results of the example drum: plot.py OUTPUT_DIR [EV_RESULTS EN_RESULTS]"""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from compare import HERE, column, table


def maps(path):
    figure, axes = plt.subplots(1, 2, figsize=(9, 4), layout="constrained")
    for case, axis in zip(("ev", "en"), axes):
        rows = table(HERE / f"map_{case}.csv")
        x, z, C = (column(rows, name) for name in ("x", "z", "C"))
        grid = np.full((72, 72), np.nan)
        grid[np.round(z + 35.5).astype(int), np.round(x + 35.5).astype(int)] = C
        image = axis.imshow(grid, origin="lower", extent=(-36, 36, -36, 36), cmap="RdYlBu_r", vmin=0, vmax=1)
        axis.add_patch(plt.Circle((0, 0), 35, fill=False, color="0.4"))
        axis.set(title=f"{case.upper()}: share of small grains, 12 to 14 s", xlabel="x, mm", ylabel="z, mm")
    figure.colorbar(image, ax=axes, shrink=0.8)
    figure.savefig(path, dpi=90)


def curves(path, drums):
    figure, axes = plt.subplots(2, 2, figsize=(9, 6.5), layout="constrained")
    for case, (left, right) in zip(("ev", "en"), axes.T):
        rows = [row for row in table(HERE / "profiles.csv") if row["case"] == case]
        depth, velocity, error = (column(rows, name) for name in ("depth", "velocity", "velocity_error"))
        left.errorbar(depth, 100 * velocity, 200 * error, fmt="k.", markersize=3, label="grains, two standard errors")
        rows = [row for row in table(HERE / "segregation.csv") if row["case"] == case]
        right.errorbar(column(rows, "time"), column(rows, "apart_1mm"), 2 * column(rows, "apart_1mm_error"), fmt="k.", markersize=3)
        if case in drums:
            rows = [row for row in table(drums[case] / "profiles.csv") if float(row["time"]) == 10]
            left.plot(1e3 * column(rows, "depth"), 100 * column(rows, "velocity"), "r", label="example drum, 10 s")
            rows = [row for row in table(drums[case] / "history.csv") if float(row["time"]) < 14]
            right.plot(column(rows, "time"), column(rows, "intensity"), "r")
        left.set(title=case.upper(), xlabel="depth at mid-chord, mm", ylabel="velocity along the surface, cm/s")
        right.set(xlabel="time, s", ylabel="intensity of segregation")
        left.legend()
    figure.savefig(path, dpi=90)


def main():
    output = Path(sys.argv[1])
    maps(output / "maps.png")
    curves(output / "curves.png", dict(zip(("ev", "en"), map(Path, sys.argv[2:4]))))


if __name__ == "__main__":
    main()
