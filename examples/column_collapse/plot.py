#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a collapse: the particles at four times and the final profile. plot.py OUT -> OUT/collapse.png"""

import json
import sys
from pathlib import Path

import matplotlib
import numpy as np
import tomllib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from view import MATERIAL, Run, pictures  # noqa: E402


def main():
    out = Path(sys.argv[1])
    case = tomllib.loads((out / "case.toml").read_text())
    summary = json.loads((out / "summary.json").read_text())
    L0, unit = case["geometry"]["width"], np.sqrt(case["geometry"]["aspect"] * case["geometry"]["width"] / 9.81)
    run = Run(out)
    chosen = [run[round(k * (len(run) - 1))] for k in (0, 0.15, 0.35, 1)]
    figure, axes = plt.subplots(5, 1, figsize=(8, 14), sharex=True, layout="constrained")
    limits = pictures.limits_of_run(run, "velocity")
    for axis, frame in zip(axes, chosen):
        x = frame.material.points
        distance = np.hypot(x[:, 0], x[:, 1]) if summary["dimension"] == 3 else x[:, 0]
        dots = axis.scatter(distance / L0, x[:, 2] / L0, c=frame.material.scalar("velocity"), s=3, cmap="viridis",
                            vmin=limits[0], vmax=limits[1], linewidths=0)
        if "body" in run.fields and summary["dimension"] == 2:
            wall = frame.where(frame["body"] != MATERIAL).points / L0
            axis.scatter(wall[:, 0], wall[:, 2], c=pictures.WALL_COLOUR, s=3, linewidths=0)
        axis.set(title=f"t = {frame.time / unit:.1f} sqrt(H0/g)", ylabel="z/L0", aspect="equal",
                 ylim=(-0.2, 1.05 * case["geometry"]["aspect"]))
    figure.colorbar(dots, ax=axes, label="speed (m/s)", shrink=0.5)
    axes[4].set_xlim(-0.3, 1.05 * run[-1].material.points[:, :2].max() / L0)
    profile = np.genfromtxt(out / "profile.csv", delimiter=",", names=True)
    axes[4].plot(profile["distance_over_L0"], profile["depth_over_L0"], "k-", label="final depth")
    axes[4].axhline(case["output"]["reading_depth"] * case["geometry"]["aspect"], color="grey", lw=0.8, ls="--",
                    label="reading depth")
    axes[4].axvspan(1 + summary["run_out_least"], 1 + summary["run_out_greatest"], color="tab:orange", alpha=0.3,
                    label="experiments")
    axes[4].axvline(1 + summary["run_out"], color="tab:red", lw=1, label="run-out")
    axes[4].set(xlabel="distance/L0", ylabel="depth/L0")
    axes[4].legend(frameon=False)
    figure.savefig(out / "collapse.png", dpi=100)


try:
    main()
except FileNotFoundError as error:
    sys.exit(f"plot.py: {error}")
