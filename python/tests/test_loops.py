# SPDX-License-Identifier: GPL-3.0-or-later
"""Loops, made in several ways."""

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf


@pytest.fixture(scope="module")
def torus():
    return smf.Mesh(*shapes.torus(12, 18))


def meridian(column=0):
    return [12 * column + i for i in range(12)]


def solved(mesh, loop):
    r = smf.reeb_graph(mesh, poles=[], loops=[loop])
    assert r.certificate.holds and r.number_of_arcs == 1
    return r


def test_a_loop_can_follow_edges(torus):
    loop = smf.loop_along(torus, meridian())
    assert loop.edges.shape == (len(loop.positions), 2)
    assert set(loop.edges.ravel().tolist()) >= set(meridian())
    solved(torus, loop)


def test_a_loop_can_run_through_picked_vertices(torus):
    loop = smf.loop_through(torus, [0, 4, 8])
    np.testing.assert_allclose(
        sorted(solved(torus, loop).fluxes), solved(torus, smf.loop_along(torus, meridian())).fluxes
    )


def test_a_loop_through_vertices_keeps_clear_of_poles(body):
    poles = smf.find_poles(body)
    waist = [v for v, p in enumerate(body.vertices) if p[2] == 13]
    picks = [waist[0], waist[len(waist) // 3], waist[2 * len(waist) // 3]]
    loop = smf.loop_through(body, picks, poles=poles)
    assert smf.reeb_graph(body, poles=poles, loops=[loop]).number_of_arcs == 6
    with pytest.raises(smf.LoopsError, match="belongs to a pole"):
        smf.loop_through(body, [int(poles[0]), *picks[1:]], poles=poles)


def test_loops_separate_a_set_of_vertices(torus):
    loops = smf.loops_around(torus, meridian(0) + meridian(1))
    assert len(loops) == 2
    solved(torus, loops[0])
    with pytest.raises(smf.LoopsError) as caught:
        smf.reeb_graph(torus, poles=[], loops=loops)
    assert caught.value.kind == "homotopic_loops"


def test_loops_are_sections_by_a_plane(torus):
    loops = smf.plane_loops(torus, [0, 1, 0, 0.05])
    assert len(loops) == 2
    for loop in loops:
        np.testing.assert_allclose(loop.points(torus)[:, 1], -0.05, atol=1e-12)
    near = smf.plane_loop(torus, [0, 1, 0, 0.05], near=0)
    assert near.points(torus)[:, 0].mean() > 0
    solved(torus, near)


def test_loops_are_isolines(torus):
    y = torus.vertices[:, 1]
    by_values = smf.isoline_loops(torus, y, -0.05)
    by_plane = smf.plane_loops(torus, [0, 1, 0, 0.05])
    for one, other in zip(by_values, by_plane):
        np.testing.assert_array_equal(one.edges, other.edges)
        np.testing.assert_allclose(one.positions, other.positions)


def test_a_loop_runs_around_a_pole(sphere):
    small, large = smf.pole_loop(sphere, 0), smf.pole_loop(sphere, 0, rings=3)
    assert len(small.positions) < len(large.positions)


def test_a_reversed_loop_is_the_same_component(torus):
    loop = smf.loop_along(torus, meridian())
    assert np.array_equal(loop.reversed().reversed().edges, loop.edges)
    np.testing.assert_allclose(solved(torus, loop.reversed()).fluxes, solved(torus, loop).fluxes)


def test_a_loop_may_be_a_pair_of_lists(torus):
    loop = smf.loop_along(torus, meridian())
    solved(torus, (loop.edges.tolist(), loop.positions.tolist()))


def test_loops_files_are_written_and_read(torus, tmp_path):
    loop = smf.loop_along(torus, meridian())
    smf.write_loops(torus, tmp_path / "loops.txt", [loop])
    (again,) = smf.read_loops(torus, tmp_path / "loops.txt")
    np.testing.assert_array_equal(again.edges, loop.edges)
    np.testing.assert_array_equal(again.positions, loop.positions)
    (tmp_path / "bad.txt").write_text("circle 1 2 3\n")
    with pytest.raises(smf.FileError, match="bad.txt:1"):
        smf.read_loops(torus, tmp_path / "bad.txt")
    with pytest.raises(smf.FileError):
        smf.write_loops(torus, tmp_path / "none" / "loops.txt", [loop])


@pytest.mark.parametrize(
    "make",
    [
        lambda mesh: smf.loop_along(mesh, [0, 1]),
        lambda mesh: smf.loop_along(mesh, [0, 1, 100]),
        lambda mesh: smf.loop_along(mesh, [0, 1, -2]),
        lambda mesh: smf.loop_through(mesh, [0, 4, 4]),
        lambda mesh: smf.loop_through(mesh, [0, 4, 10**9]),
        lambda mesh: smf.loops_around(mesh, [[0]]),
        lambda mesh: smf.loops_around(mesh, [-1]),
        lambda mesh: smf.plane_loops(mesh, [1, 2, 3]),
        lambda mesh: smf.plane_loops(mesh, [1, 2, 3, np.nan]),
        lambda mesh: smf.plane_loop(mesh, [1, 0, 0, 10], 0),
        lambda mesh: smf.plane_loop(mesh, [1, 0, 0, 0], 10**9),
        lambda mesh: smf.isoline_loops(mesh, [1.0], 0.5),
        lambda mesh: smf.isoline_loops(mesh, np.full(216, np.nan), 0.5),
        lambda mesh: smf.pole_loop(mesh, 0, 0),
        lambda mesh: smf.pole_loop(mesh, 0, 100),
        lambda mesh: smf.pole_loop(mesh, -1),
    ],
)
def test_wrong_loops_are_refused(torus, make):
    with pytest.raises(ValueError):
        make(torus)


def test_the_modulus_of_a_tube_is_its_length_over_its_circumference():
    tube = smf.Mesh(*shapes.tube(around=40, along=60, length=3.0, radius=1.0))
    circumference = 40 * 2 * np.sin(np.pi / 40)
    for opening in (0, 1):
        assert smf.loop_modulus(tube, opening) == pytest.approx(3.0 / circumference, rel=1e-3)
    (loop,) = smf.plane_loops(tube, [0, 0, 1, -1.0])
    with pytest.raises(smf.LoopsError) as caught:  # it runs around the openings, too
        smf.loop_modulus(tube, loop)
    assert caught.value.kind == "homotopic_loops"


def test_the_modulus_of_a_torus_is_that_of_its_flat_metric(torus):
    # the conformal torus of the radii 1 and r has the modulus sqrt(1 / r^2 - 1)
    fine = smf.Mesh(*shapes.torus(40, 60, 0.4))
    loop = smf.loop_along(fine, list(range(40)))
    assert smf.loop_modulus(fine, loop) == pytest.approx((1 / 0.4**2 - 1) ** 0.5, rel=0.02)
    with pytest.raises(ValueError, match="no pole 0"):
        smf.loop_modulus(torus, 0)
    assert smf.loop_modulus(torus, 0, poles=[5]) == float("inf")


def test_wrong_sizes_of_proxies_are_refused(torus):
    for wrong in (-1, 99, 2**40):
        with pytest.raises(ValueError):
            smf.loop_hierarchy(torus, [0], number_of_proxy_vertices=wrong)
        with pytest.raises(ValueError):
            smf.loop_modulus(torus, 0, poles=[[0, 1]], number_of_proxy_vertices=wrong)
    with pytest.raises(TypeError):
        smf.loop_hierarchy(torus, [0], number_of_proxy_vertices=500.0)
