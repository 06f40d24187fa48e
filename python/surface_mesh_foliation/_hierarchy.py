# SPDX-License-Identifier: GPL-3.0-or-later
"""Canonical loops, which the shape itself decides, by their moduli."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Sequence

from . import _core
from ._arrays import count, integer
from ._loops import Loop, as_loop
from ._mesh import Mesh, as_mesh

DEFAULT_MIN_MODULUS = _core.default_min_modulus
DEFAULT_PROXY_VERTICES = 5000


class CanonicalLoop(NamedTuple):
    """A loop of a hierarchy.

    Attributes
    ----------
    loop : Loop
        The loop, disjoint from all others of the hierarchy.
    modulus : float
        The largest ratio of height to circumference of an annulus in its homotopy class.
    dominance : float
        The modulus divided by the largest one found of a class that crosses it, or infinity.
    is_separating : bool
        Whether the surface falls apart along it.
    cuts_handle : bool
        Whether the surface loses a handle if it is cut along it after all loops before it.
    parent : int
        The position of the last loop before it that bounds the piece it divides, or -1.
    """

    loop: Loop
    modulus: float
    dominance: float
    is_separating: bool
    cuts_handle: bool
    parent: int

    def margin(self, min_modulus: float = DEFAULT_MIN_MODULUS) -> float:
        """Return the factor of deformation up to which the loop remains canonical."""
        return min(self.modulus / min_modulus, math.sqrt(self.dominance))

    def is_near_bound(self, min_modulus: float = DEFAULT_MIN_MODULUS) -> bool:
        """Return whether a shape not much different has another graph."""
        return min_modulus * 5 / 6 <= self.modulus <= min_modulus * 7 / 6


class LoopHierarchy(NamedTuple):
    """Disjoint loops that cut a surface with poles into pairs of pants, by falling modulus.

    ``is_complete`` tells whether they do. No other separating class has a modulus above
    ``completeness_bound``, which is infinite where that is not known.
    """

    loops: list[CanonicalLoop]
    is_complete: bool
    completeness_bound: float

    def level(
        self, min_modulus: float = DEFAULT_MIN_MODULUS, show_handles: bool = True
    ) -> list[int]:
        """Return the positions of the loops with at least this modulus.

        With ``show_handles``, those below are added without which a handle is not shown.
        """
        if not min_modulus >= 0:
            raise ValueError(f"the least modulus, {min_modulus}, is not at least 0")
        return [
            i
            for i, loop in enumerate(self.loops)
            if loop.modulus >= min_modulus or (show_handles and loop.cuts_handle)
        ]


def hierarchy_of(
    mesh: Mesh, entries: Sequence[Any], proxy_vertices: int = DEFAULT_PROXY_VERTICES
) -> LoopHierarchy:
    loops, is_complete, bound = _core.loop_hierarchy(mesh._core, list(entries), proxy_vertices)
    found = [CanonicalLoop(Loop(*fields[0]), *fields[1:]) for fields in loops]
    return LoopHierarchy(found, is_complete, bound)


def loop_hierarchy(
    mesh: Any,
    poles: Any,
    lines: Any = (),
    *,
    number_of_proxy_vertices: int = DEFAULT_PROXY_VERTICES,
) -> LoopHierarchy:
    """Return the loops that the shape decides, on all levels of detail.

    Parameters
    ----------
    mesh : Mesh
        The mesh. Its openings count as poles.
    poles, lines
        The poles, see `reeb_graph`.
    number_of_proxy_vertices : int
        The number of vertices of the coarser mesh that moduli are computed on.
    """
    from ._input import given_poles, openings

    surface = as_mesh(mesh)
    entries = given_poles(poles, lines) + openings(surface)
    number = count(number_of_proxy_vertices, "number_of_proxy_vertices")
    return hierarchy_of(surface, entries, number)


def loop_modulus(
    mesh: Any,
    loop: Any,
    *,
    poles: Any = (),
    lines: Any = (),
    number_of_proxy_vertices: int = DEFAULT_PROXY_VERTICES,
) -> float:
    """Return the modulus of the homotopy class of a loop: height divided by circumference.

    Parameters
    ----------
    mesh : Mesh
        The mesh. Its openings count as poles.
    loop : Loop or int
        The loop, or the number of a pole, around which it runs: poles, lines, then openings.
    poles, lines
        The poles, see `reeb_graph`: the class is one on the mesh without them.
    number_of_proxy_vertices : int
        The number of vertices of the coarser mesh that the modulus is computed on.
    """
    from ._input import NO_VERTICES, Entry, given_poles, openings

    surface = as_mesh(mesh)
    entries = given_poles(poles, lines) + openings(surface)
    if isinstance(loop, tuple):
        entries.append(Entry(NO_VERTICES, -1, as_loop(loop), 1.0))
        id_of_loop = len(entries) - 1
    else:
        id_of_loop = integer(loop, "loop")
        if not 0 <= id_of_loop < len(entries):
            raise ValueError(f"there is no pole {id_of_loop}; there are {len(entries)}")
    number = count(number_of_proxy_vertices, "number_of_proxy_vertices")
    return _core.loop_modulus(surface._core, entries, id_of_loop, number)


