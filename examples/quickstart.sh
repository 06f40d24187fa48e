#!/usr/bin/env bash
# examples/quickstart.sh: installs what the main program needs (Debian 12), builds it in
# build/quickstart, and computes the Reeb graphs of two of CGAL's meshes into the folder output.
set -euo pipefail
cd "$(dirname "$0")/.."

# The runs, one per line: name of the folder in output, mesh, and options of the program.
runs=(
  # a fist: wrist, thumb, the bends of four fingers
  "hand hand.off --pole 51 --pole 21 --pole 217 --pole 435 --pole 852 --pole 1076"
  # an elephant of genus 3: four feet, trunk, two ears, and loops around its handles
  "elephant elephant.off --pole 2759 --pole 2555 --pole 2047 --pole 1671 --pole 2279 --pole 1401 --pole 982 --loops examples/Surface_mesh_foliation/data/elephant.loops"
)

test/install_packages.sh library program

build=build/quickstart
cmake --preset release -B "$build" \
  -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF
cmake --build "$build" --target foliation_reeb_graph

for run in "${runs[@]}"; do
  read -r name mesh options <<<"$run"
  echo
  echo "== $mesh"
  # shellcheck disable=SC2086
  "$build/examples/Surface_mesh_foliation/foliation_reeb_graph" \
    "$build/cgal/data/meshes/$mesh" $options --output "output/$name"
done

echo
echo "Written:"
for run in "${runs[@]}"; do
  ls -1 "output/${run%% *}"/*
done
