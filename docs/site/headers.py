# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Copies of the headers for Doxygen, in whose comments <u>, \\ and the like are plain characters, as they are meant."""
import re


def plain(comment):
    """Escapes what Doxygen would take for HTML, a command or a link, except in `code`."""
    parts = re.split(r"(`[^`]*`)", comment)
    return "".join(part if part.startswith("`") else re.sub(r"(?<!\w)(::)", r"\\\1", re.sub(r"([\\<>@#%])", r"\\\1", part))
                   for part in parts)


def for_doxygen(text):
    """An indented block after an empty line of a comment is code, and remains as it is; other indented lines are a list in
    columns, and become code, so that they keep their columns. The inline namespace whose name a macro gives is left out."""
    text = re.sub(r"^(inline namespace SCREE_CASES \{|\}  // namespace SCREE_CASES)$", "", text, flags=re.MULTILINE)
    text = re.sub(r"^#if __has_include\(<[^>]*>\)", "#if 1", text, flags=re.MULTILINE)  # all that a machine may have
    lines, before, in_code, in_list = [], "", False, False
    for line in text.split("\n"):
        match = re.search(r"(///<?)(.*)$", line)
        starts = line.strip().startswith("///") and match and match[1] == "///"
        indented = bool(starts and re.match(r"   *(?![-*] )\S", match[2]) and match[2].startswith("   "))
        in_code = bool(starts and match[2].startswith("     ") and (in_code or before == "///") and not in_list)
        if starts and (indented and not in_code) != in_list:
            in_list = not in_list
            lines.append(line[:match.start()] + "///")  # an empty line before and after
        elif not starts:
            in_list = False
        if in_list:
            line = line[:match.start()] + "///     " + match[2]
        elif match and not in_code:
            line = line[:match.start()] + match[1] + plain(match[2])
        before = line.strip()
        lines.append(line)
    return "\n".join(lines)


def copy(source, out, hide=lambda text, where: text):
    """Copies the headers; `hide` takes equations out of a text."""
    for path in source.rglob("*.hpp"):
        to = out / path.relative_to(source)
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(for_doxygen(hide(path.read_text(encoding="utf8"), path)), encoding="utf8")
