#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Builds the documentation site: build.py OUT [--url URL] -> OUT/html/index.html.

Pages are the Markdown files of the repository, and the API reference, which is made from what Doxygen reads in the headers. A
warning of a tool, a link without target and an image that is missing are errors; the exit code is then 1. It is 77 where
tools are missing; on Debian: apt-get install doxygen mkdocs mkdocs-material"""
import argparse
import json
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import api  # noqa: E402
import check_html  # noqa: E402
import descriptions  # noqa: E402
import headers  # noqa: E402
import mathematics  # noqa: E402
import navigation  # noqa: E402
import pages  # noqa: E402
import parameters  # noqa: E402
import search  # noqa: E402
import tutorial  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
TOOLS = {"doxygen": "doxygen", "mkdocs": "mkdocs mkdocs-material"}


def run(command, what):
    """Runs a tool; if it fails or warns, prints what it said and ends."""
    result = subprocess.run(command, cwd=ROOT, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if result.returncode != 0:
        lines = [line for line in result.stdout.splitlines() if re.search("warning|error", line, re.IGNORECASE)]
        sys.exit("\n".join(lines) + f"\nbuild.py: {what} failed or warned, see above")


def version():
    header = (ROOT / "include/scree/version.hpp").read_text(encoding="utf8")
    return ".".join(re.search(rf"VERSION_{part} (\d+)", header)[1] for part in ("MAJOR", "MINOR", "PATCH"))


def extract(include, out, equations):
    """The declarations and comments of the headers, in XML."""
    settings = (Path(__file__).parent / "Doxyfile").read_text(encoding="utf8")
    headers.copy(include, out / "headers", equations.hide_in_header)
    settings += f"INPUT = {out}/headers\nSTRIP_FROM_PATH = {out}/headers\nSTRIP_FROM_INC_PATH = {out}/headers\n"
    settings += f"OUTPUT_DIRECTORY = {out}\nPROJECT_NUMBER = {version()}\n"
    (out / "Doxyfile").write_text(settings, encoding="utf8")
    run(["doxygen", str(out / "Doxyfile")], "doxygen")


def site(out, tutorials, api_pages, url):
    settings = (Path(__file__).parent / "mkdocs.yml").read_text(encoding="utf8")
    nav = navigation.tree(ROOT, tutorials, api_pages)
    settings += "".join(f"{key}: {json.dumps(value)}\n" for key, value in (
        ("docs_dir", str(out / "pages")), ("site_dir", str(out / "html")), ("nav", nav), *([("site_url", url)] if url else [])))
    (out / "mkdocs.yml").write_text(settings, encoding="utf8")
    run(["mkdocs", "build", "--strict", "--config-file", str(out / "mkdocs.yml")], "mkdocs")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path, help="folder of the site, for instance build/docs")
    parser.add_argument("--url", help="where the site will be, https://.../: its page for missing pages and its canonical links need it")
    arguments = parser.parse_args()
    out = arguments.out.resolve()
    missing = [package for tool, package in TOOLS.items() if not shutil.which(tool)]
    if missing:
        print(f"build.py: tools are missing; on Debian: apt-get install {' '.join(missing)}", file=sys.stderr)
        sys.exit(77)  # CTest: skipped
    start = time.monotonic()
    for folder in ("pages", "headers", "html", "xml"):
        shutil.rmtree(out / folder, ignore_errors=True)
    out.mkdir(parents=True, exist_ok=True)
    equations = mathematics.Equations()
    tutorials = pages.stage(ROOT, out / "pages", equations.hide_in_page)
    extract(ROOT / "include", out, equations)
    api_pages = api.write(out / "xml", ROOT / "include", out / "pages/api")
    site(out, tutorials, api_pages, arguments.url)
    number = equations.put_into(out / "html")
    search.finish(out / "html")
    descriptions.put_into(out / "html")
    if equations.unavailable:
        print("build.py: equations are shown as LaTeX, because KaTeX or Node.js is missing; on Debian: apt-get install katex")
    mistakes = check_html.mistakes(out / "html")
    if mistakes:
        sys.exit("\n".join(mistakes) + f"\nbuild.py: {len(mistakes)} links or images have no target")
    count = len(list((out / "pages").rglob("*.md")))
    print(f"{count} pages, those of the API included, {number} equations in {time.monotonic() - start:.0f} s: {out}/html/index.html")


if __name__ == "__main__":
    try:
        main()
    except (pages.MissingTarget, parameters.Unreadable, mathematics.Unreadable, tutorial.NotInTable) as mistake:
        sys.exit(f"build.py: {mistake}")
