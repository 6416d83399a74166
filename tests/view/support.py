# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""A file of particles whose numbers are known, as the library writes it."""
import sys
from pathlib import Path

import h5py
import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "examples"))

UNITS = {"velocity": "m/s", "stress": "Pa", "concentration": "1", "body": "1", "identity": "1"}


def write(path, steps):
    """`steps` is a list of (time, points, fields). Steps of the same number of particles as the one before share a part."""
    counts, parts = [], []
    for _, points, _ in steps:
        if not counts or counts[-1] != len(points):
            counts.append(len(points))
        parts.append(len(counts) - 1)
    starts = np.cumsum([0] + [len(points) for _, points, _ in steps])[:-1]
    with h5py.File(path, "w") as file:
        root = file.create_group("VTKHDF")
        root["NumberOfPoints"] = np.array(counts)
        root["Points"] = np.concatenate([points for _, points, _ in steps])
        stages = root.create_group("Steps")
        stages.attrs["NSteps"] = len(steps)
        stages["Values"] = [time for time, _, _ in steps]
        stages["PartOffsets"], stages["PointOffsets"] = parts, starts
        data, offsets = root.create_group("PointData"), stages.create_group("PointDataOffsets")
        for name in steps[0][2]:
            data[name] = np.concatenate([fields[name] for _, _, fields in steps])
            data[name].attrs["units"] = np.bytes_(UNITS.get(name, "1"))
            offsets[name] = starts


def block(columns=10, rows=8, spacing=0.01):
    """A block of material on a floor of three rows, in the plane."""
    x, z = np.meshgrid(np.arange(columns), np.arange(rows))
    floor_x, floor_z = np.meshgrid(np.arange(columns), np.arange(-3, 0))
    points = np.concatenate([np.column_stack([x.ravel(), 0 * x.ravel(), z.ravel()]),
                             np.column_stack([floor_x.ravel(), 0 * floor_x.ravel(), floor_z.ravel()])])
    return (points + [0.5, 0, 0.5]) * spacing, np.repeat([0, 1], [x.size, floor_x.size])


def box_in_space(columns=10, spacing=0.01):
    """A cube of material in a shell of three rows, in space."""
    places = np.stack(np.meshgrid(*[np.arange(-3, columns + 3)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
    inside = ((places >= 0) & (places < columns)).all(axis=1)
    return (places + 0.5) * spacing, np.where(inside, 0, 1)


def fields_of(points, body, time):
    """Velocity (z, 0, t), a stress with the pressure 100 z, C = 1 in the upper half of the material."""
    z, zero = points[:, 2], np.zeros(len(points))
    middle = z[body == 0].mean() if (body == 0).any() else 0
    stress = np.column_stack([-100 * z] * 3 + [zero] * 3)
    return {"velocity": np.column_stack([z, zero, zero + time]), "stress": stress,
            "concentration": np.where(z > middle, 1.0, 0.0), "body": body.astype(np.int32),
            "identity": np.arange(len(points))}


def falling_block(path, steps=4):
    """A block that moves to the right by a spacing per step; from the second step on its first particle is gone."""
    points, body = block()
    states = []
    for k in range(steps):
        moved = points + np.outer(body == 0, [0.01 * k, 0, 0])
        fields = fields_of(moved, body, 0.5 * k)
        keep = slice(1 if k > 1 else 0, None)
        states.append((0.5 * k, moved[keep], {name: values[keep] for name, values in fields.items()}))
    write(path, states)
    return states
