# SPDX-License-Identifier: GPL-3.0-or-later
"""Certified Reeb graphs of triangle meshes by harmonic measured foliations.

>>> import surface_mesh_foliation as smf
>>> mesh = smf.read("hand.off")           # or smf.Mesh(vertices, faces)
>>> r = smf.reeb_graph(mesh)
>>> r.graph                               # a networkx.MultiGraph
>>> r.segments                            # the arc of each face
>>> r.skeleton.write_swc("hand.swc")
"""

from ._compare import Matching, Symmetries, distance, match, symmetries
from ._core import __version__
from ._errors import (
    CertificateError,
    EdgeValueError,
    FileError,
    FoliationError,
    LoopsError,
    MeshError,
    ParameterError,
    SolverError,
    StoppedError,
)
from ._find import find_lines, find_poles
from ._hierarchy import CanonicalLoop, LoopHierarchy, loop_hierarchy, loop_modulus
from ._loops import (
    Loop,
    isoline_loops,
    loop_along,
    loop_through,
    loops_around,
    plane_loop,
    plane_loops,
    pole_loop,
    read_loops,
    write_loops,
)
from ._mesh import Mesh, MeshPart, RepairReport, as_mesh, read
from ._progress import Progress
from ._result import (
    Certificate,
    Coordinates,
    CriticalLeaf,
    CutMesh,
    Leaf,
    Location,
    Pole,
    Result,
    Singularity,
)
from ._scalar import ScalarReebGraph, scalar_reeb_graph
from ._skeleton import Skeleton
from ._solver import Solver, integrate_foliation, reeb_graph

__all__ = [
    "CanonicalLoop",
    "Certificate",
    "CertificateError",
    "Coordinates",
    "CriticalLeaf",
    "CutMesh",
    "EdgeValueError",
    "FileError",
    "FoliationError",
    "Leaf",
    "Location",
    "Loop",
    "LoopHierarchy",
    "LoopsError",
    "Matching",
    "Mesh",
    "MeshError",
    "MeshPart",
    "ParameterError",
    "Pole",
    "Progress",
    "RepairReport",
    "Result",
    "ScalarReebGraph",
    "Singularity",
    "Skeleton",
    "Solver",
    "SolverError",
    "StoppedError",
    "Symmetries",
    "__version__",
    "as_mesh",
    "distance",
    "find_lines",
    "find_poles",
    "integrate_foliation",
    "isoline_loops",
    "loop_along",
    "loop_hierarchy",
    "loop_modulus",
    "loop_through",
    "loops_around",
    "match",
    "plane_loop",
    "plane_loops",
    "pole_loop",
    "read",
    "read_loops",
    "reeb_graph",
    "scalar_reeb_graph",
    "symmetries",
    "write_loops",
]
