#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Prints the section of CHANGELOG.md of a version: release_notes.py VERSION. Links of the repository keep their targets below
--url, the address of its files at the tag."""
import argparse
import re
import sys
from pathlib import Path


def notes(changelog, version, url=""):
    """The section without its heading; nothing if there is none."""
    found = re.search(rf"^## {re.escape(version)} - (\S+)\n(.*?)(?=^## |\Z)", changelog, re.MULTILINE | re.DOTALL)
    if not found:
        return None
    text = found[2].strip()
    if url:
        text = re.sub(r"\]\((?!https?:|#)([^)]+)\)", lambda link: f"]({url.rstrip('/')}/{link[1]})", text)
    return f"scree {version}, {found[1]}\n\n{text}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("version")
    parser.add_argument("--url", default="")
    arguments = parser.parse_args()
    text = notes((Path(__file__).resolve().parents[1] / "CHANGELOG.md").read_text(encoding="utf8"), arguments.version, arguments.url)
    if text is None:
        sys.exit(f"release_notes.py: CHANGELOG.md has no released version {arguments.version}")
    print(text, end="")


if __name__ == "__main__":
    main()
