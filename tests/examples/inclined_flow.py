#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A short flow of few rows: inclined_flow.py PROGRAM CASE_FILE"""
import json
import pathlib
import tempfile

from case_program import check, check_packing, run, table

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    run(folder, "numerics.rows=10", "output.duration=0.5")
    found, history = json.loads((folder / "out/summary.json").read_text()), table(folder / "out/history.csv")
    check(found["particles"] == 100 and found["lost"] == 0, "the layer keeps its grains")
    check_packing(found)
    check(history["mean_velocity_ratio"][-1] == found["mean_velocity_ratio"], "the summary has the last row of the table")
    ratio = history["mean_velocity_ratio"]
    check(abs(ratio[0] - 0.7) < 0.01 and all(b > a for a, b in zip(ratio, ratio[1:])), f"the flow gains speed: {ratio}")
