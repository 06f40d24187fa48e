# SPDX-License-Identifier: GPL-3.0-or-later
"""The solver: one result, or one after another while poles and loops are edited."""

from __future__ import annotations

import math
from typing import Any, Optional, Union

from . import _core
from ._arrays import count, integer, real, values_of
from ._errors import FoliationError, problem
from ._input import NO_VERTICES, Entry, Input, Request, collect, pole_entry
from ._loops import as_loop
from ._mesh import Mesh, as_mesh
from ._progress import Callback, told
from ._result import Result


class Solver:
    """Computes foliations of one mesh, one after another, and keeps what the next one can reuse.

    After a change of heights a run starts from the last solution; after other changes the symbolic
    analysis of the linear solver is kept. Use one solver for each thread.

    Parameters
    ----------
    mesh, **parameters
        As for `reeb_graph`. What is found is found once, here; later it is only edited.

    Notes
    -----
    Loops are called by their ids, their positions in `loops`: those of poles come first. If an
    edit makes poles and loops that do not fit together, `solve` says so, and the next edit can
    correct it.
    """

    def __init__(
        self,
        mesh: Any,
        *,
        poles: Any = None,
        lines: Any = None,
        loops: Any = None,
        heights: Any = None,
        detail: Optional[float] = None,
        star: bool = False,
        min_loop_length: float = 0.0,
        weights: Any = "mean-value",
        allow_any_weights: bool = False,
        tolerance: float = 1e-12,
        max_iterations: int = 100,
        samples: Optional[int] = None,
    ) -> None:
        self.mesh = as_mesh(mesh)
        self._weights = _checked_weights(self.mesh, weights)
        self._allow_any_weights = bool(allow_any_weights)
        self._tolerance = real(tolerance, "tolerance")
        self._max_iterations = count(max_iterations, "max_iterations")
        self._samples = None if samples is None else count(samples, "samples")
        request = Request(poles, lines, loops, heights, detail, star, min_loop_length)
        self._input: Input = collect(self.mesh, request)
        self._core = _core.Solver(self.mesh._core)

    @property
    def loops(self) -> list[Entry]:
        """The loops by id, with their poles, if they have one, and heights."""
        return list(self._input.entries)

    def solve(self, progress: Union[bool, Callback, None] = None) -> Result:
        """Compute the foliation.

        Parameters
        ----------
        progress
            As for `reeb_graph`.
        """
        given = self._input
        with told(progress) as callback:
            core = self._core.solve(
                given.entries,
                self._weights,
                self._allow_any_weights,
                self._tolerance,
                self._max_iterations,
                callback,
            )
        return Result(self.mesh, core, given, self._samples)

    def __getstate__(self) -> dict[str, Any]:
        """Return all but what the next solution would reuse, which is computed again."""
        return {name: value for name, value in self.__dict__.items() if name != "_core"}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._core = _core.Solver(self.mesh._core)

    def problems(self) -> list[FoliationError]:
        """Return what is wrong with the poles and loops, without raising it."""
        found = _core.validate(self.mesh._core, self._input.entries)
        return [problem(*fields) for fields in found]

    # ===  Edits

    def move_pole(self, loop: int, vertex: int) -> None:
        """Move the pole of a loop, by the id of the loop, to a vertex."""
        old = self._entry(loop)
        if not old.is_pole:
            raise ValueError(f"loop {loop} has no pole")
        if old.opening >= 0:
            raise ValueError(f"the pole of loop {loop} is an opening, which cannot be moved")
        pole = pole_entry(self._vertex(vertex), "vertex")
        significances = {i: s for i, s in self._input.significances.items() if i != loop}
        entries = self._entries_with(loop, pole._replace(height=old.height))
        self._input = Input(entries, significances, {}, None)  # moduli depend on poles

    def set_height(self, loop: int, height: float) -> None:
        """Change the height of a loop."""
        entry = self._entry(loop)._replace(height=_height(height))
        self._input = self._input._replace(entries=self._entries_with(loop, entry))

    def add_pole(self, vertices: Any, height: float = 1.0) -> int:
        """Add a pole, a vertex or a path of vertices, and return the id of its loop."""
        entry = pole_entry(vertices, "pole")
        for vertex in entry.pole:
            self._vertex(int(vertex))
        entries = self._input.entries + [entry._replace(height=_height(height))]
        self._input = Input(entries, self._input.significances, {}, None)
        return len(entries) - 1

    def add_loop(self, loop: Any, height: float = 1.0) -> int:
        """Add a loop and return its id."""
        entry = Entry(NO_VERTICES, -1, as_loop(loop), _height(height))
        self._input = self._input._replace(entries=self._input.entries + [entry])
        return len(self._input.entries) - 1

    def remove(self, loop: int) -> None:
        """Remove a loop with its pole, if it has one. The ids behind it decrease by one."""
        is_pole = self._entry(loop).is_pole
        entries = self._input.entries[:loop] + self._input.entries[loop + 1 :]
        significances = _without(self._input.significances, loop)
        if is_pole:
            self._input = Input(entries, significances, {}, None)
        else:
            canonical = _without(self._input.canonical, loop)
            self._input = Input(entries, significances, canonical, self._input.hierarchy)

    def _vertex(self, vertex: Any) -> int:
        number = integer(vertex, "vertex")
        if not 0 <= number < self.mesh.number_of_vertices:
            raise ValueError(
                f"there is no vertex {number}; the mesh has {self.mesh.number_of_vertices}"
            )
        return number

    def _entry(self, loop: Any) -> Entry:
        number = integer(loop, "loop")
        if not 0 <= number < len(self._input.entries):
            raise IndexError(f"there is no loop {number}; there are {len(self._input.entries)}")
        return self._input.entries[number]

    def _entries_with(self, loop: int, entry: Entry) -> list[Entry]:
        return self._input.entries[:loop] + [entry] + self._input.entries[loop + 1 :]


def _without(numbers: dict[int, Any], gone: int) -> dict[int, Any]:
    return {i - (i > gone): value for i, value in numbers.items() if i != gone}


def _height(height: Any) -> float:
    result = real(height, "height")
    if not (result >= 1e-300 and math.isfinite(result)):
        raise ValueError(f"the height, {result}, is not a finite number of at least 1e-300")
    return result


def _checked_weights(mesh: Mesh, weights: Any) -> Any:
    if isinstance(weights, str):
        if weights not in ("mean-value", "cotangent"):
            raise ValueError(f"weights: {weights!r} is neither 'mean-value' nor 'cotangent'")
        return weights
    return values_of(weights, "weights", mesh.number_of_edges, "edges")


def reeb_graph(
    mesh: Any,
    *,
    poles: Any = None,
    lines: Any = None,
    loops: Any = None,
    heights: Any = None,
    detail: Optional[float] = None,
    star: bool = False,
    min_loop_length: float = 0.0,
    weights: Any = "mean-value",
    allow_any_weights: bool = False,
    tolerance: float = 1e-12,
    max_iterations: int = 100,
    samples: Optional[int] = None,
    progress: Union[bool, Callback, None] = None,
) -> Result:
    """Compute the certified Reeb graph of a mesh.

    What is not given is found: poles at the ends of limbs, with the openings of the mesh as
    further ends, and the loops that the shape decides, around its narrow parts and handles.

    Parameters
    ----------
    mesh : Mesh, or what `as_mesh` accepts
        A mesh of one part.
    poles : sequence of int, optional
        Vertices that become poles; an element may also be a path of vertices. By default, poles
        are found.
    lines : sequence of paths, or "auto", optional
        Paths of vertices that become line poles; "auto" finds the rims of fins and wings.
    loops : sequence of Loop, optional
        The loops besides those of poles; an empty one for none. By default, they are found.
    heights : float or array_like, optional
        The heights of all loops, or of each: of poles, lines, openings, what is found, and loops,
        in this order. 1 by default.
    detail : float, optional
        The least modulus of a loop that is found, 0.6 by default: a smaller one gives more loops.
    star : bool
        Whether only loops around handles are found: without handles, the graph is a star.
    min_loop_length : float
        With ``star``: leave out handles for which a shorter loop is found.
    weights : {"mean-value", "cotangent"} or array_like, shape (E,)
        The weights of the edges, positive.
    allow_any_weights : bool
        Whether other weights are accepted, for which the only guarantee is the certificate.
    tolerance : float
        The bound for the optimality at which the solver stops.
    max_iterations : int
        The largest number of iterations.
    samples : int, optional
        The number of leaves that are sampled in each arc; by default, as many as its shape needs.
    progress : bool or function, optional
        If it is a function, it is called with a `Progress` after each iteration; if it returns
        False, the solver stops with a certified result, and what it raises ends the run. True
        shows the progress, by tqdm if that is installed.

    Returns
    -------
    Result
        The foliation, its graph, and all that can be read from them.

    Raises
    ------
    FoliationError
        If something is wrong: its attributes say what and where.
    KeyboardInterrupt
        If Ctrl-C is pressed meanwhile.
    """
    solver = Solver(
        mesh,
        poles=poles,
        lines=lines,
        loops=loops,
        heights=heights,
        detail=detail,
        star=star,
        min_loop_length=min_loop_length,
        weights=weights,
        allow_any_weights=allow_any_weights,
        tolerance=tolerance,
        max_iterations=max_iterations,
        samples=samples,
    )
    return solver.solve(progress)


def whitehead_foliation(
    mesh: Any,
    *,
    poles: Any = None,
    lines: Any = None,
    loops: Any = None,
    heights: Any = None,
    detail: Optional[float] = None,
    star: bool = False,
    min_loop_length: float = 0.0,
    weights: Any = "mean-value",
    allow_any_weights: bool = False,
    over_relaxation: float = 1.0,
    stage_critical_moves: bool = False,
    spread_by_rings: bool = False,
    tolerance: float = 1e-12,
    max_sweeps: int = 1_000_000,
    samples: Optional[int] = None,
    progress: Union[bool, Callback, None] = None,
) -> Result:
    """Compute the same as `reeb_graph` by Whitehead moves, for comparison and study.

    This is the algorithm of the paper, with moves that pull folds back, so that it converges. It
    takes much longer.

    Parameters
    ----------
    mesh, poles, lines, loops, heights, detail, star, min_loop_length
        As for `reeb_graph`.
    weights, allow_any_weights, tolerance, samples
        As for `reeb_graph`.
    over_relaxation : float
        A factor strictly between 0 and 2 for moves inside arcs; 1.9 saves most of the sweeps.
    stage_critical_moves : bool
        Whether critical moves wait until no other move covers an edge.
    spread_by_rings : bool
        Whether leaves spread by one ring of triangles at a time, rather than all at once along a
        row of vertices.
    max_sweeps : int
        The largest number of sweeps, in each of which every vertex is moved once.
    progress : bool or function, optional
        As for `reeb_graph`; an iteration is a sweep.
    """
    surface = as_mesh(mesh)
    request = Request(poles, lines, loops, heights, detail, star, min_loop_length)
    given = collect(surface, request)
    with told(progress) as callback:
        core = _core.whitehead_foliation(
            surface._core,
            given.entries,
            _checked_weights(surface, weights),
            bool(allow_any_weights),
            real(over_relaxation, "over_relaxation"),
            bool(stage_critical_moves),
            bool(spread_by_rings),
            real(tolerance, "tolerance"),
            count(max_sweeps, "max_sweeps"),
            callback,
        )
    return Result(surface, core, given, None if samples is None else count(samples, "samples"))


def integrate_foliation(
    mesh: Any,
    edge_values: Any,
    *,
    tolerance: float = 1e-9,
    weights: Any = "mean-value",
    allow_any_weights: bool = False,
    samples: Optional[int] = None,
) -> Result:
    """Build a foliation from one number for each edge, and from nothing else.

    Parameters
    ----------
    mesh : Mesh
        A mesh of one part without openings.
    edge_values : array_like, shape (E,)
        The transverse measure of the leaves that cross each edge, in the order of ``mesh.edges``.
    tolerance : float
        The relative accuracy of the values.
    weights, allow_any_weights, samples
        As for `reeb_graph`.
    """
    surface = as_mesh(mesh)
    core = _core.integrate_foliation(
        surface._core,
        values_of(edge_values, "edge_values", surface.number_of_edges, "edges"),
        _checked_weights(surface, weights),
        bool(allow_any_weights),
        real(tolerance, "tolerance"),
    )
    return Result(surface, core, None, None if samples is None else count(samples, "samples"))
