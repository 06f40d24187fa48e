# SPDX-License-Identifier: GPL-3.0-or-later
"""What tests share: meshes made by numpy, and CGAL's if they are there."""

import os
import sys
import tarfile
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1] / "examples"))

import shapes  # noqa: E402
import surface_mesh_foliation as smf  # noqa: E402

_ARCHIVE = Path("/usr/share/doc/libcgal-dev/data.tar.gz")


@pytest.fixture(scope="session")
def body():
    return smf.Mesh(*shapes.body())


@pytest.fixture(scope="session")
def body_result(body):
    return smf.reeb_graph(body)


@pytest.fixture(scope="session")
def plate():
    return smf.Mesh(*shapes.plate(2))


@pytest.fixture(scope="session")
def tube():
    return smf.Mesh(*shapes.tube())


@pytest.fixture(scope="session")
def sphere():
    return smf.Mesh(*shapes.sphere(2))


@pytest.fixture(scope="session")
def cgal_data(tmp_path_factory):
    """Return the folder with CGAL's meshes, of which a few are unpacked if need be."""
    if os.environ.get("SMF_DATA_DIR"):
        return Path(os.environ["SMF_DATA_DIR"])
    if not _ARCHIVE.exists():
        pytest.skip("CGAL's meshes are not installed")
    folder = tmp_path_factory.mktemp("cgal")
    names = [f"data/meshes/{name}.off" for name in ("hand", "elephant", "bear")]
    with tarfile.open(_ARCHIVE) as archive:
        for name in names:
            (folder / Path(name).name).write_bytes(archive.extractfile(name).read())
    return folder
