# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipe of Conan 2, with the sources that it stands in: ``conan create package/conan``."""

import os
import re

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.files import copy, load

required_conan_version = ">=2.0"


class SurfaceMeshFoliation(ConanFile):
    name = "surface-mesh-foliation"
    description = "Reeb graphs of triangle meshes by harmonic measured foliations"
    license = "GPL-3.0-or-later"
    topics = ("cgal", "geometry-processing", "mesh", "reeb-graph", "skeleton")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"  # of what uses the headers
    no_copy_source = True

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..")

    def set_version(self):
        header = load(self, os.path.join(
            self._root, "include", "CGAL", "Surface_mesh_foliation", "version.h"))
        self.version = re.search(r'FOLIATION_VERSION "(.*)"', header)[1]

    def export_sources(self):
        for pattern in ("include/*.h", "LICENSE.md"):
            copy(self, pattern, self._root, self.export_sources_folder)

    def requirements(self):
        self.requires("cgal/[>=5.5 <7]", transitive_headers=True, transitive_libs=True)
        self.requires("eigen/[>=3.4 <4]", transitive_headers=True)

    def validate(self):
        check_min_cppstd(self, 17)

    def package(self):
        copy(self, "include/*.h", self.source_folder, self.package_folder)
        copy(self, "LICENSE.md", self.source_folder, os.path.join(self.package_folder, "licenses"))

    def package_id(self):
        self.info.clear()

    def package_info(self):
        self.cpp_info.set_property("cmake_file_name", "Surface_mesh_foliation")
        self.cpp_info.set_property(
            "cmake_target_name", "Surface_mesh_foliation::Surface_mesh_foliation")
        self.cpp_info.set_property("pkg_config_name", "surface-mesh-foliation")
        self.cpp_info.defines = ["CGAL_EIGEN3_ENABLED"]
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
        if self.settings.get_safe("compiler") == "gcc":
            self.cpp_info.cxxflags = ["-frounding-math"]
