#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Table of shear box runs made by shear_box_gpu.sh: times, errors and differences between devices and precisions."""
import csv
import json
import pathlib
import sys

DEVICES = ("gpu_double", "gpu_float", "cpu_double")


def load(folder):
    """Summary and row means at the last compared time; None where a run is missing."""
    try:
        summary = json.loads((folder / "summary.json").read_text())
        rows = list(csv.DictReader((folder / "profiles.csv").open()))
    except OSError:
        return None
    last = max(float(row["time"]) for row in rows)
    means = [float(row["C_mean"]) for row in rows if float(row["time"]) == last]
    return summary, means


def largest_difference(a, b):
    return max(abs(x - y) for x, y in zip(a, b))


def main():
    folder = pathlib.Path(sys.argv[1])
    cases = sorted({tuple(run.name.split("_")[2:]) for run in folder.iterdir()}, key=lambda c: (c[0], -float(c[1])))
    print("| scheme | dr/H | particles | run | steps | seconds | M particle-steps/s | MAE width 80 T | mean C drift "
          "| min C | 1 - max C | largest difference to CPU |")
    print("|---|---|---|---|---|---|---|---|---|---|---|---|")
    for scheme, spacing in cases:
        runs = {device: load(folder / f"{device}_{scheme}_{spacing}") for device in DEVICES}
        for device in DEVICES:
            if runs[device] is None:
                print(f"| {scheme} | {spacing} | | {device} | failed | | | | | | | |")
                continue
            summary, means = runs[device]
            mae = next((c["mae_width"] for c in summary["compared"] if abs(c["time"] - 80) < 1e-6), float("nan"))
            difference = f"{largest_difference(means, runs['cpu_double'][1]):.1e}" if runs["cpu_double"] else "-"
            print(f"| {scheme} | {spacing} | {summary['particles']} | {device} | {summary['steps']} "
                  f"| {summary['wall_seconds']:.2f} | {summary['particle_steps_per_second'] / 1e6:.3f} | {mae:.2e} "
                  f"| {summary['mean_C_drift']:.1e} | {summary['min_C']:.1e} | {1 - summary['max_C']:.1e} | {difference} |")


if __name__ == "__main__":
    main()
