# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be read from a result."""

import math
import pickle

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf


def test_a_skeleton_has_points_radii_and_levels(body_result):
    skeleton = body_result.skeleton
    assert len(skeleton.polylines) == len(skeleton.radii) == len(skeleton.levels) == 6
    for polyline, radii, levels, lengths in zip(
        skeleton.polylines, skeleton.radii, skeleton.levels, skeleton.leaf_lengths
    ):
        assert polyline.shape == (len(radii), 3) and len(levels) == len(lengths) == len(radii) - 2
        assert np.all(np.diff(levels) > 0) and levels[0] > 0 and levels[-1] < 1
        assert radii.min() >= 0
    assert skeleton.node_points.shape == (7, 3)
    assert np.array_equal(skeleton.node_radii > 0, [False] * 5 + [True] * 2)
    lengths = [np.linalg.norm(np.diff(p, axis=0), axis=1).sum() for p in skeleton.polylines]
    assert skeleton.length == pytest.approx(sum(lengths))


def test_an_embedding_can_be_chosen(body_result):
    uniform = body_result.embed(9, use_uniform_levels=True)
    for levels in uniform.levels:
        np.testing.assert_allclose(levels, np.arange(1, 10) / 10)
    smooth = body_result.embed(9, use_uniform_levels=True, smoothing_steps=5)
    assert smooth.length < uniform.length
    ring = smf.reeb_graph(shapes.torus())  # whose arc is a circle
    sizes = [len(ring.embed(2, max_chord_deviation=d).polylines[0]) for d in (0.5, 0.1, 0.01)]
    assert 4 < sizes[0] < sizes[1] < sizes[2]
    for wrong in (dict(samples=-1), dict(max_chord_deviation=0.0), dict(smoothing_steps=-1)):
        with pytest.raises(ValueError):
            body_result.embed(**wrong)


def test_a_skeleton_is_written_in_swc(body_result, tmp_path):
    text = body_result.skeleton.swc()
    body_result.skeleton.write_swc(tmp_path / "body.swc")
    assert (tmp_path / "body.swc").read_text() == text
    table = np.array([line.split() for line in text.splitlines() if line[0] != "#"], float)
    assert np.array_equal(table[:, 0], np.arange(1, len(table) + 1))
    assert np.all(table[:, 6] < table[:, 0]) and (table[:, 6] == -1).sum() == 1
    assert len(table) == sum(len(p) - 1 for p in body_result.skeleton.polylines) + 1
    with pytest.raises(smf.FileError, match="none"):
        body_result.skeleton.write_swc(tmp_path / "none" / "body.swc")


def test_a_graph_is_written_in_graphml(body_result, tmp_path):
    networkx = pytest.importorskip("networkx")
    body_result.skeleton.write_graphml(tmp_path / "body.graphml")
    graph = networkx.read_graphml(tmp_path / "body.graphml")
    assert graph.number_of_nodes() == 7 and graph.number_of_edges() == 6


def test_a_vertex_has_a_point_of_the_skeleton(body_result):
    skeleton, r = body_result.skeleton, body_result
    points = skeleton.points
    assert len(points) == len(skeleton.point_radii) == len(skeleton.swc().splitlines()) - 1
    assert r.skeleton_point.min() >= 0 and r.skeleton_point.max() < len(points)
    at_node = r.node >= 0
    np.testing.assert_array_equal(r.skeleton_point[at_node], r.node[at_node])
    first = 7 + sum(len(levels) for levels in skeleton.levels[:5])
    levels = np.concatenate([[0], skeleton.levels[5], [1]])
    numbers = [r.ends[5, 0], *range(first, first + len(levels) - 2), r.ends[5, 1]]
    for vertex in np.flatnonzero(r.arc == 5):  # the one with the nearest level
        assert r.skeleton_point[vertex] == numbers[np.argmin(np.abs(levels - r.t[vertex]))]


def test_a_skeleton_can_be_pickled_and_a_result_cannot(body_result):
    copy = pickle.loads(pickle.dumps(body_result.skeleton))
    assert copy.swc() == body_result.skeleton.swc()
    assert smf.distance(copy, body_result, use_pole_labels=True) == 0
    assert copy.nodes == body_result.skeleton.nodes
    for one, other in zip(copy.arcs, body_result.skeleton.arcs):
        np.testing.assert_equal(one, other)
    for one, other in zip(copy.levels, body_result.skeleton.levels):
        np.testing.assert_array_equal(one, other)
    with pytest.raises(TypeError, match="skeleton"):
        pickle.dumps(body_result)


def test_a_damaged_pickle_is_refused(body_result):
    graph = body_result.skeleton._core
    nodes, arcs = graph.__reduce_ex__(2)[2]
    new = type(graph).__new__
    for state in (
        (),
        (nodes,),
        (nodes, arcs[0]),
        (nodes[:3], arcs),
        ([(9, *nodes[0][1:])], []),
        (nodes, [(*arcs[0][:3], 7, *arcs[0][4:])]),
        (nodes, [(*arcs[0][:8], [1.0], *arcs[0][9:])]),
    ):
        with pytest.raises((TypeError, ValueError, RuntimeError)):
            new(type(graph)).__setstate__(state)


def test_everything_is_written_for_other_programs(body_result, tmp_path):
    body_result.write(tmp_path / "new" / "body")
    written = sorted(file.name for file in (tmp_path / "new" / "body").iterdir())
    stems = ["components", "coordinates", "foliation", "leaves", "singularities", "skeleton"]
    assert written == sorted(
        [f"{stem}.vtp" for stem in stems]
        + [f"{stem}.ply" for stem in ("components", "foliation", "leaves", "segments", "skeleton")]
        + ["coordinates.obj", "reeb_graph.dot", "reeb_graph.graphml", "skeleton.swc"]
    )
    assert (tmp_path / "new/body/skeleton.swc").read_text() == body_result.skeleton.swc()
    segments = smf.read(tmp_path / "new/body/segments.ply")
    # (CGAL begins each face with another corner)
    np.testing.assert_array_equal(np.roll(segments.faces, 1, axis=1), body_result.mesh.faces)
    with pytest.raises(OSError):
        body_result.write(tmp_path / "new/body/skeleton.swc")


def test_faces_that_fill_openings_are_not_written(tmp_path):
    tube = smf.Mesh(*shapes.tube(), borders="fill")
    smf.reeb_graph(tube).write(tmp_path)
    segments = smf.read(tmp_path / "segments.ply", borders="ends")
    expected = tube.faces[~tube.is_filled]
    np.testing.assert_array_equal(np.roll(segments.faces, 1, axis=1), expected)


def test_moduli_are_heights_over_fluxes(body_result):
    np.testing.assert_allclose(body_result.moduli * body_result.fluxes, body_result.heights)


def test_the_hierarchy_has_all_levels_of_detail(body, body_result):
    hierarchy = body_result.hierarchy
    moduli = [loop.modulus for loop in hierarchy.loops]
    assert hierarchy.is_complete and len(moduli) == 2 and moduli == sorted(moduli)[::-1]
    assert hierarchy.level() == [0] and hierarchy.level(0.0) == [0, 1]
    assert hierarchy.level(math.inf) == []
    assert hierarchy.completeness_bound == pytest.approx(1 / (4 * moduli[-1]))
    assert all(loop.is_separating and not loop.cuts_handle for loop in hierarchy.loops)
    waist = hierarchy.loops[0]
    assert waist.margin() <= waist.modulus / 0.6 and waist.is_near_bound(waist.modulus)
    with pytest.raises(ValueError):
        hierarchy.level(-1)
    poles = smf.find_poles(body)
    again = smf.loop_hierarchy(body, poles)
    assert [loop.modulus for loop in again.loops] == moduli
    given = smf.reeb_graph(body, poles=poles, loops=[])
    assert [loop.modulus for loop in given.hierarchy.loops] == moduli


def test_the_hierarchy_of_a_result_counts_openings_as_poles():
    vertices, faces = shapes.body()
    mesh = smf.Mesh(vertices, faces[1:])
    r = smf.reeb_graph(mesh, poles=smf.find_poles(mesh), loops=[])
    again = smf.loop_hierarchy(mesh, smf.find_poles(mesh))
    assert [x.modulus for x in r.hierarchy.loops] == [x.modulus for x in again.loops]


def test_poles_tell_how_significant_they_are(body, body_result):
    poles, significances = smf.find_poles(body, return_significance=True)
    assert [pole.vertices.tolist() for pole in body_result.poles] == poles[:, None].tolist()
    assert [pole.significance for pole in body_result.poles] == significances.tolist()
    assert np.all(significances >= 0.2)
    assert len(smf.find_poles(body, number=2)) == 2
    assert len(smf.find_poles(body, min_significance=math.inf)) == 2
    for wrong in (dict(number=-1), dict(persistence=0.5), dict(min_significance=math.nan)):
        with pytest.raises(ValueError):
            smf.find_poles(body, **wrong)


def test_singularities_have_places(body_result):
    kinds = [s.kind for s in body_result.singularities]
    assert kinds.count("center_pole") == 5
    for s in body_result.singularities:
        assert (s.vertex >= 0) != (s.face >= 0)
        assert s.order == max(-s.index, 0)
        if s.vertex >= 0:
            assert body_result.node[s.vertex] == s.node


def test_leaves_are_closed_curves_on_their_level(body_result):
    leaf = body_result.leaf(5, 0.25)
    assert leaf.arc == 5 and leaf.level == 0.25
    np.testing.assert_array_equal(leaf.points[0], leaf.points[-1])
    sides = np.linalg.norm(np.diff(leaf.points, axis=0), axis=1)
    assert leaf.length == pytest.approx(sides.sum())
    middles = (leaf.points[1:] + leaf.points[:-1]) / 2
    np.testing.assert_allclose(leaf.centroid, sides @ middles / sides.sum())
    for arc, level in ((5, 0.0), (5, 1.0), (6, 0.5), (-1, 0.5), (5, math.inf)):
        with pytest.raises(ValueError):
            body_result.leaf(arc, level)


def test_a_leaf_runs_through_a_vertex(body_result):
    vertex = int(np.flatnonzero(body_result.arc == 5)[0])
    leaf = body_result.leaf_through_vertex(vertex)
    assert leaf.arc == 5 and leaf.level == body_result.t[vertex]
    distances = np.linalg.norm(leaf.points - body_result.mesh.vertices[vertex], axis=1)
    assert distances.min() < 1e-9
    assert body_result.leaf_through_vertex(int(body_result.poles[0].vertices[0])) is None
    for wrong in (-1, body_result.mesh.number_of_vertices):
        with pytest.raises(ValueError):
            body_result.leaf_through_vertex(wrong)
    with pytest.raises(TypeError):
        body_result.leaf_through_vertex(1.0)


def test_points_of_faces_are_located(body_result):
    mesh, r = body_result.mesh, body_result
    face = int(np.flatnonzero((r.arc[mesh.faces] == 5).all(axis=1))[0])
    for corner in range(3):
        location = r.locate(face, np.eye(3)[corner])
        assert location == (True, 5, pytest.approx(r.t[mesh.faces[face, corner]]))
    location = r.locate(face, [1, 1, 2])
    assert location.level == pytest.approx(r.t[mesh.faces[face]] @ [0.25, 0.25, 0.5])
    assert r.leaf_through_point(face, [1, 1, 2]).level == pytest.approx(location.level)
    for wrong in ([1, 1], [0, 0, 0], [-1, 1, 1], [math.nan, 1, 1], [math.inf, 1, 1]):
        with pytest.raises(ValueError):
            r.locate(face, wrong)
    with pytest.raises(ValueError):
        r.locate(-1, [1, 1, 1])


def test_critical_leaves_lie_at_nodes(body_result):
    nodes = {leaf.node for leaf in body_result.critical_leaves}
    assert nodes == set(range(7))
    points = [leaf.points for leaf in body_result.critical_leaves if leaf.node < 5]
    assert [len(p) for p in points] == [1] * 5


def test_components_are_cut_along_critical_leaves(body_result):
    cut, mesh = body_result.components, body_result.mesh
    np.testing.assert_array_equal(cut.vertices[: mesh.number_of_vertices], mesh.vertices)
    assert len(cut.faces) == len(cut.arc) > mesh.number_of_faces
    assert set(cut.arc.tolist()) == set(range(6))
    sides = np.sort(cut.faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    arcs = {}
    for side, arc in zip(map(tuple, sides.tolist()), np.repeat(cut.arc, 3).tolist()):
        arcs.setdefault(side, set()).add(arc)
    critical = {tuple(sorted(edge)) for edge in cut.critical_edges.tolist()}
    assert all(side in critical for side, two in arcs.items() if len(two) == 2)
    edges, counts = np.unique(sides, axis=0, return_counts=True)  # faces may have no area
    assert np.all(counts == 2) and len(cut.vertices) - len(edges) + len(cut.faces) == 2


def test_coordinates_are_those_of_flat_cylinders(body_result):
    r, uv = body_result, body_result.uv
    assert uv.uv.shape == uv.texture.shape == (len(uv.faces), 3, 2) and uv.texture_size > 0
    known = np.isfinite(uv.uv).all(axis=(1, 2))
    assert known.mean() > 0.9
    assert uv.texture[known].min() >= 0 and uv.texture[known].max() <= 1
    a, b, c = np.moveaxis(uv.uv[known], 1, 0)
    doubled = np.cross(b - a, c - a)
    areas = [doubled[uv.arc[known] == arc].sum() / 2 for arc in range(6)]
    rectangles = r.heights * r.fluxes
    assert areas[5] == pytest.approx(rectangles[5])
    assert np.all(areas[:5] < rectangles[:5])  # faces at a pole are cut off at its corner
    assert np.all(areas[:5] > rectangles[:5] / 2)
    # v is the parameter of a vertex that lies in the arc
    corners = uv.faces[known].ravel()
    inside = corners < r.mesh.number_of_vertices
    arcs = np.repeat(uv.arc[known], 3)
    same = inside & (r.arc[np.where(inside, corners, 0)] == arcs)
    v = uv.uv[known][:, :, 1].ravel()
    np.testing.assert_allclose(v[same], r.t[corners[same]], atol=1e-9)


def test_arrays_of_a_result_are_computed_once_and_cannot_be_changed(body_result):
    for name in ("segments", "arc", "node", "t", "edge_values"):
        array = getattr(body_result, name)
        assert getattr(body_result, name) is array
        with pytest.raises(ValueError):
            array[0] = 0


def test_a_result_outlives_its_mesh():
    r = smf.reeb_graph(shapes.sphere(1))
    expected = r.t.copy()
    leaf = r.leaf(0, 0.7)
    core = r._core
    del r
    np.testing.assert_array_equal(core.vertex_cells()[2], expected)
    assert leaf.length > 0


def test_a_result_can_be_drawn(body_result, tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    ax = body_result.plot(labels=True)
    assert len(ax.lines) == 6 and len(ax.collections) == 2 and len(ax.texts) == 13
    ax.figure.savefig(tmp_path / "body.png")
    assert (tmp_path / "body.png").stat().st_size > 10000
    again = body_result.plot(ax, surface=False)
    assert again is ax and len(ax.lines) == 12


def test_everything_has_a_short_description(body, body_result):
    assert repr(body) == f"Mesh({len(body.vertices)} vertices, {len(body.faces)} faces, 0 openings)"
    assert repr(body_result) == "Result(7 nodes, 6 arcs, genus 0, 5 poles)"
    assert repr(body_result.skeleton) == "Skeleton(7 nodes, 6 arcs)"
