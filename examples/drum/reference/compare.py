#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints results of the example drum beside the grains of this folder: compare.py CASE RESULTS_DIR, e.g. compare.py ev OUT"""

import csv
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent


def table(path):
    with open(path, encoding="utf8", newline="") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0].split(" (")[0] for name in rows[0]]
    return [dict(zip(names, row)) for row in rows[1:]]


def column(rows, name):
    return np.array([float(row[name] or "nan") for row in rows])


def main():
    case, folder = sys.argv[1], Path(sys.argv[2])
    history = table(folder / "history.csv")
    time = column(history, "time")
    print("quantity,from,to,grains,standard_error,drum,within two")

    def line(name, start, end, mean, error, value):
        print(f"{name},{start:g},{end:g},{mean:.4g},{error:.1g},{value:.4g},{'yes' if abs(value - mean) <= 2 * error else 'no'}")

    for row in table(HERE / "summary.csv"):
        name, start, end = row["quantity"], float(row["from"]), float(row["to"])
        source = name.replace("_over_bed_depth", "")
        if row["case"] != case or source not in history[0] or "peak" in name:
            continue
        now = (time > start) & (time <= end)
        if not now.any():
            continue
        value = np.nanmean(column(history, source)[now])
        if source != name:
            value /= np.nanmean(column(history, "bed_depth")[now])
        line(name, start, end, float(row["mean"]), float(row["standard_error"]), value)

    for row in table(HERE / "segregation.csv"):
        at = float(row["time"])
        if row["case"] != case or at % 2 > 1e-9 and at != 13.75 or at == 0 or at > time[-1] + 0.1:
            continue
        k = np.argmin(np.abs(time - at))
        value = float(history[k]["intensity"])
        line("intensity (cells of 1 mm)", at, at, float(row["apart_1mm"]), float(row["apart_1mm_error"]), value)
        value = 1 - float(history[k]["lacey"])
        line("1 - lacey (cells of 3 mm)", at, at, float(row["apart_3mm"]), float(row["apart_3mm_error"]), value)

    grains = [row for row in table(HERE / "profiles.csv") if row["case"] == case]
    profiles = table(folder / "profiles.csv")
    times = sorted(set(column(profiles, "time")))
    for at in times:
        if at < 6 or at > 15:
            continue
        drum = [row for row in profiles if float(row["time"]) == at]
        depth, velocity, error = (column(grains, name) for name in ("depth", "velocity", "velocity_error"))
        other = np.interp(depth / 1e3, column(drum, "depth"), column(drum, "velocity"))
        apart = np.abs(other - velocity)
        within = (apart <= 2 * error).sum()
        print(f"velocity profile at {at:g} s: mean absolute difference {100 * apart.mean():.2f} cm/s, largest {100 * apart.max():.2f} cm/s "
              f"at {depth[apart.argmax()]:g} mm; {within} of {len(depth)} depths within two standard errors")


if __name__ == "__main__":
    main()
