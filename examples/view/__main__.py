# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Shows the results of a run: python3 examples/view OUT [options]. Without options it lists times, fields and tables."""
import argparse
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
try:
    import h5py  # noqa: F401
    import matplotlib  # noqa: F401
except ModuleNotFoundError as error:
    SYSTEM = "/usr/bin/python3"  # which may have the modules when another Python comes first
    if sys.executable != SYSTEM and os.access(SYSTEM, os.X_OK):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    sys.exit(f"view: {sys.executable} has no module {error.name}; on Debian: apt-get install python3-h5py python3-matplotlib")

import numpy as np  # noqa: E402

from view import Run, page, pictures, profile, segregation_intensity  # noqa: E402


def arguments():
    parser = argparse.ArgumentParser(prog="view", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("run", help="folder of a run, or a .vtkhdf file")
    parser.add_argument("--field", help="to show: a field, or a component such as velocity.x; without it concentration, velocity or the first one")
    parser.add_argument("--page", metavar="FILE.html", help="write a page for the browser, in one file")
    parser.add_argument("--fields", metavar="A,B", help="fields of the page; without it all")
    parser.add_argument("--megabytes", type=float, default=20, help="largest size of the page (20)")
    parser.add_argument("--picture", metavar="FILE.png", help="draw states, evenly from the first to the last one")
    parser.add_argument("--states", type=int, default=4, help="how many states --picture draws (4)")
    parser.add_argument("--times", metavar="T,T", help="or those nearest to these times (s)")
    parser.add_argument("--film", metavar="FILE.mp4", help="all states, as .mp4, .gif or .webp")
    parser.add_argument("--inches", type=float, default=8, help="width of the film, at 100 pixels each (8)")
    parser.add_argument("--curves", metavar="FILE.png", help="draw the columns of all tables over time")
    parser.add_argument("--profile", metavar="x|y|z", choices="xyz", help="print the mean of --field along an axis, last state")
    return parser.parse_args()


def describe(run):
    print(f"{run.path}: {len(run)} states from {run.times[0]:g} to {run.times[-1]:g} s, {run.counts.min()} to {run.counts.max()} "
          f"particles, {run.dimension}D, spacing about {run.spacing:.3g} m")
    for name in run.scalars:
        first, last = (run[k].material.scalar(name) for k in (0, -1))
        print(f"  {name} [{run.unit(name)}]: mean {first.mean():.4g} at first, {last.mean():.4g} at the end, where it goes from "
              f"{last.min() + 0.0:.4g} to {last.max():.4g}")  # 0.0: not -0
    for name, columns in run.tables.items():
        print(f"  {name}: {', '.join(columns)}")
    if "concentration" in run.fields:
        print("  intensity of segregation (1 separated, 0 mixed): "
              f"{segregation_intensity(run[0]):.3f} at first, {segregation_intensity(run[-1]):.3f} at the end")


def main():
    options = arguments()
    run = Run(options.run)
    if not len(run):
        sys.exit(f"view: {run.path} has no stored state")
    field = options.field or (run.scalars[0] if run.scalars else None)
    if not field and (options.picture or options.film or options.profile):
        sys.exit(f"view: {run.path} has no field to show")
    if options.page:
        scalars = options.fields.split(",") if options.fields else None
        states, stride = page.write_page(run, options.page, scalars, options.megabytes)
        less = f", one particle in {stride}" if stride > 1 else ""
        print(f"{options.page}: {Path(options.page).stat().st_size / 1e6:.1f} MB, {states} of {len(run)} states{less}")
    if options.picture:
        times = [float(time) for time in options.times.split(",")] if options.times else None
        pictures.picture(run, field, options.picture, options.states, times)
    if options.film:
        pictures.film(run, field, options.film, inches=options.inches)
    if options.curves:
        pictures.curves(run, options.curves)
    if options.profile:
        print(f"{options.profile} [m], {field} [{run.unit(field)}], particles")
        for row in zip(*profile(run[-1], field, options.profile)):
            print(", ".join(f"{number:.5g}" for number in row))
    if not any((options.page, options.picture, options.film, options.curves, options.profile)):
        describe(run)


if __name__ == "__main__":
    np.seterr(all="ignore")
    try:
        main()
    except (OSError, KeyError, ValueError) as error:
        sys.exit(f"view: {error.args[0] if isinstance(error, KeyError) else error}")
