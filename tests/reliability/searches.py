# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R8, R13: fuzzers and sanitizers, which have builds of their own."""
import pathlib
import re
import subprocess

import programs
from tally import Tally

FUZZERS = {"fuzz_case_file": ["-max_len=1024"], "fuzz_checkpoint": ["-len_control=0", "-max_len=256"],
           "fuzz_geometry": ["-max_len=2048"]}
SEEDS = {"fuzz_case_file": [programs.SOURCE / "examples" / name for name in ("drum", "shear_box")],
         "fuzz_geometry": [programs.SOURCE / "tests/fuzz/seeds_of_geometry"]}


def fuzzed(context):
    """R8"""
    tally = Tally("R8", "inputs made by libFuzzer under the address and undefined-behaviour sanitizers")
    seconds = context.arguments.fuzz_seconds or context.pick(30, 3600)
    build = context.arguments.fuzz_build
    if not build:
        tally.not_run = "give --fuzz-build"
        return tally
    for name, options in FUZZERS.items():
        folder = context.folder()
        folder.mkdir()
        seeds = SEEDS.get(name, [])
        program = (pathlib.Path(build) / "tests" / "fuzz" / name).resolve()
        outcome = programs.run([program, f"-max_total_time={seconds}", *options, ".", *seeds], cwd=folder, limit=2 * seconds + 600)
        runs = re.search(r"Done (\d+) runs in (\d+) second", outcome.err)
        executed = int(runs[1]) if runs else 1
        found = [path.name for path in folder.iterdir() if re.match(r"(crash|leak|timeout|oom)-", path.name)]
        tally.tried += executed - 1
        tally.check(outcome.code == 0 and runs and not found, f"{name}: exit code {outcome.code}, {found} {outcome.err[-1500:]}")
        tally.note(f"{name}: {executed} in {seconds} s")
    return tally


REPORT = re.compile(r"ERROR: AddressSanitizer|runtime error:|ERROR: LeakSanitizer|Kokkos::View ERROR: out of bounds")


def sanitized(context):
    """R13: all tests of a build of the preset openmp-sanitize, and no report in what they print"""
    tally = Tally("R13", "tests under address and undefined-behaviour sanitizers with bounds checked: passed without a report")
    build = context.arguments.sanitized_build
    if not build:
        tally.not_run = "give --sanitized-build"
        return tally
    labels = context.arguments.sanitized_labels
    command = ["ctest", "--test-dir", build, "--output-on-failure", "--label-exclude", "must_not_compile|install|headers|reliability"]
    if labels:
        command += ["--label-regex", labels]
    outcome = subprocess.run(command, env=programs.environment(), capture_output=True, text=True, check=False)
    for name, result in re.findall(r"^ *\d+/\d+ Test +#\d+: (.*?) \.*\s*(Passed|\*\*\*.*?|Skipped)\s+[\d.]+ sec", outcome.stdout,
                                   re.MULTILINE):
        if "Skipped" not in result:
            tally.check(result == "Passed", f"{name}: {result}")
    for report in REPORT.findall(outcome.stdout):
        tally.check(False, report)
    return tally


MEASURES = {"R8": fuzzed, "R13": sanitized}
