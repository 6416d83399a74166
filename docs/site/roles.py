# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A member that a class has because of its role is described once, at the concept of the role, in a list of its comment:

    ///   name(arguments)   what it does or returns

Where the class says nothing of it, the reference repeats the words of the concept."""
import re

CALL = re.compile(r"(\w+)(?:<[^<>]*>)?\(([^()]*)\)")
PARAMETERS = "Name, unit, range and meaning of each parameter, as a list. [All models](parameters.md)."


def arguments(text):
    """The number of arguments between two brackets."""
    text = re.sub(r"<[^<>]*>|\([^()]*\)|\{[^{}]*\}", "", text)
    return len([part for part in text.split(",") if part.strip() and part.strip() != "void"])


def list_of(comment):
    """[(name, number of arguments, text)] of the list in a comment; no number for what is no function."""
    found = []
    for line in comment.splitlines():
        line = re.sub(r"^ *///", "", line)
        entry = re.match(r"   (\S(?:.*?\S)?)(?:   *(\S.*))?$", line)
        if entry and (calls := CALL.findall(entry[1])):
            shared = [[name, arguments(inner), []] for name, inner in calls]
            found.append((shared, [entry[2] or ""]))
        elif found and line.startswith("     "):
            found[-1][1].append(line.strip())
        elif entry and re.fullmatch(r"\w+(, \w+)*", entry[1]) and entry[2]:  # a constant or a type
            found.append(([[name, None, []] for name in re.findall(r"\w+", entry[1])], [entry[2]]))
        elif entry:
            found.append(([], []))
    return [(name, count, " ".join(text).strip()) for shared, text in found for name, count, _ in shared if "".join(text).strip()]


def concepts(text):
    """(name, comment, code) of the concepts of a header."""
    comment, lines = [], text.splitlines()
    for number, line in enumerate(lines):
        if line.startswith("///"):
            comment.append(line)
        elif match := re.match(r"concept (\w+)", line):
            end = next((k for k in range(number + 1, len(lines)) if re.match(r"$|///|template|namespace|struct|class", lines[k])), len(lines))
            yield match[1], "\n".join(comment), "\n".join(lines[number:end])
        elif not line.startswith("template <"):
            comment = []


def read(include):
    """{concept: (names of the functions that it requires, its list)}."""
    found = {}
    for header in sorted(include.rglob("*.hpp")):
        for name, comment, code in concepts(header.read_text(encoding="utf8")):
            listed = list_of(comment)
            functions = {each for each, count, _ in listed if count is not None}
            required = {each for each in functions if re.search(rf"(\.|::|template ){each}\b", code)}
            if functions:
                found[name] = required or functions, listed
    return found


def text_for(member, names, roles):
    """(the text of a member, the concept that it is from) in the role that a class with members of these names has; None
    without one."""
    count = None
    if f"{member.name}(" in member.code:
        count = arguments(re.sub(r"^[^(]*\(|\)[^()]*$", "", member.code[member.code.index(member.name + "("):]))
    fitting = []
    for concept, (required, listed) in roles.items():
        text = next((text for name, number, text in listed if name == member.name and number == count), None)
        share = len(required & names) / len(required)
        if text and share > 0.5:
            fitting.append((share, len(required), concept, text))
    return max(fitting)[:1:-1] if fitting else None


def add(found, include):
    """Gives the members of classes that have no text that of their role."""
    roles = read(include)
    identity = {each.name: each.ids[0] for each in found if each.kind == "concept"}
    for each in found:
        names = {member.name for member in each.members}
        for member in each.members:
            if member.texts:
                continue
            if member.name == "parameters":
                member.texts = [PARAMETERS]
            elif role := text_for(member, names, roles):
                text, concept = role[0], role[1]
                text = re.sub(r"^(optional|static|between steps)[:,] ", "", text)
                member.texts = [f"{text[0].upper()}{text[1:].rstrip('.;')}. Part of the role \ue002{identity[concept]}\ue003{concept}\ue004."]
    return found
