#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a silo: plot.py OUT -> OUT/silo.png, four states, the discharge and the grains that come out."""

import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from view import Run, small_grains  # noqa: E402

GRAINS = "RdYlBu_r"  # red: small grains, blue: large ones


def main():
    out = Path(sys.argv[1])
    run = Run(out)
    figure, axes = plt.subplots(1, 6, figsize=(18, 4), layout="constrained")
    for axis, part in zip(axes, (0, 0.2, 0.4, 0.6)):
        frame = run[round(part * (len(run) - 1))]
        x, C, body = frame.points, small_grains(frame), frame.scalar("body")
        near = np.abs(x[:, 1] - np.median(x[body == 0, 1])) < 0.1 * np.ptp(x[:, 0])  # a slice in 3D
        sand, wall = near & (body == 0), near & (body != 0)
        axis.scatter(x[wall, 0], x[wall, 2], c="0.6", s=2, linewidths=0)
        axis.scatter(x[sand, 0], x[sand, 2], c=C[sand], s=3, cmap=GRAINS, vmin=0, vmax=1, linewidths=0)
        axis.set(title=f"t = {frame.time:.2f} s", aspect="equal", xticks=[], yticks=[],
                 ylim=(-0.3 * np.ptp(x[:, 0]), run[0].points[:, 2].max()))
    history = np.genfromtxt(out / "history.csv", delimiter=",", names=True)
    axes[4].plot(history["time_s"], history["beverloo"])
    axes[4].set(xlabel="time (s)", title="rate over Beverloo's scale")
    if "C_out" in history.dtype.names:
        axes[5].plot(history["time_s"], history["C_out"], label="out")
        axes[5].plot(history["time_s"], history["C_in"], label="in the silo")
        axes[5].set(title="C of small grains")
    else:
        for name in (name for name in history.dtype.names if name.endswith("_out") and name.startswith("C")):
            axes[5].plot(history["time_s"], history[name], label=name.removesuffix("_out"))
        axes[5].set(title="each size in what comes out")
    axes[5].set(xlabel="time (s)", ylim=(-0.02, 1.02))
    axes[5].legend(frameon=False)
    figure.savefig(out / "silo.png", dpi=100)


try:
    main()
except FileNotFoundError as error:
    sys.exit(f"plot.py: {error}")
