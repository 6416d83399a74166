#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws runs of inclined_flow: profiles beside the exact one, and how they settle. plot.py OUT... -> OUT[0]/profiles.png"""

import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
from view import Run  # noqa: E402


def main():
    figure, (profiles, history) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for number, out in enumerate(map(Path, sys.argv[1:])):
        summary = json.loads((out / "summary.json").read_text())
        colour, name = f"C{number}", f"{summary['angle']:g} degrees, {summary['rows']} rows"
        tables = Run(out).tables
        profile, times = tables["profile.csv"], tables["history.csv"]
        profiles.plot(profile["velocity"], profile["height"], "o", ms=4, mfc="none", color=colour, label=name)
        profiles.plot(profile["exact_velocity"], profile["height"], "-", lw=1, color=colour)
        history.plot(times["time"] / summary["settling_time"], times["mean_velocity_ratio"], "o-", ms=3, color=colour)
    profiles.set(xlabel="velocity (m/s); lines: Bagnold", ylabel="height/H")
    profiles.legend(frameon=False)
    history.axhline(1, color="grey", lw=0.8)
    history.set(xlabel="time/settling time", ylabel="mean velocity/exact")
    figure.savefig(Path(sys.argv[1]) / "profiles.png", dpi=100)


try:
    main()
except FileNotFoundError as error:
    sys.exit(f"plot.py: {error}")
