#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What takes longest of compiling and testing: python3 benchmarks/compile_time/dearest.py BUILD [COUNT] [--budget [--spent FILE]]

Prints the sources that took longest to compile in a build folder of ninja, and the tests that took longest in the last run of CTest
there, with seconds of the clock; what came from a compiler cache took next to none.

--budget compares them with "dearest" in budget.json: the dearest source, the ten dearest together, the same of the tests, and the
whole, for which spent.py has written what building and testing took (FILE). All are multiples of the processor time of
dependencies.cpp: compiled now or, for the whole, while it ran. Other work on the machine makes seconds of the clock longer, never shorter. So what is
within its budget by the clock is within it; what is not is done again alone, and its processor time decides. A compiler cache makes
sources cheaper: they are then within. Ends with exit code 1 if a budget is exceeded."""
import argparse
import json
import pathlib
import re
import statistics
import subprocess
import sys

import measure
import spent


def sources_of(build):
    """Seconds of the clock of each object file."""
    seconds = {}
    log = build / ".ninja_log"
    for line in log.read_text().splitlines()[1:] if log.is_file() else []:
        start, end, _, output, *_ = line.split("\t")
        if output.endswith(".o"):
            seconds[output.removesuffix(".o")] = (int(end) - int(start)) / 1000  # the last build of each counts
    return seconds


def tests_of(build):
    """Seconds of the clock of each test of the last run."""
    log = build / "Testing" / "Temporary" / "LastTest.log"
    seconds, name = {}, ""
    for line in log.read_text(errors="replace").splitlines() if log.is_file() else []:
        if found := re.match(r"\d+/\d+ Testing: (.*)$", line):
            name = found[1]
        elif found := re.match(r"Test time = +([\d.]+) sec$", line):
            seconds[name] = float(found[1])
    return seconds


def dearest(seconds, count):
    return sorted(seconds.items(), key=lambda item: -item[1])[:count]


def print_table(what, seconds, count):
    print(f"The {count} dearest of {len(seconds)} {what}s, {sum(seconds.values()):.0f} s in all:\n| s | {what} |\n|---|---|")
    for name, time in dearest(seconds, count):
        print(f"| {time:.1f} | {name} |")


class Watch:
    """Compares figures with budgets that are multiples of a unit."""

    def __init__(self, build, budget):
        self.build, self.budget, self.failures = build, budget, []
        self.sources = {words[words.index("-o") + 1].removesuffix(".o"): (words, source) for source, words in measure.entries(build)}
        command = measure.command_of_examples(build)
        if command is None:
            raise SystemExit(f"{build} was configured without the examples")
        self.unit = statistics.median(measure.seconds_of_unit(command) for _ in range(3))
        print(f"\n{measure.UNIT}.cpp: {self.unit:.2f} s of the processor, the unit of the budget")

    def source_alone(self, name):
        """Seconds of the processor."""
        return measure.compile_once(*self.sources[name])[0]

    def test_alone(self, name):
        """Seconds of the processor or of the clock, the smaller one: a test may use several cores, or wait."""
        command = ["ctest", "--test-dir", str(self.build), "--tests-regex", f"^{re.escape(name)}$", "--fixture-exclude-any", ".*"]
        _, processor, clock = spent.spent(command, stdout=subprocess.DEVNULL)
        return min(processor, clock)

    def compare(self, what, seconds):
        """The figures of sources or of tests; `seconds` by the clock."""
        if not seconds:
            print(f"{what}s: not compared, there is no log of them")
            return
        alone_of = {"source": self.source_alone, "test": self.test_alone}[what]
        top, slowed = dearest(seconds, 10), None  # how much longer the clock was than alone

        def again(name, time):
            nonlocal slowed
            alone = min(time, alone_of(name))
            if alone > self.budget[what] * self.unit:
                alone = min(alone, alone_of(name))  # other work on the machine makes processor time longer, too
            print(f"{name}: {time:.1f} s in the run, {alone:.1f} s alone")
            slowed = max(slowed or 1, time / alone)
            return alone

        for name, time in top:
            if time <= self.budget[what] * self.unit:
                break  # and so are the others
            self.check(f"the {what} {name}", again(name, time), self.budget[what])
        together, allowed = sum(time for _, time in top), self.budget[f"ten {what}s"]
        if together > allowed * self.unit and slowed is None:
            again(*top[0])
        self.check(f"the ten dearest {what}s", together / (slowed or 1), allowed)

    def check(self, what, seconds, allowed, unit=None):
        multiple = seconds / (unit or self.unit)
        text = f"{what}: {multiple:.1f} units of {allowed} that are allowed"
        print(text)
        if multiple > allowed:
            self.failures.append(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("count", type=int, nargs="?", default=10)
    parser.add_argument("--budget", action="store_true", help="compare with budget.json")
    parser.add_argument("--spent", type=pathlib.Path, help="what spent.py wrote of building and testing")
    options = parser.parse_args()
    sources, tests = sources_of(options.build), tests_of(options.build)
    print_table("source", sources, options.count)
    print_table("test", tests, options.count)
    if not options.budget:
        return
    watch = Watch(options.build, json.loads((measure.HERE / "budget.json").read_text())["dearest"])
    watch.compare("source", {name: time for name, time in sources.items() if name in watch.sources})
    watch.compare("test", tests)
    if options.spent:
        figures = list(map(float, options.spent.read_text().split())) if options.spent.is_file() else []
        if not figures:
            print(f"the whole: not compared, {options.spent} is missing")
        else:
            watch.check("building and testing", figures[0], watch.budget["whole"], *figures[2:])  # or with the unit of now
    if watch.failures:
        raise SystemExit("over budget (benchmarks/compile_time/budget.json, \"dearest\"): " + "; ".join(watch.failures))


if __name__ == "__main__":
    sys.exit(main())
