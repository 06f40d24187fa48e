# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the plugin inside ParaView: pvbatch paraview_plugin.py, see test/paraview.sh.

A filter of ParaView reports its errors and goes on, and pvbatch then returns 0: so outputs are
looked at, and the last line says that all went well.
"""

import inspect
import os
import sys
import tempfile

if not hasattr(inspect, "getargspec"):  # ParaView 5.11 needs it, and Python 3.11 has none
    inspect.getargspec = inspect.getfullargspec

import surface_mesh_foliation
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy

TESTS = os.path.dirname(os.path.abspath(__file__))
sys.path.append(os.path.join(os.path.dirname(TESTS), "examples"))

import shapes  # noqa: E402


def load_plugin():
    folder = os.path.dirname(os.path.abspath(surface_mesh_foliation.__file__))
    plugin = os.path.join(folder, "paraview_reeb_graph.py")
    simple.LoadPlugin(plugin, remote=False, ns=vars(simple))


def read(folder, points, faces):
    """Write a mesh as PLY, and return a reader of it."""
    file = os.path.join(folder, f"{len(os.listdir(folder))}.ply")
    lines = ["ply", "format ascii 1.0", f"element vertex {len(points)}"]
    lines += [f"property double {name}" for name in "xyz"]
    lines += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    lines += [" ".join(map(repr, point)) for point in points.tolist()]
    lines += [" ".join(map(str, [len(face), *face])) for face in faces.tolist()]
    with open(file, "w") as stream:
        stream.write("\n".join(lines) + "\n")
    return simple.PLYReader(FileNames=[file])


def cells(graph):
    """Update a filter, and return the numbers of cells of its three outputs."""
    graph.UpdatePipeline()
    ports = [simple.OutputPort(graph, port) for port in range(3)]
    return [port.GetDataInformation().GetNumberOfCells() for port in ports]


def of_nodes(graph, name):
    data = servermanager.Fetch(graph, idx=2)
    return vtk_to_numpy(data.GetPointData().GetArray(name)).tolist()


def expect(what, value, expected):
    print(f"{what}: {value}", flush=True)
    if value != expected:
        raise AssertionError(f"{what}: {value}, not {expected}")


def test_poles_and_loops(folder):
    points, faces = shapes.body()
    graph = simple.FoliationReebGraph(Input=read(folder, points, faces))
    expect("faces, arcs and nodes of a body", cells(graph), [len(faces), 6, 7])
    expect("arrays of points", sorted(graph.PointData.keys()), ["arc", "node", "t"])
    expect("arrays of cells", sorted(graph.CellData.keys()), ["component", "part"])
    poles = sorted(set(of_nodes(graph, "point")) - {-1})
    expect("number of poles found", len(poles), 5)
    graph.HandlesOnly = 1
    expect("with loops around handles only", cells(graph)[1:], [5, 6])
    graph.HandlesOnly = 0
    graph.Poles = [100]
    expect("with another pole", set(of_updated_nodes(graph, "point")) - {-1}, {*poles, 100})
    graph.FindPoles = 0
    graph.Poles = poles
    expect("with the same poles by id", cells(graph), [len(faces), 6, 7])
    graph.Poles = []
    graph.PolePositions = (points[poles] + 0.1).reshape(-1).tolist()
    expect("and by position", set(of_updated_nodes(graph, "point")) - {-1}, set(poles))
    graph.PolePositions = []
    expect("without poles, which is an error", cells(graph), [0, 0, 0])
    graph.FindPoles = 1
    expect("after the error", cells(graph), [len(faces), 6, 7])
    graph.Detail = 0.05
    expect("are there more arcs with more detail", cells(graph)[1] > 6, True)


def of_updated_nodes(graph, name):
    graph.UpdatePipeline()
    return of_nodes(graph, name)


def test_openings(folder):
    points, faces = shapes.tube()
    graph = simple.FoliationReebGraph(Input=read(folder, points, faces))
    choices = [("Fill short ones", 3), ("Ends of the graph", 3), ("Fill all", 0)]
    for choice, kind in choices:
        graph.Openings = choice
        expect(f"a tube, {choice}", cells(graph), [len(faces), 1, 2])
        expect("kinds of nodes", of_nodes(graph, "kind"), [kind, kind])
    graph.Openings = "Fill up to a length"
    for length, kind in ((0.001, 3), (1000.0, 0)):
        graph.FillLength = length
        expect(f"kinds, filled up to {length}", of_updated_nodes(graph, "kind"), [kind, kind])


def test_repair(folder):
    points, faces = shapes.torus(12, 18)
    faces[3] = faces[3][::-1]
    graph = simple.FoliationReebGraph(Input=read(folder, points, faces))
    expect("a face that is turned over, which is an error", cells(graph), [0, 0, 0])
    graph.Repair = 1
    expect("faces after repair", cells(graph)[0], len(faces))


def test_data_of_paraview():
    sphere = simple.Sphere(ThetaResolution=30, PhiResolution=20)
    graph = simple.FoliationReebGraph(Input=sphere)
    number = cells(graph)[0]
    expect("arcs and nodes of a sphere", cells(graph)[1:], [1, 2])
    expect("are its normals carried over", "Normals" in graph.PointData.keys(), True)
    sphere.ThetaResolution = 50
    expect("are there more faces when the source has more", cells(graph)[0] > number, True)
    tube = simple.Tube(Input=simple.OutputPort(graph, 1))
    tube.Scalars = ["POINTS", "radius"]
    tube.VaryRadius = "By Absolute Scalar"
    tube.UpdatePipeline()
    number = tube.GetDataInformation().GetNumberOfPoints()
    expect("is there a tube around the skeleton", number > 0, True)
    box = simple.FoliationReebGraph(Input=simple.Clean(Input=simple.Box()))
    expect("triangles of a box of squares", cells(box)[0], 12)
    other = simple.Sphere(Center=[5, 0, 0])
    parts = simple.FoliationReebGraph(Input=simple.AppendGeometry(Input=[sphere, other]))
    expect("arcs and nodes of two spheres", cells(parts)[1:], [2, 4])
    expect("their parts", sorted(of_nodes(parts, "part")), [0, 0, 1, 1])
    image = simple.FoliationReebGraph(Input=simple.Wavelet())
    expect("an image, which is an error", cells(image), [0, 0, 0])
    group = simple.FoliationReebGraph(Input=simple.GroupDatasets(Input=[sphere, other]))
    expect("arcs and nodes of a group of two spheres", cells(group)[1:], [2, 4])


def main():
    load_plugin()
    with tempfile.TemporaryDirectory() as folder:
        test_poles_and_loops(folder)
        test_openings(folder)
        test_repair(folder)
    test_data_of_paraview()
    print("paraview: all is well", flush=True)


main()
