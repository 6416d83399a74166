# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""The stored states of a run and its tables."""
import csv
from functools import cached_property
from pathlib import Path

import h5py
import numpy as np

MATERIAL = 0  # of the field `body`


class Frame:
    """One stored state. Fields are read when they are asked for; frame["velocity"] has one row for each particle. A tensor of
    six components is xx, yy, zz, xy, yz, xz."""

    def __init__(self, run, number, keep=None):
        self.run, self.number, self._keep = run, number, keep

    @property
    def time(self):
        return self.run.times[self.number]

    @cached_property
    def points(self):
        """x, y, z in m. A run in the plane has y = 0."""
        return self._rows(self.run.root["Points"], self.run.first_points[self.number])

    def __getitem__(self, name):
        if name not in self.run.fields:
            raise KeyError(f"{self.run.path} has no field '{name}'; it has {', '.join(self.run.fields)}")
        first = self.run.root[f"Steps/PointDataOffsets/{name}"][self.number]
        return self._rows(self.run.root[f"PointData/{name}"], first)

    def __len__(self):
        return len(self.points)

    def _rows(self, data, first):
        values = data[first:first + self.run.counts[self.number]]
        return values if self._keep is None else values[self._keep]

    def where(self, keep):
        """The same state with the particles for which `keep` is true."""
        keep = np.flatnonzero(keep)
        return Frame(self.run, self.number, keep if self._keep is None else self._keep[keep])

    @property
    def material(self):
        """The particles of the material, without walls. All, if the file has no field `body`."""
        return self.where(self["body"] == MATERIAL) if "body" in self.run.fields else self

    def scalar(self, name):
        """A field as one number for each particle: the magnitude of a vector, the pressure of a stress, the norm of another
        tensor. "velocity.x" is a component, "stress.xz" that of a tensor; "pressure" of a run that stores only the stress
        is its pressure."""
        name, _, component = name.partition(".")
        if name == "pressure" and name not in self.run.fields and "stress" in self.run.fields:
            return -self["stress"][:, :3].mean(axis=1)
        values = self[name]
        if component:
            names = ["x", "y", "z"] if values.ndim > 1 and values.shape[1] == 3 else ["xx", "yy", "zz", "xy", "yz", "xz"]
            if values.ndim == 1 or component not in names:
                raise KeyError(f"'{name}' has no component '{component}'")
            return values[:, names.index(component)]
        if values.ndim == 1:
            return values
        if values.shape[1] == 6:
            return -values[:, :3].mean(axis=1) if name == "stress" else np.sqrt(values ** 2 @ [1, 1, 1, 2, 2, 2])
        return np.linalg.norm(values, axis=1)


class Run:
    """The results of a run: a folder with particles.vtkhdf and tables, or such a file. run[k] is its k-th stored state."""

    def __init__(self, path):
        path = Path(path)
        if path.is_dir():
            found = sorted(path.glob("*.vtkhdf"))
            names = [file.name for file in found]
            if not found:
                raise FileNotFoundError(f"{path} has no .vtkhdf file: not the results of a run")
            path = found[names.index("particles.vtkhdf")] if "particles.vtkhdf" in names else found[0]
        if not path.exists():
            raise FileNotFoundError(f"{path}: there is no such file or folder")
        if not h5py.is_hdf5(path) or "VTKHDF" not in (file := h5py.File(path, "r")):
            raise ValueError(f"{path} is no VTKHDF file")
        self.path, self.folder, self.root = path, path.parent, file["VTKHDF"]
        self.times, self.first_points, self.counts, self.fields = np.empty(0), [], np.empty(0, int), []
        if "Steps/Values" in self.root:
            self.times = self.root["Steps/Values"][:]
            self.first_points = self.root["Steps/PointOffsets"][:]
            # Steps of the same number of particles share a part.
            self.counts = self.root["NumberOfPoints"][:][self.root["Steps/PartOffsets"][:]]
            self.fields = list(self.root["PointData"])

    @cached_property
    def units(self):
        """Unit of each field; "1" if it has none."""
        def text(value):
            return value.decode() if isinstance(value, bytes) else str(value)
        return {name: text(self.root[f"PointData/{name}"].attrs.get("units", "1")) for name in self.fields}

    def unit(self, name):
        """Of a scalar of Frame.scalar()."""
        name = name.partition(".")[0]
        return "Pa" if name == "pressure" and name not in self.fields else self.units[name]

    def __len__(self):
        return len(self.times)

    def __getitem__(self, k):
        return Frame(self, range(len(self))[k])

    def __iter__(self):
        return (self[k] for k in range(len(self)))

    def at(self, time):
        """The stored state nearest to a time in s."""
        return self[int(np.argmin(np.abs(self.times - time)))]

    @cached_property
    def dimension(self):
        return 3 if any(np.any(self[k].points[:, 1]) for k in {0, len(self) - 1}) else 2

    @cached_property
    def spacing(self):
        """Distance of neighbours in the first state, m: the median over a sample of particles."""
        points = self[0].material.points
        sample = points[np.linspace(0, len(points) - 1, min(len(points), 100)).astype(int)]
        nearest = [np.partition(((points - x) ** 2).sum(axis=1), 1)[1] for x in sample] if len(points) > 1 else [1.0]
        return float(np.sqrt(np.median(nearest)))

    @cached_property
    def scalars(self):
        """Names for Frame.scalar() that are worth a picture: one for each field, without identity. Concentration and velocity,
        if there are any, come first."""
        names = [name for name in self.fields if name not in ("identity", "body")]
        if "stress" in names:
            names[names.index("stress")] = "pressure"
        first = [name for name in ("concentration", "concentration_1", "velocity") if name in names]
        return list(dict.fromkeys(first + names))

    @cached_property
    def tables(self):
        """Tables (CSV) of the folder by file name, each a dict from a column to an array. NaN stands for an empty cell."""
        return {path.name: read_table(path)[0] for path in sorted(self.folder.glob("*.csv"))}

    @cached_property
    def table_units(self):
        return {path.name: read_table(path)[1] for path in sorted(self.folder.glob("*.csv"))}


def read_table(path):
    """Columns of a table by name, and their units. The header has cells such as `force [N]`."""
    with open(path, encoding="utf8", newline="") as file:
        header, *rows = list(csv.reader(file)) or [[]]
    columns, units = {}, {}
    for k, cell in enumerate(header):
        name, _, unit = cell.partition(" [")
        units[name] = unit.rstrip("]") or "1"
        columns[name] = np.array([number(row[k]) if k < len(row) else np.nan for row in rows])
    return columns, units


def number(text):
    try:
        return float(text)
    except ValueError:
        return np.nan
