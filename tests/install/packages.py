#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The packages of applications contain all that a run needs: packages.py BUILD_FOLDER; exit code 77 without dpkg-dev."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

GLIBC = re.compile(r"linux-vdso|/ld-linux|^lib(c|m|dl|rt|pthread|resolv|util)\.so")


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False, **options)
    assert done.returncode == 0, f"{command}: exit code {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def libraries(program, **environment):
    """(name, place) of what a program needs, its libraries included."""
    lines = run("ldd", program, env={"PATH": os.environ["PATH"], **environment}).splitlines()
    return [(line.split()[0], line.split("=> ")[1].split(" (")[0] if "=> " in line else line.split()[0]) for line in lines]


def check_runs(root, results, libraries_from):
    """The launcher below a root lists the application and runs a small case of it, with nothing of the environment and with the
    libraries of a folder."""
    clean = {"PATH": "/usr/bin:/bin", "OMP_NUM_THREADS": "1", "OMP_PROC_BIND": "false"}
    assert "column_collapse: cases in" in run(root / "bin/scree", env=clean)
    done = subprocess.run([root / "bin/scree", "no_such"], capture_output=True, env=clean, check=False)
    assert done.returncode == 1 and b"usage" in done.stdout
    case = root / "share/scree/column_collapse/column_collapse.toml"
    loaded = subprocess.run([root / "bin/scree", "column_collapse", "--version"], capture_output=True, text=True, check=True,
                            env={**clean, "LD_DEBUG": "libs"}).stderr
    folders = {Path(found).parent.resolve() for found in re.findall(r"calling init: (\S*lib(?:gomp|hdf5)\S*)", loaded)}
    assert folders and all(folder == libraries_from or libraries_from in folder.parents for folder in folders), folders
    run(root / "bin/scree", "column_collapse", case, "--output", results, "--quiet", "--set", "numerics.across=6", "--set",
        "geometry.aspect=0.5", "--set", "output.duration=1", env=clean)
    assert json.loads((results / "summary.json").read_text())["run_out"] > 0
    assert (results / "particles.vtkhdf").stat().st_size > 1000
    packed = sorted(each.name for each in (root / "lib/scree").iterdir() if each.is_file())
    made = results.with_name(f"{results.name}_made")  # files that two of the cases read
    made.mkdir()
    scripts = (("blender/vessel.py", "v", made / "v_blender.stl"), ("terrain/ground.py", made))
    for script, *words in scripts:
        if (root / "share/scree" / script).exists():
            run(sys.executable, "-B", root / "share/scree" / script, *words)
    for application in packed:
        files = (root / "share/scree" / application).glob("*.toml")
        cases = [file for file in files if not re.search(r"^\[+study", file.read_text(), re.MULTILINE)]
        assert cases, f"no case of {application}"
        for case in cases:
            preview = results.with_name(f"{results.name}_{case.stem}")
            run(root / "bin/scree", application, case, "--preview", "--quiet", "--output", preview, env=clean, cwd=made)
            assert (preview / "preview.html").stat().st_size > 10000
    if subprocess.run([sys.executable, "-c", "import h5py, matplotlib"], capture_output=True, check=False).returncode == 0:
        python = {**clean, "PATH": f"{Path(sys.executable).parent}:{clean['PATH']}"}
        run(root / "bin/scree", "view", results, "--page", results / "run.html", env=python)
        run(sys.executable, "-B", root / "share/scree/column_collapse/plot.py", results)
        assert (results / "run.html").stat().st_size > 10000 and (results / "collapse.png").stat().st_size > 10000
        assert not list((root / "share").rglob("__pycache__"))
    return packed


def main():
    if not shutil.which("dpkg-shlibdeps") or not shutil.which("file"):
        print("dpkg-shlibdeps or file is missing; on Debian: apt-get install dpkg-dev file")
        sys.exit(77)
    build = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run("cpack", "--config", build / "CPackConfig.cmake", "-B", folder, cwd=folder)
        [deb], [archive] = folder.glob("*.deb"), folder.glob("*.tar.xz")

        needs = re.findall(r"([\w.+-]+)(?: \([^)]*\))?(?:, |$)", run("dpkg-deb", "--field", deb, "Depends").strip())
        static = (build / "CMakeCache.txt").read_text(encoding="utf8").count("SCREE_STATIC_HDF5_LINKS:INTERNAL=1")
        if static:  # names that Debian 12, 13 and Ubuntu 24.04 share
            assert {"libc6", "libgomp1"} <= set(needs) <= {"libc6", "libgcc-s1", "libgomp1", "libstdc++6"}, needs
        else:
            assert {"libc6", "libgomp1"} <= set(needs) and any(each.startswith("libhdf5") for each in needs), needs
        run("dpkg-deb", "--extract", deb, folder / "deb")
        program = folder / "deb/usr/lib/scree/column_collapse"
        elsewhere = [each for each in libraries(program) if not each[1].startswith(("/lib", "/usr/lib", "linux-vdso"))]
        assert not elsewhere, f"not libraries of the system: {elsewhere}"
        assert not any("libkokkos" in library or "libfmt" in library for library, _ in libraries(program))
        packed = check_runs(folder / "deb/usr", folder / "of_deb", Path("/usr/lib"))
        licences = {each.name for each in (folder / "deb/usr/share/doc/scree/licences").iterdir()}
        assert {"libeigen3-dev", "libcli11-dev", "libtomlplusplus-dev"} <= licences, licences
        assert not static or {"libhdf5-dev", "libaec-dev", "zlib1g-dev"} <= licences, licences

        run("tar", "--extract", "--file", archive, "--directory", folder)
        [root] = folder.glob("scree-*-Linux-*[!z]")
        brought = root / "lib/scree/libraries"
        of_system = [each for each in libraries(root / "lib/scree/column_collapse", LD_LIBRARY_PATH=str(brought))
                     if not GLIBC.search(each[0]) and not each[1].startswith(str(brought))]
        assert not of_system, f"the archive does not bring {of_system}"
        assert len(list((root / "share/doc/scree/licences").iterdir())) > 3
        assert check_runs(root, folder / "of_archive", brought.resolve()) == packed
        assert (folder / "of_archive/history.csv").read_text() == (folder / "of_deb/history.csv").read_text()
    print(f"the packages run without the repository: {', '.join(packed)}")


if __name__ == "__main__":
    main()
