# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes from VTK, and results for VTK and ParaView.

>>> from surface_mesh_foliation import vtk as smf_vtk
>>> surface = smf_vtk.from_vtk(poly_data)
>>> r = smf.reeb_graph(surface.mesh)
>>> smf_vtk.surface_to_vtk(r, surface)    # with the arrays of the input, and more
>>> smf_vtk.skeleton_to_vtk(r)
>>> smf_vtk.nodes_to_vtk(r)

The arrays are called as in the files that `Result.write` writes. It needs VTK's own module,
``vtkmodules``, of any version from 9.0; ParaView has one, too. The same as a filter for pipelines
is in `surface_mesh_foliation.vtk_filter`.
"""

from __future__ import annotations

from typing import Any, Iterable, Iterator, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np
from vtkmodules.util.numpy_support import (
    numpy_to_vtk,
    numpy_to_vtkIdTypeArray,
    vtk_to_numpy,
)
from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkTriangleFilter

from ._arrays import Floats, Ints, floats, integer
from ._errors import FoliationError
from ._mesh import Borders, Mesh, as_mesh
from ._result import Result

_NODE_KINDS = ("pole", "saddle", "regular", "boundary")  # numbered as in C++
_CELL_IDS = "surface_mesh_foliation_cell_ids"


class Surface(NamedTuple):
    """What a ``vtkPolyData`` became: a mesh, and where its vertices and faces come from.

    Attributes
    ----------
    mesh : Mesh
        The mesh, without points that no face uses.
    data : vtkPolyData
        The input.
    points : array of int, shape (V,)
        The point that each vertex comes from, or -1 if it was made.
    cells : array of int, shape (F,)
        The cell that each face is a part of, or -1 if it fills an opening.
    vertices : array of int
        The vertex that stands for each point, or -1.
    """

    mesh: Mesh
    data: Any
    points: Ints
    cells: Ints
    vertices: Ints

    def vertex_of(self, point: Any) -> int:
        """Return the vertex that stands for a point, by the id of the point."""
        number = integer(point, "point")
        if not 0 <= number < len(self.vertices):
            raise ValueError(f"there is no point {number}; there are {len(self.vertices)}")
        if self.vertices[number] < 0:
            raise ValueError(f"point {number} is on no face, so that it cannot be a pole")
        return int(self.vertices[number])

    def nearest_vertex(self, position: Any) -> int:
        """Return the vertex that is nearest to a position, except those that were made."""
        target = floats(position, "position")
        if len(target) != 3 or not np.all(np.isfinite(target)):
            raise ValueError("a position has three finite coordinates")
        given = np.flatnonzero(self.points >= 0)
        squares = ((self.mesh.vertices[given] - target) ** 2).sum(axis=1)
        return int(given[np.argmin(squares)])


class PartResult(NamedTuple):
    """The result of a part of a mesh, and the numbers of its vertices and faces in the mesh."""

    result: Result
    vertices: Ints
    faces: Ints


Results = Union[Result, Sequence[PartResult]]


# ===  From VTK


def from_vtk(data: Any, *, repair: bool = False, borders: Borders = "ends") -> Surface:
    """Make a mesh of the faces of a ``vtkPolyData``.

    Polygons and triangle strips are cut into triangles; vertices and lines are left out, and so are
    points that no face uses.

    Parameters
    ----------
    data : vtkPolyData
        The surface.
    repair, borders
        As for `Mesh`.

    Raises
    ------
    MeshError
        If this is no mesh. The attributes of the exception have numbers of points and cells.
    TypeError
        If it is another kind of data.
    """
    if not isinstance(data, vtkPolyData):
        kind = data.GetClassName() if hasattr(data, "GetClassName") else type(data).__name__
        raise TypeError(
            f"a vtkPolyData is needed, not {kind}: extract the surface before, in ParaView by the "
            "filter Extract Surface"
        )
    for cells in (data.GetPolys(), data.GetStrips()):
        _check_points(cells, data.GetNumberOfPoints())
    corners, cells = _triangles(data, repair)
    if len(cells) == 0:
        raise ValueError("the data has no faces")
    used = np.unique(corners)
    number = np.full(data.GetNumberOfPoints(), -1)
    number[used] = np.arange(len(used))
    positions = vtk_to_numpy(data.GetPoints().GetData())[used]
    try:
        mesh = Mesh(positions, number[corners], repair=repair, borders=borders)
    except FoliationError as error:
        raise in_terms_of_data(error, used, cells) from None
    return _traced(mesh, data, used, cells)


def _check_points(cells: Any, number_of_points: int) -> None:
    """Check what VTK takes for granted."""
    points = vtk_to_numpy(cells.GetConnectivityArray())
    if len(points) > 0 and not 0 <= points.min() <= points.max() < number_of_points:
        wrong = points.min() if points.min() < 0 else points.max()
        raise ValueError(f"a cell has the point {wrong}, but there are {number_of_points} points")


def _triangles(data: Any, repair: bool) -> tuple[Ints, Ints]:
    """Return the corners of all triangles, and the cell that each is a part of."""
    first = data.GetNumberOfVerts() + data.GetNumberOfLines()
    polygons = data.GetPolys()
    if data.GetNumberOfStrips() == 0 and polygons.IsHomogeneous() == 3:
        corners = vtk_to_numpy(polygons.GetConnectivityArray()).reshape(-1, 3)
        return corners.astype(np.int64), np.arange(first, first + len(corners))
    copy = vtkPolyData()
    copy.CopyStructure(data)
    ids = numpy_to_vtkIdTypeArray(np.arange(data.GetNumberOfCells()), deep=True)
    ids.SetName(_CELL_IDS)
    copy.GetCellData().AddArray(ids)
    triangulate = vtkTriangleFilter()
    triangulate.SetInputData(copy)
    triangulate.PassVertsOff()
    triangulate.PassLinesOff()
    triangulate.Update()
    output = triangulate.GetOutput()
    if output.GetNumberOfPolys() == 0:
        return np.zeros((0, 3), np.int64), np.zeros(0, np.int64)
    corners = vtk_to_numpy(output.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    cells = vtk_to_numpy(output.GetCellData().GetArray(_CELL_IDS))
    _check_none_is_missing(np.arange(first, data.GetNumberOfCells()), cells, repair)
    return corners.astype(np.int64), cells.astype(np.int64)


def _check_none_is_missing(faces: Ints, cells: Ints, repair: bool) -> None:
    missing = np.setdiff1d(faces, cells)
    if len(missing) > 0 and not repair:
        raise ValueError(
            f"cell {missing[0]} cannot be cut into triangles, since it is degenerate: repair the "
            "data, or remove the cell"
        )


def in_terms_of_data(error: FoliationError, points: Ints, cells: Ints) -> FoliationError:
    """Return an error that names points and cells, given those of each vertex and face."""
    points_of_error = [int(points[v]) for v in error.vertices if v < len(points)]
    cells_of_error = [int(cells[f]) for f in error.faces if f < len(cells)]
    if points_of_error == list(error.vertices) and cells_of_error == list(error.faces):
        return error
    named = [("points", points_of_error), ("cells", cells_of_error)]
    places = [f"{name} {', '.join(map(str, numbers))}" for name, numbers in named if numbers]
    message = f"{error.message} (these are {' and '.join(places)} of the data)"
    return type(error)(message, error.kind, points_of_error, cells_of_error, error.loops)


def _traced(mesh: Mesh, data: Any, used: Ints, cells: Ints) -> Surface:
    """Return the mesh with the places that its vertices and faces come from."""
    points = np.full(mesh.number_of_vertices, -1)
    faces = np.full(mesh.number_of_faces, -1)
    vertices = np.full(data.GetNumberOfPoints(), -1)
    report = mesh.repair_report  # of the mesh before openings were filled
    if report is None:
        points[: len(used)] = used
        faces[: len(cells)] = cells
        vertices[used] = np.arange(len(used))
    else:
        points[: len(report.vertex_origins)] = _taken(used, report.vertex_origins)
        faces[: len(report.face_origins)] = _taken(cells, report.face_origins)
        vertices[used] = report.vertices
    faces[mesh.is_filled] = -1
    return Surface(mesh, data, points, faces, vertices)


def _taken(numbers: Ints, origins: Ints) -> Ints:
    """Return the numbers at some positions, of which -1 stands for none."""
    return np.where(origins >= 0, numbers[origins], -1)


# ===  To VTK


def mesh_to_vtk(mesh: Any) -> Any:
    """Return a mesh, or what `as_mesh` accepts, as a ``vtkPolyData``."""
    surface = as_mesh(mesh)
    output = _poly_data(surface.vertices)
    output.SetPolys(_cell_array(surface.faces))
    return output


def surface_to_vtk(results: Results, surface: Union[Surface, Mesh, None] = None) -> Any:
    """Return the mesh, without faces that fill openings, as a ``vtkPolyData``.

    It has the point arrays ``arc`` and ``node``, of which one is -1, and ``t``, the distance from
    end 0 of the arc; and the cell arrays ``component``, the number of the arc, and ``part``.

    Parameters
    ----------
    results : Result, or sequence of PartResult
        What was computed. Arcs and nodes are numbered on from part to part.
    surface : Surface or Mesh, optional
        The mesh that all parts belong to; by default, that of the result. With a `Surface`, the
        arrays of its data are carried over, except those with one of the names above.
    """
    pieces = _pieces(results)
    mesh = _whole_mesh(results, surface)
    faces = np.flatnonzero(~mesh.is_filled)
    vertices, corners = np.unique(mesh.faces[faces], return_inverse=True)
    output = _poly_data(mesh.vertices[vertices])
    output.SetPolys(_cell_array(corners.reshape(-1, 3)))
    if isinstance(surface, Surface):
        _carry_over(surface.data.GetPointData(), surface.points[vertices], output.GetPointData())
        _carry_over(surface.data.GetCellData(), surface.cells[faces], output.GetCellData())
    _add_arrays(output.GetPointData(), _vertex_arrays(pieces, mesh), vertices)
    _add_arrays(output.GetCellData(), _face_arrays(pieces, mesh), faces)
    return output


def skeleton_to_vtk(results: Results) -> Any:
    """Return the graph in space as a ``vtkPolyData`` with a polyline for each arc.

    It has the point arrays ``radius``, and ``arc`` and ``node``, of which one is -1; and the cell
    arrays ``arc``, ``height``, ``flux``, ``modulus``, ``length``, ``area`` and ``part``.
    """
    pieces = _pieces(results)
    output = _poly_data(np.concatenate([piece.result.skeleton.points for piece in pieces]))
    output.SetLines(_cell_array([line for piece in pieces for line in _lines(piece)]))
    _add_arrays(output.GetPointData(), _joined(map(_sample_arrays, pieces)))
    _add_arrays(output.GetCellData(), _joined(map(_arc_arrays, pieces)))
    return output


def nodes_to_vtk(results: Results, surface: Optional[Surface] = None) -> Any:
    """Return the nodes of the graph as a ``vtkPolyData`` with a vertex for each.

    It has the point arrays ``node``, ``kind`` (0 for a pole, 1 for a saddle, 2 for the node of a
    torus without poles, 3 for an opening), ``pole``, the number of the pole in its part or -1,
    ``genus``, ``radius`` and ``part``; and, if the surface is given, ``point``, the id of the point
    of the data that is the pole, or -1.
    """
    pieces = _pieces(results)
    output = _poly_data(np.concatenate([piece.result.skeleton.node_points for piece in pieces]))
    output.SetVerts(_cell_array(np.arange(output.GetNumberOfPoints()).reshape(-1, 1)))
    _add_arrays(output.GetPointData(), _joined(map(_node_arrays, pieces)))
    if surface is not None:
        points = [_point_of_pole(node["pole"], piece, surface) for piece, node in _nodes(pieces)]
        _add_arrays(output.GetPointData(), {"point": points})
    return output


class _Piece(NamedTuple):
    """A part with its number, and those of its first node, arc, and point of the skeleton."""

    number: int
    result: Result
    vertices: Ints
    faces: Ints
    first_node: int
    first_arc: int
    first_point: int


def _pieces(results: Results) -> list[_Piece]:
    if isinstance(results, Result):
        mesh = results.mesh
        vertices, faces = np.arange(mesh.number_of_vertices), np.arange(mesh.number_of_faces)
        results = [PartResult(results, vertices, faces)]
    pieces: list[_Piece] = []
    node = arc = point = 0
    for number, part in enumerate(results):
        pieces.append(_Piece(number, *part, node, arc, point))
        node += part.result.number_of_nodes
        arc += part.result.number_of_arcs
        point += len(part.result.skeleton.points)
    if not pieces:
        raise ValueError("there is no result")
    return pieces


def _whole_mesh(results: Results, surface: Union[Surface, Mesh, None]) -> Mesh:
    if isinstance(surface, Surface):
        return surface.mesh
    if surface is None and not isinstance(results, Result):
        raise ValueError("surface: the mesh that the parts belong to is needed")
    return results.mesh if isinstance(results, Result) else as_mesh(surface)


def _vertex_arrays(pieces: list[_Piece], mesh: Mesh) -> dict[str, Any]:
    arc, node = (np.full(mesh.number_of_vertices, -1) for _ in range(2))
    t = np.zeros(mesh.number_of_vertices)
    for piece in pieces:
        r = piece.result
        arc[piece.vertices] = np.where(r.arc >= 0, r.arc + piece.first_arc, -1)
        node[piece.vertices] = np.where(r.node >= 0, r.node + piece.first_node, -1)
        t[piece.vertices] = r.t
    return {"arc": arc, "node": node, "t": t}


def _face_arrays(pieces: list[_Piece], mesh: Mesh) -> dict[str, Any]:
    component, part = (np.full(mesh.number_of_faces, -1) for _ in range(2))
    for piece in pieces:
        component[piece.faces] = piece.result.segments + piece.first_arc
        part[piece.faces] = piece.number
    return {"component": component, "part": part}


def _sample_arrays(piece: _Piece) -> dict[str, Any]:
    skeleton = piece.result.skeleton
    sizes = [len(line) - 2 for line in skeleton.polylines]
    no_node, no_arc = np.full(sum(sizes), -1), np.full(len(skeleton.nodes), -1)
    nodes = piece.first_node + np.arange(len(skeleton.nodes))
    arcs = piece.first_arc + np.repeat(np.arange(len(sizes)), sizes)
    return {
        "radius": skeleton.point_radii,
        "arc": np.concatenate([no_arc, arcs]),
        "node": np.concatenate([nodes, no_node]),
    }


def _lines(piece: _Piece) -> list[Ints]:
    """Return the points of each arc: those of nodes come first, then the others, arc by arc."""
    skeleton = piece.result.skeleton
    next_point = piece.first_point + len(skeleton.nodes)
    result = []
    for arc in skeleton.arcs:
        first, last = (piece.first_point + end for end in arc["ends"])
        end = next_point + len(arc["polyline"]) - 2
        result.append(np.array([first, *range(next_point, end), last]))
        next_point = end
    return result


def _arc_arrays(piece: _Piece) -> dict[str, Any]:
    arcs = piece.result.skeleton.arcs
    return {
        "arc": piece.first_arc + np.arange(len(arcs)),
        **{name: [arc[name] for arc in arcs] for name in ("height", "flux", "length", "area")},
        "modulus": piece.result.moduli,
        "part": np.full(len(arcs), piece.number),
    }


def _node_arrays(piece: _Piece) -> dict[str, Any]:
    nodes = piece.result.skeleton.nodes
    return {
        "node": piece.first_node + np.arange(len(nodes)),
        "kind": [_NODE_KINDS.index(node["kind"]) for node in nodes],
        **{name: [node[name] for node in nodes] for name in ("pole", "genus", "radius")},
        "part": np.full(len(nodes), piece.number),
    }


def _nodes(pieces: list[_Piece]) -> Iterator[tuple[_Piece, dict[str, Any]]]:
    for piece in pieces:
        for node in piece.result.skeleton.nodes:
            yield piece, node


def _point_of_pole(number: int, piece: _Piece, surface: Surface) -> int:
    if number < 0:
        return -1
    pole = piece.result.poles[number]
    is_vertex = not pole.is_opening and len(pole.vertices) == 1
    return int(surface.points[piece.vertices[pole.vertices[0]]]) if is_vertex else -1


def _joined(arrays: Iterable[dict[str, Any]]) -> dict[str, Any]:
    """Return the arrays of all pieces, one behind the other."""
    pieces = list(arrays)
    return {name: np.concatenate([piece[name] for piece in pieces]) for name in pieces[0]}


def _poly_data(positions: Floats) -> Any:
    points = vtkPoints()
    points.SetData(numpy_to_vtk(np.ascontiguousarray(positions), deep=True))
    result = vtkPolyData()
    result.SetPoints(points)
    return result


def _cell_array(cells: Union[Ints, list[Ints]]) -> Any:
    """Return the cells whose points are given, in a table if each has the same number of them."""
    if isinstance(cells, np.ndarray):
        offsets = np.arange(len(cells) + 1) * cells.shape[1]
    else:
        offsets = np.cumsum([0, *map(len, cells)])
    result = vtkCellArray()
    result.SetData(_ids(offsets), _ids(np.concatenate(cells)))
    return result


def _ids(numbers: Ints) -> Any:
    return numpy_to_vtkIdTypeArray(np.ascontiguousarray(numbers, dtype=np.int64), deep=True)


def _add_arrays(
    attributes: Any, arrays: Mapping[str, Any], taken: Union[Ints, slice] = slice(None)
) -> None:
    for name, values in arrays.items():
        values = np.asarray(values)[taken]
        dtype = np.float64 if values.dtype.kind == "f" else np.int32
        array = numpy_to_vtk(np.ascontiguousarray(values, dtype=dtype), deep=True)
        array.SetName(name)
        attributes.AddArray(array)


def _carry_over(source: Any, origins: Ints, target: Any) -> None:
    """Copy the values at some positions, of which -1 stands for none: its values are 0."""
    if np.array_equal(origins, np.arange(source.GetNumberOfTuples())):
        target.PassData(source)
        return
    target.CopyAllOn()
    target.CopyAllocate(source, len(origins))
    places = np.flatnonzero(origins >= 0)
    target.CopyData(source, _id_list(origins[places]), _id_list(places))
    for place in np.flatnonzero(origins < 0):
        target.NullData(place)


def _id_list(numbers: Ints) -> Any:
    result = vtkIdList()
    result.SetNumberOfIds(len(numbers))
    for i, number in enumerate(numbers.tolist()):
        result.SetId(i, number)
    return result
