# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What the headers declare outside of `detail`, with the text of the comments, from the XML of Doxygen."""
import html
import re
import textwrap
import xml.etree.ElementTree as xml
from dataclasses import dataclass, field

KINDS = ("class", "struct", "concept", "function", "variable", "typedef", "enum")


@dataclass
class Member:
    name: str
    code: str
    texts: list
    line: int = 0
    result: str = ""  # type of what a function returns
    body: str = ""  # its code, where the header has it


@dataclass
class Declaration:
    header: str  # below include/
    line: int
    kind: str
    name: str  # without `scree::`
    codes: list  # one for each overload
    texts: list  # paragraphs in Markdown
    type_of: str = ""  # of a constant, the id of its type
    members: list = field(default_factory=list)
    overloads: list = field(default_factory=list)  # of a function, as members
    ids: list = field(default_factory=list)  # those of Doxygen

    @property
    def folder(self):
        parts = self.header.split("/")
        return parts[1] if len(parts) > 2 else "scree"

    @property
    def anchor(self):
        return re.sub(r"[^\w.:]+", "-", self.name).strip("-")

    @property
    def page(self):
        return f"{self.folder}.md#{html.escape(self.anchor)}"


def words(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def short(name):
    return name.removeprefix("scree::")


def spaced(code):
    """Code as a reader writes it, from the tokens of Doxygen: no blanks within angle brackets and before commas."""
    code = re.sub(r"\s+", " ", code).replace("scree::", "")
    code = re.sub(r"\b(\w+) =  ?(typedef )?", r"\1 = ", code)
    return re.sub(r"< (?=\S)", "<", re.sub(r"(?<=\S) >", ">", code)).strip()


def code(text):
    """Code within text, whose characters are no Markdown; in a table, too."""
    text = html.escape(text, quote=False)
    return "<code>" + re.sub(r"[|*_`\\\[\]$]", lambda match: f"&#{ord(match[0])};", text) + "</code>"


def plain(text):
    """Text whose characters are no Markdown."""
    return re.sub(r"([\\`*_{}\[\]|#$])", r"\\\1", html.escape(text, quote=False))


def markdown(element):
    """The paragraphs of a description. [[id|name]] is a reference to a declaration."""
    paragraphs = []

    def inline(each):
        text = plain(each.text or "")
        for child in each:
            if child.tag == "computeroutput":
                text += code("".join(child.itertext()))
            elif child.tag == "ref":
                text += f"\ue002{child.get('refid')}\ue003{plain(''.join(child.itertext()))}\ue004"
            elif child.tag == "verbatim":
                block = re.sub(r"^\n+|\s+$", "", child.text or "")
                text += f"\n\n<pre>{code(textwrap.dedent(block))}</pre>\n\n"
            elif child.tag == "itemizedlist":
                text += "\n\n" + "".join(f"- {inline(item).strip()}\n" for item in child) + "\n"
            elif child.tag == "ndash":
                text += "--"
            else:
                text += inline(child)
            text += plain(child.tail or "")
        return text

    if element is not None:
        for para in element.iter("para"):
            paragraphs += [re.sub(r"[ \n]+", " ", part).strip() if not part.startswith(("<pre>", "- ")) else part
                           for part in re.split(r"\n\n+", inline(para)) if part.strip()]
    return paragraphs


def texts_of(element):
    return markdown(element.find("briefdescription")) + markdown(element.find("detaileddescription"))


def template_of(element):
    """template<...> of a declaration, and what it requires."""
    listed = element.find("templateparamlist")
    code = ""
    if listed is not None:
        parts = []
        for each in listed:
            default = each.find("defval")
            name = words(each.find("declname"))
            type_ = words(each.find("type"))
            parts.append(type_ + (f" {name}" if name and not type_.endswith(name) else "")
                         + (f" = {words(default)}" if default is not None else ""))
        code = f"template <{', '.join(parts)}> "
    requires = element.find("requiresclause")
    return code + (f"requires {words(requires)} " if requires is not None else "")


def code_of(member):
    """The declaration of a function, variable or type."""
    kind, name = member.get("kind"), words(member.find("name"))
    if kind == "typedef":
        return spaced(template_of(member) + re.sub(r"using .*?(\w+) = ", r"using \1 = ", words(member.find("definition"))))
    if kind == "function":
        prefix = "static " if member.get("static") == "yes" and "::" in words(member.find("qualifiedname")).removeprefix("scree::") else ""
        arguments = words(member.find("argsstring"))
        type_ = words(member.find("type"))
        return spaced(template_of(member) + prefix + f"{type_} {name}".strip()) + spaced(arguments)
    if kind == "enum":
        values = ", ".join(words(each.find("name")) for each in member.iter("enumvalue"))
        return f"enum class {name} {{ {values} }}" if member.get("strong") == "yes" else f"enum {name} {{ {values} }}"
    initial = words(member.find("initializer"))
    type_ = words(member.find("type"))
    static = "static " if member.get("static") == "yes" and "constexpr" in type_ else ""
    return spaced(f"{template_of(member)}{static}{type_} {name}{words(member.find('argsstring'))}"
                  + (f" {initial}" if initial and len(initial) < 60 else ""))


def body_of(member, folder):
    """The lines of a function, from the headers that Doxygen read, which lie beside its XML."""
    where = member.find("location")
    first, last = (int(where.get(name) or -1) for name in ("bodystart", "bodyend"))
    if member.get("kind") != "function" or first < 0 or last < first:
        return ""
    lines = (folder.parent / "headers" / where.get("bodyfile")).read_text(encoding="utf8").splitlines()
    return "\n".join(re.sub(r"//.*", "", line) for line in lines[first - 1:last])


def member_of(member, folder):
    return Member(words(member.find("name")), code_of(member), texts_of(member), int(member.find("location").get("line")),
                  words(member.find("type")), body_of(member, folder))


def members_of(compound, folder):
    found = {}
    for member in compound.iter("memberdef"):
        name = words(member.find("name"))
        if member.get("prot") != "public" or member.get("kind") not in KINDS or name.startswith(("operator", "~", "@")):
            continue
        new = member_of(member, folder)
        for value in member.iter("enumvalue"):
            if texts_of(value):
                new.texts.append(f"{code(words(value.find('name')))}: " + " ".join(texts_of(value)))
        if new.texts or not any(each.texts for each in found.values() if each.name == name):
            found[new.code] = new
    members = list(found.values())
    for each, last in zip(reversed(members[:-1]), reversed(members[1:])):  # the comment of `a, b` is that of both
        if not each.texts and each.line == last.line:
            each.texts = last.texts
    return members


def of_compound(compound, name, folder):
    kind = compound.get("kind")
    head = f"{template_of(compound)}{kind} {name.rpartition('::')[2]}"
    if kind == "concept":
        code = re.sub(r"concept scree::\S*?(\w+) =\s*", r"concept \1 = ", "".join(compound.find("initializer").itertext())).strip()
    else:
        bases = [short(words(base)) for base in compound.findall("basecompoundref") if "detail" not in words(base)]
        code = spaced(head + (f" : {', '.join(bases)}" if bases else ""))
    location = compound.find("location")
    return Declaration(location.get("file"), int(location.get("line")), kind, name, [code], texts_of(compound),
                       members=members_of(compound, folder), ids=[compound.get("id")])


def read(folder):
    """All declarations, in the order of their headers and lines. Overloads are one; those without a comment count for
    nothing beside one that has one."""
    found = {}
    for path in sorted(folder.glob("*.xml")):
        compound = xml.parse(path).getroot().find("compounddef")
        if compound is None or compound.get("prot", "public") != "public":
            continue
        kind, name, location = compound.get("kind"), words(compound.find("compoundname")), compound.find("location")
        if kind in ("class", "struct", "concept") and name.startswith("scree::") and location is not None:
            declaration = of_compound(compound, spaced(short(name)), folder)
            if "<" not in name or declaration.texts:
                found[location.get("file"), declaration.name] = declaration
        if kind != "namespace" or not name.startswith("scree") or "detail" in name.split("::"):
            continue
        for member in compound.iter("memberdef"):
            label, where = words(member.find("name")), member.find("location")
            if member.get("kind") not in KINDS or label.startswith(("operator", "@")) or member.get("prot") != "public":
                continue
            full = short(f"{name}::{label}")
            key = where.get("file"), full
            new = Declaration(key[0], int(where.get("line")), member.get("kind"), full, [code_of(member)], texts_of(member),
                              overloads=[member_of(member, folder)], ids=[member.get("id")])
            for value in member.iter("enumvalue"):
                if texts_of(value):
                    new.texts.append(f"{code(words(value.find('name')))}: " + " ".join(texts_of(value)))
            reference = member.find("type/ref")
            if reference is not None:
                new.type_of = reference.get("refid")
            old = found.get(key)
            if old is None or (new.texts and not old.texts):
                new.ids += old.ids if old else []
                new.overloads += old.overloads if old else []
                found[key] = new
            else:
                old.ids += new.ids
                old.overloads += new.overloads
                if new.texts or not old.texts:
                    old.codes += [code for code in new.codes if code not in old.codes]
                    old.texts += [text for text in new.texts if text not in old.texts]
    declarations = sorted(found.values(), key=lambda each: (each.header, each.line, each.name))
    by_id = {identity: each for each in declarations for identity in each.ids}
    for each in declarations:  # an object of a field or of a term is what its type is
        if each.kind == "variable" and not each.texts and each.type_of in by_id and by_id[each.type_of].texts:
            each.texts = [f"\ue002{each.type_of}\ue003{by_id[each.type_of].name}\ue004 as an object: {by_id[each.type_of].texts[0]}"]
    return declarations
