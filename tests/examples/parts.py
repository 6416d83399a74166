# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A case that is divided into parts ends with one set of files, the same for any number of parts."""
import json
import pathlib
import tempfile

from case_program import check, run, table

SHORT = ("numerics.across=8", "output.duration=1", "output.interval=0.25")
with tempfile.TemporaryDirectory() as folder:
    found = {}
    for parts in (1, 2, 4):
        said = run(folder, *SHORT, f"numerics.parts={parts}")
        out = pathlib.Path(folder) / "out"
        check(said.count("run-out") == 1, f"{parts} parts speak once")
        names = {file.name for file in out.iterdir()}
        check(names == {"case.toml", "history.csv", "particles.vtkhdf", "profile.csv", "summary.json"}, f"{names}")
        summary = json.loads((out / "summary.json").read_text(encoding="utf8"))
        found[parts] = (
            [(out / name).read_bytes() for name in ("history.csv", "profile.csv")],
            [summary[name] for name in ("particles", "wall_particles", "lost", "steps", "run_out", "summit_over_L0")],
        )
        check(len(table(out / "history.csv")["time"]) == 5, "five rows")
    check(found[1] == found[2] == found[4], "1, 2 and 4 parts have the same results")
