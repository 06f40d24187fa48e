# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures by matplotlib."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from ._result import Result


def plot(result: Result, ax: Any, surface: bool, labels: bool) -> Any:
    """Draw the mesh and the graph, and return the axes."""
    import matplotlib.pyplot as plt

    if ax is None:
        ax = plt.figure().add_subplot(projection="3d")
    colors = plt.get_cmap("tab20")(np.arange(result.number_of_arcs) % 20)
    if surface:
        _draw_surface(result, ax, colors)
    _draw_graph(result, ax, colors)
    if labels:
        _write_labels(result, ax)
    _set_limits(result.mesh.vertices, ax)
    return ax


def _draw_surface(result: Result, ax: Any, colors: Any) -> None:
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    faces = Poly3DCollection(result.mesh.vertices[result.mesh.faces], linewidth=0)
    faces.set_facecolor(colors[result.segments] * [1, 1, 1, 0.3])
    ax.add_collection3d(faces)


def _draw_graph(result: Result, ax: Any, colors: Any) -> None:
    for polyline, color in zip(result.skeleton.polylines, colors):
        ax.plot(*polyline.T, color=color * [0.7, 0.7, 0.7, 1], linewidth=2)
    ax.scatter(*result.skeleton.node_points.T, color="black", s=20)


def _write_labels(result: Result, ax: Any) -> None:
    for number, polyline in enumerate(result.skeleton.polylines):
        ax.text(*_middle(polyline), str(number))
    for number, point in enumerate(result.skeleton.node_points):
        ax.text(*point, f"({number})")


def _middle(polyline: Any) -> Any:
    """Return the point of a polyline that is nearest to its middle."""
    lengths = np.linalg.norm(np.diff(polyline, axis=0), axis=1).cumsum()
    return polyline[1:][np.argmin(np.abs(lengths - lengths[-1] / 2))]


def _set_limits(vertices: Any, ax: Any) -> None:
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    ax.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    ax.set_box_aspect(np.maximum(high - low, 1e-3 * (high - low).max()), zoom=1.3)
    ax.set_axis_off()
