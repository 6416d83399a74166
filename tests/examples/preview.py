#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The preview of a case leaves one page with its particles, and earlier results as they were: preview.py PROGRAM CASE_FILE"""
import base64
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from case_program import CASE, PROGRAM, check

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


def preview(folder, *more):
    return subprocess.run([PROGRAM, CASE, "--preview", "--output", "out", *more], cwd=folder, capture_output=True, text=True)


def part(page, name):
    return re.search(rf'<script type="[a-z/]*" id="{name}">(.*?)</script>', page, re.DOTALL)[1]


with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as name:
    folder = pathlib.Path(name)
    if (script := CASE.parent / "vessel.py").exists():
        subprocess.run([sys.executable, script, "v", folder / "v_blender.stl"], check=True)
    if (script := CASE.parent / "ground.py").exists():
        subprocess.run([sys.executable, script, folder], check=True)
    earlier = {"case.toml": "its case", "history.csv": "its rows", "summary.json": "{}", "checkpoint.h5": "its state"}
    (folder / "out").mkdir()
    for file, text in earlier.items():
        (folder / "out" / file).write_text(text)

    began = time.monotonic()
    done = preview(folder, "--force")
    print(f"{time.monotonic() - began:.1f} s")
    check(done.returncode == 0, f"exit code {done.returncode}\n{done.stdout}{done.stderr}")
    check("checks of the start: passed" in done.stdout and "first step: " in done.stdout, "it reports the checks and the step")
    check(done.stdout.endswith("preview of the start, for a browser: out/preview.html\n"), "it tells where the page is")
    found = {path.name: path for path in (folder / "out").iterdir()}
    check(set(found) == {*earlier, "preview.html"}, f"it writes one file: {sorted(found)}")
    check(all(found[file].read_text() == text for file, text in earlier.items()), "earlier results are as they were")

    page = found["preview.html"].read_text(encoding="utf8")
    meta = json.loads(part(page, "meta"))
    counts = [int(count) for count in re.findall(r"^[\w ]+: (\d+) particles$", done.stdout, re.MULTILINE)]
    check(len(counts) == len(meta["bodies"]) and sum(counts) == meta["counts"][0], f"it counts its particles: {counts}")
    data = base64.b64decode(part(page, "data"), validate=True)
    rows = meta["dimension"] + 1 + len(meta["scalars"])
    check(len(data) == 2 * rows * meta["counts"][0] and len(meta["ranges"]) == rows, "all particles have all numbers")
    check(f"{PROGRAM.name}, {CASE.name}, 20" in meta["title"], f"the title has case and date: {meta['title']}")

    if CHROMIUM:
        shown = subprocess.run([CHROMIUM, "--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
                                "--enable-unsafe-swiftshader", "--virtual-time-budget=20000", f"--user-data-dir={folder}/profile",
                                "--dump-dom", f"file://{found['preview.html']}"], capture_output=True, text=True).stdout
        check('data-ready="yes"' in shown, "a browser shows the page")
        check("<td>checks of the start</td><td>passed</td>" in shown, "with the report")

    refused = preview(folder, "--vary", "output.checkpoints=[1, 2]")
    check(refused.returncode == 2, "a study has no preview")
    found["preview.html"].write_text("a text of the user")
    refused = preview(folder)
    check(refused.returncode == 1 and "out/preview.html: is no preview" in refused.stderr, "another file of that name is refused")
    check(found["preview.html"].read_text() == "a text of the user", "and stays as it was")
