# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The built site: equations fit into their columns, and the search finds what people ask for, also where it is opened from disk."""
import http.server
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))
import navigation  # noqa: E402

CHROMIUM = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
QUESTIONS = {  # what is asked, and the pages of which one must be among the first two
    "install": "docs/install", "Windows": "docs/install", "NaN": "docs/checks", "out of memory": "docs/faq", "glossary": "docs/start",
    "gmsh": "docs/theory/setup", "restart": "docs/checkpoint examples/course/08_restart.cpp", "ParaView": "docs/looking_at_results",
    "friction mu(I)": "docs/theory/laws docs/choosing", "fill_lattice": "api/setup", "StressDivergence": "api/terms",
    "several GPUs": "docs/distributed", "own law": "examples/course/05_own_law.cpp docs/theory/laws docs/extending",
    "time step": "docs/choosing", "rotating drum": "examples/drum/index", "silo": "examples/silo/index", "cite": "index",
    "units of fields": "api/all_fields", "wall force": "docs/theory/granular docs/faq", "compile error": "docs/faq"}
NEWCOMERS = {  # single words and short phrases, before the names of the library are known; the same rule
    "segregation": "docs/theory/segregation", "restart": "docs/checkpoint examples/course/08_restart.cpp",
    "gpu": "docs/distributed examples/course/10_float_on_gpu.cpp docs/install docs/performance", "install": "docs/install",
    "drum": "examples/drum/index", "shear box": "examples/shear_box/index", "friction angle": "docs/theory/laws docs/choosing",
    "output vtk": "docs/looking_at_results docs/overview api/io", "mpi ranks": "docs/distributed",
    "angle of repose": "docs/theory/verification docs/choosing", "boundary conditions": "docs/theory/granular api/boundaries",
    "hopper": "examples/silo/index examples/course/12_silo.cpp", "getting started": "docs/start index", "example input file": "docs/case_programs",
    "kernel": "docs/extending api/kernels", "moving wall": "docs/theory/granular docs/extending api/motion examples/course/04_gate.cpp",
    "number of threads": "docs/faq docs/performance docs/install", "docker": "docs/install", "landslide": "examples/terrain/index docs/theory/setup",
    "particle size": "docs/choosing docs/theory/laws", "checkpoint": "docs/checkpoint", "viscosity": "docs/choosing docs/theory/granular",
    "animation": "docs/looking_at_results docs/gallery", "constitutive model": "docs/theory/laws docs/extending",
    "unit tests": "CONTRIBUTING docs/start docs/performance docs/install", "contribute": "CONTRIBUTING", "license": "index",
    "cmake find_package": "docs/install index", "periodic boundary": "docs/theory/setup docs/overview docs/extending docs/faq",
    "DEM": "docs/comparison docs/theory/verification", "inclined plane": "examples/inclined_flow/index",
    "Bagnold": "docs/theory/verification examples/inclined_flow/index", "save particles": "docs/overview docs/looking_at_results api/io",
    "pressure oscillations": "docs/choosing docs/theory/granular",
    "CUDA architecture": "docs/install", "bug report": "docs/support CONTRIBUTING", "random packing": "docs/theory/setup api/setup",
    "digital elevation model": "docs/theory/setup examples/terrain/index", "inflow and outflow": "docs/extending docs/overview api/openings",
    "Janssen": "docs/theory/verification examples/silo/index", "critical state": "docs/theory/laws docs/theory/verification",
    "download": "docs/install index docs/start", "color by velocity": "docs/looking_at_results", "scaling strong weak": "docs/performance docs/distributed",
    "density of the material": "docs/choosing docs/theory/laws api/laws", "flow rate": "examples/silo/index examples/course/12_silo.cpp",
    "sand pile": "docs/theory/verification docs/choosing", "segmentation fault": "docs/faq docs/checks",
    "retaining wall": "docs/theory/verification examples/course/04_gate.cpp", "inertial number": "docs/theory/laws docs/choosing",
    "sound speed": "docs/choosing docs/theory/laws docs/theory/granular"}
MEMBERS = {"update_diagnostics": "api/solver", "failed_trials": "api/solver api/system", "sort_period": "docs/choosing docs/overview api/solver", "rest_density": "api/laws api/parameters",
           "effective_viscosity": "api/terms", "CheckpointOptions": "api/run", "time_interval": "api/run"}
MEASURE = """<script>addEventListener("load", () => document.fonts.ready.then(() => {
  const wide = [...document.querySelectorAll(".katex-display")].filter(each => each.scrollWidth > each.clientWidth + 1);
  const text = document.createElement("pre");
  text.id = "measured";
  text.textContent = document.querySelectorAll(".katex-display").length + "\\n"
    + wide.map(each => each.scrollWidth + " > " + each.clientWidth + ": " + each.querySelector("annotation").textContent).join("\\n");
  document.body.append(text);
}))</script></body>"""


class Late(http.server.BaseHTTPRequestHandler):
    """Answers after some seconds: a page with a picture from here is not complete until its workers, too, have run."""

    def do_GET(self):
        time.sleep(6)
        self.send_response(404)
        self.end_headers()

    def log_message(self, *_):
        pass


def page_after_scripts(address, *options):
    """The HTML of a page when its scripts have run."""
    with tempfile.TemporaryDirectory() as profile:
        return subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
                               "--window-size=1366,900", *options, "--dump-dom", address], capture_output=True, text=True, timeout=120,
                              check=True).stdout


class Built(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.site = Path(os.environ.get("SCREE_SITE", cls.folder.name)) / "html"  # CTest has built it
        if not cls.site.is_dir():
            done = subprocess.run([sys.executable, str(ROOT / "docs/site/build.py"), str(cls.site.parent)], capture_output=True, text=True,
                                  check=False)
            if done.returncode == 77:
                raise unittest.SkipTest(done.stderr)
            assert done.returncode == 0, done.stdout + done.stderr
        cls.as_latex = not any(style.stat().st_size for style in cls.site.rglob("katex.css"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def found(self, questions):
        if not shutil.which("node"):
            self.skipTest("Node.js is missing")
        done = subprocess.run(["node", str(ROOT / "docs/site/search.js"), str(self.site), json.dumps(list(questions))], capture_output=True,
                              text=True, check=True)
        pages = json.loads(done.stdout)
        return {question: [page.removesuffix(".html") for page in each[:2]] for question, each in zip(questions, pages)
                if not {page.removesuffix(".html") for page in each[:2]} & set(questions[question].split())}

    def test_of_twenty_questions_eighteen_find_their_page_among_the_first_two(self):
        missed = self.found(QUESTIONS)
        self.assertEqual(len(QUESTIONS), 20)
        self.assertLessEqual(len(missed), 2, missed)

    def test_nine_of_ten_words_of_newcomers_find_their_page_among_the_first_two(self):
        self.assertGreater(len(NEWCOMERS), 30)
        self.assertLessEqual(10 * len(missed := self.found(NEWCOMERS)), len(NEWCOMERS), missed)

    def test_members_are_found(self):
        self.assertEqual(self.found(MEMBERS), {})

    def test_no_equation_is_left(self):
        for path in [*self.site.rglob("*.html"), *self.site.rglob("search/*")]:
            text = path.read_text(encoding="utf8")
            self.assertIsNone(re.search(r"[\ue000-\ue004]|\\ue00\d", text), path)
        if self.as_latex:
            self.skipTest("KaTeX is missing: equations are shown as LaTeX")
        laws = (self.site / "docs/theory/laws.html").read_text(encoding="utf8")
        self.assertGreater(laws.count('class="katex-display"'), 20)
        self.assertFalse("```math" in laws)
        self.assertTrue("<annotation" in (self.site / "api/terms.html").read_text(encoding="utf8"))

    def test_each_page_has_a_description_of_its_own(self):
        pages = {path: re.search(r'<meta name="description" content="([^"]*)">', path.read_text(encoding="utf8"))[1]
                 for path in self.site.rglob("*.html")}
        self.assertGreater(len(pages), 100)
        same = [str(path) for path, text in pages.items() if list(pages.values()).count(text) > 1 or not 4 < len(text) < 300]
        self.assertEqual(same, [])
        self.assertIn("There is no page at this address", pages[self.site / "404.html"])

    @unittest.skipUnless(CHROMIUM, "Chromium is missing")
    def test_no_equation_is_wider_than_its_column(self):
        if self.as_latex:
            self.skipTest("KaTeX is missing: equations are shown as LaTeX")
        equations = 0
        for path in sorted(self.site.rglob("*.html")):
            text = path.read_text(encoding="utf8")
            if 'class="katex-display"' not in text:
                continue
            copy = path.with_name(f"measured_{path.name}")
            copy.write_text(text.replace("</body>", MEASURE), encoding="utf8")
            count, *wide = re.search(r'<pre id="measured">(.*?)</pre>', page_after_scripts(copy.as_uri(), "--virtual-time-budget=8000"), re.DOTALL)[1].split("\n")
            copy.unlink()
            self.assertEqual([each for each in wide if each], [], path.name)
            equations += int(count)
        self.assertGreater(equations, 70)

    @unittest.skipUnless(CHROMIUM, "Chromium is missing")
    def test_a_page_that_is_opened_from_disk_searches(self):
        late = http.server.ThreadingHTTPServer(("127.0.0.1", 0), Late)
        threading.Thread(target=late.serve_forever, daemon=True).start()
        copy = self.site / "docs/searched.html"
        copy.write_text((self.site / "docs/faq.html").read_text(encoding="utf8").replace(
            "</body>", f'<img src="http://127.0.0.1:{late.server_port}/late.png"></body>'), encoding="utf8")
        page = page_after_scripts(copy.as_uri() + "?q=gmsh")
        late.shutdown()
        late.server_close()
        copy.unlink()
        self.assertEqual(re.findall(r'<a href="file:[^"]*/html/([^"?#]*)[^"]*" class="md-search-result__link"', page)[:1], ["docs/theory/setup.html"])

    def test_the_menu_has_each_application_under_its_name(self):
        home = (self.site / "index.html").read_text(encoding="utf8")
        applications = navigation.applications(ROOT)
        self.assertGreater(len(applications), 7)
        drum = (self.site / "examples/drum/index.html").read_text(encoding="utf8")
        for page in applications:
            title = (ROOT / page).read_text(encoding="utf8").split("\n")[0].removeprefix("# ")
            self.assertTrue(re.search(rf'<a href="[^"]*" class="md-nav__link[^>]*>(?:\s|<[^>]*>)*{re.escape(title)}\s*<', drum), page)
        self.assertNotIn("Further", re.search(r'<nav class="md-tabs".*?</nav>', home, re.DOTALL)[0])

    def test_there_are_a_light_and_a_dark_look(self):
        home = (self.site / "index.html").read_text(encoding="utf8")
        self.assertTrue('data-md-color-media="(prefers-color-scheme: dark)" data-md-color-scheme="slate"' in home)


if __name__ == "__main__":
    unittest.main()
