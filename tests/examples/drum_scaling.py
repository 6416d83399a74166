#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The curves of examples/drum/scaling.py on made-up studies, whose scatter and powers are known."""
import csv
import importlib.util
import math
import random
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / "examples" / "drum" / "scaling.py"
found = importlib.util.spec_from_file_location("scaling", SCRIPT)
scaling = importlib.util.module_from_spec(found)
found.loader.exec_module(scaling)


def made_up(count, noise, seed=1, products=(3, 30)):
    """Members with degree = 0.2 (Lambda Pe)^0.4 and time = 0.02 Pe^0.9 epsilon^-0.5, times 1 + noise."""
    source = random.Random(seed)
    members = []
    for k in range(count):
        Pe, product, epsilon = source.uniform(20, 300), source.uniform(*products), source.uniform(0.15, 0.35)
        members.append({"member": str(k + 1), "Lambda": product / Pe, "Pe": Pe, "epsilon": epsilon, "turns": 1000.0,
                        "degree": 0.2 * product ** 0.4 * (1 + source.gauss(0, noise)),
                        "time_in_turns": 0.02 * Pe ** 0.9 * epsilon ** -0.5 * (1 + source.gauss(0, noise)),
                        "radius": 0.07, "fill": 0.42, "speed": 10.0, "Froude": 0.008,
                        "spacing": 0.002})
    return members


class Curves(unittest.TestCase):
    def test_members_on_a_curve_have_no_scatter(self):
        curve = scaling.degree_curve(made_up(20, 0))
        self.assertLess(curve.scatter, 1e-12)
        for expected, value in zip((math.log(0.2), 0.4, 0), curve.coefficients):
            self.assertAlmostEqual(value, expected, places=9)
        self.assertAlmostEqual(curve(10), 0.2 * 10 ** 0.4, places=12)
        for expected, value in zip((math.log(0.02), 0.9, -0.5), scaling.time_curve(made_up(20, 0)).coefficients):
            self.assertAlmostEqual(value, expected, places=9)

    def test_the_scatter_is_that_of_the_noise(self):
        for noise in (0.03, 0.1):
            self.assertAlmostEqual(scaling.degree_curve(made_up(2000, noise)).scatter / noise, 1, delta=0.05)
            self.assertAlmostEqual(scaling.time_curve(made_up(2000, noise)).scatter / noise, 1, delta=0.05)

    def test_a_degree_that_depends_on_something_else_scatters(self):
        members = made_up(200, 0)
        for k, m in enumerate(members):
            m["degree"] *= 1.2 if k % 2 else 0.8
        self.assertAlmostEqual(scaling.degree_curve(members).scatter, 0.2, delta=0.02)

    def test_times_are_compared_at_one_product_alone(self):
        members = made_up(200, 0)
        for m in scaling.alike(members, 10):
            self.assertTrue(8 <= m["Lambda"] * m["Pe"] <= 12)
        self.assertTrue(10 < len(scaling.alike(members, 10)) < 60)

    def test_members_that_do_not_differ_are_refused(self):
        alike = [dict(m, Pe=100.0, epsilon=0.2) for m in made_up(10, 0)]
        with self.assertRaisesRegex(scaling.Mistake, "do not differ enough"):
            scaling.time_curve(alike)
        with self.assertRaisesRegex(scaling.Mistake, "needs more than 3 members"):
            scaling.degree_curve(made_up(3, 0))

    def test_runs_that_end_too_early_are_left_out(self):
        members = made_up(3, 0)
        for m, time in zip(members, (1.0, 3.0, 5.0)):
            m["turns"], m["time_in_turns"] = 5.0, time
        self.assertEqual([m["member"] for m in scaling.settled(members, 0.8)], ["1", "2"])


    def test_members_with_another_spacing_or_a_curved_surface_are_told_apart(self):
        members = made_up(20, 0)
        members[3].update(spacing=0.001, degree=2 * members[3]["degree"])
        members[5].update(Froude=0.2, degree=3 * members[5]["degree"])
        usual = scaling.usual(members)
        self.assertEqual(len(usual), 19)
        lines = scaling.report(usual, 11, [0.04, 0.3])
        self.assertIn("19 members", lines[1])
        self.assertIn("18 members: scatter 0.0 %", lines[lines.index("members with omega^2 R/g <= 0.04:") + 1])
        rolling = [m for m in usual if m["Froude"] < 0.1]
        others = scaling.about_others(members, scaling.degree_curve(rolling))
        self.assertEqual(len(others), 1)
        self.assertIn("member 4, R/dr = 70", others[0])
        self.assertIn("+100.0 % off the curve", others[0])


class Study(unittest.TestCase):
    def write(self, folder, members, **others):
        names = {**scaling.COLUMNS, "time": "time"}
        columns = ["geometry.rotation_speed [rpm]" if name == "speed" else names[name] for name in members[0] if name in names]
        with open(folder / "study.csv", "w", encoding="utf8", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["member", "state", *columns, "time", "message"])
            for m in members:
                values = [m[name] for name in m if name in names]
                writer.writerow([m["member"], others.get("state", "finished"), *values, m["turns"] * 60 / m["speed"], ""])

    def run_on(self, folder):
        return subprocess.run([sys.executable, SCRIPT, folder, "--no-pictures"], capture_output=True, text=True)

    def test_a_study_is_read_and_its_maps_are_written(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.write(folder, made_up(12, 0, products=(8.5, 11.5)))
            done = self.run_on(folder)
            self.assertIn("12 members", done.stdout + done.stderr)
            self.assertIn("0.02 Pe^0.90 epsilon^-0.50, scatter 0.0 %", done.stdout)
            with open(folder / "maps.csv", encoding="utf8") as file:
                rows = list(csv.DictReader(file))
            self.assertEqual(len(rows), 12)
            self.assertEqual((float(rows[3]["turns"]), float(rows[3]["speed"])), (1000, 10))

    def test_a_study_without_results_is_refused_with_one_line(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.assertIn("expected the directory of a study", self.run_on(folder).stderr)
            self.write(folder, made_up(3, 0), state="failed")
            done = self.run_on(folder)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
            self.assertIn("no member has finished", done.stderr)


if __name__ == "__main__":
    unittest.main()
