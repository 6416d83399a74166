# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Equations of pages and comments, which are LaTeX: $...$ in text, and ```math blocks of one equation each.

KaTeX renders them while the site is built: the pages have its HTML, for the eyes, and MathML, for screen readers, and its style
sheet and fonts lie in the site, so that a browser needs neither a script nor another host. Tools that work on the text in
between see one character of Unicode's private area, a number and another such character."""
import html
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

OPEN, CLOSE = "\ue000", "\ue001"
PLACE = re.compile(f"{OPEN}(\\d+){CLOSE}")
IN_TEXT = re.compile(r"(?<![\\$\w])\$(?=[^\s$])((?:[^$`\n]|\n(?!\s*\n))*?[^\s$\\])\$(?![\w$])")
BLOCK = re.compile(r"^( *)```math\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)
PROGRAM = """
const katex = require('katex'), all = JSON.parse(require('fs').readFileSync(0, 'utf8'));
console.log(JSON.stringify({program: require.resolve('katex'), answers: all.map(({tex, display}) => {
  try { return {html: katex.renderToString(tex, {displayMode: display, strict: 'error'})}; }
  catch (mistake) { return {mistake: String(mistake.message)}; }
})}));
"""


class Unreadable(Exception):
    pass


class Unavailable(Exception):
    pass


def katex(equations):
    """The answer of KaTeX for each (tex, display), and its folder; Unavailable if it is not installed."""
    paths = [os.environ.get("NODE_PATH"), "/usr/share/nodejs", "/usr/local/lib/node_modules"]
    given = json.dumps([{"tex": tex, "display": display} for tex, display in equations])
    try:
        done = subprocess.run(["node", "-e", PROGRAM], input=given, capture_output=True, text=True, check=False,
                              env={**os.environ, "NODE_PATH": ":".join(filter(None, paths))})
    except FileNotFoundError as missing:
        raise Unavailable from missing
    if done.returncode != 0:
        if "Cannot find module 'katex'" in done.stderr:
            raise Unavailable
        raise Unreadable(done.stderr.strip())
    said = json.loads(done.stdout)
    return said["answers"], Path(said["program"]).parent


def words(rendered):
    """An equation in characters, for the index of the search and for titles."""
    mathml = re.search(r"<math.*?</math>", rendered, re.DOTALL)[0]
    return html.unescape(re.sub(r"<annotation.*?</annotation>|<[^>]*>", "", mathml, flags=re.DOTALL))


def copy_style(program, out):
    """The style sheet and the fonts of KaTeX; of the three formats of each font the one that all present browsers read."""
    (out / "fonts").mkdir(parents=True)
    style = (program / "katex.min.css").read_text(encoding="utf8")
    style = re.sub(r",url\([^)]*\.(?:woff|ttf)\) ?format\(['\"]\w+['\"]\)", "", style)
    (out / "katex.css").write_text(style, encoding="utf8")
    for font in set(re.findall(r"url\(fonts/([^)]*)\)", style)):
        shutil.copyfile(program / "fonts" / font, out / "fonts" / font)


class Equations:
    """Takes equations out of texts, and puts what KaTeX makes of them in their places. `unavailable` tells that KaTeX is not
    installed; the equations are then shown as they are written."""

    def __init__(self, render=katex):
        self.found, self.render, self.unavailable = [], render, False

    def place(self, tex, display, where):
        self.found.append((" ".join(tex.split()), display, where))
        return f"{OPEN}{len(self.found) - 1}{CLOSE}"

    def hide_in_page(self, text, where):
        """A page without its equations; code stays."""
        text = BLOCK.sub(lambda match: match[1] + self.place(match[2], True, where), text)
        parts = re.split(r"(^```.*?^```$|`[^`]*`)", text, flags=re.MULTILINE | re.DOTALL)
        return "".join(part if part.startswith("`") else IN_TEXT.sub(lambda match: self.place(match[1], False, where), part)
                       for part in parts)

    def hide_in_header(self, text, where):
        """A header without the equations of its comments. An equation may go over the end of a line of a comment."""
        def equation(match):
            return self.place(re.sub(r"\n *///? ?", " ", match[1]), False, where)
        return re.sub(r"(?:[^\n]*///[^\n]*\n)+", lambda comment: IN_TEXT.sub(equation, comment[0]), text)

    def results(self, out):
        """(HTML, words) of each equation; a style sheet comes to `out`. A mistake is Unreadable, with the file that has it."""
        try:
            answers, program = self.render([(tex, display) for tex, display, _ in self.found])
        except Unavailable:
            self.unavailable = True
            out.mkdir(parents=True)
            (out / "katex.css").write_text("")
            return [(f"<code>{html.escape(tex)}</code>", tex) for tex, _, _ in self.found]
        for (tex, _, where), answer in zip(self.found, answers):
            if "mistake" in answer:
                raise Unreadable(f"{where}: {answer['mistake']}: {tex}")
        copy_style(program, out)
        return [(answer["html"], words(answer["html"])) for answer in answers]

    def put_into(self, folder):
        """Puts the equations into the HTML below a folder, and their words into the index of the search."""
        results = self.results(folder / "katex")
        for path in folder.rglob("*.html"):
            text = path.read_text(encoding="utf8")
            if OPEN in text:
                head, body, rest = text.partition("<body")  # <title> and <meta> have words alone
                head = PLACE.sub(lambda match: html.escape(results[int(match[1])][1]), head)
                path.write_text(head + body + PLACE.sub(lambda match: results[int(match[1])][0], rest), encoding="utf8")
        for path in folder.rglob("*.js*"):
            text = path.read_text(encoding="utf8")
            text = re.sub(r"\\ue000(\d+)\\ue001", f"{OPEN}\\1{CLOSE}", text)  # JSON in ASCII
            if OPEN in text:
                path.write_text(PLACE.sub(lambda match: json.dumps(html.escape(results[int(match[1])][1]))[1:-1], text), encoding="utf8")
        return len(results)
