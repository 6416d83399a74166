# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""What workflows and container files name exists: scripts and their commands, presets, targets, labels, options, jobs, paths."""
import itertools
import json
import re
import shlex
import subprocess
import unittest
from pathlib import Path

try:
    import yaml
except ImportError:
    yaml = None

ROOT = Path(__file__).resolve().parents[2]
CMAKE = [path for name in ("CMakeLists.txt", "*.cmake") for folder in ("cmake", "examples", "src", "tests", "benchmarks")
         for path in sorted((ROOT / folder).rglob(name))] + [ROOT / "CMakeLists.txt"]
ENDS = {"&&", "||", ";", ">", "|"}
ACTIONS = {"actions/checkout", "actions/cache", "actions/upload-artifact", "actions/download-artifact"}


def commands(script):
    """The commands of a script, as lists of words."""
    script = re.sub(r"(^|\s)#.*", "", script.replace("\\\n", " "))
    for line in script.splitlines():
        lexer = shlex.shlex(line, posix=True, punctuation_chars="&|;>")
        lexer.whitespace_split = True
        command = []
        for word in lexer:
            if word in ENDS:
                yield command
                command = [] if word != ">" else ["to"]
            else:
                command.append(word)
        yield command


def variants(text, matrix):
    """A text with the values of each row of the matrix in the place of ${{ matrix.name }}."""
    rows = matrix.get("include") or [dict(zip(matrix, values)) for values in itertools.product(*matrix.values())]
    return {re.sub(r"\$\{\{ matrix\.(\w+) \}\}", lambda match: str(row[match[1]]), text) for row in rows} if "matrix." in text else {text}


class Repository:
    def __init__(self, root=ROOT):
        self.root = root
        self.cmake = "\n".join(path.read_text(encoding="utf8") for path in CMAKE)
        presets = json.loads((root / "CMakePresets.json").read_text(encoding="utf8"))
        self.configure = {each["name"] for each in presets["configurePresets"] if not each.get("hidden")}
        self.build = {each["name"] for each in presets["buildPresets"]}
        script = (root / "cmake/quickstart.sh").read_text(encoding="utf8")
        self.quickstart = {name.strip() for line in re.findall(r"^  ([a-z_| -]+)\)", script, re.MULTILINE) for name in line.split("|")}

    def has_target(self, name):
        if re.search(rf"add_(?:custom_target|executable|library)\({name}\b|scree_\w+\({name}\b", self.cmake):
            return True
        if name.startswith("test_"):
            return (self.root / "tests" / name[5:]).is_dir()
        if name.startswith("course_"):
            return (self.root / "examples/course" / f"{name[7:]}.cpp").exists()
        return (self.root / "examples" / name).is_dir() or name in ("all", "install")

    def has_label(self, name):
        return (self.root / "tests" / name).is_dir() or name == "benchmarks" or re.search(rf"LABELS \"?{name}\b", self.cmake) is not None

    def faults(self, command):
        """What a command names and the repository lacks."""
        if not command:
            return []
        name, words = command[0], command[1:]
        missing = []
        if name in ("bash", "sh", "python3") and words and not words[0].startswith("-"):
            if not (self.root / words[0]).is_file():
                missing.append(words[0])
            elif words[0] == "cmake/quickstart.sh" and words[1] not in self.quickstart:
                missing.append(f"quickstart.sh {words[1]}")
        if name in ("cmake", "ctest"):
            building = "--build" in words
            for word, value in zip(words, words[1:] + [""]):
                if word == "--preset" and value not in (self.build if building else self.configure):
                    missing.append(f"preset {value}")
                if word in ("--label-exclude", "--label-regex"):
                    missing += [f"label {label}" for label in re.findall(r"\w+", value) if not self.has_label(label)]
                if word in ("--build", "--test-dir") and value.startswith("build/") and value[6:] not in self.configure | {"kokkos"}:
                    missing.append(value)
                if match := re.match(r"-D(SCREE_\w+)=", word):
                    if not re.search(rf"\b{match[1]}\b", self.cmake):
                        missing.append(f"option {match[1]}")
            if "--target" in words:
                missing += [f"target {each}" for each in words[words.index("--target") + 1:] if not each.startswith("-") and not self.has_target(each)]
        return missing


@unittest.skipUnless(yaml, "PyYAML is missing")
class Workflows(unittest.TestCase):
    repository = Repository()

    def jobs(self):
        for path in sorted((ROOT / ".github/workflows").glob("*.yaml")):
            workflow = yaml.safe_load(path.read_text(encoding="utf8"))
            for name, job in workflow["jobs"].items():
                yield path.name, workflow, name, job

    def scripts(self):
        """(where, script) of all steps, for each row of a matrix."""
        for file, _, name, job in self.jobs():
            matrix = job.get("strategy", {}).get("matrix", {})
            for step in job["steps"]:
                for script in variants(step.get("run", ""), matrix):
                    yield f"{file}, {name}", re.sub(r"\$\{\{ [^}]* \}\}", "value", script)

    def test_mistakes_are_found(self):
        for script, missing in (("bash cmake/quick.sh test", ["cmake/quick.sh"]), ("bash cmake/quickstart.sh pakc", ["quickstart.sh pakc"]),
                                ("cmake --preset opnmp -DSCREE_WARNING=ON", ["preset opnmp", "option SCREE_WARNING"]),
                                ("ls && cmake --build build/openmp --target scree_tests test_nothing", ["target test_nothing"]),
                                ("ctest --test-dir build/other --label-exclude '^(programs|nothing)$'", ["build/other", "label nothing"])):
            self.assertEqual([fault for command in commands(script) for fault in self.repository.faults(command)], missing)

    def test_what_commands_name_exists(self):
        found = list(self.scripts())
        self.assertGreater(len([script for _, script in found if script]), 20)
        self.assertEqual([(where, fault) for where, script in found for command in commands(script)
                          for fault in self.repository.faults(command)], [])

    def test_commands_are_those_of_a_shell(self):
        for where, script in self.scripts():
            with self.subTest(where):
                done = subprocess.run(["bash", "-n"], input=script, text=True, capture_output=True, check=False)
                self.assertEqual(done.stderr, "")

    def test_jobs_steps_and_matrices_fit(self):
        for file, workflow, name, job in self.jobs():
            with self.subTest(f"{file}, {name}"):
                needs = job.get("needs", [])
                self.assertEqual(set([needs] if isinstance(needs, str) else needs) - set(workflow["jobs"]), set())
                matrix = job.get("strategy", {}).get("matrix", {})
                names = set(matrix.get("include", [{}])[0]) | set(matrix) - {"include"}
                self.assertEqual(set(re.findall(r"matrix\.(\w+)", json.dumps(job))) - names, set())
                for row in matrix.get("include", []):
                    self.assertEqual(set(row), names)
                for step in job["steps"]:
                    self.assertEqual(len({"run", "uses"} & set(step)), 1, step)
                    if "uses" in step:
                        self.assertRegex(step["uses"], rf"^({'|'.join(ACTIONS)})@v\d+$")

    def test_artifacts_that_are_fetched_are_made_and_where_scripts_leave_them(self):
        made, fetched, paths = set(), set(), []
        for file, _, _, job in self.jobs():
            for step in job["steps"]:
                if "upload-artifact" in step.get("uses", ""):
                    made.add((file, step["with"]["name"]))
                    paths.append(step["with"]["path"])
                if "download-artifact" in step.get("uses", ""):
                    fetched.add((file, step["with"]["name"]))
        self.assertEqual(fetched - made, set())
        sources = "".join((ROOT / path).read_text(encoding="utf8") for path in ("cmake/quickstart.sh", "cmake/packages.cmake", ".ci/run", "docs/CMakeLists.txt"))
        for path in paths:
            self.assertIn(re.sub(r"/(html|scree\*)$", "", path).removeprefix("build/openmp/"), sources, path)

    def test_the_pages_name_the_compilers_of_the_workflow(self):
        workflow = yaml.safe_load((ROOT / ".github/workflows/ci.yaml").read_text(encoding="utf8"))
        for row in workflow["jobs"]["compilers"]["strategy"]["matrix"]["include"]:
            self.assertIn(row["cxx"].replace("clang++", "clang"), row["packages"])


class Containers(unittest.TestCase):
    repository = Repository()

    def test_what_the_container_file_names_exists(self):
        text = re.sub(r"\\\n", " ", (ROOT / "cmake/Containerfile").read_text(encoding="utf8"))
        stages = re.findall(r"^FROM \S+ AS (\w+)", text, re.MULTILINE)
        self.assertEqual(set(re.findall(r"--from=(\w+)", text)) - set(stages), set())
        runs = re.findall(r"^RUN (.*)", text, re.MULTILINE)
        self.assertGreater(len(runs), 1)
        self.assertEqual([fault for run in runs for command in commands(run) for fault in self.repository.faults(command)], [])
        self.assertIn("packages", re.findall(r"COPY --from=build /scree/build/openmp/(\w+)/", text))

    def test_what_the_container_of_developers_names_exists(self):
        settings = json.loads((ROOT / ".devcontainer/devcontainer.json").read_text(encoding="utf8"))
        found = [settings[name] for name in ("onCreateCommand", "postCreateCommand")]
        self.assertEqual([fault for script in found for command in commands(script) for fault in self.repository.faults(command)], [])


if __name__ == "__main__":
    unittest.main()
