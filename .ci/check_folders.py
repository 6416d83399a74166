#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Folders of include/scree that include each other in a circle: python3 .ci/check_folders.py

Folders lie on floors: a folder includes only from lower ones. Prints the floors and how many headers and lines each folder has;
ends with exit code 1, and names the includes, if some folders form a circle."""
import collections
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent / "include/scree"


def folder_of(header):
    return header.relative_to(ROOT).parts[0]


def arrows():
    """For each folder, the folders that it includes from, with the includes."""
    found = collections.defaultdict(lambda: collections.defaultdict(list))
    for header in sorted(ROOT.rglob("*.[hi]pp")):
        if header.parent == ROOT:
            continue
        for name in re.findall(r'^#include "(.+)"', header.read_text(encoding="utf8"), re.MULTILINE):
            target = (header.parent / name).resolve()
            if target.parent != ROOT and folder_of(target) != folder_of(header):
                found[folder_of(header)][folder_of(target)].append(f"{header.relative_to(ROOT)} includes {target.relative_to(ROOT)}")
    return found


def main():
    found = arrows()
    sizes = collections.defaultdict(lambda: [0, 0])
    for header in ROOT.rglob("*.[hi]pp"):
        if header.parent != ROOT:
            sizes[folder_of(header)][0] += 1
            sizes[folder_of(header)][1] += len(header.read_text(encoding="utf8").splitlines())
    left, placed, floor = set(sizes), set(), 0
    while ready := {folder for folder in left if set(found[folder]) <= placed}:
        floor += 1
        print(f"floor {floor}: " + ", ".join(f"{name} ({sizes[name][0]}, {sizes[name][1]} lines)" for name in sorted(ready)))
        placed |= ready
        left -= ready
    if not left:
        return 0
    print(f"These folders include each other in a circle, or rest on one that does: {', '.join(sorted(left))}", file=sys.stderr)
    for folder in sorted(left):
        for other in sorted(set(found[folder]) & left):
            print(f"  {found[folder][other][0]}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
