# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The names of the library in the pages are those of the headers."""
import re
import sys
import textwrap
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
sys.path.insert(0, str(ROOT / "docs/site"))
import names  # noqa: E402

HEADER = """
#define MACRO(x) struct x {};
namespace scree {
class Later;
/// struct InComment {};
template <class T, template <class> class Q = Default>
requires Fits<T> && (sizeof(T) > 1)
class [[nodiscard]] Whole : public Base<T> {
  struct Inner {};
  void member() {}
};
template <class T>
class Whole<T*> {};
template <class T>
concept Fits = requires(T t) { t.x(); };
using Alias = Whole<int>;
enum class Kind { one, two };
inline constexpr Whole<int> constant{};
template <class T>
inline constexpr bool is_fit = (sizeof(T) < 3);
inline std::vector<Whole<int>> made(int a = {}, char const* text = "struct No {};") { struct Local {}; return {}; }
template <class T>
requires(std::is_same_v<T, int>) SCREE_FN auto shifted(T x) -> decltype(x) { return x; }
bool operator==(Alias const&, Alias const&);
void Whole<int>::outside() {}
namespace fields { inline constexpr Whole<int> velocity{}; }
inline namespace two { struct InTwo {}; }
namespace detail { struct Hidden {}; }
}  // namespace scree
"""


class Names(unittest.TestCase):
    def test_names_of_namespaces_are_found_and_no_others(self):
        self.assertEqual(list(names.in_namespaces(HEADER)),
                         [("scree", "type", "Whole"), ("scree", "concept", "Fits"), ("scree", "type", "Alias"), ("scree", "type", "Kind"),
                          ("scree", "constant", "constant"), ("scree", "constant", "is_fit"), ("scree", "function", "made"),
                          ("scree", "function", "shifted"), ("scree::fields", "constant", "velocity"),
                          ("scree::two", "type", "InTwo"), ("scree::detail", "type", "Hidden")])

    def test_each_name_has_the_header_that_declares_it(self):
        found = names.public(INCLUDE)
        for name, kind, header in (("Solver", "type", "solver/solver.hpp"), ("fill_lattice", "function", "setup/lattice.hpp"),
                                   ("fields::velocity", "constant", "fields/standard.hpp"), ("app::Run", "type", "app/run.hpp"),
                                   ("RotationAbout", "type", "motion/rotation_about.hpp"), ("app::run_program", "function", "app/program.hpp"),
                                   ("plane_strain_cone", "function", "laws/drucker_prager.hpp")):
            self.assertEqual(found.get(name), (kind, f"scree/{header}"), name)
        self.assertEqual([name for name in found if "detail" in name or "SCREE" in name], [])

    def test_the_members_of_a_struct_are_found_in_their_order(self):
        text = "struct A : B<int> {\n  using T = int;\n  double a = 0, b;\n  std::vector<X<1>> list = {1, 2};\n  static constexpr int no = 1;\n" \
               "  void f() const { int no2; }\n  typename M::law law = {};\n  A(int no3);\n};\nstruct C { int no4; };"
        self.assertEqual(names.members_of(text, "A"), ["a", "b", "list", "law"])


class Questions(unittest.TestCase):
    PAGE = (ROOT / "docs/faq.md").read_text(encoding="utf8")

    def test_the_names_of_one_word_are_those_of_the_headers(self):
        right = ", ".join(f"`{name}`" for name in names.of_one_word(names.public(INCLUDE))) + "."
        there = " ".join(self.PAGE.split("These are the names of one word:")[1].split("\n## ")[0].split())
        self.assertEqual(there, right, "docs/faq.md should have\n" + textwrap.fill(right, 125, break_on_hyphens=False))

    def test_the_members_of_settings_are_listed_in_their_order(self):
        rows = re.findall(r"^\| `(\w+)` \| ((?:`\w+`(?:, )?)+) \|$", self.PAGE, re.MULTILINE)
        self.assertGreater(len(rows), 4)
        found = names.public(INCLUDE)
        for struct, members in rows:
            header = (INCLUDE / found[struct][1]).read_text(encoding="utf8")
            self.assertEqual(re.findall(r"\w+", members), names.members_of(header, struct), struct)


if __name__ == "__main__":
    unittest.main()
