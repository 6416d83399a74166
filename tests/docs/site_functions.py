# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Each public function has a text, which says what it returns and when it throws."""
import re
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
INCLUDE = ROOT / "include"
sys.path.insert(0, str(ROOT / "docs/site"))
import build  # noqa: E402
import declarations  # noqa: E402
import mathematics  # noqa: E402
import roles  # noqa: E402

THROWS = re.compile(r"\bthrow\b(?!;)|\bcheck_setting\(|\bcheck_parameters\(|\bcheck_settings_of\(|\bfail\(")
SAYS_SO = re.compile(r"\b([Tt]hrow|refuse|[Ee]nds all|does not compile)")
# A text that begins with a verb tells what a function does, not what it returns.
VERB = re.compile(r"(?:Adds|Appends|Builds|Checks|Combines|Computes|Continues|Converts|Copies|Creates|Describes|Evaluates|Extrapolates|Fills|Finds|Fuses|"
                  r"Gathers|Goes on|Joins|Loads|Makes|Measures|Merges|Moves|Opens|Prints|Puts|Reads|Reduces|Removes|Replaces|Runs|Says|"
                  r"Sets|Sorts|Sums|Takes|Throws|Turns|Updates|Writes)\b(?! of\b)|(?:[A-Z][a-z]+s (?:the|a|an|all|each|its|it|one|what|whether|any)\b)")
RETURNS = re.compile(r"\b[Rr]eturn|\b[Gg]ives?\b|whether|; (?:true|false)\b|gets? (?:it|them|one|those)\b")


def functions(found):
    """(header, name, [overloads], text) of the functions of headers that are written out."""
    for each in found:
        if each.kind == "function":
            yield each.header, each.name, each.overloads, " ".join(each.texts)
        if "<" in each.name:  # a specialisation has the functions of its template
            continue
        by_name = {}
        for member in each.members:
            if "(" in member.code and member.result.find("(*") < 0 and is_function(member):
                by_name.setdefault(member.name, []).append(member)
        for name, overloads in by_name.items():
            yield each.header, f"{each.name}::{name}", overloads, " ".join(text for one in overloads for text in one.texts)


def is_function(member):
    return re.search(rf"(?<!\w){re.escape(member.name)}\(", member.code) and not re.search(r"=\s*(default|delete)$", member.code)


def bodies_elsewhere(root):
    """{Class::function or function: body} of files .ipp, and of sources of the library."""
    found = {}
    start = re.compile(r"^(?:SCREE_BODY )?(?!namespace|using|struct|class|template|static_assert|typedef|//|#)[A-Za-z][^\n;=({]*?([\w:]+)\(",
                       re.MULTILINE)
    for path in [*sorted((root / "include").rglob("*.ipp")), *sorted((root / "src").rglob("*.cpp"))]:
        text = path.read_text(encoding="utf8")
        for match in start.finditer(text):
            body = re.split(r"^(?:\}|[^\n]*;$)", text[match.start():], maxsplit=1, flags=re.MULTILINE)[0]
            if "{" in body:
                body = re.split(r"^\}", text[match.start():], maxsplit=1, flags=re.MULTILINE)[0]
                found[match[1]] = found.get(match[1], "") + re.sub(r"//.*", "", body)
    return found


def faults(found, elsewhere):
    """What the texts of functions leave out."""
    result = []
    for header, name, overloads, text in functions(found):
        code = "\n".join([*(one.body for one in overloads), *(elsewhere.get(each, "") for each in {name, "::".join(name.split("::")[-2:]), name.removeprefix("app::")})])
        types = {one.result.split()[-1] if one.result else "" for one in overloads}
        if not text.strip():
            result.append(f"{header}: {name} has no text")
        elif THROWS.search(code) and not SAYS_SO.search(text):
            result.append(f"{header}: {name} throws, and its text does not say when")
        elif not types <= {"void", ""} and VERB.match(text) and not RETURNS.search(text):
            result.append(f"{header}: {name} returns {', '.join(types)}, and its text does not say what that is: {text[:100]}")
    return result


HEADER = """
namespace scree {
/// A role:
///   size()     the number of them, 0 or more
///   at(n)      element n. Throws std::out_of_range
///              beyond the last
template <class T>
concept Role = requires(T t) {
  t.size();
  t.at(1);
};
/// A class with the role.
struct Good {
  int size() const;
  int at(int n) const { if (n > 0) throw 1; return n; }
  Good() = default;
  Good(Good const&) = delete;
};
/// A class with faults.
struct Bad {
  explicit Bad(int n);
  /// Sets the number.
  void set(int n) { check_setting(n > 0, "n", n, "above 0"); }
  /// Fills the box.
  double fill() const;
  /// The number. It must not be 0.
  int number() { if (n == 0) throw 1; return n; }
  int n = 0;
};
/// Sums of something; throws nothing.
int sums();
}
"""


def read(include, folder):
    build.extract(include, Path(folder), mathematics.Equations())
    return roles.add(declarations.read(Path(folder) / "xml"), include)


@unittest.skipUnless(shutil.which("doxygen"), "doxygen is missing")
class Functions(unittest.TestCase):
    def test_each_fault_is_found(self):
        with tempfile.TemporaryDirectory() as include, tempfile.TemporaryDirectory() as folder:
            (Path(include) / "scree/some").mkdir(parents=True)
            (Path(include) / "scree/some/some.hpp").write_text(HEADER, encoding="utf8")
            found = read(Path(include), folder)
        self.assertEqual([fault.split(": ", 1)[1].split(":  ")[0] for fault in faults(found, {"sums": "throw 1;", "Bad::set": "throw 1;"})],
                         ["Bad::Bad has no text", "Bad::set throws, and its text does not say when",
                          "Bad::fill returns double, and its text does not say what that is: Fills the box.",
                          "Bad::number throws, and its text does not say when"])
        texts = {member.name: member.texts for each in found if each.name == "Good" for member in each.members}
        self.assertIn("Element n. Throws std::out_of_range beyond the last. Part of the role", texts["at"][0])
        self.assertIn("The number of them, 0 or more. Part of the role", texts["size"][0])

    def test_texts_of_functions_leave_nothing_out(self):
        with tempfile.TemporaryDirectory() as folder:
            found = read(INCLUDE, folder)
        self.assertGreater(sum(1 for _ in functions(found)), 1000)
        self.assertEqual(faults(found, bodies_elsewhere(ROOT)), [])


if __name__ == "__main__":
    unittest.main()
