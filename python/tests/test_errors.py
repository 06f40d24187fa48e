# SPDX-License-Identifier: GPL-3.0-or-later
"""Exceptions."""

import pickle

import numpy as np
import pytest
import surface_mesh_foliation as smf

CLASSES = [
    smf.CertificateError,
    smf.EdgeValueError,
    smf.FileError,
    smf.LoopsError,
    smf.MeshError,
    smf.ParameterError,
    smf.SolverError,
    smf.StoppedError,
]


@pytest.mark.parametrize("error", [smf.FoliationError, *CLASSES])
def test_exceptions_keep_what_they_say(error):
    one = error("face 3 is wrong", "kind", [1], [3], [])
    for each in (one, pickle.loads(pickle.dumps(one))):
        assert isinstance(each, smf.FoliationError) and type(each) is error
        assert str(each) == each.message == "face 3 is wrong"
        assert (each.kind, each.vertices, each.faces, each.loops) == ("kind", (1,), (3,), ())


def test_exceptions_are_those_of_python_too():
    for error in (smf.MeshError, smf.LoopsError, smf.ParameterError, smf.EdgeValueError):
        assert issubclass(error, ValueError)
    for error in (smf.SolverError, smf.CertificateError, smf.StoppedError):
        assert issubclass(error, RuntimeError)
    assert issubclass(smf.FileError, OSError)


def test_places_are_numbers_of_python(body):
    vertices = body.vertices.copy()
    vertices[7] = np.nan
    with pytest.raises(smf.MeshError) as caught:
        smf.Mesh(vertices, body.faces)
    assert caught.value.vertices == (7,) and type(caught.value.vertices[0]) is int


def test_the_compiled_part_checks_its_arguments_too(body):
    from surface_mesh_foliation import _core

    core = body._core
    none = np.zeros(0, np.int64)
    for call in (
        lambda: _core.mesh_of_triangles(np.zeros((3, 2)), np.zeros((1, 3), int), 0.0),
        lambda: _core.mesh_of_triangles(np.zeros((3, 3)), np.array([[0, 1, 3]]), 0.0),
        lambda: _core.mesh_of_triangles(np.zeros((3, 3)), np.array([[0.0, 1.5, 2.0]]), 0.0),
        lambda: _core.repaired_mesh_of_polygons(np.zeros((3, 3)), none, np.array([0, 3]), 0.0),
        lambda: _core.loop_along(core, np.array([[0, 1, 2]])),
        lambda: _core.validate(core, [3]),
        lambda: _core.validate(core, [(none, -1, None)]),
        lambda: _core.validate(core, [(none, 5, None, 1.0)]),
        lambda: _core.validate(core, [(none, -1, (none, none), 1.0)]),
        lambda: _core.Solver(None),
        lambda: _core.Solver(core).solve([], 3, False, 1e-9, 10, None),
        lambda: _core.Solver(core).solve([], "no", False, 1e-9, 10, None),
        lambda: _core.scalar_reeb_graph(core, np.zeros(3), None, True),
        lambda: _core.integrate_foliation(core, np.zeros(3), "mean-value", False, 1e-9),
        lambda: _core.integrate_foliation(None, np.zeros(3), "mean-value", False, 1e-9),
        lambda: _core.Mesh(),
        lambda: _core.Result(),
        lambda: _core.LeafTracer(None),
        lambda: _core.embed(None, 1, False, 1.0, 0),
        lambda: _core.match(None, None, False),
    ):
        with pytest.raises((TypeError, ValueError, RuntimeError, smf.FoliationError)):
            call()
