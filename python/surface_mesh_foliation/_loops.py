# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops on a mesh, made in several ways."""

from __future__ import annotations

from typing import Any, Iterable, NamedTuple

import numpy as np

from . import _core
from ._arrays import Floats, Ints, floats, integer, ints, path, real, sequence, values_of
from ._mesh import as_mesh


class Loop(NamedTuple):
    """A closed curve, given by the edges that it crosses, in order.

    Attributes
    ----------
    edges : array of int, shape (n, 2)
        The vertices of each edge, such that the second one lies to the left of the loop.
    positions : array of float, shape (n,)
        Where the edge is crossed: 0 at its first vertex, 1 at its second.
    """

    edges: Ints
    positions: Floats

    def points(self, mesh: Any) -> Floats:
        """Return the points where the loop crosses edges, shape (n, 3)."""
        return _core.points_of_loop(as_mesh(mesh)._core, as_loop(self))

    def reversed(self) -> Loop:
        """Return the loop that runs the other way."""
        return Loop(
            np.ascontiguousarray(self.edges[::-1, ::-1]),
            np.ascontiguousarray(1 - self.positions[::-1]),
        )


def as_loop(loop: Any, name: str = "loop") -> Loop:
    """Return a loop that is given as one, or as a pair of edges and positions."""
    if not isinstance(loop, (tuple, list)) or len(loop) != 2:
        raise TypeError(f"{name} must be a Loop, not {loop!r}")
    edges = ints(loop[0], f"{name}: edges", 2)
    positions = floats(loop[1], f"{name}: positions")
    if len(edges) != len(positions):
        raise ValueError(f"{name}: {len(positions)} positions for {len(edges)} edges")
    return Loop(edges, positions)


def _loops(pairs: Iterable[tuple[Ints, Floats]]) -> list[Loop]:
    return [Loop(*pair) for pair in pairs]


def loop_along(mesh: Any, cycle: Any) -> Loop:
    """Return a closed walk along edges, pushed off to its left.

    Parameters
    ----------
    mesh : Mesh
        The mesh.
    cycle : array_like of int
        At least three vertices, each joined to the next by an edge, and the last to the first.
    """
    return Loop(*_core.loop_along(as_mesh(mesh)._core, ints(cycle, "cycle")))


def loop_through(mesh: Any, vertices: Any, *, poles: Any = (), lines: Any = ()) -> Loop:
    """Return the shortest simple loop along edges through vertices that a user has picked.

    Parameters
    ----------
    mesh : Mesh
        The mesh.
    vertices : array_like of int
        At least three vertices, in order.
    poles, lines
        Poles that the loop keeps clear of, and that it has to separate; see `reeb_graph`.
    """
    from ._input import given_poles

    surface = as_mesh(mesh)
    entries = given_poles(poles, lines)
    return Loop(*_core.loop_through(surface._core, ints(vertices, "vertices"), entries))


def loops_around(mesh: Any, vertices: Any) -> list[Loop]:
    """Return the curves that separate a set of vertices from the others, the set to their left."""
    return _loops(_core.loops_around(as_mesh(mesh)._core, ints(vertices, "vertices")))


def plane_loops(mesh: Any, plane: Any) -> list[Loop]:
    """Return the curves in which the plane ax + by + cz + d = 0 meets the mesh.

    Parameters
    ----------
    mesh : Mesh
        The mesh.
    plane : array_like, shape (4,)
        The numbers a, b, c, d. The side where the sum is positive lies to the left.
    """
    return _loops(_core.plane_loops(as_mesh(mesh)._core, _plane(plane)))


def plane_loop(mesh: Any, plane: Any, near: int) -> Loop:
    """Return the curve of a plane section that comes nearest to a vertex."""
    core = as_mesh(mesh)._core
    return Loop(*_core.plane_loop(core, _plane(plane), integer(near, "near")))


def _plane(plane: Any) -> Floats:
    numbers = floats(plane, "plane")
    if len(numbers) != 4 or not np.all(np.isfinite(numbers)):
        raise ValueError("plane: four finite numbers a, b, c, d are needed")
    return numbers


def isoline_loops(mesh: Any, values: Any, level: float) -> list[Loop]:
    """Return the curves where a function, given at the vertices, takes a value."""
    surface = as_mesh(mesh)
    function = values_of(values, "values", surface.number_of_vertices, "vertices")
    if not np.all(np.isfinite(function)):
        vertex = int(np.argmin(np.isfinite(function)))
        raise ValueError(f"values: the value of vertex {vertex} is not finite")
    return _loops(_core.isoline_loops(surface._core, function, real(level, "level")))


def pole_loop(mesh: Any, vertex: int, rings: int = 1) -> Loop:
    """Return the loop around all vertices within ``rings - 1`` edges of a vertex."""
    core = as_mesh(mesh)._core
    return Loop(*_core.pole_loop(core, integer(vertex, "vertex"), integer(rings, "rings")))


def read_loops(mesh: Any, file: Any) -> list[Loop]:
    """Read a loops file, as the main program does."""
    return _loops(_core.read_loops(as_mesh(mesh)._core, path(file)))


def write_loops(mesh: Any, file: Any, loops: Iterable[Loop]) -> None:
    """Write a loops file, which `read_loops` and the main program read."""
    checked = [as_loop(loop, f"loop {i}") for i, loop in enumerate(sequence(loops, "loops"))]
    _core.write_loops(as_mesh(mesh)._core, path(file), checked)
