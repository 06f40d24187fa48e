# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes from arrays and from objects of other libraries."""

import pickle
from types import SimpleNamespace

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf

TETRAHEDRON = (
    np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float),
    np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]),
)


@pytest.mark.parametrize(
    "make, genus",
    [(shapes.sphere, 0), (shapes.torus, 1), (shapes.plate, 2), (lambda: shapes.plate(4), 4)],
)
def test_a_mesh_keeps_its_arrays(make, genus):
    vertices, faces = make()
    mesh = smf.Mesh(vertices, faces)
    np.testing.assert_array_equal(mesh.vertices, vertices)
    np.testing.assert_array_equal(mesh.faces, faces)
    assert mesh.genus == genus
    assert mesh.number_of_edges == len(mesh.edges) == 3 * len(faces) // 2
    assert mesh.euler_characteristic == 2 - 2 * genus


def test_edges_are_those_of_the_faces(plate):
    sides = np.sort(plate.faces[:, [[0, 1], [1, 2], [2, 0]]], axis=2).reshape(-1, 2)
    expected = {tuple(side) for side in sides.tolist()}
    found = [tuple(sorted(edge)) for edge in plate.edges.tolist()]
    assert len(found) == len(set(found)) and set(found) == expected


def test_vertices_are_a_view_that_outlives_the_mesh():
    mesh = smf.Mesh(*shapes.sphere(1))
    vertices = mesh.vertices
    assert not vertices.flags.owndata and not vertices.flags.writeable
    expected = vertices.copy()
    del mesh
    np.testing.assert_array_equal(vertices, expected)
    with pytest.raises(ValueError):
        vertices[0] = 0


@pytest.mark.parametrize(
    "vertices, faces",
    [
        (TETRAHEDRON[0].tolist(), TETRAHEDRON[1].tolist()),
        (TETRAHEDRON[0].astype(np.float32), TETRAHEDRON[1].astype(np.uint8)),
        (np.asfortranarray(TETRAHEDRON[0]), np.asfortranarray(TETRAHEDRON[1])),
        (np.repeat(TETRAHEDRON[0], 2, axis=0)[::2], TETRAHEDRON[1].astype(np.uint64)),
        (TETRAHEDRON[0].astype(int), TETRAHEDRON[1].astype(">i4")),
        (TETRAHEDRON[0].astype(np.longdouble), TETRAHEDRON[1]),
    ],
)
def test_any_real_and_integer_type_and_layout_is_accepted(vertices, faces):
    mesh = smf.Mesh(vertices, faces)
    np.testing.assert_array_equal(mesh.vertices, TETRAHEDRON[0])
    np.testing.assert_array_equal(mesh.faces, TETRAHEDRON[1])


@pytest.mark.parametrize(
    "vertices, faces, error, words",
    [
        (TETRAHEDRON[0], TETRAHEDRON[1] * 1.0, TypeError, "faces must be integers"),
        (TETRAHEDRON[0], TETRAHEDRON[1] > 0, TypeError, "faces must be integers"),
        (TETRAHEDRON[0] * 1j, TETRAHEDRON[1], TypeError, "vertices must be real"),
        (TETRAHEDRON[0].astype(str), TETRAHEDRON[1], TypeError, "vertices must be real"),
        ([[0, 0, 0], [1]], TETRAHEDRON[1], TypeError, "vertices"),
        (TETRAHEDRON[0].T, TETRAHEDRON[1], ValueError, r"shape \(n, 3\), not \(3, 4\)"),
        (TETRAHEDRON[0].ravel(), TETRAHEDRON[1], ValueError, r"shape \(n, 3\), not \(12,\)"),
        (TETRAHEDRON[0], TETRAHEDRON[1][:, :2], ValueError, r"faces must have the shape"),
        (None, TETRAHEDRON[1], TypeError, "vertices"),
        (TETRAHEDRON[0], None, TypeError, "faces"),
    ],
)
def test_wrong_types_and_shapes_are_refused(vertices, faces, error, words):
    with pytest.raises(error, match=words):
        smf.Mesh(vertices, faces)


def _changed(array, place, value):
    result = array.copy()
    result[place] = value
    return result


@pytest.mark.parametrize(
    "vertices, faces, kind, words",
    [
        (_changed(TETRAHEDRON[0], (2, 1), np.nan), TETRAHEDRON[1], "not_finite", "vertex 2"),
        (_changed(TETRAHEDRON[0], (3, 0), np.inf), TETRAHEDRON[1], "not_finite", "vertex 3"),
        (TETRAHEDRON[0], _changed(TETRAHEDRON[1], (1, 1), -1), "file", "face 1 has the vertex -1"),
        (TETRAHEDRON[0], _changed(TETRAHEDRON[1], (1, 1), 4), "file", "face 1 has the vertex 4"),
        (
            TETRAHEDRON[0],
            _changed(TETRAHEDRON[1], (3, 2), 2**62),
            "file",
            "face 3 has the vertex 4611686018427387904",
        ),
        (TETRAHEDRON[0], _changed(TETRAHEDRON[1], (0, 1), 0), "not_triangle_mesh", "face 0"),
        (TETRAHEDRON[0] * [1, 0, 0], TETRAHEDRON[1], "degenerate_face", "face 0"),
        (TETRAHEDRON[0], _changed(TETRAHEDRON[1], 0, [0, 1, 2]), "not_orientable", ""),
        (np.zeros((0, 3)), np.zeros((0, 3), int), "empty_mesh", "no vertices"),
        (TETRAHEDRON[0], np.zeros((0, 3), int), "empty_mesh", "no faces"),
        (np.concatenate([TETRAHEDRON[0], [[5, 5, 5]]]), TETRAHEDRON[1], "isolated_vertex", "4"),
    ],
)
def test_what_is_no_mesh_is_refused_with_kind_and_place(vertices, faces, kind, words):
    with pytest.raises(smf.MeshError, match=words) as caught:
        smf.Mesh(vertices, faces)
    assert caught.value.kind == kind


def test_openings_are_ends_or_filled():
    vertices, faces = shapes.tube(around=12, along=4, length=2.0)
    as_ends = smf.Mesh(vertices, faces)
    assert sorted(len(opening) for opening in as_ends.openings) == [12, 12]
    assert not as_ends.is_filled.any()
    assert as_ends.number_of_edges == len(as_ends.edges) and as_ends.euler_characteristic == 2
    filled = smf.Mesh(vertices, faces, borders="fill")
    assert filled.openings == [] and filled.number_of_filled_openings == 2
    assert filled.is_filled.sum() == len(filled.faces) - len(faces) > 0
    assert not filled.is_filled[: len(faces)].any()
    np.testing.assert_array_equal(filled.faces[: len(faces)], faces)
    assert smf.Mesh(vertices, faces, borders=6.0).number_of_filled_openings == 0
    assert smf.Mesh(vertices, faces, borders=7.0).number_of_filled_openings == 2


@pytest.mark.parametrize("borders", ["close", -1.0, float("nan"), [1], True])
def test_wrong_borders_are_refused(borders):
    with pytest.raises((ValueError, TypeError)):
        smf.Mesh(*shapes.tube(), borders=borders)


def test_a_soup_is_repaired_with_a_report():
    vertices, faces = shapes.sphere(1)
    soup = vertices[faces].reshape(-1, 3)  # faces that do not know their neighbors
    corners = np.arange(len(soup)).reshape(-1, 3)
    corners[5] = corners[5][::-1]
    mesh = smf.Mesh(soup, corners, repair=True)
    report = mesh.repair_report
    assert mesh.genus == 0 and mesh.number_of_vertices == len(vertices)
    assert report.reversed_faces == 1
    assert report.merged_vertices + report.stitched_edges > 0
    assert any("turned over" in line for line in report.descriptions)
    np.testing.assert_array_equal(report.face_origins, np.arange(len(faces)))
    np.testing.assert_allclose(mesh.vertices[report.vertices], soup)
    np.testing.assert_allclose(mesh.vertices, soup[report.vertex_origins])


def test_polygons_are_cut_by_a_repair():
    cube = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], float)
    squares = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    for faces in (squares, np.array(squares), squares[:5] + [[1, 5, 7], [1, 7, 3]]):
        mesh = smf.Mesh(cube, faces, repair=True)
        assert mesh.number_of_faces == 12 and mesh.genus == 0
        assert mesh.repair_report.triangulated_faces in (5, 6)
        assert mesh.repair_report.first_faces[-1] == 12


def test_a_mesh_that_needs_no_repair_has_an_empty_report(sphere):
    report = smf.Mesh(sphere.vertices, sphere.faces, repair=True).repair_report
    assert report.descriptions == []
    assert sphere.repair_report is None


def test_parts_are_meshes_of_their_own():
    first, second = shapes.sphere(1), shapes.torus()
    faces = np.concatenate([first[1], second[1] + len(first[0])])
    mesh = smf.Mesh(np.concatenate([first[0] + 10, second[0]]), faces)
    assert mesh.number_of_parts == 2 and mesh.genus == 1
    parts = mesh.parts()
    assert [part.mesh.genus for part in parts] == [1, 0]
    for part in parts:
        np.testing.assert_array_equal(part.mesh.vertices, mesh.vertices[part.vertices])
        np.testing.assert_array_equal(part.vertices[part.mesh.faces], mesh.faces[part.faces])
    with pytest.raises(smf.MeshError) as caught:
        smf.reeb_graph(mesh)
    assert caught.value.kind == "not_connected"


def test_a_mesh_of_one_part_is_its_part(body):
    (part,) = body.parts()
    assert part.mesh is body


def test_a_mesh_can_be_pickled():
    mesh = smf.Mesh(*shapes.tube(), borders="fill")
    copy = pickle.loads(pickle.dumps(mesh))
    np.testing.assert_array_equal(copy.vertices, mesh.vertices)
    np.testing.assert_array_equal(copy.faces, mesh.faces)
    np.testing.assert_array_equal(copy.is_filled, mesh.is_filled)
    assert copy.number_of_filled_openings == 2


def test_meshes_of_other_libraries_are_accepted(sphere):
    vertices, faces = sphere.vertices, sphere.faces
    padded = np.insert(faces, 0, 3, axis=1).ravel()
    for mesh in (
        (vertices, faces),
        SimpleNamespace(vertices=vertices, faces=faces),  # trimesh
        SimpleNamespace(vertices=vertices, triangles=faces),  # open3d
        SimpleNamespace(points=vertices, faces=padded),  # pyvista
    ):
        np.testing.assert_array_equal(smf.as_mesh(mesh).faces, faces)
        assert smf.reeb_graph(mesh, star=True).number_of_arcs == 1
    assert smf.as_mesh(sphere) is sphere


def test_what_is_no_mesh_of_another_library_is_refused(sphere):
    quads = np.insert(np.zeros((2, 4), int), 0, 4, axis=1).ravel()
    with pytest.raises(ValueError, match="triangulate"):
        smf.as_mesh(SimpleNamespace(points=sphere.vertices, faces=quads))
    for mesh in (None, 3, "hand.off", SimpleNamespace(vertices=sphere.vertices)):
        with pytest.raises(TypeError, match="not a mesh"):
            smf.as_mesh(mesh)
