#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints the table of docs/reliability.md: for each measure what was tried and what survived.

    python3 tests/reliability/reliability.py --build build/openmp            all that can be run with this build
    python3 tests/reliability/reliability.py --build build/openmp --short    two minutes
    python3 tests/reliability/reliability.py --build build/openmp --only R4,R5

Needs the examples and test_reliability in the build, and h5py. Ends with exit code 1 if a measure falls short."""
import argparse
import pathlib
import random
import shutil
import sys
import tempfile
import time

import damage
import disk
import endurance
import faults
import inputs
import interruption
import library
import programs
import repeatability
import searches
import tally

FAMILIES = (repeatability, interruption, damage, disk, inputs, searches, library, endurance, faults)
MEASURES = {name: measure for family in FAMILIES for name, measure in family.MEASURES.items()}
NOT_BUILT = 77  # what CTest counts as skipped


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=programs.SOURCE / "build" / "openmp", help="build folder")
    parser.add_argument("--short", action="store_true", help="fewer attempts of each, at most two minutes in total")
    parser.add_argument("--only", help="measures, R4,R5")
    parser.add_argument("--seed", type=int, help="of all random choices but times; new in each run, and printed")
    parser.add_argument("--steps", type=int, help="R15: length of the drum")
    parser.add_argument("--other-build", help="R16: a build for another backend")
    parser.add_argument("--fuzz-build", help="R8: a build of the preset fuzz")
    parser.add_argument("--fuzz-seconds", type=int, help="R8: for each fuzzer")
    parser.add_argument("--sanitized-build", help="R13: a build of the preset openmp-sanitize")
    parser.add_argument("--sanitized-labels", help="R13: expression for the labels of the tests to run; all")
    parser.add_argument("--faults", help="R17: expression for the faults to plant; all")
    parser.add_argument("--faults-build", type=pathlib.Path, help="R17: folder for the copy of the source and its build, kept")
    parser.add_argument("--work", default=memory(), help="where files are made and removed; %(default)s")
    return parser.parse_args()


def memory():
    """A folder in memory, where there is one: a checkpoint after every step is slow on a disk."""
    shared = pathlib.Path("/dev/shm")
    return str(shared) if shared.is_dir() and shutil.disk_usage(shared).free > 2**30 else tempfile.gettempdir()


def chosen(arguments):
    if arguments.only:
        names = arguments.only.split(",")
        if unknown := [name for name in names if name not in MEASURES]:
            raise SystemExit(f"no measure {', '.join(unknown)}; there are {', '.join(in_order(MEASURES))}")
        return names
    return in_order(MEASURES)


def in_order(names):
    return sorted(names, key=lambda name: int(name[1:]))


def main():
    arguments = read_arguments()
    seed = arguments.seed if arguments.seed is not None else random.SystemRandom().randrange(2**31)
    names, rows = chosen(arguments), []
    if not (arguments.build / "examples" / "drum" / "drum").is_file():
        print(f"{arguments.build} has no examples; build them first")
        return NOT_BUILT
    print(f"seed {seed}, {arguments.build}", flush=True)
    with tempfile.TemporaryDirectory(prefix="scree-reliability-", dir=arguments.work) as work:
        pathlib.Path(work).chmod(0o755)
        for name in names:
            (pathlib.Path(work) / name).mkdir(mode=0o755)
            context = programs.Context(arguments.build.resolve(), pathlib.Path(work) / name, arguments.short,
                                       random.Random(f"{seed} {name}"), arguments)
            began = time.monotonic()
            found = MEASURES[name](context)
            for row in found if isinstance(found, list) else [found]:
                row.seconds = time.monotonic() - began
                tally.print_failures(row)
                rows.append(row)
            print(f"  {name}: {time.monotonic() - began:.0f} s", flush=True)
    print(tally.HEAD)
    for row in sorted(rows, key=lambda row: int(row.measure[1:])):
        print(row.row())
    return 1 if any(row.falls_short for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
