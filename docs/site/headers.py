# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Copies of the headers for Doxygen, in whose comments <u>, \\ and the like are plain characters, as they are meant."""
import re


def plain(comment):
    """Escapes what Doxygen would take for HTML, a command, a link or the end of the first sentence, except in `code`."""
    comment = re.sub(r"\b(al|eq|vs)\.(?: |$)", lambda match: match[0].rstrip() + "\0", comment)
    parts = re.split(r"(`[^`]*`)", comment)
    return "".join(part if part.startswith("`") else re.sub(r"(?<!\w)(::)", r"\\\1", re.sub(r"([\\<>@#%])", r"\\\1", part))
                   for part in parts).replace("\0", "\\ ")


def for_doxygen(text):
    """An indented block after an empty line of a comment is code, and remains as it is. The inline namespace whose name a
    macro gives is left out."""
    text = re.sub(r"^(inline namespace SCREE_CASES \{|\}  // namespace SCREE_CASES)$", "", text, flags=re.MULTILINE)
    text = re.sub(r"^#if __has_include\(<[^>]*>\)", "#if 1", text, flags=re.MULTILINE)  # all that a machine may have
    lines, before, in_code = [], "", False
    for line in text.split("\n"):
        match = re.search(r"(///<?)(.*)$", line)
        if match:
            indented = match[2].startswith("     ")
            in_code = indented and (in_code or before == "///")
            if not in_code:
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
