#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Coarse, short runs of the blender in both vessels that its script makes: blender.py PROGRAM CASE_FILE"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from case_program import CASE, check, check_restart, run, table

with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for vessel, volume, extra in (("v", 13.23e-3, 'segregation.start="halves"'), ("tote", 22.8e-3, "vessel.own_speed=5")):
        subprocess.run([sys.executable, CASE.parent / "vessel.py", vessel, folder / "vessel.stl"], check=True)
        spacing = 0.02 if vessel == "v" else 0.025
        run(folder, 'vessel.file="vessel.stl"', f"numerics.spacing={spacing}", "output.turns=0.04", "output.history=0.01",
            "output.frames=0.02", "output.sample=2", extra)
        found = json.loads((folder / "out/summary.json").read_text())
        history = table(folder / "out/history.csv")
        check(abs(found["vessel_volume"] / volume - 1) < 0.01, f"{vessel}: volume {found['vessel_volume']:.4g} m^3")
        check(abs(found["bed_volume"] / found["vessel_volume"] - 0.45) < 1e-3, "the bed fills 45 % of it")
        check(abs(found["drift_of_mean"]) < 1e-13, f"mean C drifts by {found['drift_of_mean']:.1e}")
        check(abs(history["mean"][0] - 0.5) < 2e-3, f"mean C {history['mean'][0]:.4f}")
        check(found["lost"] == 0, "no particle is lost")
        check(0 <= found["lacey_at_start"] < found["lacey"] + 0.2 <= 1.2, f"Lacey index {found['lacey']:.3f}")
        check(0.8 < found["intensity"] <= 1 + 1e-6, f"intensity {found['intensity']:.4f}")
        check(abs(history["along"][0]) > (0.04 if vessel == "v" else -1), f"halves apart by {history['along'][0]:.3f} m")
        rate = 15 * 2 * math.pi / 60
        if vessel == "v":
            check(all(abs(p - rate * t) < 1e-6 for p, t in zip(history["power"], history["torque"])),
                  "power is torque times angular velocity")
            # Before the bed yields, its weight has moved by the angle turned: an arm of a few centimetres.
            arm = history["torque"][-1] / (found["bed_volume"] * 1500 * 9.81)
            check(0.002 < arm < 0.1, f"torque over weight: {1e3 * arm:.1f} mm")
        check(max(history["speed"]) < 1.5, f"largest speed {max(history['speed']):.2f} m/s")
    subprocess.run([sys.executable, CASE.parent / "vessel.py", "tote", folder / "vessel.stl"], check=True)
    lines = (folder / "vessel.stl").read_text().splitlines()
    (folder / "sheet.stl").write_text("\n".join(lines[:1 + 7 * 8] + lines[-1:]))  # without its floor and its lid
    message = run(folder, 'vessel.file="sheet.stl"', code=1)
    check("sheet.stl" in message and "needs a closed one" in message, "a vessel without a lid is refused")

    # Three sizes: layers from below, in the order of the list.
    run(folder, 'vessel.file="vessel.stl"', "numerics.spacing=0.025", "output.turns=0.02", "output.history=0.01",
        "output.frames=0.02", "output.sample=2", "species.diameters=[2e-3, 1e-3, 1.5e-3]", "species.shares=[0.3, 0.5, 0.2]")
    found = json.loads((folder / "out/summary.json").read_text())
    check(abs(table(folder / "out/history.csv")["mean"][0] - 0.5) < 5e-3, "the mean is that of the smallest grains")
    check(abs(found["drift_of_mean"]) < 1e-13, f"it drifts by {found['drift_of_mean']:.1e}")
    check(0.8 < found["intensity_at_start"] <= 1 + 1e-12, f"apart at the start: intensity {found['intensity_at_start']:.3f}")
    check(found["lost"] == 0, "no particle is lost")

    coarse = ('vessel.file="vessel.stl"', "numerics.spacing=0.03", "output.turns=0.01", "output.history=0.0025",
              "output.frames=0.005", "output.sample=2")
    check_restart(folder, ["history.csv"], coarse, ("output.turns=0.005",))
    first, rest = (json.loads((folder / each / "summary.json").read_text()) for each in ("whole", "rest"))
    check(all(first[key] == rest[key] for key in first if "second" not in key), "the summaries are the same")
