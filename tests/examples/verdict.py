#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The verdicts of quickstart.sh: a shear box is compared with the table of its page, a collapse with experiments."""
import importlib.util
import unittest
from pathlib import Path

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def verdict_of(example):
    module = importlib.util.spec_from_file_location(f"verdict_of_{example}", EXAMPLES / example / "verdict.py")
    loaded = importlib.util.module_from_spec(module)
    module.loader.exec_module(loaded)
    return loaded


shear_box, column_collapse = verdict_of("shear_box"), verdict_of("column_collapse")

PAGE = """| scheme, box | dr/H = 0.04 | 0.02 |
|---|---|---|
| conservative, oscillating | 2e-3 | 8.00e-4 |
| - the aim | | 9e-4 |
| hcsr, oscillating (`--set model.scheme=hcsr`) | 7e-3 | 3e-3 |
"""


def summary(error, **other):
    return {"flux": "symmetric", "reading": "chi", "closure": "constant", "jitter": 0, "scheme": "conservative", "upright": False,
            "spacing": 0.02, "compared": [{"time": 40, "mae_width": 1}, {"time": 80, "mae_width": error}], **other}


class ShearBox(unittest.TestCase):
    def test_an_equal_error_is_as_published(self):
        self.assertEqual(shear_box.verdict(summary(8.04e-4), PAGE)[0], 0)
        self.assertIn("as published (8.00e-04)", shear_box.verdict(summary(8.04e-4), PAGE)[1])

    def test_another_error_is_not(self):
        for error in (7.9e-4, 8.1e-4, 0.0, float("nan")):
            self.assertEqual(shear_box.verdict(summary(error), PAGE)[0], 1, error)

    def test_the_row_and_the_column_are_those_of_the_run(self):
        self.assertEqual(shear_box.verdict(summary(7e-3, scheme="hcsr", spacing=0.04), PAGE)[0], 0)
        self.assertEqual(shear_box.verdict(summary(7e-3, scheme="hcsr"), PAGE)[0], 1)

    def test_a_run_that_the_table_has_not_gets_no_verdict(self):
        for other in ({"spacing": 0.03}, {"upright": True}, {"jitter": 0.1}, {"flux": "asymmetric"}, {"compared": []}):
            self.assertEqual(shear_box.verdict(summary(8e-4, **other), PAGE)[0], 2, other)

    def test_the_page_has_the_run_of_the_quick_start(self):
        page = (EXAMPLES / "shear_box/README.md").read_text(encoding="utf8")
        self.assertAlmostEqual(shear_box.published(page, "conservative", False, 0.02), 8.4e-4, delta=1e-5)


class ColumnCollapse(unittest.TestCase):
    def test_a_run_out_is_right_between_the_bounds_of_experiments(self):
        for run_out, code in ((2.4, 0), (2.95, 0), (3.6, 0), (2.39, 1), (3.61, 1), (0.0, 1), (float("nan"), 1)):
            found = column_collapse.verdict({"run_out": run_out, "run_out_least": 2.4, "run_out_greatest": 3.6})
            self.assertEqual(found[0], code, run_out)
            self.assertIn("within" if code == 0 else "outside", found[1])


if __name__ == "__main__":
    unittest.main()
