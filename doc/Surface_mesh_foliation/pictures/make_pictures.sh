#!/usr/bin/env bash
# doc/Surface_mesh_foliation/pictures/make_pictures.sh: installs what it needs (Debian 12), builds
# the main program, the examples, solve_steps and draw in build/pictures, runs them on CGAL's
# meshes, and draws all pictures of the README and the manual into doc/Surface_mesh_foliation/fig.
# Some pictures show other meshes: they are drawn if the environment variable SMF_SHARED_DIR is the
# path of a folder that contains a folder meshes.
set -euo pipefail
[ -z "${SMF_SHARED_DIR:-}" ] || SMF_SHARED_DIR=$(realpath "$SMF_SHARED_DIR")
cd "$(dirname "$0")/../../.."

test/install_packages.sh library program pictures

build=$PWD/build/pictures
cmake --preset release -B "$build" \
  -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF
cmake --build "$build" --target foliation_reeb_graph detect_feature_lines \
  component_coordinates embedding_samples loops_by_hand
cmake -G Ninja -S doc/Surface_mesh_foliation/pictures -B "$build/draw"
cmake --build "$build/draw"

programs=$build/examples/Surface_mesh_foliation
meshes=$build/cgal/data/meshes
loops=$PWD/examples/Surface_mesh_foliation/data
fig=$PWD/doc/Surface_mesh_foliation/fig

# ===  The foliations, one folder each in build/pictures/out

rm -rf "$build/out"
mkdir "$build/out"
cd "$build/out"

# foliate FOLDER MESH OPTION...
foliate()
{
  "$programs/foliation_reeb_graph" "$meshes/$2" "${@:3}" --quiet --output "$1"
}

# poles VERTEX...: the options that make these vertices poles
poles()
{
  printf -- '--pole %s ' "$@"
}

# shellcheck disable=SC2046
{
  # wrist, thumb, the bends of four fingers
  foliate hand hand.off $(poles 51 21 217 435 852 1076)
  foliate palm hand.off $(poles 51 21 217 435 852 1076) --loops "$loops/hand.loops" \
    --heights 1,1,1,1,1,1,0.4
  # four feet, trunk, two ears
  foliate elephant elephant.off $(poles 2759 2555 2047 1671 2279 1401 982) \
    --loops "$loops/elephant.loops"
  foliate elephant_without_loops elephant.off $(poles 2759 2555 2047 1671 2279 1401 982)
  # the rim of an ear instead of its tip
  foliate ear elephant.off $(poles 2759 2555 2047 1671 2279 1401) --pole-line \
    2338,2340,1584,1705,1706,1580,516,1576,1575,2605,1574,1555,1568,2586,1549,1569,1536,1535,1531 \
    --loops "$loops/elephant.loops"
  # nose, hooves, tip of the tail: as in the example embedding_samples
  foliate even camel.off $(poles 3548 9213 9495 8802 9067 512)
}
cp -r even uniform
"$programs/embedding_samples" >samples.txt
for kind in even uniform; do
  mv "${kind}_skeleton.ply" $kind/skeleton.ply
  mv "${kind}_leaves.ply" $kind/leaves.ply
done
# foliate_found FOLDER MESH OPTION...: with the poles and the canonical loops that are found
foliate_found()
{
  "$programs/foliation_reeb_graph" "$2" "${@:3}" --quiet --output "$1"
}
for mesh in armadillo bear elephant hand homer camel; do
  foliate_found "found_$mesh" "$meshes/$mesh.off"
done
# hierarchy NAME MESH: the levels of detail of one mesh
hierarchy()
{
  foliate_found "hierarchy_$1_1" "$2" --auto-poles --detail 1000
  foliate_found "hierarchy_$1_2" "$2"
  foliate_found "hierarchy_$1_3" "$2" --auto-poles --detail 0
}
hierarchy elephant "$meshes/elephant.off"
hierarchy homer "$meshes/homer.off"
shared_meshes=
if [ -n "${SMF_SHARED_DIR:-}" ]; then
  shared_meshes="human_man_6890 human_woman_6890 hand_7993 cat_7949 scorpion_6315 scorpion_49997
    airplane_8730"
fi
for mesh in $shared_meshes; do
  foliate_found "found_$mesh" "$SMF_SHARED_DIR/meshes/$mesh.off"
done
# foliate_lines FOLDER MESH VERTEX...: with the lines that are found, and poles
foliate_lines()
{
  local options
  options=$("$programs/detect_feature_lines" "$2" "${@:3}" |
    sed -n 's/^line .*, vertices \(.*\)/--pole-line \1/p')
  # shellcheck disable=SC2046,SC2086
  "$programs/foliation_reeb_graph" "$2" $options $(poles "${@:3}") --quiet --output "$1"
}
foliate_lines lines_elephant "$meshes/elephant.off" 2759 2555 2047 1671 2279
if [ -n "$shared_meshes" ]; then
  foliate_lines lines_airplane "$SMF_SHARED_DIR/meshes/airplane_8730.off" 8695 # the nose
  foliate_lines lines_fish "$SMF_SHARED_DIR/meshes/fish_945.off" 604           # the mouth
fi
foliate auto_elephant elephant.off
if [ -n "$shared_meshes" ]; then
  # foliate_boot FOLDER LENGTH: without handles that have a shorter loop
  foliate_boot()
  {
    "$programs/foliation_reeb_graph" "$SMF_SHARED_DIR/meshes/boot_19931.off" --auto-poles \
      --auto-loops --min-loop-length "$2" --quiet --output "$1"
  }
  foliate_boot boot_0 0
  foliate_boot boot_2 0.02
  foliate_boot boot_5 0.05
fi
mkdir squares
(cd squares && "$programs/component_coordinates" >shapes.txt)
mkdir bear
(cd bear && "$programs/loops_by_hand" >loops.txt)
mkdir solve
"$build/draw/solve_steps" "$meshes/hand.off" solve 51 21 217 435 852 1076 >solve/steps.txt

# ===  The pictures

draw=$build/draw/draw
hand_view=(--view "-0.1,0.5,1")
elephant_view=(--view "0.35,0.2,-1")
ear_view=(--view "0.3,-0.15,-1" --zoom 2.9 --center "0.08,0.03,-0.1")
bear_view=(--view "-0.4,0.3,1")
camel_view=(--view "1,0.15,0.3")
graph=(--surface transparent --skeleton)

"$draw" "$fig/teaser.png" 360x370 \
  --panel hand --leaves "${hand_view[@]}" \
  --panel hand "${graph[@]}" "${hand_view[@]}" \
  --panel elephant --leaves "${elephant_view[@]}" \
  --panel elephant "${graph[@]}" "${elephant_view[@]}"

"$draw" "$fig/notions.png" 400x450 \
  --panel bear --gray --curves bear/loops.ply --poles "${bear_view[@]}" \
  --panel bear --gray --leaves "${bear_view[@]}" \
  --panel bear --critical "${bear_view[@]}" \
  --panel bear "${graph[@]}" --tube-radius 0.012 "${bear_view[@]}"

"$draw" "$fig/poles.png" 500x430 \
  --panel elephant --leaves "${ear_view[@]}" \
  --panel ear --leaves "${ear_view[@]}"

"$draw" "$fig/separating_loop.png" 370x350 \
  --panel hand --leaves "${hand_view[@]}" \
  --panel hand "${graph[@]}" "${hand_view[@]}" \
  --panel palm --leaves "${hand_view[@]}" \
  --panel palm "${graph[@]}" "${hand_view[@]}"

"$draw" "$fig/handles.png" 370x370 \
  --panel elephant_without_loops --leaves "${elephant_view[@]}" \
  --panel elephant_without_loops "${graph[@]}" "${elephant_view[@]}" \
  --panel elephant --leaves "${elephant_view[@]}" \
  --panel elephant "${graph[@]}" "${elephant_view[@]}"

if [ -n "$shared_meshes" ]; then
  "$draw" "$fig/automatic_loops.png" 370x370 \
    --panel auto_elephant "${graph[@]}" "${elephant_view[@]}" \
    --panel boot_0 "${graph[@]}" \
    --panel boot_2 "${graph[@]}" \
    --panel boot_5 "${graph[@]}" \
    --panel boot_5 --leaves
fi

"$draw" "$fig/sampling.png" 440x430 \
  --panel even --leaves "${camel_view[@]}" \
  --panel even "${graph[@]}" --samples "${camel_view[@]}" \
  --panel uniform --leaves "${camel_view[@]}" \
  --panel uniform "${graph[@]}" --samples "${camel_view[@]}"

"$draw" "$fig/coordinates.png" 500x490 \
  --panel squares --squares 0.02 "${camel_view[@]}" \
  --panel squares --squares 0.02 --view "-1,0.25,0.7"

"$draw" "$fig/solve.png" 300x285 \
  --panel solve/loops --gray --curves solve/loops.ply --poles "${hand_view[@]}" \
  --panel solve/0 --leaves "${hand_view[@]}" \
  --panel solve/1 --leaves "${hand_view[@]}" \
  --panel solve/2 --leaves "${hand_view[@]}" \
  --panel solve/last --leaves "${hand_view[@]}"

"$draw" "$fig/convergence.png" 1200x420 --panel solve --plot

"$draw" "$fig/feature_poles.png" 330x360 \
  --panel found_armadillo --poles --view "0.3,0.2,-1" \
  --panel found_elephant --poles "${elephant_view[@]}" \
  --panel found_hand --poles "${hand_view[@]}" \
  --panel found_homer --poles --view "0.2,0.1,1" \
  --panel found_camel --poles "${camel_view[@]}"

"$draw" "$fig/canonical.png" 330x330 \
  --panel found_bear "${graph[@]}" --tube-radius 0.012 "${bear_view[@]}" \
  --panel found_camel "${graph[@]}" "${camel_view[@]}" \
  --panel found_homer "${graph[@]}" --view "0.2,0.1,1" \
  --panel found_armadillo "${graph[@]}" --view "0.3,0.2,-1" \
  --panel found_elephant "${graph[@]}" "${elephant_view[@]}"

"$draw" "$fig/hierarchy.png" 330x330 \
  --panel hierarchy_homer_1 "${graph[@]}" --view "0.2,0.1,1" \
  --panel hierarchy_homer_2 "${graph[@]}" --view "0.2,0.1,1" \
  --panel hierarchy_homer_3 "${graph[@]}" --view "0.2,0.1,1" \
  --panel hierarchy_elephant_1 "${graph[@]}" "${elephant_view[@]}" \
  --panel hierarchy_elephant_2 "${graph[@]}" "${elephant_view[@]}" \
  --panel hierarchy_elephant_3 "${graph[@]}" "${elephant_view[@]}"

# the errors of moduli against the number of vertices around the surface, from the table
mkdir moduli
awk -F, '/^[0-9]/ { for (i = 2; i <= NF; ++i) print i - 2, $1, $i < 0 ? -$i : $i }' \
  "$fig/../data/loop_moduli.csv" >moduli/convergence.txt
"$draw" "$fig/loop_moduli.png" 700x420 --panel moduli --plot

# time and memory against the number of vertices, from the columns of the table
mkdir growth_all growth_parts growth_memory
curves_of_growth()
{
  awk -F, -v columns="$*" \
    '/^[0-9]/ { for (i = 1; i <= split(columns, c, " "); ++i) print i - 1, $1, $c[i] }' \
    "$fig/../data/growth.csv"
}
curves_of_growth 8 9 4 5 >growth_all/convergence.txt
curves_of_growth 2 3 6 7 >growth_parts/convergence.txt
curves_of_growth 10 11 >growth_memory/convergence.txt
"$draw" "$fig/growth.png" 480x420 --panel growth_all --plot \
  --panel growth_parts --plot --panel growth_memory --plot

if [ -n "$shared_meshes" ]; then
  scorpion_view=(--view "0.8,0.7,0.7")
  "$draw" "$fig/feature_poles_of_meshes.png" 290x330 \
    --panel found_human_man_6890 --poles \
    --panel found_human_woman_6890 --poles \
    --panel found_hand_7993 --poles \
    --panel found_cat_7949 --poles --view "-0.6,0.3,1" \
    --panel found_scorpion_6315 --poles "${scorpion_view[@]}" \
    --panel found_scorpion_49997 --poles "${scorpion_view[@]}" \
    --panel found_airplane_8730 --poles --view "0.5,-0.6,0.8" --up "0,0,1"

  "$draw" "$fig/canonical_of_meshes.png" 330x330 \
    --panel found_human_man_6890 "${graph[@]}" \
    --panel found_human_woman_6890 "${graph[@]}" \
    --panel found_cat_7949 "${graph[@]}" --view "-0.6,0.3,1" \
    --panel found_scorpion_6315 "${graph[@]}" "${scorpion_view[@]}" \
    --panel found_airplane_8730 "${graph[@]}" --view "0.5,-0.6,0.8" --up "0,0,1"

  "$draw" "$fig/feature_lines.png" 430x390 \
    --panel lines_airplane --leaves --view "0.5,-0.6,0.8" --up "0,0,1" \
    --panel lines_fish --leaves --view "1,0.3,0.3" \
    --panel lines_elephant --leaves "${elephant_view[@]}"
fi

"$draw" "$fig/Surface_mesh_foliation_icon.png" 130x130 \
  --panel bear "${graph[@]}" --tube-radius 0.02 "${bear_view[@]}"

ls -l "$fig"
