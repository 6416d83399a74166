#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A coarse, short run of the terrain that its script makes: terrain.py PROGRAM CASE_FILE"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from case_program import CASE, check, check_restart, run, table


def raster(path):
    """Head and values, rows from south to north."""
    lines = path.read_text().splitlines()
    head = {key.lower(): float(value) for key, value in (line.split() for line in lines[:6])}
    rows = [[float(value) for value in line.split()] for line in lines[6:]][::-1]
    check(len(rows) == head["nrows"] and all(len(row) == head["ncols"] for row in rows), f"{path.name} is a raster")
    return head, rows


def volume(map_):
    head, rows = map_
    return head["cellsize"] ** 2 * sum(map(sum, rows))


def centre(map_):
    """x of the middle of the grains from the west of the ground, m."""
    head, rows = map_
    weights = [sum(row[k] for row in rows) for k in range(int(head["ncols"]))]
    return head["xllcorner"] - 499997.5 + sum((k + 0.5) * head["cellsize"] * w for k, w in enumerate(weights)) / sum(weights)


with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    subprocess.run([sys.executable, CASE.parent / "ground.py", folder, "10"], check=True)
    short = ("numerics.spacing=6", "output.duration=4", "output.maps=1", "output.cell=10")
    run(folder, *short)
    out = folder / "out"
    summary = json.loads((out / "summary.json").read_text())
    maps = [raster(out / f"depth_{k:02}.asc") for k in range(summary["maps"])]
    check(len(maps) == 5, "a map at the start and four later")

    _, release = raster(folder / "release.asc")
    check(abs(100 * sum(map(sum, release)) / summary["released_volume"] - 1) < 0.03, "the volume is that of the raster")
    total = summary["volume_on_ground"] + summary["volume_gone"] + summary["volume_through_ground"]
    check(abs(total / summary["released_volume"] - 1) < 1e-9, "no volume is lost from the account")
    for each in maps:
        check(abs(volume(each) / summary["released_volume"] - 1) < 1e-3, f"the map has {volume(each):.1f} m^3")

    # A block that slides on the gully: the way is between those with the least and the greatest friction.
    k = [3 * mu / math.sqrt(9 + 12 * mu * mu) for mu in (0.382, 0.6)]
    angle = math.radians(32)
    ways = [0.5 * 9.81 * 4**2 * (math.sin(angle) - each * math.cos(angle)) * math.cos(angle) for each in k]
    way = centre(maps[-1]) - centre(maps[0])
    check(0.5 * ways[1] < way < 1.1 * ways[0], f"the middle moves {way:.1f} m; a block {ways[1]:.1f} to {ways[0]:.1f} m")

    _, arrival = raster(out / "arrival.asc")
    _, largest = raster(out / "largest_depth.asc")
    times = [t for row in arrival for t in row if t != -9999]
    check(min(times) == 0 and max(times) <= 4, "arrivals are times of the run")
    deep = sum(d > 0.1 for row in largest for d in row)
    check(deep == len(times) and summary["area"] == 100 * deep, "cells with an arrival are those that became deep")
    heights = table(out / "history.csv")["centre_z"]
    check(len(heights) == 9 and all(b <= a + 0.05 for a, b in zip(heights, heights[1:])), "the middle never rises")

    check("gone.asc" in run(folder, *short, 'ground.heights="gone.asc"', code=1), "a missing raster is named")
    check("output.cell" in run(folder, *short, "output.cell=5", code=2), "maps finer than the particles are refused")

    before = {file.name: file.read_bytes() for file in out.iterdir()}
    missing = run(folder, *short, 'ground.heights="gone.asc"', 'output.restart_from="gone.h5"', code=1)
    check("gone.h5: cannot read the checkpoint" in missing, "a missing checkpoint is found before the ground is read")
    run(folder, *short, "material.young=1", code=1)
    (folder / "alone").mkdir()
    (folder / "alone/checkpoint.h5").write_bytes(before["checkpoint.h5"])
    lacks = run(folder, *short, 'output.restart_from="alone/checkpoint.h5"', code=1)
    check("alone/history.csv: cannot read it" in lacks, "a checkpoint without the tables of its run is refused")
    after = {file.name: file.read_bytes() for file in out.iterdir()}
    check(after == before, "runs that were refused leave the earlier results")

    coarse = ("numerics.spacing=8", "output.duration=1", "output.maps=0.25", "output.history=0.25", "output.cell=10")
    maps = [f"depth_{k:02}.asc" for k in range(5)]
    check_restart(folder, ["history.csv", *maps, "largest_depth.asc", "arrival.asc"], coarse, ("output.duration=0.5",))
