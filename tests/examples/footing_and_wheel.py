#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Coarse runs of the strip and of the wheel: footing_and_wheel.py PROGRAM FOLDER_OF_CASES"""
import json
import math
import pathlib
import tempfile

from case_program import CASE, check, check_packing, run, table


def found(folder, case, *settings):
    run(folder, *settings, case=CASE / case)
    summary = json.loads((folder / "out/summary.json").read_text())
    check_packing(summary)
    return summary


def strip(folder):
    coarse = ("numerics.spacing=0.1", "output.duration=2")
    clay = found(folder, "footing.toml", *coarse)
    ratio = clay["pressure"] / clay["bearing_capacity"]
    check(abs(clay["bearing_capacity"] - (2 + math.pi) * 1000) < 1e-6, "the exact pressure is (2 + pi) c")
    check(abs(ratio - 1) < 0.08, f"the strip breaks in at {ratio:.3f} of it")
    history = table(folder / "out/history.csv")
    check(all(abs(s - 0.02 * t) < 1e-9 for s, t in zip(history["sinkage"], history["time"])), "it sinks at the given speed")
    check(history["support"][2] < 0.5 * clay["support"], "the load grows with the settlement first")
    friction = found(folder, "footing.toml", *coarse, "soil.friction_angle=10")
    check(friction["pressure"] > 1.2 * clay["bearing_capacity"], "control: friction carries more")


def wheel(folder):
    load, radius, turning, friction = 100, 0.1, 2, math.tan(math.radians(35))
    runs = {}
    for slip in (-0.2, 0.3, None):
        given = () if slip is None else (f"wheel.slip={slip}",)
        w = runs[slip] = found(folder, "wheel.toml", "numerics.spacing=0.01", *given)
        print(slip, {k: v for k, v in w.items() if k != "wall_seconds"})
        check(abs(w["support"] / load - 1) < 0.03, "the soil carries the load")
        check(slip is None or abs(w["slip"] - slip) < 1e-9, "the slip is the given one")
        check(w["drawbar"] < friction * load, "the pull is below the limit of friction")
        check(w["torque"] > w["drawbar"] * radius, "the torque exceeds pull times radius")
        speed = (1 - w["slip"]) * turning * radius
        sunk = table(folder / "out/history.csv")["sinkage"]
        sinking = sunk[-1] - sunk[len(sunk) // 2]  # m/s, in the second half, which lasts 1 s
        power = w["torque"] * turning - w["drawbar"] * speed + load * sinking
        check(w["dissipated"] > 0, "the soil takes energy")
        check(abs(w["dissipated"] / power - 1) < 0.05, "torque x turning = pull x speed + load x rising + what the soil takes")
    towed, driving, free = runs[-0.2], runs[0.3], runs[None]
    check(towed["drawbar"] < 0 < driving["drawbar"], "a towed wheel is pulled, a driving one pulls")
    check(towed["torque"] < driving["torque"], "slip takes torque")
    check(driving["sinkage"] > towed["sinkage"], "slip lets the wheel sink")
    check(abs(free["drawbar"]) < 0.03 * load and 0 < free["slip"] < 0.3, f"without drawbar the slip is {free['slip']:.3f}")
    text = run(folder, "output.duration=4", case=CASE / "wheel.toml", code=2)
    check("output.duration" in text and "right side" in text, "a wheel that would leave the bed is refused")


def refused(folder):
    """A case that cannot begin leaves the results of an earlier run, though `run` says --force."""
    coarse = ("numerics.spacing=0.01", "output.duration=0.01")
    run(folder, *coarse, case=CASE / "wheel.toml")
    before = {file.name: file.read_bytes() for file in (folder / "out").iterdir()}
    check({"history.csv", "particles.vtkhdf", "summary.json", "case.toml"} <= before.keys(), "there are results")
    for setting, code, words in (("soil.young=1", 1, "would crush it"), ("bed.depth=0.001", 2, "bed.depth: less than numerics.spacing"),
                                 ("numerics.cfl=1e400", 2, "numerics.cfl: 1e400 is out of range")):
        text = run(folder, *coarse, setting, case=CASE / "wheel.toml", code=code)
        check(words in text and len(text.splitlines()) == 1, f"{setting} is refused: {text}")
        after = {file.name: file.read_bytes() for file in (folder / "out").iterdir()}
        check(after == before, "the earlier results are as they were")


with tempfile.TemporaryDirectory() as name:
    refused(pathlib.Path(name))
    strip(pathlib.Path(name))
    wheel(pathlib.Path(name))
