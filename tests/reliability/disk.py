# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R6: no room, no permission."""
import os
import pathlib
import resource
import shutil
import subprocess

import drum_case
import programs
from tally import Tally

NOBODY = 65534
REASONS = ("File too large", "No space left on device", "Permission denied", "Read-only file system", "Is a directory",
           "Not a directory", "No such file or directory")


def complaint(outcome):
    """What is wrong with the answer to a disk that fails; empty: nothing."""
    if outcome.code != 1:
        return f"exit code {outcome.code}"
    if len(outcome.messages) != 1 or not any(reason in outcome.messages[0] for reason in REASONS):
        return f"messages {outcome.messages}"
    return ""


def full(context):
    """R6"""
    tally = Tally("R6", "files limited in size, a full, a read-only and a forbidden directory: one message with the reason, "
                  "the last checkpoint leads to the bits of the whole run")
    whole = drum_case.whole_run(context)
    expected = drum_case.results_in(whole)
    largest = max(path.stat().st_size for path in whole.iterdir())
    for k in range(context.pick(6, 40)):
        size = 0 if k == 0 else int(context.random.uniform(0, largest))
        limited(context, tally, size, expected)
    on_small_disk(context, tally, expected)
    forbidden(context, tally)
    return tally


def go_on(context, tally, folder, expected, what):
    """Without the limit the run goes on from the last checkpoint, if there was time for one."""
    checkpoint = folder / "checkpoint.h5"
    if checkpoint.exists():
        outcome = programs.run(drum_case.continued(context, checkpoint, folder))
        different = outcome.err if outcome.code else drum_case.differences(expected, drum_case.results_in(folder))
        tally.check(not different, f"{what}, continued: {different}")


def limited(context, tally, size, expected):
    folder = context.folder()
    outcome = programs.run(drum_case.command(context, folder), preexec_fn=lambda: resource.setrlimit(
        resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY)))
    what = f"files of at most {size} bytes"
    if outcome.code != 0:  # else the limit came to bear nowhere
        fault = complaint(outcome)
        tally.check(not fault, f"{what}: {fault}")
        go_on(context, tally, folder, expected, what)


def on_small_disk(context, tally, expected):
    """A file system in memory, where the system lets one be made."""
    disk = context.folder()
    disk.mkdir()
    sizes = context.pick((300, 1500), (50, 200, 300, 400, 600, 900, 1200, 1500, 2000))
    done = 0
    for kilobytes in sizes:
        made = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kilobytes}k", "none", str(disk)], capture_output=True)
        if made.returncode != 0:
            break
        try:
            folder = disk / "output"
            outcome = programs.run(drum_case.command(context, folder))
            if outcome.code != 0:
                done += 1
                fault = complaint(outcome)
                tally.check(not fault, f"a disk of {kilobytes} kB: {fault}")
                if folder.exists():
                    copied = context.folder()
                    shutil.copytree(folder, copied)
                    go_on(context, tally, copied, expected, f"a disk of {kilobytes} kB")
        finally:
            subprocess.run(["umount", str(disk)], check=True)
    tally.note(f"{done} full disks" if done else "no disk could be made, only limits of files")


def forbidden(context, tally):
    """As a user who owns nothing, where this program may become one."""
    as_nobody = {"user": NOBODY, "group": NOBODY, "extra_groups": []} if os.geteuid() == 0 else {}
    folder = context.folder()
    folder.mkdir(mode=0o555)
    case = context.folder()
    case.write_text("")
    case.chmod(0)
    places = {"a folder that may not be written": folder, "a place in it": folder / "output",
              "a file in place of the folder": pathlib.Path("/dev/null"), "below a file": pathlib.Path("/dev/null/output"),
              "a file system that is read only": pathlib.Path("/proc/output")}
    for what, place in places.items():
        fault = complaint(programs.run(drum_case.command(context, place), **as_nobody))
        tally.check(not fault, f"{what}: {fault}")
    outcome = programs.run([context.program("drum"), case, "--output", context.folder()], **as_nobody)
    tally.check(outcome.code == 2 and "Permission denied" in outcome.err and len(outcome.messages) == 1,
                f"a case file that may not be read: exit code {outcome.code}, {outcome.messages}")


MEASURES = {"R6": full}
