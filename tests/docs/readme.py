#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The program of the README prints the lines that the README shows: readme.py PROGRAM README.md"""
import pathlib
import re
import subprocess
import sys

page = pathlib.Path(sys.argv[2]).read_text(encoding="utf8")
wanted = re.search(r"and prints\s+```text\n(.*?)```", page, re.DOTALL)[1]
printed = subprocess.run([sys.argv[1]], capture_output=True, text=True, check=True).stdout
if printed != wanted:
    sys.exit(f"the README shows\n{wanted}\nbut its program prints\n{printed}")
