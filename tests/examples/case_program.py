# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the tests of case programs share: PROGRAM and CASE from the command line, runs, checks and tables."""
import csv
import pathlib
import subprocess
import sys

PROGRAM, CASE = (pathlib.Path(argument).resolve() for argument in sys.argv[1:])


def check(holds, text):
    print(("" if holds else "FAILED: ") + text)
    if not holds:
        raise SystemExit(1)


def run(folder, *settings, code=0, case=CASE, output="out"):
    """Runs the case in a folder, with its results in `output`; returns what the program said."""
    command = [PROGRAM, case, "--force", "--output", output] + [part for each in settings for part in ("--set", each)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    check(done.returncode == code, f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def table(path):
    """Columns by name, without units."""
    with open(path, encoding="utf8") as file:
        rows = list(csv.reader(file))
    return {name.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}


def check_restart(folder, names, whole, half):
    """A run that goes on from the checkpoint of one with the settings `half` leaves the same files as the whole one."""
    run(folder, *whole, output="whole")
    run(folder, *whole, *half, output="half")
    run(folder, *whole, 'output.restart_from="half/checkpoint.h5"', output="rest")
    for name in names:
        same = (folder / "whole" / name).read_bytes() == (folder / "rest" / name).read_bytes()
        check(same, f"{name}: the continued run leaves the bytes of the whole one")
    check((folder / "half" / names[0]).read_bytes() != (folder / "whole" / names[0]).read_bytes(), "half of it does not")
