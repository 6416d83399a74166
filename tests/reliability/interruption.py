# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R4, R14: runs that are killed, and runs that are asked to stop."""
import signal
import time

import drum_case
import programs
from tally import Tally


def has_rows(folder, rows):
    table = folder / "history.csv"
    return table.exists() and table.read_bytes().count(b"\n") > rows


def killed(context):
    """R4: a checkpoint after every step, so that nearly every kill falls into the writing of one."""
    tally = Tally("R4", "kill -9 at random times, a checkpoint after every step; continued: bits of the whole run")
    began = time.monotonic()
    expected = drum_case.results_in(drum_case.whole_run(context))
    lasted = time.monotonic() - began
    halfway = early = late = 0
    for attempt in range(context.pick(6, 60)):
        folder = context.folder()
        process = programs.start(drum_case.command(context, folder))
        # Some before there is a checkpoint at all.
        while attempt % 10 != 5 and not (folder / "checkpoint.h5").exists() and process.poll() is None:
            time.sleep(0.001)
        time.sleep(context.random.uniform(0, 0.02 if attempt % 10 == 5 else 0.8 * lasted))
        process.kill()
        process.communicate()
        if process.returncode == 0:
            late += 1
            continue
        halfway += (folder / "checkpoint.h5.part").exists()
        checkpoints = [folder / name for name in ("checkpoint.h5", "checkpoint.previous.h5") if (folder / name).exists()]
        if checkpoints:
            what = f"killed after step {drum_case.steps_in(checkpoints[0])}"
            outcome = programs.run(drum_case.continued(context, checkpoints[0], folder))
        else:
            early, what = early + 1, "killed before the first checkpoint, begun anew"
            outcome = programs.run(drum_case.command(context, folder, flags=["--force"]))
        different = outcome.err if outcome.code else drum_case.differences(expected, drum_case.results_in(folder))
        tally.check(not different, f"{what}: {different}")
    tally.note(f"{halfway} left a checkpoint half written, {early} fell before the first one, {late} came too late")
    return tally


SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGXCPU, signal.SIGUSR1)


def stopped(context):
    """R14"""
    tally = Tally("R14", "SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1: a checkpoint, exit code 128 + number, the "
                  "tables of the whole run when continued")
    length = {"time.duration": 0.1, "output.checkpoints": drum_case.NEVER, "output.profile_times": [0.05]}
    expected = drum_case.tables_in(drum_case.whole_run(context, length))
    for number in SIGNALS:
        for _ in range(context.pick(1, 20)):
            tally.check(*stopped_by(context, number, length, expected))
    return tally


def listen():
    """A job in the background inherits that some signals are ignored."""
    for number in SIGNALS:
        signal.signal(number, signal.SIG_DFL)


def stopped_by(context, number, length, expected):
    """Whether a run did what it should, and what it did."""
    folder = context.folder()
    began = time.monotonic()
    process = programs.start(drum_case.command(context, folder, length), preexec_fn=listen)
    while not has_rows(folder, 1) and process.poll() is None:
        time.sleep(0.001)
    time.sleep(context.random.uniform(0, 0.05))
    process.send_signal(number)
    outcome = programs.ended(process, began)
    name = signal.Signals(number).name
    if outcome.code != 128 + number:
        return False, f"{name}: exit code {outcome.code}"
    if not (folder / "checkpoint.h5").exists():
        return False, f"{name}: no checkpoint"
    if "to continue, add --set 'output.restart_from=" not in outcome.err:
        return False, f"{name}: does not say how to continue: {outcome.err}"
    outcome = programs.run(drum_case.continued(context, folder / "checkpoint.h5", folder, length))
    different = outcome.err if outcome.code else drum_case.differences(expected, drum_case.tables_in(folder))
    return not different, f"{name}: {different}"


MEASURES = {"R4": killed, "R14": stopped}
