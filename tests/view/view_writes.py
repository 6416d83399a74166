# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Pictures, films and pages of examples/view. The page is opened in a headless Chromium, if there is one."""
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import matplotlib
import numpy as np
import support
from view import Run, page, pictures

CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
OPTIONS = ["--headless=new", "--no-sandbox", "--hide-scrollbars", "--use-gl=angle", "--use-angle=swiftshader",
           "--enable-unsafe-swiftshader", "--window-size=1200,800", "--virtual-time-budget=20000"]


class WithRun(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        support.falling_block(self.folder / "particles.vtkhdf")
        (self.folder / "history.csv").write_text("time [s],force [N]\n0,1\n0.5,2\n", encoding="utf8")
        self.run_ = Run(self.folder)


class Pictures(WithRun):
    def test_a_picture_shows_walls_and_both_ends_of_the_colours(self):
        pictures.picture(self.run_, "concentration", self.folder / "a.png", 1)
        pixels = matplotlib.image.imread(self.folder / "a.png")[..., :3].reshape(-1, 3)
        for colour in (*(matplotlib.colormaps["viridis"](share)[:3] for share in (0.0, 1.0)), [0x9a / 255] * 3):
            self.assertGreater((np.abs(pixels - colour).max(axis=1) < 0.02).sum(), 1000, colour)

    def test_a_film_has_a_frame_for_each_state(self):
        from PIL import Image
        pictures.film(self.run_, "velocity", self.folder / "a.gif")
        with Image.open(self.folder / "a.gif") as film:
            self.assertEqual(film.n_frames, 4)

    def test_curves_need_a_table_with_times(self):
        pictures.curves(self.run_, self.folder / "b.png")
        self.assertGreater((self.folder / "b.png").stat().st_size, 1000)
        (self.folder / "history.csv").unlink()
        with self.assertRaisesRegex(ValueError, "no table with a column `time`"):
            pictures.curves(Run(self.folder), self.folder / "c.png")


class Commands(WithRun):
    def command(self, *words):
        return subprocess.run([sys.executable, support.ROOT / "examples/view", self.folder, *words], capture_output=True,
                              text=True, check=False)

    def test_without_options_times_fields_and_tables_are_listed(self):
        done = self.command()
        self.assertEqual(done.returncode, 0, done.stderr)
        for text in ("4 states from 0 to 1.5 s, 109 to 110 particles, 2D", "velocity [m/s]: mean", "history.csv: time, force"):
            self.assertIn(text, done.stdout)

    def test_a_profile_is_printed(self):
        self.assertIn("z [m], pressure [Pa], particles", self.command("--profile", "z", "--field", "pressure").stdout)

    def test_an_unknown_field_is_one_message(self):
        done = self.command("--page", str(self.folder / "a.html"), "--fields", "speed")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, "^view: .*no field speed; it has")
        self.assertFalse((self.folder / "a.html").exists())


class Pages(WithRun):
    def test_nothing_is_loaded_from_elsewhere(self):
        page.write_page(self.run_, self.folder / "a.html")
        text = (self.folder / "a.html").read_text(encoding="utf8")
        self.assertIsNone(re.search(r'(src|href)\s*=|@import|url\(|https?:|fetch\(', text))

    def test_a_large_run_is_thinned_to_the_size_that_is_asked_for(self):
        points, body = support.block(100, 100)
        generator = np.random.default_rng(1)
        states = [(0.1 * k, points + generator.normal(0, 0.01, points.shape) * [1, 0, 1], support.fields_of(points, body, k))
                  for k in range(80)]
        support.write(self.folder / "large.vtkhdf", states)
        run = Run(self.folder / "large.vtkhdf")
        count, stride = page.write_page(run, self.folder / "a.html", megabytes=1)
        self.assertEqual(count, 60)
        self.assertGreater(stride, 1)
        self.assertLess((self.folder / "a.html").stat().st_size, 1e6)
        self.assertGreater((self.folder / "a.html").stat().st_size, 0.4e6)

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_the_page_shows_the_numbers_of_a_picked_particle_at_each_time(self):
        page.write_page(self.run_, self.folder / "a.html")
        for frame, place in ((0, 5), (3, 5)):
            text = self.chromium(f"#frame={frame}&scalar=pressure&pick={place}", "--dump-dom")
            self.assertIn('data-ready="yes"', text)
            cells = dict(re.findall(r"<tr><td>(.*?)</td><td>(.*?)</td></tr>", text))
            state = self.run_[frame]
            self.assertEqual(int(cells["identity"]), state["identity"][place])
            for name, wanted in (("x (m)", state.points[place, 0]), ("z (m)", state.points[place, 2]),
                                 ("pressure (Pa)", state.scalar("pressure")[place]),
                                 ("velocity (m/s)", state.scalar("velocity")[place])):
                self.assertAlmostEqual(float(cells[name]), wanted, delta=1e-4 * max(1, abs(wanted)), msg=name)

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_the_page_draws_walls_and_both_kinds_of_grains(self):
        page.write_page(self.run_, self.folder / "a.html")
        self.chromium("#frame=1&scalar=concentration", f"--screenshot={self.folder}/a.png")
        image = (matplotlib.image.imread(self.folder / "a.png")[..., :3] * 255).round()
        left = image[:650, :800].reshape(-1, 3)  # without legend, slider and text
        for name, colour in (("walls", (158, 158, 158)), ("C = 0", (68, 1, 84)), ("C = 1", (253, 231, 37))):
            self.assertGreater((np.abs(left - colour).max(axis=1) <= 3).sum(), 5000, name)

    def chromium(self, address, *options):
        done = subprocess.run([CHROMIUM, *OPTIONS, f"--user-data-dir={self.folder}/profile", *options,
                               f"file://{self.folder}/a.html{address}"], capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout


if __name__ == "__main__":
    unittest.main()
