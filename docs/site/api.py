# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The API reference, one page for each folder of headers: declaration, text and members of each name. It is part of the site,
whose search finds all of them."""
import html
import re
from collections import defaultdict

import declarations
import fields
import names
import parameters
import roles


def linked(text, pages):
    """References become links; those to what has no page become code."""
    def link(match):
        name = match[2].removeprefix("scree::")
        return f"[{name}]({pages[match[1]]})" if match[1] in pages else name
    return re.sub("\ue002(.*?)\ue003(.*?)\ue004", link, text)


def add_meanings(found, include):
    """A member of a model that has no comment has the meaning, unit and range that `parameters()` declares."""
    meanings = {}
    for header in include.rglob("*.hpp"):
        for model, name, unit, _, allowed, meaning in parameters.of_header(header.read_text(encoding="utf8")):
            meanings[str(header.relative_to(include)), model, name] = f"{meaning}{f', {unit}' if unit != '1' else ''}; {allowed}"
    for each in found:
        for member in each.members:
            key = each.header, each.name.rpartition("::")[2], member.name
            if not member.texts and key in meanings:
                member.texts = [declarations.plain(meanings[key])]


def of_declaration(each, pages):
    """The lines of one name."""
    label = each.name + ("()" if each.kind == "function" else "")
    lines = [f"### <code>{html.escape(label)}</code> {{ #{each.anchor} }}", "", "```cpp", *each.codes, "```", ""]
    for text in each.texts:
        lines += [linked(text, pages), ""]
    if each.members:
        lines += ["| member | |", "|---|---|"]
        for member in each.members:
            text = "<br>".join(linked(paragraph, pages).replace("\n", "&#10;") for paragraph in member.texts)
            lines.append(f'| <span id="{html.escape(each.anchor)}.{member.name}"></span>{declarations.code(member.code)} | {text} |')
        lines.append("")
    return lines


def write(folder, include, out):
    """Writes the pages and returns their places in the menu."""
    found = [each for each in declarations.read(folder) if each.texts or each.members or each.kind in ("class", "struct", "concept")]
    add_meanings(found, include)
    roles.add(found, include)
    pages = {identity: each.page for each in found for identity in each.ids}
    by_folder = defaultdict(lambda: defaultdict(list))
    for each in found:
        by_folder[each.folder][each.header].append(each)
    out.mkdir(parents=True, exist_ok=True)
    members = sum(len(each.members) for each in found)
    index = ["# API", "", f"{len(found)} classes, concepts, functions and constants with {members} members, by folder of `include/scree`. "
             "The search of this site finds their names. [Fields](all_fields.md) has the fields of particles, [parameters of models](parameters.md) "
             "units, ranges and defaults, [which header has what](which_header.md) the header of each name.", "", "| folder | headers |", "|---|---|"]
    for name, headers in sorted(by_folder.items()):
        lines = [f"# {name}", "", "[Overview](../docs/overview.md) · [all folders](index.md)", ""]
        for header, list_ in sorted(headers.items()):
            lines += [f"## {header}", ""]
            for each in list_:
                lines += of_declaration(each, pages)
        (out / f"{name}.md").write_text("\n".join(lines), encoding="utf8")
        index.append(f"| [{name}]({name}.md) | {', '.join(f'`{header}`' for header in sorted(headers))} |")
    (out / "index.md").write_text("\n".join(index) + "\n", encoding="utf8")
    page_of = {each.name: each.page for each in reversed(found)}
    parameters.write(include, out / "parameters.md", {name.rpartition("::")[2]: page for name, page in page_of.items()})
    names.write(include, out / "which_header.md", page_of)
    fields.write(include, out / "all_fields.md", found)
    return [{"All folders": "api/index.md"}, {"Fields": "api/all_fields.md"}, {"Parameters of models": "api/parameters.md"},
            {"Which header has what": "api/which_header.md"}, *(f"api/{name}.md" for name in sorted(by_folder))]
