# SPDX-License-Identifier: GPL-3.0-or-later
"""Reeb graphs of functions, foliations from edge values, and by Whitehead moves."""

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf


@pytest.mark.parametrize(
    "make, genus", [(shapes.sphere, 0), (shapes.torus, 1), (shapes.plate, 2), (shapes.body, 0)]
)
def test_the_graph_of_a_function_has_a_cycle_for_each_handle(make, genus):
    mesh = smf.Mesh(*make())
    values = mesh.vertices @ [0.1, 1.0, 0.01]
    found = smf.scalar_reeb_graph(mesh, values)
    assert len(found.arcs) - len(found.nodes) + 1 == genus
    assert [node["value"] for node in found.nodes] == sorted(node["value"] for node in found.nodes)
    for node in found.nodes:
        assert node["value"] == values[node["vertex"]]
    extrema = [node["kind"] for node in found.nodes if node["kind"] != "saddle"]
    assert {"minimum", "maximum"} == set(extrema)
    lower = np.array([found.arcs[arc]["lower"] for arc in found.arc])
    upper = np.array([found.arcs[arc]["upper"] for arc in found.arc])
    assert np.all((lower <= values) & (values <= upper))


def test_persistence_simplifies(body):
    values = body.vertices[:, 2] + 0.2 * np.sin(7 * np.arange(body.number_of_vertices))
    many = smf.scalar_reeb_graph(body, values)
    few = smf.scalar_reeb_graph(body, values, persistence=1.0)
    assert len(few.nodes) < len(many.nodes)
    kinds = [node["kind"] for node in few.nodes]
    assert kinds.count("minimum") - kinds.count("saddle") + kinds.count("maximum") == 2


def test_the_graph_of_a_function_is_one_of_networkx(body):
    networkx = pytest.importorskip("networkx")
    graph = smf.scalar_reeb_graph(body, body.vertices[:, 2]).graph
    assert isinstance(graph, networkx.MultiGraph) and networkx.is_connected(graph)
    assert all("value" in node for _, node in graph.nodes(data=True))


def test_saddles_may_stay_folded():
    mesh = smf.Mesh(*shapes.torus(8, 12))
    values = np.random.default_rng(5).permutation(mesh.number_of_vertices)
    folded = smf.scalar_reeb_graph(mesh, values, unfold_saddles=False)
    unfolded = smf.scalar_reeb_graph(mesh, values)
    assert len(folded.nodes) < len(unfolded.nodes)
    assert max(node["multiplicity"] for node in folded.nodes) > 1
    assert {node["multiplicity"] for node in unfolded.nodes} == {0, 1}


@pytest.mark.parametrize(
    "values, error",
    [
        ([1.0], ValueError),
        (np.zeros((550, 1)), ValueError),
        (["a"], TypeError),
        (None, TypeError),
    ],
)
def test_wrong_functions_are_refused(body, values, error):
    with pytest.raises(error):
        smf.scalar_reeb_graph(body, values)


def test_a_value_that_is_not_finite_is_named(body):
    values = body.vertices[:, 2].copy()
    values[33] = np.nan
    with pytest.raises(smf.ParameterError) as caught:
        smf.scalar_reeb_graph(body, values)
    assert caught.value.vertices == (33,)
    with pytest.raises(ValueError):
        smf.scalar_reeb_graph(body, body.vertices[:, 2], persistence=-1.0)


def test_a_mesh_with_openings_has_no_graph_of_a_function(tube):
    with pytest.raises(smf.MeshError) as caught:
        smf.scalar_reeb_graph(tube, tube.vertices[:, 2])
    assert caught.value.kind == "not_closed"


@pytest.mark.parametrize(
    "make", [lambda: shapes.sphere(2), shapes.body, shapes.torus, lambda: shapes.plate(1)]
)
def test_a_foliation_is_recovered_from_its_edge_values(make):
    mesh = smf.Mesh(*make())
    r = smf.reeb_graph(mesh)
    again = smf.integrate_foliation(mesh, r.edge_values)
    assert again.certificate.holds
    assert again.number_of_arcs == r.number_of_arcs
    assert again.number_of_nodes == r.number_of_nodes
    np.testing.assert_allclose(again.edge_values, r.edge_values, atol=1e-8)
    np.testing.assert_allclose(np.sort(again.fluxes), np.sort(r.fluxes), rtol=1e-5)
    assert len(again.poles) == len(r.poles)
    assert all(np.isnan(pole.significance) for pole in again.poles)
    moduli = [loop.modulus for loop in again.hierarchy.loops]
    np.testing.assert_allclose(moduli, [loop.modulus for loop in r.hierarchy.loops], rtol=0.01)


def test_wrong_edge_values_are_refused(body, body_result):
    values = body_result.edge_values.copy()
    for wrong, kind in ((-1.0, "invalid_edge_value"), (np.nan, "invalid_edge_value")):
        values[11] = wrong
        with pytest.raises(smf.EdgeValueError) as caught:
            smf.integrate_foliation(body, values)
        assert caught.value.kind == kind and caught.value.vertices
    with pytest.raises(smf.EdgeValueError):
        smf.integrate_foliation(body, np.zeros(body.number_of_edges))
    with pytest.raises(ValueError, match="numbers for"):
        smf.integrate_foliation(body, values[1:])
    with pytest.raises(smf.ParameterError):
        smf.integrate_foliation(body, body_result.edge_values, tolerance=1.0)


@pytest.mark.parametrize(
    "make, has_singular_faces",
    [(shapes.body, True), (lambda: shapes.plate(2), True), (shapes.tube, False)],
)
def test_all_singularities_of_the_subdivided_mesh_are_vertices(make, has_singular_faces):
    r = smf.reeb_graph(smf.Mesh(*make()))
    mesh, values = r.subdivided
    faces = [s.face for s in r.singularities if s.face >= 0]
    n = r.mesh.number_of_vertices
    assert mesh.number_of_vertices == n + len(faces)
    assert mesh.number_of_faces == r.mesh.number_of_faces + 2 * len(faces)
    np.testing.assert_array_equal(mesh.vertices[:n], r.mesh.vertices)
    value = {tuple(sorted(edge)): x for edge, x in zip(mesh.edges.tolist(), values)}
    for edge, x in zip(r.mesh.edges.tolist(), r.edge_values):
        assert value[tuple(sorted(edge))] == x
    for a, b, c in mesh.faces.tolist():
        sides = sorted(value[tuple(sorted(side))] for side in ((a, b), (b, c), (c, a)))
        assert sides[2] == pytest.approx(sides[0] + sides[1], abs=1e-9)
    assert bool(faces) == has_singular_faces
    if not mesh.openings:
        again = smf.integrate_foliation(mesh, values)
        assert again.number_of_arcs == r.number_of_arcs


@pytest.mark.parametrize("make", [lambda: shapes.sphere(1), shapes.body, shapes.tube])
def test_whitehead_moves_find_the_same_foliation(make):
    mesh = smf.Mesh(*make())
    r = smf.reeb_graph(mesh)
    told = []
    other = smf.whitehead_foliation(
        mesh, over_relaxation=1.8, progress=lambda progress: told.append(progress)
    )
    assert other.certificate.holds and other.certificate.has_converged
    np.testing.assert_array_equal(other.ends, r.ends)
    np.testing.assert_allclose(other.edge_values, r.edge_values, atol=1e-6)
    assert list(other.canonical_loops) == list(r.canonical_loops)
    assert [progress.iteration for progress in told] == list(range(1, len(told) + 1))


def test_whitehead_moves_can_be_ended(body):
    few = smf.whitehead_foliation(body, max_sweeps=3)
    assert few.certificate.holds and not few.certificate.has_converged
    by_rings = smf.whitehead_foliation(
        body, max_sweeps=3, spread_by_rings=True, stage_critical_moves=True
    )
    assert not np.allclose(by_rings.edge_values, few.edge_values)
    stopped = smf.whitehead_foliation(body, progress=lambda progress: progress.iteration < 2)
    assert not stopped.certificate.has_converged

    def fail(progress):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        smf.whitehead_foliation(body, progress=fail)


@pytest.mark.parametrize(
    "options, error",
    [
        ({"over_relaxation": 2.0}, smf.ParameterError),
        ({"over_relaxation": "a"}, TypeError),
        ({"max_sweeps": -1}, ValueError),
        ({"weights": [1.0]}, ValueError),
        ({"poles": [3, 3]}, smf.LoopsError),
    ],
)
def test_wrong_arguments_of_whitehead_moves_are_refused(body, options, error):
    with pytest.raises(error):
        smf.whitehead_foliation(body, **options)
