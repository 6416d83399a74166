#!/usr/bin/env python3
# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Draws what the drum wrote as figures 16 to 29 of Zhu, Peng & Wu (2024) and a history of the bed, one PNG each."""

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
from PIL import Image  # noqa: E402  (comes with matplotlib)

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import view  # noqa: E402

plt.rcParams.update({"font.size": 11, "axes.titlesize": 11, "legend.fontsize": 9.5, "legend.frameon": False,
                     "axes.spines.top": False, "axes.spines.right": False, "savefig.dpi": 100,
                     "figure.constrained_layout.use": True})

# Okabe & Ito's colours, which differ for colour-blind readers too; yellow is left out (too pale for lines).
COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"]
DASHES = ["-", "--", ":", "-."]
GRAINS = "RdYlBu_r"  # blue: large grains, red: small ones
WALL_COLOUR = "#8A8A8A"
SURFACE_SETS = [  # bit, name, colour; a particle in several sets is drawn as the first of them
    (1, r"$\Omega_F$ free surface", "#0072B2"),
    (4, r"$\Omega_W$ wall", "#D55E00"),
    (2, r"$\Omega_f$ near the free surface", "#56B4E9"),
    (8, r"$\Omega_w$ near the wall", "#E69F00"),
    (0, r"$\Omega_I$ full support", "#D9D9D9"),
]
NORMALS = [("free_surface_normal", "normal of the free surface", COLOURS[0]),
           ("wall_normal", "normal of the wall", COLOURS[1])]
RATES = [("gradient_V_rate", r"$\dot C_1$: $-F\,\nabla_g V$", COLOURS[0]),
         ("gradient_C_rate", r"$\dot C_2$: $-V\mathcal{F}\,\nabla_g C$", COLOURS[1]),
         ("diffusion_rate", r"$\dot C_3$: $\nabla\cdot(D\,\nabla C)$", COLOURS[2])]
# What the paper's text says of the DEM (Yang et al. 2021) and of its own curves; its plotted data are not public.
DEM_SURFACE_SPEED = {("EV", 20.0): 6.0, ("EV", 40.0): 7.0}  # cm/s
RATE_VANISHES = 0.24                                        # of the bed depth, in EN
DEPTH_LABEL = r"$\bar d_{mc}$"


class PlotError(Exception):
    """What the user has to change; printed as one line."""


# ---------------------------------------------------------------------------------------------------- results of a run


class Run:
    """What one run of the drum left in its directory. SI units; angles in degrees."""

    def __init__(self, directory):
        self.directory = Path(directory)
        if not (self.directory / "case.toml").is_file():
            raise PlotError(f"{self.directory} has no case.toml: not the results of a run of drum")
        self.options = tomllib.loads((self.directory / "case.toml").read_text())
        self.radius = self.options["geometry"]["radius"]
        self.spacing = self.options["numerics"]["spacing"]
        self.side = -1 if self.options["geometry"]["rotation_speed"] < 0 else 1  # the analysis looks at it clockwise
        self.omega = abs(self.options["geometry"]["rotation_speed"]) * np.pi / 30

    @cached_property
    def summary(self):
        path = self.directory / "summary.json"
        return json.loads(path.read_text()) if path.is_file() else {}

    @property
    def case(self):
        """EV or EN, the paper's two; empty for any other filling."""
        names = {(0.42, 0.5): "EV", (0.591, 0.11): "EN"}
        return names.get((self.options["geometry"]["fill_depth"], round(self.options["segregation"]["C0"], 2)), "")

    @cached_property
    def history(self):
        return read_columns(self.directory / "history.csv")

    @cached_property
    def profiles(self):
        return read_columns(self.directory / "profiles.csv")

    @cached_property
    def profile_times(self):
        return list(np.unique(self.profiles["time"]))

    def profile(self, time):
        at_time = self.profiles["time"] == time
        return {name: values[at_time] for name, values in self.profiles.items()}

    @cached_property
    def frames(self):
        return Frames(self)

    def surface(self, time):
        """Angle (radians) and height over the axis (m) of the surface; the mean of the second up to the time."""
        t = self.history["time"]
        chosen = (t > time - 1) & (t <= time + 1e-6) if time > 0 else t == t[0]
        angle, depth = (np.nanmean(self.history[name][chosen]) for name in ["angle", "bed_depth"])
        return np.radians(angle), depth - self.radius

    @cached_property
    def features(self):
        """What can tell this run from others, in words."""
        segregation, numerics = self.options["segregation"], self.options["numerics"]
        return {
            "case": self.case or f"filled to {self.options['geometry']['fill_depth']:g} of 2R",
            "filter": {"none": "no filter", "shepard": "Shepard filter"}.get(
                numerics["stress_filter"], f"{numerics['stress_filter']} filter"),
            "viscosity": rf"$\alpha c_s = {numerics['viscosity_speed']:g}$ m/s",
            "volume": {"none": "no volume control"}.get(
                numerics["volume_control"], f"volume {numerics['volume_control']}"),
            "stiffness": f"stiffness {self.options['material']['stiffness_factor']:g}",
            "spacing": rf"$\Delta r = {1000 * self.spacing:g}$ mm",
            "cfl": f"CFL {numerics['cfl']:g}",
            "scheme": {"hcsr": "HCSR"}.get(segregation["scheme"], segregation["scheme"]),
            "flux": f"{segregation['flux']} flux",
            "closure": f"closure {segregation['closure']}",
            "filling": f"filled by {numerics['filling']}",
            "dimension": f"{numerics['dimension']}D",
            "precision": numerics["precision"],
            "speed": f"{self.options['geometry']['rotation_speed']:g} rpm",
        }


class Frames:
    """The stored states of all particles."""

    def __init__(self, run):
        self.spacing, self.states = run.spacing, view.Run(run.directory / "particles.vtkhdf")
        self.times = self.states.times
        if not len(self.times):
            raise PlotError(f"{run.directory}/particles.vtkhdf holds no state")

    def nearest(self, time):
        return int(np.argmin(np.abs(self.times - time)))

    def points(self, k):
        """x, y, z of all particles, m."""
        return self.states[k].points

    def field(self, name, k):
        return self.states[k][name]

    def slab(self, k, body):
        """Which particles of the material (0) or the wall (1) to draw: in 3D one layer in the middle of the length."""
        y = self.points(k)[:, 1] / self.spacing
        return (self.field("body", k) == body) & (y > -0.25) & (y < 0.75)


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
        return [", ".join(runs[0].features[name] for name in ["case", "spacing", "stiffness"] if name not in leave_out)]
    names = [name for name in runs[0].features if name not in leave_out]
    telling = [name for name in names if len({run.features[name] for run in runs}) > 1]
    return [", ".join(run.features[name] for name in telling) or run.directory.name for run in runs]


def chosen_times(run, wanted):
    """Times of the run's profiles: those wanted that there are, or else the last ones."""
    times = run.profile_times
    return [time for time in wanted if time in times] or times[-len(wanted):]


def steady_time(run):
    """20 s, as in the paper; the end of a run that did not get there."""
    return run.frames.times[run.frames.nearest(20)]


# ----------------------------------------------------------------------------------------------- parts of the pictures


def drum_axes(runs, panels=None):
    """A figure with a drum in each panel, all at the same scale, in mm; cut off above the highest bed."""
    panels = panels or len(runs)
    columns = min(panels, 3)
    rows = -(-panels // columns)
    reach = 1000 * max(run.radius + 3.2 * run.spacing for run in runs)
    levels = [1000 * run.radius * (2 * run.options["geometry"]["fill_depth"] - 0.45) for run in runs]
    top = min(reach, max(levels))
    width = [6.2, 4.9, 3.7][columns - 1]
    height = rows * (0.92 * width * (reach + top) / (2 * reach) + 0.5)
    figure, all_axes = plt.subplots(rows, columns, figsize=(width * columns + 0.9, height), squeeze=False)
    for axes in all_axes.flat[panels:]:
        axes.set_axis_off()
    for axes in all_axes.flat[:panels]:
        axes.set(xlim=(-reach, reach), ylim=(-reach, top), aspect="equal")
        axes.tick_params(labelsize=8)
        axes.set_xlabel("mm", fontsize=9)
    return figure, list(all_axes.flat[:panels])


def draw_particles(axes, run, k, chosen, **how):
    """`colour` for all, or `values` with cmap and limits."""
    points = 1000 * run.frames.points(k)[chosen][:, [0, 2]]
    colour = how.get("colour")
    size = np.full(len(points), 1000 * (0.96 if colour else 1.2) * run.spacing)  # a field without gaps
    collection = EllipseCollection(size, size, np.zeros(len(points)), units="xy", offsets=points,
                                   transOffset=axes.transData, facecolors=colour, edgecolors="none")
    if colour is None:
        collection.set(array=how["values"], cmap=how["cmap"], clim=how["limits"])
    axes.add_collection(collection)
    return collection


def draw_field(axes, run, k, values, **how):
    material = run.frames.slab(k, 0)
    draw_particles(axes, run, k, run.frames.slab(k, 1), colour=WALL_COLOUR)
    return draw_particles(axes, run, k, material, values=values[material], **how)


def marker(colour, label):
    return Line2D([], [], marker="o", ls="", ms=7, color=colour, label=label)


def letters(texts):
    return [f"({letter})  {text}" for letter, text in zip("abcdefghijkl", texts)]


def legend_below(figure, handles, columns):
    inches = 0.2 + 0.24 * -(-len(handles) // columns)
    share = inches / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, share, 1, 1 - share))
    figure.legend(handles=handles, loc="lower center", ncol=columns)


class Chord:
    """The frame of the surface: s along it, downhill, and depth, m. As the recorder does it."""

    def __init__(self, run, k):
        self.run, (self.angle, self.height) = run, run.surface(run.frames.times[k])

    def coordinates(self, points):
        x, z = self.run.side * points[:, 0], points[:, 2]
        c, s = np.cos(self.angle), np.sin(self.angle)
        return x * c - z * s, self.height - (x * s + z * c)

    def points(self, s, depth):
        """x, z in mm."""
        up, c, sine = self.height - depth, np.cos(self.angle), np.sin(self.angle)
        return 1000 * self.run.side * (s * c + up * sine), 1000 * (up * c - s * sine)

    def excess(self, velocity, depth):
        along = self.run.side * velocity[:, 0] * np.cos(self.angle) - velocity[:, 2] * np.sin(self.angle)
        return along - self.run.omega * (self.height - depth)


def layers(run, k):
    """Depths over s of the rigid body limit (excess over rigid rotation 5 % of that at the surface in the middle) and of
    the largest shear rate: s, limit, peak."""
    chord, chosen = Chord(run, k), run.frames.slab(k, 0)
    s, depth = (values[chosen] for values in chord.coordinates(run.frames.points(k)))
    excess = chord.excess(run.frames.field("velocity", k)[chosen], depth)
    shear = run.frames.field("shear_rate", k)[chosen]
    half = np.sqrt(run.radius ** 2 - chord.height ** 2)
    limit = 0.05 * np.mean(excess[(np.abs(s) < 0.1 * run.radius) & (depth < max(1e-3, run.spacing))])
    found = []
    for centre in np.arange(-0.9, 0.901, 0.1) * half:
        bins, w, g = strip_means(np.abs(s - centre) < 0.08 * half, depth, excess, shear, run.spacing)
        below = np.flatnonzero(w < limit)
        if len(below) and below[0] > 0:
            found.append((centre, bins[below[0]], bins[np.argmax(np.where(bins < bins[below[0]], g, -1))]))
    return chord, np.array(found).reshape(-1, 3).T


def strip_means(strip, depth, excess, shear, spacing):
    number = np.maximum(depth[strip] / spacing, 0).astype(int)
    count = np.bincount(number)
    full = count > 0
    with np.errstate(invalid="ignore"):
        means = [np.bincount(number, values[strip]) / count for values in (depth, excess, shear)]
    return [mean[full] for mean in means]


def smooth(values):
    """Mean of three neighbours."""
    padded = np.concatenate([values[:1], values, values[-1:]])
    return (padded[:-2] + padded[1:-1] + padded[2:]) / 3


def draw_layers(axes, run, k, with_peak=False):
    chord, (s, limit, peak) = layers(run, k)
    handles = []
    if len(s) > 2:
        handles += axes.plot(*chord.points(s, smooth(limit)), "--", color="#E8590C", lw=1.8, label="rigid body limit")
        if with_peak:
            handles += axes.plot(*chord.points(s, smooth(peak)), ":", color="black", lw=2.2, label="largest shear rate")
    ends = np.array([0.0, chord.height + run.radius])
    handles += axes.plot(*chord.points(0 * ends, ends), "-.", color="0.35", lw=1, label="mid-chord")
    return handles


# ------------------------------------------------------------------------------------------------------------- figures


def figure_16(runs):
    """Vertical stress at 0.01 s with and without filter and artificial viscosity, one panel per run."""
    figure, panels = drum_axes(runs)
    largest = 1.5 * max(run.options["material"]["density"] * 9.81 * 2 * run.radius *
                        run.options["geometry"]["fill_depth"] for run in runs)
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        k = run.frames.nearest(0.01)
        image = draw_field(axes, run, k, run.frames.field("stress", k)[:, 2], cmap="viridis", limits=(-largest, 0))
        axes.set_title(f"{label}, t = {run.frames.times[k]:.3g} s")
    figure.colorbar(image, ax=panels, shrink=0.8, label=r"$\sigma_{zz}$ (Pa)")
    return figure


def figure_17(runs):
    """Velocity with the rigid body limit and the mid-chord."""
    figure, panels = drum_axes(runs)
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        k = run.frames.nearest(steady_time(run))
        velocity = 100 * run.frames.field("velocity", k)
        speed = np.linalg.norm(velocity, axis=1)
        image = draw_field(axes, run, k, speed, cmap="viridis", limits=(0, 7))
        draw_arrows(axes, run, k, velocity)
        handles = draw_layers(axes, run, k)
        axes.set_title(f"{label}, t = {run.frames.times[k]:g} s")
    figure.colorbar(image, ax=panels, shrink=0.8, label="speed (cm/s)", extend="max")
    legend_below(figure, handles, 3)
    return figure


def draw_arrows(axes, run, k, velocity):
    points = run.frames.points(k)
    chosen = run.frames.slab(k, 0) & spread(points[:, [0, 2]], run.frames.slab(k, 0), 0.12 * run.radius)
    axes.quiver(*1000 * points[chosen][:, [0, 2]].T, *velocity[chosen][:, [0, 2]].T, color="black", angles="xy",
                scale_units="xy", units="xy", scale=0.6, width=0.25, headwidth=4, headlength=4, headaxislength=3.6)


def spread(points, chosen, distance):
    """Those of the chosen that are not closer than the distance to one already taken."""
    taken = []
    for i in np.flatnonzero(chosen):
        if not taken or np.hypot(*(points[taken] - points[i]).T).min() > distance:
            taken.append(i)
    return np.isin(np.arange(len(points)), taken)


def figure_18(runs):
    """Shear rate with the rigid body limit and the surface of largest shear."""
    figure, panels = drum_axes(runs)
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        k = run.frames.nearest(steady_time(run))
        image = draw_field(axes, run, k, run.frames.field("shear_rate", k), cmap="magma", limits=(0, 12))
        handles = draw_layers(axes, run, k, with_peak=True)
        axes.set_title(f"{label}, t = {run.frames.times[k]:g} s")
    figure.colorbar(image, ax=panels, shrink=0.8, label=r"$\dot\gamma$ (1/s)", extend="max")
    legend_below(figure, handles, 3)
    return figure


def profile_axes(panels, ylabel):
    figure, axes = plt.subplots(1, panels, figsize=(4.9 * panels if panels < 3 else 3.9 * panels, 4), sharey=True,
                                squeeze=False)
    for one in axes[0]:
        one.set(xlabel=DEPTH_LABEL, xlim=(0, 1))
        one.axhline(0, color="0.8", lw=0.8, zorder=0)
    axes[0, 0].set_ylabel(ylabel)
    return figure, axes[0]


def figure_19(runs):
    """Shear rate along the mid-chord at four times."""
    figure, panels = profile_axes(len(runs), r"$\dot\gamma$ (1/s)")
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        for time, colour in zip(chosen_times(run, [10.0, 20.0, 30.0, 40.0]), COLOURS):
            profile = run.profile(time)
            axes.plot(profile["depth_over_D"], profile["shear_rate"], "o-", color=colour, ms=3, lw=1.3,
                      label=f"$t = {time:g}$ s")
        axes.set_title(label)
        axes.legend()
    return figure


def velocity_figure(runs):
    """Speed along the mid-chord at 20, 30 and 40 s, one panel per time, one line per run."""
    times = chosen_times(runs[0], [20.0, 30.0, 40.0])
    figure, panels = profile_axes(len(times), "speed (cm/s)")
    for axes, time, title in zip(panels, times, letters(f"$t = {time:g}$ s" for time in times)):
        for run, label, colour, dash in zip(runs, labels(runs), COLOURS, DASHES * 2):
            if time in run.profile_times:
                profile = run.profile(time)
                axes.plot(profile["depth_over_D"], 100 * profile["speed"], dash, color=colour, lw=1.6, label=label)
        profile = runs[0].profile(time)
        rigid = 100 * runs[0].omega * np.abs(profile["surface_height"] - profile["depth"])
        axes.plot(profile["depth_over_D"], rigid, color="0.6", lw=1, label="rigid rotation")
        dem = DEM_SURFACE_SPEED.get((runs[0].case, time))
        if dem:
            axes.plot(0, dem, "k*", ms=11, clip_on=False, ls="", label="DEM at the surface, as quoted")
        axes.set_title(title)
    legend_below(figure, unique_handles(panels), 2)
    return figure


def unique_handles(panels):
    handles = {}
    for axes in panels:
        for handle, label in zip(*axes.get_legend_handles_labels()):
            handles.setdefault(label, handle)
    return list(handles.values())


def figure_22(runs):
    """Surface sets."""
    figure, panels = drum_axes(runs)
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        k = run.frames.nearest(steady_time(run))
        bits, left = run.frames.field("surface_set", k), run.frames.slab(k, 0)
        for bit, _, colour in SURFACE_SETS:
            chosen = left & ((bits & bit == bit) if bit else True)
            draw_particles(axes, run, k, chosen, colour=colour)
            left = left & ~chosen
        draw_particles(axes, run, k, run.frames.slab(k, 1), colour=WALL_COLOUR)
        axes.set_title(f"{label}, t = {run.frames.times[k]:g} s")
    handles = [marker(colour, name) for _, name, colour in SURFACE_SETS] + [marker(WALL_COLOUR, "fictitious")]
    legend_below(figure, handles, 3)
    return figure


def figure_23(runs):
    """Normals of the boundary particles."""
    figure, panels = drum_axes(runs)
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        k = run.frames.nearest(steady_time(run))
        draw_particles(axes, run, k, run.frames.slab(k, 0), colour="#E4E4E4")
        draw_particles(axes, run, k, run.frames.slab(k, 1), colour="#B4B4B4")
        draw_normals(axes, run, k)
        axes.set_title(f"{label}, t = {run.frames.times[k]:g} s")
    legend_below(figure, [Line2D([], [], color=c, lw=2, label=text) for _, text, c in NORMALS], 2)
    return figure


def draw_normals(axes, run, k):
    outermost = run.frames.slab(k, 0) & (run.frames.field("surface_set", k) & (1 | 4) > 0)
    points, length = 1000 * run.frames.points(k)[:, [0, 2]], 1000 * 0.1 * run.radius
    for name, _, colour in NORMALS:
        normal = run.frames.field(name, k)[:, [0, 2]]
        drawn = outermost & (np.hypot(*normal.T) > 0.5)
        axes.quiver(*points[drawn].T, *normal[drawn].T, color=colour, angles="xy", scale_units="xy", units="xy",
                    scale=1 / length, width=0.06 * length, headwidth=3.5, headlength=4, headaxislength=3.6)


def snapshots_figure(runs):
    """C at several times, of the first run."""
    run = runs[0]
    times = sorted({run.frames.times[run.frames.nearest(time)] for time in [0, 5, 10, 20, 30, 40]})
    figure, panels = drum_axes(runs, panels=len(times))
    C0 = run.options["segregation"]["C0"]
    high = 1.0 if C0 > 0.3 else 3 * C0
    for axes, time, title in zip(panels, times, letters(f"$t = {time:g}$ s" for time in times)):
        k = run.frames.nearest(time)
        image = draw_field(axes, run, k, run.frames.field("concentration", k), cmap=GRAINS, limits=(0, high))
        axes.set_title(title)
    figure.colorbar(image, ax=panels, shrink=0.7, label="$C$ of small grains", extend="neither" if high == 1 else "max")
    return figure


def sizes(run):
    """Diameters of a list of sizes, m; empty for small and large grains."""
    return run.options.get("species", {}).get("diameters", [])


def species_figure(runs):
    """Each size of the list, in a row, at the start, after half and at the end of the first run."""
    run = runs[0]
    states = [0, run.frames.nearest(run.frames.times[-1] / 2), len(run.frames.times) - 1]
    figure, panels = drum_axes(runs, panels=3 * len(sizes(run)))
    shown = [(diameter, k, run.frames.field(f"concentration_{number}", k))
             for number, diameter in enumerate(sizes(run), 1) for k in states]
    high = max(float(values.max()) for _, _, values in shown)
    for axes, (diameter, k, values) in zip(panels, shown):
        image = draw_field(axes, run, k, values, cmap=GRAINS, limits=(0, high))
        axes.set_title(f"{1000 * diameter:g} mm, $t = {run.frames.times[k]:g}$ s")
    figure.colorbar(image, ax=panels, shrink=0.7, label="$C$ of each size")
    return figure


def figure_26(runs):
    """C along the mid-chord."""
    figure, panels = profile_axes(len(runs), "$C$")
    for axes, run, label in zip(panels, runs, letters(labels(runs))):
        for time, colour in zip(chosen_times(run, [5.0, 10.0, 20.0, 40.0]), COLOURS):
            profile = run.profile(time)
            axes.plot(profile["depth_over_D"], profile["C"], "o-", color=colour, ms=3, lw=1.3, label=f"$t = {time:g}$ s")
        axes.axhline(run.options["segregation"]["C0"], color="0.6", lw=1, ls=":")
        axes.set_title(label)
        axes.legend()
    return figure


def figure_27(runs):
    """Mean C over time, and its drift on a logarithmic scale."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10.2, 3.8 + 0.12 * len(runs)), sharex=True)
    for run, label, colour in zip(runs, labels(runs), COLOURS):
        t, mean = run.history["time"], run.history["C_mean"]
        drift = np.maximum.accumulate(np.abs(mean - mean[0]))
        left.plot(t, mean, color=colour, lw=1.6, label=label)
        some = slice(None, None, max(1, len(t) // 20))
        left.plot(t[some], np.full_like(t[some], mean[0]), "o", color=colour, mfc="none", ms=5)
        right.semilogy(t, np.where(drift > 0, drift, np.nan), color=colour, lw=1.6)
    left.set(xlabel="$t$ (s)", ylabel="mean $C$")
    left.set_ylim(0, max(0.6, left.get_ylim()[1]))
    exact = Line2D([], [], color="0.3", marker="o", mfc="none", ms=5, ls="", label="exact: constant")
    right.set(xlabel="$t$ (s)", ylabel="largest drift of mean $C$ up to $t$")
    right.set_ylim(bottom=1e-18)
    legend_below(figure, left.get_legend_handles_labels()[0] + [exact], 2)
    return figure


def rates_figure(runs):
    """dC/dt along the mid-chord and its three parts, of the first run; those of others dashed."""
    times = chosen_times(runs[0], [5.0, 10.0, 20.0, 40.0])
    figure, axes = plt.subplots(1, len(times), figsize=(3.2 * len(times) + 0.6, 3.9), sharey=True, squeeze=False)
    for one, time, title in zip(axes[0], times, letters(f"$t = {time:g}$ s" for time in times)):
        for run, dash in zip(runs, DASHES):
            if time in run.profile_times:
                draw_rates(one, run.profile(time), dash, with_sum=run is runs[0])
        one.axhline(0, color="0.8", lw=0.8, zorder=0)
        if runs[0].case == "EN":
            one.axvline(RATE_VANISHES, color="0.5", lw=1, ls=":", label=r"paper: $\dot C_1 = 0$ beyond")
        one.set(xlabel=DEPTH_LABEL, xlim=(0, 0.6), title=title)
    axes[0, 0].set_ylabel("$dC/dt$ (1/s)")
    handles = unique_handles(axes[0])
    if len(runs) > 1:
        handles += [Line2D([], [], color="0.3", ls=dash, label=label) for dash, label in zip(DASHES, labels(runs))]
    legend_below(figure, handles, 3)
    return figure


def draw_rates(axes, profile, dash, with_sum):
    total = sum(profile[name] for name, _, _ in RATES)
    for name, label, colour in RATES:
        axes.plot(profile["depth_over_D"], profile[name], dash, color=colour, lw=1.5,
                  label=label if with_sum else None)
    if with_sum:
        axes.plot(profile["depth_over_D"], total, "o", color="0.2", ms=3, label=r"$\dot C$: their sum")


HISTORY = [("angle", "surface angle (degrees)", 1), ("surface_speed", "surface speed (cm/s)", 100),
           ("bed_depth", "bed depth at mid-chord (mm)", 1000), ("number_density", "number density, interior mean", 1),
           ("number_density_min", "number density, least of the interior", 1),
           ("zero_stress_fraction", "share of particles without stress", 1), ("centroid_z", "centroid $z$ (mm)", 1000),
           ("largest_radius", "largest radius (mm)", 1000), ("C_deviation", "standard deviation of $C$", 1)]


def history_figure(runs):
    """What tells whether a bed is steady and keeps its volume."""
    figure, panels = plt.subplots(3, 3, figsize=(12, 8.4), sharex=True)
    for axes, (name, title, scale) in zip(panels.flat, HISTORY):
        for run, label, colour in zip(runs, labels(runs), COLOURS):
            axes.plot(run.history["time"], scale * run.history[name], color=colour, lw=1, label=label)
        axes.set_title(title, fontsize=10)
    for axes in panels[-1]:
        axes.set_xlabel("$t$ (s)")
    legend_below(figure, panels[0, 0].get_legend_handles_labels()[0], 2)
    return figure


# ---------------------------------------------------------------------------------------------------- which to draw


def numbers_by_case(run):
    """The paper has one figure each for EV and EN of velocity, snapshots and rates."""
    return {"velocity": 21, "snapshots": 25, "rates": 28} if run.case == "EN" else \
           {"velocity": 20, "snapshots": 24, "rates": 29}


def all_figures(runs):
    own = numbers_by_case(runs[0])
    if sizes(runs[0]):  # no rates, and no C of small grains
        return {"16": figure_16, "17": figure_17, "18": figure_18, "19": figure_19, "20": velocity_figure,
                "22": figure_22, "23": figure_23, "history": history_figure, "species": species_figure}
    return {"16": figure_16, "17": figure_17, "18": figure_18, "19": figure_19, str(own["velocity"]): velocity_figure,
            "22": figure_22, "23": figure_23, str(own["snapshots"]): snapshots_figure, "26": figure_26,
            "27": figure_27, str(own["rates"]): rates_figure, "history": history_figure}


def fitting_figures(runs):
    """Figure 16 is that of a run of a moment; the others need a flow."""
    if runs[0].frames.times[-1] < 0.1:
        return ["16"]
    needs_profiles = {"19", "20", "21", "26", "28", "29"}
    return [name for name in all_figures(runs) if name != "16" and (name not in needs_profiles or runs[0].profile_times)]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("results", metavar="RESULTS_DIR", help="directory that drum wrote (its --output)")
    parser.add_argument("--compare", metavar="OTHER_DIR", nargs="+", default=[], help="more of them, drawn beside it")
    parser.add_argument("--figure", nargs="+", help="numbers of figures in the paper, history, or species for a list of sizes; without it, those "
                        "for which the runs have the data")
    parser.add_argument("--output", type=Path, help="directory of the pictures; without it RESULTS_DIR")
    return parser.parse_args()


def save(figure, path):
    """With a palette of 256 colours: a third of the size."""
    buffer = io.BytesIO()
    figure.savefig(buffer)
    picture = Image.open(buffer).convert("RGB")
    picture.quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE).save(path, optimize=True)
    plt.close(figure)


def main():
    arguments = parse_arguments()
    runs = [Run(directory) for directory in [arguments.results, *arguments.compare]]
    known = all_figures(runs)
    directory = arguments.output or runs[0].directory
    directory.mkdir(parents=True, exist_ok=True)
    for name in arguments.figure or fitting_figures(runs):
        if name not in known:
            raise PlotError(f"no figure {name} of these results; there are {', '.join(known)}")
        path = directory / (f"figure_{name}.png" if name.isdigit() else f"{name}.png")
        save(known[name](runs), path)
        print(path)


if __name__ == "__main__":
    try:
        main()
    except (PlotError, OSError) as error:
        sys.exit(f"plot.py: {error}")
