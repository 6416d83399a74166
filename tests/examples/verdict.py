#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The verdict on a run of the shear box is that of the table of its page."""
import importlib.util
import unittest
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "examples/shear_box"
module = importlib.util.spec_from_file_location("verdict", FOLDER / "verdict.py")
verdict = importlib.util.module_from_spec(module)
module.loader.exec_module(verdict)

PAGE = """| scheme, box | dr/H = 0.04 | 0.02 |
|---|---|---|
| conservative, oscillating | 2e-3 | 8.00e-4 |
| - the aim | | 9e-4 |
| hcsr, oscillating (`--set model.scheme=hcsr`) | 7e-3 | 3e-3 |
"""


def summary(error, **other):
    return {"flux": "symmetric", "reading": "chi", "closure": "constant", "jitter": 0, "scheme": "conservative", "upright": False,
            "spacing": 0.02, "compared": [{"time": 40, "mae_width": 1}, {"time": 80, "mae_width": error}], **other}


class Verdict(unittest.TestCase):
    def test_an_equal_error_is_as_published(self):
        self.assertEqual(verdict.verdict(summary(8.04e-4), PAGE)[0], 0)
        self.assertIn("as published (8.00e-04)", verdict.verdict(summary(8.04e-4), PAGE)[1])

    def test_another_error_is_not(self):
        for error in (7.9e-4, 8.1e-4, 0.0, float("nan")):
            self.assertEqual(verdict.verdict(summary(error), PAGE)[0], 1, error)

    def test_the_row_and_the_column_are_those_of_the_run(self):
        self.assertEqual(verdict.verdict(summary(7e-3, scheme="hcsr", spacing=0.04), PAGE)[0], 0)
        self.assertEqual(verdict.verdict(summary(7e-3, scheme="hcsr"), PAGE)[0], 1)

    def test_a_run_that_the_table_has_not_gets_no_verdict(self):
        for other in ({"spacing": 0.03}, {"upright": True}, {"jitter": 0.1}, {"flux": "asymmetric"}, {"compared": []}):
            self.assertEqual(verdict.verdict(summary(8e-4, **other), PAGE)[0], 2, other)

    def test_the_page_has_the_run_of_the_quick_start(self):
        page = (FOLDER / "README.md").read_text(encoding="utf8")
        self.assertAlmostEqual(verdict.published(page, "conservative", False, 0.02), 8.4e-4, delta=1e-5)


if __name__ == "__main__":
    unittest.main()
