# SPDX-License-Identifier: GPL-3.0-or-later
"""Distances among many graphs, and the shapes of a collection that are like another one."""

from __future__ import annotations

import heapq
import math
from concurrent.futures import Executor, Future
from typing import Any, Iterable, Iterator, Mapping, NamedTuple, Optional, Sequence, Union

import numpy as np

from ._arrays import Floats, count, integer, sequence
from ._compare import Graph, as_skeleton, distance
from ._skeleton import Skeleton

Collection = Union[Mapping[Any, Graph], Iterable[Graph]]

# So many rows of a matrix are in flight at a time.
_WINDOW = 256


class Neighbor(NamedTuple):
    """A shape of a collection, and how far it is from another one.

    Attributes
    ----------
    name
        Its key in the collection, or its position.
    distance : float
        The distance of the graphs, from 0 to 1; infinity if they are not isomorphic.
    moduli_distance : float
        The distance of the moduli of their arcs.
    """

    name: Any
    distance: float
    moduli_distance: float


def distance_matrix(graphs: Iterable[Graph], executor: Optional[Executor] = None) -> Floats:
    """Return the distances of all pairs of graphs.

    Parameters
    ----------
    graphs : iterable of Result or Skeleton
        The graphs.
    executor : concurrent.futures.Executor, optional
        Where distances are computed, by default here.

    Returns
    -------
    array, shape (n, n)
        A symmetric matrix with zero diagonal, and infinity for graphs that are not isomorphic.
    """
    skeletons = [as_skeleton(graph) for graph in sequence(graphs, "graphs")]
    if executor is not None and not isinstance(executor, Executor):
        raise TypeError(f"executor must be a concurrent.futures.Executor, not {executor!r}")
    matrix = np.zeros((len(skeletons), len(skeletons)))
    for i, row in enumerate(_rows(skeletons, executor)):
        matrix[i, i + 1 :] = matrix[i + 1 :, i] = row
    return matrix


def retrieve(query: Graph, collection: Collection, k: int = 5) -> list[Neighbor]:
    """Return the shapes of a collection that are nearest to another shape.

    Shapes are compared by the distance of their graphs, and, if these are equal, such as infinite,
    by the distance of the moduli of their arcs. Of two that are still equal, the one that comes
    first in the collection is returned first.

    Parameters
    ----------
    query : Result or Skeleton
        The graph of the shape.
    collection : mapping or iterable of Result or Skeleton
        The graphs, by name or position. A generator, which may load them one by one, keeps only
        one of them in memory.
    k : int
        How many shapes to return, at most.

    Returns
    -------
    list of Neighbor
        The nearest shapes, the nearest first.

    Notes
    -----
    The distance of moduli is the least mean change of their logarithms that makes their
    distributions equal (a Wasserstein distance). It depends neither on the size of the shapes nor
    on the numbering of arcs, and compares graphs that are not isomorphic, too.
    """
    number = count(integer(k, "k"), "k")
    if number == 0:
        raise ValueError("k must be at least 1")
    wanted = as_skeleton(query)
    moduli = _log_moduli(wanted)
    if isinstance(collection, Mapping):
        named: Iterable[tuple[Any, Graph]] = collection.items()
    elif isinstance(collection, Iterable) and not isinstance(collection, (str, bytes)):
        named = enumerate(collection)
    else:
        raise TypeError(f"collection must be graphs by name, or a sequence, not {collection!r}")
    found = (_neighbor(wanted, moduli, name, as_skeleton(graph)) for name, graph in named)
    ordered = ((n.distance, n.moduli_distance, i, n) for i, n in enumerate(found))
    return [neighbor for _, _, _, neighbor in heapq.nsmallest(number, ordered)]


def _neighbor(query: Skeleton, moduli: Floats, name: Any, graph: Skeleton) -> Neighbor:
    return Neighbor(name, distance(query, graph), _distance_of_moduli(moduli, _log_moduli(graph)))


def _log_moduli(graph: Skeleton) -> Floats:
    moduli: Floats = np.sort([math.log(arc["height"] / arc["flux"]) for arc in graph.arcs])
    return moduli


def _distance_of_moduli(first: Floats, second: Floats) -> float:
    """Return the integral of the difference of two quantile functions."""
    if len(first) == 0 or len(second) == 0:
        return 0.0 if len(first) == len(second) else math.inf
    # Both functions are constant between these numbers, in units of 1 / (m n), which are exact.
    m, n = len(first), len(second)
    steps = np.union1d(np.arange(m + 1) * n, np.arange(n + 1) * m)
    differences = np.abs(first[steps[:-1] // n] - second[steps[:-1] // m])
    return float(np.dot(differences, np.diff(steps)) / (m * n))


def _rows(skeletons: Sequence[Skeleton], executor: Optional[Executor]) -> Iterator[list[float]]:
    """Return for each graph its distances from those after it."""
    rows = ((graph, skeletons[i + 1 :]) for i, graph in enumerate(skeletons))
    if executor is None:
        for graph, others in rows:
            yield _row(graph, others)
        return
    in_flight: list[Future[list[float]]] = []
    try:
        for graph, others in rows:
            in_flight.append(executor.submit(_row, graph, others))
            if len(in_flight) == _WINDOW:
                yield in_flight.pop(0).result()
        while in_flight:
            yield in_flight.pop(0).result()
    finally:
        for future in in_flight:
            future.cancel()


def _row(graph: Skeleton, others: Sequence[Skeleton]) -> list[float]:
    return [distance(graph, other) for other in others]
