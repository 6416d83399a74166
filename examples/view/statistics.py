# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Profiles, and measures of how mixed a bed is."""
import numpy as np

AXES = {"x": 0, "y": 1, "z": 2}


def profile(frame, name, along="z", bins=20, span=None):
    """Mean of a scalar over the material in equal bins along an axis: middles of the bins (m), means (NaN in empty bins),
    numbers of particles. `span` is (from, to) in m; without it, that of the particles."""
    frame = frame.material
    x, values = frame.points[:, AXES[along]], frame.scalar(name)
    edges = np.linspace(*(span or (x.min(), x.max())), bins + 1)
    counts, _ = np.histogram(x, edges)
    sums, _ = np.histogram(x, edges, weights=values)
    with np.errstate(invalid="ignore"):
        return (edges[1:] + edges[:-1]) / 2, sums / np.where(counts > 0, counts, np.nan), counts


def _cells(frame, size):
    """Number of the cell of each particle, and of particles in each cell, for cells of `size` m."""
    index = np.floor((frame.points - frame.points.min(axis=0)) / size).astype(int)
    _, cell, counts = np.unique(index, axis=0, return_inverse=True, return_counts=True)
    return cell.ravel(), counts


def small_grains(frame):
    """C of small grains, 0 to 1. With a list of sizes in case.toml of the run it is (d_max - d)/(d_max - d_min) with the mean
    diameter d of the mixture, which of two sizes is C of the small ones."""
    if "concentration" in frame.run.fields:
        return frame.scalar("concentration")
    import tomllib
    sizes = np.array(tomllib.loads((frame.run.folder / "case.toml").read_text(encoding="utf8"))["species"]["diameters"])
    finer = (sizes.max() - sizes) / (np.ptp(sizes) or 1)
    return sum(finer[k] * frame.scalar(f"concentration_{k + 1}") for k in range(len(sizes)))


def segregation_intensity(frame, name="concentration", size=None, least=4):
    """Danckwerts' (1952) intensity of segregation of a concentration (0 to 1): the standard deviation of its mean over cells of
    `size` (m; four spacings if not given), over the largest possible one, sqrt(C (1 - C)). 1: separated, 0: mixed. Cells with fewer
    than `least` particles do not count."""
    frame = frame.material
    values = frame.scalar(name)
    cell, counts = _cells(frame, size or 4 * frame.run.spacing)
    means, full = np.bincount(cell, values) / counts, counts >= least
    if not full.any():
        raise ValueError(f"no cell has {least} particles: choose larger ones than {size or 4 * frame.run.spacing:g} m")
    mean = np.average(means[full], weights=counts[full])
    if not 0 < mean < 1:
        return 0.0  # of one kind alone
    variance = np.average((means[full] - mean) ** 2, weights=counts[full])
    return float(np.sqrt(variance / (mean * (1 - mean))))


def lacey_index(frame, marked, size=None, least=4):
    """Lacey's (1954) index of mixing of marked particles (an array of true and false for the material, for instance
    `frame.material["group"] == 1`) in cells of `size` (m; four spacings if not given): (s0^2 - s^2)/(s0^2 - sr^2), where s^2 is the
    variance of the fraction of marked particles, s0^2 = p (1 - p) that of separated ones and sr^2 = s0^2/n that of a random
    mixture with n particles in a cell. 0: separated, 1: mixed at random."""
    frame = frame.material
    marked = np.asarray(marked, dtype=float)
    if marked.shape != (len(frame),):
        raise ValueError(f"`marked` needs one value for each of the {len(frame)} particles of the material")
    cell, counts = _cells(frame, size or 4 * frame.run.spacing)
    full = counts >= least
    if not full.any():
        raise ValueError(f"no cell has {least} particles: choose larger ones than {size or 4 * frame.run.spacing:g} m")
    fractions, weights = (np.bincount(cell, marked) / counts)[full], counts[full]
    p = np.average(fractions, weights=weights)
    separated = p * (1 - p)
    if separated == 0:
        return 1.0  # of one kind alone
    variance = np.average((fractions - p) ** 2, weights=weights)
    return float((separated - variance) / (separated - separated * len(weights) / weights.sum()))
