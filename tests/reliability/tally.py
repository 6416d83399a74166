# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Counts what was tried and what survived, and prints the table."""
import dataclasses


@dataclasses.dataclass
class Tally:
    """One row of the table: `tried` attempts of one kind of fault."""
    measure: str  # "R4"
    fault: str  # what is done to the program
    tried: int = 0
    failures: list = dataclasses.field(default_factory=list)  # what did not survive, in words
    notes: list = dataclasses.field(default_factory=list)  # figures to stand beside the counts
    seconds: float = 0
    not_run: str = ""  # why nothing was tried

    def check(self, survived, attempt):
        """Counts one attempt; `attempt` says in words which, for the case that it did not survive."""
        self.tried += 1
        if not survived:
            self.failures.append(str(attempt))
        return survived

    def note(self, text):
        self.notes.append(text)

    @property
    def survived(self):
        return self.tried - len(self.failures)

    @property
    def falls_short(self):
        return bool(self.failures) or (self.tried == 0 and not self.not_run)

    def row(self):
        """The row in Markdown."""
        figure = f"not run: {self.not_run}" if self.not_run else f"{self.survived} of {self.tried}"
        return f"| {self.measure} | {self.fault} | {figure} | {'; '.join(self.notes)} | {self.seconds:.0f} |"


HEAD = "| | fault | survived | | s |\n|---|---|---|---|---|"


def print_failures(tally, most=20):
    for failure in tally.failures[:most]:
        print(f"  FAILED {tally.measure}: {failure}", flush=True)
    if len(tally.failures) > most:
        print(f"  ... and {len(tally.failures) - most} more", flush=True)
