# SPDX-License-Identifier: GPL-3.0-or-later
"""Calls of the module whose functions and arguments are made of bytes; see make_calls()."""

import functools
import sys
import warnings

import numpy as np
import shapes
import surface_mesh_foliation as smf
from odd_arguments import INFINITY, odd
from surface_mesh_foliation import _core

# what the module may raise; its compiled part also says in other ways that an element has the wrong
# type, or is too large for it
DOCUMENTED = (TypeError, ValueError, IndexError, smf.FoliationError)
DOCUMENTED_OF_CORE = DOCUMENTED + (OverflowError, RuntimeError)


class Bytes:
    """What the fuzzer has made up; behind its end there are zeros."""

    def __init__(self, data):
        self._data = data
        self._position = 0

    def is_empty(self):
        return self._position >= len(self._data)

    def below(self, bound):
        self._position += 1
        return 0 if self._position > len(self._data) else self._data[self._position - 1] % bound

    def choose(self, options):
        return options[self.below(len(options))]


# ===  Plausible arguments

SPHERE = shapes.sphere(0)  # of twelve vertices


def torus():
    """Return a torus of sixteen vertices."""
    u, v = np.meshgrid(np.arange(4), np.arange(4), indexing="ij")
    a, b = np.pi / 2 * u, np.pi / 2 * v
    points = np.stack([(2 + np.cos(b)) * np.cos(a), (2 + np.cos(b)) * np.sin(a), np.sin(b)], -1)
    corner = 4 * u + v
    right, up = np.roll(corner, -1, 0), np.roll(corner, -1, 1)
    across = np.roll(up, -1, 0)
    faces = [np.stack([corner, right, across], -1), np.stack([corner, across, up], -1)]
    return points.reshape(-1, 3), np.concatenate(faces).reshape(-1, 3)


SURFACES = [SPHERE, (SPHERE[0], SPHERE[1][1:]), torus()]


@functools.lru_cache(None)
def meshes():
    """Return a sphere, a disk and a torus."""
    return [smf.Mesh(*surface, borders="ends") for surface in SURFACES]


@functools.lru_cache(None)
def results():
    return [smf.reeb_graph(meshes()[0], poles=[0, 3, 7]), smf.reeb_graph(meshes()[2])]


class Arguments:
    """Makes arguments for one mesh, of which some are odd."""

    def __init__(self, source):
        self._source = source
        self.mesh = source.choose(meshes())

    def odd(self, value):
        return odd(self._source, value)

    def choice(self, *options):
        return self.odd(self._source.choose(options))

    def flag(self):
        return self.choice(False, True)

    def index(self):
        return self._source.below(self.mesh.number_of_vertices)

    def vertex(self):
        return self.odd(self.index())

    def vertices(self, most=5):
        return self.odd(np.array([self.index() for _ in range(self._source.below(most + 1))], int))

    def number(self):
        return self.odd(self._source.below(16) / 4)

    def numbers(self, size):
        start = self._source.below(16)
        return self.odd(np.sin(np.arange(start, start + size)))

    def surface(self):
        vertices, faces = self._source.choose(SURFACES)
        return self.odd(vertices), self.odd(faces)

    def plane(self):
        return self.odd(np.array([self._source.below(5) - 2.0 for _ in range(4)]))

    def loop(self):
        edges = np.array(self.mesh.edges[: 3 + self._source.below(4)])
        positions = np.full(len(edges), 0.5)
        loop = smf.Loop(edges, positions)
        way = self._source.below(3)
        try:
            if way == 1:
                loop = smf.pole_loop(self.mesh, self.index())
            if way == 2:
                loop = smf.plane_loop(self.mesh, [1, 0.1, 0.2, 0.01], 0)
        except smf.LoopsError:
            pass  # it would meet the border
        return self.odd(smf.Loop(self.odd(loop.edges), self.odd(loop.positions)))

    def loops(self):
        return self.odd([self.loop() for _ in range(self._source.below(3))])

    def poles(self):
        return self.odd([self.vertex() for _ in range(self._source.below(5))])

    def lines(self):
        return self.choice(None, [], "auto", [self.vertices()])

    def heights(self):
        return self.choice(None, 2.0, [self.number()], np.ones(3), np.array([1, 2, 3, 4]))

    def weights(self):
        all_weights = np.ones(self.mesh.number_of_edges)
        return self.choice("mean-value", "cotangent", all_weights)

    def entry(self):
        border = self.choice(-1, 0)
        pole = self.odd(np.array([self.index() for _ in range(self._source.below(3))], int))
        loop = self._source.choose([None, self.loop()])
        return self.odd((pole, border, loop, self.number()))

    def entries(self):
        return self.odd([self.entry() for _ in range(1 + self._source.below(4))])

    def progress(self):
        return self.choice(None, lambda *_: True, lambda *_: False, failing, lambda: None)

    def result(self):
        return self.odd(self._source.choose(results()))

    def point(self):
        return self.odd([self.number(), self.number(), self.number()])

    def a_count(self):
        """Return a number of samples, sweeps or the like, for which large ones take long."""
        return self._source.choose([0, 1, 3, 7, None, -1, 0.5, "a", True, -(2**63)])

    def options_of_input(self):
        return {
            "poles": self.poles(),
            "lines": self.lines(),
            "loops": self._source.choose([None, self.loops()]),
            "heights": self.heights(),
            "detail": self.choice(None, 0.5),
            "star": self.flag(),
            "min_loop_length": self.choice(0.0, 0.1),
            "weights": self.weights(),
            "allow_any_weights": self.flag(),
            "tolerance": self.choice(1e-12, 1e-3),
        }

    def some(self, options):
        """Return those of the options that bytes choose."""
        chosen = self._source.below(256) + 256 * self._source.below(256)
        return {name: options[name] for i, name in enumerate(options) if chosen >> i & 1}


def failing(*_):
    raise ValueError("the progress is refused")


# ===  Calls: each is a function and what it is called with


def core_of(mesh):
    return getattr(mesh, "_core", mesh)


def mesh_call(a):
    options = {"repair": a.flag(), "borders": a.choice(None, "fill", 1.0)}
    return smf.Mesh, a.surface(), a.some(options)


def as_mesh_call(a):
    return smf.as_mesh, (a.odd(a.surface()),), {}


def loop_call(a):
    function = a._source.choose([smf.loop_along, smf.loop_through, smf.loops_around])
    return function, (a.odd(a.mesh), a.vertices()), {}


def loop_through_call(a):
    return smf.loop_through, (a.mesh, a.vertices()), {"poles": a.poles(), "lines": a.lines()}


def pole_loop_call(a):
    return smf.pole_loop, (a.mesh, a.vertex()), {"rings": a.odd(1 + a._source.below(4))}


def plane_call(a):
    if a._source.below(2):
        return smf.plane_loops, (a.mesh, a.plane()), {}
    return smf.plane_loop, (a.mesh, a.plane(), a.vertex()), {}


def isoline_call(a):
    return smf.isoline_loops, (a.mesh, a.numbers(a.mesh.number_of_vertices), a.number()), {}


def points_call(a):
    return smf.Loop.points, (a.loop(), a.mesh), {}


def scalar_call(a):
    options = {"persistence": a.choice(None, 0.1), "unfold_saddles": a.flag()}
    return smf.scalar_reeb_graph, (a.mesh, a.numbers(a.mesh.number_of_vertices)), a.some(options)


def find_call(a):
    options = {"number": a.number(), "persistence": a.number(), "min_significance": a.number()}
    return smf.find_poles, (a.mesh,), a.some(options)


def hierarchy_call(a):
    options = {"number_of_proxy_vertices": a.choice(0, 4, 5000)}
    return smf.loop_hierarchy, (a.mesh, a.poles(), a.choice((), [a.vertices()])), a.some(options)


def modulus_call(a):
    loop = a._source.choose([a.loop(), a.vertex()])
    return smf.loop_modulus, (a.mesh, loop), {"poles": a.poles()}


def reeb_graph_call(a):
    options = {**a.options_of_input(), "samples": a.a_count(), "progress": a.progress()}
    return all_of_a_graph, (a.odd(a.mesh),), a.some(options)


def all_of_a_graph(mesh, **options):
    result = smf.reeb_graph(mesh, **options)
    assert result.certificate.holds
    return result.graph, result.segments, result.components, result.uv, result.singularities


def whitehead_call(a):
    options = {"over_relaxation": a.number(), "spread_by_rings": a.flag(), "tolerance": a.number()}
    return smf.whitehead_foliation, (a.mesh,), {
        "poles": a.poles(), "max_sweeps": a.a_count(), **a.some(options)}  # fmt: skip


def integrate_call(a):
    result = a._source.choose(results())
    mesh = a.odd(result.mesh)
    return smf.integrate_foliation, (mesh, a.odd(result.edge_values)), {"tolerance": a.number()}


def edits_call(a):
    edits = []
    for _ in range(1 + a._source.below(5)):
        edits.append(a._source.choose([
            ("move_pole", a.vertex(), a.vertex()), ("set_height", a.vertex(), a.number()),
            ("add_pole", a.vertices(), a.number()), ("add_loop", a.loop(), a.number()),
            ("remove", a.vertex()), ("solve", a.progress()), ("problems",), ("solve",),
        ]))  # fmt: skip
    return edited, (a.mesh, a.poles(), edits), {}


def edited(mesh, poles, edits):
    solver = smf.Solver(mesh, poles=poles, loops=[])
    for name, *arguments in edits:
        check(getattr(solver, name), arguments, {}, DOCUMENTED)


def entering_again_call(a):
    return solved_while_solving, (a.mesh,), {}


def solved_while_solving(mesh):
    solver = smf.Solver(mesh, poles=[0, 3, 7], loops=[])
    try:
        solver.solve(lambda *_: solver.solve())
    except RuntimeError as error:
        assert "is at work already" in str(error), error


def leaf_call(a):
    result = a._source.choose(results())
    return a._source.choose([
        (result.leaf, (a.vertex(), a.number()), {}),
        (result.leaf_through_vertex, (a.vertex(),), {}),
        (result.leaf_through_point, (a.vertex(), a.point()), {}),
        (result.locate, (a.vertex(), a.point()), {}),
        (result.embed, (a.a_count(),), {"max_chord_deviation": a.odd(INFINITY)}),
    ])  # fmt: skip


def compare_call(a):
    if a._source.below(2):
        return smf.match, (a.result(), a.result()), {"use_pole_labels": a.flag()}
    return smf.symmetries, (a.result(), a.number()), {}


def core_pickle_call(a):
    """Restore a graph in space from what is pickled, in part changed."""
    graph = a._source.choose(results()).skeleton._core
    nodes, arcs = graph.__getstate__()
    nodes[0], arcs[0] = a.odd(nodes[0]), a.odd(arcs[0])
    state = a.odd((a.odd(nodes), a.odd(arcs)))
    return restored, (_core.EmbeddedGraph, state), {}


def restored(kind, state):
    result = kind.__new__(kind)
    result.__setstate__(state)
    return result.nodes, result.arcs, result.levels, _core.symmetries(result, 0.2)


def core_mesh_call(a):
    vertices, faces = a.surface()
    if a._source.below(2):
        return _core.mesh_of_triangles, (vertices, faces, a.choice(None, 1.0)), {}
    corners = faces.ravel() if isinstance(faces, np.ndarray) else faces
    first = a.odd(3 * np.arange(1 + len(SPHERE[1])))
    return _core.repaired_mesh_of_polygons, (vertices, a.odd(corners), first, None), {}


def core_loop_call(a):
    mesh = core_of(a.odd(a.mesh))
    return a._source.choose([
        (_core.loop_along, (mesh, a.vertices()), {}),
        (_core.loop_through, (mesh, a.vertices(), a.entries()), {}),
        (_core.loops_around, (mesh, a.vertices()), {}),
        (_core.plane_loop, (mesh, a.plane(), a.vertex()), {}),
        (_core.isoline_loops, (mesh, a.numbers(a.mesh.number_of_vertices), a.number()), {}),
        (_core.points_of_loop, (mesh, a.loop()), {}),
        (_core.validate, (mesh, a.entries()), {}),
        (_core.missing_poles, (mesh, a.entries()), {}),
        (_core.handle_loops, (mesh, a.entries(), a.flag(), a.number()), {}),
        (_core.loop_hierarchy, (mesh, a.entries(), a.choice(4, 5000)), {}),
        (_core.loop_modulus, (mesh, a.entries(), a.vertex(), a.choice(4, 5000)), {}),
        (_core.scalar_reeb_graph, (mesh, a.numbers(a.mesh.number_of_vertices), None, a.flag()), {}),
    ])  # fmt: skip


def core_solve_call(a):
    mesh = core_of(a.odd(a.mesh))
    arguments = a.entries(), a.weights(), a.flag(), a.number(), a.odd(50), a.progress()
    return solved, (mesh, arguments), {}


def solved(mesh, arguments):
    result = _core.Solver(mesh).solve(*arguments)
    return result.system, result.statistics, result.vertex_cells(), result.segments()


CALLS = [
    mesh_call, as_mesh_call, loop_call, loop_through_call, pole_loop_call, plane_call, isoline_call,
    points_call, scalar_call, find_call, hierarchy_call, modulus_call, reeb_graph_call,
    whitehead_call, integrate_call, edits_call, entering_again_call, leaf_call, compare_call,
]  # fmt: skip
CALLS_OF_CORE = [core_mesh_call, core_loop_call, core_solve_call, core_pickle_call]


def check(function, arguments, options, documented):
    """Call a function, which may raise what is documented, and then says what is wrong."""
    try:
        function(*arguments, **options)
    except documented as error:
        assert str(error), "an exception without a message"


def make_calls(data, is_printing):
    """Make a few calls, as the bytes say. What goes through is a find."""
    source = Bytes(data)
    for _ in range(4):
        if source.is_empty():
            return
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            make_call = source.choose(CALLS + CALLS_OF_CORE)
            function, arguments, options = make_call(Arguments(source))
            if is_printing:
                print(function, arguments, options, file=sys.stderr, flush=True)
            is_core = make_call in CALLS_OF_CORE
            check(function, arguments, options, DOCUMENTED_OF_CORE if is_core else DOCUMENTED)
