# SPDX-FileCopyrightText: The scree authors
# SPDX-License-Identifier: Apache-2.0 WITH LLVM-exception
"""Opens the run of the present folder in ParaView (5.12 or later) with sensible settings, in the folder of a run:

    paraview --script=path/to/scree/examples/view/paraview_state.py
    pvbatch path/to/scree/examples/view/paraview_state.py picture.png     # the last state, without a window

Material as spheres, coloured by concentration, velocity or the first field; walls grey and, in space, transparent; the view
along y with z upwards."""
import sys

from paraview import simple as pv

FILE = "particles.vtkhdf"
FIRST = ("concentration", "concentration_1", "velocity", "pressure")


def spacing_of(points):
    """Distance of neighbours: the median over a few particles of the distance to the nearest other one, m."""
    nearest = []
    for k in range(0, len(points), max(1, len(points) // 50)):
        distances = sorted(sum((a - b) ** 2 for a, b in zip(points[k], other)) for other in points)
        nearest.append(distances[1] ** 0.5 if len(distances) > 1 else 1.0)
    return sorted(nearest)[len(nearest) // 2]


def show(source, view, spacing):
    shown = pv.Show(source, view)
    shown.SetRepresentationType("Point Gaussian")
    shown.GaussianRadius = 0.5 * spacing
    shown.ShaderPreset = "Sphere"
    return shown


def part(reader, name, low, high):
    chosen = pv.Threshold(registrationName=name, Input=reader)
    chosen.Scalars = ["POINTS", "body"]
    chosen.LowerThreshold, chosen.UpperThreshold = low, high
    return chosen


def main():
    reader = pv.OpenDataFile(FILE)
    if reader is None:
        sys.exit(f"paraview_state: {FILE} is not here, or this version of ParaView does not read it (5.12 or later does)")
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    view = pv.GetActiveViewOrCreate("RenderView")
    data = reader.PointData
    fields = [data[k].Name for k in range(data.GetNumberOfArrays())]
    from paraview import servermanager
    from vtkmodules.util.numpy_support import vtk_to_numpy
    points = vtk_to_numpy(servermanager.Fetch(reader).GetPoints().GetData())
    spacing, in_space = spacing_of(points.tolist()[:20000]), bool((points[:, 1] != 0).any())

    material = reader
    if "body" in fields:
        material = part(reader, "material", 0, 0)
        walls = show(part(reader, "walls", 0.5, 1e9), view, spacing)
        walls.ColorArrayName = ["POINTS", ""]
        walls.DiffuseColor = walls.AmbientColor = [0.62, 0.62, 0.62]
        walls.Opacity = 0.15 if in_space else 1.0
        pv.Hide(reader, view)
    shown = show(material, view, spacing)
    scene.GoToLast()
    colours = next((name for name in FIRST if name in fields), fields[0] if fields else None)
    if colours:
        pv.ColorBy(shown, ("POINTS", colours))
        pv.GetColorTransferFunction(colours).ApplyPreset("Viridis (matplotlib)", True)
        shown.RescaleTransferFunctionToDataRangeOverTime()
        shown.SetScalarBarVisibility(view, True)
        bar = pv.GetScalarBar(pv.GetColorTransferFunction(colours), view)
        bar.TitleColor = bar.LabelColor = [0, 0, 0]
        bar.WindowLocation = "Lower Right Corner"

    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 1 if in_space else 0
    view.CameraParallelProjection = 0 if in_space else 1
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = ([-1, -2, 1] if in_space else [0, -1, 0]), [0, 0, 0], [0, 0, 1]
    pictures = [word for word in sys.argv[1:] if word.endswith(".png")]
    if pictures:
        view.ViewSize = [1200, 800]
    pv.ResetCamera(view)
    if pictures:
        pv.SaveScreenshot(pictures[0], view, ImageResolution=[1200, 800])
    else:
        scene.GoToFirst()
        pv.Render(view)


main()
