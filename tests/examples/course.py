#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Runs a program of the course with small numbers and checks the physics of what it writes: course.py PROGRAM.

The function named after the program (without course_) holds the checks. Exit code 0 if all hold."""
import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

try:
    import h5py
except ImportError:
    SYSTEM = "/usr/bin/python3"  # which may have the module when another Python comes first
    if sys.executable != SYSTEM and os.access(SYSTEM, os.X_OK):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    h5py = None
    print("there is no h5py: particles.vtkhdf and checkpoint.h5 are not read")

PROGRAM = pathlib.Path(sys.argv[1]).resolve()


def start(folder, *arguments):
    return subprocess.Popen([PROGRAM, *map(str, arguments)], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


def run(folder, *arguments, code=0):
    process = start(folder, *arguments)
    output, _ = process.communicate()
    check(process.returncode == code, f"exit code {process.returncode}\n{output}")
    return output


def check(holds, text):
    print(("" if holds else "FAILED: ") + text)
    if not holds:
        raise SystemExit(1)


def within(value, low, high, name):
    check(low <= value <= high, f"{name}: {value:.5g}, wanted {low:.5g} to {high:.5g}")


def table(folder, name):
    """The columns of a table by the names in its header, without units."""
    with open(folder / name, encoding="utf8") as file:
        rows = list(csv.reader(file))
    names = [cell.split(" [")[0] for cell in rows[0]]
    return {n: [float(row[k]) for row in rows[1:]] for k, n in enumerate(names)}


def mean(values):
    return sum(values) / len(values)


def frames(folder, number):
    """That particles.vtkhdf has this number of frames."""
    if h5py is None:
        return
    with h5py.File(folder / "particles.vtkhdf") as file:
        check(file["VTKHDF/Steps"].attrs["NSteps"] == number, f"{number} frames")


def program_01_first_steps(folder):
    printed = run(folder, 0.6)
    heap = table(folder, "heap.csv")
    force = heap["force on the walls over weight"]
    check(f"after 0.6 s the walls bear {force[-1]:.3f} of the weight of the sand" in printed, f"it prints {printed}")
    check(all(f == 0 for f in force[:10]), "no force as long as the ball falls")
    within(max(force), 1.2, 10, "force at the impact over weight")
    within(mean(force[-20:]), 0.97, 1.03, "force at the end over weight")
    below = mean(heap["pressure below the heap"][-20:])
    # Sand at rest bears half to all of the vertical stress across, so that the mean is 0.75 to 1 of it.
    within(below, 430, 640, "pressure below the heap, Pa; rho g times its depth, 39 to 42 mm, is 575 to 620 Pa")
    frames(folder, len(force))


def program_02_column_collapse(folder):
    run(folder, 10, 5)
    front = table(folder, "run_out.csv")
    within(front["run-out"][-1], 2.4, 3.6, "run-out, of experiments in channels")
    within(front["summit"][-1], 0.7, 1.3, "summit in widths")
    within(front["speed"][-1], 0, 0.05, "speed at the end")
    frames(folder, 51)


def program_03_layered_materials(folder):
    ways = {}
    for friction, duration in ((0.1, 0.3), (0.6, 0.3)):
        run(folder, friction, duration)
        layers = table(folder, "layers.csv")
        for name, wanted in (("weak layer", 5.6), ("sand", 19.2), ("fill", 17.6)):
            mass = layers[f"mass of the {name}"]
            within(mass[0], wanted * (1 - 1e-12), wanted * (1 + 1e-12), f"mass of the {name}")
            check(all(m == mass[0] for m in mass), "which stays as it is")
        ways[friction] = layers["way of the weak layer"][-1]
        frames(folder, 51)
    within(ways[0.1], 0.02, 0.06, "way of a weak layer in 0.3 s")
    within(ways[0.6], 0, 0.005, "of a strong one")


def program_04_gate(folder):
    run(folder, 0.05, 0.4)
    gate = table(folder, "gate.csv")
    for force, rest, front, t in zip(gate["force on the gate"], gate["force at rest"], gate["front"], gate["time"]):
        if t < 0.05:
            within(force / rest, 0.95, 1.02, f"force on the gate over that at rest at {t:.3f} s")
            within(front, 0.095, 0.1, "front behind the gate")
    check(gate["force on the gate"][-1] == 0, "no force on the open gate")
    within(gate["front"][-1], 0.2, 0.45, "front after the gate is open")
    frames(folder, 61)


def program_05_own_law(folder):
    for ratio, low, high in ((0.5, 0.3, 3), (2, -0.05, 0.1)):
        run(folder, ratio, 0.5)
        cut = table(folder, "cut.csv")
        within(cut["advance of the front"][-1], low, high, f"advance of the front at {ratio} of the critical strength")
        within(max(cut["largest stress over strength"]), 0.3, 1 + 1e-9, "largest stress over strength")
    frames(folder, 41)


def program_06_own_term(folder):
    run(folder)
    fall = table(folder, "speed.csv")
    for speed, exact, t in list(zip(fall["speed"], fall["exact speed"], fall["time"]))[1:]:
        if t < 0.45:  # it lands after 0.5 s
            within(speed / exact, 0.999, 1.001, f"speed over the exact one at {t:.2f} s")
    within(fall["speed"][-1], -0.01, 0.01, "speed after landing")
    within(fall["centre"][-1], 0.005, 0.02, "height of the heap's centre")
    frames(folder, 61)


def program_07_own_wall(folder):
    run(folder, 0.3)
    belt = table(folder, "belt.csv")
    for u, wanted, t in zip(belt["mean velocity"], belt["velocity by friction"], belt["time"]):
        within(u, wanted - 0.03, wanted + 0.03, f"mean velocity at {t:.3f} s")
    frames(folder, 51)


def program_08_restart(folder):
    names = ("centre.csv", "checkpoint.h5")
    whole, parts, killed = (folder / name for name in ("whole", "parts", "killed"))
    for path in (whole, parts, killed):
        path.mkdir()
    run(whole, 0.4)
    run(parts, 0.2)
    run(parts, 0.4)
    process = start(killed, 0.4)
    while not (killed / "centre.csv").exists():
        time.sleep(0.01)
    time.sleep(0.1)
    process.send_signal(signal.SIGTERM)
    process.communicate()
    check(process.returncode == 128 + signal.SIGTERM, "a signal stops the run with its exit code")
    check((killed / "checkpoint.h5").exists(), "and leaves a checkpoint")
    run(killed, 0.4)
    for other in (parts, killed):
        check((whole / "centre.csv").read_bytes() == (other / "centre.csv").read_bytes(), f"{other.name}: the same table")
        same_state(whole, other)
        frames(other, 9)
    motion = table(whole, "centre.csv")["centre"]
    within(max(motion) - min(motion), 0.01, 0.03, "path of the sand in the shaken box")


def same_state(one, other):
    if h5py is None:
        return
    with h5py.File(one / "checkpoint.h5") as a, h5py.File(other / "checkpoint.h5") as b:
        for name in ("position", "velocity", "stress"):
            key = f"arrays/material/{name}"
            check(a[key][()].tobytes() == b[key][()].tobytes(), f"{other.name}: {name} with the same bits")


def program_09_three_dimensions(folder):
    run(folder, 6, 4)
    heap = table(folder, "heap.csv")
    within(heap["run-out"][-1], 0.8, 1.7, "run-out in radii")
    within(max(heap["off the axis"]), 0, 0.01, "distance of the centre from the axis in radii")
    within(heap["height of the centre"][-1], 0.1, 0.25, "height of the centre in radii")
    frames(folder, 41)


def program_10_float_on_gpu(folder):
    output = run(folder, 10, 0.4)
    check("particle-steps/s" in output, output.strip())
    drum = table(folder, "slope.csv")
    within(drum["slope"][0], -0.01, 0.01, "slope at the start")
    within(mean(drum["slope"][-15:]), drum["angle of friction"][0], 38, "slope of the flowing sand")
    frames(folder, 41)


def program_11_own_physics(folder):
    run(folder, 1, 1)
    rest = table(folder, "tank.csv")
    ratio = mean(rest["pressure on the floor"][25:]) / rest["rho g depth"][0]
    within(ratio, 0.995, 1.005, "pressure on the floor over rho g depth, from 0.5 to 1 s")
    run(folder, 0.3)
    dam = table(folder, "tank.csv")
    within(max(dam["front"]), 0.48, 0.52, "farthest front: the far wall of the tank")
    speeds = [(b - a) / (dam["time"][1]) for a, b in zip(dam["front"], dam["front"][1:])]
    within(max(speeds), 1, 2 * (9.81 * 0.2) ** 0.5, "speed of the front, at most 2 sqrt(g depth)")
    frames(folder, 51)


def program_12_silo(folder):
    slot, rho, g, spacing = 0.03, 1500, 9.81, 0.003
    run(folder, slot, 0.45)
    t = table(folder, "silo.csv")
    start = t["mass in"][0]
    check(all(abs(i + o - start) < 1e-9 * start for i, o in zip(t["mass in"], t["mass out"])), "mass in + mass out is that at the start")
    check(all(abs(o - n * rho * spacing**2) < 1e-9 * start for o, n in zip(t["mass out"], t["removed"])), "mass out is that of the removed")
    check(all(o == 0 for time, o in zip(t["time"], t["mass out"]) if time <= 0.1), "nothing leaves while the gate is closed")

    def rate(a, b):
        of = dict(zip((round(time, 6) for time in t["time"]), t["mass out"]))
        return (of[b] - of[a]) / (b - a)

    within(rate(0.34, 0.44) / rate(0.22, 0.32), 0.9, 1.1, "later rate over earlier rate")
    within(rate(0.22, 0.44) / (rho * g**0.5 * slot**1.5), 0.7, 1.3, "rate over rho sqrt(g) width^(3/2) (Beverloo)")


def program_13_own_vessel(folder):
    script = pathlib.Path(__file__).parents[2] / "examples/course/vessel.py"
    subprocess.run([sys.executable, script, folder / "vessel.stl"], check=True)
    output = run(folder, "vessel.stl", 0.2, 5, 0.2)
    check("384 triangles in 1 shells, 1 of them closed" in output, output.splitlines()[0])
    vessel = table(folder, "vessel.csv")
    within(vessel["mass"][0], 0.2 * (1 - 1e-12), 0.2 * (1 + 1e-12), "mass of the sand")
    check(all(m == vessel["mass"][0] for m in vessel["mass"]), "which stays as it is")
    within(mean(vessel["force on the vessel over weight"][-10:]), 0.97, 1.03, "force on the vessel over the weight")
    within(vessel["speed"][-1], 0, 0.02, "speed at the end")
    frames(folder, 31)


def program_14_wheel(folder):
    run(folder, 3, 0.6)
    wheel = table(folder, "wheel.csv")
    within(wheel["way"][-1], 0.03, 0.06, "way of the axle in 0.6 s")
    within(wheel["sinkage"][-1], 0.015, 0.03, "sinkage")
    within(mean(wheel["force over weight"][-30:]), 0.9, 1.15, "force of the grains over the weight")
    check(all(moment > 0 for moment in wheel["moment"][-30:]), "the grains resist the turning")
    frames(folder, 61)


def program_15_stone(folder):
    run(folder, 2.5, 0.5)
    first, second = table(folder / "stones", "first.csv"), table(folder / "stones", "second.csv")
    late = max(k for k, u in enumerate(second["velocity x"][:40]) if u > first["velocity x"][k] + 1.4)  # before they meet
    time, u = first["time"], first["velocity x"]
    begin = next(k for k, t in enumerate(time) if t > 0.01)
    within((u[begin] - u[late]) / (time[late] - time[begin]) / (0.3 * 9.81), 0.97, 1.03, "deceleration over friction times g")
    before = u[late] + second["velocity x"][late]
    gap = [b - a for a, b in zip(second["position x"], first["position x"])]
    within(min(gap), 0.0985, 0.1, "least distance of the stones, which are 0.1 m long")
    check(u[late + 8] > u[late] and second["velocity x"][late + 8] < second["velocity x"][late], "the second pushes the first")
    check(before > 0, "both move towards the sand")
    within(first["velocity x"][-1], -0.1, 0.4, "speed of the first in the sand")
    within(min(first["position z"] + second["position z"]), 0.029, 0.03, "height of the stones on the floor")
    frames(folder, 41)


def program_16_several_ranks(folder):
    lines = {}
    for ranks in (1, 2, 3):
        lines[ranks] = run(folder, ranks, 0.1).splitlines()[-1]
        print(lines[ranks])
        found = table(folder, "shares.csv")
        check(all(all_ranks >= one for one, all_ranks in zip(found["speed of rank 0"], found["speed"])),
              "no rank is faster than the whole")
        within(mean(found["share"]), 0.6 / ranks, 1.6 / ranks, f"share of the first of {ranks} ranks")
        within(max(found["speed"]), 0.3, 1.5, "speed of the column that falls, m/s")
    check(len(set(lines.values())) == 1, "the same state on 1, 2 and 3 ranks")
    frames(folder, 6)


def program_17_valve(folder):
    wanted = 1.5
    run(folder, wanted, 0.35)
    valve = table(folder, "valve.csv")
    out, way = valve["mass out"], valve["way of the slide"]
    check(all(m == 0 for m, t in zip(out, valve["time"]) if t <= 0.1), "nothing leaves before the valve opens")
    within(max(way), 0.039, 0.042, "way of the slide that opens the slot of 30 mm, m")
    within(min(way[-5:]), -0.002, 0.001, "way of the slide at the end, m")
    # The slide needs 40 ms to close, and what is below it falls on; the silo lets through 26 kg/(m s).
    within(out[-1] / wanted, 1, 1.8, "mass out over the wanted one")
    within(out[-1] - out[-6], 0, 0.02, "mass that leaves in the last 50 ms, kg/m")
    frames(folder, 51)


def main():
    name = PROGRAM.name.replace("course_", "program_")
    if name not in globals():
        raise SystemExit(f"{__file__} has no check for {PROGRAM.name}: add {name}()")
    with tempfile.TemporaryDirectory() as folder:
        globals()[name](pathlib.Path(folder))


main()
