#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws what the shear box wrote as figures 8 to 14 of Zhu, Peng & Wu (2024), one PNG each."""

import argparse
import csv
import io
import json
import sys
from functools import cached_property
from pathlib import Path

try:
    import h5py  # noqa: F401  (of view)
    import numpy as np
    import tomllib
    import matplotlib
except ModuleNotFoundError as error:
    sys.exit(f"plot.py: {sys.executable} has no module {error.name}; on Debian 12: "
             "apt-get install python3-matplotlib python3-h5py python3-numpy, then /usr/bin/python3 plot.py ...")

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import LogFormatterSciNotation  # noqa: E402
from PIL import Image  # noqa: E402  (comes with matplotlib)

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import view  # noqa: E402

plt.rcParams.update({"font.size": 11, "axes.titlesize": 11, "legend.fontsize": 10, "legend.frameon": False,
                     "axes.spines.top": False, "axes.spines.right": False, "savefig.dpi": 100,
                     "figure.constrained_layout.use": True})

# Okabe & Ito's colours, which differ for colour-blind readers too; yellow is left out (too pale for lines).
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
GRAINS = "RdYlBu_r"  # blue: large grains, red: small ones
SURFACE_SETS = [  # bit, name, colour; a particle in several sets is drawn as the first of them
    (1, r"$\Omega_F$ free surface", "#0072B2"),
    (4, r"$\Omega_W$ wall", "#D55E00"),
    (2, r"$\Omega_f$ near the free surface", "#56B4E9"),
    (8, r"$\Omega_w$ near the wall", "#E69F00"),
    (0, r"$\Omega_I$ full support", "#D9D9D9"),
]
NORMALS = [("free_surface_normal", "normal of the free surface", COLOURS[0]),
           ("wall_normal", "normal of the wall", COLOURS[1])]
WALL_COLOUR = "#6E6E6E"
ONE_DIMENSIONAL = "1D reference"
QUARTERS = [0.25, 0.5, 0.75]


class PlotError(Exception):
    """What the user has to change; printed as one line."""


# ---------------------------------------------------------------------------------------------------- results of a run


class Run:
    """What one run of the shear box left in its directory. Times in T, lengths in H."""

    def __init__(self, directory):
        self.directory = Path(directory)
        for name in ["case.toml", "summary.json"]:
            if not (self.directory / name).is_file():
                raise PlotError(f"{self.directory} has no {name}: not the results of a finished run of shear_box")
        self.options = tomllib.loads((self.directory / "case.toml").read_text())
        self.summary = json.loads((self.directory / "summary.json").read_text())

    @property
    def spacing(self):
        return self.options["numerics"]["spacing"]

    @property
    def reference(self):
        """What C_reference of the profiles is."""
        return ONE_DIMENSIONAL if self.options["geometry"]["upright"] else "2D reference"

    @property
    def compared(self):
        return [entry["time"] for entry in self.summary["compared"]]

    def error(self, name, time):
        return next(entry[name] for entry in self.summary["compared"] if entry["time"] == time)

    @cached_property
    def history(self):
        return read_columns(self.directory / "history.csv")

    @cached_property
    def profiles(self):
        return read_columns(self.directory / "profiles.csv")

    def profile(self, time):
        at_time = self.profiles["time"] == time
        return {name: values[at_time] for name, values in self.profiles.items()}

    @cached_property
    def frames(self):
        return Frames(self.directory / "particles.vtkhdf", self.options)

    @cached_property
    def features(self):
        """What can tell this run from others, in words."""
        geometry, model, numerics = (self.options[key] for key in ["geometry", "model", "numerics"])
        by_shear_rate = model["closure"] == "shear-rate"
        return {
            "scheme": {"hcsr": "HCSR"}.get(model["scheme"], model["scheme"]),
            "flux": f"{model['flux']} flux",
            "reading": {"chi": r"$B = H\gamma_0$", "times": r"$B = H$"}[model["reading"]],
            "closure": r"$V, D \propto \dot\gamma$" if by_shear_rate else "constant $V, D$",
            "d_bar": rf"$\bar d = {1000 * model['d_bar']:g}$ mm" if by_shear_rate else "",
            "upright": "upright box" if geometry["upright"] else "oscillating box",
            "dimension": f"{numerics['dimension']}D",
            "precision": numerics["precision"],
            "jitter": rf"jitter {numerics['jitter']:g} $\Delta r$",
            "spacing": rf"$\Delta r/H = {self.spacing:g}$",
        }


class Frames:
    """The stored states of all particles."""

    def __init__(self, path, options):
        if not path.is_file():
            raise PlotError(f"{path} is missing")
        self.states = view.Run(path)
        self.options = options
        self.times = self.states.times / options["geometry"]["period"]

    def nearest(self, time):
        k = int(np.argmin(np.abs(self.times - time)))
        if abs(self.times[k] - time) > 1e-3:
            raise PlotError(f"{self.states.path} has no state at t/T = {time:g}; "
                            "run with --set output.frame_interval=0.25 --set time.periods=1")
        return k

    def points(self, k):
        """x/H and z/H of frame k."""
        return self.states[k].points[:, [0, 2]] / self.options["geometry"]["height"]

    def middle_plane(self, k):
        """Which particles stand in the plane halfway in depth; in 2D all do."""
        depth = self.states[k].points[:, 1] / self.options["geometry"]["height"]
        middle = depth[np.argmin(np.abs(depth - (depth.min() + depth.max()) / 2))]
        return np.abs(depth - middle) < 0.5 * self.options["numerics"]["spacing"]

    def field(self, name, k):
        return self.states[k][name]

    def row_means(self):
        """z/H of the rows of particles and C over (row, frame)."""
        material = self.field("body", 0) == 0
        spacing = self.options["numerics"]["spacing"]
        rows, row = np.unique(np.floor(self.points(0)[material, 1] / spacing), return_inverse=True)
        sums = [np.bincount(row, self.field("concentration", k)[material]) for k in range(len(self.times))]
        return (rows + 0.5) * spacing, np.transpose(sums) / np.bincount(row)[:, None]


def read_columns(path):
    if not path.is_file():
        raise PlotError(f"{path} is missing")
    with path.open() as file:
        header, *rows = csv.reader(file)
    columns = np.array(rows, dtype=float).reshape(len(rows), len(header)).T
    return {name.split(" [")[0]: column for name, column in zip(header, columns)}


def labels(runs, leave_out=()):
    """For each run the features by which the given runs differ; of a single run the main ones."""
    if len(runs) == 1:
        return [", ".join(runs[0].features[name] for name in ["scheme", "flux", "spacing"] if name not in leave_out)]
    names = [name for name in runs[0].features if name not in leave_out]
    telling = [name for name in names if len({run.features[name] for run in runs}) > 1]
    return [", ".join(filter(None, (run.features[name] for name in telling))) for run in runs]


def common_times(runs, wanted=None):
    """The compared times that all runs have; those wanted, if any of them is there."""
    times = [time for time in runs[0].compared if all(time in run.compared for run in runs)]
    if not times:
        raise PlotError(f"no compared time is common to {', '.join(str(run.directory) for run in runs)}")
    return [time for time in times if wanted and time in wanted] or times


def late_time(runs):
    """80 T, as in the paper; the last common time otherwise."""
    return common_times(runs, [80.0])[-1]


# ----------------------------------------------------------------------------------------------- parts of the pictures


def draw_map(axes, frames):
    """C over time and height, linear between the rows and the stored states."""
    if len(frames.times) < 2:
        raise PlotError(f"{frames.root.file.filename} has fewer than two states; lower output.frame_interval")
    z, C = frames.row_means()
    end = frames.times[-1]
    t_fine, z_fine = np.linspace(0, end, 501), (np.arange(400) + 0.5) / 400
    C = np.array([np.interp(t_fine, frames.times, row) for row in C])
    C = np.transpose([np.interp(z_fine, z, column) for column in C.T])
    axes.set(xlabel="$t/T$")
    return axes.imshow(C, cmap=GRAINS, vmin=0, vmax=1, extent=(0, end, 0, 1), origin="lower", aspect="auto",
                       interpolation="nearest")


def add_colour_bar(figure, image, axes):
    bar = figure.colorbar(image, ax=axes, aspect=25, pad=0.02)
    bar.set_ticks(np.linspace(0, 1, 6), labels=["0 large", "0.2", "0.4", "0.6", "0.8", "1 small"])
    bar.ax.set_title("$C$")


def sparse(profile, number=14):
    """Some rows of a profile, for symbols: evenly spread, both ends among them."""
    rows = len(profile["z_over_H"])
    return np.unique(np.linspace(0, rows - 1, min(rows, number)).round().astype(int))


def draw_profiles(axes, run, times):
    for time, colour in zip(times, COLOURS):
        profile = run.profile(time)
        z, some = profile["z_over_H"], sparse(profile)
        axes.plot(profile["C_mean"], z, color=colour, lw=1.8)
        axes.plot(profile["C_reference"][some], z[some], "o", color=colour, mfc="none", ms=6.5, clip_on=False)
        if run.reference != ONE_DIMENSIONAL:
            axes.plot(profile["C_one_dimensional"][some], z[some], "+", color=colour, ms=6.5, clip_on=False)
    axes.set(xlabel="$C$", ylabel="$z/H$", xlim=(-0.02, 1.02), ylim=(0, 1))


def profile_legend(run, times):
    kinds = [Line2D([], [], color="0.3", lw=1.8, label="SPH, mean over width"),
             Line2D([], [], color="0.3", marker="o", mfc="none", ms=6.5, ls="", label=run.reference)]
    if run.reference != ONE_DIMENSIONAL:
        kinds.append(Line2D([], [], color="0.3", marker="+", ms=6.5, ls="", label=ONE_DIMENSIONAL))
    return [Line2D([], [], color=c, lw=1.8, label=f"$t/T = {t:g}$") for t, c in zip(times, COLOURS)] + kinds


def draw_particles(axes, points, spacing, colour, label=None):
    size = np.full(len(points), 0.92 * spacing)
    axes.add_collection(EllipseCollection(size, size, np.zeros(len(points)), units="xy", offsets=points,
                                          transOffset=axes.transData, facecolors=colour, edgecolors="none"))
    return Line2D([], [], marker="o", ls="", ms=7, color=colour, label=label)


def box_axes(run, times, rows=1):
    """A figure with one panel per time, all at the same scale, and what to draw in each: axes, number of the frame,
    points, which of them stand in the plane to show. With two rows: a pair of axes, the lower one free."""
    frames = run.frames
    numbers = [frames.nearest(time) for time in times]
    clouds, planes = [frames.points(k) for k in numbers], [frames.middle_plane(k) for k in numbers]
    top, margin = 1 + 3.5 * run.spacing, 1.5 * run.spacing
    bottom = min(cloud[:, 1].min() for cloud in clouds) - margin
    shown = [cloud[cloud[:, 1] < top, 0] for cloud in clouds]
    spans = [(x.min() - margin, x.max() + margin) for x in shown]
    widths = [high - low for low, high in spans]
    height = 9.2 / sum(widths) * (top - bottom) + 0.8
    figure = plt.figure(figsize=(10.2, height + 0.7 + 2.8 * (rows - 1)))
    grid = figure.add_gridspec(rows, 1, height_ratios=[height] + [2.8] * (rows - 1))
    upper = grid[0].subgridspec(1, len(times), width_ratios=widths)
    panels = upper.subplots(sharey=True)
    for axes, time, span, letter in zip(panels, times, spans, "abc"):
        axes.set(xlim=span, ylim=(bottom, top), aspect="equal", xlabel="$x/H$", title=f"({letter})  $t/T = {time:g}$")
    panels[0].set_ylabel("$z/H$")
    if rows == 2:
        lower = grid[1].subgridspec(1, len(times)).subplots()
        lower[0].set_ylabel("$z/H$")
        panels = list(zip(panels, lower))
    return figure, zip(panels, numbers, clouds, planes)


def legend_below(figure, handles, columns):
    inches = 0.2 + 0.24 * -(-len(handles) // columns)
    share = inches / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    figure.legend(handles=handles, loc="lower center", ncol=columns)


# ------------------------------------------------------------------------------------------------------------- figures


def figure_8(runs):
    """Surface sets."""
    run = runs[0]
    figure, panels = box_axes(run, QUARTERS)
    for axes, k, points, plane in panels:
        material, bits = run.frames.field("body", k) == 0, run.frames.field("surface_set", k)
        handles, left = [], material & plane
        for bit, name, colour in SURFACE_SETS:
            chosen = left & ((bits & bit == bit) if bit else True)
            handles.append(draw_particles(axes, points[chosen], run.spacing, colour, name))
            left &= ~chosen
        handles.append(draw_particles(axes, points[~material & plane], run.spacing, WALL_COLOUR, "fictitious"))
    legend_below(figure, handles, 3)
    return figure


def figure_9(runs):
    """Normals: of the outermost particles above, of all that have one in the upper left corner below."""
    run = runs[0]
    figure, panels = box_axes(run, QUARTERS, rows=2)
    for axes, k, points, plane in panels:
        outermost = run.frames.field("surface_set", k) & (1 | 4) > 0
        draw_normals(axes[0], run, k, spread(points, plane & outermost, 0.019), length=0.07)
        draw_normals(axes[1], run, k, plane, length=1.8 * run.spacing)
        material = run.frames.field("body", k) == 0
        corner = points[material & (points[:, 1] > 1 - run.spacing)].min(axis=0)
        show_close_up(axes[1], corner, run.spacing)
    legend_below(figure, [Line2D([], [], color=c, lw=2, label=label) for _, label, c in NORMALS], 2)
    return figure


def spread(points, chosen, distance):
    """Those of the chosen that are not closer than the distance to one already taken."""
    taken = []
    for i in np.flatnonzero(chosen):
        if not taken or np.hypot(*(points[taken] - points[i]).T).min() > distance:
            taken.append(i)
    return np.isin(np.arange(len(points)), taken)


def draw_normals(axes, run, k, chosen, length):
    material, points = run.frames.field("body", k) == 0, run.frames.points(k)
    plane = run.frames.middle_plane(k)
    draw_particles(axes, points[material & plane], run.spacing, "#E4E4E4")
    draw_particles(axes, points[~material & plane], run.spacing, "#B4B4B4")
    for name, _, colour in NORMALS:
        normal = run.frames.field(name, k)[:, [0, 2]]
        drawn = chosen & (np.hypot(*normal.T) > 0.5)
        axes.quiver(*points[drawn].T, *normal[drawn].T, color=colour, angles="xy", scale_units="xy", units="xy",
                    scale=1 / length, width=0.08 * length, headwidth=3.5, headlength=4, headaxislength=3.6)


def show_close_up(axes, corner, spacing):
    low, high = corner - [4 * spacing, 10 * spacing], corner + [14 * spacing, 3 * spacing]
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", xlabel="$x/H$")


def figure_10(runs):
    """C over height and time, and profiles against the references; one row per run."""
    figure, panels = plt.subplots(len(runs), 2, figsize=(10.2, 3.9 * len(runs)), sharey=True, squeeze=False,
                                  gridspec_kw={"width_ratios": [1.7, 1]})
    for (left, right), run, label in zip(panels, runs, labels(runs)):
        image = draw_map(left, run.frames)
        left.set(ylabel="$z/H$", title=label)
        add_colour_bar(figure, image, left)
        times = common_times([run], [20.0, 40.0, 80.0])[:len(COLOURS)]
        draw_profiles(right, run, times)
        right.tick_params(labelleft=True)
        right.legend(handles=profile_legend(run, times), loc="center left", bbox_to_anchor=(1, 0.5), handlelength=1.5)
    return figure


def figure_11(runs):
    """Profiles of several spacings at 80 T against the reference, and their errors."""
    runs = sorted(runs, key=lambda run: -run.spacing)
    time = late_time(runs)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.2, 4.4), sharey=True, gridspec_kw={"width_ratios": [1.3, 1]})
    finest = runs[-1].profile(time)
    left.plot(finest["C_reference"], finest["z_over_H"], color="0.25", lw=1.2, label=runs[-1].reference)
    for run, label, colour, marker in zip(runs, labels(runs), COLOURS, "os^Dv<>"):
        profile = run.profile(time)
        z, some = profile["z_over_H"], sparse(profile, 25)
        left.plot(profile["C_mean"][some], z[some], marker, color=colour, mfc="none", ms=5.5, label=label)
        right.plot(profile["C_mean"] - profile["C_reference"], z, color=colour, lw=1.5)
    left.set(xlabel="$C$", ylabel="$z/H$", ylim=(0, 1), title=f"mean over the width at $t/T = {time:g}$")
    left.legend(loc="best")
    right.axvline(0, color="0.7", lw=0.8, zorder=0)
    right.locator_params(axis="x", nbins=5)
    right.set(xlabel=r"$C - C_{\mathrm{reference}}$", title="error")
    return figure


def figure_12(runs):
    """MAE and RMSE against the spacing; one pair of lines for each set of runs that differ in their spacing alone."""
    time = late_time(runs)
    figure, axes = plt.subplots(figsize=(7.2, 4.8))
    for (label, series), colour in zip(by_all_but_spacing(runs).items(), COLOURS):
        draw_convergence(axes, series, time, label, colour)
    draw_slopes(axes, runs, [run.error("mae_width", time) for run in runs])
    axes.set(xlabel=r"$\Delta r/H$", ylabel=f"error of $C$, mean over the width, at $t/T = {time:g}$",
             xscale="log", yscale="log")
    spacings = sorted({run.spacing for run in runs})
    axes.set_xticks(spacings, [f"{spacing:g}" for spacing in spacings])
    axes.set_xticks([], minor=True)
    axes.yaxis.set_minor_formatter(LogFormatterSciNotation(minor_thresholds=(1.5, 0.8)))
    axes.tick_params(axis="y", which="minor", labelsize=9)
    axes.legend(loc="upper left")
    return figure


def by_all_but_spacing(runs):
    series = {}
    for label, run in zip(labels(runs, leave_out=["spacing"]), runs):
        series.setdefault(label, []).append(run)
    for label, members in series.items():
        members.sort(key=lambda run: run.spacing)
        if len({run.spacing for run in members}) < 2:
            raise PlotError(f"figure 12 needs runs of two spacings or more{' for ' + label if label else ''}")
    return series


def draw_convergence(axes, runs, time, label, colour):
    spacings = [run.spacing for run in runs]
    for name, style in [("mae", "o-"), ("rmse", "s--")]:
        errors = [run.error(f"{name}_width", time) for run in runs]
        order = np.polyfit(np.log(spacings), np.log(errors), 1)[0]
        words = ", ".join(filter(None, [label, name.upper()]))
        axes.plot(spacings, errors, style, color=colour, mfc="white", label=f"{words}: order {order:.2f}")


def draw_slopes(axes, runs, errors):
    low, high = (f(run.spacing for run in runs) for f in (min, max))
    for slope, style in [(1, ":"), (2, "-.")]:
        ends = np.array([low, high])
        axes.plot(ends, 0.6 * min(errors) * (ends / low) ** slope, style, color="0.55", lw=1.2, label=f"slope {slope}")


def figure_13(runs):
    """Several d_bar: C over height and time above, profiles below."""
    times = common_times(runs, [20.0, 40.0, 60.0, 80.0, 120.0])[:5]
    figure = plt.figure(figsize=(11, 6.6))
    upper, lower = figure.subfigures(2, 1, height_ratios=[1.05, 1])
    names = labels(runs)
    maps = upper.subplots(1, len(runs), sharey=True, squeeze=False)[0]
    for axes, run, name in zip(maps, runs, names):
        image = draw_map(axes, run.frames)
        axes.set_title(name)
    maps[0].set_ylabel("$z/H$")
    add_colour_bar(upper, image, maps)
    panels = lower.subplots(1, len(times), sharey=True, squeeze=False)[0]
    for axes, time in zip(panels, times):
        compare_at(axes, runs, names, time)
    panels[0].set_ylabel("$z/H$")
    panels[-1].legend(loc="center left", bbox_to_anchor=(1, 0.5), handlelength=1.3)
    return figure


def compare_at(axes, runs, names, time):
    for run, name, colour in zip(runs, names, COLOURS):
        profile = run.profile(time)
        z, some = profile["z_over_H"], sparse(profile, 11)
        axes.plot(profile["C_mean"], z, color=colour, lw=1.6, label=name)
        axes.plot(profile["C_reference"][some], z[some], "o", color=colour, mfc="none", ms=4.5)
    axes.plot([], [], "o", color="0.3", mfc="none", ms=4.5, label=runs[0].reference)
    axes.set(xlabel="$C$", xlim=(-0.04, 1.04), ylim=(0, 1), xticks=[0, 0.5, 1], title=f"$t/T = {time:g}$")


def figure_14(runs):
    """Mean C over time: on the scale of C, and its drift on a logarithmic scale."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.2, 3.8 + 0.12 * len(runs)), sharex=True)
    for run, label, colour in zip(runs, labels(runs), COLOURS):
        t, mean = run.history["time"], run.history["C_mean"]
        drift = np.maximum.accumulate(np.abs(mean / mean[0] - 1))
        left.plot(t, mean, color=colour, lw=1.6, label=label)
        right.semilogy(t, np.where(drift > 0, drift, np.nan), color=colour, lw=1.6)
    some = slice(None, None, max(1, len(t) // 24))
    left.plot(t[some], np.full_like(t[some], mean[0]), "o", color="0.3", mfc="none", ms=6, label="exact: constant")
    left.set(xlabel="$t/T$", ylabel="mean $C$", ylim=(0.4, 0.6) if np.abs(mean - 0.5).max() < 0.1 else None)
    left.locator_params(axis="y", nbins=5)
    draw_rounding(right)
    legend_below(figure, left.get_legend_handles_labels()[0], 2)
    right.set(xlabel="$t/T$", ylabel=r"largest $|\overline{C}/\overline{C}_0 - 1|$ up to $t$")
    return figure


def draw_rounding(axes):
    unit = np.finfo(float).eps
    axes.axhline(unit, color="0.6", lw=1, ls=":")
    axes.annotate("rounding of one double", (1, unit), (0, -4), xycoords=("axes fraction", "data"), ha="right",
                  va="top", textcoords="offset points", color="0.45", fontsize=9)
    low, high = axes.get_ylim()
    axes.set_ylim(min(low, 0.1 * unit), 3 * high)


FIGURES = {8: figure_8, 9: figure_9, 10: figure_10, 11: figure_11, 12: figure_12, 13: figure_13, 14: figure_14}


def fitting_figures(runs):
    """The figures that these runs have the data for."""
    if len(runs) == 1:
        times = runs[0].frames.times
        quarters = all(np.abs(times - time).min() < 1e-3 for time in QUARTERS)
        return ([8, 9] if quarters else []) + ([10] if runs[0].compared else []) + [14]
    return ([11, 12] if len({run.spacing for run in runs}) > 1 else []) + \
           ([13] if len({run.features["d_bar"] for run in runs}) > 1 else []) + [14]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", metavar="DIR", nargs="+", help="directory that shear_box wrote (its --output)")
    parser.add_argument("--figure", type=int, choices=FIGURES, help="number of the figure in the paper; without it, "
                        "those for which the runs have the data (one run: 10 and 14)")
    parser.add_argument("--output", type=Path, help="directory of the pictures; without it the first DIR")
    return parser.parse_args()


def draw(number, runs, directory):
    figure = FIGURES[number](runs)
    path = directory / f"figure_{number:02}.png"
    save(figure, path)
    plt.close(figure)
    return path


def save(figure, path):
    """With a palette of 256 colours: a third of the size."""
    buffer = io.BytesIO()
    figure.savefig(buffer)
    picture = Image.open(buffer).convert("RGB")
    picture.quantize(256, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(path, optimize=True)


def main():
    arguments = parse_arguments()
    runs = [Run(directory) for directory in arguments.runs]
    directory = arguments.output or runs[0].directory
    directory.mkdir(parents=True, exist_ok=True)
    numbers = [arguments.figure] if arguments.figure else fitting_figures(runs)
    paths = [draw(number, runs, directory) for number in numbers]
    print(*paths, sep="\n")


if __name__ == "__main__":
    try:
        main()
    except (PlotError, OSError) as error:
        sys.exit(f"plot.py: {error}")
