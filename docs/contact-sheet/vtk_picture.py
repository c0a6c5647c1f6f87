"""Renders a model with VTK as a plain script does: reader, mapper, actor, the defaults of the renderer.

    vtk_picture.py MODEL SIZE PICTURE [TEXTURE]

glTF files, and OBJ files with a material library, are read by VTK's importers, which make actors with materials. The
camera is the default one, reset so that it shows everything; light and anti-aliasing are the defaults, too. The
background is white.
"""

import sys
from pathlib import Path

import vtk


def importer_of(model):
    if model.suffix.lower() in (".glb", ".gltf"):
        return vtk.vtkGLTFImporter()
    materials = model.with_suffix(".mtl")
    if model.suffix.lower() != ".obj" or not materials.is_file():
        return None
    importer = vtk.vtkOBJImporter()
    importer.SetFileNameMTL(str(materials))
    importer.SetTexturePath(str(model.parent))
    return importer


def actor_of(model, texture):
    readers = {".obj": vtk.vtkOBJReader, ".stl": vtk.vtkSTLReader, ".ply": vtk.vtkPLYReader}
    reader = readers[model.suffix.lower()]()
    reader.SetFileName(str(model))
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    if texture:
        image = vtk.vtkPNGReader()
        image.SetFileName(texture)
        map_of_colors = vtk.vtkTexture()
        map_of_colors.SetInputConnection(image.GetOutputPort())
        actor.SetTexture(map_of_colors)
    return actor


def main(model, size, picture, texture=None):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetSize(int(size), int(size))
    window.AddRenderer(renderer)
    importer = importer_of(Path(model))
    if importer:
        importer.SetFileName(model)
        importer.SetRenderWindow(window)
        importer.Update()
        renderer.SetActiveCamera(vtk.vtkCamera())
    else:
        renderer.AddActor(actor_of(Path(model), texture))
    renderer.ResetCamera()
    window.Render()
    image = vtk.vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(picture)
    writer.SetInputConnection(image.GetOutputPort())
    writer.Write()


if __name__ == "__main__":
    main(*sys.argv[1:])
