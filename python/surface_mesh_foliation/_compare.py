# SPDX-License-Identifier: GPL-3.0-or-later
"""Graphs compared with one another and with themselves."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, NamedTuple, Optional, Union

from . import _core
from ._arrays import Ints, real
from ._skeleton import Skeleton

if TYPE_CHECKING:
    from ._result import Result

Graph = Union["Result", Skeleton]


class Matching(NamedTuple):
    """The isomorphism of two graphs for which they differ least.

    Attributes
    ----------
    nodes, arcs : array of int
        For each node or arc of the first graph, the one of the second that it is matched to.
    length_distance, area_distance, flux_distance : float
        How much of all lengths, areas and fluxes would have to be moved, from 0 to 1.
    """

    nodes: Ints
    arcs: Ints
    length_distance: float
    area_distance: float
    flux_distance: float

    @property
    def distance(self) -> float:
        """The mean of the three distances."""
        return (self.length_distance + self.area_distance + self.flux_distance) / 3


class Symmetries(NamedTuple):
    """The ways to exchange arcs of a graph that are alike.

    Attributes
    ----------
    generators : list of pairs of arrays
        Symmetries of which all are composed: the images of nodes, and of arcs.
    node_classes, arc_classes : array of int
        For each node or arc, the first one that it is exchanged with, or itself.
    is_incomplete : bool
        Whether there may be more symmetries, since the search was given up.
    """

    generators: list[tuple[Ints, Ints]]
    node_classes: Ints
    arc_classes: Ints
    is_incomplete: bool

    @property
    def arc_groups(self) -> list[list[int]]:
        """The arcs that are exchanged with others, group by group."""
        groups: dict[int, list[int]] = {}
        for arc, first in enumerate(self.arc_classes.tolist()):
            groups.setdefault(first, []).append(arc)
        return [group for group in groups.values() if len(group) > 1]


def match(first: Graph, second: Graph, *, use_pole_labels: bool = False) -> Optional[Matching]:
    """Match the graphs of two shapes, such as two poses of a body.

    Parameters
    ----------
    first, second : Result or Skeleton
        The graphs.
    use_pole_labels : bool
        Whether only poles of the same number match, as if they were given in the same order.

    Returns
    -------
    Matching or None
        None if the graphs are not isomorphic.
    """
    found = _core.match(as_skeleton(first)._core, as_skeleton(second)._core, bool(use_pole_labels))
    return None if found is None else Matching(*found)


def distance(first: Graph, second: Graph, *, use_pole_labels: bool = False) -> float:
    """Return the distance of two graphs, from 0 to 1; infinity if they are not isomorphic."""
    matching = match(first, second, use_pole_labels=use_pole_labels)
    return math.inf if matching is None else matching.distance


def symmetries(graph: Graph, tolerance: float = 0.2) -> Symmetries:
    """Return the symmetries of a graph.

    Parameters
    ----------
    graph : Result or Skeleton
        The graph.
    tolerance : float
        The largest difference of two lengths, areas or fluxes that count as equal, as a share of
        the larger one.
    """
    return Symmetries(*_core.symmetries(as_skeleton(graph)._core, real(tolerance, "tolerance")))


def as_skeleton(graph: Graph) -> Skeleton:
    """Return the graph in space of what is given as a graph."""
    skeleton = graph if isinstance(graph, Skeleton) else getattr(graph, "skeleton", None)
    if not isinstance(skeleton, Skeleton):
        raise TypeError(f"a graph is a Result or a Skeleton, not {graph!r}")
    return skeleton
