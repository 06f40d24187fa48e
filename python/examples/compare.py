# SPDX-License-Identifier: GPL-3.0-or-later
"""Two shapes compared by their graphs."""

import shapes
import surface_mesh_foliation as smf

first = smf.reeb_graph(shapes.body())
second = smf.reeb_graph(shapes.body(arm=9, leg=8))
ring = smf.reeb_graph(shapes.torus())

# %% the matching for which the graphs differ least
matching = smf.match(first, second)
for arc, image in enumerate(matching.arcs):
    print(f"arc {arc} is like arc {image}")
print("distance", matching.distance)

# %% graphs that are not isomorphic are infinitely far apart
print("distance to a ring", smf.distance(first, ring))
