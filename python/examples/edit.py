# SPDX-License-Identifier: GPL-3.0-or-later
"""Poles and loops that are edited, as a program with a mouse would."""

import time

import shapes
import surface_mesh_foliation as smf

solver = smf.Solver(shapes.body())
print(solver.solve())

# %% an edit takes less time than the first solution
for edit in (
    lambda: solver.move_pole(3, 100),
    lambda: solver.set_height(2, 2.0),
    lambda: solver.remove(5),
):
    start = time.perf_counter()
    edit()
    r = solver.solve()
    print(r, f"{1000 * (time.perf_counter() - start):.0f} ms")

# %% what does not fit together is refused, and the next edit corrects it
solver.add_pole(100)
print("wrong:", solver.problems()[0])
solver.remove(5)
print(solver.solve())
