# SPDX-License-Identifier: GPL-3.0-or-later
from ._collection import (
    CollectionProgress as CollectionProgress,
    CollectionReport as CollectionReport,
    analyze as analyze,
    map_collection as map_collection,
)
from ._compare import (
    Matching as Matching,
    Symmetries as Symmetries,
    distance as distance,
    match as match,
    symmetries as symmetries,
)
from ._core import __version__ as __version__
from ._errors import (
    CertificateError as CertificateError,
    EdgeValueError as EdgeValueError,
    FileError as FileError,
    FoliationError as FoliationError,
    LoopsError as LoopsError,
    MeshError as MeshError,
    ParameterError as ParameterError,
    SolverError as SolverError,
    StoppedError as StoppedError,
)
from ._find import (
    find_lines as find_lines,
    find_poles as find_poles,
)
from ._hierarchy import (
    CanonicalLoop as CanonicalLoop,
    LoopHierarchy as LoopHierarchy,
    loop_hierarchy as loop_hierarchy,
    loop_modulus as loop_modulus,
)
from ._input import Entry as Entry
from ._loops import (
    Loop as Loop,
    isoline_loops as isoline_loops,
    loop_along as loop_along,
    loop_through as loop_through,
    loops_around as loops_around,
    plane_loop as plane_loop,
    plane_loops as plane_loops,
    pole_loop as pole_loop,
    read_loops as read_loops,
    write_loops as write_loops,
)
from ._mesh import (
    Mesh as Mesh,
    MeshPart as MeshPart,
    RepairReport as RepairReport,
    as_mesh as as_mesh,
    read as read,
)
from ._progress import Progress as Progress
from ._records import (
    Certificate as Certificate,
    Coordinates as Coordinates,
    CriticalLeaf as CriticalLeaf,
    CutMesh as CutMesh,
    Leaf as Leaf,
    Location as Location,
    Pole as Pole,
    Singularity as Singularity,
    SubdividedMesh as SubdividedMesh,
)
from ._result import Result as Result
from ._retrieval import (
    Neighbor as Neighbor,
    distance_matrix as distance_matrix,
    retrieve as retrieve,
)
from ._scalar import (
    ScalarReebGraph as ScalarReebGraph,
    scalar_reeb_graph as scalar_reeb_graph,
)
from ._skeleton import Skeleton as Skeleton
from ._solver import (
    Solver as Solver,
    integrate_foliation as integrate_foliation,
    reeb_graph as reeb_graph,
    whitehead_foliation as whitehead_foliation,
)
from ._table import read_table as read_table

__all__ = [
    "CanonicalLoop",
    "Certificate",
    "CertificateError",
    "CollectionProgress",
    "CollectionReport",
    "Coordinates",
    "CriticalLeaf",
    "CutMesh",
    "EdgeValueError",
    "Entry",
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
    "Neighbor",
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
    "SubdividedMesh",
    "Symmetries",
    "__version__",
    "analyze",
    "as_mesh",
    "distance",
    "distance_matrix",
    "find_lines",
    "find_poles",
    "integrate_foliation",
    "isoline_loops",
    "loop_along",
    "loop_hierarchy",
    "loop_modulus",
    "loop_through",
    "loops_around",
    "map_collection",
    "match",
    "plane_loop",
    "plane_loops",
    "pole_loop",
    "read",
    "read_loops",
    "read_table",
    "reeb_graph",
    "retrieve",
    "scalar_reeb_graph",
    "symmetries",
    "whitehead_foliation",
    "write_loops",
]
