# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Tutorials: each program of examples/course as a page, made from its source and its row in the table of the course."""
import re
from dataclasses import dataclass
from pathlib import Path


class NotInTable(Exception):
    pass


@dataclass
class Tutorial:
    source: Path
    new: str
    time: str
    result: str
    picture: str  # of the result, beside the source; empty if there is none

    @property
    def title(self):
        number, *words = self.source.stem.split("_")
        return f"{int(number)}. {' '.join(words).capitalize()}".replace("gpu", "GPU")

    @property
    def page(self):
        return Path("examples/course") / f"{self.source.name}.md"

    def text(self):
        comment, code = split(self.source.read_text(encoding="utf8"))
        name = self.source.stem
        picture = f"![{self.result}]({self.picture})\n\n" if self.picture else ""
        return (f"---\nhide: [toc]\n---\n\n# {self.title}\n\n{prose(comment)}\n\n{picture}**New here:** {self.new}.\n\n**What to expect:** "
                f"{self.result} ({self.time} on one core).\n\n"
                f"```bash\ncmake --build build/openmp --target course_{name}\n"
                f"build/openmp/examples/course/course_{name}\n```\n\n## The program\n\n"
                f"`examples/course/{self.source.name}`, complete:\n\n```cpp linenums=\"1\"\n{code.rstrip()}\n```\n")


def split(source):
    """The comment at the head of a program, without the licence, and the rest."""
    lines = source.split("\n")
    end = next(k for k, line in enumerate(lines) if not line.startswith("//"))
    comment = [re.sub(r"^// ?", "", line) for line in lines[:end] if "SPDX" not in line]
    return "\n".join(comment).strip("\n"), "\n".join(lines[end:])


def prose(comment):
    """Indented lines of a comment are code."""
    return re.sub(r"(?:^  .*\n?)+", lambda block: "```text\n" + re.sub(r"^  ", "", block[0], flags=re.M).rstrip() + "\n```\n",
                  comment, flags=re.MULTILINE)


def all_of(folder):
    rows = {}
    for line in (folder / "README.md").read_text(encoding="utf8").splitlines():
        cells = [cell.strip() for cell in line.strip("| ").split(" | ")]
        match = re.match(r"\[(\w+)\]\((\w+\.cpp)\)", cells[0])
        if match and len(cells) == 4:
            rows[match[2]] = cells[1:]
    tutorials = []
    for source in sorted(folder.glob("*.cpp")):
        if source.name not in rows:
            raise NotInTable(f"{source} has no row in the table of {folder}/README.md")
        picture = f"figures/{source.stem}.png"
        tutorials.append(Tutorial(source, *rows[source.name], picture if (folder / picture).exists() else ""))
    return tutorials
