# SPDX-License-Identifier: GPL-3.0-or-later
"""Graphs compared with one another and with themselves."""

import math

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf


def test_a_graph_matches_itself(body_result):
    matching = smf.match(body_result, body_result, use_pole_labels=True)
    np.testing.assert_array_equal(matching.nodes, np.arange(7))
    np.testing.assert_array_equal(matching.arcs, np.arange(6))
    assert matching.distance == 0
    assert smf.distance(body_result, body_result.skeleton) == 0


def test_a_matching_is_an_isomorphism(body, body_result):
    permutation = np.random.default_rng(1).permutation(body.number_of_vertices)
    inverse = np.argsort(permutation)
    other = smf.reeb_graph((body.vertices[permutation] * 2 + 1, inverse[body.faces]))
    matching = smf.match(body_result, other)
    assert sorted(matching.nodes.tolist()) == list(range(7))
    for arc, image in enumerate(matching.arcs):
        ends = matching.nodes[body_result.ends[arc]]
        assert sorted(ends.tolist()) == sorted(other.ends[image].tolist())
    assert 0 <= matching.distance < 0.1


def test_distances_are_means_of_three(body_result):
    other = smf.reeb_graph(shapes.body(arm=10, leg=7))
    matching = smf.match(body_result, other)
    three = matching.length_distance, matching.area_distance, matching.flux_distance
    assert matching.distance == pytest.approx(sum(three) / 3) and 0 < min(three)
    assert smf.distance(other, body_result) == pytest.approx(matching.distance)


def test_graphs_that_are_not_isomorphic_do_not_match(body_result):
    other = smf.reeb_graph(shapes.torus())
    assert smf.match(body_result, other) is None
    assert smf.distance(body_result, other) == math.inf


def test_symmetries_exchange_arms_and_legs(body_result):
    found = body_result.symmetries
    assert len(found.generators) == 2 and not found.is_incomplete
    for nodes, arcs in found.generators:
        for arc, image in enumerate(arcs):
            ends = nodes[body_result.ends[arc]]
            assert sorted(ends.tolist()) == sorted(body_result.ends[image].tolist())
    tips = body_result.skeleton.node_points
    for one, other in found.arc_groups:
        a, b = tips[body_result.ends[one, 0]], tips[body_result.ends[other, 0]]
        assert a[2] == pytest.approx(b[2], abs=1) and a[0] != b[0]
    noise = np.random.default_rng(2).normal(scale=0.02, size=body_result.mesh.vertices.shape)
    other = smf.reeb_graph((body_result.mesh.vertices + noise, body_result.mesh.faces))
    assert len(smf.symmetries(other).arc_groups) == 2
    assert smf.symmetries(other, 1e-9).arc_groups == []
    assert len(found.node_classes) == 7 and len(found.arc_classes) == 6
    with pytest.raises(ValueError):
        smf.symmetries(body_result, 2.0)


def test_what_is_no_graph_is_refused(body_result):
    for wrong in (None, 3, "graph"):
        with pytest.raises(TypeError):
            smf.match(body_result, wrong)
        with pytest.raises(TypeError):
            smf.symmetries(wrong)
