#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs a command and writes to a file what it took: python3 benchmarks/compile_time/spent.py FILE COMMAND...

FILE gets seconds of the processor (user and system, of all processes that the command started and waited for) and of the clock.
The exit code is that of the command."""
import os
import pathlib
import subprocess
import sys
import time


def spent(command, **options):
    """Exit code, seconds of the processor and of the clock."""
    began, before = time.monotonic(), os.times()
    code = subprocess.run(command, check=False, **options).returncode
    after = os.times()
    return code, after.children_user + after.children_system - before.children_user - before.children_system, time.monotonic() - began


def main():
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    code, processor, clock = spent(sys.argv[2:])
    file = pathlib.Path(sys.argv[1])
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(f"{processor:.1f} {clock:.1f}\n")
    print(f"{processor:.0f} s of the processor, {clock:.0f} s of the clock")
    return code if code >= 0 else 128 - code


if __name__ == "__main__":
    sys.exit(main())
