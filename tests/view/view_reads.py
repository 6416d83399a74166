# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""examples/view reads runs, and computes profiles and measures of mixing."""
import os
import re
import subprocess
import tempfile
import unittest
from pathlib import Path

import numpy as np
import support
from view import Run, lacey_index, profile, segregation_intensity, small_grains


class WithRun(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.states = support.falling_block(self.folder / "particles.vtkhdf")
        (self.folder / "history.csv").write_text('time [s],force [N],share\n0,1,\n0.5,2,0.25\n', encoding="utf8")
        self.run_ = Run(self.folder)


class Reading(WithRun):
    def test_states_have_their_times_points_and_fields(self):
        self.assertEqual(list(self.run_.times), [0, 0.5, 1, 1.5])
        self.assertEqual(list(self.run_.counts), [110, 110, 109, 109])
        for frame, (time, points, fields) in zip(self.run_, self.states):
            self.assertEqual(frame.time, time)
            np.testing.assert_array_equal(frame.points, points)
            for name, values in fields.items():
                np.testing.assert_array_equal(frame[name], values)

    def test_units_dimension_and_spacing(self):
        self.assertEqual(self.run_.units["velocity"], "m/s")
        self.assertEqual(self.run_.dimension, 2)
        self.assertAlmostEqual(self.run_.spacing, 0.01)

    def test_the_material_is_without_walls(self):
        self.assertEqual(len(self.run_[0].material), 80)
        self.assertTrue((self.run_[0].material["body"] == 0).all())

    def test_scalars_are_magnitudes_components_and_pressures(self):
        frame, z = self.run_[2], self.states[2][1][:, 2]
        np.testing.assert_allclose(frame.scalar("velocity"), np.hypot(z, 1))
        np.testing.assert_allclose(frame.scalar("velocity.z"), 1)
        np.testing.assert_allclose(frame.scalar("pressure"), 100 * z)
        np.testing.assert_allclose(frame.scalar("stress.xx"), -100 * z)

    def test_tables_have_columns_and_units(self):
        table = self.run_.tables["history.csv"]
        np.testing.assert_array_equal(table["force"], [1, 2])
        np.testing.assert_array_equal(table["share"], [np.nan, 0.25])
        self.assertEqual(self.run_.table_units["history.csv"], {"time": "s", "force": "N", "share": "1"})

    def test_mistakes_are_named(self):
        with self.assertRaisesRegex(KeyError, "no field 'speed'; it has"):
            self.run_[0]["speed"]
        with self.assertRaisesRegex(KeyError, "no component 'w'"):
            self.run_[0].scalar("velocity.w")
        with self.assertRaisesRegex(FileNotFoundError, "missing: there is no such file or folder"):
            Run(self.folder / "missing")
        with self.assertRaisesRegex(ValueError, "history.csv is no VTKHDF file"):
            Run(self.folder / "history.csv")
        with tempfile.TemporaryDirectory() as empty, self.assertRaisesRegex(FileNotFoundError, "not the results of a run"):
            Run(empty)

    def test_the_nearest_state_to_a_time_is_found(self):
        self.assertEqual(self.run_.at(0.8).number, 2)


class Documentation(WithRun):
    def test_the_code_of_looking_at_results_runs(self):
        page = (support.ROOT / "docs/looking_at_results.md").read_text(encoding="utf8")
        blocks = re.findall(r"^```python\n(.*?)^```", page, re.MULTILINE | re.DOTALL)
        self.assertEqual(len(blocks), 2)
        for block in blocks:
            block = block.replace('"OUT"', repr(str(self.folder))).replace("path/to/scree", str(support.ROOT))
            names = {}
            exec(block.replace('"particles.vtkhdf"', repr(str(self.folder / "particles.vtkhdf"))), names)  # noqa: S102
        np.testing.assert_array_equal(names["velocity"], self.states[-1][2]["velocity"])


class Statistics(WithRun):
    def test_a_profile_has_the_mean_of_each_row(self):
        middles, means, counts = profile(self.run_[0], "velocity.x", "z", bins=8, span=(0, 0.08))
        np.testing.assert_allclose(middles, 0.01 * np.arange(8) + 0.005)
        np.testing.assert_allclose(means, middles)
        np.testing.assert_array_equal(counts, 10)

    def test_separated_grains_have_the_intensity_one(self):
        self.assertAlmostEqual(segregation_intensity(self.run_[0], size=0.04), 1)

    def test_grains_of_a_list_are_as_small_as_their_mean_diameter(self):
        points, body = support.block(3, 1)
        fields = support.fields_of(points, body, 0)
        np.testing.assert_array_equal(small_grains(self.run_[0]), self.run_[0].scalar("concentration"))
        del fields["concentration"]
        mixtures = np.array([[1, 0, 0], [0, 1, 0], [0.5, 0.25, 0.25]] + [[0, 0, 0]] * 9)  # walls
        for k in range(3):
            fields[f"concentration_{k + 1}"] = mixtures[:, k].astype(float)
        folder = self.folder / "list"
        folder.mkdir()
        support.write(folder / "particles.vtkhdf", [(0.0, points, fields)])
        (folder / "case.toml").write_text("[species]\ndiameters = [4e-3, 1e-3, 2e-3]\n", encoding="utf8")
        frame = Run(folder)[0]
        np.testing.assert_allclose(small_grains(frame)[:3], [0, 1, 0.25 + 0.25 * 2 / 3])
        self.assertEqual(frame.run.scalars[0], "concentration_1")

    def test_a_chessboard_has_the_intensity_zero_and_is_more_mixed_than_by_chance(self):
        points, body = support.block(8, 8)
        fields = support.fields_of(points, body, 0)
        fields["concentration"] = (np.rint(points / 0.01 - 0.5).sum(axis=1) % 2).astype(float)
        support.write(self.folder / "mixed.vtkhdf", [(0.0, points, fields)])
        frame = Run(self.folder / "mixed.vtkhdf")[0].material
        self.assertAlmostEqual(segregation_intensity(frame, size=0.04), 0)
        self.assertAlmostEqual(lacey_index(frame, frame["concentration"] == 1, size=0.04), 16 / 15)

    def test_lacey_index_is_zero_for_separated_and_one_for_random_grains(self):
        frame = self.run_[0].material
        self.assertAlmostEqual(lacey_index(frame, frame["concentration"] == 1, size=0.04), 0)
        points, body = support.block(100, 80)
        support.write(self.folder / "large.vtkhdf", [(0.0, points, support.fields_of(points, body, 0))])
        large = Run(self.folder / "large.vtkhdf")[0].material
        marked = np.random.default_rng(1).random(len(large)) < 0.3
        self.assertAlmostEqual(lacey_index(large, marked, size=0.04), 1, delta=0.01)

    def test_cells_with_few_particles_are_refused_with_advice(self):
        with self.assertRaisesRegex(ValueError, "choose larger ones than 0.001 m"):
            segregation_intensity(self.run_[0], size=0.001)


@unittest.skipUnless("SCREE_PROGRAM" in os.environ, "SCREE_PROGRAM names no program")
class FilesOfTheLibrary(unittest.TestCase):
    def test_a_run_of_the_first_program_of_the_course_is_read(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([os.environ["SCREE_PROGRAM"], "0.1"], cwd=folder, check=True, capture_output=True)
            run = Run(folder)
            self.assertEqual(len(run), 101)
            self.assertEqual(run.dimension, 2)
            self.assertAlmostEqual(run.spacing, 0.004, delta=1e-9)
            fallen = run[0].material.points[:, 2].mean() - run[50].material.points[:, 2].mean()
            self.assertAlmostEqual(fallen, 9.81 * run.times[50] ** 2 / 2, delta=1e-5)
            self.assertEqual(len(run.tables["heap.csv"]["time"]), 101)


if __name__ == "__main__":
    unittest.main()
