# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh with mistakes and openings, and another in parts."""

import numpy as np
import shapes
import surface_mesh_foliation as smf

# %% faces that do not know their neighbors, one of them turned over, and one missing
vertices, faces = shapes.sphere()
soup = vertices[faces[1:]].reshape(-1, 3)
corners = np.arange(len(soup)).reshape(-1, 3)
corners[7] = corners[7][::-1]
mesh = smf.Mesh(soup, corners, repair=True)
print(*mesh.repair_report.descriptions, sep="\n")

# %% the opening is an end of the graph, or filled
print(smf.reeb_graph(mesh).graph.nodes(data="kind"))
print(smf.Mesh(mesh.vertices, mesh.faces, borders="fill"))

# %% what is wrong is said with its place
try:
    smf.Mesh(soup, corners)
except smf.MeshError as error:
    print(error.kind, error.faces, error)

# %% one graph for each part
ring, offset = shapes.torus(), len(mesh.vertices)
both = smf.Mesh(
    np.concatenate([mesh.vertices + 5, ring[0]]), np.concatenate([mesh.faces, ring[1] + offset])
)
for part in both.parts():
    print(part.mesh, smf.reeb_graph(part.mesh))
