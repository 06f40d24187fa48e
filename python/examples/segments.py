# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of a shape: of each face, and drawn."""

import numpy as np
import shapes
import surface_mesh_foliation as smf

mesh = smf.Mesh(*shapes.body())
r = smf.reeb_graph(mesh)

# %% the part of each face, and where each vertex lies in its part
print("faces of each part:", np.bincount(r.segments))
for part in range(r.number_of_arcs):
    vertices = np.flatnonzero(r.arc == part)
    print(f"part {part}: {len(vertices)} vertices, t up to {r.t[vertices].max():.2f}")

# %% the values of edges, in the order of mesh.edges
longest = np.argmax(r.edge_values)
print("the most leaves cross the edge", mesh.edges[longest])

# %% parts with exact borders, on a mesh that is cut along the critical leaves
cut = r.components
print(len(cut.faces), "faces instead of", mesh.number_of_faces)

# %% a picture
ax = r.plot(labels=True)
ax.figure.savefig("segments.png")
