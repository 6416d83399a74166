#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The program of docs/case_programs.md does what its page says: case_program.py PROGRAM"""
import json
import pathlib
import subprocess
import sys
import tempfile


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(code, *words):
            done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True, timeout=300)
            assert done.returncode == code, f"{words}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}"
            return done.stdout + done.stderr

        assert "| numerics.spacing    | H" in run(0, "--options")
        (folder / "case.toml").write_text("[numerics]\nspcing = 0.1\n")
        said = run(2, "case.toml", "--set", "bed.height=20").splitlines()
        assert said == ["--set: bed.height: 20 is out of range; allowed: a number in [0.001, 10] m",
                        "case.toml:2:1: numerics.spcing: unknown key, did you mean 'numerics.spacing'?; allowed: spacing"], said
        assert "longer than the run" in run(2, "--set", "time.interval=30")
        assert not (folder / "box_output").exists()

        (folder / "case.toml").write_text("[numerics]\nspacing = 0.1\n[time]\nperiods = 4\n")
        assert "took" in run(0, "case.toml", "--output", "whole")
        whole = (folder / "whole" / "history.csv").read_text()
        assert whole.splitlines()[0] == "time [s],mean C,centre of small grains [m]" and len(whole.splitlines()) == 6
        assert json.loads((folder / "whole" / "summary.json").read_text())["particles"] == 40
        assert "holds an earlier result" in run(1, "case.toml", "--output", "whole")
        run(0, "whole/case.toml", "--output", "whole", "--force", "--quiet")
        assert (folder / "whole" / "history.csv").read_text() == whole

        # In two parts.
        run(0, "case.toml", "--output", "parts", "--set", "time.periods=2")
        on = ["--output", "parts", "--set", "output.restart_from=parts/checkpoint.h5", "--quiet"]
        assert "note: parts/checkpoint.h5: case: '[time] periods = 2' of the checkpoint is missing" in run(0, "case.toml", *on)
        assert (folder / "parts" / "history.csv").read_text() == whole
    print("the page's program does what the page says")


if __name__ == "__main__":
    main()
