# SPDX-License-Identifier: GPL-3.0-or-later
"""Arguments that a fuzzer has found (test/fuzz/python_boundary.py): they are taken, or refused."""

import numpy as np
import pytest
import surface_mesh_foliation as smf


@pytest.mark.parametrize(
    "edges, positions",
    [([[2**64, 0]], [0.5]), ([[0, 1]], [None]), ([[0, 1]], [10**400]), ([[0, 1]], [0.5, 0.5])],
)
def test_a_loop_of_odd_numbers_has_no_points(sphere, edges, positions):
    with pytest.raises((TypeError, ValueError), match="loop"):
        smf.Loop(edges, positions).points(sphere)


def test_a_loop_of_lists_has_points(sphere):
    loop = smf.pole_loop(sphere, 0)
    lists = smf.Loop(loop.edges.tolist(), loop.positions.tolist())
    np.testing.assert_array_equal(lists.points(sphere), loop.points(sphere))


def test_faces_may_be_memory(sphere):
    faces = memoryview(sphere.faces.astype(">i4"))
    for repair in (False, True):
        mesh = smf.Mesh(memoryview(np.array(sphere.vertices)), faces, repair=repair)
        np.testing.assert_array_equal(mesh.faces, sphere.faces)


def test_coordinates_in_arcs_of_the_least_height_end(sphere):
    try:
        result = smf.reeb_graph(sphere, poles=[8, 0, 2], heights=1e-300)
        assert result.uv is not None
    except smf.CertificateError as error:
        assert "not certified" in str(error)
    except smf.SolverError as error:
        assert "component coordinates" in str(error)


def test_heights_below_the_least_are_refused(sphere):
    for height in (5e-324, 9e-301):
        with pytest.raises(smf.LoopsError, match="the height of loop 0 is .* at least 1e-300"):
            smf.reeb_graph(sphere, poles=[8, 0, 2], heights=height)
