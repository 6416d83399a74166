# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R17: plants the faults of planted.py, one at a time, in a copy of the source, and expects a test to fail."""
import re
import shutil
import subprocess

import programs
from planted import FAULTS
from tally import Tally

PARTS = ("CMakeLists.txt", "README.md", "cmake", "docs", "include", "src", "tests")  # tests read the pages


def header(fault, source):
    return source / "include" / "scree" / fault.file


def not_plantable(fault, source):
    """Why a fault has no place in the source; empty: it has one."""
    stands = header(fault, source).read_text(encoding="utf-8").count(fault.before)
    return "" if stands == 1 else f"cannot be planted, '{fault.before}' stands {stands} times"


class Copy:
    """The source in another folder, where each file of tests is a program of its own."""

    def __init__(self, folder):
        self.source, self.build = folder / "source", folder / "build"
        self.source.mkdir(parents=True, exist_ok=True)
        for part in PARTS:
            self.copy(programs.SOURCE / part, self.source / part)
        subprocess.run(["cmake", "-S", self.source, "-B", self.build, "-G", "Ninja", "-DSCREE_TESTS_APART=ON",
                        "-DSCREE_BUILD_EXAMPLES=OFF", "-DSCREE_BUILD_BENCHMARKS=OFF", "-DCMAKE_BUILD_TYPE=Release"],
                       check=True, stdout=subprocess.DEVNULL)

    @staticmethod
    def copy(original, copied):
        """Leaves alone what is the same, so that it is not compiled again."""
        for path in [original] if original.is_file() else original.rglob("*"):
            target = copied / path.relative_to(original) if original.is_dir() else copied
            if path.is_file() and "__pycache__" not in path.parts:
                target.parent.mkdir(parents=True, exist_ok=True)
                if not target.exists() or target.read_bytes() != path.read_bytes():
                    shutil.copyfile(path, target)

    def test(self, source):
        """Whether a test program passes; an error text if it cannot be built."""
        name = "test_" + source.replace("/", "_")
        built = subprocess.run(["ninja", "-C", self.build, "-j1", name], capture_output=True, text=True, check=False)
        if built.returncode != 0:
            return built.stdout[-1500:] + built.stderr[-500:]
        try:
            return programs.run([self.build / "tests" / name], limit=900).code == 0
        except subprocess.TimeoutExpired:
            return False

    def with_fault(self, fault):
        """The same with a fault; the source is as before afterwards."""
        if problem := not_plantable(fault, self.source):
            return problem
        file = header(fault, self.source)
        text = file.read_text(encoding="utf-8")
        try:
            file.write_text(text.replace(fault.before, fault.after), encoding="utf-8")
            return self.test(fault.test)
        finally:
            file.write_text(text, encoding="utf-8")


def plantable():
    """R17, short: compiling takes too long, but each fault must still have its place."""
    tally = Tally("R17", "faults in the physics: each can be planted, and its test is there")
    for fault in FAULTS:
        problem = not_plantable(fault, programs.SOURCE)
        if not (programs.SOURCE / "tests" / f"{fault.test}.cpp").is_file():
            problem = f"there is no test {fault.test}"
        tally.check(not problem, f"{fault.name}: {problem}")
    return tally


def planted(context):
    """R17"""
    if context.short:
        return plantable()
    tally = Tally("R17", "faults planted in the physics, one at a time: a test fails")
    copy = Copy(context.arguments.faults_build or context.folder())
    right = {}  # what each test says without a fault
    for fault in FAULTS:
        if not re.search(context.arguments.faults or "", fault.name):
            continue
        if fault.test not in right:
            right[fault.test] = copy.test(fault.test)
        if right[fault.test] is not True:
            tally.check(False, f"{fault.test} does not pass without a fault: {right[fault.test]}")
            continue
        passes = copy.with_fault(fault)
        result = {True: f"survives {fault.test}", False: "killed"}.get(passes, f"not planted: {passes}")
        tally.check(result == "killed", f"{fault.name}: {result}")
        print(f"  {fault.name}: {result.splitlines()[0]}", flush=True)
    return tally


MEASURES = {"R17": planted}
