# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes from files."""

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(repr(float(x)) for x in v) for v in vertices]
    lines += [f"{len(f)} " + " ".join(map(str, f)) for f in faces]
    return "\n".join(lines) + "\n"


def obj(vertices, faces):
    lines = ["v " + " ".join(repr(float(x)) for x in v) for v in vertices]
    lines += ["f " + " ".join(str(i + 1) for i in f) for f in faces]
    return "\n".join(lines) + "\n"


def stl(vertices, faces):
    lines = ["solid mesh"]
    for face in faces:
        lines += ["facet normal 0 0 0", "outer loop"]
        lines += ["vertex " + " ".join(repr(float(x)) for x in vertices[i]) for i in face]
        lines += ["endloop", "endfacet"]
    return "\n".join(lines + ["endsolid mesh"]) + "\n"


@pytest.mark.parametrize("write, suffix", [(off, "off"), (obj, "obj")])
def test_files_are_read_in_their_order(tmp_path, write, suffix):
    vertices, faces = shapes.torus(12, 18)
    file = tmp_path / f"torus.{suffix}"
    file.write_text(write(vertices, faces))
    for name in (file, str(file), bytes(file)):
        mesh = smf.read(name)
        np.testing.assert_array_equal(mesh.vertices, vertices)
        np.testing.assert_array_equal(mesh.faces, faces)


def test_corners_of_stl_are_joined(tmp_path):
    vertices, faces = shapes.sphere(1)
    (tmp_path / "sphere.stl").write_text(stl(vertices, faces))
    assert smf.read(tmp_path / "sphere.stl").number_of_vertices == len(vertices)


def test_a_file_is_repaired_on_request(tmp_path):
    vertices, faces = shapes.sphere(1)
    faces = faces.copy()
    faces[7] = faces[7][::-1]
    file = tmp_path / "turned.off"
    file.write_text(off(vertices, faces))
    with pytest.raises(smf.MeshError, match="turned.off"):
        smf.read(file)
    assert smf.read(file, repair=True).repair_report.reversed_faces == 1


def test_short_openings_of_files_are_filled(tmp_path):
    vertices, faces = shapes.torus(64, 64)
    file = tmp_path / "hole.off"
    sides = vertices[faces] - vertices[np.roll(faces, 1, axis=1)]
    smallest = np.argmin(np.linalg.norm(sides, axis=2).sum(axis=1))
    file.write_text(off(vertices, np.delete(faces, smallest, axis=0)))
    assert smf.read(file).number_of_filled_openings == 1
    assert len(smf.read(file, borders="ends").openings) == 1


@pytest.mark.parametrize(
    "name, text, error",
    [
        ("none.off", None, smf.FileError),
        ("empty.off", "", smf.FileError),
        ("words.off", "OFF\nthree 1 0\n", smf.FileError),
        ("short.off", "OFF\n3 1 0\n0 0 0\n", smf.FileError),
        ("mesh.xyz", "0 0 0\n", smf.FileError),
        ("open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 5\n", smf.FoliationError),
    ],
)
def test_bad_files_are_refused_by_name(tmp_path, name, text, error):
    file = tmp_path / name
    if text is not None:
        file.write_text(text)
    for repair in (False, True):
        with pytest.raises(error, match=name) as caught:
            smf.read(file, repair=repair)
        assert caught.value.kind == "file"


def test_a_missing_file_is_an_error_of_the_operating_system(tmp_path):
    with pytest.raises(OSError):
        smf.read(tmp_path / "none.off")


def test_an_open_or_closed_file_is_no_name(tmp_path):
    with open(tmp_path / "mesh.off", "w") as file:
        with pytest.raises(TypeError, match="name or path"):
            smf.read(file)
    with pytest.raises(TypeError, match="name or path"):
        smf.read(file)
    with pytest.raises(TypeError):
        smf.read(None)
