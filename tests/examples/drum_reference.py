#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The grains of the drum: what evaluate.py measures in a bed that is known, a short run of the program, the published tables:
drum_reference.py PROGRAM EXAMPLES/drum/reference. Ends with 77, skipped, where numpy is missing."""

import csv
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: this Python has no numpy")
    sys.exit(77)

PROGRAM, FOLDER = Path(sys.argv[1]), Path(sys.argv[2])
sys.path.insert(0, str(FOLDER))
sys.dont_write_bytecode = True
import evaluate  # noqa: E402

RADIUS, LENGTH, OMEGA = 0.035, 0.003, np.pi / 6
faults = []


def expect(what, value, wanted, tolerance):
    if not abs(value - wanted) <= tolerance:
        faults.append(f"{what}: {value} instead of {wanted} +- {tolerance}")


def table(path):
    with open(path, encoding="utf8", newline="") as file:
        rows = list(csv.reader(file))
    return [dict(zip([name.split(" (")[0] for name in rows[0]], row)) for row in rows[1:]]


def write_known_bed(folder, angle, depth, share, layer=0.007, top=0.08):
    """Two seeds of a bed of a flat surface; small grains are more by 0.1 below 10 mm, the speed falls linearly in a layer."""
    n, cell, fine = 144, 0.5e-3, 5
    along = (np.arange(n * fine) - n * fine / 2 + 0.5) * cell / fine
    x, z = np.meshgrid(along, along)
    below = depth - RADIUS - (np.sin(angle) * x + np.cos(angle) * z)
    solid = np.where((below > 0) & (np.hypot(x, z) < RADIUS), 0.6, 0) * (cell / fine) ** 2 * LENGTH
    speed = np.where(below < layer, top * (1 - below / layer), 0) + OMEGA * (depth - RADIUS - below)
    C = np.where(below > 0.01, share + 0.1, share)
    u, w = speed * np.cos(angle), -speed * np.sin(angle)
    fields = [solid * (1 - C), solid * C, solid * (1 - C) * u, solid * C * u, solid * (1 - C) * w, solid * C * w, solid * speed**2]
    coarse = np.array([f.reshape(n, fine, n, fine).sum((1, 3)) for f in fields])
    windows = np.stack([coarse, coarse])[None].astype(np.float32)
    windows.tofile(folder / "windows.f32")
    apart = np.zeros((2, 2, 2, 72, 72), np.float32)  # at the first time mixed, at the second one apart
    blocks = coarse[:2].reshape(2, 72, 2, 72, 2).sum((2, 4))
    total = blocks.sum(0)
    apart[0, :, 0], apart[0, :, 1] = 0.5 * total, 0.5 * total
    left = np.arange(72) < 36
    apart[1, :, 0], apart[1, :, 1] = total * left, total * ~left
    apart.tofile(folder / "frames.f32")
    (folder / "windows.csv").write_text("from (s),to (s),samples\n6,14,10\n", encoding="utf8")
    about = f"replicas ev:1 ev:2\nacross {n} 72\nradius {RADIUS}\nlength {LENGTH}\nrpm 5\n"
    (folder / "about.txt").write_text(about, encoding="utf8")


def known_bed():
    for degrees, depth in ((22, 0.0294), (25, 0.0413)):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_known_bed(folder, np.radians(degrees), depth, 0.4)
            run = evaluate.Run(folder)
            numbers, depths, rows = evaluate.profile(run.mean(0, 6, 14), run)
            expect("angle", numbers["angle"], degrees, 0.1)
            expect("bed depth", numbers["bed_depth"], depth, 0.1e-3)
            expect("surface speed", numbers["surface_speed"], 0.08 * (1 - 0.5 / 7) + OMEGA * (depth - RADIUS - 0.5e-3), 0.001)
            expect("packing", numbers["packing"], 0.6, 1e-3)
            inside = (depths > 1e-3) & (depths < depth - 2e-3)
            wanted = np.where(depths < 0.007, 0.08 * (1 - depths / 0.007), 0) + OMEGA * (depth - RADIUS - depths)
            expect("velocity profile", np.abs(rows["velocity"] - wanted)[inside].max(), 0, 0.0012)
            expect("C above", rows["C"][(depths > 1e-3) & (depths < 9e-3)].mean(), 0.4, 1e-3)
            expect("C below", rows["C"][(depths > 11e-3) & (depths < depth - 2e-3)].mean(), 0.5, 1e-3)
            expect("shear rate", rows["shear_rate"][(depths > 2e-3) & (depths < 5e-3)].mean(), 0.08 / 0.007 + OMEGA, 0.2)
            expect("edge of the layer over D", numbers["active_depth_over_bed_depth"], 0.95 * 0.007 / depth, 0.01)
            expect("mixed", evaluate.mixing(run.frames[0, 0], LENGTH, 1)[1], 0, 1e-6)
            expect("apart", evaluate.mixing(run.frames[1, 0], LENGTH, 1)[1], 1, 1e-6)
            expect("apart, over that of random mixing", evaluate.mixing(run.frames[1, 0], LENGTH, 2)[0], 1, 1e-6)
            (folder / "out").mkdir()
            evaluate.evaluate(run, folder / "out", 6, 6)
            rows = table(folder / "out" / "summary.csv")
            expect("standard error of equal seeds", float(rows[0]["standard_error"]), 0, 1e-9)
    # grains drawn one by one: mixed at random, though their cells differ
    dice = np.random.default_rng(1)
    solid = 1.8e-9 / 2
    drawn = np.array([dice.poisson(solid / evaluate.VOLUME[kind], (72, 72)) * evaluate.VOLUME[kind] for kind in (0, 1)])
    expect("mixed at random", evaluate.mixing(drawn, LENGTH, 1)[0], 0, 0.004)
    expect("mixed at random, with the differences by chance", evaluate.mixing(drawn, LENGTH, 1)[1], 0.0205, 0.003)
    mean, error = evaluate.mean_and_error([1.0, 2.0, 6.0])
    expect("mean", mean, 3, 1e-12)
    expect("standard error", error, np.sqrt(7 / 3), 1e-12)


def short_run():
    with tempfile.TemporaryDirectory() as name:
        small = ["radius=0.003", "length=0.0025", "settle=0.02", "time=0.02", "sample=0.002", "frame=0.01", "window=0.01"]
        done = subprocess.run([PROGRAM, "ev=1,2", f"output={name}", *small], capture_output=True, text=True, check=False)
        expect("exit code", done.returncode, 0, 0)
        run = evaluate.Run(Path(name))
        expect("windows", len(run.windows), 2, 0)
        expect("frames", len(run.frames), 3, 0)
        to_chord = 0.16 * 0.003
        segment = 0.003**2 * np.arccos(0.16) - to_chord * np.sqrt(0.003**2 - to_chord**2)
        for replica in (0, 1):
            large, small_ones = run.mean(replica, 0, 0.02)[:2].sum((1, 2))
            expect("solid of a replica over the filling", (large + small_ones) / (0.6 * segment * 0.0025), 1, 0.01)
            expect("share of small grains", small_ones / (large + small_ones), 0.5, 0.01)
        if np.array_equal(run.fields[0, 0], run.fields[0, 1]):
            faults.append("two seeds gave the same bed")
        for wrong, message in (("ev=x", "seed"), ("en=1.5", "seed"), ("step=-1", "step"), ("speed=3", "unknown argument")):
            done = subprocess.run([PROGRAM, wrong, f"output={name}"], capture_output=True, text=True, check=False)
            if done.returncode != 1 or message not in done.stderr:
                faults.append(f"{wrong}: exit code {done.returncode}, {done.stderr}")


def published():
    rows = table(FOLDER / "summary.csv")
    for case, share in (("ev", 0.5), ("en", 1 / 9)):
        of_case = {row["quantity"]: float(row["mean"]) for row in rows if row["case"] == case}
        expect(f"angle of {case}", of_case["angle"], 22.5, 3)
        cells = table(FOLDER / f"map_{case}.csv")
        solid = np.array([float(row["packing"]) for row in cells])
        C = np.array([float(row["C"]) for row in cells])
        expect(f"share of small grains in the map of {case}", (solid * C).sum() / solid.sum(), share, 0.005)
    if any(not row["standard_error"] or int(row["seeds"]) < 3 for row in rows):
        faults.append("summary.csv has rows without a standard error of three seeds")


known_bed()
published()
short_run()
print("\n".join(faults) or "grains of the drum: known bed, short run and published tables agree")
sys.exit(1 if faults else 0)
