# SPDX-License-Identifier: GPL-3.0-or-later
"""What a result consists of, as tuples with names."""

from __future__ import annotations

from typing import NamedTuple

from ._arrays import Floats, Ints
from ._mesh import Mesh


class Certificate(NamedTuple):
    """What is proved of a result, and how far the solver has come.

    ``holds`` is true of every result: the graph extracted from the foliation is the dual graph of
    the loops. ``has_converged`` tells whether the foliation is harmonic up to the tolerance.
    """

    holds: bool
    has_converged: bool
    energy: float
    optimality: float
    resolved_optimality: float
    iterations: int


class Pole(NamedTuple):
    """A pole.

    Attributes
    ----------
    vertices : array of int
        Its vertex; those of its path, if it is a line; those of the border of an opening.
    is_opening : bool
        Whether it is an opening.
    significance : float
        How much of a limb it is the end of, if it was found; NaN otherwise.
    """

    vertices: Ints
    is_opening: bool
    significance: float


class Singularity(NamedTuple):
    """A singular vertex or face.

    ``kind`` is ``"center_pole"``, ``"thorn_pole"``, ``"tripod"``, ``"morse_saddle"`` or
    ``"higher_saddle"``; ``vertex`` or ``face`` is -1.
    """

    kind: str
    index: int  # type: ignore[assignment]  # it hides a method of tuples that makes no sense here
    order: int
    node: int
    vertex: int
    face: int


class Leaf(NamedTuple):
    """A closed leaf: its arc, its distance from end 0, its points (the first also last)."""

    arc: int
    level: float
    points: Floats
    length: float
    centroid: tuple[float, float, float]


class Location(NamedTuple):
    """Where the foliation sends a point: to a level of an arc, or to a node."""

    is_arc: bool
    number: int
    level: float


class CutMesh(NamedTuple):
    """The mesh cut along the critical leaves.

    Its first vertices are those of the mesh; ``arc`` has the component of each face, and
    ``critical_edges`` the ends of edges on critical leaves.
    """

    vertices: Floats
    faces: Ints
    arc: Ints
    critical_edges: Ints


class SubdividedMesh(NamedTuple):
    """A mesh whose singularities are all vertices, and the foliation on its edges.

    Attributes
    ----------
    mesh : Mesh
        The mesh with each singular face split into three at its center. First come the vertices of
        the mesh before, then the centers.
    edge_values : array, shape (E,)
        The transverse measure of the leaves that cross each edge, in the order of ``mesh.edges``.
    """

    mesh: Mesh
    edge_values: Floats


class Coordinates(NamedTuple):
    """Flat coordinates of the components, on the mesh cut along the critical leaves.

    Attributes
    ----------
    vertices, faces, arc
        As for `CutMesh`.
    uv : array, shape (F, 3, 2)
        For each corner of a face, the position around the component, and the distance from end 0.
    texture : array, shape (F, 3, 2)
        Texture coordinates, with all charts side by side in the unit square.
    texture_size : float
        The length on the surface that the side of the square stands for.
    """

    vertices: Floats
    faces: Ints
    arc: Ints
    uv: Floats
    texture: Floats
    texture_size: float


class CriticalLeaf(NamedTuple):
    """A part of a critical leaf: its node, and its points."""

    node: int
    points: Floats
