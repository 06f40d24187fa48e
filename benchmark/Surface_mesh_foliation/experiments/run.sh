#!/usr/bin/env bash
# benchmark/Surface_mesh_foliation/experiments/run.sh: installs what it needs (Debian 12), builds
# all experiments in build/experiments, runs them, copies their results into the folder results
# beside this script, and makes the tables and plots of the manual's chapter Experiments from these.
# Environment variables:
#   SMF_SHARED_DIR  a folder with a folder meshes, for the shapes that CGAL does not have
#   SMF_OUTPUT      a folder to write to, instead of this one and the manual
set -euo pipefail
[ -z "${SMF_SHARED_DIR:-}" ] || SMF_SHARED_DIR=$(realpath "$SMF_SHARED_DIR")
here=$(dirname "$(realpath "$0")")
cd "$here/../../.."

test/install_packages.sh library experiments

build=build/experiments
cmake --preset release -B "$build" \
  -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=ON \
  -D SURFACE_MESH_FOLIATION_SHARED_DIR="${SMF_SHARED_DIR:-}"
cmake --build "$build" --target experiments

manual=${SMF_OUTPUT:-doc/Surface_mesh_foliation}
results=${SMF_OUTPUT:-$here}/results
mkdir -p "$results"
cp "$build"/benchmark/Surface_mesh_foliation/experiments/results/*.csv "$results"
"$here/tables.py" "$results" "$manual/data" "$manual/fig"
fig=$(realpath "$manual/fig")
draw=$PWD/$build/draw/draw

# pictures of graphs, by the program that draws all pictures of the manual
cmake -G Ninja -S doc/Surface_mesh_foliation/pictures -B "$build/draw"
cmake --build "$build/draw" --target draw
cd "$build/benchmark/Surface_mesh_foliation/experiments/results/panels"
graph=(--surface transparent --skeleton)

hand=(--view "-0.1,0.5,1")
panels=()
for kind in harmonic_cotangent ours_star ours_loop_by_hand; do
  for pose in 0 4; do # the first one in which the harmonic function has another graph
    panels+=(--panel "hand_${pose}_$kind" "${graph[@]}" "${hand[@]}")
  done
done
"$draw" "$fig/experiment_hand.png" 300x330 "${panels[@]}"

"$draw" "$fig/experiment_degrees.png" 450x330 \
  --panel cow_0_harmonic_mean_value "${graph[@]}" --view "1,0.3,0.5" \
  --panel cow_0_ours_star "${graph[@]}" --view "1,0.3,0.5" \
  --panel cow_0_ours_canonical_loops "${graph[@]}" --view "1,0.3,0.5" \
  --panel homer_0_ours_star "${graph[@]}" --view "0.2,0.1,1"

panels=()
for method in marked_by_hand ours_star ours_canonical_loops shape_diameter_function; do
  panels+=(--panel "camel_$method" --view "1,0.15,0.3")
done
"$draw" "$fig/experiment_segments.png" 360x330 "${panels[@]}"

panels=()
for kind in height geodesic_distance first_eigenfunction harmonic_mean_value ours_star \
  ours_canonical_loops; do
  panels+=(--panel "camel_0_$kind" "${graph[@]}" --view "1,0.15,0.3")
done
"$draw" "$fig/experiment_graphs.png" 300x330 "${panels[@]}"
panels=()
for kind in harmonic_mean_value ours_canonical_loops; do
  for pose in 0 1 2; do
    panels+=(--panel "homer_${pose}_$kind" "${graph[@]}" --view "0.2,0.1,1")
  done
done
"$draw" "$fig/experiment_poses.png" 300x330 "${panels[@]}"
