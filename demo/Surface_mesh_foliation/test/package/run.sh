#!/usr/bin/env bash
# demo/Surface_mesh_foliation/test/package/run.sh [FOLDER...]: compiles the package's own tests to
# WebAssembly, those of all folders that apply or of those given, and runs them under node.
set -euo pipefail
cd "$(dirname "$0")/../../../.."

test/install_packages.sh library tests wasm

build=build/wasm_tests
data=$build/data/meshes
if [ ! -e $data ]; then
  mkdir -p $build
  tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C $build data/meshes
fi
export NODE_PATH=/usr/share/nodejs # where Debian has what the optimizer needs
folders=$(IFS=';'; echo "$*")
emcmake cmake -S demo/Surface_mesh_foliation/test/package -B $build -G Ninja \
  -D CMAKE_BUILD_TYPE=Release -D SMF_DATA_DIR="$PWD/$data" -D SMF_TEST_FOLDERS="$folders"
cmake --build $build
ctest --test-dir $build --output-on-failure --no-tests=error
