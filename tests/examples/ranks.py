# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The drum on the processes of mpirun ends with one set of files, the same for any number of ranks; what ranks cannot do is
refused once: ranks.py PROGRAM CASE MPIRUN"""
import pathlib
import subprocess
import sys
import tempfile

MPIRUN = [sys.argv.pop()]
if "Open MPI" in subprocess.run([*MPIRUN, "--version"], capture_output=True, text=True).stdout:
    MPIRUN += ["--oversubscribe", "--allow-run-as-root"]

from case_program import CASE, PROGRAM, check  # noqa: E402  it reads the other arguments

SHORT = ("numerics.spacing=0.0035", "time.duration=0.04", "output.history_interval=0.02", "output.profile_times=[0.04]")


def run(ranks, output, *arguments):
    command = [*MPIRUN, "-n", str(ranks), PROGRAM, CASE, "--output", output, *arguments]
    for setting in SHORT:
        command += ["--set", setting]
    return subprocess.run(command, capture_output=True, text=True)


with tempfile.TemporaryDirectory() as folder:
    found = {}
    for ranks in (1, 2, 4):
        output = pathlib.Path(folder) / str(ranks)
        done = run(ranks, output)
        check(done.returncode == 0, f"{ranks} ranks: {done.stdout}{done.stderr}")
        check(done.stdout.count("results in") == 1, f"{ranks} ranks speak once")
        names = {file.name for file in output.iterdir()}
        check("summary.json" in names and not any(name.endswith(".part") for name in names), f"{names}")
        found[ranks] = [(output / name).read_bytes() for name in ("profiles.csv", "radial.csv")]
        check(len(found[ranks][0].splitlines()) > 5, "a profile")
    check(found[1] == found[2] == found[4], "1, 2 and 4 ranks have the same results")

    done = run(2, pathlib.Path(folder) / "study", "--vary", "geometry.rotation_speed=[2, 5]")
    check(done.returncode == 2 and done.stderr.count("processes of mpirun run one case") == 1, done.stderr)
    done = run(2, pathlib.Path(folder) / "1")
    check(done.returncode == 1 and done.stderr.count("holds an earlier result") == 1, done.stderr)
