#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a blender: plot.py OUT -> OUT/mixing.png and OUT/frames/0000.png, 0001.png, ... for a movie."""

import sys
from pathlib import Path

import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from view import MATERIAL, Run, small_grains  # noqa: E402

GRAINS = "RdYlBu_r"  # red: small grains, blue: large ones


def draw(path, time, x, C, vessel, reach):
    """From the front (what the glass shows) and from the side, cut through the middle."""
    figure, axes = plt.subplots(1, 2, figsize=(9, 4.5), layout="constrained")
    size = 4e4 / len(x)**(2 / 3)
    order = np.argsort(-x[:, 1])
    dots = axes[0].scatter(x[order, 0], x[order, 2], c=C[order], s=size, cmap=GRAINS, vmin=0, vmax=1, linewidths=0)
    axes[0].scatter(vessel[:, 0], vessel[:, 2], c="#9a9a9a", s=0.3, linewidths=0)
    wall_cut, cut = (np.abs(points[:, 1]) < 0.03 * reach for points in (vessel, x))
    axes[1].scatter(vessel[wall_cut, 0], vessel[wall_cut, 2], c="#9a9a9a", s=size, linewidths=0)
    axes[1].scatter(x[cut, 0], x[cut, 2], c=C[cut], s=size, cmap=GRAINS, vmin=0, vmax=1, linewidths=0)
    for axis, name in zip(axes, ("front", "cut in the middle")):
        axis.set(title=f"{name}, t = {time:.2f} s", xlabel="x (m)", ylabel="z (m)", aspect="equal",
                 xlim=(-reach, reach), ylim=(-reach, reach))
    figure.colorbar(dots, ax=axes, label="C of small grains", shrink=0.8)
    figure.savefig(path, dpi=100)
    plt.close(figure)


def main():
    out = Path(sys.argv[1])
    run = Run(out)
    (out / "frames").mkdir(exist_ok=True)
    reach = 1.05 * max(np.abs(frame.points).max() for frame in run)
    for k, frame in enumerate(run):
        grains, vessel = frame.material, frame.where(frame["body"] != MATERIAL).points
        draw(out / f"frames/{k:04d}.png", frame.time, grains.points, small_grains(grains), vessel, reach)
    history = np.genfromtxt(out / "history.csv", delimiter=",", names=True)
    figure, axes = plt.subplots(2, 1, figsize=(7, 6), sharex=True, layout="constrained")
    axes[0].plot(history["turns"], history["lacey"], label="Lacey index of samples")
    axes[0].plot(history["turns"], history["intensity"], label="intensity of segregation of particles")
    axes[0].plot(history["turns"], history["neighbours"], label="unlike neighbours")
    axes[0].plot(history["turns"], history["doucet"], label="index of Doucet")
    axes[0].set(ylim=(0, 1.05))
    axes[0].legend(frameon=False)
    axes[1].plot(history["turns"], history["torque_N_m"])
    axes[1].set(xlabel="turns", ylabel="torque (N m)")
    figure.savefig(out / "mixing.png", dpi=100)


try:
    main()
except FileNotFoundError as error:
    sys.exit(f"plot.py: {error}")
