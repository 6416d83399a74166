# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs the programs of a build folder and reads their results."""
import dataclasses
import os
import pathlib
import subprocess
import time

SOURCE = pathlib.Path(__file__).resolve().parents[2]


@dataclasses.dataclass
class Outcome:
    code: int  # exit code; -n: ended by signal n
    out: str
    err: str
    seconds: float

    @property
    def messages(self):
        """Lines on the standard error stream that are no remarks."""
        return [line for line in self.err.splitlines() if line and not line.startswith("note: ")]


def environment(threads=1):
    return {**os.environ, "OMP_NUM_THREADS": str(threads), "OMP_PROC_BIND": "false", "OMP_WAIT_POLICY": "passive"}


def start(command, threads=1, env_more=None, **options):
    """A process that goes on in the background; what it says is read by ended()."""
    return subprocess.Popen([str(word) for word in command], env={**environment(threads), **(env_more or {})}, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, **options)


def ended(process, began, limit=600):
    try:
        out, err = process.communicate(timeout=limit)
    except subprocess.TimeoutExpired:
        process.kill()
        process.communicate()
        raise
    return Outcome(process.returncode, out.decode(errors="replace"), err.decode(errors="replace"), time.monotonic() - began)


def run(command, threads=1, limit=600, **options):
    began = time.monotonic()
    return ended(start(command, threads, **options), began, limit)


@dataclasses.dataclass
class Context:
    """What every measure is given."""
    build: pathlib.Path
    work: pathlib.Path  # an empty folder for files
    short: bool
    random: object  # random.Random, with a seed that is printed
    arguments: object  # of the command line
    made: int = 0

    def folder(self):
        """A name for a folder that is not there yet."""
        self.made += 1
        return self.work / str(self.made)

    def pick(self, short, long):
        return short if self.short else long

    def program(self, name):
        return self.build / "examples" / name / name

    def test(self, name):
        return next((path for path in (self.build / "tests" / name, self.build / "tests" / name.removeprefix("test_") / name)
                     if path.is_file()), None)
