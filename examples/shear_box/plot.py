#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws what the shear box wrote as figures 8 to 14 of Zhu, Peng & Wu (2024), one PNG each."""

import argparse
import csv
import json
import sys
from functools import cached_property
from pathlib import Path

try:
    import h5py
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

plt.rcParams.update({"font.size": 11, "axes.titlesize": 11, "legend.fontsize": 10, "legend.frameon": False,
                     "axes.spines.top": False, "axes.spines.right": False, "savefig.dpi": 110,
                     "mathtext.fontset": "cm", "figure.constrained_layout.use": True})

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
WALL_COLOUR = "#6E6E6E"
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
        self.root = h5py.File(path)["VTKHDF"]
        self.options = options
        self.times = self.root["Steps/Values"][:] / options["geometry"]["period"]

    def nearest(self, time):
        k = int(np.argmin(np.abs(self.times - time)))
        if abs(self.times[k] - time) > 1e-3:
            raise PlotError(f"{self.root.file.filename} has no state at t/T = {time:g}; "
                            "run with --set output.frame_interval=0.25 --set time.periods=1")
        return k

    def points(self, k):
        """x/H and z/H of frame k."""
        first = self.root["Steps/PointOffsets"][k]
        return self.root["Points"][first:first + self.count(k)][:, [0, 2]] / self.options["geometry"]["height"]

    def field(self, name, k):
        first = self.root[f"Steps/PointDataOffsets/{name}"][k]
        return self.root[f"PointData/{name}"][first:first + self.count(k)]

    def count(self, k):
        return self.root["NumberOfPoints"][self.root["Steps/PartOffsets"][k]]

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
    return dict(zip(header, columns))


def labels(runs, leave_out=()):
    """For each run the features by which the given runs differ."""
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
    z = np.concatenate([[0], z, [1]])
    C = np.concatenate([C[:1], C, C[-1:]])
    axes.set(xlabel="$t/T$", ylim=(0, 1))
    return axes.pcolormesh(frames.times, z, C, cmap=GRAINS, vmin=0, vmax=1, shading="gouraud", rasterized=True)


def add_colour_bar(figure, image, axes):
    bar = figure.colorbar(image, ax=axes, label="$C$", ticks=np.linspace(0, 1, 6), aspect=25, pad=0.02)
    bar.ax.set_title("small", fontsize=10)
    bar.ax.text(0.5, -0.03, "large", transform=bar.ax.transAxes, ha="center", va="top", fontsize=10)


def sparse(profile, number=14):
    """Some rows of a profile, for symbols: evenly spread, both ends among them."""
    rows = len(profile["z_over_H"])
    return np.unique(np.linspace(0, rows - 1, min(rows, number)).round().astype(int))


def draw_profiles(axes, run, times):
    for time, colour in zip(times, COLOURS):
        profile = run.profile(time)
        z, some = profile["z_over_H"], sparse(profile)
        axes.plot(profile["C_mean"], z, color=colour, lw=1.8)
        axes.plot(profile["C_reference"][some], z[some], "o", color=colour, mfc="none", ms=6.5)
        axes.plot(profile["C_one_dimensional"][some], z[some], "+", color=colour, ms=6.5)
    axes.set(xlabel="$C$", ylabel="$z/H$", xlim=(-0.02, 1.02), ylim=(0, 1))


def profile_legend(times):
    kinds = [Line2D([], [], color="0.3", lw=1.8, label="SPH, mean over width"),
             Line2D([], [], color="0.3", marker="o", mfc="none", ms=6.5, ls="", label="2D reference"),
             Line2D([], [], color="0.3", marker="+", ms=6.5, ls="", label="1D reference")]
    return [Line2D([], [], color=c, lw=1.8, label=f"$t/T = {t:g}$") for t, c in zip(times, COLOURS)] + kinds


def draw_particles(axes, points, spacing, colour, label=None):
    size = np.full(len(points), 0.92 * spacing)
    axes.add_collection(EllipseCollection(size, size, np.zeros(len(points)), units="xy", offsets=points,
                                          transOffset=axes.transData, facecolors=colour, edgecolors="none"))
    return Line2D([], [], marker="o", ls="", ms=7, color=colour, label=label)


def box_axes(run, times):
    """A figure with one panel per time, all at the same scale, and the particles to draw in each."""
    frames = run.frames
    numbers = [frames.nearest(time) for time in times]
    top, margin = 1 + 3.5 * run.spacing, 1.5 * run.spacing
    clouds = [frames.points(k) for k in numbers]
    spans = [(cloud[cloud[:, 1] < top, 0].min() - margin, cloud[cloud[:, 1] < top, 0].max() + margin)
             for cloud in clouds]
    bottom = min(cloud[:, 1].min() for cloud in clouds) - margin
    widths = [high - low for low, high in spans]
    scale = 9.2 / sum(widths)
    figure, panels = plt.subplots(1, len(times), figsize=(10.2, scale * (top - bottom) + 1.5), sharey=True,
                                  gridspec_kw={"width_ratios": widths})
    for axes, time, span, letter in zip(panels, times, spans, "abc"):
        axes.set(xlim=span, ylim=(bottom, top), aspect="equal", xlabel="$x/H$", title=f"({letter})  $t/T = {time:g}$")
    panels[0].set_ylabel("$z/H$")
    return figure, zip(panels, numbers, clouds)


def legend_below(figure, handles, columns):
    figure.legend(handles=handles, loc="outside lower center", ncol=columns) if has_outside_legends() else \
        figure.axes[-1].legend(handles=handles, loc="upper center")


# ------------------------------------------------------------------------------------------------------------- figures
