# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops of one's own, in four ways, and what is found."""

import numpy as np
import shapes
import surface_mesh_foliation as smf

torus = smf.Mesh(*shapes.torus(12, 18))

# %% along edges, through picked vertices, around a set of vertices, in a plane
loops = [
    smf.loop_along(torus, range(12)),
    smf.loop_through(torus, [0, 4, 8]),
    smf.loops_around(torus, range(24))[0],
    smf.plane_loop(torus, [0, 1, 0, 0.05], near=0),
]
for loop in loops:
    r = smf.reeb_graph(torus, poles=[], loops=[loop])
    print(f"crosses {len(loop.positions)} edges, circumference {r.fluxes[0]:.3f}")

# %% the modulus of the homotopy class, without unit
print("modulus", smf.loop_modulus(torus, loops[0]))

# %% loops that the shape decides, on all levels of detail
body = smf.Mesh(*shapes.body())
hierarchy = smf.loop_hierarchy(body, smf.find_poles(body))
print("moduli", np.round([loop.modulus for loop in hierarchy.loops], 2))
print("arcs", [smf.reeb_graph(body, detail=d).number_of_arcs for d in (1.0, 0.6, 0.0)])
