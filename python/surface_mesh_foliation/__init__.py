# SPDX-License-Identifier: GPL-3.0-or-later
"""Certified Reeb graphs of triangle meshes by harmonic measured foliations.

>>> import surface_mesh_foliation as smf
>>> mesh = smf.read("hand.off")           # or smf.Mesh(vertices, faces)
>>> r = smf.reeb_graph(mesh)
>>> r.graph                               # a networkx.MultiGraph
>>> r.segments                            # the arc of each face
>>> r.skeleton.write_swc("hand.swc")
"""

from importlib import import_module
from typing import Any

# The names of the module, by the file that defines them. A file is read when one of its names is
# used, so that importing the module costs next to nothing. The stub beside this file says the same
# to type checkers; a test compares them.
_NAMES = {
    "_collection": [
        "CollectionProgress",
        "CollectionReport",
        "analyze",
        "map_collection",
    ],
    "_compare": ["Matching", "Symmetries", "distance", "match", "symmetries"],
    "_core": ["__version__"],
    "_errors": [
        "CertificateError",
        "EdgeValueError",
        "FileError",
        "FoliationError",
        "LoopsError",
        "MeshError",
        "ParameterError",
        "SolverError",
        "StoppedError",
    ],
    "_find": ["find_lines", "find_poles"],
    "_hierarchy": ["CanonicalLoop", "LoopHierarchy", "loop_hierarchy", "loop_modulus"],
    "_input": ["Entry"],
    "_loops": [
        "Loop",
        "isoline_loops",
        "loop_along",
        "loop_through",
        "loops_around",
        "plane_loop",
        "plane_loops",
        "pole_loop",
        "read_loops",
        "write_loops",
    ],
    "_mesh": ["Mesh", "MeshPart", "RepairReport", "as_mesh", "read"],
    "_progress": ["Progress"],
    "_records": [
        "Certificate",
        "Coordinates",
        "CriticalLeaf",
        "CutMesh",
        "Leaf",
        "Location",
        "Pole",
        "Singularity",
        "SubdividedMesh",
    ],
    "_result": ["Result"],
    "_retrieval": ["Neighbor", "distance_matrix", "retrieve"],
    "_scalar": ["ScalarReebGraph", "scalar_reeb_graph"],
    "_skeleton": ["Skeleton"],
    "_solver": ["Solver", "integrate_foliation", "reeb_graph", "whitehead_foliation"],
    "_table": ["read_table"],
}
_FILE_OF_NAME = {name: file for file, names in _NAMES.items() for name in names}

__all__ = sorted(_FILE_OF_NAME)


def __getattr__(name: str) -> Any:
    if name not in _FILE_OF_NAME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{_FILE_OF_NAME[name]}", __name__), name)
    globals()[name] = value  # it is looked up once
    return value


def __dir__() -> list[str]:
    return __all__
