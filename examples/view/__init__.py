# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Results of a run in Python: fields as NumPy arrays, profiles, measures of mixing, pictures, films, a page for the browser.

    import sys; sys.path.insert(0, "scree/examples")
    from view import Run

    run = Run("OUT")                        # a folder with particles.vtkhdf, or such a file
    last = run[-1]                          # the last stored state
    last.points, last["velocity"]           # arrays, in m and m/s
    run.units["velocity"], run.times        # "m/s"; s
    run.tables["heap.csv"]["time"]          # a column of a table

`python3 scree/examples/view OUT --help` has the commands. It needs h5py, numpy and matplotlib (Debian: python3-h5py,
python3-matplotlib), for films ffmpeg."""
from .run import MATERIAL, Frame, Run
from .statistics import lacey_index, profile, segregation_intensity, small_grains

__all__ = ["MATERIAL", "Frame", "Run", "lacey_index", "profile", "segregation_intensity", "small_grains"]
