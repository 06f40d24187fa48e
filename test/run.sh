#!/usr/bin/env bash
# test/run.sh [CMAKE-ARGUMENT...]: installs what the tests need (Debian 12), builds the tests, the
# examples and the Python module in build/test, and tests them all. It is meant to be quick:
# programs are optimized a little, and compiled together as far as they can be. That each header and
# each example compiles alone is left to test/matrix.sh.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh library tests python

cmake --preset release -B build/test \
  -D SURFACE_MESH_FOLIATION_BUILD_TESTS=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF \
  -D SURFACE_MESH_FOLIATION_CHECK_HEADERS=OFF \
  -D SURFACE_MESH_FOLIATION_UNITY_EXAMPLES=ON \
  -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
  -D Python_EXECUTABLE=/usr/bin/python3 \
  "$@"
cmake --build build/test
ctest --test-dir build/test --output-on-failure --no-tests=error --parallel "$(nproc)"
