#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Compares a study of the drum with the scaling of Schlick et al. (2015): scaling.py STUDY_DIR [--output DIR].

Prints how far members are from the curves that the degree of segregation and its time should be on, and writes maps.csv,
one line per member, and the pictures scaling.png and maps.png."""

import argparse
import csv
import math
import sys
from pathlib import Path

# Columns of maps.csv, and of study.csv, for a speed in rpm, lengths in m, angles in degrees.
COLUMNS = {"speed": "geometry.rotation_speed", "radius": "geometry.radius", "fill": "geometry.fill_depth",
           "d_small": "material.d_small", "d_large": "material.d_large", "spacing": "numerics.spacing",
           "angle": "surface_angle.mean", "angle_least": "surface_angle.min", "angle_largest": "surface_angle.max",
           "surface_speed": "surface_speed.mean", "bed_depth": "bed_depth.mean", "layer_depth": "scaling.layer_depth",
           "curvature": "surface_scatter.mean", "epsilon": "scaling.epsilon", "Lambda": "scaling.Lambda", "Pe": "scaling.Pe",
           "Froude": "scaling.Froude", "degree": "scaling.degree", "time_in_turns": "scaling.time_in_turns",
           "deviation": "scaling.deviation", "intensity": "intensity", "lacey": "lacey"}


class Mistake(Exception):
    """What the user has to change; printed as one line."""


def members_of(path):
    """The finished members of a study, as dictionaries of numbers by the names of COLUMNS."""
    try:
        with open(path, encoding="utf8", newline="") as file:
            rows = list(csv.DictReader(file))
    except OSError as error:
        raise Mistake(f"{path}: {error.strerror}; expected the directory of a study of drum") from None
    rows = [{name.split(" [")[0]: value for name, value in row.items()} for row in rows]
    finished = [row for row in rows if row.get("state") == "finished"]
    if not finished:
        raise Mistake(f"{path}: no member has finished")
    members = []
    for row in finished:
        member = {"member": row["member"]}
        for name, column in COLUMNS.items():
            if column in row and row[column] != "":
                member[name] = float(row[column])
        if "time" in row and "speed" in member:
            member["turns"] = float(row["time"]) * abs(member["speed"]) / 60
        for name in ("Lambda", "Pe", "degree", "time_in_turns", "epsilon", "Froude", "turns", "radius", "fill", "spacing"):
            if name not in member:
                raise Mistake(f"{path}: member {row['member']} has no {COLUMNS.get(name, 'time or geometry.rotation_speed')}")
        members.append(member)
    return members


def solve(matrix, right):
    """The solution of a small system of equations, by elimination with pivots."""
    n = len(right)
    rows = [list(line) + [value] for line, value in zip(matrix, right)]
    largest = max(abs(value) for line in matrix for value in line)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        if abs(rows[k][k]) <= 1e-12 * largest:
            raise Mistake("the members do not differ enough for a curve")
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    found = [0.0] * n
    for k in reversed(range(n)):
        found[k] = (rows[k][n] - sum(rows[k][j] * found[j] for j in range(k + 1, n))) / rows[k][k]
    return found


class Curve:
    """ln y = sum of a_k times terms of the logarithms of the arguments, by least squares."""

    def __init__(self, terms, arguments, values):
        self.terms = terms
        lines = [self.line(*point) for point in arguments]
        logs = [math.log(value) for value in values]
        n = len(lines[0])
        if len(lines) <= n:
            raise Mistake(f"a curve of {n} coefficients needs more than {len(lines)} members")
        matrix = [[sum(line[i] * line[j] for line in lines) for j in range(n)] for i in range(n)]
        self.coefficients = solve(matrix, [sum(line[i] * log for line, log in zip(lines, logs)) for i in range(n)])
        deviations = [value / self(*point) - 1 for point, value in zip(arguments, values)]
        self.deviations = deviations
        self.scatter = math.sqrt(sum(d * d for d in deviations) / len(deviations))

    def line(self, *point):
        return [term(*(math.log(x) for x in point)) for term in self.terms]

    def __call__(self, *point):
        return math.exp(sum(a * term for a, term in zip(self.coefficients, self.line(*point))))


# Of one argument: a parabola in logarithms. Of Pe and epsilon: a product of powers.
PARABOLA = [lambda x: 1.0, lambda x: x, lambda x: x * x]
POWERS = [lambda x, y: 1.0, lambda x, y: x, lambda x, y: y]


def degree_curve(members):
    """The degree of segregation over Lambda Pe."""
    return Curve(PARABOLA, [(m["Lambda"] * m["Pe"],) for m in members], [m["degree"] for m in members])


def settled(members, share):
    """The members with a Lambda and a Pe whose run was long enough for a share of the last degree of segregation."""
    return [m for m in members if m["Lambda"] > 0 and m["Pe"] > 0 and m["time_in_turns"] > 0 and
            1 - math.exp(-m["turns"] / m["time_in_turns"]) >= share]


def alike(members, centre, width=0.2):
    """The members with Lambda Pe within a share of a value."""
    return [m for m in members if abs(m["Lambda"] * m["Pe"] / centre - 1) <= width]


def time_curve(members):
    """The time of segregation in turns over Pe and epsilon, for members with the same Lambda Pe."""
    return Curve(POWERS, [(m["Pe"], m["epsilon"]) for m in members], [m["time_in_turns"] for m in members])


def write_maps(members, path):
    names = ["member", "turns"] + [name for name in COLUMNS if any(name in m for m in members)]
    with open(path, "w", encoding="utf8", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        for m in members:
            writer.writerow([m[name] if name == "member" else f"{m[name]:.6g}" if name in m else "" for name in names])


def load_matplotlib():
    try:
        import matplotlib
    except ModuleNotFoundError as error:
        raise Mistake(f"{sys.executable} has no module {error.name}; on Debian 12: apt-get install python3-matplotlib, then "
                      "/usr/bin/python3 scaling.py ...; or --no-pictures") from None
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 11, "axes.titlesize": 11, "legend.fontsize": 9.5, "legend.frameon": False,
                         "axes.spines.top": False, "axes.spines.right": False, "savefig.dpi": 100,
                         "figure.constrained_layout.use": True})
    return plt


COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]  # as in plot.py
MARKS = ["o", "s", "^", "D", "v"]


def styles_of(members):
    """A colour for each radius and a mark for each filling."""
    radii, fills = sorted({m["radius"] for m in members}), sorted({m["fill"] for m in members})
    return {m["member"]: {"color": COLOURS[radii.index(m["radius"]) % len(COLOURS)],
                          "marker": MARKS[fills.index(m["fill"]) % len(MARKS)]} for m in members}


def add_legend(ax, members):
    for radius in sorted({m["radius"] for m in members}):
        k = sorted({m["radius"] for m in members}).index(radius)
        ax.plot([], [], "o", color=COLOURS[k % len(COLOURS)], label=f"R = {1000 * radius:g} mm")
    for k, fill in enumerate(sorted({m["fill"] for m in members})):
        ax.plot([], [], MARKS[k % len(MARKS)], color="0.5", label=f"filled to {fill:g}")
    ax.legend()


def spaced(values, count=100):
    low, high = math.log(min(values)), math.log(max(values))
    return [math.exp(low + (high - low) * k / (count - 1)) for k in range(count)]


def plain_ticks(ax):
    from matplotlib.ticker import LogLocator, NullFormatter, ScalarFormatter
    for axis in (ax.xaxis, ax.yaxis):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
        axis.set_major_formatter(ScalarFormatter())
        axis.set_minor_formatter(NullFormatter())


def draw_scaling(plt, members, centre, froude, path):
    """The curves are those of members with Froude numbers up to a limit; the marks of others are hollow."""
    fig, axes = plt.subplots(1, 2, figsize=(11, 4.4))
    styles = styles_of(members)
    for m in members:
        styles[m["member"]]["fillstyle"] = "full" if m["Froude"] <= froude else "none"
    rolling = [m for m in members if m["Froude"] <= froude]
    products = [m["Lambda"] * m["Pe"] for m in members]
    curve = degree_curve(rolling)
    for m, product in zip(members, products):
        axes[0].loglog(product, m["degree"], linestyle="", **styles[m["member"]])
    axes[0].loglog(spaced(products), [curve(x) for x in spaced(products)], color="0.6", zorder=0)
    axes[0].set(xlabel=r"$\Lambda\,Pe$", ylabel="degree of segregation",
                title=f"scatter {100 * curve.scatter:.1f} %")
    add_legend(axes[0], members)
    curve = time_curve(alike(rolling, centre))
    for m in alike(members, centre):
        axes[1].loglog(curve(m["Pe"], m["epsilon"]), m["time_in_turns"], linestyle="", **styles[m["member"]])
    ends = spaced([m["time_in_turns"] for m in alike(members, centre)], 2)
    axes[1].loglog(ends, ends, color="0.6", zorder=0)
    a, b, c = curve.coefficients
    axes[1].set(xlabel=rf"{math.exp(a):.2g} $Pe^{{{b:.2f}}}\,\epsilon^{{{c:.2f}}}$", ylabel="time in turns",
                title=rf"$\Lambda\,Pe$ = {centre:g} within 20 %: scatter {100 * curve.scatter:.1f} %")
    for ax in axes:
        plain_ticks(ax)
    fig.savefig(path)


# Name, label and factor of each map; None: over the radius. The last two are drawn for members with the same Lambda Pe alone.
MAPS = [("angle", "angle, degrees", 1), ("layer_depth", r"$\delta/R$", None), ("surface_speed", "surface speed, cm/s", 100),
        ("curvature", "rms of the surface/R", None), ("degree", "degree of segregation", 1), ("time_in_turns", "time, turns", 1)]


def draw_maps(plt, members, compared, centre, path):
    fig, axes = plt.subplots(2, 3, figsize=(13, 7.6))
    styles = styles_of(members)
    for ax, (name, label, factor) in zip(axes.flat, MAPS):
        segregates = name in ("degree", "time_in_turns")
        for m in compared if segregates else members:
            if name in m:
                ax.plot(m["Froude"], m[name] * (factor or 1 / m["radius"]), linestyle="", **styles[m["member"]])
        ax.set(xscale="log", yscale="log" if name == "surface_speed" else "linear", xlabel=r"$\omega^2 R/g$", ylabel=label)
        if segregates:
            ax.set_title(rf"$\Lambda\,Pe$ = {centre:g} within 20 %")
    add_legend(axes[0, 0], members)
    fig.savefig(path)


def usual(members):
    """The members with the commonest spacing over the radius."""
    spacings = [round(m["radius"] / m["spacing"]) for m in members]
    commonest = max(set(spacings), key=spacings.count) if members else 0
    return [m for m, spacing in zip(members, spacings) if spacing == commonest]


def about_others(members, curve):
    """Lines about members with another spacing."""
    known = {m["member"] for m in usual(members)}
    return [f"member {m['member']}, R/dr = {m['radius'] / m['spacing']:.0f}: degree {m['degree']:.3f}, "
            f"{100 * (m['degree'] / curve(m['Lambda'] * m['Pe']) - 1):+.1f} % off the curve, after {m['turns']:.3g} turns; "
            f"time {m['time_in_turns']:.3g} turns" for m in members if m["member"] not in known]


def report(members, centre, limits):
    """Lines of text about the two curves, of all members and of those with Froude numbers up to each limit."""
    lines = ["all members that count:", *about_curves(members, centre)]
    for limit in sorted(limits, reverse=True):
        slower = [m for m in members if m["Froude"] <= limit]
        if len(slower) < len(members):
            lines += [f"members with omega^2 R/g <= {limit:g}:", *about_curves(slower, centre)]
    return lines


def about_curves(members, centre):
    if len(members) <= len(PARABOLA):
        return [f"only {len(members)} members have a Lambda, a Pe and a time, too few for a curve"]
    curve = degree_curve(members)
    worst = max(abs(d) for d in curve.deviations)
    products = [m["Lambda"] * m["Pe"] for m in members]
    lines = [f"degree of segregation over Lambda Pe ({min(products):.3g} to {max(products):.3g}), {len(members)} members: "
             f"scatter {100 * curve.scatter:.1f} %, largest deviation {100 * worst:.1f} %"]
    chosen = alike(members, centre)
    if len(chosen) > len(POWERS):
        curve = time_curve(chosen)
        worst = max(abs(d) for d in curve.deviations)
        a, b, c = curve.coefficients
        lines.append(f"time in turns at Lambda Pe = {centre:g} within 20 %, {len(chosen)} members with Pe of "
                     f"{min(m['Pe'] for m in chosen):.3g} to {max(m['Pe'] for m in chosen):.3g}: {math.exp(a):.3g} Pe^{b:.2f} "
                     f"epsilon^{c:.2f}, scatter {100 * curve.scatter:.1f} %, largest deviation {100 * worst:.1f} %")
    else:
        lines.append(f"only {len(chosen)} members have Lambda Pe = {centre:g} within 20 %, too few for a curve of the time")
    return lines


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("study", type=Path, help="directory of the study")
    parser.add_argument("--output", type=Path, help="directory of maps.csv and the pictures; by default that of the study")
    parser.add_argument("--product", type=float, default=11, help="Lambda Pe at which times are compared (default: 11)")
    parser.add_argument("--froude", type=float, nargs="+", default=[0.04, 0.07],
                        help="values of omega^2 R/g up to which members are compared apart, too (default: 0.04 0.07); the picture "
                             "has the curves of the first")
    parser.add_argument("--share", type=float, default=0.8,
                        help="of the last degree that a run must have reached to be compared (default: 0.8)")
    parser.add_argument("--no-pictures", action="store_true", help="only the text and maps.csv")
    words = parser.parse_args()
    try:
        members = members_of(words.study / "study.csv")
        output = words.output or words.study
        output.mkdir(parents=True, exist_ok=True)
        write_maps(members, output / "maps.csv")
        scaled = settled(usual(members), words.share)
        print("\n".join(report(scaled, words.product, words.froude)))
        rolling = [m for m in scaled if m["Froude"] <= words.froude[0]]
        if len(rolling) > len(PARABOLA):
            for line in about_others(members, degree_curve(rolling)):
                print(line)
        if not words.no_pictures and len(alike(rolling, words.product)) > len(POWERS):
            plt = load_matplotlib()
            draw_scaling(plt, scaled, words.product, words.froude[0], output / "scaling.png")
            draw_maps(plt, members, alike(scaled, words.product), words.product, output / "maps.png")
    except Mistake as mistake:
        sys.exit(f"scaling.py: {mistake}")


if __name__ == "__main__":
    main()
