#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Coarse runs of the silo in the plane and in space: silo.py PROGRAM CASE_FILE"""
import json
import math
import pathlib
import tempfile

from case_program import check, run, table

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for dimension, settings in ((2, ("numerics.spacing=0.003", "output.duration=0.6")),
                                (3, ("numerics.spacing=0.008", "output.duration=0.25", "geometry.outlet=0.06"))):
        run(folder, f"numerics.dimension={dimension}", *settings)
        found, t = json.loads((folder / "out/summary.json").read_text()), table(folder / "out/history.csv")
        print(f"in {dimension}D:", {k: v for k, v in found.items() if k != "wall_seconds"})
        check(found["largest_error_of_mass"] < 1e-12, "mass in + mass out is that at the start")
        check(found["largest_error_of_small"] < 1e-5, "so is that of the small grains")
        check(all(o == 0 for time, o in zip(t["time"], t["mass_out"]) if time <= 0.1), "nothing leaves through the closed gate")
        check(found["removed"] > 20, "grains leave through the open one")
        check(t["C_out"][[o > 0 for o in t["mass_out"]].index(True)] < 0.01, "large grains, which were below, come out first")
        if dimension == 2:
            check(0.7 < found["beverloo"] < 1.4, "discharge within the range of Beverloo's coefficients in a plane")
            check(t["C_out"][-1] > 0.5, "the small ones of the top come in the funnel flow, before the large ones at the walls")
            check(not math.isnan(found["rate"]), "two fifths have left")
