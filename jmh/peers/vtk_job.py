"""Does whole jobs with VTK, from a mesh file to a PNG file, in one process.

    vtk_job.py

Input and output are those of JobRun.java. VTK reads the file, makes normals, renders with its default light, and writes the
picture, all by its own classes. OBJ, PLY and STL files only; where it reads no faces, as of PLY files with triangle strips, no
job is done. Needs vtk.
"""

import os
import sys
import tempfile
import time

import vtk

READERS = {".obj": vtk.vtkOBJReader, ".ply": vtk.vtkPLYReader, ".stl": vtk.vtkSTLReader}


def job(file, side, samples, picture):
    start = time.perf_counter()
    reader = READERS[os.path.splitext(file)[1].lower()]()
    reader.SetFileName(file)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputConnection(reader.GetOutputPort())
    normals.Update()
    loaded = time.perf_counter()
    if normals.GetOutput().GetNumberOfCells() == 0:
        return None

    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(normals.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    renderer = vtk.vtkRenderer()
    renderer.AddActor(actor)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(samples if samples > 1 else 0)
    window.SetSize(side, side)
    window.AddRenderer(renderer)
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(picture)
    writer.Write()
    window.Finalize()
    return 1e3 * (loaded - start), 1e3 * (time.perf_counter() - loaded)


def measure(seconds, *request):
    jobs = []
    end = time.perf_counter() + seconds
    while not jobs or time.perf_counter() < end:
        done = job(*request)
        if done is None:
            return "0 0 0 0"
        jobs.append(done)
    load, rest = min(jobs, key=sum)
    return "%d %.3f %.3f %.3f" % (len(jobs), load + rest, load, rest)


def main():
    vtk.vtkObject.GlobalWarningDisplayOff()
    with tempfile.TemporaryDirectory() as folder:
        for line in sys.stdin:
            seconds, side, samples, file = line.rstrip("\n").split(" ", 3)
            picture = os.path.join(folder, "job.png")
            print(measure(float(seconds), file, int(side), int(samples), picture), flush=True)


main()
