#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares the run-out of a collapse with experiments: verdict.py OUT. The exit code is 0 if it lies between their bounds, 1 if
it does not."""
import json
import sys
from pathlib import Path


def verdict(summary):
    """(exit code, sentence)."""
    run_out, least, greatest = (summary[key] for key in ("run_out", "run_out_least", "run_out_greatest"))
    if least <= run_out <= greatest:
        return 0, f"The run-out is {run_out:.2f} L0, within that of experiments ({least:.2f} to {greatest:.2f} L0)."
    return 1, (f"The run-out is {run_out:.2f} L0, outside that of experiments ({least:.2f} to {greatest:.2f} L0). "
               "Please report it, with the system and the compiler.")


def main():
    code, sentence = verdict(json.loads((Path(sys.argv[1]) / "summary.json").read_text(encoding="utf8")))
    print(sentence)
    sys.exit(code)


if __name__ == "__main__":
    main()
