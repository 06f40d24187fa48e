#!/usr/bin/env bash
# test/run.sh [CMAKE-ARGUMENT...]: installs what the tests need (Debian 12), builds the tests and
# the examples in build/test, and runs them all.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh library tests

cmake --preset release -B build/test \
  -D SURFACE_MESH_FOLIATION_BUILD_TESTS=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF \
  "$@"
cmake --build build/test
ctest --test-dir build/test --output-on-failure --no-tests=error --parallel "$(nproc)"
