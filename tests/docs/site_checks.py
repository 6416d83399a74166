# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The scripts of docs/site find mistakes, and leave what is right as it is."""
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "docs/site"), str(ROOT / ".ci")]
import build  # noqa: E402
import check_html  # noqa: E402
import headers  # noqa: E402
import pages  # noqa: E402
import parameters  # noqa: E402
import release_notes  # noqa: E402
import step_diagram  # noqa: E402
import tutorial  # noqa: E402


class Links(unittest.TestCase):
    def mistakes(self, body):
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "a.html").write_text(f"<h1 id='top'>A</h1>{body}", encoding="utf8")
            Path(folder, "picture.png").write_bytes(b"")
            return check_html.mistakes(Path(folder))

    def test_right_links_are_no_mistakes(self):
        self.assertEqual(self.mistakes("<a href='#top'>x</a><a href='a.html#top'>x</a><img src='picture.png'>"
                                       "<a href='https://kokkos.org'>x</a>"), [])

    def test_each_kind_of_mistake_is_found(self):
        for body in ("<a href='b.html'>x</a>", "<a href='#bottom'>x</a>", "<a href='a.html#bottom'>x</a>", "<img src='x.png'>",
                     "<script src='https://example.org/x.js'></script>", "<link href='//example.org/x.css'>"):
            with self.subTest(body):
                self.assertEqual(len(self.mistakes(body)), 1)


class Staging(unittest.TestCase):
    def test_a_link_without_target_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            (root / "README.md").write_text("[x](docs/nothing.md)", encoding="utf8")
            with self.assertRaises(pages.MissingTarget):
                pages.stage(root, root / "out")

    def test_code_is_left_alone(self):
        text = "a\n- b\n```cpp\n[](int)\n- c\n```\n"
        self.assertEqual(pages.outside_code(text, pages.for_python_markdown), "a\n\n- b\n```cpp\n[](int)\n- c\n```\n")

    def test_angle_brackets_are_no_tags(self):
        self.assertEqual(pages.for_python_markdown("<u_m> `A<B>`\n\n    <code>\n\n<https://kokkos.org>"),
                         "&lt;u_m> `A<B>`\n\n    <code>\n\n<https://kokkos.org>")

    def test_bars_in_code_of_tables_lose_their_escape(self):
        self.assertEqual(pages.for_python_markdown(r"| `a \| b` |"), "| `a | b` |")


class Headers(unittest.TestCase):
    def test_markup_in_comments_is_escaped_outside_of_code(self):
        self.assertEqual(headers.for_doxygen("/// <u> of `A<B>`\nint a;  ///< in <m>"),
                         "/// \\<u\\> of `A<B>`\nint a;  ///< in \\<m\\>")

    def test_a_list_in_columns_keeps_them(self):
        self.assertEqual(headers.for_doxygen("  /// A part:\n  ///   passes()   tuple\n  ///              of <u>\n  /// Use it.\nint a;"),
                         "  /// A part:\n  ///\n  ///        passes()   tuple\n  ///                   of <u>\n  ///\n  /// Use it.\nint a;")
        self.assertEqual(headers.for_doxygen("/// A:\n///   b\nint c;\n/// D."), "/// A:\n///\n///        b\nint c;\n/// D.")

    def test_code_and_indented_blocks_stay(self):
        for text in ("std::vector<int> x;", "///\n///     f<int>();"):
            self.assertEqual(headers.for_doxygen(text), text)


class Parameters(unittest.TestCase):
    HEADER = """struct Sand {
  double a = 1e-3;  ///< a comment
  int n = 30;
  static constexpr auto parameters() {
    return std::array{parameter("a", &Sand::a, "m", "a length that needs "
                                                    "two lines", allowed::above(0, 1)),
                      parameter("n", &Sand::n, "1", "a number", RANGE)};
  }
};"""

    def test_names_units_defaults_ranges_and_meanings_are_read(self):
        self.assertEqual(list(parameters.of_header(self.HEADER.replace("RANGE", "allowed::at_least(1)"))),
                         [("Sand", "a", "m", "1e-3", "above 0, at most 1", "a length that needs two lines"),
                          ("Sand", "n", "1", "30", "1 or more", "a number")])

    def test_parameters_of_a_nested_struct_and_vectors_are_read(self):
        header = """class Turn {
 public:
  struct Parameters {
    Vec<3, double> axis = {0, 0, 1}, up = Vec<3, double>::Zero();
    static constexpr auto parameters() {
      return std::array{parameter("axis", &Parameters::axis, "1", "direction", allowed::finite()),
                        parameter("up", &Parameters::up, "m", "height", allowed::finite())};
    }
  };
};"""
        self.assertEqual(list(parameters.of_header(header)), [("Turn", "axis", "1", "[0, 0, 1]", "finite", "direction"),
                                                              ("Turn", "up", "m", "0 each", "finite", "height")])

    def test_a_declaration_that_is_not_understood_is_no_silent_gap(self):
        for text in ("range_of_n", "allowed::even()"):
            with self.assertRaises(parameters.Unreadable):
                list(parameters.of_header(self.HEADER.replace("RANGE", text)))

    def test_every_parameter_of_the_library_is_read(self):
        found = [row for header in (ROOT / "include").rglob("*.hpp") for row in parameters.of_header(header.read_text("utf8"))]
        self.assertIn(("MuOfI", "mu_s", "1", "0.382", "0 or more", "friction at rest"), found)
        self.assertIn(("Gravity", "magnitude", "m/s^2", "9.81", "0 or more, because it acts downwards already",
                       "acceleration of gravity"), found)
        self.assertGreater(len(found), 50)


class Tutorials(unittest.TestCase):
    def test_the_head_of_a_program_becomes_text(self):
        source = "// SPDX: licence\n//\n// A ball.\n//\n//   program [time]\n#include <a>\n"
        comment, code = tutorial.split(source)
        self.assertEqual(code, "#include <a>\n")
        self.assertEqual(tutorial.prose(comment), "A ball.\n\n```text\nprogram [time]\n```\n")

    def test_each_program_of_the_course_is_a_tutorial(self):
        self.assertEqual(len(tutorial.all_of(ROOT / "examples/course")), len(list((ROOT / "examples/course").glob("*.cpp"))))


class Package(unittest.TestCase):
    def test_the_version_to_cite_is_that_of_the_headers(self):
        self.assertIn(f"\nversion: {build.version()}\n", (ROOT / "CITATION.cff").read_text(encoding="utf8"))


class Release(unittest.TestCase):
    CHANGELOG = "# C\n\n## Unreleased\n\n- x\n\n## 0.2.0 - 2027-01-02\n\n### Added\n\n- [a](docs/a.md), [b](https://b.c)\n\n## 0.1.0 - 2026-11-23\n\n- y\n"

    def test_the_notes_are_the_section_of_the_version(self):
        self.assertEqual(release_notes.notes(self.CHANGELOG, "0.2.0", "https://x/v0.2.0/"),
                         "scree 0.2.0, 2027-01-02\n\n### Added\n\n- [a](https://x/v0.2.0/docs/a.md), [b](https://b.c)\n")
        self.assertEqual(release_notes.notes(self.CHANGELOG, "0.1.0"), "scree 0.1.0, 2026-11-23\n\n- y\n")

    def test_a_version_that_is_not_released_has_no_notes(self):
        self.assertIsNone(release_notes.notes(self.CHANGELOG, "0.3.0"))
        self.assertIsNone(release_notes.notes(self.CHANGELOG, "0.2"))


class Diagram(unittest.TestCase):
    def test_the_diagram_of_a_step_is_that_of_its_script(self):
        self.assertEqual((ROOT / "docs/figures/step.svg").read_text(encoding="utf8"), step_diagram.svg(),
                         "run: python3 docs/site/step_diagram.py")


if __name__ == "__main__":
    unittest.main()
