# SPDX-License-Identifier: GPL-3.0-or-later
"""A filter in a pipeline of VTK, and its outputs as files for ParaView."""

from surface_mesh_foliation.vtk_filter import FoliationReebGraph
from vtkmodules.vtkFiltersCore import vtkTubeFilter
from vtkmodules.vtkFiltersSources import vtkSuperquadricSource
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter

# %% a torus whose points are there twice along a seam: it is repaired
source = vtkSuperquadricSource()
source.ToroidalOn()
source.SetThetaResolution(48)
source.SetPhiResolution(48)
graph = FoliationReebGraph()
graph.SetInputConnection(source.GetOutputPort())
graph.SetRepair(True)
graph.Update()

# %% the surface with its parts, the skeleton, and the nodes
for port, name in enumerate(("surface", "skeleton", "nodes")):
    print(name, graph.GetOutputDataObject(port).GetNumberOfCells(), "cells")
    writer = vtkXMLPolyDataWriter()
    writer.SetInputConnection(graph.GetOutputPort(port))
    writer.SetFileName(f"{name}.vtp")
    writer.Write()

# %% further filters follow: a tube around the skeleton
tube = vtkTubeFilter()
tube.SetInputConnection(graph.GetOutputPort(1))
tube.SetRadius(0.02)
tube.Update()
print("tube", tube.GetOutput().GetNumberOfPoints(), "points")

# %% what is wrong is reported as the errors of other filters are, and kept
graph.SetRepair(False)
graph.AddPole(10**6)
graph.Update()
print("error:", graph.error)
