#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The study of examples/drum/scaling.toml, four of its members, coarse and short: scaling.py PROGRAM
CASE_FILE"""
import csv
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import tomllib

from case_program import CASE, PROGRAM, check

STUDY = CASE.parent / "scaling.toml"
COARSE = {"numerics.spacing": 0.08, "time.duration": 0.7, "output.history_interval": 0.01}  # R, turns, turns; means of a second
SETTINGS = ("output.frame_interval=100", "output.profile_times=[]")


def lists_of(study):
    """The lists of a study, by keys."""
    options = tomllib.loads(study.read_text(encoding="utf8"))
    check(options.pop("study") == {"combine": "rows"}, "members are rows")
    return {f"{section}.{name}": values for section, names in options.items() for name, values in names.items()}


def check_lists(lists):
    counts = {len(values) for values in lists.values()}
    check(len(counts) == 1 and counts.pop() > 40, "each list has a value for each member")
    radii, fills, speeds = (set(lists[f"geometry.{name}"]) for name in ("radius", "fill_depth", "rotation_speed"))
    check(len(radii) == 3 and len(fills) == 3 and {1, 2, 5, 10, 20} <= speeds, "three radii, three fillings, speeds of 1 to 20 rpm")


def short(lists, members):
    """The lists of some members, with coarse spacings and short times."""
    chosen = {key: [values[k] for k in members] for key, values in lists.items()}
    for row in range(len(members)):
        turn = 60 / chosen["geometry.rotation_speed"][row]
        chosen["numerics.spacing"][row] = COARSE["numerics.spacing"] * chosen["geometry.radius"][row]
        chosen["time.duration"][row] = COARSE["time.duration"] * turn
        chosen["output.history_interval"][row] = COARSE["output.history_interval"] * turn
    return chosen


def words_of(value):
    return "[" + ", ".join(f'"{item}"' if isinstance(item, str) else repr(item) for item in value) + "]"


def main():
    lists = lists_of(STUDY)
    check_lists(lists)
    members = [17, 34, len(lists["numerics.spacing"]) - 4, len(lists["numerics.spacing"]) - 1]  # two of each closure, fast
    chosen = short(lists, members)
    with tempfile.TemporaryDirectory() as name:
        output = pathlib.Path(name) / "out"
        command = [str(PROGRAM), str(CASE), "--study", str(STUDY), "--output", str(output), "--quiet", "--workers", "2"]
        for key, values in chosen.items():
            command += ["--vary", f"{key}={words_of(values)}"]
        for setting in SETTINGS:
            command += ["--set", setting]
        done = subprocess.run(command, capture_output=True, text=True, timeout=600)
        check(done.returncode == 0, f"the study runs {done.stderr.strip()}")
        with open(output / "study.csv", encoding="utf8") as file:
            rows = list(csv.DictReader(file))
        check(len(rows) == len(members) and all(row["state"] == "finished" for row in rows), "all members finish")
        for row in rows:
            names = "layer_depth half_surface epsilon Lambda Pe degree time".split()
            found = {key: float(row[f"scaling.{key}"]) for key in names}
            check(all(math.isfinite(value) and value > 0 for value in found.values()), f"numbers of the scaling: {found}")
            R, delta, L = float(row["geometry.radius [m]"]), found["layer_depth"], found["half_surface"]
            d_small, d_large = (float(row[f"material.{which} [m]"]) for which in ("d_small", "d_large"))
            d = (d_small + d_large) / 2
            ratio = 0.11 / 0.0307 / d if row["segregation.closure"].strip('"') == "shear-rate" else (
                0.26 * d_small * math.log(d_large / d_small) / (0.042 * d * d))
            check(math.isclose(found["Lambda"] * found["Pe"], ratio * delta, rel_tol=1e-9), "Lambda Pe is V delta/D")
            check(math.isclose(found["epsilon"], delta / L) and 0.9 * R < L <= R and 0 < delta < R, "lengths of the layer")
        done = subprocess.run([sys.executable, CASE.parent / "scaling.py", output, "--no-pictures"], capture_output=True, text=True)
        check(done.returncode == 0 and "too few for a curve" in done.stdout, f"scaling.py reads it {done.stdout}{done.stderr}")
        lines = (output / "maps.csv").read_text(encoding="utf8").count("\n")
        check(lines == len(members) + 1, "maps.csv has a line for each member")


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "2"
    main()
