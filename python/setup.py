# SPDX-License-Identifier: GPL-3.0-or-later
"""Lets setuptools build the compiled part of the module by CMake."""

import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext


class CMakeBuild(build_ext):
    """Builds the extension by CMake.

    Of the environment, ``CMAKE_ARGS`` holds further arguments of CMake, which itself reads
    ``CMAKE_PREFIX_PATH``, ``CMAKE_GENERATOR`` and ``CMAKE_BUILD_PARALLEL_LEVEL``.
    """

    def build_extension(self, ext):
        source = Path(__file__).parent.resolve()
        output = Path(self.get_ext_fullpath(ext.name)).parent.resolve()
        build = Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        configure = [
            "cmake",
            f"-S{source}",
            f"-B{build}",
            f"-DPython_EXECUTABLE={sys.executable}",
            f"-DCMAKE_LIBRARY_OUTPUT_DIRECTORY={output}",
            "-DCMAKE_BUILD_TYPE=Release",
            *shlex.split(os.environ.get("CMAKE_ARGS", "")),
        ]
        environment = dict(os.environ)
        if shutil.which("ninja"):  # by default, CMake wants make
            environment.setdefault("CMAKE_GENERATOR", "Ninja")
        subprocess.run(configure, check=True, env=environment)
        subprocess.run(["cmake", "--build", str(build), "--target", "_core"], check=True)


setup(
    ext_modules=[Extension("surface_mesh_foliation._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)
