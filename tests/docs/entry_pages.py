#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The figures of the pages that a newcomer reads after README.md are those of the places where they were measured or are declared:
entry_pages.py REPOSITORY. A number of these pages that has no source, and is none of their own records, is a fault."""
import collections
import re
import sys

from front_page import COLUMN, DRUM, NUMBER, ROOT, found, prose, text, versions

COURSE = "examples/course/README.md"
SPEED = "docs/performance.md"
VIEW = "examples/view/page.py"


def compile_cost():
    """The processor time of one formulation, s, and its memory, GB, from the multiples in the table of compile times."""
    low, high = found(SPEED, r"headers of Kokkos, Eigen and fmt alone, which take (\S+) to (\S+) s")
    multiple, memory = found(SPEED, r"\| one formulation \| \S+ \| \*\*(\S+)\*\* \| (\d+) MB")
    return f"{float(multiple) * float(low):.0f}", f"{float(multiple) * float(high):.0f}", f"{float(memory) / 1000:.2f}", "12"


def passed_on_gpu():
    """The sum of the table of tests on a GPU."""
    table = found("docs/install.md", r"\| folder \| passed \|.*?\n\|[-|]+\|\n(.*?)\n\n")[0]
    return (str(sum(int(number) for number in re.findall(r"\| (\d+)(?: of \d+)? (?=\|)", table))),)


def speeds(size):
    """Of the benchmark of LOQUAT: scree, LOQUAT, and their ratio."""
    row = re.search(rf"^\| {size} \| (\S+) M(?: \([^)]*\))? \| (\S+) M \((?:\S+ ms, )?(\S+) times\)", text(SPEED), re.MULTILINE)
    return row and (row[2], row[1], row[3])


def time_of(program):
    """Of a program of the course."""
    return found(COURSE, rf"\[{program}\]\([^)]*\) \| [^|]+ \| (\d+) s \|")


def systems():
    return found("cmake/quickstart.sh", r"Debian (\d+) or (\d+)[^\n]*Ubuntu (\S+?)[\s,;.]") or found("README.md", r"Debian (12), (13), Ubuntu (24\.04)")


# For each page: pieces of it, each group a figure, with what the figures are. The pages have no addresses of links here.
PAGES = {
    "docs/start.md": [
        (r"Debian (\d+) or (\d+) or Ubuntu (24\.04)", systems),
        (r"run takes (\d+) s on one core", lambda: time_of("01_first_steps")),
        (r"after (1) s the walls bear (\S+) of the weight", lambda: (
            *found("examples/course/01_first_steps.cpp", r"argument<double>\(argc, argv, 1, (\d+)\)"),
            *found(COURSE, r"force on the walls ends at the weight, mean of the last 0\.3 s (\S+) \|"))),
        (r"ParaView (\S+) or later", lambda: found("docs/looking_at_results.md", r"ParaView (\S+) or later")),
        (r"kernel, (\S+) dr by default", lambda: found("include/scree/solver/settings.hpp", r"double smoothing = ([\d.]+);")),
        (r"interact up to (\d) h", lambda: found("include/scree/kernels/wendland_c2.hpp", r"double support = (\d);")),
        (r"radius (\d) h", lambda: found("include/scree/kernels/wendland_c2.hpp", r"double support = (\d);")),
        (r"formulation takes (\d+) to (\d+) s and (\S+) GB \(g\+\+ (\d+),", compile_cost),
    ],
    "docs/faq.md": [
        (r"(\d+) to (\d+) s and (\S+) GB for one formulation \(g\+\+ (\d+),", compile_cost),
        (r"ParaView (\S+) or later", lambda: found("docs/looking_at_results.md", r"ParaView (\S+) or later")),
        (r"Debian (12) has ParaView (\S+),", lambda: found("docs/looking_at_results.md", r"Debian (12) has (\S+),")),
        (r"C\+\+(20)", lambda: found("cmake/library.cmake", r"cxx_std_(\d+)")),
        (r"segregation takes (\d+) to (\d+) bytes in float\n\(\[measured\]\), about (1) GB for each million", lambda: (
            *(low_high := found(SPEED, r"with segregation, float, 113 neighbours: (\d+) to (\d+) bytes")),
            f"{(float(low_high[0]) + float(low_high[1])) / 2000:.0f}")),
    ],
    "docs/install.md": [
        (r"Debian (\d+) and (\d+), Ubuntu (24\.04)", systems),
        (r"C\+\+(20)", lambda: found("cmake/library.cmake", r"cxx_std_(\d+)")),
        (r"g\+\+ (\d+) to (\d+);", lambda: versions(r"cxx: g\+\+-(\d+)")),
        (r"\| CMake \| 3\.25 to 4\.4 \| (\S+) \|", lambda: found("CMakeLists.txt", r"cmake_minimum_required\(VERSION (\S+)\)")),
        (r"\| memory \| (\S+) GB", lambda: compile_cost()[2:3]),
        (r"tests up to (\d) GB for each", lambda: found("tests/CMakeLists.txt", r"a batch takes up to (\d) GB")),
        (r"at a time\n\(\): (\d+) tests", passed_on_gpu),
        (r"Kokkos >= (5\.0\.2), Eigen (\S+) or (\d), fmt >= (10\.1)", lambda: (
            *found("cmake/kokkos.cmake", r"SCREE_KOKKOS_VERSION (\S+)\)"), *found("cmake/dependencies.cmake", r"scree needs Eigen (\S+) or (\d)"),
            *found("cmake/dependencies.cmake", r"find_package\(fmt (\S+) "))),
        (r"run and drawn within (\d+) s", lambda: found("tests/install/try_packages.sh", r'"\$seconds" -lt (\d+)')),
    ],
    "docs/comparison.md": [
        *[(rf"\| {size} \| (\S+) \| (\S+) \| (\S+) \|", lambda size=size: speeds(size)) for size in ("66 108", "1 090 908", "7 452 108")],
        (r"takes (\S+), (\S+) and (\S+) % longer", lambda: found(SPEED, r"three sizes in float takes (\S+), (\S+) and (\S+) % longer")),
        (r"\| (\S+) million tried", lambda: (f"{round(int(found(SPEED, r'([0-9] 452 108)')[0].replace(' ', '')) / 1e6, 1)}",)),
        (r"Peng et al\. (\d+)", lambda: found("docs/refs.bib", r"\{Peng2019,.*?year = \{(\d+)\}")),
    ],
    "docs/stability.md": [
        (r"g\+\+ (\d+) to (\d+) and", lambda: versions(r"cxx: g\+\+-(\d+)")),
        (r"clang (\d+) to (\d+) on", lambda: versions(r"cxx: clang\+\+-(\d+)")),
        (r"Debian (\d+), Debian (\d+) and Ubuntu (24\.04)", systems),
        (r"nvcc (\d+)", lambda: found(".github/workflows/ci.yaml", r"nvidia/cuda:(\d+)")),
        (r"Kokkos (5\.0\.2) and (5\.1\.1)", lambda: tuple(sorted(set(re.findall(r"version: (\S+)\}", text(".github/workflows/ci.yaml")))))),
    ],
    "docs/gallery.md": [
        (r"out by (\S+) half-widths; experiments give (\S+) to (\d\.\d)", lambda: (
            *found(COLUMN, r"run-out of (\S+) L0"), *found(COLUMN, r"experiments give (\S+) to (\d\.\d)"))),
        (r"Grains of (\S+), (\S+) and (\S+) mm", lambda: tuple(
            f"{1000 * float(each):g}" for each in found("examples/drum/ternary.toml", r"diameters = \[(\S+), (\S+), (\S+)\]"))),
        (r"a slope of (\d+) to (\d+) degrees", lambda: found(COURSE, r"a slope of (\d+) to (\d+) degrees")),
        (r"model of (\d+) lines", lambda: found(COURSE, r"liquid, (\d+) lines")),
        (r"layer at (\d+) degrees", lambda: found("docs/figures/gallery.sh", r"slope\.angle=(\d+)")),
        (r"slip of (\S+) sinks", lambda: found("docs/figures/gallery.sh", r"wheel\.slip=(\S+)")),
        (r"places in (\d+) periods", lambda: found("examples/shear_box/shear_box.toml", r"periods = (\d+)")),
        *[(rf"`course_{name}`,\s(\d+) s", lambda name=name: time_of(name)) for name in re.findall(r"^\| \[(\d\d_\w+)\]", text(COURSE), re.MULTILINE)],
    ],
    "docs/looking_at_results.md": [
        (r"at most (\d+) MB", lambda: found("examples/view/__main__.py", r"megabytes\W[^\n]*default=(\d+)") or found(VIEW, r"megabytes=(\d+)")),
        (r"at most (\d+) states are taken; of a larger run fewer states, down to (\d+),", lambda: found(VIEW, r"MOST_FRAMES, FEWEST_FRAMES = (\d+), (\d+)")),
        (r"have (\d+) bits: steps of 1/(\d+)", lambda: (*found(VIEW, r"numbers of (\d+) bits"), *found(VIEW, r"STEPS = (\d+)"))),
        (r"Danckwerts (\d+)", lambda: found("docs/refs.bib", r"\{Danckwerts1952,.*?year = \{(\d+)\}")),
        (r"Lacey (\d+)", lambda: found("docs/refs.bib", r"\{Lacey1954,.*?year = \{(\d+)\}")),
    ],
}
# What is no figure, or has its record on the page itself, with its command or date.
OWN = {
    "docs/start.md": [],
    "docs/faq.md": [r"\[[Pp]rogram \d+\]", r"plane y = 0", r"nvcc 13\.0"],
    "docs/install.md": [r"64 bit", r"clang 14 \(", r"(nvcc|CUDA) 13\.0", r"3\.25 to 4\.4", r"takes 100 minutes.*?5 GB for each compiler", r"27 November 2026",
                        r"24 or 30 programs", r"^\| [a-z]+ \| \d+.*$", r"built on Debian 1[23](, on|:|,)", r"Debian 12 and 13", r"Debian 13", r"Ubuntu 24\.04"],
    "docs/comparison.md": [r"November 2026", r"1e8 particles", r"steps 40 to 240", r"nvcc 13\.0"],
    "docs/stability.md": [r"is 0, a new", r"VTKHDF 2\.0", r"change in 0\.2", r"g\+\+ 16\.2", r"fmt 11\.1", r"HDF5 2\.2"],
    "docs/gallery.md": [],
    "docs/looking_at_results.md": [r"browser of 2023", r"WebGL 2", r"Ottosson 2020", r"\b0 to see", r"below 800 pixels", r"\| 0 \| 1 \|", r"^\d\. ", r"0 is the material, 1 the",
                                   r"plane y = 0", r"ParaView 5\.12.*?5\.11"],
}
# Pages whose figures come from tests and other pages, which they name: each number but the plainest must be in one of those.
DERIVED = {"docs/choosing.md": ["docs/theory/*.md", "docs/extending.md", "docs/performance.md", "docs/checks.md", "docs/differences_from_paper.md", "examples/*/README.md",
                                "benchmarks/results/*.md", "include/scree/**/*.hpp", "tests/verification/**/*.cpp", "CHANGELOG.md"]}
PLAIN = re.compile(r"\d|1\d|20|30|40|50|100")  # too common to be looked for


def without_addresses(page):
    return re.sub(r"\]\([^)]*\)", "]", page)


def check(page):
    """The faults of a page, and the number of groups of figures that were compared."""
    whole, left, faults = without_addresses(text(page)), prose(text(page)), []
    bare = re.sub(r"`[^`]*`", "", whole)
    for pattern, source in PAGES[page]:
        shown = re.search(pattern, bare) or re.search(pattern, whole)
        right = source()
        if not shown or not right or shown.groups() != tuple(right):
            faults.append(f"{page}: /{pattern}/: the page has {shown and shown.groups()}, its source {right}")
        left = re.sub(pattern.replace(r"`course_", "").split("`")[-1] if "`" in pattern else pattern, "", left, count=0)
    for pattern in OWN[page]:
        left = re.sub(pattern, "", left, flags=re.MULTILINE | re.DOTALL if ".*?" in pattern else re.MULTILINE)
    faults += [f"{page}: no source is known for '{number}' in: {line.strip()}" for line in left.splitlines()
               for number in re.findall(rf"(?<![\w.])(?:{NUMBER})(?![\w.]*\w)", line)]
    return faults, len(PAGES[page])


def check_derived(page):
    numbers = rf"(?<![\w.])(?:{NUMBER})(?![\w.]*\w)"
    known = set()
    for pattern in DERIVED[page]:
        for path in ROOT.glob(pattern):
            known |= set(re.findall(numbers, path.read_text(encoding="utf8")))
    there = [(number, line) for line in prose(text(page)).splitlines() for number in re.findall(numbers, line) if not PLAIN.fullmatch(number)]
    return [f"{page}: '{number}' is in none of the pages and tests that it names: {line.strip()[:200]}" for number, line in there if number not in known], len(there)


def main():
    faults, groups = [], collections.Counter()
    for page in PAGES:
        found_here, groups[page] = check(page)
        faults += found_here
    for page in DERIVED:
        found_here, groups[page] = check_derived(page)
        faults += found_here
    print("\n".join(faults) or ", ".join(f"{page} {count}" for page, count in groups.items()))
    sys.exit(bool(faults))


if __name__ == "__main__":
    main()
