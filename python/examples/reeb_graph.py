# SPDX-License-Identifier: GPL-3.0-or-later
"""The Reeb graph of a mesh from nothing but the mesh, as a graph of networkx."""

import networkx
import shapes
import surface_mesh_foliation as smf

mesh = smf.Mesh(*shapes.body())  # or smf.read("body.stl", repair=True)
r = smf.reeb_graph(mesh)
print(r)

# %% nodes and arcs with their properties
for node, properties in r.graph.nodes(data=True):
    print(node, properties["kind"], "at", properties["point"])
for first, last, arc, properties in r.graph.edges(keys=True, data=True):
    print(f"arc {arc} from {first} to {last}: length {properties['length']:.1f}")

# %% all of networkx can be used
print("a tree:", networkx.is_tree(r.graph))
print("arcs that are alike:", r.symmetries.arc_groups)

# %% what is proved, and how sure the loops are
print(r.certificate)
for arc, loop in r.canonical_loops.items():
    print(f"loop {arc}: modulus {loop.modulus:.2f}, margin {loop.margin():.2f}")
