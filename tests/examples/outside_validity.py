#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs that leave the validity of their model end with exit code 3 and say why: outside_validity.py PROGRAM CASE_FILE"""
import os
import pathlib
import subprocess
import sys
import tempfile

SHORT_DRUM = ["numerics.spacing=0.0035", "time.duration=1"]
TALL_COLUMN = ["geometry.aspect=5", "numerics.across=10", "output.duration=4"]
LAYER = ["numerics.rows=8", "output.duration=0.02", "output.interval=0.01"]

# Options, the exit code, and words of the message.
CASES = {
    "column_collapse": [
        (TALL_COLUMN, 0, ""),
        ([*TALL_COLUMN, "numerics.reach=6"], 3, "the distance beyond the walls (m) must be at most"),
    ],
    "inclined_flow": [
        (LAYER, 0, ""),
        ([*LAYER, "slope.diameter=1"], 2, "numerics.sound_speed"),
        ([*LAYER, "slope.depth=1000"], 2, "numerics.sound_speed"),
        ([*LAYER, "numerics.sound_speed=0.1"], 2, "strained by more than 5 % by its own weight"),
        ([*LAYER, "slope.angle=28"], 2, "slope.start"),
    ],
    "drum": [
        (["numerics.spacing=0.0035", "time.duration=0.1", "geometry.rotation_speed=100"], 0, ""),
        ([*SHORT_DRUM, "geometry.rotation_speed=100", "numerics.viscosity_speed=0", "numerics.cfl=1"], 3, ""),
        ([*SHORT_DRUM, "geometry.rotation_speed=100", "numerics.viscosity_speed=0"], 3, "number density"),
    ],
    "shear_box": [
        (["numerics.spacing=0.1", "output.reference_spacing=0.1", "time.periods=0.2", "model.kappa=1"], 0, ""),
    ],
}


def main():
    program, case = sys.argv[1:]
    failures = 0
    unset = {name: value for name, value in os.environ.items() if name != "OMP_PROC_BIND"}  # Kokkos must not warn of it
    for options, expected, words in CASES[pathlib.Path(program).stem]:
        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder) / "out"
            command = [program, case, "--output", str(out), "--quiet"]
            for option in options:
                command += ["--set", option]
            run = subprocess.run(command, capture_output=True, text=True, timeout=300, env=unset)
            good = run.returncode == expected and words in run.stderr and "OMP_PROC_BIND" not in run.stderr
            if expected == 3:  # what was written until then is kept, and there is no summary as of a run that ended
                good = good and "outside the validity of the model" in run.stderr
                good = good and (out / "particles.vtkhdf").exists() and not (out / "summary.json").exists()
                good = good and len((out / "history.csv").read_text().splitlines()) >= 1
            if expected == 2:
                good = good and not out.exists()
            if expected == 0:
                good = good and (out / "summary.json").exists()
            print(f"{'ok' if good else 'FAILED'} {' '.join(options)}: {run.returncode} {run.stderr.strip()}")
            failures += not good
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
