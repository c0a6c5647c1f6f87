"""Draws a file of triangles with VTK, off screen, and prints one line of JSON.

    vtk_peer.py FILE [--side N] [--warm-up SECONDS] [--measure SECONDS] [--picture FILE]

Options and output are those of llvmpipe.c; a picture whose name ends in .png becomes a PNG file. Needs vtk and numpy. VTK
picks an off-screen OpenGL by itself, llvmpipe where there is no GPU. Colours stay linear, also in the picture; scenes with
rounds of shading are refused.
"""

import argparse
import json
import time

import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

LEAST_FRAMES = 5
ROUNDS = 2


def read(file):
    data = numpy.fromfile(file, dtype=numpy.uint8)
    if data[:8].tobytes() != b"LZTRI001":
        raise SystemExit("not a file of triangles")
    coloring, _, vertices, indices = (int(i) for i in data[8:24].view("<i4"))
    if coloring == ROUNDS:
        raise SystemExit("VTK has no shader for this scene")
    to_clip = data[24:88].view("<f4").reshape(4, 4).T
    table = data[88 : 88 + 16 * vertices].view([("position", "<f4", 3), ("rgba", "u1", 4)])
    corners = data[88 + 16 * vertices :].view("<i4") if indices else numpy.arange(vertices)
    return to_clip, table, corners


def window(file, side):
    to_clip, table, corners = read(file)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(numpy.ascontiguousarray(table["position"]), deep=True))
    triangles = vtk.vtkCellArray()
    offsets = numpy.arange(0, len(corners) + 1, 3, dtype=numpy.int64)
    triangles.SetData(
        numpy_to_vtkIdTypeArray(offsets, deep=True),
        numpy_to_vtkIdTypeArray(corners.astype(numpy.int64), deep=True),
    )
    mesh = vtk.vtkPolyData()
    mesh.SetPoints(points)
    mesh.SetPolys(triangles)
    colors = numpy_to_vtk(numpy.ascontiguousarray(table["rgba"][:, :3]), deep=True, array_type=vtk.VTK_UNSIGNED_CHAR)
    mesh.GetPointData().SetScalars(colors)

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    mapper.SetColorModeToDirectScalars()
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()

    # The file's matrix goes from world to clip space at once: the camera stands at the origin, looking along -z
    matrix = vtk.vtkMatrix4x4()
    matrix.DeepCopy([float(number) for number in to_clip.reshape(-1)])
    renderer = vtk.vtkRenderer()
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0, 0, 0)
    camera.SetFocalPoint(0, 0, -1)
    camera.SetViewUp(0, 1, 0)
    camera.SetExplicitProjectionTransformMatrix(matrix)
    camera.UseExplicitProjectionTransformMatrixOn()
    renderer.SetBackground(0, 0, 0)
    renderer.SetBackgroundAlpha(0)
    renderer.AddActor(actor)

    result = vtk.vtkRenderWindow()
    result.SetOffScreenRendering(1)
    result.SetMultiSamples(0)
    result.SetAlphaBitPlanes(1)
    result.SetSize(side, side)
    result.AddRenderer(renderer)
    return result


def frame(target):
    start = time.perf_counter()
    target.Render()
    target.WaitForCompletion()
    return 1e3 * (time.perf_counter() - start)


def write_png(target, file):
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(target)
    image.SetInputBufferTypeToRGBA()
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(file)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("file")
    parser.add_argument("--side", type=int, default=1024)
    parser.add_argument("--warm-up", type=float, default=1.5)
    parser.add_argument("--measure", type=float, default=4.0)
    parser.add_argument("--picture")
    options = parser.parse_args()
    vtk.vtkObject.GlobalWarningDisplayOff()
    target = window(options.file, options.side)
    first = frame(target)
    if options.picture and options.picture.endswith(".png"):
        write_png(target, options.picture)
        return
    if options.picture:
        pixels = vtk.vtkUnsignedCharArray()
        target.GetRGBACharPixelData(0, 0, options.side - 1, options.side - 1, 0, pixels)
        rows = vtk_to_numpy(pixels).reshape(options.side, options.side, 4)[::-1]
        rows.tofile(options.picture)
        print(json.dumps({"covered": int((rows[:, :, 3] != 0).sum())}))
        return
    end = time.perf_counter() + options.warm_up
    while time.perf_counter() < end:
        frame(target)
    times = []
    end = time.perf_counter() + options.measure
    while len(times) < LEAST_FRAMES or time.perf_counter() < end:
        times.append(frame(target))
    times.sort()
    count = len(times)
    print(
        json.dumps(
            {
                "median": times[count // 2],
                "q1": times[count // 4],
                "q3": times[3 * count // 4],
                "min": times[0],
                "max": times[-1],
                "first": first,
                "frames": count,
                "version": vtk.vtkVersion.GetVTKVersion() + ", " + target.GetClassName(),
            }
        )
    )


main()
