#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Every source that code and docs name by author and year is in docs/refs.bib: sources.py REPOSITORY."""
import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1])
NAME = r"\b[A-Z][a-z]+[A-Za-z-]*\b"
CITATION = re.compile(rf"({NAME})(?:, {NAME})*(?:,? (?:&|and) {NAME}| et al\.)?,? \(?((?:19|20)\d\d)\b")
NOT_AUTHORS = {"In", "Since", "From", "Until", "Copyright", "Hopper", "September", "October", "November", "December"}


def entries():
    text = (ROOT / "docs/refs.bib").read_text(encoding="utf8")
    for entry in re.split(r"^@", text, flags=re.MULTILINE)[1:]:
        author, year = re.search(r"author\s*=\s*\{(.*?)\}[,\s]*\w+\s*=", entry, re.DOTALL), re.search(r"year\s*=\s*\{(\d+)\}", entry)
        if author and year:
            yield author[1].replace(r"{\o}", "oe"), year[1]  # code has ASCII letters alone


def cited():
    for folder, kinds in (("include", ("hpp",)), ("examples", ("hpp", "cpp", "md")), ("docs", ("md",)), ("tests", ("hpp", "cpp"))):
        for kind in kinds:
            for path in sorted((ROOT / folder).rglob(f"*.{kind}")):
                text = re.sub(r"\s*\n\s*(?://+)?\s*", " ", path.read_text(encoding="utf8"))
                for match in CITATION.finditer(text):
                    if match[1] not in NOT_AUTHORS:
                        yield match[1], match[2], path.relative_to(ROOT)


known = list(entries())
found = list(cited())
keys = re.findall(r"^@\w+\{(\w+),", (ROOT / "docs/refs.bib").read_text(encoding="utf8"), re.MULTILINE)
paper = (ROOT / "paper/paper.md").read_text(encoding="utf8")
unknown = sorted({key for key in re.findall(r"@([A-Z]\w+)", paper) if key not in keys})
missing = [f"@{key} (paper/paper.md)" for key in unknown] + sorted({f"{author} {year} ({path})" for author, year, path in found
                  if not any(author.lower() in names.lower() and year == of for names, of in known)})
print(f"{len(known)} entries, {len(found)} citations")
print("\n".join(f"not in docs/refs.bib: {each}" for each in missing))
sys.exit(bool(missing) or len(found) < 30)
