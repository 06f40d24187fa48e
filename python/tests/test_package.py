# SPDX-License-Identifier: GPL-3.0-or-later
"""The module as a whole: names, stubs, versions, imports, examples, and the program in C++."""

import ast
import json
import os
import platform
import re
import runpy
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import shapes
import surface_mesh_foliation as smf
from test_read import stl

FOLDER = Path(smf.__file__).resolve().parent
PYTHON = Path(__file__).parents[1]
EXAMPLES = [f for f in sorted((PYTHON / "examples").glob("*.py")) if f.stem != "shapes"]


def run(code):
    command = [sys.executable, "-c", code]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def test_importing_loads_nothing_else():
    code = "import sys, surface_mesh_foliation; print(*sys.modules)"
    loaded = run(code).split()
    assert "surface_mesh_foliation" in loaded
    for module in ("numpy", "networkx", "matplotlib", "tqdm", "surface_mesh_foliation._core"):
        assert module not in loaded


def test_computing_needs_no_more_than_numpy():
    code = (
        "import sys; sys.modules.update(networkx=None, matplotlib=None, tqdm=None);"
        f"sys.path.insert(0, {str(PYTHON / 'examples')!r});"
        "import shapes, surface_mesh_foliation as smf;"
        "r = smf.reeb_graph(shapes.sphere(1)); print(r.skeleton.length > 0)"
    )
    assert run(code).strip() == "True"


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="counts pages of Linux")
@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="asks glibc to keep memory")
def test_memory_is_kept_from_run_to_run(monkeypatch):
    def pages_of_a_run():
        code = (
            f"import sys; sys.path.insert(0, {str(PYTHON / 'examples')!r});"
            "import resource, shapes, surface_mesh_foliation as smf;"
            "mesh = shapes.sphere(5);"
            "compute = lambda: smf.reeb_graph(mesh, poles=[0, 1], loops=[]).segments;"
            "pages = lambda: resource.getrusage(resource.RUSAGE_SELF).ru_minflt;"
            "compute(); compute(); before = pages(); compute(); print(pages() - before)"
        )
        return int(run(code))

    for name in ("MALLOC_TRIM_THRESHOLD_", "MALLOC_MMAP_THRESHOLD_", "GLIBC_TUNABLES"):
        monkeypatch.delenv(name, raising=False)
    kept = pages_of_a_run()
    monkeypatch.setenv("MALLOC_TRIM_THRESHOLD_", "131072")
    assert pages_of_a_run() > 1000 > 10 * kept


def test_the_stub_has_the_names_of_the_module():
    tree = ast.parse((FOLDER / "__init__.pyi").read_text())
    imports = [node for node in tree.body if isinstance(node, ast.ImportFrom)]
    names = {alias.name: node.module for node in imports for alias in node.names}
    assert names == smf._FILE_OF_NAME
    (exported,) = [node.value for node in tree.body if isinstance(node, ast.Assign)]
    assert dir(smf) == smf.__all__ == sorted(names) == ast.literal_eval(exported)
    for name in names:
        assert getattr(smf, name).__doc__, f"{name} is not documented"
    with pytest.raises(AttributeError):
        smf.no_such_name


def test_the_stub_of_the_compiled_part_has_its_names():
    from surface_mesh_foliation import _core

    tree = ast.parse((FOLDER / "_core.pyi").read_text())
    functions = {node.name for node in tree.body if isinstance(node, ast.FunctionDef)}
    classes = {node.name: node for node in tree.body if isinstance(node, ast.ClassDef)}
    values = {node.target.id for node in tree.body if isinstance(node, ast.AnnAssign)}
    names = {name for name in dir(_core) if name == "__version__" or name[0] != "_"}
    assert functions | set(classes) | values == names
    for name, node in classes.items():
        in_stub = {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
        members = {member for member in dir(getattr(_core, name)) if member[0] != "_"}
        assert in_stub - {"__init__"} == members


def test_public_functions_describe_all_parameters():
    import inspect

    names = ["reeb_graph", "integrate_foliation", "whitehead_foliation", "scalar_reeb_graph"]
    names += ["find_poles"]
    names += ["analyze", "distance_matrix", "map_collection", "read_table", "retrieve"]
    for name in names:
        function = getattr(smf, name)
        for parameter in inspect.signature(function).parameters:
            assert re.search(rf"^ {{4}}(\w+, )*{parameter}\b", function.__doc__, re.M), parameter


def test_versions_agree():
    text = (PYTHON / "pyproject.toml").read_text()
    assert re.search(r'^version = "(.*)"', text, re.M)[1] == smf.__version__


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_examples_run(example, tmp_path, monkeypatch):
    matplotlib = pytest.importorskip("matplotlib")
    pytest.importorskip("networkx")
    if example.stem == "pipeline":
        pytest.importorskip("vtkmodules")
    matplotlib.use("Agg")
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(example), run_name="__main__")


def run_block(file, begin, end, folder, monkeypatch, names=()):
    """Run the first piece of code of a document, and return its names."""
    matplotlib = pytest.importorskip("matplotlib")
    pytest.importorskip("networkx")
    matplotlib.use("Agg")
    monkeypatch.chdir(folder)
    code = file.read_text().split(begin, 1)[1].split(end, 1)[0]
    result = dict(names)
    exec(compile(code, str(file), "exec"), result)
    return result


def test_the_code_of_the_readme_runs(cgal_data, tmp_path, monkeypatch):
    shutil.copy(cgal_data / "hand.off", tmp_path)
    readme = PYTHON.parent / "README.md"
    names = run_block(readme, "```python\n", "```", tmp_path, monkeypatch)
    assert names["r"].certificate.holds and (tmp_path / "hand.swc").exists()


def test_the_code_of_the_manual_runs(tmp_path, monkeypatch):
    (tmp_path / "body.stl").write_text(stl(*shapes.body()))
    manual = PYTHON.parent / "doc/Surface_mesh_foliation/python.txt"
    names = run_block(manual, "\\code{.py}\n", "\\endcode", tmp_path, monkeypatch)
    assert names["r"].certificate.holds and (tmp_path / "body.swc").exists()
    text = manual.read_text().split("\\section SMFPythonEdits", 1)[1]
    (tmp_path / "edits.txt").write_text(text)
    fine = smf.Mesh(*shapes.subdivided(*shapes.subdivided(*shapes.body())))
    names = {"smf": smf, "mesh": fine}
    run_block(tmp_path / "edits.txt", "\\code{.py}\n", "\\endcode", tmp_path, monkeypatch, names)


def test_the_code_of_the_manual_on_collections_runs(tmp_path, monkeypatch, capsys):
    (tmp_path / "shapes").mkdir()
    for name, shape in (("body", shapes.body()), ("torus", shapes.torus())):
        (tmp_path / "shapes" / f"{name}.off").write_text(off(smf.Mesh(*shape)))
    manual = PYTHON.parent / "doc/Surface_mesh_foliation/python.txt"
    first, second = manual.read_text().split("\\section SMFPythonCollections", 1)[1].split(
        "\\endcode", 2
    )[:2]
    names = {"mesh": smf.Mesh(*shapes.torus(20, 30)), "__name__": "__main__"}
    for text in (first, second):
        (tmp_path / "block.txt").write_text(text)
        file = tmp_path / "block.txt"
        names = run_block(file, "\\code{.py}\n", "\\endcode", tmp_path, monkeypatch, names)
    assert names["report"].done == 2
    assert "torus.off" in capsys.readouterr().out.splitlines()[-2]


def off(mesh):
    lines = ["OFF", f"{mesh.number_of_vertices} {mesh.number_of_faces} 0"]
    lines += [" ".join(map(repr, v)) for v in mesh.vertices.tolist()]
    lines += ["3 " + " ".join(map(str, f)) for f in mesh.faces.tolist()]
    return "\n".join(lines) + "\n"


@pytest.mark.parametrize(
    "make", [shapes.body, shapes.plate, shapes.torus, shapes.tube, lambda: shapes.sphere(2)]
)
def test_the_program_in_cpp_finds_the_same(make, tmp_path):
    program = os.environ.get("SMF_MAIN_PROGRAM")
    if not program:
        pytest.skip("SMF_MAIN_PROGRAM does not name the program")
    mesh = smf.Mesh(*make())
    (tmp_path / "mesh.off").write_text(off(mesh))
    command = [program, tmp_path / "mesh.off", "--json", "--quiet", "--borders", "ends"]
    expected = json.loads(subprocess.run(command, capture_output=True, check=True).stdout)
    r = smf.reeb_graph(mesh)
    assert [set(pole.vertices.tolist()) for pole in r.poles] == [set(p) for p in expected["poles"]]
    assert [e.tolist() for e in r.ends] == [a["nodes"] for a in expected["reeb_graph"]["arcs"]]
    fluxes = [a["flux"] for a in expected["reeb_graph"]["arcs"]]
    np.testing.assert_allclose(r.fluxes, fluxes, rtol=1e-9)
    lengths = [a["length"] for a in expected["reeb_graph"]["arcs"]]
    np.testing.assert_allclose([arc["length"] for arc in r.skeleton.arcs], lengths, rtol=1e-9)
    moduli = [loop["modulus"] for loop in expected["found_loops"]]
    np.testing.assert_allclose([x.modulus for x in r.canonical_loops.values()], moduli, rtol=1e-9)
    assert r.certificate.energy == pytest.approx(expected["foliation"]["energy"], rel=1e-9)
    assert r.symmetries.arc_groups == expected["symmetries"]
