# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R5, R18: checkpoints that were damaged or belong to another run, and those of earlier versions."""
import pathlib

import drum_case
import programs
from tally import Tally

GOLDEN = pathlib.Path(__file__).resolve().parent / "golden"
REFUSED = {"format_1"}  # from before the filter counted the yielding


def refused(outcome, checkpoint):
    """What is wrong with the answer to a checkpoint that must be refused; empty: nothing."""
    if outcome.code != 1:
        return f"exit code {outcome.code}"
    if len(outcome.messages) != 1 or str(checkpoint) not in outcome.messages[0]:
        return f"messages {outcome.messages}"
    return ""


def damages(content, random, flips, cuts, pages):
    """Damaged copies of a file with what was done."""
    for _ in range(flips):
        place, bit = random.randrange(len(content)), random.randrange(8)
        changed = bytearray(content)
        changed[place] ^= 1 << bit
        yield f"bit {bit} of byte {place} flipped", bytes(changed)
    for _ in range(cuts):
        left = random.randrange(len(content))
        yield f"cut after {left} bytes", content[:left]
    used = [k for k in range(0, len(content), 4096) if any(content[k:k + 4096])]
    for start in random.sample(used, min(pages, len(used))):
        yield f"page at {start} zeroed", content[:start] + bytes(len(content[start:start + 4096])) + content[start + 4096:]


OTHER_RUNS = {
    "another spacing": {"numerics.spacing": 2.5e-3},
    "single precision": drum_case.FLOAT,
    "another dimension": drum_case.IN_SPACE,
    "another smoothing length": {"numerics.smoothing": 1.6},
    "another depth of the bed": {"geometry.fill_depth": 0.5},
    "other fields": {"numerics.volume_control": '"none"', "segregation.scheme": '"hcsr"'},
}


def damaged(context):
    """R5"""
    tally = Tally("R5", "checkpoint with a flipped bit, cut, with a zeroed page, of another case: refused by one message that "
                  "names it, no result touched")
    whole = drum_case.whole_run(context)
    folder = drum_case.copy_of(context, whole)
    checkpoint = folder / "checkpoint.h5"
    content = checkpoint.read_bytes()
    for done, changed in damages(content, context.random, context.pick(20, 200), context.pick(5, 30), context.pick(5, 30)):
        checkpoint.write_bytes(changed)
        before = drum_case.bytes_in(folder)
        fault = refused(programs.run(drum_case.continued(context, checkpoint, folder, {"time.duration": 0.03})), checkpoint)
        if drum_case.bytes_in(folder) != before:
            fault += ", a result changed"
        tally.check(not fault, f"{done}: {fault}")
    checkpoint.write_bytes(content)
    for name, settings in OTHER_RUNS.items():
        outcome = programs.run(drum_case.continued(context, checkpoint, folder, {"time.duration": 0.03, **settings}))
        fault = refused(outcome, checkpoint)
        tally.check(not fault, f"{name}: {fault}")
    continue_from_previous(context, tally, whole)
    return tally


def continue_from_previous(context, tally, whole):
    """The checkpoint before the damaged one is there, and leads to the same end."""
    folder = drum_case.copy_of(context, whole)
    content = (folder / "checkpoint.h5").read_bytes()
    (folder / "checkpoint.h5").write_bytes(content[:len(content) // 2])
    outcome = programs.run(drum_case.continued(context, folder / "checkpoint.previous.h5", folder))
    same = outcome.code == 0 and drum_case.results_in(whole) == drum_case.results_in(folder)
    tally.check(same, f"continued from the checkpoint before: {outcome.err or 'other bits'}")


def old(context):
    """R18: each folder of golden/ holds the results of a run of an earlier version, to be continued but for REFUSED."""
    tally = Tally("R18", "checkpoints since version 0.1 go on; older ones are refused by a message")
    for results in sorted(path for path in GOLDEN.iterdir() if path.is_dir()):
        folder = drum_case.copy_of(context, results)
        checkpoint = folder / "checkpoint.h5"
        at = drum_case.steps_in(checkpoint)
        outcome = programs.run([context.program("drum"), folder / "case.toml", "--output", folder, "--quiet", "--set",
                                f'output.restart_from="{checkpoint}"', "--set", "time.duration=0.012"])
        went_on = outcome.code == 0 and drum_case.steps_in(checkpoint) > at
        as_expected = not refused(outcome, checkpoint) if results.name in REFUSED else went_on
        tally.check(as_expected, f"{results.name}: exit code {outcome.code}, {outcome.err}")
        tally.note(f"{results.name}: {'goes on' if went_on else outcome.messages}")
    return tally


MEASURES = {"R5": damaged, "R18": old}
