# SPDX-License-Identifier: GPL-3.0-or-later
"""The Reeb graph in space: polylines with radii."""

from __future__ import annotations

import tempfile
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from . import _core
from ._arrays import Floats, path


class Skeleton:
    """A Reeb graph in space, whose arcs run through the centroids of leaves.

    It can be pickled, for processes and clusters, where a `Result` cannot.

    Attributes
    ----------
    nodes, arcs : list of dict
        All properties of nodes and arcs, by number.
    polylines : list of array, shape (n, 3)
        By arc: the points from the node at end 0 to that at end 1.
    radii : list of array, shape (n,)
        By arc: the radii of the leaves whose centroids the points are; 0 at a pole.
    levels, leaf_lengths : list of array, shape (n - 2,)
        By arc: of the leaves between its ends, the distance from end 0, and the length.
    points : array, shape (P, 3)
        All points: those of the nodes, then the others, arc by arc.
    point_radii : array, shape (P,)
        Their radii.
    node_points : array, shape (N, 3)
        The points of the nodes.
    node_radii : array, shape (N,)
        The radii of the nodes.
    """

    def __init__(self, core: _core.EmbeddedGraph) -> None:
        self._core = core

    @cached_property
    def nodes(self) -> list[dict[str, Any]]:
        return self._core.nodes

    @cached_property
    def arcs(self) -> list[dict[str, Any]]:
        return self._core.arcs

    @property
    def polylines(self) -> list[Floats]:
        return [arc["polyline"] for arc in self.arcs]

    @property
    def radii(self) -> list[Floats]:
        return [arc["radii"] for arc in self.arcs]

    @cached_property
    def levels(self) -> list[Floats]:
        return self._core.levels

    @cached_property
    def leaf_lengths(self) -> list[Floats]:
        return self._core.leaf_lengths

    @property
    def node_points(self) -> Floats:
        return np.array([node["point"] for node in self.nodes])

    @property
    def node_radii(self) -> Floats:
        return np.array([node["radius"] for node in self.nodes])

    @cached_property
    def points(self) -> Floats:
        return np.concatenate([self.node_points, *(line[1:-1] for line in self.polylines)])

    @cached_property
    def point_radii(self) -> Floats:
        return np.concatenate([self.node_radii, *(radii[1:-1] for radii in self.radii)])

    @property
    def length(self) -> float:
        """The length of all arcs together."""
        return float(sum(arc["length"] for arc in self.arcs))

    def write_swc(self, file: Any) -> None:
        """Write the skeleton in SWC, the format of traces of neurons."""
        self._core.write_swc(path(file))

    def swc(self) -> str:
        """Return the skeleton as the text of an SWC file."""
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder, "skeleton.swc")
            self.write_swc(file)
            return file.read_text()

    def write_graphml(self, file: Any) -> None:
        """Write the graph in GraphML, with the properties of nodes and arcs."""
        self._core.write_graphml(path(file))

    def graph(self) -> Any:
        """Return a new ``networkx.MultiGraph``, with all properties of nodes and arcs.

        The key of an edge is the number of its arc; its property ``ends`` says in which order
        its polyline runs.
        """
        import networkx

        graph = networkx.MultiGraph()
        for number, node in enumerate(self.nodes):
            graph.add_node(number, **node)
        for number, arc in enumerate(self.arcs):
            graph.add_edge(*arc["ends"], key=number, modulus=arc["height"] / arc["flux"], **arc)
        return graph

    def __reduce__(self) -> tuple[Any, ...]:
        return Skeleton, (self._core,)

    def __repr__(self) -> str:
        return f"Skeleton({len(self.nodes)} nodes, {len(self.arcs)} arcs)"
