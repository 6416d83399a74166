# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A table of the parameters of all models, from their declarations `parameters()` in the headers."""
import re

TEXT = r'"((?:[^"\\]|\\.|"\s*")*)"'
ENTRY = re.compile(rf"parameter\(\s*{TEXT},\s*&[\w:<>]*?(\w+),\s*{TEXT},\s*{TEXT},\s*"
                   r"((?:allowed::\w+|ParameterRange)\s*[({](?:[^()\"]|\"[^\"]*\"|\([^()]*\))*?[)}])\s*\)", re.DOTALL)
SENTENCES = {"above": "above {0}", "above 2": "above {0}, at most {1}", "at_least": "{0} or more", "finite": "finite",
             "above_or_infinite": "above {0}, or infinite", "at_least_or_infinite": "{0} or more, or infinite",
             "from_to 2": "{0} to {1}", "between 2": "above {0}, below {1}"}


VECTOR = r"\{[^}]*\}|Vec<\w+, double>::Zero\(\)"


class Unreadable(Exception):
    pass


def joined(text):
    """Adjacent string literals are one."""
    return re.sub(r'"\s*"', "", text)


def of_vector(default):
    """The initialiser of a vector as an array of a case file; that of a number as it is."""
    if default.startswith("Vec<"):
        return "0 each"
    return f"[{default[1:-1]}]" if default.startswith("{") else default


def in_words(allowed):
    """A range as a reader wants it: above 0; 0 to 1; the words of the declaration, if it has any."""
    words = re.search(TEXT, allowed, re.DOTALL)
    if words:
        return joined(words[1])
    name, arguments = re.match(r"(?:allowed::)?(\w+)\s*[({](.*)[)}]$", allowed, re.DOTALL).groups()
    numbers = [each.strip() for each in arguments.split(",") if each.strip()]
    sentence = SENTENCES.get(f"{name} {len(numbers)}", SENTENCES.get(name))
    if sentence is None:
        raise Unreadable(f"no words for the range {allowed}")
    return sentence.format(*numbers)


def of_header(text):
    """(model, name, unit, default, allowed, meaning) of each parameter of a header."""
    code = re.sub(r"//.*", "", text)
    for block in re.finditer(r"^( *)static constexpr auto parameters\(\) \{(.*?)\n\1\}", code, re.DOTALL | re.MULTILINE):
        declaration = list(re.finditer(r"^(?:struct|class) (\w+)", code[:block.start()], re.MULTILINE))[-1]
        model, body = declaration[1], code[declaration.start():]
        entries = list(ENTRY.finditer(block[2]))
        if len(entries) != len(re.findall(r"\bparameter\(", block[2])):
            raise Unreadable(f"parameters() of {model} has a declaration that the table of the site does not understand")
        for name, member, unit, meaning, allowed in (entry.groups() for entry in entries):
            default = re.search(rf"\b(?:double|int)\b[^;(]*?\b{member}\s*=\s*({VECTOR}|[^;,]+)[;,]", body)
            yield model, joined(name), unit, of_vector(default[1].strip()) if default else "", in_words(allowed), joined(meaning)


def write(include, out, page_of):
    """Writes the page; `page_of` gives the page of the reference for a name."""
    lines = ["# Parameters of models", "", "Every model declares its parameters with unit, range and meaning; `check()` refuses "
             "other values before a run. A default that is empty or 0 outside of the range must be set. Unit 1: none.", ""]
    count = 0
    for header in sorted(include.rglob("*.hpp")):
        last = None
        for model, name, unit, default, allowed, meaning in of_header(header.read_text(encoding="utf8")):
            if model != last:
                link = f'[`{model}`]({page_of[model]})' if model in page_of else f"`{model}`"
                lines += ["", f"## {model}", "", f"{link}, `{header.relative_to(include)}`", "",
                          "| parameter | unit | default | allowed | meaning |", "|---|---|---|---|---|"]
                last = model
            meaning = re.sub(r"([_*|])", r"\\\1", meaning)
            lines.append(f"| `{name}` | {unit} | {default} | {allowed} | {meaning} |")
            count += 1
    lines[2] = lines[2].replace("Every model declares its parameters", f"Every model declares its parameters, {count} in all,")
    out.write_text("\n".join(lines) + "\n", encoding="utf8")
