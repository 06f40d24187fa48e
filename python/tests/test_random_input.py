# SPDX-License-Identifier: GPL-3.0-or-later
"""Whatever is passed in, the answer is a result or an exception that says what is wrong."""

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

CLEAR = (TypeError, ValueError, IndexError, smf.FoliationError)

settings.register_profile(
    "smf", deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
)
settings.load_profile("smf")

SPHERE = smf.Mesh(*shapes.sphere(1))
TORUS = smf.Mesh(*shapes.torus(8, 12))
DISK = smf.Mesh(SPHERE.vertices, SPHERE.faces[1:])
MESHES = st.sampled_from([SPHERE, TORUS, DISK])


def clear(function, *arguments, **options):
    """Call a function; return None if it raises an exception of a kind that users expect."""
    try:
        return function(*arguments, **options)
    except CLEAR as error:
        assert str(error)
        return None


any_array = hnp.arrays(
    dtype=st.one_of(
        hnp.floating_dtypes(),
        hnp.integer_dtypes(),
        hnp.unsigned_integer_dtypes(),
        hnp.complex_number_dtypes(),
        hnp.boolean_dtypes(),
        hnp.unicode_string_dtypes(),
    ),
    shape=hnp.array_shapes(min_dims=0, max_dims=3, min_side=0, max_side=5),
)
junk = st.one_of(
    any_array,
    st.none(),
    st.text(max_size=5),
    st.floats(),
    st.integers(),
    st.lists(st.one_of(st.integers(-3, 50), st.floats(), st.none()), max_size=6),
    st.lists(st.lists(st.integers(-3, 50), max_size=4), max_size=6),
    st.dictionaries(st.integers(), st.integers(), max_size=3),
)
numbers = st.one_of(st.floats(), st.integers(-5, 5))
vertex = st.one_of(st.integers(-2, 45), st.integers(), st.floats(), st.none())


@settings(max_examples=450)
@given(junk, junk, st.booleans())
def test_any_objects_as_a_mesh(vertices, faces, repair):
    clear(smf.Mesh, vertices, faces, repair=repair)


damages = st.one_of(
    st.tuples(st.just("move corner"), st.integers(0, 79), st.integers(-1, 42)),
    st.tuples(st.just("turn face"), st.integers(0, 79), st.just(0)),
    st.tuples(st.just("drop face"), st.integers(0, 79), st.just(0)),
    st.tuples(st.just("repeat face"), st.integers(0, 79), st.just(0)),
    st.tuples(st.just("move vertex"), st.integers(0, 41), st.one_of(st.floats(-2, 2), st.floats())),
)


def damaged(vertices, faces, all_damages):
    vertices, faces = vertices.copy(), faces.copy()
    for kind, place, value in all_damages:
        place %= len(vertices) if kind == "move vertex" else len(faces)
        if kind == "move corner":
            faces[place, 1] = value
        elif kind == "turn face":
            faces[place] = faces[place][::-1]
        elif kind == "drop face":
            faces = np.delete(faces, place, axis=0)
        elif kind == "repeat face":
            faces = np.concatenate([faces, faces[place : place + 1]])
        else:
            vertices[place] = value
    return vertices, faces


@settings(max_examples=300)
@given(st.lists(damages, max_size=4), st.booleans(), st.sampled_from(["ends", "fill", None, 1.0]))
def test_damaged_meshes(all_damages, repair, borders):
    arrays = damaged(SPHERE.vertices, SPHERE.faces, all_damages)
    mesh = clear(smf.Mesh, *arrays, repair=repair, borders=borders)
    if not all_damages:
        assert mesh is not None
    if mesh is not None:
        assert mesh.faces.min() >= 0 and mesh.faces.max() < mesh.number_of_vertices
        for part in mesh.parts():
            r = clear(smf.reeb_graph, part.mesh)
            assert r is None or r.certificate.holds


@settings(max_examples=60)
@given(
    st.randoms(use_true_random=False),
    st.floats(1e-3, 1e3),
    st.lists(st.integers(0, 41), min_size=2, max_size=5, unique=True),
)
def test_a_graph_depends_neither_on_order_nor_on_scale(random, scale, poles):
    order = list(range(42))
    random.shuffle(order)
    number = np.argsort(order)
    first = smf.reeb_graph(SPHERE, poles=poles, loops=[])
    other = (scale * SPHERE.vertices[order], number[SPHERE.faces])
    second = smf.reeb_graph(other, poles=number[poles], loops=[])
    np.testing.assert_array_equal(first.ends, second.ends)
    np.testing.assert_allclose(second.fluxes * scale, first.fluxes, rtol=1e-6)
    # a vertex at the saddle, where all arcs end, may be a little before it in the other mesh
    before, after = (np.where(r.node >= len(poles), 1.0, r.t) for r in (first, second))
    np.testing.assert_allclose(after[number], before, atol=1e-6)


@settings(max_examples=100)
@given(
    st.lists(st.integers(0, 11), max_size=3),
    st.lists(st.tuples(st.integers(0, 60), st.floats(-0.1, 1.1)), max_size=2),
    st.booleans(),
)
def test_meridians_of_a_torus_with_changes(columns, changes, is_reversed):
    loops = []
    for column in columns:
        loop = smf.loop_along(TORUS, [8 * column + i for i in range(8)])
        loops.append(loop.reversed() if is_reversed else loop)
    for place, position in changes:
        if loops:
            loops[0].positions[place % len(loops[0].positions)] = position
    r = clear(smf.reeb_graph, TORUS, poles=[], loops=loops)
    if r is not None:
        assert r.certificate.holds and r.number_of_arcs == len(loops) == 1
    if len(loops) == 1 and not changes:
        assert r is not None


@settings(max_examples=100)
@given(st.lists(st.integers(0, 95), min_size=3, max_size=6))
def test_loops_through_vertices_of_a_torus(vertices):
    loop = clear(smf.loop_through, TORUS, vertices)
    if loop is not None:
        assert len(loop.edges) == len(loop.positions) > 2
        r = clear(smf.reeb_graph, TORUS, poles=[], loops=[loop])
        assert r is None or r.number_of_arcs == 1


@settings(max_examples=450)
@given(
    hnp.arrays(float, st.tuples(st.integers(0, 7), st.just(3)), elements=st.floats(-2, 2)),
    hnp.arrays(np.int64, st.tuples(st.integers(0, 9), st.just(3)), elements=st.integers(-1, 7)),
    st.sampled_from(["ends", "fill", None, 1.0]),
)
def test_any_triangles_as_a_mesh(vertices, faces, borders):
    for repair in (False, True):
        mesh = clear(smf.Mesh, vertices, faces, repair=repair, borders=borders)
        if mesh is not None:
            assert mesh.faces.min() >= 0 and mesh.faces.max() < mesh.number_of_vertices
            clear(smf.reeb_graph, mesh)


@settings(max_examples=180)
@given(st.lists(st.lists(st.integers(-1, 8), max_size=6), max_size=7))
def test_any_polygons_are_repaired_or_refused(polygons):
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    mesh = clear(smf.Mesh, cube, polygons, repair=True)
    if mesh is not None:
        assert len(mesh.repair_report.first_faces) == len(polygons) + 1


@settings(max_examples=120)
@given(st.integers(0, 2**32), st.floats(0, 0.3))
def test_a_mesh_with_moved_vertices_has_a_certified_graph(seed, size):
    noise = np.random.default_rng(seed).normal(scale=size, size=SPHERE.vertices.shape)
    r = clear(smf.reeb_graph, (SPHERE.vertices + noise, SPHERE.faces))
    assert r is None or r.certificate.holds


@settings(max_examples=360)
@given(
    MESHES,
    st.one_of(st.none(), junk, st.lists(st.one_of(vertex, st.lists(vertex, max_size=3)))),
    st.one_of(st.none(), junk, st.lists(st.lists(vertex, max_size=4), max_size=2)),
    st.one_of(st.none(), numbers, st.lists(numbers, max_size=6)),
)
def test_any_poles_lines_and_heights(mesh, poles, lines, heights):
    r = clear(smf.reeb_graph, mesh, poles=poles, lines=lines, heights=heights)
    assert r is None or r.certificate.holds


@settings(max_examples=360)
@given(
    MESHES,
    st.lists(
        st.one_of(
            junk,
            st.tuples(junk, junk),
            st.integers(0, 30).flatmap(
                lambda n: st.tuples(
                    hnp.arrays(np.int64, (n, 2), elements=st.integers(-1, 96)),
                    hnp.arrays(float, n, elements=st.floats(-0.5, 1.5)),
                )
            ),
        ),
        max_size=3,
    ),
)
def test_any_loops(mesh, loops):
    r = clear(smf.reeb_graph, mesh, loops=loops, poles=[0, 5])
    assert r is None or r.certificate.holds


@settings(max_examples=300)
@given(MESHES, st.lists(vertex, max_size=6), st.lists(numbers, min_size=3, max_size=5), numbers)
def test_loops_through_any_vertices_and_planes(mesh, vertices, plane, level):
    for make in (smf.loop_along, smf.loop_through, smf.loops_around):
        clear(make, mesh, vertices)
    clear(smf.plane_loops, mesh, plane)
    clear(smf.plane_loop, mesh, plane, vertices[0] if vertices else 0)
    clear(smf.isoline_loops, mesh, mesh.vertices[:, 0], level)


options = st.one_of(
    st.tuples(st.just("weights"), st.one_of(junk, st.text(max_size=3))),
    st.tuples(st.just("tolerance"), numbers),
    st.tuples(st.just("max_iterations"), st.one_of(st.integers(-2, 5), st.floats())),
    st.tuples(st.just("samples"), st.one_of(st.integers(-2, 5), st.floats())),
    st.tuples(st.just("detail"), numbers),
    st.tuples(st.just("star"), st.booleans()),
    st.tuples(st.just("min_loop_length"), numbers),
    st.tuples(st.just("allow_any_weights"), st.booleans()),
)


@settings(max_examples=200)
@given(MESHES, st.lists(options, max_size=2))
def test_any_options(mesh, chosen):
    r = clear(smf.reeb_graph, mesh, **dict(chosen))
    if not chosen:
        assert r is not None
    if r is not None:
        assert r.certificate.holds and len(r.skeleton.polylines) == r.number_of_arcs


@settings(max_examples=240)
@given(
    st.sampled_from([SPHERE, TORUS]),
    st.integers(0, 2**32),
    st.floats(0, 1),
    st.one_of(st.none(), numbers),
)
def test_any_function_has_a_graph_with_the_right_cycles(mesh, seed, ties, persistence):
    random = np.random.default_rng(seed)
    values = random.normal(size=mesh.number_of_vertices)
    values[random.random(len(values)) < ties] = 0
    found = clear(smf.scalar_reeb_graph, mesh, values, persistence=persistence)
    if found is not None:
        assert len(found.arcs) - len(found.nodes) + 1 == mesh.genus


@settings(max_examples=180)
@given(MESHES, junk, junk)
def test_any_values(mesh, values, other):
    clear(smf.scalar_reeb_graph, mesh, values)
    clear(smf.isoline_loops, mesh, values, other)
    clear(smf.integrate_foliation, mesh, values)


@settings(max_examples=120)
@given(
    hnp.arrays(float, SPHERE.number_of_edges, elements=st.floats(0, 1)),
    st.floats(0, 0.2),
)
def test_any_edge_values(values, tolerance):
    r = clear(smf.integrate_foliation, SPHERE, values, tolerance=tolerance)
    assert r is None or r.certificate.holds


@pytest.fixture(scope="module")
def torus_result():
    return smf.reeb_graph(TORUS)


@settings(max_examples=300)
@given(
    st.one_of(vertex, st.integers(0, 95)),
    vertex,
    st.one_of(numbers, st.floats(0, 1)),
    st.lists(st.one_of(numbers, st.floats(0, 1), st.floats(0, 1)), min_size=3, max_size=4),
)
def test_any_leaf_and_place(torus_result, face, arc, level, coordinates):
    clear(torus_result.leaf, arc, level)
    clear(torus_result.leaf_through_vertex, face)
    clear(torus_result.leaf_through_point, face, coordinates)
    place = clear(torus_result.locate, face, coordinates)
    assert place is None or place.number == 0


edits = st.one_of(
    st.tuples(st.just("move_pole"), vertex, vertex),
    st.tuples(st.just("set_height"), vertex, numbers),
    st.tuples(st.just("add_pole"), vertex, numbers),
    st.tuples(st.just("add_loop"), junk, numbers),
    st.tuples(st.just("remove"), vertex),
)


@settings(max_examples=180)
@given(MESHES, st.lists(edits, max_size=8))
def test_any_edits(mesh, all_edits):
    solver = smf.Solver(mesh)
    for name, *arguments in all_edits:
        clear(getattr(solver, name), *arguments)
        problems = solver.problems()
        r = clear(solver.solve)
        assert (r is None) == bool(problems)


@settings(max_examples=300)
@given(st.binary(max_size=200), st.sampled_from(["off", "obj", "ply", "stl", "xyz"]))
def test_any_bytes_as_a_file(tmp_path_factory, content, suffix):
    file = tmp_path_factory.getbasetemp() / f"random.{suffix}"
    file.write_bytes(content)
    clear(smf.read, file)
    clear(smf.read, file, repair=True)
