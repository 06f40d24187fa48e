# SPDX-License-Identifier: GPL-3.0-or-later
"""The classical Reeb graph, of a function on the vertices."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

from . import _core
from ._arrays import Ints, real, values_of
from ._mesh import as_mesh


class ScalarReebGraph(NamedTuple):
    """The Reeb graph of a function.

    Attributes
    ----------
    nodes, arcs : list of dict
        The properties of critical vertices and of families of contours.
    arc : array of int, shape (V,)
        The arc of each vertex.
    """

    nodes: list[dict[str, Any]]
    arcs: list[dict[str, Any]]
    arc: Ints

    @property
    def graph(self) -> Any:
        """The graph as a new ``networkx.MultiGraph``."""
        import networkx

        graph = networkx.MultiGraph()
        for number, node in enumerate(self.nodes):
            graph.add_node(number, **node)
        for number, arc in enumerate(self.arcs):
            graph.add_edge(*arc["ends"], key=number, **arc)
        return graph


def scalar_reeb_graph(
    mesh: Any,
    values: Any,
    *,
    persistence: Optional[float] = None,
    unfold_saddles: bool = True,
) -> ScalarReebGraph:
    """Compute the Reeb graph of the function that is given by its values at the vertices.

    Parameters
    ----------
    mesh : Mesh
        A mesh without openings.
    values : array_like, shape (V,)
        The values, finite. Of equal ones, that of the vertex with the lower number counts as
        lower.
    persistence : float, optional
        Arcs to an extremum whose difference of values is at most this are removed.
    unfold_saddles : bool
        Whether a multiple saddle becomes several nodes, so that each handle is a cycle.
    """
    surface = as_mesh(mesh)
    function = values_of(values, "values", surface.number_of_vertices, "vertices")
    least = None if persistence is None else real(persistence, "persistence")
    found = _core.scalar_reeb_graph(surface._core, function, least, bool(unfold_saddles))
    return ScalarReebGraph(*found)
