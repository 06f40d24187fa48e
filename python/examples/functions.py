# SPDX-License-Identifier: GPL-3.0-or-later
"""The Reeb graph of a function, and a foliation from nothing but edge values."""

import shapes
import surface_mesh_foliation as smf

mesh = smf.Mesh(*shapes.plate(2))

# %% the classical Reeb graph, of a function on the vertices
height = mesh.vertices @ [1.0, 0.1, 0.01]
found = smf.scalar_reeb_graph(mesh, height, persistence=0.5)
print(found.graph, [node["kind"] for node in found.nodes])

# %% a foliation is determined by the transverse measure of each edge
r = smf.reeb_graph(mesh)
again = smf.integrate_foliation(mesh, r.edge_values)
print(r, again)
