# SPDX-License-Identifier: GPL-3.0-or-later
"""Poles and lines that are found on a mesh."""

from __future__ import annotations

import math
from typing import Any, Literal, Optional, Sequence, Union, overload

import numpy as np

from . import _core
from ._arrays import Bools, Floats, Ints, real
from ._mesh import Mesh, as_mesh


@overload
def find_poles(
    mesh: Any,
    *,
    number: Optional[float] = ...,
    persistence: float = ...,
    min_significance: float = ...,
    return_significance: Literal[False] = ...,
) -> Ints: ...
@overload
def find_poles(
    mesh: Any,
    *,
    number: Optional[float] = ...,
    persistence: float = ...,
    min_significance: float = ...,
    return_significance: Literal[True],
) -> tuple[Ints, Floats]: ...
def find_poles(
    mesh: Any,
    *,
    number: Optional[float] = None,
    persistence: float = _core.default_persistence,
    min_significance: float = _core.default_min_significance,
    return_significance: bool = False,
) -> Union[Ints, tuple[Ints, Floats]]:
    """Find the ends of limbs, to be used as poles.

    They are local maxima of the average geodesic distance to all points of the surface that are
    persistent and significant.

    Parameters
    ----------
    mesh : Mesh
        The mesh.
    number : int, optional
        The largest number of poles.
    persistence : float
        The least persistence of a pole, a ratio, at least 1.
    min_significance : float
        The least significance of a pole, about the length of its limb divided by its
        circumference.
    return_significance : bool
        Whether to return the significances, too.

    Returns
    -------
    poles : array of int
        The vertices, the most persistent first.
    significances : array of float
        Only if asked for; infinite for poles that a foliation needs in any case.
    """
    poles, significances = _core.find_poles(
        as_mesh(mesh)._core,
        math.inf if number is None else real(number, "number"),
        real(persistence, "persistence"),
        real(min_significance, "min_significance"),
    )
    return (poles, significances) if return_significance else poles


def find_lines(mesh: Any) -> list[Ints]:
    """Find the rims of fins, wings and other blades, to be used as line poles."""
    return _core.find_lines(as_mesh(mesh)._core)


def vertices_near_lines(mesh: Mesh, lines: Sequence[Ints]) -> Bools:
    """Return for each vertex whether it lies on the blade of a line, where no pole is wanted."""
    result = np.zeros(mesh.number_of_vertices, bool)
    if not lines:
        return result
    width = _core.default_blade_width * math.sqrt(_area(mesh))
    for vertex in np.concatenate(lines):
        distance = np.linalg.norm(mesh.vertices - mesh.vertices[vertex], axis=1)
        result |= distance < width
    return result


def _area(mesh: Mesh) -> float:
    corners = mesh.vertices[mesh.faces]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    return float(np.linalg.norm(normals, axis=1).sum()) / 2
