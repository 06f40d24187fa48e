# SPDX-License-Identifier: GPL-3.0-or-later
"""Graphs: what is found, what is given, and what must be true of each."""

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf

MESHES = {
    "sphere": lambda: shapes.sphere(2),
    "body": shapes.body,
    "torus": shapes.torus,
    "tube": shapes.tube,
    "plate of genus 1": lambda: shapes.plate(1),
    "plate of genus 2": lambda: shapes.plate(2),
    "plate of genus 3": lambda: shapes.plate(3),
}


def check(r):
    """Check what is true of every result."""
    mesh = r.mesh
    assert r.certificate.holds and r.certificate.has_converged
    # the graph
    assert r.ends.shape == (r.number_of_arcs, 2)
    assert set(r.ends.ravel().tolist()) == set(range(r.number_of_nodes))
    degrees = np.bincount(r.ends.ravel())
    for number, pole in enumerate(r.poles):
        assert degrees[number] == 1 and len(pole.vertices) > 0
    # segments
    assert r.segments.shape == (mesh.number_of_faces,)
    assert r.segments.min() >= 0 and r.segments.max() < r.number_of_arcs
    # cells: a vertex lies in an arc, between its ends, or at a node
    assert np.array_equal(r.arc >= 0, r.node < 0)
    inside = r.arc >= 0
    assert np.all(r.t[inside] > 0) and np.all(r.t[inside] < r.heights[r.arc[inside]])
    assert np.all(r.t[~inside] == 0) and np.all(r.node[~inside] < r.number_of_nodes)
    # edge values: an edge that passes no whole arc stays in one, passes a node, or both its nodes
    assert r.edge_values.shape == (mesh.number_of_edges,) and r.edge_values.min() >= 0
    u, v = mesh.edges.T
    short = (r.arc[u] == r.arc[v]) & inside[u] & (r.edge_values < r.heights.min())
    t, s, h = r.t[u][short], r.t[v][short], r.heights[r.arc[u]][short]
    passages = np.array([abs(t - s), t + s, 2 * h - t - s, h - abs(t - s)])
    assert short.sum() > mesh.number_of_edges / 4
    assert abs(passages - r.edge_values[short]).min(axis=0).max() < 1e-9
    # energy: that of the cylinders
    assert np.dot(r.heights, r.fluxes) == pytest.approx(r.certificate.energy, rel=1e-6)
    # singularities: their indices add up to those of the closed surface, without its openings
    indices = sum(s.index for s in r.singularities)
    assert indices == 4 - 4 * r.genus - 2 * sum(pole.is_opening for pole in r.poles)


@pytest.mark.parametrize("name", MESHES)
def test_every_result_is_consistent(name):
    mesh = smf.Mesh(*MESHES[name]())
    r = smf.reeb_graph(mesh)
    check(r)
    graph = r.graph
    cycles = graph.number_of_edges() - graph.number_of_nodes() + 1
    assert cycles == r.genus == mesh.genus


@pytest.mark.parametrize("name", ["hand", "elephant", "bear"])
def test_results_of_cgal_meshes_are_consistent(cgal_data, name):
    r = smf.reeb_graph(smf.read(cgal_data / f"{name}.off"))
    check(r)
    assert r.number_of_arcs - r.number_of_nodes + 1 == r.genus


def test_a_body_has_its_limbs_and_a_waist(body_result):
    r = body_result
    assert r.number_of_nodes == 7 and r.number_of_arcs == 6
    assert sorted(np.bincount(r.ends.ravel()).tolist()) == [1, 1, 1, 1, 1, 3, 4]
    assert list(r.canonical_loops) == [5]
    assert r.canonical_loops[5].modulus > 0.6
    assert [sorted(group) for group in r.symmetries.arc_groups].count([]) == 0
    assert len(r.symmetries.arc_groups) == 2  # arms and legs
    tips = np.array([body_result.mesh.vertices[pole.vertices[0]] for pole in r.poles])
    assert tips[:, 0].min() == 0 and tips[:, 0].max() == 20 and tips[:, 2].max() == 27


def test_the_graph_is_one_of_networkx(body_result):
    networkx = pytest.importorskip("networkx")
    graph = body_result.graph
    assert isinstance(graph, networkx.MultiGraph) and graph is body_result.graph
    assert networkx.is_tree(graph)
    for number, node in graph.nodes(data=True):
        assert node["kind"] == ("pole" if number < 5 else "saddle")
        assert set(node) == {"kind", "genus", "pole", "point", "radius"}
    for u, v, number, arc in graph.edges(keys=True, data=True):
        assert {u, v} == set(body_result.ends[number].tolist())
        assert arc["ends"] == tuple(body_result.ends[number].tolist())
        assert arc["height"] == body_result.heights[number] == 1
        assert arc["modulus"] == pytest.approx(body_result.moduli[number])
        assert arc["component"] == ("disk" if number < 5 else "cylinder")
        np.testing.assert_array_equal(arc["polyline"][0], graph.nodes[arc["ends"][0]]["point"])
        np.testing.assert_array_equal(arc["polyline"][-1], graph.nodes[arc["ends"][1]]["point"])
        assert len(arc["radii"]) == len(arc["polyline"])
    areas = sum(arc["area"] for *_, arc in graph.edges(data=True))
    assert areas == pytest.approx(_area(body_result.mesh))


def _area(mesh):
    a, b, c = np.moveaxis(mesh.vertices[mesh.faces], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def test_parallel_arcs_and_loops_at_a_node_are_kept():
    assert smf.reeb_graph(smf.Mesh(*shapes.torus())).graph.number_of_edges(0, 0) == 1
    graph = smf.reeb_graph(smf.Mesh(*shapes.plate(3))).graph
    assert len(set(map(frozenset, graph.edges()))) < graph.number_of_edges()


def test_poles_can_be_given(body):
    poles = [0, body.number_of_vertices - 1, 100]
    r = smf.reeb_graph(body, poles=poles, loops=[])
    check(r)
    assert [pole.vertices.tolist() for pole in r.poles] == [[pole] for pole in poles]
    assert r.number_of_arcs == 3 and r.canonical_loops == {}
    assert all(np.isnan(pole.significance) for pole in r.poles)
    for given in (tuple(poles), np.array(poles, np.int32), iter(poles), map(np.int64, poles)):
        again = smf.reeb_graph(body, poles=given, loops=[])
        np.testing.assert_array_equal(again.t, r.t)


def test_two_poles_on_a_sphere_share_an_arc(sphere):
    r = smf.reeb_graph(sphere, poles=[0, 3], heights=[1, 2])
    check(r)
    assert r.merged_loops == [1] and r.heights.tolist() == [3.0]
    assert r.graph.edges[0, 1, 0]["component"] == "sphere"


def test_line_poles_can_be_given(sphere):
    u = int(sphere.edges[0, 0])
    v = int(sphere.edges[0, 1])
    far = int(np.argmin(sphere.vertices @ (sphere.vertices[u] + sphere.vertices[v])))
    for given in (dict(poles=[far, [u, v]]), dict(poles=[far], lines=[[u, v]])):
        r = smf.reeb_graph(sphere, **given)
        check(r)
        assert [pole.vertices.tolist() for pole in r.poles] == [[far], [u, v]]
        kinds = sorted(s.kind for s in r.singularities)
        assert kinds == ["center_pole", "thorn_pole", "thorn_pole"]


def test_lines_can_be_found(body):
    r = smf.reeb_graph(body, lines="auto")
    check(r)
    with pytest.raises(ValueError, match="auto"):
        smf.reeb_graph(body, lines="all")


def test_openings_are_ends(tube):
    r = smf.reeb_graph(tube)
    check(r)
    assert [pole.is_opening for pole in r.poles] == [True, True]
    assert {frozenset(pole.vertices.tolist()) for pole in r.poles} == {
        frozenset(opening.tolist()) for opening in tube.openings
    }
    assert [node["kind"] for node in r.skeleton.nodes] == ["boundary", "boundary"]
    # t is the position along the tube
    z = tube.vertices[:, 2] / 3 * r.heights[0]
    inside = r.arc == 0
    expected = z if np.corrcoef(z[inside], r.t[inside])[0, 1] > 0 else r.heights[0] - z
    np.testing.assert_allclose(r.t[inside], expected[inside], atol=1e-9)


def test_heights_are_one_or_given_for_all_or_for_each(body):
    poles = smf.find_poles(body)
    assert smf.reeb_graph(body, poles=poles, loops=[]).heights.tolist() == [1] * 5
    assert smf.reeb_graph(body, poles=poles, loops=[], heights=2).heights.tolist() == [2] * 5
    r = smf.reeb_graph(body, poles=poles, loops=[], heights=[1, 2, 3, 4, 5])
    check(r)
    assert r.heights.tolist() == [1, 2, 3, 4, 5]


def test_a_star_has_one_saddle(body, plate):
    assert smf.reeb_graph(body, star=True).number_of_nodes == 6
    check(smf.reeb_graph(plate, star=True))
    assert smf.reeb_graph(plate, star=True, min_loop_length=100.0, poles=[0, 1]).genus == 2


def test_less_modulus_gives_more_detail(body):
    arcs = [smf.reeb_graph(body, detail=d).number_of_arcs for d in (float("inf"), 0.6, 0.0)]
    assert arcs == [5, 6, 7]


def test_weights_can_be_chosen(body, body_result):
    ones = smf.reeb_graph(body, weights=np.ones(body.number_of_edges))
    check(ones)
    cotangent = smf.reeb_graph(body, weights="cotangent", allow_any_weights=True)
    assert cotangent.certificate.holds
    assert len({r.certificate.energy for r in (ones, cotangent, body_result)}) == 3


def test_energy_is_the_sum_over_weights(body):
    weights = np.linspace(1, 2, body.number_of_edges)
    r = smf.reeb_graph(body, weights=weights)
    assert np.dot(weights, r.edge_values**2) == pytest.approx(r.certificate.energy)


def test_samples_are_as_many_as_asked_for(body):
    for samples in (0, 1, 7):
        r = smf.reeb_graph(body, samples=samples)
        assert all(len(polyline) == samples + 2 for polyline in r.skeleton.polylines)
    assert all(len(p) >= 22 for p in smf.reeb_graph(body).skeleton.polylines)


@pytest.mark.parametrize(
    "arguments, error, words",
    [
        (dict(poles=[0, 10**6]), smf.ParameterError, "no vertex 1000000; the mesh has"),
        (dict(poles=[0, -1]), smf.ParameterError, "no vertex -1"),
        (dict(poles=[0, 2**70]), ValueError, "too large"),
        (dict(poles=[0, 1.5]), TypeError, "pole 1 must be an integer"),
        (dict(poles=[0, True]), TypeError, "pole 1"),
        (dict(poles=[0, []]), ValueError, "pole 1 has no vertex"),
        (dict(poles=5), TypeError, "poles must be a sequence"),
        (dict(poles="05"), TypeError, "poles must be a sequence"),
        (dict(poles=[0, 0]), smf.LoopsError, ""),
        (dict(poles=[], loops=[]), smf.LoopsError, ""),
        (dict(poles=[0], loops=[]), smf.LoopsError, ""),
        (dict(lines=[[0, 470]]), smf.LoopsError, ""),
        (dict(lines=[0, 1]), ValueError, "line 0"),
        (dict(loops=[3]), TypeError, "loop 0 must be a Loop"),
        (dict(loops=[([[0, 1, 2]], [0.5])]), ValueError, "loop 0"),
        (dict(loops=[([[0, 1]], [0.5, 0.5])]), ValueError, "2 positions for 1 edges"),
        (dict(loops=[([[0, 0]], [0.5])]), smf.FoliationError, ""),
        (dict(loops=[([[0, -5]], [0.5])]), smf.ParameterError, "no vertex -5"),
        (dict(loops=[([[0, 470]], [0.5])]), smf.ParameterError, "no edge joins"),
        (dict(loops=[], detail=0.5), ValueError, "give one of them"),
        (dict(star=True, detail=0.5), ValueError, "give one of them"),
        (dict(min_loop_length=3.0), ValueError, "star"),
        (dict(detail=-0.5), ValueError, "-0.5"),
        (dict(detail=float("nan")), ValueError, "NaN"),
        (dict(heights=[1, 2]), ValueError, "2 numbers for"),
        (dict(heights=0.0), smf.LoopsError, ""),
        (dict(heights=float("inf")), smf.LoopsError, ""),
        (dict(heights=float("nan")), ValueError, "NaN"),
        (dict(heights="high"), TypeError, "heights"),
        (dict(weights="heavy"), ValueError, "heavy"),
        (dict(weights=[1.0, 2.0]), ValueError, "2 numbers for"),
        (dict(tolerance=0.0), smf.ParameterError, ""),
        (dict(tolerance=float("nan")), ValueError, "NaN"),
        (dict(max_iterations=-1), ValueError, "negative"),
        (dict(max_iterations=1.5), TypeError, "integer"),
        (dict(samples=-1), ValueError, "negative"),
        (dict(progress=3), TypeError, "progress"),
    ],
)
def test_wrong_arguments_are_refused(body, arguments, error, words):
    with pytest.raises(error, match=words):
        smf.reeb_graph(body, **arguments)


def test_weights_that_are_not_positive_are_refused_by_place(body):
    weights = np.ones(body.number_of_edges)
    for value in (0.0, -1.0, np.nan, np.inf):
        weights[17] = value
        with pytest.raises(smf.ParameterError) as caught:
            smf.reeb_graph(body, weights=weights)
        assert caught.value.kind == "invalid_weight"
        assert sorted(caught.value.vertices) == sorted(body.edges[17].tolist())


def test_loops_that_do_not_fit_are_named(plate):
    loop = smf.plane_loops(plate, [1, 0, 0, -0.5])[0]
    with pytest.raises(smf.LoopsError) as caught:
        smf.reeb_graph(plate, poles=[], loops=[loop])
    assert caught.value.kind == "inessential_loop" and caught.value.loops == (0,)
    across = smf.plane_loops(plate, [1, 0, 0, -3.5])[0]
    with pytest.raises(smf.LoopsError) as caught:
        smf.reeb_graph(plate, poles=[], loops=[across, across])
    assert set(caught.value.loops) == {0, 1}
