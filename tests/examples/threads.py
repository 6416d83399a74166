# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A case that is divided into ranks ends with one set of files, the same for any number of ranks."""
import json
import pathlib
import subprocess
import tempfile

from case_program import CASE, PROGRAM, check, run, table

SHORT = ("numerics.across=8", "output.duration=1", "output.interval=0.25")
with tempfile.TemporaryDirectory() as folder:
    found = {}
    for ranks in (1, 2, 4):
        said = run(folder, *SHORT, f"numerics.ranks={ranks}")
        out = pathlib.Path(folder) / "out"
        check(said.count("run-out") == 1, f"{ranks} ranks speak once")
        check((f"{ranks} ranks, threads of one process; between" in said) == (ranks > 1), "the transport is told")
        names = {file.name for file in out.iterdir()}
        check(names == {"case.toml", "checkpoint.h5", "history.csv", "particles.vtkhdf", "profile.csv", "summary.json"}, f"{names}")
        summary = json.loads((out / "summary.json").read_text(encoding="utf8"))
        found[ranks] = (
            [(out / name).read_bytes() for name in ("history.csv", "profile.csv")],
            [summary[name] for name in ("particles", "wall_particles", "lost", "steps", "run_out", "summit_over_L0")],
        )
        check(len(table(out / "history.csv")["time"]) == 5, "five rows")
    check(found[1] == found[2] == found[4], "1, 2 and 4 ranks have the same results")

    words = [PROGRAM, CASE, "--profile", "--force", "--output", "out", *(f"--set={each}" for each in SHORT)]
    said = subprocess.run(words + ["--set=numerics.ranks=2"], cwd=folder, capture_output=True, text=True, check=True).stdout
    rows = [line for line in said.splitlines() if line.count("|") == 3 and "%" in line]
    check("profile of" in said and len(rows) == 2, "--profile prints a row for each rank")

# Kokkos would print its own help before that of the program.
help_text = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
check(help_text.lstrip().startswith("Collapse of a column") and "--kokkos-num-threads" not in help_text, "--help is the program's")
