# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A table of all fields of particles and bodies, from their declarations: name, unit, value, what computes it, may it be set."""
import re
from collections import defaultdict

VALUES = {"Scalar": "number", "Integer": "integer", "Vector": "vector of dim", "Tensor": "dim x dim", "Axial": "dim (dim - 1)/2",
          "Symmetric3": "symmetric 3 x 3", "Symmetric": "symmetric dim x dim", "SymmetricOperator": "on symmetric tensors",
          "PerSpecies": "one for each species", "Labelled": "",
          "RigidVector": "vector of dim", "RigidTurn": "1 or 3 components"}
FIELD = re.compile(r"^struct (\w+) : (?:\w+::)*(\w+)<(?:\w+, )?\"([^\"]*)\",\s*\"([^\"]*)\">\s*\{", re.MULTILINE)
OBJECT = re.compile(r"^inline constexpr (\w+)(?:<[^>]*>)? (\w+)\{\}", re.MULTILINE)


def declared(include):
    """{type: (kind, name, unit, object, header)} of all fields of the headers."""
    found, objects = {}, {}
    for header in sorted(include.rglob("*.hpp")):
        text = header.read_text(encoding="utf8")
        objects.update({type_: name for type_, name in OBJECT.findall(text)})
        for type_, kind, name, unit in FIELD.findall(text):
            found[type_] = kind, name, unit, str(header.relative_to(include))
    return {type_: (*rest[:3], objects.get(type_, ""), rest[3]) for type_, rest in found.items()}


def sources(include):
    """{type: {how: [(class, header)]}}: what writes or adds to a field, whose history it is, what gives it at the start."""
    found, objects = defaultdict(lambda: defaultdict(list)), {}
    texts = {str(header.relative_to(include)): header.read_text(encoding="utf8") for header in sorted(include.rglob("*.hpp"))}
    for text in texts.values():
        objects.update({name: type_ for type_, name in OBJECT.findall(text)})
    for header, text in texts.items():
        places = [(match, match[1], re.findall(r"\w+", match[2])) for match in
                  re.finditer(r"using (writes|adds|history|rate) = ([^;]*);", text)]
        places += [(match, "start", [objects.get(match[1])]) for match in
                   re.finditer(r"\b(?:from_host|fill)\((?:fields::)?(\w+),", text)]
        places += [(match, "kept", [match[1]]) for match in re.finditer(r"^  Column<P, (\w+)> ", text, re.MULTILINE)]
        for match, how, types in places:
            classes = re.findall(r"^(?:struct|class) (\w+)", text[:match.start()], re.MULTILINE)
            place = (classes[-1] if classes else "", header)
            for type_ in types[:1] if how == "rate" else types:
                if place not in found[type_][how]:
                    found[type_][how].append(place)
    return found


def write(include, out, declarations):
    """Writes the page; `declarations` are those of the headers, with texts."""
    by_name = {each.name.rpartition("::")[2]: each for each in reversed(declarations) if each.kind in ("class", "struct")}
    all_of = {type_: rest for type_, rest in declared(include).items() if type_ in by_name}  # without those of `detail`
    rates = {type_: re.match(r"using rate = (\w+)", member.code)[1] for type_ in all_of
             for member in by_name[type_].members if member.name == "rate"}
    found = sources(include)
    for type_, rate in rates.items():  # a law that integrates its history gives its rate, too
        found[rate]["writes"] += found[type_]["history"]
    lines = ["---", "hide: [toc]", "---", "", "# Fields", "", f"The {len(all_of)} fields that the headers declare. A program names a field by its object, as in "
             "`solver.set(fields::velocity, ...)`, and results have it under its name. Particles carry the fields that the formulation and its "
             "observers name, and no others. Unit 1: none.", "",
             "`set()` gives a field a value for each particle, before a run or between steps. A field that evolves goes on from this value. "
             "A field that a pass computes is overwritten when the pass runs next. A field that passes read and that nothing computes must be set, "
             "zeros too, if they are meant, unless the last column says that it may stay zero.", "",
             "| object; name, unit; value | what it is | computed by | may it be set |", "|---|---|---|---|"]
    for type_, (kind, name, unit, object_, _) in sorted(all_of.items(), key=lambda item: item[1][1].lower()):
        each = by_name[type_]
        passes = [*found[type_]["writes"], *found[type_]["adds"]]
        if type_ not in rates and not passes and not found[type_]["history"]:
            passes = found[type_]["kept"]  # by code that takes its values as a whole
        by = {f"[{class_}]({by_name[class_].page})" if class_ in by_name else f"`{header.removeprefix('scree/')}`"
              for class_, header in [*passes, *found[type_]["history"]]}
        if type_ in rates:
            rate = rates[type_]
            given = f"yes; it evolves by [{all_of[rate][1]}]({by_name[rate].page})"
        elif passes:
            given = "overwritten where it is computed"
        elif found[type_]["history"]:
            given = "yes; the law changes it"
        elif found[type_]["start"]:
            given = "yes; the solver gives it at the start"
        else:
            given = "yes"
        members = {member.name for member in each.members}
        given += "; above 0" if "above_zero" in members else ""
        given += "; may stay zero" if "may_stay_zero" in members else ""
        label = f"`fields::{object_}`" if object_ else f"`{type_}`"
        lines.append(f"| [{label}]({each.page})<br>{'<br>'.join(filter(None, (f'{name}, {unit}', VALUES[kind])))} | {' '.join(each.texts[:1])} | "
                     f"{', '.join(sorted(by))} | {given} |")
    out.write_text(re.sub("\ue002.*?\ue003(.*?)\ue004", r"\1", "\n".join(lines)) + "\n", encoding="utf8")
