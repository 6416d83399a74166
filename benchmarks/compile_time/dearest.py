#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The sources that took longest to compile in a build folder of ninja: python3 benchmarks/compile_time/dearest.py BUILD [COUNT]

Seconds of the wall clock, from ninja's log; what came from a compiler cache took next to none."""
import pathlib
import sys


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    count = int(sys.argv[2]) if len(sys.argv) == 3 else 10
    seconds = {}
    for line in (pathlib.Path(sys.argv[1]) / ".ninja_log").read_text().splitlines()[1:]:
        start, end, _, output, *_ = line.split("\t")
        if output.endswith(".o"):
            seconds[output] = (int(end) - int(start)) / 1000  # the last build of each counts
    print(f"The {count} dearest of {len(seconds)} sources, {sum(seconds.values()):.0f} s in all:\n| s | source |\n|---|---|")
    for output, time in sorted(seconds.items(), key=lambda item: -item[1])[:count]:
        print(f"| {time:.1f} | {output.removesuffix('.o')} |")


if __name__ == "__main__":
    main()
