#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs the benchmark programs of a build folder and keeps their results in benchmarks/results/MACHINE/PROGRAM.json:
python3 benchmarks/run.py BUILD [--only WORD] [--rows REGEX] [--repetitions 5]

MACHINE is the name of the GPU, or that of the CPU with its number of threads, unless --machine names it."""
import argparse
import json
import os
import pathlib
import re
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

# What Google Benchmark says that describes neither machine nor build, or that the name of a row says already.
LEFT_OUT_OF_CONTEXT = ("host_name", "executable", "library_build_type", "load_avg", "caches", "cpu_scaling_enabled")
LEFT_OUT_OF_ROWS = ("family_index", "per_family_instance_index", "run_name", "repetition_index", "repetitions", "threads")


def git(*words):
    return subprocess.run(("git", "-C", HERE, *words), capture_output=True, text=True).stdout.strip()


def commit():
    return (git("rev-parse", "--short=12", "HEAD") or "unknown") + ("-modified" if git("status", "--porcelain") else "")


def cpu():
    model = re.search(r"^model name\s*:\s*(.*)$", pathlib.Path("/proc/cpuinfo").read_text(), re.MULTILINE)
    return model[1] if model else "cpu"


def folder_name(context):
    name = context.get("device") or f"{cpu()} {context['concurrency']} threads"
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def run(program, options):
    """Results as Google Benchmark writes them, with the commit and the CPU in their context."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        subprocess.run((program, f"--benchmark_out={out.name}", "--benchmark_out_format=json",
                        f"--benchmark_filter={options.rows}", f"--benchmark_repetitions={options.repetitions}",
                        "--benchmark_display_aggregates_only=true", f"--benchmark_min_time={options.min_time}"),
                       check=True, env={"OMP_PROC_BIND": "false", **os.environ})
        text = out.read()
    if not text:  # no row matches
        return {}, []
    results = json.loads(text)
    context = {key: value for key, value in results["context"].items() if key not in LEFT_OUT_OF_CONTEXT}
    rows = [{key: value for key, value in row.items() if key not in LEFT_OUT_OF_ROWS}
            for row in results["benchmarks"] if row["run_type"] == "iteration"]
    return {**context, "commit": commit(), "cpu": cpu()}, rows


def write(path, context, rows):
    """One line for each row, so that files can be read and compared."""
    path.parent.mkdir(parents=True, exist_ok=True)
    lines = ",\n".join("  " + json.dumps(row) for row in rows)
    path.write_text(f'{{"context": {json.dumps(context, indent=1)},\n"benchmarks": [\n{lines}\n]}}\n')
    print(f"wrote {path}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--only", default="", help="programs whose name holds this word")
    parser.add_argument("--rows", default=".", help="rows that match this regular expression")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--min-time", type=float, default=0.2, help="seconds that each repetition lasts at least")
    parser.add_argument("--machine", help="name of the folder of the results")
    parser.add_argument("--out", type=pathlib.Path, default=HERE / "results")
    options = parser.parse_args()
    programs = [path for path in sorted((options.build / "benchmarks").rglob("bench_*"))
                if path.is_file() and os.access(path, os.X_OK) and options.only in path.name]
    if not programs:
        raise SystemExit(f"no benchmark programs in {options.build}: build them first")
    load, cores = os.getloadavg()[0], os.cpu_count()
    if load > 0.2 * cores:
        print(f"Beware: others are at work on this machine (load {load:.1f} of {cores} cores).")
    for program in programs:
        context, rows = run(program, options)
        if rows:
            write(options.out / (options.machine or folder_name(context)) / f"{program.name}.json", context, rows)


if __name__ == "__main__":
    main()
