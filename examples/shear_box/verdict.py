#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares the error of a run of the shear box with that of the table in README.md: verdict.py OUT. The exit code is 0 if they
are equal within 1 %, 1 if they are not, and 2 if the table has no such run."""
import json
import re
import sys
from pathlib import Path

TIME, SHARE = 80, 0.01  # periods; of the error, for other compilers and a GPU


def published(page, scheme, upright, spacing):
    """The error that the table of results gives, or nothing."""
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")] for line in page.splitlines() if line.startswith("|")]
    head = next(row for row in rows if row[0] == "scheme, box")
    spacings = [float(re.sub(r"dr/H = ", "", cell)) for cell in head[1:]]
    name = f"{scheme}, {'upright' if upright else 'oscillating'}"
    row = next((row for row in rows if row[0].split(" (")[0] == name), None)
    return float(row[1 + spacings.index(spacing)]) if row and spacing in spacings else None


def verdict(summary, page):
    """(exit code, sentence)."""
    usual = all(summary[key] == value for key, value in (("flux", "symmetric"), ("reading", "chi"), ("closure", "constant"), ("jitter", 0)))
    error = next((each["mae_width"] for each in summary["compared"] if each["time"] == TIME), None)
    known = published(page, summary["scheme"], summary["upright"], summary["spacing"]) if usual else None
    if error is None or known is None:
        return 2, "README.md has no error of such a run"
    if abs(error - known) <= SHARE * known:
        return 0, f"The mean absolute error at {TIME} T is {error:.2e}, as published ({known:.2e})."
    return 1, f"The mean absolute error at {TIME} T is {error:.2e}; published is {known:.2e}. Please report it, with the system and the compiler."


def main():
    folder = Path(sys.argv[1])
    code, sentence = verdict(json.loads((folder / "summary.json").read_text(encoding="utf8")),
                             (Path(__file__).parent / "README.md").read_text(encoding="utf8"))
    print(sentence)
    sys.exit(code)


if __name__ == "__main__":
    main()
