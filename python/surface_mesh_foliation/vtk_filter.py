# SPDX-License-Identifier: GPL-3.0-or-later
"""Reeb graphs as a filter for pipelines of VTK, and the one that ParaView's plugin shows.

>>> from surface_mesh_foliation.vtk_filter import FoliationReebGraph
>>> graph = FoliationReebGraph()
>>> graph.SetInputConnection(reader.GetOutputPort())
>>> tube.SetInputConnection(graph.GetOutputPort(1))
"""

from __future__ import annotations

from functools import cached_property
from typing import Any, NamedTuple, Optional

import numpy as np
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData

from ._arrays import Floats, Ints
from ._errors import FoliationError
from ._find import find_poles
from ._hierarchy import DEFAULT_MIN_MODULUS
from ._input import add_poles, given_poles, openings
from ._mesh import Borders, MeshPart
from ._result import Result
from ._solver import reeb_graph
from .vtk import (
    PartResult,
    Surface,
    from_vtk,
    in_terms_of_data,
    nodes_to_vtk,
    skeleton_to_vtk,
    surface_to_vtk,
)

# What becomes of openings, by number: ParaView's enumerations have numbers.
FILL_SHORT_OPENINGS, KEEP_OPENINGS, FILL_OPENINGS, FILL_UP_TO_LENGTH = range(4)


class FoliationReebGraph(VTKPythonAlgorithmBase):  # type: ignore[misc]  # VTK has no types
    """Computes the Reeb graph of a ``vtkPolyData``, of each of its parts.

    Its outputs are those of `surface_to_vtk`, `skeleton_to_vtk` and `nodes_to_vtk`. If something is
    wrong, an error is reported as those of other filters are, ``error`` is the exception, and the
    outputs are empty. Poles that were found are kept while the input and its repair stay the same.
    """

    def __init__(self) -> None:
        super().__init__(
            nInputPorts=1, inputType="vtkPolyData", nOutputPorts=3, outputType="vtkPolyData"
        )
        self.error: Optional[Exception] = None
        self._finds_poles = True
        self._pole_ids: list[int] = []
        self._pole_positions: list[tuple[float, float, float]] = []
        self._detail = DEFAULT_MIN_MODULUS
        self._is_star = False
        self._openings = FILL_SHORT_OPENINGS
        self._fill_length = 0.0
        self._repairs = False
        self._kept: Optional[_Prepared] = None

    # ===  Properties

    def _set(self, name: str, value: Any) -> None:
        if getattr(self, name) != value:
            setattr(self, name, value)
            self.Modified()

    def SetFindPoles(self, value: bool) -> None:
        """Whether poles are found, besides those that are given. They are by default."""
        self._set("_finds_poles", bool(value))

    def AddPole(self, point: int) -> None:
        """Make a point a pole, by its id in the input."""
        self._set("_pole_ids", [*self._pole_ids, point])

    def ClearPoles(self) -> None:
        """Forget the poles that were given by id."""
        self._set("_pole_ids", [])

    def AddPolePosition(self, x: float, y: float, z: float) -> None:
        """Make the point that is nearest to a position a pole."""
        self._set("_pole_positions", [*self._pole_positions, (x, y, z)])

    def ClearPolePositions(self) -> None:
        """Forget the poles that were given by position."""
        self._set("_pole_positions", [])

    def SetDetail(self, value: float) -> None:
        """Set the least modulus of a loop that is found: a smaller one gives more loops."""
        self._set("_detail", value)

    def SetStar(self, value: bool) -> None:
        """Whether only loops around handles are found: without handles, the graph is a star."""
        self._set("_is_star", bool(value))

    def SetOpenings(self, value: int) -> None:
        """Set what becomes of openings: each is an end of the graph, unless it is filled.

        ``FILL_SHORT_OPENINGS`` is the default; ``KEEP_OPENINGS`` fills none, ``FILL_OPENINGS`` all,
        and ``FILL_UP_TO_LENGTH`` those with a border of at most the length that is set.
        """
        self._set("_openings", value)

    def SetFillLength(self, value: float) -> None:
        """Set the longest border of an opening to fill, for ``FILL_UP_TO_LENGTH``."""
        self._set("_fill_length", value)

    def SetRepair(self, value: bool) -> None:
        """Whether the input is repaired. By default, what is no oriented manifold is refused."""
        self._set("_repairs", bool(value))

    # ===  The run

    def RequestData(self, request: Any, inputs: Any, outputs: Any) -> int:
        """Called by VTK."""
        data = [vtkPolyData.GetData(outputs, port) for port in range(3)]
        try:
            results = self._computed(vtkPolyData.GetData(inputs[0]))
            self.error = None
        except Exception as error:
            for output in data:
                output.Initialize()
            self._report(error)
            return 0
        for output, result in zip(data, results):
            output.ShallowCopy(result)
        return 1

    def _report(self, error: Exception) -> None:
        self.error = error
        expected = isinstance(error, (FoliationError, TypeError, ValueError))
        text = str(error) if expected else f"{type(error).__name__}: {error}"
        vtkOutputWindow.GetInstance().DisplayErrorText(f"Foliation Reeb Graph: {text}\n")

    def _computed(self, data: Any) -> tuple[Any, Any, Any]:
        prepared = self._prepared(data)
        surface = prepared.surface
        poles = [surface.vertex_of(point) for point in self._pole_ids]
        poles += [surface.nearest_vertex(position) for position in self._pole_positions]
        results = []
        for part in prepared.parts:
            results.append(PartResult(self._result(part, poles), part.vertices, part.faces))
            self.UpdateProgress(len(results) / (len(prepared.parts) + 1))
        return (
            surface_to_vtk(results, surface),
            skeleton_to_vtk(results),
            nodes_to_vtk(results, surface),
        )

    def _prepared(self, data: Any) -> _Prepared:
        borders = self._borders()
        key = data.GetMTime(), self._repairs, borders
        if self._kept is None or self._kept.surface.data is not data or self._kept.key != key:
            surface = from_vtk(data, repair=self._repairs, borders=borders)
            self._kept = _Prepared(key, surface, [_Part(surface, p) for p in surface.mesh.parts()])
        return self._kept

    def _borders(self) -> Borders:
        choices: dict[int, Borders] = {
            FILL_SHORT_OPENINGS: None,
            KEEP_OPENINGS: "ends",
            FILL_OPENINGS: "fill",
            FILL_UP_TO_LENGTH: self._fill_length,
        }
        if self._openings not in choices:
            raise ValueError(f"openings, {self._openings}, is none of {list(choices)}")
        return choices[self._openings]

    def _result(self, part: _Part, poles: list[int]) -> Result:
        has_default_detail = self._is_star or self._detail == DEFAULT_MIN_MODULUS
        try:
            return reeb_graph(
                part.mesh,
                poles=part.poles(poles, self._finds_poles),
                detail=None if has_default_detail else self._detail,
                star=self._is_star,
            )
        except FoliationError as error:
            raise in_terms_of_data(error, part.points, part.cells) from None


class _Part:
    """A part of a surface, and the poles found on it."""

    def __init__(self, surface: Surface, part: MeshPart) -> None:
        self.mesh, self.vertices, self.faces = part
        self.points, self.cells = surface.points[part.vertices], surface.cells[part.faces]
        self._number = np.full(surface.mesh.number_of_vertices, -1)  # in the part, or -1
        self._number[part.vertices] = np.arange(len(part.vertices))

    @cached_property
    def _found(self) -> tuple[Ints, Floats]:
        return find_poles(self.mesh, return_significance=True)

    def poles(self, given: list[int], finds_poles: bool) -> list[Ints]:
        """Return the poles of the part: those of the given ones that lie on it, and others."""
        here = [number for number in self._number[given] if number >= 0] if given else []
        entries = given_poles(here, ()) + openings(self.mesh)
        if finds_poles:
            add_poles(self.mesh, entries, (), self._found)
        return [entry.pole for entry in entries if entry.opening < 0]


class _Prepared(NamedTuple):
    """What is kept of an input: the key says from which one it was made, and how."""

    key: tuple[Any, ...]
    surface: Surface
    parts: list[_Part]
