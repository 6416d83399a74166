#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Ctrl-C loses nothing of a run: interrupted.py PROGRAM CASE_FILE NUMBER [KEY=VALUE ...]

NUMBER runs of the case with these settings are interrupted at random times, continued with the option that the program
prints, and interrupted again. Each ends with the results of a run that was never stopped, bit for bit."""
import pathlib
import random
import re
import signal
import subprocess
import sys
import tempfile
import time

from case_program import CASE, PROGRAM, check, without_clock

NUMBER, SETTINGS = int(sys.argv[3]), sys.argv[4:]
chance = random.Random(NUMBER)


def start(folder, *more):
    words = [PROGRAM, CASE, "--force", "--output", "out"] + [f"--set={each}" for each in (*SETTINGS, *more)]
    return subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def results(folder):
    names = sorted(path.name for path in folder.iterdir() if path.name != "case.toml" and "checkpoint" not in path.name)
    return {name: without_clock(folder / name) for name in names}


def interrupted(folder, seconds):
    """How often a run was stopped until it came to its end."""
    stops, more = 0, ()
    while True:
        process = start(folder, *more)
        history = folder / "out" / "history.csv"
        while process.poll() is None and (not history.exists() or history.read_text().count("\n") < 2):
            time.sleep(0.001)  # a run that has not begun has nothing to lose
        time.sleep(chance.uniform(0, 0.7 * seconds))
        process.send_signal(signal.SIGINT)
        _, said = process.communicate()
        if process.returncode == 0:
            return stops
        if process.returncode == -signal.SIGINT:  # it had not begun: the next one starts from the same checkpoint
            continue
        check(process.returncode == 128 + signal.SIGINT, f"stopped: exit code {process.returncode} {said}")
        stops += 1
        option = re.search(r"to continue, add --set '(output.restart_from=.*)' to the command", said)
        check(option is not None, f"it says how to continue: {said}")
        more = (option[1],)
        check("is new" not in said and "is missing" not in said, f"it says that nothing of the case has changed: {said}")


with tempfile.TemporaryDirectory() as name:
    home = pathlib.Path(name)
    if (script := CASE.parent / "vessel.py").exists():
        subprocess.run([sys.executable, script, "v", home / "vessel.stl"], check=True)
    if (script := CASE.parent / "ground.py").exists():
        subprocess.run([sys.executable, script, home, "10"], check=True)
    whole = home / "whole"
    whole.mkdir()
    began = time.monotonic()
    process = start(whole)
    _, said = process.communicate()
    check(process.returncode == 0, f"a run that is not stopped: exit code {process.returncode} {said}")
    seconds, whole = time.monotonic() - began, results(whole / "out")
    stops = 0
    for number in range(NUMBER):
        folder = home / str(number)
        folder.mkdir()
        stops += interrupted(folder, seconds)
        found = results(folder / "out")
        check(sorted(found) == sorted(whole), f"run {number + 1}, {stops} stops so far: files {sorted(found)}")
        different = [name for name in whole if found[name] != whole[name]]
        check(not different, f"it has the bits of the run that was not stopped; different: {different}")
    check(stops > 0, f"{stops} stops in {NUMBER} runs of {seconds:.2f} s")
