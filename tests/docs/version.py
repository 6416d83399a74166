#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The version is the same wherever it is named: version.py REPOSITORY."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])


def found(path, pattern):
    """All that the group of a pattern matches in a file."""
    return re.findall(pattern, (ROOT / path).read_text(encoding="utf8"), re.MULTILINE)


version = found("CMakeLists.txt", r"^project\(scree VERSION (\S+)")[0]
minor = version.rpartition(".")[0]
named = {
    "CITATION.cff, version": (found("CITATION.cff", r"^version: (\S+)"), version),
    "README.md, line of facts": (found("README.md", r"^Version ([0-9.]+) "), version),
    "codemeta.json, version": (found("codemeta.json", r'"version": "([^"]+)"'), version),
    "codemeta.json, date": (found("codemeta.json", r'"datePublished": "([^"]+)"'),
                            next(iter(found("CHANGELOG.md", r"^## [0-9.]+ - (\S+)")), None)),
    "codemeta.json, description": (found("codemeta.json", r'"description": "([^"]+)"'),
                                   found("CMakeLists.txt", r'^project\(scree .*DESCRIPTION "([^"]+)"')[0]),
    "CHANGELOG.md, first version": (found("CHANGELOG.md", r"^## (?:Unreleased \()?([0-9.]+)")[:1], version),
    "CITATION.cff, date": (found("CITATION.cff", r"^date-released: (\S+)"),
                           next(iter(found("CHANGELOG.md", r"^## [0-9.]+ - (\S+)")), None)),
    "docs/install.md, packages": (sorted(set(found("docs/install.md", r"scree[_-]([0-9.]+[0-9])[_-]"))), version),
    "docs/stability.md, column": (found("docs/stability.md", r"within ([0-9.]+)\.x"), minor),
    **{f"{page}, find_package": (found(page, r"find_package\(scree ([0-9.]+)"), minor)
       for page in ("README.md", "docs/case_programs.md", "docs/stability.md")},
}
wrong = [f"{where}: {', '.join(values) or 'nothing'}, not {right}" for where, (values, right) in named.items()
         if not values or any(value != right for value in values)]
print(f"version {version}, named in {len(named)} other places")
print("\n".join(wrong))
sys.exit(bool(wrong))
