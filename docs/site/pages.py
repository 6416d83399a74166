# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The pages of the site: Markdown files and pictures of the repository at their own paths, so that their links hold. A
source file that a page links to becomes a page, too; those of the course become tutorials."""
import re
import shutil
from pathlib import Path

import navigation
import tutorial

LINK = re.compile(r"(?<!!)(\]\()([^)\s:#]+)(#[^)\s]*)?(\))")
LANGUAGES = {".cpp": "cpp", ".hpp": "cpp", ".py": "python", ".sh": "bash", ".toml": "toml", ".json": "json"}


class MissingTarget(Exception):
    pass


def outside_code(text, change):
    """Applies `change` to the lines of a page that are not within fences."""
    parts = re.split(r"(^```.*?^```$)", text, flags=re.MULTILINE | re.DOTALL)
    return "".join(part if part.startswith("```") else change(part) for part in parts)


def without_tags(text):
    """<u> outside of code and links is meant as it stands; Python-Markdown would take it for HTML."""
    blocks = re.split(r"((?:^ {4}.*\n?)+)", text, flags=re.MULTILINE)  # those with odd numbers are indented: code
    for k in range(0, len(blocks), 2):
        parts = re.split(r"(`[^`]*`|<https?:[^>]*>)", blocks[k])
        blocks[k] = "".join(part if number % 2 else part.replace("<", "&lt;") for number, part in enumerate(parts))
    return "".join(blocks)


def for_python_markdown(text):
    """Python-Markdown wants an empty line before a list, four spaces of indentation, and no escapes in code of tables."""
    lines, before = [], ""
    for line in without_tags(text).split("\n"):
        item = re.match(r"( *)([-*]|\d+\.) ", line)
        if item and before.strip() and not re.match(r" *([-*]|\d+\.) |  ", before):
            lines.append("")
        if item and item[1]:
            line = " " * len(item[1]) + line if len(item[1]) < 4 else line
        if line.startswith("|"):
            line = re.sub(r"`[^`]*`", lambda code: code[0].replace(r"\|", "|"), line)
        lines.append(line)
        before = line
    return "\n".join(lines)


def code_page(path):
    language = LANGUAGES.get(path.suffix, "text")
    return f"# {path.name}\n\n```{language}\n{path.read_text(encoding='utf8').rstrip()}\n```\n"


def stage(root, out, hide=lambda text, where: text):
    """Fills `out` and returns the tutorials as (title, page); `hide` takes equations out of a text."""
    linked = set()

    def rewrite(page, text):
        def target_of(match):
            target = (page.parent / match[2]).resolve()
            if not target.exists():
                raise MissingTarget(f"{page}: no {match[2]}")
            anchor, link = match[3] or "", match[2]
            if target.is_dir():
                return match[1] + link.rstrip("/") + "/README.md" + anchor + match[4]
            if target.suffix in (".md", ".png", ".svg", ".webp"):
                return match[0]
            linked.add(target.relative_to(root))
            return match[1] + link + ".md" + anchor + match[4]

        return outside_code(text, lambda part: LINK.sub(target_of, for_python_markdown(part)))

    for page in navigation.sources(root):
        to = out / page.relative_to(root)
        to.parent.mkdir(parents=True, exist_ok=True)
        if page.suffix == ".md":
            to.write_text(rewrite(page, hide(page.read_text(encoding="utf8"), page.relative_to(root))), encoding="utf8")
        else:
            shutil.copyfile(page, to)
    shutil.copyfile(Path(__file__).parent / "site.css", out / "site.css")

    tutorials = tutorial.all_of(root / "examples/course")
    for each in tutorials:
        linked.discard(each.source.relative_to(root))
        (out / each.page).write_text(each.text(), encoding="utf8")
    for path in linked:
        to = out / f"{path}.md"
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(code_page(root / path), encoding="utf8")
    return [(each.title, str(each.page)) for each in tutorials]
