# SPDX-License-Identifier: GPL-3.0-or-later
"""What is computed: a foliation, and all that can be read from it."""

from __future__ import annotations

import math
from functools import cached_property
from typing import Any, Optional

import numpy as np

from . import _core
from ._arrays import Floats, Ints, count, floats, integer, path, read_only, real
from ._compare import Symmetries, symmetries
from ._hierarchy import CanonicalLoop, LoopHierarchy, hierarchy_of
from ._input import NO_VERTICES, Entry, Input
from ._loops import Loop
from ._mesh import Mesh
from ._records import (
    Certificate,
    Coordinates,
    CriticalLeaf,
    CutMesh,
    Leaf,
    Location,
    Pole,
    Singularity,
    SubdividedMesh,
)
from ._skeleton import Skeleton

# More leaves are sampled where a chord between two is farther from the leaf between them than
# this part of its radius: arcs have as many points as their shape needs, as in the main program.
_CHORD_DEVIATION = 0.1
_SAMPLES = 20


class Result:
    """A certified foliation with its Reeb graph. What is not looked at is not computed.

    Arcs are numbered like loops, nodes from 0, those of poles first. End 0 of an arc lies to the
    left of its loop; of the arc of a pole, it is the pole.
    """

    def __init__(
        self, mesh: Mesh, core: _core.Result, given: Optional[Input], samples: Optional[int]
    ) -> None:
        self.mesh = mesh
        self._core = core
        self._input = given
        self._samples = samples

    @cached_property
    def _system(self) -> dict[str, Any]:
        return self._core.system

    # ===  The graph

    @cached_property
    def graph(self) -> Any:
        """The graph as a ``networkx.MultiGraph`` with all properties of nodes and arcs."""
        return self.skeleton.graph()

    @cached_property
    def skeleton(self) -> Skeleton:
        """The graph in space: polylines, radii, SWC."""
        return self.embed(self._samples)

    def embed(
        self,
        samples: Optional[int] = None,
        *,
        use_uniform_levels: bool = False,
        max_chord_deviation: float = math.inf,
        smoothing_steps: int = 0,
    ) -> Skeleton:
        """Return the graph in space with a choice of samples.

        Parameters
        ----------
        samples : int, optional
            The number of leaves that are sampled in each arc; by default, as many as its shape
            needs.
        use_uniform_levels : bool
            Whether samples have equal differences of level, rather than equal distances.
        max_chord_deviation : float
            More leaves are sampled where a chord is off by more than this part of the radius.
        smoothing_steps : int
            How many times polylines are smoothed.
        """
        deviation = real(max_chord_deviation, "max_chord_deviation")
        if samples is None:
            deviation = min(deviation, _CHORD_DEVIATION)
        number = _SAMPLES if samples is None else count(samples, "samples")
        steps = count(smoothing_steps, "smoothing_steps")
        return Skeleton(
            _core.embed(self._core, number, bool(use_uniform_levels), deviation, steps)
        )

    @property
    def genus(self) -> int:
        """The genus of the mesh."""
        return int(self._system["genus"])

    @property
    def number_of_nodes(self) -> int:
        """The number of nodes, N."""
        return int(self._system["number_of_nodes"])

    @property
    def number_of_arcs(self) -> int:
        """The number of arcs, A."""
        return len(self.ends)

    @property
    def ends(self) -> Ints:
        """The nodes at ends 0 and 1 of each arc, shape (A, 2)."""
        ends: Ints = self._system["ends"]
        return ends

    @property
    def heights(self) -> Floats:
        """The heights of the arcs, the transverse measures of their leaves, shape (A,)."""
        heights: Floats = self._system["heights"]
        return heights

    @property
    def fluxes(self) -> Floats:
        """The fluxes of the arcs, the circumferences of their flat cylinders, shape (A,)."""
        fluxes: Floats = self._system["fluxes"]
        return fluxes

    @property
    def moduli(self) -> Floats:
        """The moduli of the components in this foliation, height divided by flux, shape (A,).

        Those of the homotopy classes of loops are in `hierarchy`, or found by `loop_modulus`.
        """
        return self.heights / self.fluxes

    @cached_property
    def symmetries(self) -> Symmetries:
        """The ways to exchange arcs that are alike."""
        return symmetries(self)

    # ===  Where vertices, edges and faces of the mesh lie

    @cached_property
    def segments(self) -> Ints:
        """The component, an arc, that most of each face lies in, shape (F,)."""
        return read_only(self._core.segments())

    @cached_property
    def _cells(self) -> tuple[Ints, Ints, Floats]:
        arc, node, t = self._core.vertex_cells()
        return read_only(arc), read_only(node), read_only(t)

    @property
    def arc(self) -> Ints:
        """The arc that each vertex lies in, or -1 if it lies at a node, shape (V,)."""
        return self._cells[0]

    @property
    def node(self) -> Ints:
        """The node that each vertex lies at, or -1 if it lies in an arc, shape (V,)."""
        return self._cells[1]

    @property
    def t(self) -> Floats:
        """The distance of each vertex from end 0 of its arc; 0 at a node, shape (V,)."""
        return self._cells[2]

    @cached_property
    def edge_values(self) -> Floats:
        """The transverse measure of the leaves that cross each edge of the mesh, shape (E,)."""
        return read_only(self._core.edge_values())

    @cached_property
    def skeleton_point(self) -> Ints:
        """The point of ``skeleton.points`` that stands for the surface around each vertex, (V,).

        The thickness of the shape there is ``skeleton.point_radii[skeleton_point]``.
        """
        return read_only(_core.vertex_samples(self._core, self.skeleton._core))

    # ===  Poles and loops

    @cached_property
    def poles(self) -> list[Pole]:
        """The poles, in the order of their numbers."""
        return [
            Pole(vertices, is_opening, self._significance(number))
            for number, (vertices, is_opening) in enumerate(self._system["poles"])
        ]

    def _significance(self, pole: int) -> float:
        if self._input is None:
            return math.nan
        loops = [loop for loop, entry in enumerate(self._input.entries) if entry.is_pole]
        return self._input.significances.get(loops[pole], math.nan)

    @cached_property
    def loops(self) -> list[Loop]:
        """The loops of the arcs."""
        return [Loop(*loop) for loop in self._core.loops]

    @property
    def merged_loops(self) -> list[int]:
        """The ids of loops without an arc: 1 on a sphere with two poles, otherwise none."""
        return [int(loop) for loop in self._system["merged_loops"]]

    @property
    def canonical_loops(self) -> dict[int, CanonicalLoop]:
        """The loops that were found as canonical ones, with their moduli, by arc."""
        if self._input is None or not self._input.canonical:
            return {}
        return {arc: self.hierarchy.loops[i] for arc, i in self._input.canonical.items()}

    @cached_property
    def hierarchy(self) -> LoopHierarchy:
        """The loops that the shape decides between these poles, on all levels of detail."""
        if self._input is not None and self._input.hierarchy is not None:
            return self._input.hierarchy
        return hierarchy_of(self.mesh, [self._pole_entry(pole) for pole in self.poles])

    def _pole_entry(self, pole: Pole) -> Entry:
        if not pole.is_opening:
            return Entry(pole.vertices, -1, None, 1.0)
        border = set(pole.vertices.tolist())
        opening = [set(v.tolist()) for v in self.mesh.openings].index(border)
        return Entry(NO_VERTICES, opening, None, 1.0)

    # ===  The foliation

    @cached_property
    def certificate(self) -> Certificate:
        """What is proved of this result, and how far the solver has come."""
        statistics = dict(self._core.statistics)
        return Certificate(holds=statistics.pop("is_certified"), **statistics)

    @cached_property
    def singularities(self) -> list[Singularity]:
        """The poles and saddles of the foliation."""
        return [Singularity(*fields) for fields in self._core.singularities]

    @cached_property
    def components(self) -> CutMesh:
        """The mesh cut along the critical leaves, so that each face lies in one component."""
        return CutMesh(*self._core.components())

    @cached_property
    def subdivided(self) -> SubdividedMesh:
        """The mesh with singular faces split, so that all singularities are vertices."""
        vertices, faces, ends, values = self._core.subdivided()
        mesh = Mesh(vertices, faces)
        number = _numbers_of_edges(ends, len(vertices))
        order = np.argsort(number)
        at = np.searchsorted(number[order], _numbers_of_edges(mesh.edges, len(vertices)))
        return SubdividedMesh(mesh, read_only(values[order[at]]))

    @cached_property
    def uv(self) -> Coordinates:
        """Flat coordinates of the components, and texture coordinates."""
        return Coordinates(*_core.coordinates(self._core))

    @cached_property
    def critical_leaves(self) -> list[CriticalLeaf]:
        """The critical leaves, as polylines."""
        return [CriticalLeaf(*fields) for fields in _core.critical_leaves(self._core)]

    @cached_property
    def _tracer(self) -> _core.LeafTracer:
        return _core.LeafTracer(self._core)

    def leaf(self, arc: int, level: float) -> Leaf:
        """Return the leaf of an arc at a distance from its end 0, less than its height."""
        return Leaf(*self._tracer.leaf(integer(arc, "arc"), real(level, "level")))

    def leaf_through_vertex(self, vertex: int) -> Optional[Leaf]:
        """Return the leaf through a vertex, or None if it lies on a critical leaf or a plateau."""
        leaf = self._tracer.leaf_through_vertex(integer(vertex, "vertex"))
        return None if leaf is None else Leaf(*leaf)

    def leaf_through_point(self, face: int, coordinates: Any) -> Optional[Leaf]:
        """Return the leaf through a point of a face, or None, as for a vertex.

        Parameters
        ----------
        face : int
            The face.
        coordinates : array_like, shape (3,)
            The barycentric coordinates of the point, in the order of the corners of the face.
        """
        leaf = self._tracer.leaf_through_point(integer(face, "face"), _weights(coordinates))
        return None if leaf is None else Leaf(*leaf)

    def locate(self, face: int, coordinates: Any) -> Location:
        """Return where a point of a face lies: on a leaf of an arc, or at a node."""
        return Location(*self._tracer.locate(integer(face, "face"), _weights(coordinates)))

    def write(self, folder: Any) -> None:
        """Write files for other programs into a folder, which is made if there is none.

        They are those of the main program: the graph in GraphML and DOT; the skeleton in PLY, VTP
        and SWC; the mesh with its segments, cut into components, with the foliation, its leaves
        and its singularities, in PLY or VTP; and texture coordinates in OBJ and VTP.
        """
        import os

        name = path(folder)
        os.makedirs(name, exist_ok=True)
        _core.write_files(self._core, self.skeleton._core, name)

    def plot(self, ax: Any = None, *, surface: bool = True, labels: bool = False) -> Any:
        """Draw the mesh in the colors of its components, with the graph, by matplotlib.

        Parameters
        ----------
        ax : matplotlib axes in three dimensions, optional
            Where to draw; by default, in a new figure.
        surface : bool
            Whether to draw the mesh.
        labels : bool
            Whether to write the numbers of arcs and nodes.

        Returns
        -------
        ax
            The axes.
        """
        from ._plot import plot

        return plot(self, ax, surface, labels)

    def __reduce__(self) -> Any:
        raise TypeError("a Result cannot be pickled: pickle its skeleton, or its arrays")

    def __repr__(self) -> str:
        return (
            f"Result({self.number_of_nodes} nodes, {self.number_of_arcs} arcs, "
            f"genus {self.genus}, {len(self._system['poles'])} poles)"
        )


def _numbers_of_edges(ends: Ints, number_of_vertices: int) -> Ints:
    """Return a number for each edge that tells it from all others."""
    numbers: Ints = ends.min(axis=1) * number_of_vertices + ends.max(axis=1)
    return numbers


def _weights(coordinates: Any) -> list[float]:
    numbers = floats(coordinates, "coordinates")
    if len(numbers) != 3:
        raise ValueError(f"coordinates: {len(numbers)} numbers for three corners")
    return [float(number) for number in np.asarray(numbers)]
