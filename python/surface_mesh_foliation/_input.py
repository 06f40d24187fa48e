# SPDX-License-Identifier: GPL-3.0-or-later
"""Poles and loops: those that are given, and those that are found."""

from __future__ import annotations

import math
from typing import Any, NamedTuple, Optional, Sequence

import numpy as np

from . import _core
from ._arrays import Floats, Ints, floats, integer, ints, real, sequence
from ._find import find_lines, find_poles, vertices_near_lines
from ._hierarchy import LoopHierarchy, hierarchy_of
from ._loops import Loop, as_loop
from ._mesh import Mesh

NO_VERTICES = np.zeros(0, np.int64)
_MOST_LOOPS = 50  # so many loops of a pants decomposition take seconds


class Entry(NamedTuple):
    """One loop of a solver: that of a pole, which may be an opening, or another one.

    The loop id, by which results and errors call it, is the position in the list of entries.

    Attributes
    ----------
    pole : array of int
        The vertices of the pole; none if it is an opening, or if this is no pole loop.
    opening : int
        The number of the opening that is the pole, or -1.
    loop : Loop or None
        None for a loop that hugs its pole.
    height : float
        The transverse measure of its leaves.
    """

    pole: Ints
    opening: int
    loop: Optional[Loop]
    height: float

    @property
    def is_pole(self) -> bool:
        """Whether this is the loop of a pole."""
        return len(self.pole) > 0 or self.opening >= 0


class Input(NamedTuple):
    """What a foliation is to have."""

    entries: list[Entry]
    significances: dict[int, float]  # of poles that were found, by loop id
    canonical: dict[int, int]  # of canonical loops, by loop id: the position in the hierarchy
    hierarchy: Optional[LoopHierarchy]


class Request(NamedTuple):
    """The arguments of `reeb_graph` that say which poles and loops there are to be."""

    poles: Any = None
    lines: Any = None
    loops: Any = None
    heights: Any = None
    detail: Optional[float] = None
    star: bool = False
    min_loop_length: float = 0.0


def pole_entry(vertices: Any, name: str) -> Entry:
    """Return the entry of a pole that is a vertex, or a path of vertices."""
    is_path = isinstance(vertices, (list, tuple, np.ndarray)) and np.ndim(vertices) > 0
    pole = ints(vertices, name) if is_path else np.array([integer(vertices, name)])
    if len(pole) == 0:
        raise ValueError(f"{name} has no vertex")
    return Entry(pole, -1, None, 1.0)


def given_poles(poles: Any, lines: Any) -> list[Entry]:
    """Return the entries of poles and line poles that are given."""
    entries = [pole_entry(p, f"pole {i}") for i, p in enumerate(sequence(poles, "poles"))]
    for i, line in enumerate(sequence(lines, "lines")):
        entries.append(pole_entry(ints(line, f"line {i}"), f"line {i}"))
    return entries


def openings(mesh: Mesh) -> list[Entry]:
    """Return the entries of the openings, which are poles, too."""
    return [Entry(NO_VERTICES, i, None, 1.0) for i in range(len(mesh.openings))]


def collect(mesh: Mesh, request: Request) -> Input:
    """Return given poles and lines, openings, lines and poles found, and loops, in this order."""
    _check(request)
    finds_lines = isinstance(request.lines, str)
    given_lines = () if finds_lines or request.lines is None else request.lines
    entries = given_poles(() if request.poles is None else request.poles, given_lines)
    entries += openings(mesh)
    lines = _add_lines(mesh, entries) if finds_lines else []
    significances = {}
    if request.poles is None:
        found = find_poles(mesh, return_significance=True)
        significances = add_poles(mesh, entries, lines, found)
    canonical: dict[int, int] = {}
    hierarchy = None
    if request.loops is not None:
        for i, loop in enumerate(sequence(request.loops, "loops")):
            entries.append(Entry(NO_VERTICES, -1, as_loop(loop, f"loop {i}"), 1.0))
    elif request.star or not (request.detail is not None or _is_simple_enough(mesh, entries)):
        _add_handle_loops(mesh, entries, request.min_loop_length)
    else:
        hierarchy = hierarchy_of(mesh, entries)
        canonical = _add_canonical_loops(entries, hierarchy, request.detail)
    return Input(_with_heights(entries, request.heights), significances, canonical, hierarchy)


def _check(request: Request) -> None:
    if isinstance(request.lines, str) and request.lines != "auto":
        raise ValueError(f"lines: {request.lines!r} is neither 'auto' nor a list of lines")
    if request.detail is not None and request.star:
        raise ValueError("detail asks for canonical loops, and star for none: give one of them")
    if request.loops is not None and (request.detail is not None or request.star):
        raise ValueError("loops are given, and detail or star ask for others: give one of them")
    if request.min_loop_length and not request.star:
        raise ValueError("min_loop_length is for loops around handles: it needs star=True")


def _add_lines(mesh: Mesh, entries: list[Entry]) -> list[Ints]:
    """Add lines that are found, except those that meet a pole."""
    lines = [line for line in find_lines(mesh) if not _occupied(mesh, entries)[line].any()]
    entries.extend(Entry(line, -1, None, 1.0) for line in lines)
    return lines


def add_poles(
    mesh: Mesh, entries: list[Entry], lines: Sequence[Ints], found: tuple[Ints, Floats]
) -> dict[int, float]:
    """Add poles that were found, except on other poles and on the blades of lines.

    Add those, too, that a foliation needs in any case. Return significances by loop id.
    """
    poles, significances = found
    occupied = _occupied(mesh, entries) | vertices_near_lines(mesh, lines)
    result = {}
    for pole, significance in zip(poles, significances):
        if not occupied[pole]:
            result[len(entries)] = float(significance)
            entries.append(Entry(np.array([pole]), -1, None, 1.0))
    for pole in _core.missing_poles(mesh._core, entries):
        result[len(entries)] = math.inf
        entries.append(Entry(np.array([pole]), -1, None, 1.0))
    return result


def _occupied(mesh: Mesh, entries: Sequence[Entry]) -> Any:
    """Return for each vertex whether it belongs to a pole."""
    result = np.zeros(mesh.number_of_vertices, bool)
    for entry in entries:
        pole = entry.pole if entry.opening < 0 else mesh.openings[entry.opening]
        result[pole[(pole >= 0) & (pole < len(result))]] = True  # others are refused later
    return result


def _is_simple_enough(mesh: Mesh, entries: Sequence[Entry]) -> bool:
    """Return whether canonical loops are found within seconds, as in the main program.

    A pants decomposition of a surface with ends has -3/2 times the Euler characteristic of the
    closed surface, plus the number of ends, loops.
    """
    return -3 * mesh.euler_characteristic // 2 + len(entries) <= _MOST_LOOPS


def _add_handle_loops(mesh: Mesh, entries: list[Entry], min_length: float) -> None:
    length = real(min_length, "min_loop_length")
    for loop in _core.handle_loops(mesh._core, entries, False, length):
        entries.append(Entry(NO_VERTICES, -1, Loop(*loop), 1.0))


def _add_canonical_loops(
    entries: list[Entry], hierarchy: LoopHierarchy, detail: Optional[float]
) -> dict[int, int]:
    result = {}
    for i in hierarchy.level() if detail is None else hierarchy.level(real(detail, "detail")):
        result[len(entries)] = i
        entries.append(Entry(NO_VERTICES, -1, hierarchy.loops[i].loop, 1.0))
    return result


def _with_heights(entries: list[Entry], heights: Any) -> list[Entry]:
    if heights is None:
        return entries
    if np.ndim(heights) == 0:
        all_heights: Floats = np.full(len(entries), real(heights, "heights"))
    else:
        all_heights = floats(heights, "heights")
    if len(all_heights) != len(entries):
        raise ValueError(f"heights: {len(all_heights)} numbers for {len(entries)} loops")
    return [entry._replace(height=float(h)) for entry, h in zip(entries, all_heights)]
