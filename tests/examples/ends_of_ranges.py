#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Both ends of the allowed range of every numeric option: ends_of_ranges.py PROGRAM CASE_FILE [KEY=VALUE ...]

A short run with each must come to its end with finite results, or be refused in words: with exit code 2 by a rule that names
an option, or with 3 where the state leaves the validity of the model. KEY=VALUE makes the runs short."""
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

NUMBER = r"[-+0-9.e]+"
SECONDS = 10  # a run that is still under way then has not failed; of many particles only


def ranges(program):
    """Key, whether it is an integer, whether an array, and both ends, of each option that has a range."""
    table = subprocess.run([program, "--options"], capture_output=True, text=True, check=True).stdout
    for line in table.splitlines()[2:]:
        key, _, _, allowed, _ = [cell.strip() for cell in line.strip("|").split("|", 4)]
        found = re.search(rf"in ([\[(])({NUMBER}), ({NUMBER})\]", allowed)
        if found is None:
            if "number" in allowed and "names" not in allowed:
                raise SystemExit(f"{key}: a number without a range: {allowed}")
            continue
        if found[1] == "(":
            raise SystemExit(f"{key}: the lower end {found[2]} is not allowed itself: which number is the least that runs?")
        yield key, "array" in allowed, float(found[2]), float(found[3]), "integer" in allowed


# Measures of mixing have no value where there are grains of one size alone, the packing none in a single row of grains.
NO_VALUE = {"segregation.C0": ("intensity", "lacey"), "geometry.aspect": ("packing", "packing_loosest", "packing_densest")}


def not_finite(folder):
    """Names of the numbers of the results that are none."""
    missing = []
    for table in ("history.csv", "profile.csv"):
        path = folder / table
        if not path.exists():
            continue
        names, *rows = path.read_text().splitlines()
        for row in rows:
            for name, value in zip(names.split(","), row.split(",")):
                if not math.isfinite(float(value)):
                    missing.append(f"{table}: {name}")
    if not (folder / "summary.json").exists():
        return ["summary.json"]
    for name, value in json.loads((folder / "summary.json").read_text()).items():
        if isinstance(value, (str, float)) and str(value).lower() in ("nan", "infinity", "-infinity", "inf"):
            missing.append(f"summary.json: {name}")
    return missing


def verdict(program, case, overrides, may_be_missing=()):
    """What is wrong with a run, and how it went. Without numbers that may be missing all that are."""
    with tempfile.TemporaryDirectory() as folder:
        words = [program, *case, "--output", folder + "/out", "--quiet"]
        for override in overrides:
            words += ["--set", override]
        try:
            run = subprocess.run(words, capture_output=True, text=True, timeout=SECONDS, stdin=subprocess.DEVNULL)
        except subprocess.TimeoutExpired:
            return "", "still runs"
        said = run.stderr.strip().splitlines()[-1] if run.stderr.strip() else ""
        if run.returncode == 0:
            missing = [name for name in not_finite(pathlib.Path(folder) / "out") if name not in may_be_missing]
            return ", ".join(dict.fromkeys(missing)), "runs"
        if run.returncode in (2, 3) and said:
            return "", f"{run.returncode}: {said}"
        return f"exit code {run.returncode}: {said}", ""


def main():
    program, case, short = sys.argv[1], sys.argv[2:3], sys.argv[3:]
    failures, tried, still = [], 0, 0
    # What has no value yet after so short a run (the depth of a flow that has not begun).
    base, how = verdict(program, case, short)
    if how != "runs":
        raise SystemExit(f"the short run itself: {base}")
    may_be_missing = base.split(", ")
    for key, is_array, low, high, is_integer in ranges(program):
        for end in (low, high):
            text = f"{int(end)}" if is_integer else f"{end!r}"
            override = f"{key}=[{text}]" if is_array else f"{key}={text}"
            without = [f"{file}: {name}" for file in ("history.csv", "summary.json") for name in NO_VALUE.get(key, ())]
            wrong, how = verdict(program, case, [*short, override], [*may_be_missing, *without])
            tried += 1
            still += how == "still runs"
            print(f"{override}: {'FAILED: ' + wrong if wrong else how}", flush=True)
            if wrong:
                failures.append(override)
    print(f"{tried} tried, {len(failures)} failed, {still} still ran after {SECONDS} s")
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
