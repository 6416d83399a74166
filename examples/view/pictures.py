# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Pictures and films of a run, tables as curves."""
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib import animation  # noqa: E402
from matplotlib.cm import ScalarMappable  # noqa: E402
from matplotlib.colors import Normalize  # noqa: E402
from PIL import Image  # noqa: E402  (comes with matplotlib)

from .run import MATERIAL  # noqa: E402

WALL, WALL_COLOUR = 1, "#9a9a9a"


def label(run, name):
    unit = run.unit(name)
    return name.replace("_", " ") + ("" if unit == "1" else f" ({unit})")


def limits_of(run, name, frames):
    """Range of a scalar over some states: percentiles 1 and 99, so that single particles do not set the colours."""
    values = np.concatenate([run[k].material.scalar(name) for k in frames]) if len(run) else np.zeros(1)
    values = values[np.isfinite(values)]
    if not len(values):
        return 0.0, 1.0
    low, high = np.percentile(values, [1, 99])
    return (low, high) if high > low else (values.min(), values.max() if values.max() > values.min() else values.min() + 1)


def limits_of_run(run, name):
    """Over the whole run: all pictures of it have the same colours."""
    return limits_of(run, name, np.unique(np.linspace(0, len(run) - 1, min(40, len(run))).round().astype(int)))


def bounds_of(run):
    """Box around the material and rigid bodies at all times, and around the walls as far as they are near them."""
    ends = sorted({0, len(run) - 1})
    walls = [run[k].points[run[k]["body"] == WALL] for k in ends] if "body" in run.fields else []
    frames = [run[k] for k in sorted({*range(0, len(run), 5), *ends})]
    points = np.concatenate([each.points[each["body"] != WALL] if walls else each.points for each in frames])
    walls = np.concatenate(walls) if walls else np.empty((0, 3))
    points = points if len(points) else walls
    low, high = points.min(axis=0), points.max(axis=0)
    if len(walls):
        reach = 0.6 * max(high - low)
        low, high = (np.minimum(low, np.maximum(walls.min(axis=0), low - reach)),
                     np.maximum(high, np.minimum(walls.max(axis=0), high + reach)))
    return low - run.spacing, high + run.spacing


class PlaneDrawing:
    """Particles of a plane on an axis of matplotlib, coloured by a scalar; walls grey."""

    def __init__(self, axis, run, name, limits, bounds):
        self.axis, self.run, self.name = axis, run, name
        low, high = bounds
        axis.set(xlim=(low[0], high[0]), ylim=(low[2], high[2]), aspect="equal", xlabel="x (m)", ylabel="z (m)")
        axis.figure.canvas.draw()
        width = axis.get_window_extent().width / axis.figure.dpi * 72 / (high[0] - low[0]) * run.spacing  # points
        height = axis.get_window_extent().height / axis.figure.dpi * 72 / (high[2] - low[2]) * run.spacing
        size = max(min(width, height), 0.5) ** 2
        self.walls = axis.scatter([], [], s=size, c=WALL_COLOUR, linewidths=0)
        self.dots = axis.scatter([], [], s=size, c=[], cmap="viridis", vmin=limits[0], vmax=limits[1], linewidths=0)

    @staticmethod
    def extent(bounds):
        low, high = bounds
        return high[0] - low[0], high[2] - low[2]

    def show(self, frame):
        material = frame.material
        self.dots.set_offsets(material.points[:, [0, 2]])
        self.dots.set_array(material.scalar(self.name))
        if "body" in self.run.fields:
            self.walls.set_offsets(frame.where(frame["body"] != MATERIAL).points[:, [0, 2]])
        self.axis.set_title(f"t = {frame.time:.4g} s", fontsize=10)


class SpaceDrawing:
    """Particles of space as spheres with light from above on the left, seen from in front and above, without perspective.
    Walls are dots through which the material is seen. A bar shows the scale."""

    TURN, TILT, WIDTH = 0.6, 0.35, 700  # rad; pixels
    LIGHT = np.array([-0.4, 0.7, 0.8]) / np.linalg.norm([-0.4, 0.7, 0.8])

    def __init__(self, axis, run, name, limits, bounds):
        self.axis, self.run, self.name = axis, run, name
        low, high = bounds
        self.middle = (low + high) / 2
        self.size = self.extent(bounds)
        self.pixels = self.WIDTH / self.size[0]  # per m
        self.scale = ScalarMappable(Normalize(*limits), "viridis")
        self.dots = self.scale  # of the colour bar
        self.image = axis.imshow(np.ones((2, 2, 3)), extent=(0, self.size[0], 0, self.size[1]), interpolation="antialiased")
        axis.set(xticks=[], yticks=[])
        axis.spines[:].set_visible(False)
        most = 0.3 * self.size[0]
        length = next(n * 10 ** np.floor(np.log10(most)) for n in (5, 2, 1) if n * 10 ** np.floor(np.log10(most)) <= most)
        right, below = 0.98 * self.size[0], 0.02 * self.size[1]
        axis.plot([right - length, right], [below, below], color="#333", lw=1.5)
        axis.text(right - length / 2, below, f"{length * 1e3:g} mm" if length < 1 else f"{length:g} m", ha="center", va="bottom", fontsize=8)

    @classmethod
    def axes(cls):
        (c, s), (ct, st) = ((np.cos(a), np.sin(a)) for a in (cls.TURN, cls.TILT))
        return np.array([[c, s, 0], [-s * st, c * st, ct], [s * ct, -c * ct, st]])  # right, up, towards the eye

    @classmethod
    def extent(cls, bounds):
        low, high = bounds
        return tuple(np.abs(cls.axes()[:2]) @ (high - low))

    def show(self, frame):
        shape = int(np.ceil(self.size[1] * self.pixels)), self.WIDTH
        picture, depth = np.ones((*shape, 3)), np.full(shape, -np.inf)
        material = frame.material
        self._paint(picture, depth, material.points, self.scale.to_rgba(material.scalar(self.name))[:, :3], 0.55)
        if "body" in self.run.fields:
            walls = frame.where(frame["body"] != MATERIAL).points
            self._paint(picture, depth, walls, np.full((len(walls), 3), 0.55), 0.12)
        self.image.set_data(picture)
        self.axis.set_title(f"t = {frame.time:.4g} s", fontsize=10)

    def _paint(self, picture, depth, points, colours, radius):
        radius = max(radius * self.run.spacing * self.pixels, 0.7)
        x, y, z = self.axes() @ (points - self.middle).T * self.pixels
        x, y = x + picture.shape[1] / 2, picture.shape[0] / 2 - y
        reach = range(-int(radius) - 1, int(radius) + 2)
        passes = []
        for down in reach:  # each sphere covers these pixels around its middle
            for right in reach:
                column, row = np.floor(x).astype(int) + right, np.floor(y).astype(int) + down
                across, up = (column + 0.5 - x) / radius, (y - row - 0.5) / radius
                seen = (across ** 2 + up ** 2 <= 1) & (column >= 0) & (column < picture.shape[1]) & (row >= 0) & (row < picture.shape[0])
                which = np.flatnonzero(seen)
                front = np.sqrt(1 - across[which] ** 2 - up[which] ** 2)
                normals = np.stack([across[which], up[which], front])
                passes.append((row[which], column[which], z[which] + radius * front, which, normals))
                np.maximum.at(depth, (row[which], column[which]), z[which] + radius * front)
        for row, column, near, which, normals in passes:
            top = near >= depth[row, column]
            light = 0.45 + 0.55 * np.maximum(self.LIGHT @ normals[:, top], 0)
            picture[row[top], column[top]] = colours[which[top]] * light[:, None]


def drawing_of(run):
    return PlaneDrawing if run.dimension == 2 else SpaceDrawing


def picture(run, name, path, count=4, times=None):
    """`count` states, evenly from the first to the last one, or those nearest to `times` (s), as a PNG, PDF or SVG."""
    frames = (np.unique(np.linspace(0, len(run) - 1, min(count, len(run))).round().astype(int)) if times is None
              else np.array([run.at(time).number for time in times]))
    bounds, kind = bounds_of(run), drawing_of(run)
    width, height = kind.extent(bounds)
    aspect = height / width
    # As near as possible to a figure of 3 : 4, without gaps.
    divisors = [n for n in range(1, len(frames) + 1) if len(frames) % n == 0]
    columns = min(divisors, key=lambda n: abs(np.log(len(frames) / n ** 2 * (aspect + 0.15) / 0.75)))
    rows = len(frames) // columns
    size = 8 / columns
    figure, axes = plt.subplots(rows, columns, figsize=(8.6, min(rows * (size * aspect + 0.75), 14)), squeeze=False,
                                layout="compressed", sharex=True, sharey=True)
    limits = limits_of_run(run, name)
    drawings = [kind(axis, run, name, limits, bounds) for axis, _ in zip(axes.flat, frames)]
    for drawing, k in zip(drawings, frames):
        drawing.show(run[k])
        drawing.axis.label_outer()
    figure.colorbar(drawings[0].dots, ax=axes, label=label(run, name), shrink=0.8)
    figure.savefig(path, dpi=100, bbox_inches="tight", pad_inches=0.05)
    plt.close(figure)
    if str(path).endswith(".png"):
        with Image.open(path) as image:  # a third of the size, with 256 colours
            small = image.convert("RGB").quantize(256, method=Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        small.save(path, optimize=True)


def film(run, name, path, frames_per_second=15, inches=8.0):
    """All states, as MP4 (with ffmpeg), GIF or WebP, `inches` wide at 100 pixels each."""
    bounds, kind = bounds_of(run), drawing_of(run)
    width, height = kind.extent(bounds)
    figure, axis = plt.subplots(figsize=(inches, np.clip(0.65 * inches * height / width + 0.8, 2, 10)), layout="constrained")
    drawing = kind(axis, run, name, limits_of_run(run, name), bounds)
    figure.colorbar(drawing.dots, ax=axis, label=label(run, name))
    kind_of_file = str(path).rpartition(".")[2]
    if kind_of_file in ("gif", "webp"):
        _write_images(figure, drawing, run, path, frames_per_second)
    else:
        if not animation.writers.is_available("ffmpeg"):
            raise OSError("films other than .gif and .webp need ffmpeg; on Debian: apt-get install ffmpeg")
        writer = animation.FFMpegWriter(fps=frames_per_second, extra_args=["-pix_fmt", "yuv420p"])
        with writer.saving(figure, str(path), dpi=100):
            for frame in run:
                drawing.show(frame)
                writer.grab_frame()
    plt.close(figure)


def _write_images(figure, drawing, run, path, frames_per_second):
    images = []
    for frame in run:
        drawing.show(frame)
        figure.canvas.draw()
        images.append(Image.fromarray(np.asarray(figure.canvas.buffer_rgba())[..., :3].copy()))
    if str(path).endswith(".gif"):  # one palette for all, so that what stays as it is takes no room
        palette = images[len(images) // 2].quantize(128, dither=Image.Dither.NONE)
        images = [each.quantize(palette=palette, dither=Image.Dither.NONE) for each in images]
    more = {} if str(path).endswith(".gif") else {"quality": 60, "method": 6, "minimize_size": True}
    images[0].save(path, save_all=True, append_images=images[1:], duration=round(1000 / frames_per_second), loop=0, **more)


def curves(run, path):
    """Every column of every table that has a column `time`, against it."""
    tables = {name: columns for name, columns in run.tables.items() if "time" in columns and len(columns["time"]) > 1}
    panels = [(table, column) for table, columns in tables.items() for column in columns if column != "time"]
    if not panels:
        raise ValueError(f"{run.folder} has no table with a column `time`")
    rows = -(-len(panels) // 2)
    figure, axes = plt.subplots(rows, 2, figsize=(9, 2.2 * rows), squeeze=False, layout="constrained")
    for axis, (table, column) in zip(axes.flat, panels):
        units = run.table_units[table]
        axis.plot(tables[table]["time"], tables[table][column], color="#0072B2", lw=1)
        axis.set_title(column + ("" if units[column] == "1" else f" ({units[column]})"), fontsize=9)
        axis.set_xlabel(f"time ({units['time']})", fontsize=8)
        axis.tick_params(labelsize=8)
    for axis in axes.flat[len(panels):]:
        axis.set_visible(False)
    figure.savefig(path, dpi=100)
    plt.close(figure)
