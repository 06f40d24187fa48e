#!/usr/bin/env bash
# demo/Surface_mesh_foliation/test/engine/run.sh [MESH...]: tests the engine under node, after
# build_engine.sh, and compares it with the same code compiled natively, on meshes of the package's
# generators, on CGAL's, on those in $SURFACE_MESH_FOLIATION_SHARED_DIR/meshes, and on those given.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../../../.."

test/install_packages.sh library program wasm

build=build/engine_native
cmake -S demo/Surface_mesh_foliation -B $build -G Ninja
cmake --build $build

mkdir -p $build/meshes
$build/make_meshes $build/meshes
meshes=($build/meshes/*.off)

archive=/usr/share/doc/libcgal-dev/data.tar.gz
names="3torus anchor blob-closed cactus double-torus-example eight elk hand handle homer joint knot1
  mesh_with_border pinion rotor spool triceratops"
for name in $names; do
  file=data/meshes/$name.off
  [ -e $build/$file ] || tar -xzf $archive -C $build $file
  meshes+=($build/$file)
done

[ -z "${SURFACE_MESH_FOLIATION_SHARED_DIR:-}" ] ||
  meshes+=("$SURFACE_MESH_FOLIATION_SHARED_DIR"/meshes/*.off)

$build/write_results "${meshes[@]}" "$@" > $build/results.json
esbuild demo/Surface_mesh_foliation/engine/Server.ts --bundle --format=esm --log-level=warning \
  --outfile=$build/Server.mjs
export NATIVE_RESULTS=$PWD/$build/results.json SERVER_MODULE=$PWD/$build/Server.mjs
node --test "$here"/*.test.mjs
