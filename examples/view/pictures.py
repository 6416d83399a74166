# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Pictures and films of a run, tables as curves."""
import matplotlib
import numpy as np

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib import animation  # noqa: E402
from PIL import Image  # noqa: E402  (comes with matplotlib)

WALL_COLOUR = "#9a9a9a"


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


def bounds_of(run):
    """Box around all particles of the first and the last state, and of the material between them."""
    points = [run[k].points for k in {0, len(run) - 1}] + [run[k].material.points for k in range(0, len(run), 5)]
    points = np.concatenate([each for each in points if len(each)])
    return points.min(axis=0) - run.spacing, points.max(axis=0) + run.spacing


def _visible(frame):
    """Order and positions in the picture: a plane as it is, space seen along y, particles in front last."""
    order = np.argsort(-frame.points[:, 1], kind="stable")
    return order, frame.points[order][:, [0, 2]]


class Drawing:
    """Particles on an axis of matplotlib, coloured by a scalar; walls grey."""

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

    def show(self, frame):
        material = frame.material
        order, positions = _visible(material)
        self.dots.set_offsets(positions)
        self.dots.set_array(material.scalar(self.name)[order])
        if "body" in self.run.fields and self.run.dimension == 2:  # in space walls would hide the material
            self.walls.set_offsets(frame.where(frame["body"] != 0).points[:, [0, 2]])
        self.axis.set_title(f"t = {frame.time:.4g} s", fontsize=10)
        return self.dots, self.walls


def picture(run, name, path, count=4):
    """`count` states, evenly from the first to the last one, as a PNG, PDF or SVG."""
    frames = np.unique(np.linspace(0, len(run) - 1, min(count, len(run))).round().astype(int))
    low, high = bounds_of(run)
    aspect = (high[2] - low[2]) / (high[0] - low[0])
    # As near as possible to a figure of 3 : 4, without gaps.
    divisors = [n for n in range(1, len(frames) + 1) if len(frames) % n == 0]
    columns = min(divisors, key=lambda n: abs(np.log(len(frames) / n ** 2 * (aspect + 0.15) / 0.75)))
    rows = len(frames) // columns
    size = 8 / columns
    figure, axes = plt.subplots(rows, columns, figsize=(8.6, min(rows * (size * aspect + 0.75), 14)), squeeze=False,
                                layout="compressed", sharex=True, sharey=True)
    limits = limits_of(run, name, frames)
    drawings = [Drawing(axis, run, name, limits, (low, high)) for axis, _ in zip(axes.flat, frames)]
    for axis in axes.flat[len(frames):]:
        axis.set_visible(False)
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


def film(run, name, path, frames_per_second=15):
    """All states, as MP4 (with ffmpeg) or GIF."""
    low, high = bounds_of(run)
    aspect = (high[2] - low[2]) / (high[0] - low[0])
    figure, axis = plt.subplots(figsize=(8, np.clip(7 * aspect + 0.9, 2, 10)), layout="constrained")
    drawing = Drawing(axis, run, name, limits_of(run, name, range(0, len(run), max(1, len(run) // 20))), (low, high))
    figure.colorbar(drawing.dots, ax=axis, label=label(run, name))
    is_gif = str(path).endswith(".gif")
    if not is_gif and not animation.writers.is_available("ffmpeg"):
        raise OSError("films other than .gif need ffmpeg; on Debian: apt-get install ffmpeg")
    writer = (animation.PillowWriter(fps=frames_per_second) if is_gif else
              animation.FFMpegWriter(fps=frames_per_second, extra_args=["-pix_fmt", "yuv420p"]))
    with writer.saving(figure, str(path), dpi=100):
        for frame in run:
            drawing.show(frame)
            writer.grab_frame()
    plt.close(figure)


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
