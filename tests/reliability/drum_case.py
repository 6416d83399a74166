# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A coarse rotating drum of a second or less, and the comparison of its results bit by bit."""
import hashlib
import shutil

import h5py
import numpy

import programs

EVERY_STEP = 1e-9  # s of the clock on the wall between checkpoints
NEVER = 1e6

COARSE = {
    "numerics.spacing": 2e-3,
    "output.history_interval": 0.004,
    "output.frame_interval": 0.01,
    "output.profile_times": [0.01, 0.02],
    "output.profile_average": 0.004,
    "output.checkpoints": EVERY_STEP,
    "time.duration": 0.02,
}
IN_SPACE = {"numerics.dimension": 3, "numerics.spacing": 3e-3, "geometry.length": 0.018, "time.duration": 0.01,
            "output.profile_times": [0.01], "output.frame_interval": 0.005}
FLOAT = {"numerics.precision": '"float"'}


def command(context, output, settings=None, flags=()):
    words = [context.program("drum"), "--output", output, "--quiet", *flags]
    for key, value in {**COARSE, **(settings or {})}.items():
        words += ["--set", f"{key}={value}"]
    return words


def continued(context, checkpoint, output, settings=None, flags=()):
    return command(context, output, {**(settings or {}), "output.restart_from": f'"{checkpoint}"'}, flags)


def state_in(checkpoint):
    """All that a run goes on from, by name, as bytes. Notes (the case as text) are left out."""
    with h5py.File(checkpoint, "r") as file:
        found = {name: numpy.asarray(file[name]).tobytes() for name in ("time", "steps", "counters")}
        found["signature"] = bytes(numpy.asarray(file["signature"]))
        file["arrays"].visititems(lambda name, item: found.update({name: numpy.asarray(item).tobytes()})
                                  if isinstance(item, h5py.Dataset) and name != "recorder" else None)
        return found


def steps_in(checkpoint):
    with h5py.File(checkpoint, "r") as file:
        return int(file["steps"][0])


def tables_in(folder):
    """The tables without their column of the clock on the wall."""
    found = {}
    for table in sorted(folder.glob("*.csv")):
        rows = [line.split(",") for line in table.read_text().splitlines()]
        kept = [k for k, name in enumerate(rows[0]) if "wall" not in name or "seconds" not in name]
        found[table.name] = "\n".join(",".join(row[k] for k in kept) for row in rows).encode()
    return found


def frames_in(folder):
    found = {}
    with h5py.File(folder / "particles.vtkhdf", "r") as file:
        file["VTKHDF"].visititems(lambda name, item: found.update({"frames/" + name: numpy.asarray(item).tobytes()})
                                  if isinstance(item, h5py.Dataset) else None)
    return found


def results_in(folder):
    """Tables, frames and the last checkpoint of a run, by name, as bytes."""
    return {**state_in(folder / "checkpoint.h5"), **tables_in(folder), **frames_in(folder)}


def differences(one, other):
    return sorted(name for name in one.keys() | other.keys() if one.get(name) != other.get(name))


def digest(results):
    sums = hashlib.sha256()
    for name in sorted(results):
        sums.update(name.encode() + b"\0" + results[name])
    return sums.hexdigest()


def bytes_in(folder):
    """All files of a folder as they are."""
    return {path.name: path.read_bytes() for path in folder.iterdir() if path.is_file() and path.name != ".lock"}


def whole_run(context, settings=None, threads=1):
    """Runs the case to its end; the folder of its results."""
    folder = context.folder()
    outcome = programs.run(command(context, folder, settings), threads)
    if outcome.code != 0:
        raise SystemExit(f"the case itself fails with code {outcome.code}: {outcome.err}")
    return folder


def copy_of(context, folder):
    copied = context.folder()
    shutil.copytree(folder, copied)
    return copied
