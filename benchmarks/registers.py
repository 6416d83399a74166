#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Registers, stack and spills of the kernels of bench_pairs: python3 benchmarks/registers.py BUILD [WORD]

BUILD is a configured CUDA build folder; its sources whose path holds WORD (default pairs/3d_float) are compiled anew."""
import json
import pathlib
import re
import shlex
import subprocess
import sys

# Parts of a symbol that are the same for all, or told by the rest; kernels with which Kokkos fills and copies its arrays.
SAME = re.compile(r"\b(?:scree|Kokkos|Impl|detail|bench|by_hand|std)::")
OF_KOKKOS = re.compile(r"<View(?:Fill|Copy|ValueFunctor)<")


def short(symbol):
    """A pair loop by its terms, others by the beginning of their name; nothing for Kokkos' own."""
    name = SAME.sub("", subprocess.run(("c++filt", symbol), capture_output=True, text=True).stdout.strip())
    if OF_KOKKOS.search(name):
        return None
    terms = re.search(r"View, \w+, ((?:(?!::View)[^()])*?)> >", name)
    if "PairLoop<" in name and terms:
        return "pair loop: " + terms[1] + ">" * (terms[1].count("<") - terms[1].count(">"))
    return re.sub(r"^void (?:cuda_parallel_launch\w*<)?(?:ParallelFor<)?|, RangePolicy<.*$", "", name)[:100]


def report(command, folder):
    words = shlex.split(command)
    words = words[next(k for k, word in enumerate(words) if word.endswith("nvcc_wrapper")):]
    words[words.index("-o") + 1] = "/dev/null"
    return subprocess.run([*words, "-Xptxas", "-v"], cwd=folder, capture_output=True, text=True, check=True).stderr


def main():
    build = pathlib.Path(sys.argv[1])
    wanted = sys.argv[2] if len(sys.argv) > 2 else "pairs/3d_float"
    print("| kernel | registers | stack, bytes | spilled, bytes |\n|---|---|---|---|")
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if wanted not in entry["file"]:
            continue
        text = report(entry["command"], entry["directory"])
        for symbol, stack, stores, loads, registers in re.findall(
                r"Compiling entry function '(\w+)'.*?(\d+) bytes stack frame, (\d+) bytes spill stores, "
                r"(\d+) bytes spill loads.*?Used (\d+) registers", text, re.DOTALL):
            name = short(symbol)
            if name:
                print(f"| {name} | {registers} | {stack} | {int(stores) + int(loads)} |", flush=True)


if __name__ == "__main__":
    main()
