#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Ratios of times in results of Google Benchmark (JSON).

  compare.py BEFORE AFTER   rows of both files (or folders of files): time before over time after, above 1 is faster
  compare.py RESULTS        rows of the library against the same by hand: time by hand over time of the library

Times are medians over repetitions; the spread beside them is (largest - smallest)/median."""
import argparse
import json
import pathlib
import re
import statistics

MICROSECONDS = {"ns": 1e-3, "us": 1, "ms": 1e3, "s": 1e6}


def load(path):
    """Times in microseconds of all repetitions of each row."""
    files = sorted(path.glob("*.json")) if path.is_dir() else [path]
    rows = {}
    for file in files:
        for run in json.loads(file.read_text())["benchmarks"]:
            name = re.sub(r"/(real_time|iterations:\d+|repeats:\d+)", "", run.get("run_name", run["name"]))
            if run.get("run_type", "iteration") != "iteration":
                continue
            if run.get("error_occurred"):
                print(f"not measured: {name}: {run['error_message']}")
                continue
            rows.setdefault(name, []).append(run["real_time"] * MICROSECONDS[run["time_unit"]])
    return rows


def show(times):
    median = statistics.median(times)
    return f"{median:.5g} us ({100 * (max(times) - min(times)) / median:.0f} %)"


def table(header, lines):
    print("| row | " + " | ".join(header) + " |\n|" + "---|" * (len(header) + 1))
    for line in lines:
        print("| " + " | ".join(line) + " |")


def ratio(times, others):
    return f"{statistics.median(times) / statistics.median(others):.3f}"


def against_before(before, after):
    table(("before", "after", "before/after"),
          [(name, show(before[name]), show(after[name]), ratio(before[name], after[name])) for name in after if name in before])
    for name in sorted(before.keys() ^ after.keys()):
        print(f"only {'before' if name in before else 'after'}: {name}")


def against_yardstick(rows):
    """For each row of the library all rows that differ from it in who did it."""
    lines = []
    for name, times in rows.items():
        for other in rows:
            who = re.search(r"/(by_hand\w*)/", other)
            if who and other.replace(who[0], "/library/") == name:
                lines.append((name, who[1], show(rows[other]), show(times), ratio(rows[other], times)))
    table(("yardstick", "its time", "library", "yardstick/library"), lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="+", type=pathlib.Path)
    parser.add_argument("--rows", default="", help="only rows that match this regular expression")
    options = parser.parse_args()
    if len(options.results) > 2:
        parser.error("give one or two files or folders")
    results = [{name: times for name, times in load(path).items() if re.search(options.rows, name)}
               for path in options.results]
    against_before(*results) if len(results) == 2 else against_yardstick(results[0])


if __name__ == "__main__":
    main()
