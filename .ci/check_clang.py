#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Errors and warnings of clang in the examples and the course: python3 .ci/check_clang.py BUILD [WORD]

BUILD is a build folder of g++ configured with the examples; nothing needs to be built in it. clang++ only reads the sources, one
instance of each example, and writes no code. With WORD: of all sources, tests too, those whose path holds it."""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FLAGS = ["-fsyntax-only", "-Werror", "-Wno-unknown-warning-option", "-Wno-ignored-optimization-argument"]


def sources(build, word):
    """Path of each source and the words of the command that compiles it."""
    seen = set()
    for entry in json.loads((build / "compile_commands.json").read_text()):
        path = pathlib.Path(entry["file"])
        made = build / "examples" in path.parents
        if word:
            wanted = word in str(path) and path.suffix == ".cpp"
        else:
            wanted = ROOT / "examples" in path.parents or (made and path.parent not in seen)
        if wanted:
            if made:
                seen.add(path.parent)
            yield path, shlex.split(entry["command"])


def of_clang(clang, command):
    """The command without the compiler, its output and its precompiled header, whose headers are included."""
    compiler = next(i for i, word in enumerate(command) if pathlib.Path(word).name in ("c++", "g++") or "g++-" in word)
    words = [word for word in command[compiler + 1:] if word not in ("-Winvalid-pch", "-c") and not word.startswith("--param=ggc")]
    output = words.index("-o")
    del words[output:output + 2]
    for at in [k for k, word in enumerate(words) if word.endswith("cmake_pch.hxx")][::-1]:
        headers = re.findall(r'^#include [<"](.+)[>"]', pathlib.Path(words[at]).read_text(encoding="utf8"), re.MULTILINE)
        words[at - 1:at + 1] = [word for header in headers for word in ("-include", header)]
    return [clang, *words, *FLAGS]


def main():
    if len(sys.argv) not in (2, 3):
        raise SystemExit(__doc__)
    build, word = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2] if len(sys.argv) == 3 else ""
    clang = next((found for name in ("clang++-14", "clang++") if (found := shutil.which(name))), None)
    if clang is None:
        raise SystemExit("clang++ is missing")

    def check(item):
        path, command = item
        return path, subprocess.run(of_clang(clang, command), cwd=build, capture_output=True, text=True)

    count, failures = 0, 0
    with concurrent.futures.ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        for path, result in pool.map(check, sources(build, word)):
            count += 1
            if result.returncode != 0:
                failures += 1
                print(f"{path.name}:\n{result.stderr}", flush=True)
    print(f"{clang}: {count} sources, {failures} with errors or warnings")
    return 1 if failures or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
