# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Finds assignments of lists that name members, `x = {.b = 1}`, which nvcc 13.0 compiles wrongly in templates.

There it drops the names: the values go to the first members of the class, without a word. `x = Type{.b = 1}` and declarations
are compiled rightly, and so are lists that begin with the first member and leave none out before the last one, which a
program cannot tell. So the headers of the library and of examples and benchmarks, which are templates, have none.

    python3 assigned_lists.py <the repository>
"""
import pathlib
import re
import sys

# What is assigned to has no type before it and begins the line; `using x = {` is no C++.
ASSIGNED = re.compile(r"^\s*(?:\(?\*?this\)?->|[A-Za-z_])[\w.()\[\]:>-]*\s=\s\{+\.", re.MULTILINE)


def found_in(text):
    """The numbers of the lines with such an assignment."""
    return [text.count("\n", 0, match.end()) + 1 for match in ASSIGNED.finditer(text)]


def main():
    assert found_in("  a.b = {.c = 1};\n  history_ = {.c = 2};\n  v[0] = {{.c = 1}};") == [1, 2, 3]
    assert not found_in("  A const b = {.c = 1};\n  a = A{.c = 2};\n  f({.c = 1});\n  A b{.c = 1};\n  // x = {.a = 1}")
    root = pathlib.Path(sys.argv[1])
    faults = []
    for folder in ("include", "examples", "benchmarks"):
        for header in sorted((root / folder).rglob("*.hpp")):
            faults += [f"{header.relative_to(root)}:{line}" for line in found_in(header.read_text())]
    for fault in faults:
        print(f"{fault}: name the type, `x = Type{{.member = ...}}`: nvcc 13.0 drops the names of members here")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
