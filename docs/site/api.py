# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Tables of the API, one page for each folder of headers: name, first sentence, link to the reference of Doxygen. They make
the search of the site find the names of the library."""
import html
import re
import xml.etree.ElementTree as xml
from collections import defaultdict

import names
import parameters


def words(element):
    text = " ".join("".join(element.itertext()).split()) if element is not None else ""
    return text if len(text) < 400 else text[:400].rsplit(" ", 1)[0] + " ..."


def short(name):
    return name.removeprefix("scree::")


def entries(folder):
    """(header, kind, name, first sentence, page) of classes, concepts, functions and constants outside of classes."""
    seen = set()
    for path in sorted(folder.glob("*.xml")):
        compound = xml.parse(path).getroot().find("compounddef")
        if compound is None:
            continue
        kind, name = compound.get("kind"), words(compound.find("compoundname"))
        if compound.get("prot", "public") != "public":
            continue
        location = compound.find("location")
        if kind in ("class", "struct", "concept") and name.startswith("scree") and location is not None:
            yield location.get("file"), kind, short(name), words(compound.find("briefdescription")), compound.get("id") + ".html"
        if kind != "namespace":
            continue
        for member in compound.iter("memberdef"):
            what, label, where = member.get("kind"), words(member.find("name")), member.find("location").get("file")
            if what not in ("function", "variable", "typedef") or label.startswith("operator") or (where, label) in seen:
                continue
            brief = words(member.find("briefdescription"))
            if brief:
                seen.add((where, label))
                page, _, anchor = member.get("id").rpartition("_1")
                label = short(f"{name}::{label}") + ("()" if what == "function" else "")
                yield where, what, label, brief, f"{page}.html#{anchor}"


def write(folder, include, out):
    """Writes the pages and returns their places in the menu."""
    by_folder = defaultdict(lambda: defaultdict(list))
    for header, *entry in entries(folder):
        header = header.removeprefix("include/")
        by_folder[header.split("/")[1] if header.count("/") > 1 else "scree"][header].append(entry)
    out.mkdir(parents=True, exist_ok=True)

    def cell(text):
        return re.sub(r"([|*_`\[\]])", r"\\\1", html.escape(text, quote=False))

    count = sum(len(list_) for headers in by_folder.values() for list_ in headers.values())
    index = ["# API", "", f"{count} classes, concepts, functions and constants, by folder of `include/scree`. The search of this "
             "site finds their names. <a href=\"../reference/index.html\">The full reference</a> has their members and a search "
             "of its own. Constants and functions without a comment are in the full reference only. [Parameters of models](parameters.md) has units, "
             "ranges and defaults, [which header has what](which_header.md) the header of each name.", "",
             "| folder | headers |", "|---|---|"]
    for name, headers in sorted(by_folder.items()):
        lines = [f"# {name}", "", "[Overview](../docs/overview.md) · [all folders](index.md)", ""]
        for header, list_ in sorted(headers.items()):
            lines += [f"## {header}", "", "| name | |", "|---|---|"]
            lines += [f'| <a href="../reference/{page}"><code>{html.escape(label)}</code></a> | {cell(brief)} |'
                      for _, label, brief, page in sorted(list_, key=lambda each: each[1])]
            lines.append("")
        (out / f"{name}.md").write_text("\n".join(lines), encoding="utf8")
        index.append(f"| [{name}]({name}.md) | {', '.join(f'`{header}`' for header in sorted(headers))} |")
    (out / "index.md").write_text("\n".join(index) + "\n", encoding="utf8")
    classes = {label.rpartition("::")[2]: page for headers in by_folder.values() for list_ in headers.values()
               for kind, label, _, page in list_ if kind in ("class", "struct")}
    parameters.write(include, out / "parameters.md", classes)
    names.write(include, out / "which_header.md", {label.removesuffix("()"): page for headers in by_folder.values()
                                                   for list_ in headers.values() for _, label, _, page in list_})
    return ["api/index.md", {"Which header has what": "api/which_header.md"}, {"Parameters of models": "api/parameters.md"}, *(f"api/{name}.md" for name in sorted(by_folder))]
