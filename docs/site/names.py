# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The names that headers declare in `scree` and its namespaces, found without a compiler, and the page that tells which
header has what."""
import functools
import html
import re

OPENS, CLOSES = "({[", ")}]"


def code_of(text):
    """A header without comments, texts and directives of the preprocessor."""
    text = re.sub(r"//[^\n]*|/\*.*?\*/|\"(?:[^\"\\\n]|\\.)*\"|'(?:[^'\\\n]|\\.)+'", " ", text, flags=re.DOTALL)
    return re.sub(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", "", text, flags=re.MULTILINE)


def after(text, at):
    """The place behind the bracket that closes the one at a place; angle brackets only where one opens."""
    angles, depth = text[at] == "<", 0
    while at < len(text):
        if text[at] in OPENS or (angles and text[at] == "<"):
            depth += 1
        elif text[at] in CLOSES or (angles and text[at] == ">" and text[at - 1] != "-"):
            depth -= 1
        at += 1
        if depth == 0:
            break
    return at


def bare(declaration):
    """A declaration without template<...>, requires and [[attributes]]."""
    declaration = re.sub(r"\[\[.*?\]\]", " ", declaration).strip()
    while True:
        before = declaration
        for word in ("template", "explicit"):
            match = re.match(rf"{word}\s*(?=<)", declaration)
            if match:
                declaration = declaration[after(declaration, match.end()):].strip()
        match = re.match(r"requires\b\s*|(?:&&|\|\|)\s*", declaration)
        if match and before == declaration:
            rest = declaration[match.end():].lstrip("! ")
            if rest.startswith("("):
                rest = rest[after(rest, 0):]
            else:
                rest = re.sub(r"^[\w:]+\s*", "", rest)
                if rest.startswith("<"):
                    rest = rest[after(rest, 0):]
                if rest.startswith("{"):
                    rest = rest[after(rest, 0):]
            declaration = rest.strip()
        if declaration == before:
            return declaration


def name_of(declaration, has_body):
    """(kind, name) that a declaration in a namespace introduces, or nothing."""
    text = bare(declaration)
    if re.match(r"(static_assert|extern|friend|namespace|using namespace|private|public)\b", text) or not text:
        return None
    match = re.match(r"(struct|class|union|enum class|enum)\s+(\w+)\s*(<?)", text)
    if match:
        return ("type", match[2]) if has_body and not match[3] else None
    match = re.match(r"(concept|using)\s+(\w+)\s*=", text)
    if match:
        return "concept" if match[1] == "concept" else "type", match[2]
    flat, depth = "", 0  # without what is in angle brackets
    for k, c in enumerate(text):
        if c in "(={" and depth == 0:
            break
        is_arrow = c == ">" and text[k - 1] == "-"
        depth += (c == "<") - (c == ">" and not is_arrow)
        if depth == 0 and c != ">":
            flat += c
    match = re.search(r"(?<![:\w~])(\w+)\s*$", flat)
    if match is None or "operator" in flat:
        return None
    is_function = re.search(rf"\b{match[1]}\s*\(", text)
    return None if match[1] == "decltype" else ("function" if is_function else "constant", match[1])


def in_namespaces(text):
    """(namespace, kind, name) of each declaration outside of classes and functions."""
    code, at, spaces, start = code_of(text), 0, [], 0
    while at < len(code):
        c = code[at]
        if c == "(" or c == "[":
            at = after(code, at)
            continue
        if c == "{":
            head = code[start:at].strip()
            match = re.fullmatch(r"(?:inline\s+)?namespace\s*([\w:]*)", head)
            if match:
                spaces.append(match[1])
                at = start = at + 1
                continue
            found = name_of(head, True)
            at = after(code, at)
            rest = re.match(r"\s*[;,]|\s*\w", code[at:])  # an initialiser ends with a semicolon, a body does not
            if rest and rest[0].endswith((";", ",")):
                at += rest.end()
            start = at
            if found:
                yield "::".join(filter(None, spaces)), *found
            continue
        if c == ";":
            found = name_of(code[start:at].strip(), False)
            if found:
                yield "::".join(filter(None, spaces)), *found
            start = at + 1
        if c == "}":
            if spaces:
                spaces.pop()
            start = at + 1
        at += 1


@functools.lru_cache(maxsize=1)
def public(include):
    """{name with its namespace but `scree::`: (kind, header)} of all that users may name; the first header that declares it."""
    found = {}
    for header in sorted(include.rglob("*.hpp")):
        where = str(header.relative_to(include))
        for space, kind, name in in_namespaces(header.read_text(encoding="utf8")):
            space = re.sub(r"(^|::)(SCREE_CASES)(?=::|$)", "", space)
            if space.split("::")[0] == "scree" and "detail" not in space:
                full = "::".join([*space.split("::")[1:], name])
                found.setdefault(full, (kind, where))
    return found


def of_one_word(names):
    """Names in `scree` itself that are one word, which somebody may have for something else."""
    return sorted((name for name in names if re.fullmatch(r"[A-Z]?[a-z]+", name)), key=lambda name: (name.lower(), name))


def members_of(text, name):
    """The data members of a struct in a header, in their order."""
    body = code_of(text)
    body = body[re.search(rf"^struct {name} (?:: [^{{]*)?{{", body, re.MULTILINE).end() - 1:]
    flat, depth = "", 0
    for c in body[:after(body, 0)]:
        depth -= c in CLOSES
        flat += c if depth == 1 or c in "({" else ""
        depth += c in OPENS
        if c == "}" and depth == 1:
            flat += ";" if re.search(r"[)\w]\s*\{\}$", flat) and "=" not in flat.split(";")[-1] else ""
    found = []
    while flat != (flat := re.sub(r"<[^<>;]*>", "", flat)):
        continue
    for each in flat.split(";"):
        each = re.sub(r"=[^,]*", "", each).strip(" {\n")
        if "(" not in each and re.fullmatch(r"(?:typename )?[\w:]+(?:\s+\w+(?:\s*,\s*\w+)*)", each) and not re.match(
                r"(using|static|return|template|class|struct|public|private)\b", each):
            found += [part.split()[-1] for part in each.split(",")]
    return found


def write(include, out, page_of):
    """Writes the table of names and headers; `page_of` gives the page of the reference for a name."""
    found = public(include)
    spaces = sorted({name.rpartition("::")[0] for name in found})
    lines = ["# Which header has what", "", f"The {len(found)} names that the headers declare, by namespace, each with the header to include. "
             "`scree/scree.hpp` includes most of what formulations need. [API](index.md) tells what they are.", ""]
    for space in spaces:
        lines += [f"## {'::'.join(filter(None, ('scree', space)))}", "", "| name | header |", "|---|---|"]
        for name in sorted((each for each in found if each.rpartition("::")[0] == space), key=str.lower):
            kind, header = found[name]
            label = html.escape(name.rpartition("::")[2] + ("()" if kind == "function" else ""))
            link = f'[<code>{label}</code>]({page_of[name]})' if name in page_of else f"`{label}`"
            lines.append(f"| {link} | `{header}` |")
        lines.append("")
    out.write_text("\n".join(lines), encoding="utf8")
