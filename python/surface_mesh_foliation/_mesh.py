# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes: from arrays, files, and objects of other libraries."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, NamedTuple, Optional, Union

import numpy as np

from . import _core
from ._arrays import Bools, Floats, Ints, floats, ints, path, read_only, real, sequence

Borders = Union[str, float, None]


class RepairReport(NamedTuple):
    """What a repair did, and what became of vertices and faces.

    ``vertex_origins`` and ``face_origins`` have, for each vertex or face of the result, the one
    of the input that it comes from, or -1. ``vertices`` has, for each vertex of the input, the
    one that stands for it, or -1; face ``f`` of the input became the faces from
    ``first_faces[f]`` up to, but not including, ``first_faces[f + 1]``.
    """

    merged_vertices: int
    triangulated_faces: int
    degenerate_faces: int
    repeated_faces: int
    reversed_faces: int
    duplicated_vertices: int
    stitched_edges: int
    unused_vertices: int
    descriptions: list[str]
    vertex_origins: Ints
    face_origins: Ints
    vertices: Ints
    first_faces: Ints


class MeshPart(NamedTuple):
    """A connected component: a mesh, and the numbers that its vertices and faces had before."""

    mesh: Mesh
    vertices: Ints
    faces: Ints


class Mesh:
    """An oriented manifold of triangles, perhaps with openings, which does not change.

    Parameters
    ----------
    vertices : array_like, shape (V, 3)
        The coordinates of the vertices.
    faces : array_like of int, shape (F, 3)
        The corners of the faces, counterclockwise seen from outside. If ``repair`` is true, faces
        may have any number of corners: an array of the shape (F, k), or a list of lists.
    repair : bool
        Make an oriented manifold of whatever is given, and report that in ``repair_report``.
        Otherwise, what is not one is refused.
    borders : {"ends", "fill"}, float or None
        What to do with openings: make them ends of the graph, fill all of them, or fill those with
        a border of at most this length; ``None`` stands for a twentieth of the diagonal of the
        bounding box. New vertices and faces come behind those that are given.

    Raises
    ------
    MeshError
        If the arrays are not such a mesh: the exception says what is wrong, and where.
    TypeError, ValueError
        If an array has the wrong type or shape.
    """

    def __init__(
        self, vertices: Any, faces: Any, *, repair: bool = False, borders: Borders = "ends"
    ) -> None:
        length = _fill_length(borders)
        points = floats(vertices, "vertices", 3)
        self._core: _core.Mesh
        self.repair_report: Optional[RepairReport] = None
        if repair:
            corners, first = _polygons(faces)
            self._core, report = _core.repaired_mesh_of_polygons(points, corners, first, length)
            self.repair_report = RepairReport(**report)
        else:
            self._core = _core.mesh_of_triangles(points, ints(faces, "faces", 3), length)

    @classmethod
    def _of_core(cls, core: _core.Mesh, report: Optional[RepairReport]) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._core = core
        mesh.repair_report = report
        return mesh

    @property
    def number_of_vertices(self) -> int:
        """The number of vertices, V."""
        return len(self.vertices)

    @property
    def number_of_faces(self) -> int:
        """The number of faces, F."""
        return len(self.faces)

    @property
    def number_of_edges(self) -> int:
        """The number of edges, E."""
        return (3 * self.number_of_faces + sum(map(len, self.openings))) // 2

    @property
    def euler_characteristic(self) -> int:
        """The Euler characteristic of the surface, its openings closed: 2 for a sphere."""
        open_surface = self.number_of_vertices - self.number_of_edges + self.number_of_faces
        return open_surface + len(self.openings)

    @cached_property
    def vertices(self) -> Floats:
        """The coordinates of the vertices, shape (V, 3). Nothing is copied."""
        return self._core.vertices

    @cached_property
    def faces(self) -> Ints:
        """The corners of the faces, shape (F, 3)."""
        return read_only(self._core.faces)

    @cached_property
    def edges(self) -> Ints:
        """The ends of the edges, shape (E, 2): edge values are in this order."""
        return read_only(self._core.edges)

    @cached_property
    def is_filled(self) -> Bools:
        """For each face, whether it was made to fill an opening."""
        return read_only(self._core.is_filled)

    @cached_property
    def number_of_filled_openings(self) -> int:
        """How many openings were filled."""
        return self._core.number_of_filled_openings

    @cached_property
    def openings(self) -> list[Ints]:
        """The vertices around each opening."""
        return self._core.openings

    @cached_property
    def _parts(self) -> list[tuple[Ints, Ints]]:
        return self._core.parts()

    @property
    def number_of_parts(self) -> int:
        """The number of connected components; a graph needs a mesh that has one."""
        return len(self._parts)

    @property
    def genus(self) -> int:
        """The number of handles, of all parts together; openings are none."""
        return self.number_of_parts - self.euler_characteristic // 2

    def parts(self) -> list[MeshPart]:
        """Take the mesh apart into connected components, the largest first."""
        if self.number_of_parts == 1:
            numbers = np.arange(self.number_of_vertices), np.arange(self.number_of_faces)
            return [MeshPart(self, *numbers)]
        return [self._part(vertices, faces) for vertices, faces in self._parts]

    def _part(self, vertices: Ints, faces: Ints) -> MeshPart:
        number = np.full(self.number_of_vertices, -1)
        number[vertices] = np.arange(len(vertices))
        return MeshPart(Mesh(self.vertices[vertices], number[self.faces[faces]]), vertices, faces)

    def __repr__(self) -> str:
        return (
            f"Mesh({self.number_of_vertices} vertices, {self.number_of_faces} faces, "
            f"{len(self.openings)} openings)"
        )

    def __reduce__(self) -> tuple[Any, ...]:
        kept = self.is_filled, self.number_of_filled_openings
        return _restored, (np.array(self.vertices), self.faces, kept, self.repair_report)


def _restored(
    vertices: Floats, faces: Ints, filled: tuple[Bools, int], report: Optional[RepairReport]
) -> Mesh:
    mesh = Mesh(vertices, faces)
    mesh.__dict__["is_filled"], mesh.__dict__["number_of_filled_openings"] = filled
    mesh.repair_report = report
    return mesh


def read(file: Any, *, repair: bool = False, borders: Borders = None) -> Mesh:
    """Read a mesh from a file.

    Parameters
    ----------
    file : str or path
        The name of the file, which ends with ``.off``, ``.obj``, ``.ply`` or ``.stl``.
    repair, borders
        As for `Mesh`. By default, openings with short borders are filled, and others are ends.

    Raises
    ------
    FileError
        If the file cannot be read. The message names the line that is wrong.
    MeshError
        If it holds something other than a mesh.
    """
    name = path(file)
    length = _fill_length(borders)
    if not repair:
        return Mesh._of_core(_core.read_mesh(name, length), None)
    core, report = _core.read_repaired_mesh(name, length)
    return Mesh._of_core(core, RepairReport(**report))


def as_mesh(mesh: Any) -> Mesh:
    """Return a mesh, which may be given as one of another library.

    Parameters
    ----------
    mesh : Mesh, or pair of arrays, or object
        Objects have the attributes ``vertices`` and ``faces``, as those of trimesh, or
        ``vertices`` and ``triangles``, or ``points`` and ``faces``, as those of pyvista, where
        each face is preceded by its number of corners.
    """
    if isinstance(mesh, Mesh):
        return mesh
    if isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        return Mesh(*mesh)
    for points, faces in (("vertices", "faces"), ("vertices", "triangles"), ("points", "faces")):
        if hasattr(mesh, points) and hasattr(mesh, faces):
            return Mesh(getattr(mesh, points), _unpacked(getattr(mesh, faces)))
    raise TypeError(
        f"not a mesh: {type(mesh).__name__}; give a Mesh, a pair of vertices and faces, or an "
        "object with these attributes"
    )


def _unpacked(faces: Any) -> Any:
    """Return an array of triangles, of which each may be preceded by the number 3."""
    array = np.asarray(faces)
    if array.ndim != 1:
        return faces
    packed = ints(array, "faces")
    if len(packed) % 4 != 0 or np.any(packed[::4] != 3):
        raise ValueError("faces: not all of them are triangles; triangulate the mesh before")
    return packed.reshape(-1, 4)[:, 1:]


def _fill_length(borders: Borders) -> Optional[float]:
    """Return the longest border of an opening to fill; None if the package is to choose it."""
    if borders is None:
        return None
    if isinstance(borders, str):
        if borders not in ("ends", "fill"):
            raise ValueError(f"borders: {borders!r} is neither 'ends', 'fill' nor a length")
        return 0.0 if borders == "ends" else math.inf
    return real(borders, "borders")


def _polygons(faces: Any) -> tuple[Ints, Ints]:
    """Return the corners of all polygons, and where those of each begin, with the end."""
    if isinstance(faces, np.ndarray) and faces.ndim == 2:
        corners = ints(faces.reshape(-1), "faces")
        return corners, np.arange(len(faces) + 1) * faces.shape[1]
    polygons = [ints(polygon, f"face {f}") for f, polygon in enumerate(sequence(faces, "faces"))]
    sizes = [0] + [len(polygon) for polygon in polygons]
    corners = np.concatenate(polygons) if polygons else np.zeros(0, np.int64)
    return corners, np.cumsum(sizes, dtype=np.int64)
