#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs a command and writes to a file what it took: python3 benchmarks/compile_time/spent.py [--build BUILD] FILE COMMAND...

FILE gets seconds of the processor (user and system, of all processes that the command started and waited for) and of the clock. With
--build it also gets the unit of budget.json, in seconds of the processor: the median of compilations of dependencies.cpp, one every
two minutes while the command runs, as soon as that has configured BUILD. A machine whose speed changes then changes both. The time
of these compilations is not counted. The exit code is that of the command."""
import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import threading
import time

import measure


class Units(threading.Thread):
    """Compiles dependencies.cpp now and then until it is told to stop."""
    PAUSE = 120

    def __init__(self, build):
        super().__init__(daemon=True)
        self.build, self.seconds, self.told_to_stop = build, [], threading.Event()

    def run(self):
        while not self.told_to_stop.wait(self.PAUSE):
            try:
                command = measure.command_of_examples(self.build)
            except (OSError, ValueError, RuntimeError):
                continue  # not configured yet, or being configured
            if command is not None:
                self.seconds.append(measure.seconds_of_unit(command))

    def stop(self):
        """The unit; none if the command ended before there was one."""
        self.told_to_stop.set()
        self.join()
        return statistics.median(self.seconds) if self.seconds else None


def spent(command, **options):
    """Exit code, seconds of the processor and of the clock."""
    began, before = time.monotonic(), os.times()
    code = subprocess.run(command, check=False, **options).returncode
    after = os.times()
    return code, after.children_user + after.children_system - before.children_user - before.children_system, time.monotonic() - began


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=pathlib.Path, metavar="FILE")
    parser.add_argument("--build", type=pathlib.Path)
    parser.add_argument("command", nargs=argparse.REMAINDER, metavar="COMMAND")
    options = parser.parse_args()
    if not options.command:
        parser.error("a command is missing")
    units = Units(options.build) if options.build else None
    if units:
        units.start()
    code, processor, clock = spent(options.command)
    unit = units.stop() if units else None
    processor -= sum(units.seconds) if units else 0
    options.file.parent.mkdir(parents=True, exist_ok=True)
    options.file.write_text(f"{processor:.1f} {clock:.1f}" + (f" {unit:.2f}" if unit else "") + "\n")
    print(f"{processor:.0f} s of the processor, {clock:.0f} s of the clock" +
          (f"; {measure.UNIT}.cpp took {unit:.2f} s of the processor meanwhile" if unit else ""))
    return code if code >= 0 else 128 - code


if __name__ == "__main__":
    sys.exit(main())
