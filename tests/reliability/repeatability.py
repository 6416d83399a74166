# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R1, R2, R3: the same bits from every run, from a run that was cut, and with any number of threads."""
import signal
import time

import drum_case
import programs
from tally import Tally

KINDS = {
    "2D, double": {},
    "2D, float": drum_case.FLOAT,
    "3D, double": drum_case.IN_SPACE,
    "3D, float": {**drum_case.IN_SPACE, **drum_case.FLOAT},
}
SHEAR_BOX = ["--set", "numerics.spacing=0.05", "--set", "time.periods=1", "--set", "output.compared=[1]", "--set",
             "output.frame_interval=0.5", "--set", "output.reference_spacing=0.05", "--quiet"]


def shear_box_results(context, threads=1):
    folder = context.folder()
    outcome = programs.run([context.program("shear_box"), "--output", folder, *SHEAR_BOX], threads)
    if outcome.code != 0:
        raise SystemExit(f"the shear box fails: {outcome.err}")
    return {**drum_case.tables_in(folder), **drum_case.frames_in(folder)}


def repeated(context):
    """R1"""
    tally = Tally("R1", "the same run again: all tables, frames and the state after the last step")
    results = {name: lambda s=settings: drum_case.results_in(drum_case.whole_run(context, s))
               for name, settings in KINDS.items() if not context.short or name.startswith("2D")}
    if context.program("shear_box").is_file():
        results["shear box"] = lambda: shear_box_results(context)
    for name, once in results.items():
        first = drum_case.digest(once())
        for attempt in range(2, context.pick(2, 5) + 1):
            tally.check(drum_case.digest(once()) == first, f"{name}: run {attempt} differs from the first")
    tally.note(f"drum ({', '.join(name for name in results if name != 'shear box')}), shear box" if "shear box" in results
               else "drum only")
    return tally


def restarted(context):
    """R2"""
    tally = Tally("R2", "a run stopped by SIGTERM at a random step and continued to the end: the bits of the whole run")
    steps = []
    for name, settings in KINDS.items():
        if context.short and name.startswith("3D"):
            continue
        began = time.monotonic()
        whole = drum_case.whole_run(context, settings)
        lasted = time.monotonic() - began
        expected = drum_case.results_in(whole)
        for _ in range(context.pick(2, 10)):
            cut = context.folder()
            if not cut_at_random(context, cut, settings, lasted):
                tally.note(f"{name}: one run ended before it was cut")
                continue
            at = drum_case.steps_in(cut / "checkpoint.h5")
            steps.append(at)
            outcome = programs.run(drum_case.continued(context, cut / "checkpoint.h5", cut, settings))
            different = outcome.err if outcome.code else drum_case.differences(expected, drum_case.results_in(cut))
            tally.check(not different, f"{name}, cut after step {at}: {different}")
    tally.note(f"cut after steps {min(steps)} to {max(steps)}, {sum(step % 30 != 0 for step in steps)} of them off the "
               "period of the filter" if steps else "none was cut")
    return tally


def cut_at_random(context, folder, settings, lasted):
    """Stops a run by SIGTERM; whether it was stopped before its end."""
    began = time.monotonic()
    process = programs.start(drum_case.command(context, folder, settings))
    while not (folder / "checkpoint.h5").exists() and process.poll() is None:
        time.sleep(0.002)
    time.sleep(context.random.uniform(0, 0.6 * lasted))
    process.send_signal(signal.SIGTERM)
    return programs.ended(process, began).code == 128 + signal.SIGTERM


def threads(context):
    """R3"""
    tally = Tally("R3", "1, 2 and 4 threads")
    for name, settings in KINDS.items():
        if context.short and name.startswith("3D"):
            continue
        one = drum_case.results_in(drum_case.whole_run(context, settings, threads=1))
        for count in context.pick((2,), (2, 4)):
            more = drum_case.results_in(drum_case.whole_run(context, settings, threads=count))
            tally.check(one == more, f"{name}, {count} threads: {drum_case.differences(one, more)}")
    return tally


MEASURES = {"R1": repeated, "R2": restarted, "R3": threads}
