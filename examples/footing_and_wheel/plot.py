#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws a strip, a wheel or a study of slips: plot.py OUT -> OUT/footing.png, OUT/wheel.png or OUT/slip.png"""

import json
import sys
from pathlib import Path

import matplotlib
import numpy as np
import tomllib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from view import Run  # noqa: E402


def read(out):
    case = tomllib.loads((out / "case.toml").read_text())
    return case, json.loads((out / "summary.json").read_text())


def table(file):
    found = np.genfromtxt(file, delimiter=",", names=True)
    return {name.split("_")[0]: found[name] for name in found.dtype.names}


def draw_state(axis, out, case, field, label, part=1.0):
    run = Run(out)
    frame = run[round(part * (len(run) - 1))]
    x, body = frame.points, frame.scalar("body")
    soil, value = body == 0, frame.scalar(field)
    size = 72 * axis.get_position().width * axis.figure.get_figwidth() / np.ptp(x[:, 0]) * case["numerics"]["spacing"]
    style = {"s": size**2, "linewidths": 0}
    axis.scatter(x[~soil, 0], x[~soil, 2], c="0.6", **style)
    picture = axis.scatter(x[soil, 0], x[soil, 2], c=value[soil], cmap="viridis", vmin=0,
                           vmax=np.percentile(value[soil], 99), **style)
    axis.figure.colorbar(picture, ax=axis, label=label, shrink=0.8)
    axis.set(aspect="equal", title=f"t = {frame.time:.2f} s", xlabel="m", ylabel="m")


def footing(out):
    case, found = read(out)
    history, width, cohesion = table(out / "history.csv"), case["strip"]["width"], case["soil"]["cohesion"]
    figure, (left, right) = plt.subplots(1, 2, figsize=(13, 4.5), layout="constrained", width_ratios=(2, 3))
    left.plot(100 * history["sinkage"] / width, history["support"] / width / cohesion, label="strip")
    if case["soil"]["friction_angle"] == 0:
        left.axhline(found["bearing_capacity"] / cohesion, color="k", ls="--", label="2 + pi (Prandtl 1920)")
    left.set(xlabel="settlement over width (%)", ylabel="mean pressure over cohesion", ylim=(0, None))
    left.legend(frameon=False)
    draw_state(right, out, case, "velocity", "speed (m/s)")
    figure.savefig(out / "footing.png", dpi=80)


def wheel(out):
    case, _ = read(out)
    history, load, radius = table(out / "history.csv"), case["wheel"]["load"], case["wheel"]["radius"]
    figure, axes = plt.subplot_mosaic([["state", "state"], ["force", "way"]], figsize=(12, 7), layout="constrained")
    draw_state(axes["state"], out, case, "pressure", "pressure (Pa)")
    time = history["time"]
    for name, scale, label in (("support", load, "support/W"), ("drawbar", load, "drawbar pull/W"),
                               ("torque", load * radius, "torque/(W r)")):
        axes["force"].plot(time, history[name] / scale, label=label, lw=1)
    axes["force"].set(xlabel="time (s)", ylim=(-0.6, 1.6))
    axes["way"].plot(time, 1e3 * history["sinkage"], label="sinkage (mm)")
    axes["way"].plot(time, 100 * history["travel"], label="travel (cm)")
    axes["way"].set(xlabel="time (s)")
    for name in ("force", "way"):
        axes[name].legend(frameon=False)
    figure.savefig(out / "wheel.png", dpi=80)


def study(out):
    case, free = read(out / "free")
    slips, load, radius = table(out / "slip.csv"), case["wheel"]["load"], case["wheel"]["radius"]
    runs = sorted(out.glob("slip_*"), key=lambda run: read(run)[1]["slip"])
    figure, axes = plt.subplot_mosaic([["pull", "sinkage"], ["low", "high"]], figsize=(12, 7), layout="constrained")
    axes["pull"].plot(slips["slip"], slips["drawbar"] / load, "o-", label="drawbar pull/W")
    axes["pull"].plot(slips["slip"], slips["torque"] / load / radius, "s-", label="torque/(W r)")
    axes["pull"].plot(free["slip"], 0, "k*", ms=12, label="without a drawbar")
    axes["pull"].axhline(np.tan(np.radians(case["soil"]["friction_angle"])), color="k", ls="--", lw=1, label="tan(phi)")
    axes["pull"].axhline(0, color="0.7", lw=0.8)
    axes["pull"].legend(frameon=False)
    axes["sinkage"].plot(slips["slip"], 1e3 * slips["sinkage"], "o-")
    axes["sinkage"].set(ylabel="sinkage (mm)")
    for name in ("pull", "sinkage"):
        axes[name].set(xlabel="slip")
    for name, run in (("low", runs[1]), ("high", runs[-1])):
        draw_state(axes[name], run, case, "pressure", "pressure (Pa)")
        axes[name].set(title=f"slip {round(read(run)[1]['slip'], 3) + 0:g}")
    figure.savefig(out / "slip.png", dpi=80)


def main():
    out = Path(sys.argv[1])
    if (out / "slip.csv").exists():
        study(out)
    elif read(out)[0]["body"]["tool"] == "strip":
        footing(out)
    else:
        wheel(out)


try:
    main()
except FileNotFoundError as error:
    sys.exit(f"plot.py: {error}")
