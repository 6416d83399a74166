# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Reads steps.vtkhdf, written by the hidden test [.vtk] of vtkhdf.cpp, with VTK's own reader (>= 9.3) and checks that
every number is where the test put it: particle i of step s is at (s, i, 0.5), has C = 100 s + i, and so on."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIOHDF import vtkHDFReader

counts = [3, 3, 5, 2, 2, 4000, 4000, 1]
reader = vtkHDFReader()
reader.SetFileName(sys.argv[1])
reader.UpdateInformation()
times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
assert np.array_equal(times, [0.5 * s for s in range(len(counts))]), times

for s in [*range(len(counts)), 5, 0, 3, 7, 2]:  # forwards, then jumping about
    reader.UpdateTimeStep(times[s])
    data, n = reader.GetOutputDataObject(0), counts[s]
    assert data.IsA("vtkPolyData") and data.GetNumberOfPoints() == n and data.GetNumberOfVerts() == n, (s, data)
    assert data.GetNumberOfCells() == n, (s, data.GetNumberOfCells())
    i = np.arange(n)
    assert np.array_equal(vtk_to_numpy(data.GetVerts().GetConnectivityArray()), i), s
    assert np.array_equal(vtk_to_numpy(data.GetVerts().GetOffsetsArray()), np.arange(n + 1)), s
    assert np.array_equal(vtk_to_numpy(data.GetPoints().GetData()), np.column_stack([0 * i + s, i, 0 * i + 0.5])), s
    expected = {"C": 100 * s + i, "speed": 0.25 * i, "surface set": s - i,
                "normal": np.column_stack([i, 2 * i, 0 * i + 3 * s])}
    for name, values in expected.items():
        assert np.array_equal(vtk_to_numpy(data.GetPointData().GetArray(name)), values), (s, name)
print(f"VTK {vtkVersion.GetVTKVersion()} reads all {len(counts)} steps as written")
