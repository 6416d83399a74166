# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The API reference has all names, with text that is whole, and all fields."""
import functools
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
sys.path.insert(0, str(ROOT / "docs/site"))
import api  # noqa: E402
import build  # noqa: E402
import declarations  # noqa: E402
import fields  # noqa: E402
import headers  # noqa: E402
import mathematics  # noqa: E402
import names  # noqa: E402

HEADER = """
namespace scree {
/// The sum over neighbours $a_i = \\sum_j b_j$. Its error is 1. See eq. 2 of Zhu et al. (2024) for `f<T>(x)`:
///
///     Sum sum{.n = 1};
template <class T = double>
struct Sum {
  int n = 0, m = 1;  ///< of terms, above 0
  /// The sum of x. Throws for less than 0.
  T of(T x) const { return x; }
  T of(int, bool) const;
 private:
  int hidden = 0;
};
inline constexpr Sum<> sum{};
/// First.
int f(int a);
/// Second.
int f(double a);
int f(...);
namespace detail { struct Inner {}; }
}
"""


@functools.lru_cache(maxsize=2)
def extracted(source):
    """The folder with what Doxygen reads in the headers below another; it exists as long as the object."""
    folder = tempfile.TemporaryDirectory()
    build.extract(source, Path(folder.name), mathematics.Equations())
    return folder


def xml_of(source):
    return Path(extracted(source).name) / "xml"


# Classes that a program of a user names first; functions that a model has because of its role are described there.
OFTEN_NAMED = {"Solver", "SolverSettings", "BodySeries", "CsvSeries", "CsvColumn", "VtkHdfSeries", "CoarseSeries", "Observer", "Progress",
               "Interrupt", "CaseEnd", "PassedVolume", "PlaneFlux", "Raster", "HeightField", "Release", "Mesh", "VolumeBelow", "LoadControl"}
OF_A_ROLE = {"passes", "parameters", "check", "contains", "bounds", "walk", "has_jumps", "signed_distance", "outward_normal"}


def without_text(found):
    """Member functions, but constructors, of classes that programs name first that have no text."""
    return [f"{each.name}::{member.name}" for each in found if each.name in OFTEN_NAMED for member in each.members
            if "(" in member.code and not member.texts and member.name not in OF_A_ROLE | {each.name}]


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is missing")
class Extraction(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "scree/terms").mkdir(parents=True)
            (Path(name) / "scree/terms/sum.hpp").write_text(HEADER, encoding="utf8")
            cls.found = {each.name: each for each in declarations.read(xml_of(Path(name)))}

    def test_names_outside_of_detail_are_found(self):
        self.assertEqual(sorted(self.found), ["Sum", "f", "sum"])

    def test_a_text_is_whole(self):
        text = self.found["Sum"].texts
        self.assertEqual(text[0], f"The sum over neighbours {mathematics.OPEN}0{mathematics.CLOSE}. Its error is 1. See eq. 2 of Zhu et al. (2024) "
                                  "for <code>f&lt;T&gt;(x)</code>:")
        self.assertEqual(text[1], "<pre><code>Sum sum{.n = 1};</code></pre>")

    def test_members_have_declarations_and_texts(self):
        self.assertEqual([(each.name, each.code, each.texts) for each in self.found["Sum"].members],
                         [("n", "int n = 0", ["of terms, above 0"]), ("m", "int m = 1", ["of terms, above 0"]), ("of", "T of(T x) const", ["The sum of x. Throws for less than 0."])])

    def test_a_member_function_without_text_is_found(self):
        lost = declarations.Member("lost", "int lost() const", [], 1)
        solver = declarations.Declaration("solver.hpp", 1, "class", "Solver", [], [], members=[lost])
        self.assertEqual(without_text([solver]), ["Solver::lost"])

    def test_overloads_are_one_name_and_those_without_text_are_left_out(self):
        self.assertEqual(self.found["f"].codes, ["int f(int a)", "int f(double a)"])
        self.assertEqual(self.found["f"].texts, ["First.", "Second."])

    def test_an_object_has_the_text_of_its_type(self):
        self.assertIn("as an object: The sum over neighbours", self.found["sum"].texts[0])


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is missing")
class Headers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.all = declarations.read(xml_of(INCLUDE))
        cls.texts = {}
        for each in cls.all:
            cls.texts.setdefault(each.name, []).extend(each.texts)

    def test_each_public_name_has_a_text(self):
        public = names.public(INCLUDE)
        self.assertGreater(len(public), 900)
        self.assertEqual([f"{header}: {name}" for name, (_, header) in public.items() if not self.texts.get(name)], [])

    def test_each_member_of_settings_and_options_has_a_text(self):
        api.add_meanings(self.all, INCLUDE)
        structs = [each for each in self.all if re.search(r"(Settings|Options)\b", each.name)]
        self.assertGreater(len(structs), 5)
        self.assertEqual([f"{each.name}::{member.name}" for each in structs for member in each.members
                          if not member.texts and not member.code.startswith(("using", "static", "template")) and "(" not in member.code.split("=")[0]], [])

    def test_member_functions_of_classes_that_programs_name_have_a_text(self):
        self.assertEqual(OFTEN_NAMED - {each.name for each in self.all}, set())
        self.assertEqual(without_text(self.all), [])

    def test_no_text_ends_before_what_it_announces(self):
        cut = re.compile(r"(:|,| \.|\b(and|or|the|of|with))$")
        texts = [(each.name, each.texts) for each in self.all] + [(f"{each.name}::{member.name}", member.texts)
                                                                for each in self.all for member in each.members]
        self.assertEqual([(name, text[-1][-60:]) for name, text in texts if text and cut.search(text[-1].rstrip())], [])


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is missing")
class Fields(unittest.TestCase):
    def test_the_page_of_fields_has_all_fields_with_unit_text_and_source(self):
        with tempfile.TemporaryDirectory() as name:
            api.write(xml_of(INCLUDE), INCLUDE, Path(name))
            page = (Path(name) / "all_fields.md").read_text(encoding="utf8")
        rows = [re.split(r" \| ", line.strip("| ")) for line in page.splitlines() if line.startswith("| [")]
        public = names.public(INCLUDE)
        wanted = {name.rpartition("::")[2] for name, (kind, _) in public.items() if kind == "type"} & set(fields.declared(INCLUDE))
        objects = {name for name in public if name.startswith("fields::")}
        there = {re.match(r"\[`([\w:]+)`\]", row[0])[1] for row in rows}
        self.assertGreater(len(wanted), 50)
        declared = fields.declared(INCLUDE)
        cells = [row[0].split("<br>") for row in rows]
        self.assertEqual({", ".join(declared[name][1:3]) for name in wanted}, {cell[1] for cell in cells})
        self.assertEqual({each for each in there if each.startswith("fields::")}, objects)
        for row in rows:
            self.assertTrue(row[1].strip(), row[0])
            self.assertRegex(row[-1], "^(yes|overwritten)", row[0])


if __name__ == "__main__":
    unittest.main()
