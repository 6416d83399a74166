# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Pictures, films and pages of examples/view. The page is opened in a headless Chromium, if there is one."""
import html
import json
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


    def in_space(self):
        points, body = support.box_in_space()
        support.write(self.folder / "space.vtkhdf", [(0.0, points, support.fields_of(points, body, 0))])
        return Run(self.folder / "space.vtkhdf")


class Pictures(WithRun):
    def test_a_picture_shows_walls_and_both_ends_of_the_colours(self):
        pictures.picture(self.run_, "concentration", self.folder / "a.png", 1)
        pixels = matplotlib.image.imread(self.folder / "a.png")[..., :3].reshape(-1, 3)
        for colour in (*(matplotlib.colormaps["viridis"](share)[:3] for share in (0.0, 1.0)), [0x9a / 255] * 3):
            self.assertGreater((np.abs(pixels - colour).max(axis=1) < 0.02).sum(), 1000, colour)

    def test_a_film_has_a_frame_for_each_state(self):
        from PIL import Image
        for name in ("a.gif", "a.webp"):
            pictures.film(self.run_, "velocity", self.folder / name)
            with Image.open(self.folder / name) as film:
                self.assertEqual(film.n_frames, 4)

    def test_the_states_of_a_picture_are_those_nearest_to_the_times(self):
        shown = []
        before = pictures.PlaneDrawing.show
        pictures.PlaneDrawing.show = lambda drawing, frame: (shown.append(frame.time), before(drawing, frame))
        self.addCleanup(setattr, pictures.PlaneDrawing, "show", before)
        pictures.picture(self.run_, "velocity", self.folder / "a.png", times=[0.1, 1.4])
        self.assertEqual(shown, [0, 1.5])

    def test_colours_are_those_of_the_whole_run(self):
        speeds = np.concatenate([frame.material.scalar("velocity") for frame in self.run_])
        np.testing.assert_allclose(pictures.limits_of_run(self.run_, "velocity"), np.percentile(speeds, [1, 99]))

    def test_walls_far_from_the_material_do_not_widen_a_picture(self):
        points, body = support.block()
        far = np.concatenate([points, [[7, 0, -0.005]]])
        body = np.append(body, 1)
        support.write(self.folder / "far.vtkhdf", [(0.0, far, support.fields_of(far, body, 0))])
        low, high = pictures.bounds_of(Run(self.folder / "far.vtkhdf"))
        np.testing.assert_allclose(low, [0.005 - 0.01, -0.01, -0.025 - 0.01])
        np.testing.assert_allclose(high, [0.095 + 0.6 * 0.09 + 0.01, 0.01, 0.075 + 0.01])

    def test_grains_in_space_are_shaded_and_seen_through_walls(self):
        run = self.in_space()
        pictures.picture(run, "concentration", self.folder / "a.png", 1)
        pixels = matplotlib.image.imread(self.folder / "a.png")[..., :3].reshape(-1, 3)
        for colour in (matplotlib.colormaps["viridis"](share)[:3] for share in (0.0, 1.0)):
            # Light changes the brightness, from 0.45 to 1, and leaves the hue.
            brightness = pixels @ colour / np.dot(colour, colour)
            like = (np.abs(pixels - np.outer(brightness, colour)).max(axis=1) < 0.04) & (brightness > 0.4) & (brightness < 1.05)
            self.assertGreater(like.sum(), 3000, colour)
            self.assertGreater(np.ptp(brightness[like]), 0.3, colour)
        self.assertGreater((np.ptp(pixels, axis=1) < 0.03).sum() - (pixels.min(axis=1) > 0.95).sum(), 1000, "walls")

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

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_the_page_fits_wide_and_narrow_windows(self):
        for width, height in ((1200, 800), (390, 844)):
            found = self.asked("""({
                inner: innerWidth, wide: document.documentElement.scrollWidth, stage: by("stage").clientHeight, tall: innerHeight,
                beyond: [...document.querySelectorAll("button, select, input, canvas, h1, td")].filter((each) => {
                  const box = each.getBoundingClientRect();
                  return box.left < -0.5 || box.right > innerWidth + 0.5;
                }).map((each) => each.id || each.tagName),
                inside: page.frames.every((frame, k) => (page.show(k), [0, 40, 79].every((i) => {
                  const [x, y] = page.particles.project(i);
                  return x > 44 && x < by("stage").clientWidth && y > 0 && y < by("stage").clientHeight - 26;
                })))})""", width, height)
            self.assertEqual(found["inner"], width)
            self.assertLessEqual(found["wide"], width)
            self.assertEqual(found["beyond"], [], width)
            self.assertGreater(found["stage"], 0.5 * min(found["tall"], 600))
            self.assertTrue(found["inside"], "at the start all of the material is seen, beside the axes")

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_axes_and_scale_bar_have_the_lengths_that_they_say(self):
        found = self.asked("""({ticks: page.axes.ticks, bar: page.axes.bar, scale: page.particles.pixelsPerMetre(),
                               place: page.particles.project(0), second: page.particles.project(9)})""")
        for axis, points in (("x", [0, 0.05]), ("z", [0, 0.05])):
            of_axis = [(value, at) for name, value, at in found["ticks"] if name == axis]
            self.assertGreater(len(of_axis), 3)
            slope, at_zero = np.polyfit(*np.array(of_axis).T, 1)
            self.assertAlmostEqual(abs(slope), found["scale"], delta=1e-3 * found["scale"])
            wanted = found["place"][0 if axis == "x" else 1]
            self.assertAlmostEqual(at_zero + slope * 0.005, wanted, delta=0.1, msg="the first particle is at 5 mm")
        self.assertAlmostEqual((found["second"][0] - found["place"][0]) / found["scale"], 0.09, delta=1e-4)
        self.assertRegex(found["bar"], r"^[125]0* mm$")

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_the_page_shows_the_material_in_space_through_walls_and_axes_where_they_belong(self):
        found = self.asked("""(() => {
              page.scalar = page.meta.scalars.findIndex(({name}) => name === "concentration");
              page.show(0);
              const picture = page.picture(), pixels = picture.getContext("2d").getImageData(0, 0, picture.width, picture.height).data;
              let yellow = 0;
              for (let k = 0; k < pixels.length; k += 4) yellow += pixels[k] > 100 && pixels[k + 1] > 90 && pixels[k + 2] < 0.4 * pixels[k];
              const x = page.axes.ticks.filter(([name]) => name === "x");
              return {yellow, names: [...new Set(page.axes.ticks.map(([name]) => name))], x, box: page.particles.box,
                      places: x.map(([, value]) => [1, 2].flatMap((k) => [0, 1].map((l) => page.particles.projected(
                        [value, page.particles.box[1][k - 1], page.particles.box[2][l]]).slice(0, 2))))};
            })()""", run=self.in_space())
        self.assertGreater(found["yellow"], 10000)
        self.assertEqual(found["names"], ["x", "y", "z"])
        np.testing.assert_allclose(found["box"], [[-0.03, 0.13]] * 3, atol=1e-5)
        for (_, _, point), edges in zip(found["x"], found["places"]):
            self.assertLess(min(np.hypot(*(np.array(edge) - point[:2])) for edge in edges), 0.01, "a tick is on an edge of the box")

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_keys_choose_time_field_and_colours_and_a_picture_has_them(self):
        found = self.asked("""(() => {
              const press = (key) => dispatchEvent(new KeyboardEvent("keydown", {key, bubbles: true, cancelable: true}));
              const state = () => [page.number, by("scalar").value, by("map").value, by("walls").checked];
              const states = [state()];
              for (const key of ["End", "ArrowLeft", "c", "m", "w"]) press(key), states.push(state());
              page.scalar = page.meta.scalars.findIndex(({name}) => name === "concentration");
              page.show(0);
              const picture = page.picture(), pen = picture.getContext("2d"), pixels = pen.getImageData(0, 0, picture.width, picture.height).data;
              const count = (rgb) => { let n = 0; for (let k = 0; k < pixels.length; k += 4) n += rgb.every((c, a) => Math.abs(pixels[k + a] - c) < 3); return n; };
              return {states, size: [picture.width, picture.height], low: count(colour("heat", 0)), high: count(colour("heat", 1)), wall: count([158, 158, 158])};
            })()""")
        first, end, left, field, colours, walls = found["states"]
        self.assertEqual(first[0], 0)
        self.assertEqual((end[0], left[0]), (3, 2))
        self.assertNotEqual(field[1], left[1])
        self.assertEqual((first[2], colours[2]), ("viridis", "heat"))
        self.assertEqual((first[3], walls[3]), (True, False))
        self.assertGreater(min(found["low"], found["high"]), 5000, "both kinds of grains are in the picture")
        self.assertLess(found["wall"], 500, "walls are switched off")

    @unittest.skipUnless(CHROMIUM, "there is no Chromium: the page is not opened")
    def test_maps_other_than_viridis_are_even_in_lightness(self):
        found = self.asked("""Object.fromEntries(Object.keys(maps).map((name) => [name, Array.from({length: 21}, (_, k) => colour(name, k / 20))]))""")
        np.testing.assert_allclose(np.array(found["viridis"])[[0, 20]], [[68, 1, 84], [253, 231, 37]])
        for name, steps in (("heat", np.full(20, 0.035)), ("grey", np.full(20, 0.0375)),
                            ("blue to red", np.r_[np.full(10, 0.045), np.full(10, -0.045)])):
            linear = np.array(found[name]) / 255
            linear = np.where(linear <= 0.04045, linear / 12.92, ((linear + 0.055) / 1.055) ** 2.4)
            to_cones = np.array([[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
                                 [0.0883024619, 0.2817188376, 0.6299787005]])
            lightness = np.cbrt(linear @ to_cones.T) @ [0.2104542553, 0.7936177850, -0.0040720468]
            np.testing.assert_allclose(np.diff(lightness), steps, atol=0.006, err_msg=name)

    def asked(self, question, width=1200, height=800, run=None):
        """What an expression in the page gives, in a frame of this size."""
        page.write_page(run or self.run_, self.folder / "b.html")
        text = (self.folder / "b.html").read_text(encoding="utf8")
        ask = """<script>(async () => {
          while (!document.body.dataset.ready) await new Promise((done) => setTimeout(done, 20));
          let answer;
          try { answer = JSON.stringify(eval(document.getElementById("question").textContent)); } catch (error) { answer = String(error); }
          parent.postMessage(answer, "*");
        })();</script></body>"""
        question = f'<script type="text/plain" id="question">{question}</script>'
        (self.folder / "b.html").write_text(text.replace("</body>", question + ask), encoding="utf8")
        (self.folder / "a.html").write_text(
            f"""<body><pre id="answer"></pre><iframe src="b.html" width="{width}" height="{height}" style="border:0"></iframe>
            <script>onmessage = (event) => document.getElementById("answer").textContent = event.data;</script></body>""", encoding="utf8")
        answer = re.search(r'<pre id="answer">(.*?)</pre>', self.chromium("", "--dump-dom"), re.DOTALL)[1]
        self.assertTrue(answer.startswith("{"), answer)
        return json.loads(html.unescape(answer))

    def chromium(self, address, *options):
        done = subprocess.run([CHROMIUM, *OPTIONS, f"--user-data-dir={self.folder}/profile", *options,
                               f"file://{self.folder}/a.html{address}"], capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout


if __name__ == "__main__":
    unittest.main()
