# SPDX-License-Identifier: GPL-3.0-or-later
"""python3 conan_recipe.py ROOT FOLDER: runs the recipe of Conan into FOLDER, with a module that stands
in for Conan, which Debian does not have, and fails if version, files or targets of the package are
wrong. That Conan itself accepts the recipe is not checked."""

import importlib.util
import re
import shutil
import sys
import types
from pathlib import Path


class StandIn:
    """What the recipe uses of conan.ConanFile."""

    def __init__(self, recipe_folder, export_folder, package_folder):
        self.recipe_folder = str(recipe_folder)
        self.export_sources_folder = self.source_folder = str(export_folder)
        self.package_folder = str(package_folder)
        self.required, self.properties = {}, {}
        self.info = types.SimpleNamespace(clear=lambda: None)
        self.cpp_info = types.SimpleNamespace(set_property=self.properties.__setitem__)
        self.settings = types.SimpleNamespace(get_safe={"compiler": "gcc"}.get)

    def requires(self, reference, **traits):
        self.required[reference.split("/")[0]] = traits


def copy(_, pattern, source, destination):
    folder, _, names = pattern.rpartition("/")
    found = [path for path in (Path(source) / folder).rglob(names) if path.is_file()]
    assert found, f"nothing to copy: {pattern} in {source}"
    for path in found:
        target = Path(destination) / path.relative_to(source)
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)


def load_recipe(file):
    modules = {
        "conan": {"ConanFile": StandIn},
        "conan.tools": {},
        "conan.tools.build": {"check_min_cppstd": lambda recipe, standard: None},
        "conan.tools.files": {"copy": copy, "load": lambda recipe, path: Path(path).read_text()},
    }
    for name, members in modules.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
    spec = importlib.util.spec_from_file_location("conanfile", file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.SurfaceMeshFoliation


def main(root, folder):
    shutil.rmtree(folder, ignore_errors=True)
    recipe_folder = root / "package" / "conan"
    recipe = load_recipe(recipe_folder / "conanfile.py")(
        recipe_folder, folder / "export", folder / "package")
    for step in ("set_version", "export_sources", "requirements", "validate", "package",
                 "package_id", "package_info"):
        getattr(recipe, step)()

    header = "include/CGAL/Surface_mesh_foliation/version.h"
    text = (root / header).read_text()
    assert f'FOLIATION_VERSION "{recipe.version}"' in text, recipe.version
    assert re.fullmatch(r"\d+\.\d+\.\d+", recipe.version)

    def files_in(place):
        return {str(path.relative_to(place)) for path in place.rglob("*.h")}

    assert files_in(folder / "package" / "include") == files_in(root / "include")
    assert (folder / "package" / "licenses" / "LICENSE.md").is_file()
    assert set(recipe.required) == {"cgal", "eigen"}
    assert recipe.properties == {
        "cmake_file_name": "Surface_mesh_foliation",
        "cmake_target_name": "Surface_mesh_foliation::Surface_mesh_foliation",
        "pkg_config_name": "surface-mesh-foliation",
    }
    print(f"{recipe.name} {recipe.version}: {len(files_in(folder / 'package'))} headers")


if __name__ == "__main__":
    main(Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve())
