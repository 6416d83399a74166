#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs test programs under NVIDIA's compute-sanitizer and counts its reports: R13 on a GPU.

    python3 tests/reliability/compute_sanitizer.py build/cuda test_pairs test_neighbours 'test_solver [snapshot]'

A program is the name of a test program of the build, with a filter of test cases after a space; or a path with arguments.
Tools: memcheck, racecheck, initcheck, synccheck, or those of --tools. Programs run ten to a hundred times slower, racecheck
the slowest. Ends with exit code 1 at a report, a test that fails, or a tool that does not run."""
import argparse
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

import programs
from tally import HEAD, Tally, print_failures

TOOLS = ("memcheck", "racecheck", "initcheck", "synccheck")
SUMMARY = re.compile(r"(?:ERROR|RACECHECK) SUMMARY: (\d+) (?:error|hazard)")


def found_program(build, name):
    """The path of a test program of a build, or of any other."""
    context = programs.Context(build, build, False, None, None)
    path = context.test(name) or context.program(name)
    return path if path.is_file() else pathlib.Path(name)


def reports_of(sanitizer, tool, command, limit):
    """How many reports, or what went wrong."""
    words = [sanitizer, "--tool", tool, "--print-limit", "20", *(["--leak-check", "full"] if tool == "memcheck" else []), *command]
    try:
        outcome = programs.run(words, limit=limit)
    except subprocess.TimeoutExpired:
        return f"more than {limit} s"
    summary = SUMMARY.findall(outcome.out + outcome.err)
    if not summary:
        return "no summary: " + (outcome.out + outcome.err)[-500:]
    reports = sum(map(int, summary))
    if reports:
        return f"{reports} reports: " + "\n".join(line for line in (outcome.out + outcome.err).splitlines()
                                                  if line.startswith("========="))[:3000]
    return "" if outcome.code == 0 else f"exit code {outcome.code}: {outcome.out[-500:]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("programs", nargs="+")
    parser.add_argument("--tools", default=",".join(TOOLS))
    parser.add_argument("--limit", type=float, default=1800, help="s for each program under each tool")
    parser.add_argument("--sanitizer", default=shutil.which("compute-sanitizer") or "/usr/local/cuda/bin/compute-sanitizer")
    arguments = parser.parse_args()
    rows = []
    for tool in arguments.tools.split(","):
        tally = Tally("R13", f"compute-sanitizer, {tool}: test programs without a report")
        for text in arguments.programs:
            name, *rest = shlex.split(text)
            fault = reports_of(arguments.sanitizer, tool, [found_program(arguments.build.resolve(), name), *rest], arguments.limit)
            tally.check(not fault, f"{text}: {fault}")
            print(f"  {tool}, {text}: {fault.splitlines()[0] if fault else 'no report'}", flush=True)
        print_failures(tally)
        rows.append(tally)
    print(HEAD)
    for row in rows:
        print(row.row())
    return 1 if any(row.falls_short for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
