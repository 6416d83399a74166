# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the tests of case programs share: PROGRAM and CASE from the command line, runs, checks and tables."""
import csv
import pathlib
import subprocess
import sys

try:
    import h5py
except ImportError:
    h5py = None

PROGRAM, CASE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
# In names of what clocks measured, and of what a continued run does once more.
CLOCKS = ("second", "microseconds_per_step", "wall time", "neighbour_builds")


def check(holds, text):
    print(("" if holds else "FAILED: ") + text)
    if not holds:
        raise SystemExit(1)


def run(folder, *settings, code=0, case=CASE, output="out"):
    """Runs the case in a folder, with its results in `output`; returns what the program said."""
    command = [PROGRAM, case, "--force", "--output", output] + [part for each in settings for part in ("--set", each)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    check(done.returncode == code, f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def table(path):
    """Columns by name, without units."""
    with open(path, encoding="utf8") as file:
        rows = list(csv.reader(file))
    return {name.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}


def check_packing(summary):
    """The grains under pressure fill the space that they take, within the bounds of the warning of a run."""
    loosest, median, densest = (summary[name] for name in ("packing_loosest", "packing", "packing_densest"))
    check(0.85 < median < 1.1 and 0.5 < loosest < median < densest < 1.5, f"packing {median:.3f}, {loosest:.3f} to {densest:.3f}")


def arrays_in(path):
    """All that an HDF5 file holds, by name, as bytes: the file itself has the times at which its parts were written."""
    found = {}

    def keep(name, item):
        found.update({f"{name}@{key}": bytes(value) for key, value in item.attrs.items() if hasattr(value, "tobytes")})
        if isinstance(item, h5py.Dataset) and item.dtype.kind not in "OSV":
            found[name] = item[...].tobytes()
    with h5py.File(path, "r") as file:
        file.visititems(keep)
    return found


def without_clock(path):
    """The contents of a file, without what clocks measured."""
    if path.suffix == ".json":
        return [line for line in path.read_text().splitlines() if not any(clock in line for clock in CLOCKS)]
    if path.suffix == ".csv":
        rows = list(csv.reader(path.read_text().splitlines()))
        kept = [k for k, name in enumerate(rows[0]) if "wall" not in name]
        return [[row[k] for k in kept] for row in rows]
    if path.suffix in (".h5", ".vtkhdf"):
        return arrays_in(path) if h5py else path.stat().st_size
    return path.read_bytes()


def check_restart(folder, names, whole, half):
    """A run that goes on from the checkpoint of one with the settings `half` leaves the same files as the whole one."""
    run(folder, *whole, output="whole")
    run(folder, *whole, *half, output="half")
    run(folder, *whole, 'output.restart_from="half/checkpoint.h5"', output="rest")
    for name in names:
        same = (folder / "whole" / name).read_bytes() == (folder / "rest" / name).read_bytes()
        check(same, f"{name}: the continued run leaves the bytes of the whole one")
    check((folder / "half" / names[0]).read_bytes() != (folder / "whole" / names[0]).read_bytes(), "half of it does not")
