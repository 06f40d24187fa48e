# SPDX-License-Identifier: GPL-3.0-or-later
"""How far a long run has come; Ctrl-C stops it, and so does a function."""

import shapes
import surface_mesh_foliation as smf

mesh = smf.Mesh(*shapes.torus(60, 90))

# %% told to a function
told = []
r = smf.reeb_graph(mesh, poles=[0, 2000], progress=told.append)
print(*told, sep="\n")

# %% stopped, with a certified result
r = smf.reeb_graph(mesh, poles=[0, 2000], progress=lambda progress: progress.optimality > 1e-3)
print(r.certificate)

# %% shown, by tqdm if it is installed
smf.reeb_graph(mesh, progress=True)
