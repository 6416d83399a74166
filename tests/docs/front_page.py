#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""README.md is short, and each of its figures is that of the place where it was measured: front_page.py REPOSITORY."""
import math
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
MOST_WORDS = 800
NUMBER = r"\d+(?:\.\d+)?(?:e-?\d+)?"


def text(path):
    return (ROOT / path).read_text(encoding="utf8")


def found(path, pattern):
    match = re.search(pattern, text(path), re.DOTALL)
    return match.groups() if match else None


def prose(page):
    """A page without code, addresses of links, and names in back quotes."""
    page = re.sub(r"^```.*?^```", "", page, flags=re.DOTALL | re.MULTILINE)
    return re.sub(r"`[^`]*`", "", re.sub(r"\]\([^)]*\)", "]", page))


def run_out_of_printed():
    """In half-widths, from the last line that the program prints."""
    left, right = (float(each) for each in re.findall(r"^0\.5 s: .* from (\S+) to (\S+) mm", text("README.md"), re.MULTILINE)[-1])
    return (f"{((right - left) / 2 - 50) / 50:.1f}",)


def order(values, *places):
    return values and tuple(values[place] for place in places)


def versions(pattern):
    """The lowest and the highest version of the CI."""
    all_of_them = [int(each) for each in re.findall(pattern, text(".github/workflows/ci.yaml"))]
    return str(min(all_of_them)), str(max(all_of_them))


def of_residual_viscosity(column):
    """The largest deviation in a column of the table of Bagnold flows, %, and the lowest and the highest angle."""
    table = found(CASES, r"\| angle, rows, from \|(.*?)\n\n")[0]
    rows = [line.split("|") for line in table.splitlines() if re.match(r"\| \d\d, ", line)]
    return max(abs(float(row[column].strip(" %*"))) for row in rows), rows[0][1].split(",")[0].strip(), rows[-1][1].split(",")[0].strip()


def bars_of_soil():
    """The bar of the rows on soil against walls, where all have the same one."""
    table = found(CASES, r"\| case \| exact \| measured \| bar \| control \|(.*?)\n\n")[0]
    bars = {line.split("|")[4].strip() for line in table.splitlines() if line.startswith("| ") and "---" not in line}
    return (bars.pop().removesuffix(" %"),) if len(bars) == 1 else None


# A piece of the page, each group a figure, and what the figures are.
COLUMN = "examples/column_collapse/README.md"
BOX, DRUM = "examples/shear_box/README.md", "examples/drum/README.md"
CASES = "docs/theory/verification.md"
BANDS = r"experiments give (\S+) to (\d\.\d)"
FIGURES = [
    (r"g\+\+ (\d+) to (\d+)", lambda: versions(r"cxx: g\+\+-(\d+)")),
    (r"clang (\d+) to (\d+)", lambda: versions(r"cxx: clang\+\+-(\d+)")),
    (r"nvcc (\d+)", lambda: found(".github/workflows/ci.yaml", r"nvidia/cuda:(\d+)")),
    (r"Debian (12), (13), Ubuntu (24\.04)", lambda: found("docs/install.md", r"Debian (12) and (13), Ubuntu (24\.04)")),
    (r"C\+\+(20)", lambda: found("cmake/library.cmake", r"cxx_std_(\d+)")),
    (r"Version (\S+) ", lambda: found("CMakeLists.txt", r"project\(scree VERSION (\S+)")),
    (r"Apache-(2\.0)", lambda: found("cmake/packages.cmake", r"Apache-(2\.0)")),
    (r"run-out is (\S+) L0", lambda: found(COLUMN, r"run-out of (\S+) L0")),
    (r"experiments \((\S+)0 to (\S+)0 L0\)", lambda: found(COLUMN, BANDS)),
    (r"\[experiments\] (\S+) to (\d\.\d)", lambda: found(COLUMN, BANDS)),
    (r"draw: (\d+) s of processor", lambda: found("docs/performance.md", r"\| all of it \| \*\*(\d+)\*\* \|")),
    (r"takes (\d+) s of processor time to compile \(g\+\+ (\d+); (\d+) s with the compiled library\) and (\d+) s to run", lambda: order(found(
        "docs/performance.md", r"With g\+\+ (\d+), -O3 and one core, the program of the README compiles in (\d+) s, with `scree::compiled` "
                               r"in (\d+) s, and runs for (\d+) s"), 1, 0, 2, 3)),
    (r"out by (\S+) half-widths", run_out_of_printed),
    (r"concentration (\S+) at (\S+) H", lambda: (
        f"{float(found(BOX, r'conservative, oscillating (?:[|] [^|]+){2}[|] ([^ ]+)')[0]):.1e}".replace("e-0", "e-"),
        found(BOX, r"scheme, box (?:\| [^|]+){2}\| ([^ ]+)")[0])),
    (r"surface at (\S+) degrees, (\S+) cm/s", lambda: (*found(DRUM, r"surface angle, degrees \| (\S+)"),
                                                     *found(DRUM, r"surface speed, cm/s \| (\S+)"))),
    (r"(\d+) to (\d+) degrees; (\d+) to (\d+) cm/s by DEM", lambda: (
        *found(DRUM, r"flat, (\d+) to (\d+) \|"), *found(DRUM, r"DEM the paper quotes for EV has (\d) at 20 s, (\d) at 40 s"))),
    (r"mean within (\d) %, moments within (\S+) %, at (\d+) to (\d+) degrees", lambda: (
        f"{math.ceil(of_residual_viscosity(2)[0])}", f"{of_residual_viscosity(3)[0]}", *of_residual_viscosity(2)[1:])),
    (r"silo\] \| within (\d) %", bars_of_soil),
    (r"an H200: (\S+)\nto (\S+) times", lambda: (*found("docs/comparison.md", r"7 452 108 \|[^|]+\|[^|]+\| (\S+)"),
                                                  *found("docs/comparison.md", r"66 108 \|[^|]+\|[^|]+\| (\S+)"))),
    (r"Wu \((\d+)\)", lambda: found("docs/refs.bib", r"\{Zhu2024,.*?year = \{(\d+)\}")),
    (r"Fluid Mech.\* (\d+), A(\d+)", lambda: found("docs/refs.bib", r"\{Zhu2024,.*?volume = \{(\d+)\}, pages = \{A(\d+)\}")),
]
IN_WORDS = [  # words that are figures
    ("README.md", r"all tests: half an hour", "cmake/quickstart.sh", r"all tests: this takes about half an hour"),
    ("README.md", r"--quick two minutes", "cmake/quickstart.sh", r"This takes about two minutes"),
]


def main():
    page, wrong = text("README.md"), []
    if len(page.split()) > MOST_WORDS:
        wrong.append(f"README.md has {len(page.split())} words, at most {MOST_WORDS} are wanted")
    left = prose(page)
    code = "\n".join(re.findall(r"^```bash\n(.*?)^```", page, re.DOTALL | re.MULTILINE))
    for pattern, source in FIGURES:
        shown = re.search(pattern, re.sub(r"\]\([^)]*\)", "]", page))
        right = source()
        if not shown or not right or shown.groups() != right:
            wrong.append(f"/{pattern}/: the page has {shown and shown.groups()}, its source {right}")
        left = re.sub(pattern, "", left, count=1)
        code = re.sub(pattern, "", code, count=1)
    for here, pattern, there, source in IN_WORDS:
        if not re.search(pattern, text(here)) or not re.search(source, text(there)):
            wrong.append(f"/{pattern}/ of {here} is not /{source}/ of {there}")
    eight = len(list((ROOT / "examples").glob("*/main.cpp")))
    if not re.search(r"^- Eight \[applications\]", page, re.MULTILINE) or eight != 8:
        wrong.append(f"the page says eight applications, there are {eight}")
    wrong += [f"no source is known for '{number}' in: {line.strip()}" for line in (left + code).splitlines()
              for number in re.findall(rf"(?<![\w.])(?:{NUMBER})(?![\w.]*\w)", line)]
    print("\n".join(wrong) or f"{len(page.split())} words, {len(FIGURES) + len(IN_WORDS) + 1} groups of figures")
    sys.exit(bool(wrong))


if __name__ == "__main__":
    main()
