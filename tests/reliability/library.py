# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R9, R11, R19, R21 to R24: attempts on the library itself, counted by test programs (*.cpp here, see tally.hpp)."""
import re

import programs
from tally import Tally

FAULTS = {
    "R9": "NaN or infinity in each field x random particle x random step: the run stops and names particle, field, step, place",
    "R11": "many particles in one cell, domains of far more cells than can be counted: the pairs of brute force, or refused",
    "R19": "steps that get too short: the run ends and says which limit",
    "R21": "layers of random rows x angle x stiffness, 2D and 3D, from their exact stress: they come to rest",
    "R22": "random speed x offset x spacing in float: the whole way, or refused",
    "R23": "random unions of closed shells: inside, distances and fillings of the union",
    "R24": "random tables and composed motions: within their points, consistent; contradictions are refused",
}


def counted(measure):
    def attempt(context):
        tally = Tally(measure, FAULTS[measure])
        program = context.test("test_reliability")
        if program is None:
            tally.not_run = "test_reliability is not built"
            return tally
        command = [program, f"[{measure}]", "--allow-running-no-tests"]
        variables = {"SCREE_RELIABILITY": context.pick("short", "long"), "SCREE_RELIABILITY_SEED": str(context.random.randrange(2**31))}
        words = " ".join([*(f"{name}={value}" for name, value in variables.items()), *map(str, command)])
        outcome = programs.run(command, env_more=variables, limit=context.pick(600, 3600))
        for survived, tried, note in re.findall(rf"^{measure}: (\d+) of (\d+)(.*)$", outcome.out, re.MULTILINE):
            for attempt in range(int(tried)):
                tally.check(attempt < int(survived), f"{note.strip(' ,')}, see {words}")
            if note.strip(" ,") not in tally.notes:
                tally.note(note.strip(" ,"))
        if outcome.code != 0 and not tally.failures:
            tally.check(False, f"{outcome.out[-2000:]}{outcome.err[-500:]}")
        return tally
    return attempt


MEASURES = {measure: counted(measure) for measure in FAULTS}
