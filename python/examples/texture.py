# SPDX-License-Identifier: GPL-3.0-or-later
"""Flat coordinates of the components, leaves, and singularities."""

import numpy as np
import shapes
import surface_mesh_foliation as smf

r = smf.reeb_graph(shapes.body())

# %% (u, v) and texture coordinates of the corners of faces, on the mesh cut along critical leaves
flat = r.uv
print(flat.uv.shape, "texture from", np.nanmin(flat.texture), "to", np.nanmax(flat.texture))
print("moduli of the cylinders", np.round(r.moduli, 2))

# %% leaves: at a level, and through a vertex
leaf = r.leaf(5, 0.5)
print(f"{len(leaf.points)} points, length {leaf.length:.2f}, center {leaf.centroid}")
vertex = int(np.flatnonzero(r.arc == 0)[0])
print("the leaf through vertex", vertex, "has the length", r.leaf_through_vertex(vertex).length)

# %% poles and saddles
for singularity in r.singularities:
    print(singularity.kind, "at node", singularity.node)
