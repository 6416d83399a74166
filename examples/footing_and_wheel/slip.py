#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A wheel at several slips: one run each, and a table of their steady means.

    slip.py PROGRAM OUT [--set section.key=value ...]    OUT/slip_0.20/..., OUT/free/..., OUT/slip.csv

The run in OUT/free has no drawbar: the wheel finds its own slip.
"""
import csv
import json
import subprocess
import sys
from pathlib import Path

SLIPS = (-0.2, 0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8)
COLUMNS = {"slip": "", "drawbar": "N/m", "torque": "N m/m", "support": "N/m", "sinkage": "m", "dissipated": "W/m"}
CASE = Path(__file__).resolve().parent / "wheel.toml"


def run(program, out, settings):
    subprocess.run([program, CASE, "--output", out, "--force", "--quiet", *settings], check=True)
    return json.loads((out / "summary.json").read_text())


def main():
    program, out, settings = Path(sys.argv[1]).resolve(), Path(sys.argv[2]), sys.argv[3:]
    out.mkdir(parents=True, exist_ok=True)
    with open(out / "slip.csv", "w", encoding="utf8", newline="") as file:
        table = csv.writer(file)
        table.writerow([f"{name} [{unit}]" if unit else name for name, unit in COLUMNS.items()])
        for slip in SLIPS:
            found = run(program, out / f"slip_{slip:.2f}", [*settings, "--set", f"wheel.slip={slip}"])
            table.writerow([found[name] for name in COLUMNS])
            file.flush()
            print(f"slip {slip:5.2f}: drawbar pull {found['drawbar']:7.2f} N/m, torque {found['torque']:6.3f} N m/m, "
                  f"sinkage {1e3 * found['sinkage']:5.2f} mm", flush=True)
    free = run(program, out / "free", settings)
    print(f"without a drawbar: slip {free['slip']:.3f}, torque {free['torque']:.3f} N m/m")


main()
