# SPDX-License-Identifier: GPL-3.0-or-later
"""Shows the filter at work on a mesh: run in ParaView by paraview.sh, beside this file."""

import inspect
import os

if not hasattr(inspect, "getargspec"):  # ParaView 5.11 needs it, and Python 3.11 has none
    inspect.getargspec = inspect.getfullargspec

import surface_mesh_foliation as smf
from paraview import simple
from paraview.simple import ColorBy, GetColorTransferFunction, OutputPort, Show
from surface_mesh_foliation.vtk import mesh_to_vtk

folder = os.path.dirname(os.path.abspath(smf.__file__))
simple.LoadPlugin(os.path.join(folder, "paraview_reeb_graph.py"), remote=False, ns=vars(simple))

COLORS = [
    (0.90, 0.45, 0.40),
    (0.45, 0.65, 0.90),
    (0.55, 0.78, 0.45),
    (0.95, 0.75, 0.35),
    (0.70, 0.55, 0.85),
    (0.45, 0.78, 0.75),
    (0.85, 0.60, 0.75),
    (0.70, 0.70, 0.50),
]


def color_parts(display, number):
    ColorBy(display, ("CELLS", "component"))
    colors = GetColorTransferFunction("component")
    colors.InterpretValuesAsCategories = 1
    colors.AnnotationsInitialized = 1
    colors.Annotations = [text for i in range(number) for text in (str(i), str(i))]
    colors.IndexedColors = [x for i in range(number) for x in COLORS[i % len(COLORS)]]


view = simple.GetActiveViewOrCreate("RenderView")
view.OrientationAxesVisibility = 0
view.UseColorPaletteForBackground = 0
view.Background = [1, 1, 1]

file = os.environ["SMF_PICTURE_MESH"]
mesh = simple.TrivialProducer(registrationName=os.path.basename(file))
mesh.GetClientSideObject().SetOutput(mesh_to_vtk(smf.read(file)))
graph = simple.FoliationReebGraph(registrationName="FoliationReebGraph1", Input=mesh)
graph.UpdatePipeline()
number = int(graph.CellData["component"].GetRange()[1]) + 1
size = max(high - low for low, high in zip(*[iter(graph.GetDataInformation().GetBounds())] * 2))

surface = Show(OutputPort(graph, 0), view)
color_parts(surface, number)
surface.Opacity = 0.45

tubes = simple.Tube(registrationName="skeleton as tubes", Input=OutputPort(graph, 1))
tubes.Radius = size / 120
lines = Show(tubes, view)
lines.ColorArrayName = ["POINTS", ""]
lines.AmbientColor = lines.DiffuseColor = [0.15, 0.15, 0.15]

nodes = Show(OutputPort(graph, 2), view)
nodes.SetRepresentationType("Points")
nodes.ColorArrayName = ["POINTS", ""]
nodes.AmbientColor = nodes.DiffuseColor = [0.8, 0.1, 0.1]
nodes.RenderPointsAsSpheres = 1
nodes.PointSize = 16

simple.SetActiveSource(graph)
camera = [float(x) for x in os.environ.get("SMF_PICTURE_CAMERA", "0 0 1 0 1 0").split()]
view.CameraFocalPoint = [0, 0, 0]
view.CameraPosition = camera[:3]
view.CameraViewUp = camera[3:]
simple.ResetCamera(view)
simple.Render(view)
open(os.environ["SMF_PICTURE_READY"], "w").close()
