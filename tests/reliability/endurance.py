# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R10, R15, R16: long runs of the coarse drum, and the same run by other builds and in single precision."""
import csv
import json
import pathlib

import drum_case
import programs
from tally import Tally

LONG = {"output.history_interval": 0.05, "output.frame_interval": 1e5, "output.profile_times": "[]",
        "output.checkpoints": 600}
TIME_OF_A_STEP = 1.26e-4  # s, of the coarse drum; about


def ended_run(context, program, settings):
    folder = context.folder()
    words = drum_case.command(context, folder, settings)
    outcome = programs.run([program, *words[1:]], limit=None)
    if outcome.code != 0:
        raise SystemExit(f"the drum fails with code {outcome.code}: {outcome.err}")
    with open(folder / "history.csv", encoding="ascii") as file:
        rows = [{name.split(" [")[0]: float(value) for name, value in row.items()} for row in csv.DictReader(file)]
    return json.loads((folder / "summary.json").read_text()), rows


def conserved(context):
    """R15 and, of the same run, R10"""
    steps = context.arguments.steps or context.pick(5_000, 1_000_000)
    summary, rows = ended_run(context, context.program("drum"), {**LONG, "time.duration": steps * TIME_OF_A_STEP})
    drift = Tally("R15", "a long drum: mean C within 1e-12 of its start at each look, particles as many as at the start")
    lost = Tally("R10", "lost particles of the same run, counted at each look")
    for row in rows:
        drift.check(abs(row["C_mean"] - rows[0]["C_mean"]) <= 1e-12, f"{row['C_mean'] - rows[0]['C_mean']:.1e} at {row}")
        lost.check(row["lost"] == 0, f"{row['lost']} lost at {row}")
    drift.note(f"{summary['steps']} steps, {summary['particles']} particles, {summary['execution_space']}, "
               f"drift {summary['mean_C_drift']:.1e}, C in [{summary['min_C']:.3g}, {summary['max_C']:.3g}]")
    lost.note("the library's own ledger is not part of this table yet")
    return [drift, lost]


# The first hundredths of a second tell rounding from faults; later rounding grows, as in any flow of grains.
AGREE = {"double": 1e-9, "single precision": 1e-4}
COMPARED = ("C_mean", "C_min", "C_max", "number_density", "largest_radius", "largest_speed", "kinetic_energy", "centroid_x",
            "centroid_z")


def agreement(context):
    """R16"""
    tally = Tally("R16", "160 steps of the drum in single precision (each quantity at each time within 1e-4 of its largest) and "
                  "by another build in double (1e-9)")
    settings = {"output.checkpoints": drum_case.NEVER}
    program, other = context.program("drum"), context.arguments.other_build
    _, reference = ended_run(context, program, settings)
    runs = [("single precision", program, drum_case.FLOAT)]
    if other:
        there = pathlib.Path(other) / "examples" / "drum" / "drum"
        runs += [("double", there, {}), ("single precision", there, drum_case.FLOAT)]
    for precision, which, changed in runs:
        summary, rows = ended_run(context, which, {**settings, **changed})
        what = f"{precision}, {summary['execution_space']}"
        largest = 0.0
        for name in COMPARED:
            scale = max(abs(row[name]) for row in reference)
            error = max(abs(a[name] - b[name]) / scale for a, b in zip(rows, reference, strict=True))
            largest = max(largest, error)
            tally.check(error <= AGREE[precision], f"{what}: {name} differs by {error:.1e}")
        tally.note(f"{what}: {largest:.1e}")
    return tally


MEASURES = {"R15": conserved, "R16": agreement}
