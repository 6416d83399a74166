# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""R7, R12: bad input, made from each program's own table of options (--options), and settings without effect."""
import dataclasses
import re

import programs
from tally import Tally

PROGRAMS = ("drum", "shear_box", "column_collapse", "inclined_flow")
LONGEST = 2  # s that a refusal may take


@dataclasses.dataclass
class Option:
    key: str
    default: str
    allowed: str  # as messages spell it, with the unit

    @property
    def section(self):
        return self.key.split(".")[0]

    @property
    def name(self):
        return self.key.split(".")[1]

    @property
    def range(self):
        """Lowest, highest, and whether the lowest itself is out of range; or nothing."""
        found = re.search(r"in ([\[(])(\S+), (\S+)\]", self.allowed)
        return found and (float(found[2]), float(found[3]), found[1] == "(")


def options_of(program):
    rows = [[cell.strip() for cell in line.strip("|\n").split(" | ")]
            for line in programs.run([program, "--options"]).out.splitlines()[2:]]
    return [Option(key, default, allowed + ("" if unit == "1" or allowed.startswith("a text") else " " + unit))
            for key, unit, default, allowed, _ in rows]


@dataclasses.dataclass
class Case:
    """One bad input and what its only message must hold."""
    what: str
    arguments: list = dataclasses.field(default_factory=list)
    text: bytes = None  # of the case file; None: there is none
    line: int = None  # of the fault in it
    holds: tuple = ()


def bad_values(option):
    """Values that an option must refuse."""
    if option.allowed.startswith("a number"):
        low, high, is_open = option.range
        yield from (("below its range", low if is_open else low - max(abs(low), 1e-3) * 1e-3),
                    ("above its range", high * (1 + 1e-6) if high else 1e-300), ("not a number", "nan"), ("infinite", "inf"),
                    ("infinite", "-inf"), ("too large for a number", "1e999"), ("of the wrong type", '"a text"'),
                    ("of the wrong type", "true"), ("of the wrong type", "[1]"), ("of the wrong type", "1979-05-27"))
    elif option.allowed.startswith("an integer"):
        low, high, _ = option.range
        yield from (("below its range", int(low) - 1), ("above its range", int(high) + 1), ("a broken number", 2.5),
                    ("not a number", "nan"), ("beyond 64 bits", "99999999999999999999"), ("of the wrong type", '"2"'))
    elif option.allowed.startswith("an array"):
        yield from (("of the wrong type", "1"), ("of the wrong type", '"a text"'), ("with a text", '[1, "a"]'),
                    ("with a nan", "[1, nan]"), ("with an array", "[[1]]"), ("below its range", "[-1, 1]"))
    elif option.allowed == "true or false":
        yield from (("of the wrong type", "1"), ("of the wrong type", '"true"'))
    elif option.allowed == "a text in quotes":
        yield from (("of the wrong type", "1"), ("of the wrong type", "[\"a\"]"))
    else:
        name = option.allowed.split('"')[1]
        yield from (("an unknown name", '"nonsense"'), ("a misspelt name", f'"{name[:-1]}"'), ("of the wrong type", "1"),
                    ("in capitals", f'"{name.upper()}"'))


def values_out_of_range(options):
    for k, option in enumerate(options):
        for what, value in bad_values(option):
            # What toml++ itself refuses, on the command line counts as a text.
            parsed = str(value) not in ("1e999", "99999999999999999999")
            holds = (option.key, "allowed: " + option.allowed)
            yield Case(f"{option.key} {what}: {value}, --set", ["--set", f"{option.key}={value}"], None, None, holds)
            yield Case(f"{option.key} {what}: {value}, file", [], f"# a case\n\n[{option.section}]\n{option.name} = {value}\n"
                       .encode(), 4, holds if parsed else ())


def unknown_names(options):
    keys = {option.key for option in options}
    for option in options:
        typo = option.key[:-1] if len(option.name) > 1 else option.key + "x"
        if typo not in keys:
            hint = (f"did you mean '{option.section}.",) if len(option.name) > 3 else ()
            yield Case(f"misspelt key {typo}, --set", ["--set", f"{typo}={option.default}"], None, None,
                       (typo, "unknown key", "allowed: ") + hint)
        other = next(o for o in options if o.section != option.section)
        if f"{other.section}.{option.name}" not in keys:
            yield Case(f"{option.key} in the section {other.section}", [], f"[{other.section}]\n{option.name} = 1\n".encode(), 2,
                       (f"{other.section}.{option.name}", "unknown key"))
    for section in sorted({option.section for option in options}):
        yield Case(f"misspelt section {section[:-1]}", [], f"[{section[:-1]}]\nx = 1\n".encode(), 1,
                   (section[:-1], "unknown section", f"did you mean '{section}'"))
        yield Case(f"a value in place of the section {section}", [], f"{section} = 1\n".encode(), 1, (section,))
        yield Case(f"section {section} twice", [], f"[{section}]\n[{section}]\n".encode(), 2)
    option = options[0]
    yield Case("a key twice", [], f"[{option.section}]\n{option.name} = {option.default}\n{option.name} = 1\n".encode(), 3)
    yield Case("a key outside of the sections", [], f"{option.name} = 1\n".encode(), 1, (f"did you mean '{option.key}'",))


GARBAGE = {
    "no value": b"[a]\nx =\n", "no equals sign": b"[a]\nx\n", "a text without end": b"[a]\nx = \"abc\n",
    "an array without end": b"[a]\nx = [1, 2\n", "a section without end": b"[a\n", "no TOML": b"radius: 0.035\n",
    "control characters": b"[a]\nx = \"\x01\x02\"\n", "no UTF-8": b"[a]\nx = \"\xff\xfe\"\n", "UTF-16": "[a]\nx = 1\n".encode("utf-16"),
    "zeros": bytes(4096), "an image": b"\x89PNG\r\n\x1a\n" + bytes(range(256)), "a program": b"\x7fELF" + bytes(range(256)),
    "a checkpoint": b"scree checkpoint 1\n" + bytes(512), "a deep key": b"a" + b".a" * 5000 + b" = 1\n",
    "a deep array": b"[a]\nx = " + b"[" * 5000 + b"]" * 5000 + b"\n", "a long line": b"x" * 1_000_000,
}


def garbage(context):
    for what, text in GARBAGE.items():
        yield Case(f"a case file with {what}", [], text)
    for k in range(context.pick(5, 20)):
        yield Case(f"a case file of random bytes ({k})", [], context.random.randbytes(200))


def command_lines(context, options):
    key, value = options[0].key, options[0].default
    missing = context.folder()
    yield Case("a case file that is missing", [missing], None, None, (str(missing), "No such file"))
    yield Case("a folder as case file", [context.work], None, None, (str(context.work), "Is a directory"))
    for what, arguments in {"an unknown flag": ["--sets", f"{key}={value}"], "--set without a value": ["--set"],
                            "two case files": ["a.toml", "b.toml"], "--force with a value": ["--force=maybe"]}.items():
        yield Case(what, arguments)
    for text in (key, key.replace(".", "="), f"={value}", "", f".{key}={value}", f"{key}.x={value}"):
        yield Case(f"--set '{text}'", ["--set", text], None, None)


# Pairs of legal values that contradict each other, and the key to blame.
CONTRADICTIONS = {
    "drum": ({"numerics.spacing": 0.0036}, {"geometry.fill_depth": 0.01}, {"material.d_large": 1e-4}, {"material.grain_density": 1000},
             {"material.mu_d": 0.1}, {"material.stiffness_factor": 1e-4}, {"output.profile_times": "[2, 1]"},
             {"output.profile_times": "[1, 1]"}, {"geometry.length": 1e-3, "numerics.dimension": 3}, {"numerics.spacing": 1e-9},
             {"numerics.spacing": 1e-7, "numerics.dimension": 3}),
    "shear_box": ({"geometry.d_large": 1e-3}, {"geometry.width": 0.00348}, {"numerics.spacing": 0.03}, {"output.compared": "[2, 1]"},
                  {"geometry.depth": 1e-3, "numerics.dimension": 3}),
    "column_collapse": ({"model.friction_at_speed": 0.1}, {"numerics.across": 1000, "numerics.dimension": 3,
                                                           "geometry.aspect": 30, "numerics.reach": 100}),
    "inclined_flow": ({"slope.angle": 10}, {"slope.angle": 50}, {"model.mu_s": 3}, {"model.mu_d": 0.1}),
}


def contradictions(name):
    for settings in CONTRADICTIONS[name]:
        arguments = [word for key, value in settings.items() for word in ("--set", f"{key}={value}")]
        blamed = ("slope.angle",) if name == "inclined_flow" else (next(iter(settings)),)
        yield Case(f"contradiction {settings}", arguments, None, None, blamed)


def fault_of(outcome, case, file):
    """What is wrong with the answer to a bad input; empty: nothing."""
    lines = [line for line in outcome.messages if line != "Run with --help for more information."]
    if outcome.code != 2:
        return f"exit code {outcome.code}"
    if len(lines) != 1 or outcome.out:
        return f"{len(lines)} messages: {outcome.err[:300]}{outcome.out[:300]}"
    if case.text is not None:
        place = f"{file}:{case.line}:" if case.line else f"{file}:"
        if not re.match(re.escape(place) + (r"\d+: " if case.line else r"\d+:\d+: "), lines[0]):
            return f"no place {place} in: {lines[0]}"
    elif case.arguments[0] == "--set" and case.holds and not lines[0].startswith(("--set: ", "default: ")):
        return f"no '--set:' in: {lines[0]}"
    if missing := [text for text in case.holds if text not in lines[0]]:
        return f"no {missing} in: {lines[0]}"
    return f"{outcome.seconds:.1f} s" if outcome.seconds > LONGEST else ""


def bad_input(context):
    """R7"""
    tally = Tally("R7", "bad input: one message with place, key and what is allowed, exit code 2, nothing left behind")
    output, file = context.folder(), context.folder().with_suffix(".toml")
    slowest = 0
    for name in PROGRAMS:
        program = context.program(name)
        if not program.is_file():
            continue
        options = options_of(program)
        cases = [*values_out_of_range(options), *unknown_names(options), *contradictions(name)]
        cases = cases[::context.pick(5, 1)] + [*garbage(context), *command_lines(context, options)]
        for case in cases:
            if case.text is not None:
                file.write_bytes(case.text)
            outcome = programs.run([program, *([file] if case.text is not None else []), "--output", output, *case.arguments],
                                   limit=30)
            fault = fault_of(outcome, case, file)
            if output.exists():
                fault += f", {output} is left behind"
                for left in output.iterdir():
                    left.unlink()
                output.rmdir()
            tally.check(not fault, f"{name}: {case.what}: {fault}")
            slowest = max(slowest, outcome.seconds)
    tally.note(f"slowest {1000 * slowest:.0f} ms")
    return tally


# Options changed where they do nothing. Each must be named by a note.
WITHOUT_EFFECT = {
    "drum": ({"geometry.length": 0.02}, {"geometry.ends": '"walled"'}, {"segregation.V": 1e-3}, {"segregation.D": 1e-7},
             {"numerics.volume_rate": 2, "numerics.volume_control": '"none"'},
             {"numerics.filter_period": 10, "numerics.stress_filter": '"none"'},
             {"segregation.chi_V": 0.2, "segregation.closure": '"constant"'},
             {"segregation.chi_D": 0.2, "segregation.closure": '"constant"'},
             {"segregation.scheme": '"hcsr"', "segregation.closure": '"none"'},
             {"segregation.flux": '"asymmetric"', "segregation.closure": '"none"'}),
    "shear_box": ({"geometry.depth": 0.06}, {"numerics.depth_boundary": '"walled"'}, {"numerics.seed": 2}, {"model.d_bar": 0.005},
                  {"time.strain_per_step": 0.1, "geometry.upright": "true"}),
}
NO_TIME = {"drum": ["--set", "time.duration=0", "--set", "numerics.spacing=3e-3"],
           "shear_box": ["--set", "time.periods=0", "--set", "numerics.spacing=0.1", "--set", "output.compared=[0]",
                         "--set", "output.reference_spacing=0.1"]}


def without_effect(context):
    """R12"""
    tally = Tally("R12", "a setting that does nothing in its case is named by a note; one that does something is not")
    for name, settings in WITHOUT_EFFECT.items():
        if not context.program(name).is_file():
            continue
        command = [context.program(name), "--quiet", *NO_TIME[name]]
        for changed in settings:
            arguments = [word for key, value in changed.items() for word in ("--set", f"{key}={value}")]
            outcome = programs.run([*command, "--output", context.folder(), *arguments])
            notes = [line for line in outcome.err.splitlines() if line.startswith("note: ") and "has no effect" in line]
            right = outcome.code == 0 and len(notes) == 1 and next(iter(changed)) in notes[0]
            tally.check(right, f"{name} {changed}: exit code {outcome.code}, {outcome.err}")
        outcome = programs.run([*command, "--output", context.folder()])
        tally.check(outcome.code == 0 and "has no effect" not in outcome.err, f"{name} as it is: {outcome.err}")
    return tally


MEASURES = {"R7": bad_input, "R12": without_effect}
