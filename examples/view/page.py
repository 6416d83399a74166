# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A run as one HTML file that needs neither server nor network.

Positions and scalars become whole numbers of 16 bits over their ranges. Where a state has the particles of the one before, the
differences are stored, which for walls are zero. Low and high bytes are kept apart and compressed."""
import base64
import json
import zlib
from datetime import datetime
from pathlib import Path

import numpy as np

STEPS = 65535  # of the ranges
MOST_FRAMES, FEWEST_FRAMES = 300, 60


class Packed:
    """Chosen states and particles of a run, as compressed numbers."""

    def __init__(self, run, scalars, frames, stride):
        self.run, self.scalars, self.frames, self.stride = run, scalars, frames, stride
        self.axes = [0, 2] if run.dimension == 2 else [0, 1, 2]
        self.ranges = self._ranges()
        self.counts, self.continues, columns = [], [], []
        before = None
        for k in frames:
            frame = run[k]
            keep = self._kept(frame)
            names = frame["identity"][keep] if "identity" in run.fields else None
            numbers = self._numbers(frame, keep)
            same = before is not None and numbers.shape == before[1].shape and (names is None or
                                                                                np.array_equal(names, before[0]))
            columns.append((numbers - before[1] if same else numbers).astype(np.uint16))
            self.counts.append(numbers.shape[1])
            self.continues.append(bool(same))
            before = (names, numbers)
        stream = np.concatenate([each.ravel() for each in columns]) if columns else np.zeros(0, np.uint16)
        bytes_apart = np.concatenate([(stream & 255).astype(np.uint8), (stream >> 8).astype(np.uint8)])
        self.data = base64.b64encode(zlib.compress(bytes_apart.tobytes(), 6)).decode()

    def _ranges(self):
        """Of the axes, of `body` and of the scalars, over the chosen states."""
        low, high = [], []
        for k in self.frames:
            values = self._values(self.run[k])
            values[~np.isfinite(values)] = np.nan
            low.append(np.nanmin(values, axis=1, initial=np.inf))
            high.append(np.nanmax(values, axis=1, initial=-np.inf))
        low, high = np.min(low, axis=0), np.max(high, axis=0)
        empty = ~np.isfinite(low)
        low[empty], high[empty] = 0, 1
        return np.stack([low, np.where(high > low, high, low + 1)], axis=1)

    def _values(self, frame):
        body = frame["body"] if "body" in self.run.fields else np.zeros(len(frame))
        rows = [frame.points[:, a] for a in self.axes] + [body] + [frame.scalar(name) for name in self.scalars]
        return np.array(rows, dtype=float)

    def _kept(self, frame):
        """Every stride-th particle. By identity where there is one, so that the same ones are kept when others come and go."""
        if "identity" in self.run.fields and self.stride > 1:
            return np.flatnonzero(frame["identity"] % self.stride == 0)
        return np.arange(0, len(frame), self.stride)

    def _numbers(self, frame, keep):
        values = self._values(frame)[:, keep]
        low, high = self.ranges[:, :1], self.ranges[:, 1:]
        values = np.where(np.isfinite(values), values, low)
        return np.rint((values - low) / (high - low) * STEPS).astype(np.int64)

    def identities(self):
        """Of the kept particles of each state, where they change their places; otherwise None."""
        if "identity" not in self.run.fields:
            return None
        return [None if same else self.run[k]["identity"][self._kept(self.run[k])].tolist()
                for k, same in zip(self.frames, self.continues)]


def title_of(run):
    """The folder of the run, or the name of its file, and the date of its results."""
    name = run.folder.resolve().name if run.path.stem == "particles" else run.path.stem
    return f"{name}, {datetime.fromtimestamp(run.path.stat().st_mtime):%Y-%m-%d %H:%M}"


def colour_range(run, name, frames):
    from .pictures import limits_of
    return [float(value) for value in limits_of(run, name, evenly(frames, 40))]


def histories(run):
    """Columns of the tables with a column `time`, to five digits, at most 500 rows."""
    found = []
    for table, columns in run.tables.items():
        if "time" not in columns or len(columns["time"]) < 2:
            continue
        step = -(-len(columns["time"]) // 500)
        for name, values in columns.items():
            if name != "time" and np.isfinite(values).any():
                units = run.table_units[table]
                found.append({"table": table, "name": name, "unit": units[name], "time_unit": units["time"],
                              "time": _short(columns["time"][::step]), "values": _short(values[::step])})
    return found


def _short(values):
    return [float(f"{value:.5g}") if np.isfinite(value) else None for value in values]


def write_page(run, path, scalars=None, megabytes=20.0, title=None):
    """Writes the page and returns (number of states, one particle in how many). States are left out first, down to 60, then
    particles, until the file is no larger than `megabytes`."""
    scalars = list(scalars or run.scalars)
    unknown = [name for name in scalars if name.partition(".")[0] not in [*run.fields, *run.scalars]]
    if unknown:
        raise KeyError(f"{run.path} has no field {', '.join(unknown)}; it has {', '.join(run.fields)}")
    if not len(run):
        raise ValueError(f"{run.path} has no stored state")
    frames, stride = evenly(range(len(run)), MOST_FRAMES), 1
    # What even eightfold compression cannot bring below the limit is not tried.
    rows, most = len(scalars) + 4, 4e6 * megabytes  # numbers of two bytes
    if run.counts[frames].sum() * rows > most:
        frames = evenly(frames, FEWEST_FRAMES)
        stride = max(1, int(run.counts[frames].sum() * rows / most))
    while True:
        packed = Packed(run, scalars, frames, stride)
        text = _html(run, packed, title or title_of(run))
        size = len(text.encode()) / 1e6
        if size <= megabytes:
            Path(path).write_text(text, encoding="utf8")
            return len(frames), stride
        if len(packed.data) < 1000:
            raise ValueError(f"a page has {size:.1f} MB without any particle: allow more than {megabytes:g} MB")
        excess = 1.1 * size / megabytes
        if len(frames) > FEWEST_FRAMES:
            frames = evenly(frames, max(FEWEST_FRAMES, int(len(frames) / excess)))
        else:
            stride = int(np.ceil(stride * excess))


def evenly(frames, most):
    """At most `most` of some states, the first and the last one included."""
    frames = list(frames)
    return [frames[k] for k in np.unique(np.linspace(0, len(frames) - 1, min(most, len(frames))).round().astype(int))]


def _html(run, packed, title):
    here = Path(__file__).resolve().parent
    files = here / "page_files"  # of a package
    if not files.is_dir():
        files = here.parents[1] / "src/app/page"  # programs write their previews with it, too
    units = [run.unit(name) for name in packed.scalars]
    meta = {
        "title": title, "dimension": run.dimension, "spacing": run.spacing * packed.stride ** (1 / run.dimension),
        "times": [float(f"{run.times[k]:.8g}") for k in packed.frames], "counts": packed.counts,
        "continues": packed.continues, "ranges": packed.ranges.tolist(), "stride": packed.stride,
        "scalars": [{"name": name, "unit": unit, "colours": colour_range(run, name, packed.frames)}
                    for name, unit in zip(packed.scalars, units)],
        "bodies": ["material", "wall", *(f"body {k}" for k in range(2, 100))][:int(packed.ranges[len(packed.axes), 1]) + 1]
                  if "body" in run.fields else ["material"],
        "identities": packed.identities(),
        "follows": "identity" in run.fields or len(set(packed.counts)) == 1, "histories": histories(run),
    }
    page = (files / "page.html").read_text(encoding="utf8")
    scripts = "\n".join((files / name).read_text(encoding="utf8") for name in ("colours.js", "axes.js", "particles.js", "page.js"))
    escaped = title.replace("&", "&amp;").replace("<", "&lt;")
    for mark, value in (("@title@", escaped), ("@scripts@", scripts), ("@data@", packed.data),
                        ("@meta@", json.dumps(meta, allow_nan=False).replace("</", "<\\/"))):
        page = page.replace(mark, value)
    return page
