# SPDX-License-Identifier: GPL-3.0-or-later
"""Data sets of VTK in, and results for VTK; the filter in a pipeline."""

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf
from test_package import PYTHON, run_block

pytest.importorskip("vtkmodules")

from surface_mesh_foliation import vtk as smf_vtk  # noqa: E402
from surface_mesh_foliation import vtk_filter  # noqa: E402
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy  # noqa: E402
from vtkmodules.vtkCommonCore import (  # noqa: E402
    vtkOutputWindow,
    vtkPoints,
    vtkStringArray,
    vtkStringOutputWindow,
)
from vtkmodules.vtkCommonDataModel import (  # noqa: E402
    vtkCellArray,
    vtkPolyData,
    vtkUnstructuredGrid,
)
from vtkmodules.vtkFiltersCore import vtkPolyDataNormals, vtkStripper, vtkTubeFilter  # noqa: E402
from vtkmodules.vtkFiltersSources import vtkSphereSource  # noqa: E402


def cell_array(cells):
    result = vtkCellArray()
    for cell in cells:
        result.InsertNextCell(len(cell), [int(corner) for corner in cell])
    return result


def poly_data(points, polygons, verts=(), lines=()):
    """Return a data set that has an array of each kind with the ids of points and cells."""
    result = vtkPolyData()
    result.SetPoints(vtkPoints())
    result.GetPoints().SetData(numpy_to_vtk(np.array(points, np.float64), deep=True))
    for add, cells in (
        (result.SetVerts, verts),
        (result.SetLines, lines),
        (result.SetPolys, polygons),
    ):
        add(cell_array(cells))
    add_ids(result.GetPointData(), result.GetNumberOfPoints())
    add_ids(result.GetCellData(), result.GetNumberOfCells())
    return result


def add_ids(attributes, number):
    ids = numpy_to_vtk(np.arange(number), deep=True)
    ids.SetName("id")
    attributes.AddArray(ids)
    vectors = numpy_to_vtk(np.outer(np.arange(number), [1.0, 2.0, 3.0]), deep=True)
    vectors.SetName("vector")
    attributes.SetVectors(vectors)
    names = vtkStringArray()
    names.SetName("name")
    for i in range(number):
        names.InsertNextValue(f"n{i}")
    attributes.AddArray(names)


def array(attributes, name):
    return vtk_to_numpy(attributes.GetArray(name))


def positions(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def triangles(data):
    return vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def check_ids(attributes, expected):
    """Check that all arrays have been carried over from these points or cells."""
    np.testing.assert_array_equal(array(attributes, "id"), expected)
    assert attributes.GetVectors().GetName() == "vector"
    np.testing.assert_array_equal(array(attributes, "vector"), np.outer(expected, [1, 2, 3]))
    names = attributes.GetAbstractArray("name")
    assert [names.GetValue(i) for i in range(len(expected))] == [f"n{i}" for i in expected]


def squares(cubes):
    """Return the surface of cubes with its squares whole: they are cut in the order of faces."""
    points, faces = cubes
    half = len(faces) // 2
    return points, np.column_stack([faces[:half], faces[half:, 2]])


# ===  From VTK


def test_triangles_become_faces():
    points, faces = shapes.body()
    surface = smf_vtk.from_vtk(poly_data(points, faces))
    np.testing.assert_array_equal(surface.mesh.vertices, points)
    np.testing.assert_array_equal(surface.mesh.faces, faces)
    np.testing.assert_array_equal(surface.points, np.arange(len(points)))
    np.testing.assert_array_equal(surface.vertices, np.arange(len(points)))
    np.testing.assert_array_equal(surface.cells, np.arange(len(faces)))


def test_single_precision_is_read(body):
    data = poly_data(body.vertices, body.faces)
    data.GetPoints().SetData(numpy_to_vtk(body.vertices.astype(np.float32), deep=True))
    np.testing.assert_allclose(smf_vtk.from_vtk(data).mesh.vertices, body.vertices)


def test_verts_lines_and_unused_points_are_left_out():
    points, faces = shapes.torus(12, 18)
    padded = np.concatenate([[[9.0, 9, 9]], points, [[8.0, 8, 8]] * 2])
    data = poly_data(padded, faces + 1, verts=[[0], [1]], lines=[[0, 3, 4]])
    surface = smf_vtk.from_vtk(data)
    np.testing.assert_array_equal(surface.mesh.vertices, points)
    np.testing.assert_array_equal(surface.points, np.arange(len(points)) + 1)
    np.testing.assert_array_equal(surface.cells, np.arange(len(faces)) + 3)
    assert surface.vertex_of(7) == 6
    with pytest.raises(ValueError, match="on no face"):
        surface.vertex_of(0)
    for wrong in (-1, len(padded)):
        with pytest.raises(ValueError, match="there is no point"):
            surface.vertex_of(wrong)
    with pytest.raises(TypeError):
        surface.vertex_of(1.5)


@pytest.mark.parametrize("repair", [False, True])
def test_polygons_are_cut_into_triangles(repair):
    points, quads = squares(shapes.body())
    data = poly_data(points, quads, verts=[[0]])
    surface = smf_vtk.from_vtk(data, repair=repair)
    assert surface.mesh.number_of_faces == 2 * len(quads)
    np.testing.assert_array_equal(np.bincount(surface.cells), [0] + [2] * len(quads))
    for face, cell in zip(surface.points[surface.mesh.faces], surface.cells):
        assert set(face) <= set(quads[cell - 1])
    expected = smf.reeb_graph(shapes.body()).number_of_arcs
    assert smf.reeb_graph(surface.mesh).number_of_arcs == expected


def test_strips_are_cut_into_triangles():
    source = vtkSphereSource()
    source.SetThetaResolution(12)
    strips = vtkStripper()
    strips.SetInputConnection(source.GetOutputPort())
    strips.Update()
    data = strips.GetOutput()
    assert data.GetNumberOfStrips() > 0
    surface = smf_vtk.from_vtk(data)
    assert surface.mesh.number_of_faces == source.GetOutput().GetNumberOfPolys()
    assert surface.mesh.genus == 0 and not surface.mesh.openings
    assert set(surface.cells) == set(range(data.GetNumberOfCells()))


def test_a_repaired_mesh_knows_where_it_comes_from():
    points, faces = shapes.sphere(1)
    soup = points[faces].reshape(-1, 3)
    corners = np.arange(len(soup)).reshape(-1, 3)
    corners[7] = corners[7][::-1]
    data = poly_data(soup, [*corners, [0, 0, 1]], verts=[[0]])
    surface = smf_vtk.from_vtk(data, repair=True)
    assert surface.mesh.number_of_vertices == len(points)
    np.testing.assert_array_equal(surface.mesh.vertices, soup[surface.points])
    np.testing.assert_array_equal(soup[surface.points[surface.vertices]], soup)
    np.testing.assert_array_equal(surface.cells, np.arange(len(faces)) + 1)
    assert surface.mesh.repair_report.reversed_faces == 1


def test_faces_that_fill_openings_come_from_no_cell(tube):
    surface = smf_vtk.from_vtk(poly_data(tube.vertices, tube.faces), borders="fill")
    assert surface.mesh.number_of_filled_openings == 2 and not surface.mesh.openings
    n = tube.number_of_faces
    np.testing.assert_array_equal(surface.cells[:n], np.arange(n))
    assert np.all(surface.cells[n:] == -1) and len(surface.cells) > n
    assert np.all(surface.points[tube.number_of_vertices :] == -1)


def test_the_nearest_vertex_is_found(body):
    surface = smf_vtk.from_vtk(poly_data(body.vertices, body.faces))
    for vertex in (0, 17, body.number_of_vertices - 1):
        assert surface.nearest_vertex(body.vertices[vertex] + [0.1, -0.2, 0.1]) == vertex
    for wrong in ([0.0, 1.0], [0.0, np.nan, 1.0]):
        with pytest.raises(ValueError, match="three finite coordinates"):
            surface.nearest_vertex(wrong)


def test_other_data_is_refused(body):
    for wrong in (vtkUnstructuredGrid(), body):
        with pytest.raises(TypeError, match=type(wrong).__name__):
            smf_vtk.from_vtk(wrong)
    for empty in (vtkPolyData(), poly_data([[0, 0, 0], [1, 0, 0]], [], lines=[[0, 1]])):
        with pytest.raises(ValueError, match="no faces"):
            smf_vtk.from_vtk(empty)


@pytest.mark.parametrize("corner", [-1, 42, 10**9])
@pytest.mark.parametrize("size", [3, 4])
def test_points_that_there_are_not_are_named(corner, size):
    points, faces = shapes.sphere(1)
    wrong = [*faces, [0, 1, 2, 3][: size - 1] + [corner]]
    data = vtkPolyData()
    data.SetPoints(poly_data(points, faces).GetPoints())
    data.SetPolys(cell_array(wrong))
    with pytest.raises(ValueError, match=f"the point {corner}, but there are 42 points"):
        smf_vtk.from_vtk(data)
    data.SetPoints(None)
    with pytest.raises(ValueError, match="there are 0 points"):
        smf_vtk.from_vtk(data, repair=True)


def test_errors_name_points_and_cells():
    points, faces = shapes.sphere(1)
    padded = np.concatenate([[[9.0, 9, 9]], points])
    turned = faces + 1
    turned[7] = turned[7][::-1]
    with pytest.raises(smf.MeshError) as caught:
        smf_vtk.from_vtk(poly_data(padded, turned, verts=[[0]]))
    error = caught.value
    assert error.faces and all(0 < cell <= len(faces) for cell in error.faces)
    assert f"cells {', '.join(map(str, error.faces))}" in str(error)
    with pytest.raises(smf.MeshError) as unchanged:
        smf_vtk.from_vtk(poly_data(points, turned - 1))
    assert tuple(cell - 1 for cell in error.faces) == unchanged.value.faces
    assert "of the data" not in str(unchanged.value)
    padded[5] = np.nan
    with pytest.raises(smf.MeshError):
        smf_vtk.from_vtk(poly_data(padded, faces + 1))


def test_a_degenerate_polygon_is_named():
    points, faces = shapes.sphere(1)
    data = poly_data(points, [*faces, [1, 1, 1, 1, 1]])
    with pytest.raises(ValueError, match=f"cell {len(faces)} "):
        smf_vtk.from_vtk(data)
    assert smf_vtk.from_vtk(data, repair=True).mesh.number_of_faces == len(faces)


# ===  To VTK


def test_a_mesh_is_the_same_after_it_was_in_vtk(tube):
    data = smf_vtk.mesh_to_vtk(tube)
    again = smf_vtk.from_vtk(data).mesh
    np.testing.assert_array_equal(again.vertices, tube.vertices)
    np.testing.assert_array_equal(again.faces, tube.faces)
    filled = smf.Mesh(*shapes.tube(), borders="fill")
    assert smf_vtk.mesh_to_vtk(filled).GetNumberOfPolys() == filled.number_of_faces
    data = smf_vtk.mesh_to_vtk(shapes.sphere(1))
    assert data.GetNumberOfPolys() == 80


def test_the_surface_has_its_arrays_and_those_of_the_data():
    points, faces = shapes.body()
    padded = np.concatenate([[[9.0, 9, 9]], points])
    data = poly_data(padded, faces + 1, verts=[[0]])
    surface = smf_vtk.from_vtk(data)
    r = smf.reeb_graph(surface.mesh)
    output = smf_vtk.surface_to_vtk(r, surface)
    np.testing.assert_array_equal(positions(output), points)
    np.testing.assert_array_equal(triangles(output), faces)
    check_ids(output.GetPointData(), np.arange(1, len(padded)))
    check_ids(output.GetCellData(), np.arange(1, len(faces) + 1))
    for name in ("arc", "node", "t"):
        np.testing.assert_array_equal(array(output.GetPointData(), name), getattr(r, name))
    np.testing.assert_array_equal(array(output.GetCellData(), "component"), r.segments)
    assert not array(output.GetCellData(), "part").any()
    bare = smf_vtk.surface_to_vtk(r)
    np.testing.assert_array_equal(triangles(bare), faces)
    assert bare.GetPointData().GetNumberOfArrays() == 3


def test_arrays_of_clean_data_are_carried_over_as_they_are(body, body_result):
    data = poly_data(body.vertices, body.faces)
    output = smf_vtk.surface_to_vtk(body_result, smf_vtk.from_vtk(data))
    check_ids(output.GetPointData(), np.arange(body.number_of_vertices))
    check_ids(output.GetCellData(), np.arange(body.number_of_faces))
    assert data.GetPointData().GetArray("arc") is None  # the input is not changed


def test_filled_openings_are_not_shown(tube):
    surface = smf_vtk.from_vtk(poly_data(tube.vertices, tube.faces), borders="fill")
    output = smf_vtk.surface_to_vtk(smf.reeb_graph(surface.mesh), surface)
    np.testing.assert_array_equal(positions(output), tube.vertices)
    np.testing.assert_array_equal(triangles(output), tube.faces)
    check_ids(output.GetCellData(), np.arange(tube.number_of_faces))


def test_what_has_no_origin_has_no_values(body, body_result):
    surface = smf_vtk.from_vtk(poly_data(body.vertices, body.faces))
    made = surface.points.copy()
    made[[2, 5]] = -1
    output = smf_vtk.surface_to_vtk(body_result, surface._replace(points=made))
    expected = np.where(made >= 0, made, 0)
    np.testing.assert_array_equal(array(output.GetPointData(), "id"), expected)
    assert output.GetPointData().GetAbstractArray("name").GetValue(5) == ""


def check_skeleton(output, results):
    """Check lines and arrays against the skeletons of all parts."""
    lines, cells = output.GetLines(), output.GetCellData()
    offsets = vtk_to_numpy(lines.GetOffsetsArray())
    points = vtk_to_numpy(lines.GetConnectivityArray())
    radius = array(output.GetPointData(), "radius")
    arcs = [arc for r in results for arc in r.skeleton.arcs]
    assert output.GetNumberOfCells() == len(offsets) - 1 == len(arcs)
    for number, arc in enumerate(arcs):
        line = points[offsets[number] : offsets[number + 1]]
        np.testing.assert_array_equal(positions(output)[line], arc["polyline"])
        np.testing.assert_array_equal(radius[line[1:-1]], arc["radii"][1:-1])
        assert np.all(array(output.GetPointData(), "arc")[line[1:-1]] == number)
        assert np.all(array(output.GetPointData(), "node")[line[1:-1]] == -1)
        assert np.all(array(output.GetPointData(), "node")[line[[0, -1]]] >= 0)
        for name in ("height", "flux", "length", "area"):
            assert array(cells, name)[number] == arc[name]
        assert array(cells, "modulus")[number] == pytest.approx(arc["height"] / arc["flux"])
    np.testing.assert_array_equal(array(cells, "arc"), np.arange(len(arcs)))


@pytest.mark.parametrize(
    "make", [shapes.body, lambda: shapes.plate(2), shapes.torus, shapes.tube, shapes.sphere]
)
def test_the_skeleton_has_a_line_for_each_arc(make):
    r = smf.reeb_graph(make())
    check_skeleton(smf_vtk.skeleton_to_vtk(r), [r])


def test_nodes_have_their_properties(tube, body, body_result):
    surface = smf_vtk.from_vtk(poly_data(body.vertices, body.faces))
    output = smf_vtk.nodes_to_vtk(body_result, surface)
    data = output.GetPointData()
    np.testing.assert_array_equal(positions(output), body_result.skeleton.node_points)
    assert output.GetNumberOfVerts() == body_result.number_of_nodes
    kinds = {"pole": 0, "saddle": 1}
    nodes = body_result.skeleton.nodes
    np.testing.assert_array_equal(array(data, "kind"), [kinds[node["kind"]] for node in nodes])
    np.testing.assert_array_equal(array(data, "radius"), [node["radius"] for node in nodes])
    for node, pole, point in zip(nodes, array(data, "pole"), array(data, "point")):
        assert pole == node["pole"]
        assert point == (-1 if pole < 0 else body_result.poles[pole].vertices[0])
    surface = smf_vtk.from_vtk(poly_data(tube.vertices, tube.faces))
    output = smf_vtk.nodes_to_vtk(smf.reeb_graph(tube), surface)
    assert array(output.GetPointData(), "kind").tolist() == [3, 3]
    assert array(output.GetPointData(), "point").tolist() == [-1, -1]


def two_parts():
    one, other = shapes.torus(12, 18), shapes.body()
    points = np.concatenate([other[0] + [50, 0, 0], one[0]])
    faces = np.concatenate([one[1] + len(other[0]), other[1]])
    return points, faces


def test_parts_are_numbered_on():
    points, faces = two_parts()
    surface = smf_vtk.from_vtk(poly_data(points, faces))
    parts = [
        smf_vtk.PartResult(smf.reeb_graph(part.mesh), part.vertices, part.faces)
        for part in surface.mesh.parts()
    ]
    results = [part.result for part in parts]
    output = smf_vtk.surface_to_vtk(parts, surface)
    check_ids(output.GetCellData(), np.arange(len(faces)))
    component, part = (array(output.GetCellData(), name) for name in ("component", "part"))
    for number, (r, vertices, part_faces) in enumerate(parts):
        assert np.all(part[part_faces] == number)
        first_arc = number * results[0].number_of_arcs
        first_node = number * results[0].number_of_nodes
        np.testing.assert_array_equal(component[part_faces], r.segments + first_arc)
        for name, first in (("arc", first_arc), ("node", first_node)):
            own = getattr(r, name)
            expected = np.where(own >= 0, own + first, -1)
            np.testing.assert_array_equal(array(output.GetPointData(), name)[vertices], expected)
    skeleton = smf_vtk.skeleton_to_vtk(parts)
    check_skeleton(skeleton, results)
    node = array(skeleton.GetPointData(), "node")
    assert sorted(node[node >= 0]) == list(range(sum(r.number_of_nodes for r in results)))
    nodes = smf_vtk.nodes_to_vtk(parts, surface)
    kept = array(skeleton.GetPointData(), "node") >= 0
    np.testing.assert_array_equal(positions(skeleton)[kept], positions(nodes))
    pole = array(nodes.GetPointData(), "point")
    found = pole >= 0
    np.testing.assert_allclose(positions(nodes)[found], points[pole[found]])
    with pytest.raises(ValueError, match="the parts belong to"):
        smf_vtk.surface_to_vtk(parts)
    with pytest.raises(ValueError, match="no result"):
        smf_vtk.skeleton_to_vtk([])


# ===  The filter


@pytest.fixture
def messages():
    """Return a function that tells what VTK has reported."""
    before = vtkOutputWindow.GetInstance()
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    yield window.GetOutput
    vtkOutputWindow.SetInstance(before)


def graph_of(data, **properties):
    """Return the filter, after it has run; a property with a list is set by several calls."""
    graph = vtk_filter.FoliationReebGraph()
    for name, value in properties.items():
        if isinstance(value, list):
            for element in value:
                getattr(graph, name)(*(element if isinstance(element, list) else [element]))
        else:
            getattr(graph, name)(value)
    graph.SetInputDataObject(data)
    graph.Update()
    return graph


def arcs_of(graph):
    return graph.GetOutputDataObject(1).GetNumberOfCells()


def test_the_filter_works_in_a_pipeline():
    source = vtkSphereSource()
    source.SetThetaResolution(20)
    source.SetPhiResolution(20)
    normals = vtkPolyDataNormals()
    normals.SetInputConnection(source.GetOutputPort())
    graph = vtk_filter.FoliationReebGraph()
    graph.SetInputConnection(normals.GetOutputPort())
    tube = vtkTubeFilter()
    tube.SetInputConnection(graph.GetOutputPort(1))
    tube.Update()
    assert graph.error is None
    assert tube.GetOutput().GetNumberOfPoints() > 0
    surface = graph.GetOutputDataObject(0)
    assert surface.GetNumberOfPolys() == source.GetOutput().GetNumberOfPolys()
    assert surface.GetPointData().GetNormals() is not None
    assert graph.GetOutputDataObject(2).GetNumberOfVerts() == 2
    source.SetThetaResolution(30)
    tube.Update()
    assert graph.GetOutputDataObject(0).GetNumberOfPolys() > surface.GetNumberOfPoints()
    assert graph.GetOutputDataObject(0).GetNumberOfPolys() == source.GetOutput().GetNumberOfPolys()


def test_the_filter_gives_what_the_function_gives(body, body_result):
    graph = graph_of(poly_data(body.vertices, body.faces))
    check_skeleton(graph.GetOutputDataObject(1), [body_result])
    segments = array(graph.GetOutputDataObject(0).GetCellData(), "component")
    np.testing.assert_array_equal(segments, body_result.segments)
    point = array(graph.GetOutputDataObject(2).GetPointData(), "point")
    assert set(point[point >= 0]) == {int(pole.vertices[0]) for pole in body_result.poles}


def test_poles_are_given_by_ids_and_positions(body):
    data = poly_data(body.vertices, body.faces)
    found = smf.find_poles(body).tolist()
    given = graph_of(data, SetFindPoles=False, AddPole=found)
    check_skeleton(given.GetOutputDataObject(1), [smf.reeb_graph(body, poles=found)])
    nearby = (body.vertices[found] + 0.1).tolist()
    by_position = graph_of(data, SetFindPoles=False, AddPolePosition=nearby)
    check_skeleton(by_position.GetOutputDataObject(1), [smf.reeb_graph(body, poles=found)])
    more = graph_of(data, AddPole=[100])
    point = array(more.GetOutputDataObject(2).GetPointData(), "point")
    assert set(point[point >= 0]) == {*found, 100}
    twice = graph_of(data, AddPole=found[:2])  # those that are found besides are the others
    point = array(twice.GetOutputDataObject(2).GetPointData(), "point")
    assert set(point[point >= 0]) == set(found)


def test_poles_belong_to_the_part_that_they_are_on():
    points, faces = two_parts()
    on_torus = len(points) - 10
    graph = graph_of(poly_data(points, faces), AddPole=[on_torus])
    data = graph.GetOutputDataObject(2).GetPointData()
    point, part = array(data, "point"), array(data, "part")
    assert part[point == on_torus].tolist() == [1]  # the body is larger
    assert np.all(part[(point >= 0) & (point != on_torus)] == 0) and np.any(part[point >= 0] == 0)


def test_detail_and_star_choose_the_loops(body):
    data = poly_data(body.vertices, body.faces)
    hierarchy = smf.reeb_graph(body).hierarchy
    modulus = min(loop.modulus for loop in hierarchy.loops)
    expected = smf.reeb_graph(body, detail=modulus / 2).number_of_arcs
    assert arcs_of(graph_of(data, SetDetail=modulus / 2)) == expected
    assert expected > arcs_of(graph_of(data)) > arcs_of(graph_of(data, SetStar=True)) == 5


def test_openings_are_ends_or_filled(tube):
    data = poly_data(tube.vertices, tube.faces)
    border = np.concatenate([tube.openings[0], tube.openings[0][:1]])
    length = np.linalg.norm(np.diff(tube.vertices[border], axis=0), axis=1).sum()

    def kinds(**properties):
        nodes = graph_of(data, **properties).GetOutputDataObject(2)
        return sorted(array(nodes.GetPointData(), "kind"))

    assert kinds() == kinds(SetOpenings=vtk_filter.KEEP_OPENINGS) == [3, 3]
    assert kinds(SetOpenings=vtk_filter.FILL_OPENINGS) == [0, 0]
    up_to = vtk_filter.FILL_UP_TO_LENGTH
    assert kinds(SetOpenings=up_to, SetFillLength=0.9 * length) == [3, 3]
    assert kinds(SetOpenings=up_to, SetFillLength=1.1 * length) == [0, 0]


def test_what_does_not_change_is_kept(body, monkeypatch):
    calls = []
    find = vtk_filter.find_poles
    monkeypatch.setattr(
        vtk_filter, "find_poles", lambda *args, **more: calls.append(1) or find(*args, **more)
    )
    data = poly_data(body.vertices, body.faces)
    graph = graph_of(data)
    for number, change in enumerate(
        [lambda: graph.AddPole(100), lambda: graph.SetDetail(0.3), lambda: graph.ClearPoles()]
    ):
        change()
        graph.Update()
        assert len(calls) == 1, number
    time = graph.GetMTime()
    graph.SetDetail(0.3)
    assert graph.GetMTime() == time
    graph.SetRepair(True)
    graph.Update()
    assert len(calls) == 2
    data.GetPoints().Modified()
    data.Modified()
    graph.Update()
    assert len(calls) == 3


def broken(points, faces):
    faces = faces.copy()
    faces[3] = faces[3][::-1]
    return poly_data(points, faces)


@pytest.mark.parametrize(
    "data, properties, text",
    [
        (lambda p, f: broken(p, f), {}, "orient"),
        (lambda p, f: vtkPolyData(), {}, "no faces"),
        (lambda p, f: poly_data(p, f[:0]), {}, "no faces"),
        (lambda p, f: poly_data(p, f), {"AddPole": [10**6]}, "there is no point 1000000"),
        (lambda p, f: poly_data(p, f), {"AddPole": [-1]}, "there is no point -1"),
        (lambda p, f: poly_data(p, f), {"AddPole": [5, 5]}, "pole"),
        (lambda p, f: poly_data(p, f), {"AddPolePosition": [[0, np.nan, 0]]}, "finite"),
        (lambda p, f: poly_data(p, f), {"SetFindPoles": False}, "pole"),
        (lambda p, f: poly_data(p, f), {"SetDetail": -1.0}, "modulus"),
        (lambda p, f: poly_data(p, f), {"SetDetail": np.nan}, "NaN"),
        (lambda p, f: poly_data(p, f), {"SetOpenings": 9}, "openings"),
        (lambda p, f: poly_data(p, f), {"SetOpenings": 3, "SetFillLength": np.nan}, "NaN"),
    ],
)
def test_what_is_wrong_is_reported(data, properties, text, messages):
    graph = graph_of(data(*shapes.body()), **properties)
    assert text in str(graph.error)
    assert text in messages() and "Foliation Reeb Graph: " in messages()
    for port in range(3):
        assert graph.GetOutputDataObject(port).GetNumberOfPoints() == 0


def test_after_an_error_the_filter_works_again(body, messages):
    graph = graph_of(poly_data(body.vertices, body.faces))
    arcs = arcs_of(graph)
    graph.AddPole(10**6)
    graph.Update()
    assert graph.error is not None and arcs_of(graph) == 0
    graph.ClearPoles()
    graph.Update()
    assert graph.error is None and arcs_of(graph) == arcs


def test_data_of_another_kind_is_refused_by_vtk(messages):
    graph = vtk_filter.FoliationReebGraph()
    graph.SetInputDataObject(vtkUnstructuredGrid())
    graph.Update()
    assert "vtkPolyData is required" in messages()


def test_the_code_of_the_manual_runs(body, tmp_path, monkeypatch):
    manual = PYTHON.parent / "doc/Surface_mesh_foliation/python.txt"
    text = manual.read_text().split("\\section SMFPythonVtk", 1)[1]
    (tmp_path / "vtk.txt").write_text(text)
    names = {"poly_data": poly_data(body.vertices, body.faces)}
    names = run_block(
        tmp_path / "vtk.txt", "\\code{.py}\n", "\\endcode", tmp_path, monkeypatch, names
    )
    assert names["skeleton"].GetNumberOfCells() == names["r"].number_of_arcs
    assert names["segmented"].GetCellData().GetArray("id") is not None
    assert names["nodes"].GetNumberOfPoints() == names["r"].number_of_nodes
