# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Equations of pages and comments are found, rendered and put where they were."""
import re
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "docs/site"))
import mathematics  # noqa: E402
import navigation  # noqa: E402

# What equations were written with before they were LaTeX.
PLAIN = re.compile(r"\bsum_\w|\bgrad[A-Z]_|\bsqrt\(|\bgamma_dot\b|\b[a-zA-Z]+_ij\b|\bghat\b|\bd\w+/dt\b")
NOT_TEXT = re.compile(r"^```.*?^```$|`[^`]*`|\]\([^)]*\)|\"[^\"]*\"|^#[^\n]*", re.MULTILINE | re.DOTALL)


def without(text, pattern):
    return re.sub(pattern, lambda match: "\n" * match[0].count("\n"), text)


def rendered_as(equations):
    """In the place of KaTeX: the LaTeX between <math> and </math>; \\wrong is a mistake."""
    return [{"mistake": "no such symbol"} if "wrong" in tex else {"html": f"<b><math>{tex}</math></b>"} for tex, _ in equations]


class Found(unittest.TestCase):
    def found(self, text):
        equations = mathematics.Equations()
        hidden = equations.hide_in_page(text, "page.md")
        return [(tex, display) for tex, display, _ in equations.found], hidden

    def test_equations_of_a_page_are_those_outside_of_code(self):
        text = "With $a_i = b$, `$c$`, costs of $5 or 6 $, $HOME\nand\n\n```math\nx =\n y\n```\n\n```bash\necho $OUT $IN\n```\n"
        found, hidden = self.found(text)
        self.assertEqual(found, [("x = y", True), ("a_i = b", False)])
        self.assertIn("echo $OUT $IN", hidden)
        self.assertIn("`$c$`", hidden)

    def test_an_equation_of_a_comment_may_go_over_the_end_of_a_line(self):
        equations = mathematics.Equations()
        hidden = equations.hide_in_header("int a$b; int c$d;\n/// The sum $a +\n/// b$ of both.\nint x;\n", "x.hpp")
        self.assertEqual([tex for tex, _, _ in equations.found], ["a + b"])
        self.assertTrue(hidden.startswith("int a$b; int c$d;\n"))

    def test_a_paragraph_ends_an_equation(self):
        self.assertEqual(self.found("a $x\n\ny$ b")[0], [])


class Put(unittest.TestCase):
    def test_equations_come_into_pages_titles_and_the_index_of_the_search(self):
        equations = mathematics.Equations()
        place = equations.hide_in_page("$a$", "page.md")
        equations.results = lambda out: [("<b>A</b>", "A")]
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / "page.html").write_text(f"<head><title>{place}</title></head><body>{place}</body>", encoding="utf8")
            (folder / "search_index.json").write_text(f'"{place}", "\\ue0000\\ue001"', encoding="utf8")
            self.assertEqual(equations.put_into(folder), 1)
            self.assertEqual((folder / "page.html").read_text(encoding="utf8"), "<head><title>A</title></head><body><b>A</b></body>")
            self.assertEqual((folder / "search_index.json").read_text(encoding="utf8"), '"A", "A"')

    def test_a_mistake_names_the_file_and_the_equation(self):
        equations = mathematics.Equations(lambda all_: (rendered_as(all_), Path()))
        equations.hide_in_page(r"$a$ $\wrong$", "docs/page.md")
        with self.assertRaisesRegex(mathematics.Unreadable, r"docs/page.md: no such symbol: \\wrong"):
            equations.results(Path())

    def test_without_katex_equations_are_shown_as_they_are_written(self):
        def missing(_):
            raise mathematics.Unavailable

        equations = mathematics.Equations(missing)
        equations.hide_in_page("$a < b$", "page.md")
        with tempfile.TemporaryDirectory() as name:
            self.assertEqual(equations.results(Path(name) / "katex"), [("<code>a &lt; b</code>", "a < b")])
        self.assertTrue(equations.unavailable)


class Repository(unittest.TestCase):
    def test_comments_have_no_equation_in_plain_characters(self):
        for header in sorted((ROOT / "include").rglob("*.hpp")):
            text = mathematics.Equations().hide_in_header(header.read_text(encoding="utf8"), header)
            comments = re.sub(r"`[^`]*`", "", "\n".join(re.findall(r"///<?( ?\S.*)", text)))  # but for lists in columns
            self.assertEqual([comments[max(0, match.start() - 30):match.end() + 30] for match in PLAIN.finditer(comments)], [], header)

    def test_the_theory_has_no_equation_in_plain_characters(self):
        pages = [path for path in navigation.sources(ROOT) if path.suffix == ".md" and path.parts[-2] == "theory"]
        self.assertGreater(len(pages), 5)
        for page in pages:
            equations = mathematics.Equations()
            text = without(equations.hide_in_page(page.read_text(encoding="utf8"), page), NOT_TEXT)
            self.assertEqual([text[max(0, match.start() - 30):match.end() + 30] for match in PLAIN.finditer(text)], [], page)
            self.assertEqual(re.findall(r"(?:^|\n\n) {4}[^-* \d].*", text), [], f"{page}: equations are ```math blocks")

    def test_katex_knows_each_equation(self):
        equations = mathematics.Equations()
        for page in navigation.sources(ROOT):
            if page.suffix == ".md":
                equations.hide_in_page(page.read_text(encoding="utf8"), page.relative_to(ROOT))
        for header in (ROOT / "include").rglob("*.hpp"):
            equations.hide_in_header(header.read_text(encoding="utf8"), header.relative_to(ROOT))
        self.assertGreater(sum(display for _, display, _ in equations.found), 70)
        with tempfile.TemporaryDirectory() as name:
            results = equations.results(Path(name) / "katex")
            if equations.unavailable:
                self.skipTest("KaTeX or Node.js is missing; on Debian: apt-get install katex")
            self.assertEqual([words for html, words in results if "<math" not in html], [])
            style = (Path(name) / "katex/katex.css").read_text(encoding="utf8")
            self.assertTrue(style)
            for font in re.findall(r"url\(([^)]*)\)", style):
                self.assertTrue((Path(name) / "katex" / font).exists(), font)


if __name__ == "__main__":
    unittest.main()
