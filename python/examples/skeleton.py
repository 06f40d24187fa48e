# SPDX-License-Identifier: GPL-3.0-or-later
"""A curve skeleton with radii, as arrays and as an SWC file."""

import numpy as np
import shapes
import surface_mesh_foliation as smf

r = smf.reeb_graph(shapes.body())

# %% polylines, from the node at end 0 of each arc to that at end 1, with the radii of leaves
for arc, (polyline, radii) in enumerate(zip(r.skeleton.polylines, r.skeleton.radii)):
    print(f"arc {arc}: {len(polyline)} points, mean radius {np.mean(radii):.2f}")

# %% other samples
smooth = r.embed(10, smoothing_steps=2)
print("length", r.skeleton.length, "or, smoothed,", smooth.length)

# %% files for other programs
r.skeleton.write_swc("skeleton.swc")
r.skeleton.write_graphml("skeleton.graphml")
print(r.skeleton.swc().splitlines()[1])
r.write("files")  # these, and many more
