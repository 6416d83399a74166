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


def run(folder, *settings, code=0):
    """Runs the case in a folder, with its results in `out`; returns what the program said."""
    command = [PROGRAM, CASE, "--force", "--output", "out"] + [part for each in settings for part in ("--set", each)]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    check(done.returncode == code, f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


def table(path):
    """Columns by name, without units."""
    with open(path, encoding="utf8") as file:
        rows = list(csv.reader(file))
    return {name.split(" [")[0]: [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}
