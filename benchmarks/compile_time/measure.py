#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Time and memory that it takes to compile scree, and its code: python3 benchmarks/compile_time/measure.py BUILD [--only WORD]

BUILD is a configured build folder with the examples; nothing needs to be built in it. Prints a table and compares it with
budget.json. There times are multiples of that of dependencies.cpp, compiled just before each source, so that they hold on slow
machines and on machines whose speed changes. One compiler runs at a time: two share caches, which costs a large source more than a
small one. A source over its budget is measured up to four times more; the shortest times count, since other work only adds to
them. They still differ by a tenth from one minute to the next, machine code (kB) does not: it shows what is compiled again in
every program, with g++ 12.2. Ends with exit code 1 if a budget is exceeded."""
import argparse
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
EXAMPLES = HERE.parent.parent / "examples"
UNIT = "dependencies"
COMPILED = "-DSCREE_COMPILED"  # programs that link scree::compiled


def cases(known):
    """Name and source of all that is measured, the unit first: sources of this folder and the program of README.md from headers
    alone and, where they have formulations, with the library ("compiled"). Of examples, which link it, the one of their simulation
    in 3D."""
    own = [HERE / f"{name}.cpp" for name in (UNIT, "umbrella_header", "one_formulation", "two_formulations", "twenty_groups")]
    own += [path for path in known if path.name == "readme.cpp"]  # which tests/docs/CMakeLists.txt takes from the page
    for source in own:
        yield source.stem, source
        if source.stem not in (UNIT, "umbrella_header"):
            yield f"{source.stem}, compiled", source
    for example in sorted(path.parent for path in EXAMPLES.glob("*/CMakeLists.txt")):
        instances = sorted(path for path in known if path.parent.name == example.name and path.stem.startswith("simulate_"))
        if instances or (example / "main.cpp").exists():
            yield f"example {example.name}", (instances or [example / "main.cpp"])[-1]


def entries(build):
    """Each source of the build folder with the compiler's command for it, without launchers such as ccache and without what only
    the builds of scree itself have, cmake/own_programs.cmake."""
    compiler = next(line.split("=", 1)[1] for line in (build / "CMakeCache.txt").read_text().splitlines()
                    if line.startswith("CMAKE_CXX_COMPILER:"))
    for entry in json.loads((build / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])
        yield pathlib.Path(entry["file"]).resolve(), [word for word in words[words.index(compiler):] if not word.startswith("--param=ggc")]


def commands(build):
    """The command for each source; one of them where several targets have it."""
    return dict(entries(build))


def command_of_examples(build):
    """The command for one of the examples; none if they are not built there."""
    return next((words for source, words in entries(build) if EXAMPLES in source.parents), None)


def code_of(object_file):
    """Kilobytes of code and constants."""
    table = subprocess.run(["size", object_file], capture_output=True, text=True, check=True).stdout
    return int(table.splitlines()[1].split()[0]) / 1000


def compile_once(command, source, look=lambda object_file: None):
    """Seconds of the processor, megabytes of the largest process, and what `look` finds in the object file."""
    words = list(command)
    with tempfile.TemporaryDirectory() as folder:
        words[words.index("-o") + 1] = str(pathlib.Path(folder) / "object.o")
        words[words.index("-c") + 1] = str(source)
        process = subprocess.Popen(words, cwd=folder, stderr=subprocess.PIPE, text=True, env={**os.environ, "CCACHE_DISABLE": "1"})
        errors = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            raise SystemExit(f"{source} does not compile:\n{errors}")
        return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, look(words[words.index("-o") + 1])


def seconds_of_unit(command):
    """What dependencies.cpp takes."""
    return compile_once(command, HERE / f"{UNIT}.cpp")[0]


def exceeds(figures, allowed):
    return any(figures[key] > most for key, most in (allowed or {}).items())


def measure(command, source, unit_command, allowed):
    """Seconds, multiple of the unit, megabytes and kilobytes of code of one source: the least of each."""
    units, runs = [seconds_of_unit(unit_command)], []
    for _ in range(5):
        units.append(seconds_of_unit(unit_command))
        runs.append(compile_once(command, source, code_of))
        seconds, megabytes, kilobytes = map(min, zip(*runs))
        figures = {"multiple": seconds / min(units), "seconds": seconds, "megabytes": megabytes, "kilobytes": kilobytes}
        if figures["multiple"] <= (allowed or figures)["multiple"]:
            break
    return figures


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", default="", help="cases whose name holds this word")
    parser.add_argument("--json", type=pathlib.Path, help="write the figures to this file")
    options = parser.parse_args()
    budget = json.loads((HERE / "budget.json").read_text())
    known = commands(options.build)
    any_example = command_of_examples(options.build)
    if any_example is None:
        raise SystemExit(f"{options.build} was configured without the examples")

    def figures_of(name, source):
        command = known.get(source.resolve(), any_example)
        if not name.startswith("example "):
            command = [word for word in command if word != COMPILED]
            if name.endswith(", compiled"):
                command.insert(1, COMPILED)
        return measure(command, source, any_example, budget.get(name))

    measured, failures = {}, []
    print(f"| {'source':24} | seconds | x {UNIT} | MB | kB of code | budget |\n|---|---|---|---|---|---|")
    for name, source in cases(known):
        if options.only not in name:
            continue
        figures, allowed = figures_of(name, source), budget.get(name)
        text = "none"
        if allowed:
            text = f"x {allowed['multiple']}, {allowed['megabytes']} MB"
            text += f", {allowed['kilobytes']} kB" if "kilobytes" in allowed else ""
        if exceeds(figures, allowed):
            failures.append(name)
            text += ": exceeded"
        measured[name] = figures
        print(f"| {name:24} | {figures['seconds']:.1f} | {figures['multiple']:.2f} | {figures['megabytes']:.0f} | "
              f"{figures['kilobytes']:.0f} | {text} |", flush=True)
    if "two_formulations" in measured and "one_formulation" in measured:
        more = measured["two_formulations"]["seconds"] - measured["one_formulation"]["seconds"]
        print(f"\nOne more formulation: {more:.1f} s")
    if options.json:
        options.json.write_text(json.dumps(measured, indent=1) + "\n")
    if failures:
        raise SystemExit("over budget: " + ", ".join(failures))


if __name__ == "__main__":
    sys.exit(main())
