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

    five = ("numerics.spacing=0.003", "output.duration=0.6", "species.diameters=[1e-3, 0.8e-3, 0.6e-3, 0.5e-3, 0.4e-3]")
    run(folder, *five, "species.shares=[0.2, 0.2, 0.2, 0.2, 0.2]")
    found, t = json.loads((folder / "out/summary.json").read_text()), table(folder / "out/history.csv")
    print("five sizes:", {k: v for k, v in found.items() if k != "wall_seconds"})
    check(found["largest_error_of_a_size"] < 1e-5, "each size inside + outside is what there was")
    first = [o > 0 for o in t["mass_out"]].index(True)
    check(t["C1_out"][first] > 0.99, "the first of the list, which was below, comes out first")
    for where in ("in", "out"):
        off = [abs(sum(shares) - 1) for shares in zip(*(t[f"C{k}_{where}"] for k in range(1, 6))) if not math.isnan(shares[0])]
        check(len(off) > 10 and max(off) < 1e-10, f"the shares {where} add up to 1")
    check(all(abs(t[f"C{k}_in"][0] - 0.2) < 1e-12 for k in range(1, 6)), "layers have their shares at the start")
    message = run(folder, *five, "species.shares=[0.2, 0.2, 0.2, 0.2, 0.1]", code=2)
    check("species.shares: they add up to 0.9, not to 1" in message, "shares that do not add up are refused")
