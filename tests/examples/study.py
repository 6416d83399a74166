#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A study of four coarse drums, two at a time: its files are those of single runs, it goes on where it was stopped, and
mistakes end it before anything is written: study.py PROGRAM CASE_FILE"""
import csv
import itertools
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import time

from case_program import CASE, PROGRAM, check, without_clock

SETTINGS = {"numerics.spacing": 0.0035, "time.duration": 0.03, "output.history_interval": 0.01,
            "output.frame_interval": 0.01, "output.profile_times": "[0.02]", "output.checkpoints": 0}
SPEEDS, FILLS = (5, 20), (0.42, 0.5)
STUDY = f"[geometry]\nrotation_speed = {list(SPEEDS)}\nfill_depth = {list(FILLS)}\n"
MEMBERS = [f"geometry.rotation_speed={speed} geometry.fill_depth={fill}".split()
           for speed, fill in itertools.product(SPEEDS, FILLS)]


def command(output, *words, settings=()):
    line = [str(PROGRAM), str(CASE), "--output", str(output), "--quiet"]
    given = {**SETTINGS, **dict(each.split("=", 1) for each in settings)}
    return line + [part for key in given for part in ("--set", f"{key}={given[key]}")] + [str(word) for word in words]


def run(output, *words, settings=(), code=0):
    done = subprocess.run(command(output, *words, settings=settings), capture_output=True, text=True, timeout=600)
    check(done.returncode == code, f"exit code {done.returncode} {done.stderr.strip()}")
    return done.stderr


def compare(member, single, but=()):
    names = {path.name for path in single.iterdir()} - set(but)
    check(names <= {path.name for path in member.iterdir()}, f"{member.name} has the files of a single run: {sorted(names)}")
    different = [name for name in sorted(names) if without_clock(member / name) != without_clock(single / name)]
    check(not different, f"member {member.name} has the bits of its single run; different: {different}")


def table_of(folder):
    with open(folder / "study.csv", encoding="utf8") as file:
        return list(csv.DictReader(file))


def check_table(folder):
    rows = table_of(folder)
    check([row["member"] for row in rows] == ["1", "2", "3", "4"], "the table has the members in their order")
    check(all(row["state"] == "finished" for row in rows), "all have finished")
    values = [(float(row["geometry.rotation_speed [rpm]"]), float(row["geometry.fill_depth"])) for row in rows]
    check(values == list(itertools.product(SPEEDS, FILLS)), f"values {values}")
    summaries = [json.loads((folder / row["member"] / "summary.json").read_text()) for row in rows]
    check(all(float(row["largest_radius_over_R"]) == summary["largest_radius_over_R"] and
              float(row["steps_by_limit.acoustic"]) == summary["steps_by_limit"]["acoustic"]
              for row, summary in zip(rows, summaries)), "the numbers of the summaries are in the table")


def mistakes(folder, study):
    wrong = folder / "wrong.toml"
    wrong.write_text("[geometry]\nrotation_speed = [5]\nfil_depth = [0.4]\n")
    said = run(folder / "wrong", "--study", wrong, code=2)
    check(f"{wrong}:3:" in said and "geometry.fil_depth: unknown key" in said, "the message names file, line and key")
    said = run(folder / "wrong", "--vary", "geometry.fill_depth=[0.4, 2]", code=2)
    check("2 is out of range" in said, "a value out of range is refused")
    check(not list((folder / "wrong").glob("*/case.toml")), "no member has begun")
    said = run(folder / "study", "--study", study, settings=["numerics.cfl=0.3"], code=2)
    check("case.toml: is of another case ('cfl = 0.4' there, 'cfl = 0.3' here)" in said, "another study is refused")


def stopped(folder, study, singles):
    """SIGTERM during the study: members under way leave a checkpoint; all go on, and give the tables of single runs."""
    output = folder / "stopped"
    process = subprocess.Popen(command(output, "--study", study, "--workers", 2), stderr=subprocess.PIPE, text=True)
    while not any(history.read_bytes().count(b"\n") > 2 for history in output.glob("*/history.csv")):
        time.sleep(0.001)
        check(process.poll() is None, "the study runs") if process.poll() is not None else None
    process.send_signal(signal.SIGTERM)
    said = process.communicate(timeout=600)[1]
    check(process.returncode == 128 + signal.SIGTERM, f"exit code {process.returncode} {said}")
    states = [row["state"] for row in table_of(output)]
    check("stopped" in states and "not begun" in states, f"states after the signal: {states}")
    finished = [k for k, state in enumerate(states) if state == "finished"]
    before = {k: (output / str(k + 1) / "summary.json").stat().st_mtime_ns for k in finished}
    run(output, "--study", study, "--workers", 2)
    check_table(output)
    check(all((output / str(k + 1) / "summary.json").stat().st_mtime_ns == at for k, at in before.items()),
          "finished members did not run again")
    for k, single in enumerate(singles):
        compare(output / str(k + 1), single, but=("case.toml",))  # it names the checkpoint


def failing(folder):
    """A member that leaves the validity of its model loses no other, and does not run again."""
    fast = ["geometry.rotation_speed=100", "numerics.cfl=1", "time.duration=1", "output.checkpoints=1e6"]
    words = ("--vary", "numerics.viscosity_speed=[0, 0.5]", "--workers", 2)
    said = run(folder / "failing", *words, settings=fast, code=3)
    states = [row["state"] for row in table_of(folder / "failing")]
    check(states == ["outside validity", "finished"], f"states {states}: {said}")
    check("outside the validity of the model" in table_of(folder / "failing")[0]["message"], "the table says why")
    table = (folder / "failing" / "study.csv").read_text()
    said = run(folder / "failing", *words, settings=fast, code=3)
    check("outside" not in said and (folder / "failing" / "study.csv").read_text() == table, f"nothing runs again {said}")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        singles = [folder / f"single{k}" for k in range(len(MEMBERS))]
        for output, settings in zip(singles, MEMBERS):
            run(output, settings=settings)
        study = folder / "study.toml"
        study.write_text(STUDY)
        run(folder / "study", "--study", study, "--workers", 2)
        check_table(folder / "study")
        for k, single in enumerate(singles):
            compare(folder / "study" / str(k + 1), single)
        mistakes(folder, study)
        stopped(folder, study, singles)
        failing(folder)


if __name__ == "__main__":
    os.environ["OMP_NUM_THREADS"] = "2"
    main()
