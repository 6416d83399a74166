#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Means and standard errors over the seeds of what drum_reference wrote: evaluate.py RESULTS --output DIR [--from S] [--map S]"""

import argparse
import csv
from pathlib import Path

import numpy as np

FIELDS = 7  # of Maps, maps.hpp
MM = 1e3
VOLUME = {0: np.pi / 6 * 0.5e-3**3, 1: np.pi / 6 * 0.25e-3**3}  # of a large and of a small grain


class Run:
    """The files of one run of drum_reference."""

    def __init__(self, folder):
        about = dict(line.split(" ", 1) for line in (folder / "about.txt").read_text(encoding="utf8").splitlines())
        self.replicas = [name.split(":")[0] for name in about["replicas"].split()]
        self.radius, self.length = float(about["radius"]), float(about["length"])
        self.omega = float(about["rpm"]) * 2 * np.pi / 60
        fine, coarse = (int(n) for n in about["across"].split())
        with open(folder / "windows.csv", encoding="utf8") as file:
            self.windows = [tuple(float(x) for x in row) for row in list(csv.reader(file))[1:]]
        n = len(self.replicas)
        windows = np.fromfile(folder / "windows.f32", np.float32).reshape(-1, n, FIELDS, fine, fine)
        self.fields = windows[: len(self.windows)].astype(float)
        self.windows = self.windows[: len(self.fields)]
        self.frames = np.fromfile(folder / "frames.f32", np.float32).reshape(-1, n, 2, coarse, coarse).astype(float)

    def seeds(self, case):
        return [k for k, name in enumerate(self.replicas) if name == case]

    def mean(self, replica, start, end):
        """Fields of a replica, averaged over the windows from a time to another one."""
        found = [(w[2], f[replica]) for w, f in zip(self.windows, self.fields) if w[0] > start - 0.05 and w[1] < end + 0.05]
        if not found:
            raise SystemExit(f"no window lies between {start} and {end} s")
        return sum(n * f for n, f in found) / sum(n for n, f in found)


def coordinates(across, cell):
    along = (np.arange(across) - across / 2 + 0.5) * cell
    return np.meshgrid(along, along)  # x, z of [z, x]


class Surface:
    """The line through the places of the columns within half a radius where the packing falls to half of 0.6."""

    def __init__(self, fields, run):
        self.cell = 0.5e-3
        self.x, self.z = coordinates(fields.shape[-1], self.cell)
        self.solid = fields[0] + fields[1]
        self.packing = self.solid / (self.cell**2 * run.length)
        points = []
        for column in np.flatnonzero(np.abs(self.x[0]) < run.radius / 2):
            phi = self.packing[:, column]
            top = np.flatnonzero(phi > 0.3)
            if not len(top) or top[-1] + 1 >= len(phi):
                continue
            k = top[-1]
            part = (phi[k] - 0.3) / (phi[k] - phi[k + 1])
            points.append((self.x[0, column], self.z[k, 0] + part * self.cell))
        slope, at_axis = np.polyfit(*np.array(points).T, 1)
        self.angle = -np.arctan(slope)  # by which it descends to the right
        self.height = at_axis * np.cos(self.angle)
        self.bed_depth = run.radius + self.height
        sine, cosine = np.sin(self.angle), np.cos(self.angle)
        self.s = cosine * self.x - sine * self.z  # downhill
        self.depth = self.height - (sine * self.x + cosine * self.z)
        self.scatter = np.std([z - slope * x - at_axis for x, z in points])


def binned(surface, fields, run, width=0.5e-3):
    """Sums of the fields at mid-chord in bins of the depth; a cell counts for the two bins next to its centre."""
    near = (np.abs(surface.s) < 0.1 * run.radius) & (np.hypot(surface.x, surface.z) < run.radius)
    bins = int(surface.bed_depth / width) + 3
    at = surface.depth[near] / width + 1.5  # in bins, whose middles are at -1.5, -0.5, 0.5 ... widths below the surface
    left = np.floor(at).astype(int)
    part = at - left
    sums = np.zeros((len(fields) + 1, bins + 2))
    values = [f[near] for f in fields] + [np.full(near.sum(), surface.cell**2 * run.length)]
    for shift, weight in ((0, 1 - part), (1, part)):
        inside = (left + shift >= 0) & (left + shift < bins)
        for row, value in zip(sums, values):
            np.add.at(row, (left + shift)[inside], (weight * value)[inside])
    depths = (np.arange(bins + 2) - 1.5) * width
    return depths, sums


def profile(fields, run):
    """Mid-chord of one replica, one row per depth, and the numbers of its surface."""
    surface = Surface(fields, run)
    sine, cosine = np.sin(surface.angle), np.cos(surface.angle)
    depths, sums = binned(surface, fields, run)
    solid = sums[0] + sums[1]
    with np.errstate(invalid="ignore", divide="ignore"):
        along = cosine * (sums[2] + sums[3]) - sine * (sums[4] + sums[5])
        rows = {
            "velocity": along / solid,
            "velocity_large": (cosine * sums[2] - sine * sums[4]) / sums[0],
            "velocity_small": (cosine * sums[3] - sine * sums[5]) / sums[1],
            "C": sums[1] / solid,
            "packing": solid / sums[7],
        }
        rows["fluctuation"] = np.sqrt(np.maximum(0, sums[6] / solid - rows["velocity"] ** 2))
    inside = (depths > 0) & (depths < surface.bed_depth - 0.5e-3) & (rows["packing"] > 0.05)
    rows = {name: values[inside] for name, values in rows.items()}
    depths = depths[inside]
    rows["shear_rate"] = -np.gradient(rows["velocity"], depths)
    excess = rows["velocity"] - run.omega * (surface.height - depths)

    def first_below(values, level):
        for k in range(1, len(values)):
            if values[k - 1] > level >= values[k]:
                return depths[k - 1] + (depths[k] - depths[k - 1]) * (values[k - 1] - level) / (values[k - 1] - values[k])
        return np.nan

    D = surface.bed_depth
    eye, active = first_below(rows["velocity"], 0), first_below(excess, 0.05 * excess[0])
    top = (surface.depth > 0) & (surface.depth < 1e-3) & (np.abs(surface.s) < 0.1 * run.radius)
    solid_of = fields[0] + fields[1]

    def share(where):
        return fields[1][where].sum() / solid_of[where].sum()

    r = np.hypot(surface.x, surface.z)
    deep = (surface.depth > 3e-3) & (r < run.radius - 2e-3)
    numbers = {
        "angle": np.degrees(surface.angle),
        "surface_scatter": surface.scatter,
        "bed_depth": D,
        "surface_speed": sum(
            (cosine * (fields[2] + fields[3]) - sine * (fields[4] + fields[5]))[top]
        ) / solid_of[top].sum(),
        "zero_velocity_depth_over_bed_depth": eye / D,
        "active_depth_over_bed_depth": active / D,
        "peak_shear_rate": rows["shear_rate"].max(),
        "peak_shear_rate_depth_over_bed_depth": depths[rows["shear_rate"].argmax()] / D,
        "packing": solid_of[deep].sum() / (deep.sum() * surface.cell**2 * run.length),
        "C_core": share(np.hypot(surface.s, surface.depth - eye) < 0.1 * D),
        "C_surface": share((surface.depth < 1e-3) & (surface.packing > 0.05)),
        "C_periphery": share((r > 0.9 * run.radius) & (r < run.radius) & (surface.depth > active)),
    }
    return numbers, depths, rows


def mixing(frame, length, blocks):
    """1 - Lacey's index of the grains in cells of so many mm: 1 apart, 0 mixed at random; docs/theory/mixing.md."""
    edge = frame.shape[-1] // blocks * blocks
    large, small = (f[:edge, :edge].reshape(edge // blocks, blocks, -1, blocks).sum((1, 3)) for f in frame)
    volume = large + small
    full = volume > 0.3 * (blocks * 1e-3) ** 2 * length
    V, C = volume[full], small[full] / volume[full]
    P = (V * C).sum() / V.sum()
    variance = (V * (C - P) ** 2).sum() / V.sum()
    mean_grain = P * VOLUME[1] + (1 - P) * VOLUME[0]
    at_random = len(V) / V.sum() * P * ((1 - 2 * P) * VOLUME[1] + P * mean_grain)
    return (variance - at_random) / (P * (1 - P) - at_random), variance / (P * (1 - P))


def mean_and_error(values):
    values = np.array(values)
    return values.mean(0), values.std(0, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else np.full_like(values[0], np.nan)


def digits(x):
    return f"{x:.5g}" if np.isfinite(x) else ""


def write(path, header, rows):
    with open(path, "w", encoding="utf8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows(rows)


UNITS = {"angle": "degrees", "surface_scatter": "m", "bed_depth": "m", "surface_speed": "m/s", "peak_shear_rate": "1/s"}


def evaluate(run, output, start, map_start):
    end = run.windows[-1][1]
    summary, profiles, history, curves = [], [], [], []
    for case in sorted(set(run.replicas), reverse=True):
        seeds = run.seeds(case)
        steady = [profile(run.mean(k, start, end), run) for k in seeds]
        for name in steady[0][0]:
            mean, error = mean_and_error([numbers[name] for numbers, _, _ in steady])
            summary.append([case, name, UNITS.get(name, "1"), len(seeds), f"{start:g}", f"{end:.4g}", digits(mean), digits(error)])
        late = [profile(run.mean(k, map_start, end), run) for k in seeds]
        for name in ("C_core", "C_surface", "C_periphery", "angle", "surface_speed"):
            mean, error = mean_and_error([numbers[name] for numbers, _, _ in late])
            of = [case, name, UNITS.get(name, "1"), len(seeds)]
            summary.append(of + [f"{map_start:g}", f"{end:.4g}", digits(mean), digits(error)])
        count = min(len(d) for _, d, _ in steady)
        names = ["velocity", "velocity_large", "velocity_small", "shear_rate", "fluctuation", "packing", "C"]
        D = np.mean([numbers["bed_depth"] for numbers, _, _ in steady])
        columns = {name: mean_and_error([rows[name][:count] for _, _, rows in steady]) for name in names}
        count_late = min([len(d) for _, d, _ in late] + [count])
        columns["C_late"] = mean_and_error([rows["C"][:count_late] for _, _, rows in late])
        for k in range(min(count, count_late)):
            depth = steady[0][1][k]
            row = [case, digits(MM * depth), digits(depth / D)]
            for name in names + ["C_late"]:
                row += [digits(columns[name][0][k]), digits(columns[name][1][k])]
            profiles.append(row)
        for w in run.windows:
            if w[1] - w[0] < 0.5:
                continue
            found = [profile(run.mean(k, w[0], w[1]), run)[0] for k in seeds]
            row = [case, digits((w[0] + w[1]) / 2)]
            for name in ("angle", "surface_speed", "bed_depth", "C_core", "C_surface", "C_periphery"):
                row += [digits(v) for v in mean_and_error([numbers[name] for numbers in found])]
            history.append(row)
        for f in range(len(run.frames)):
            row = [case, digits(min(0.25 * f, end))]
            for blocks in (1, 2, 3):
                values = [mixing(run.frames[f, k], run.length, blocks)[0] for k in seeds]
                row += [digits(v) for v in mean_and_error(values)]
            curves.append(row)
        write_map(run, output / f"map_{case}.csv", seeds, map_start, end)

    def twice(names):
        return [x for name in names for x in (name, name.split(" ")[0] + "_error" + name[len(name.split(" ")[0]):])]

    write(output / "summary.csv", ["case", "quantity", "unit", "seeds", "from (s)", "to (s)", "mean", "standard_error"], summary)
    write(output / "profiles.csv", ["case", "depth (mm)", "depth_over_D"] + twice(
        ["velocity (m/s)", "velocity_large (m/s)", "velocity_small (m/s)", "shear_rate (1/s)", "fluctuation (m/s)",
         "packing", "C", "C_late"]), profiles)
    write(output / "history.csv", ["case", "time (s)"] + twice(
        ["angle (degrees)", "surface_speed (m/s)", "bed_depth (m)", "C_core", "C_surface", "C_periphery"]), history)
    write(output / "segregation.csv", ["case", "time (s)"] + twice(
        ["apart_1mm", "apart_2mm", "apart_3mm"]), curves)


def compare_stiffness(run, stiffer, path, start, end):
    """Case EV of a run beside one seed with stiffer grains, over the same time."""
    rows = []
    base = [profile(run.mean(k, start, end), run)[0] for k in run.seeds("ev")]
    other = profile(stiffer.mean(stiffer.seeds("ev")[0], start, end), stiffer)[0]
    for name in other:
        mean, error = mean_and_error([numbers[name] for numbers in base])
        rows.append(["ev", name, UNITS.get(name, "1"), f"{start:g}", f"{end:g}", digits(mean), digits(error), digits(other[name])])
    write(path, ["case", "quantity", "unit", "from (s)", "to (s)", "mean", "standard_error", "stiffer"], rows)


def write_map(run, path, seeds, start, end, blocks=2):
    """C, packing and velocity in cells of 1 mm."""
    sums = []
    for k in seeds:
        f = run.mean(k, start, end)
        sums.append(f.reshape(FIELDS, f.shape[1] // blocks, blocks, f.shape[2] // blocks, blocks).sum((2, 4)))
    x, z = coordinates(sums[0].shape[-1], blocks * 0.5e-3)
    rows = []
    with np.errstate(invalid="ignore", divide="ignore"):
        C = mean_and_error([f[1] / (f[0] + f[1]) for f in sums])
        u = mean_and_error([(f[2] + f[3]) / (f[0] + f[1]) for f in sums])
        w = mean_and_error([(f[4] + f[5]) / (f[0] + f[1]) for f in sums])
        packing = mean_and_error([(f[0] + f[1]) / ((blocks * 0.5e-3) ** 2 * run.length) for f in sums])
    for i, j in zip(*np.nonzero(packing[0] > 0.05)):
        rows.append([digits(MM * x[i, j]), digits(MM * z[i, j])] + [digits(v[i, j]) for pair in (C, packing, u, w) for v in pair])
    columns = ["C", "C_error", "packing", "packing_error", "u (m/s)", "u_error (m/s)", "w (m/s)", "w_error (m/s)"]
    write(path, ["x (mm)", "z (mm)"] + columns, rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", type=Path)
    parser.add_argument("--output", type=Path, required=True)
    parser.add_argument("--from", dest="start", type=float, default=6, help="start of the steady time, s")
    parser.add_argument("--map", type=float, default=12, help="start of the time of the maps, s")
    parser.add_argument("--stiffer", type=Path, help="results with stiffer grains: stiffness.csv compares EV from 4 to 7 s")
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    run = Run(arguments.results)
    evaluate(run, arguments.output, arguments.start, arguments.map)
    if arguments.stiffer:
        compare_stiffness(run, Run(arguments.stiffer), arguments.output / "stiffness.csv", 4, 7)


if __name__ == "__main__":
    main()
