#!/usr/bin/env bash
# test/record_runs.sh PROGRAM OUTPUT CGAL_MESHES [MORE_MESHES]
#
# Records what the main program computes, for a change that must not change it: runs PROGRAM (a
# built foliation_reeb_graph) on meshes of the folder CGAL_MESHES, which is CGAL's data/meshes, and
# of the folder MORE_MESHES if it is given, and leaves in the folder OUTPUT for each run a folder
# with all files that it writes, and its JSON without the times. Two records, made by the programs
# built before and after the change with the same compiler, are compared with
#   diff -r BEFORE AFTER
set -euo pipefail

program=$1 output=$2 meshes=$3 more=${4:-}
if [ ! -x "$program" ]; then
  echo "there is no program $program" >&2
  exit 1
fi
if [ -e "$output" ]; then # runs of another program would count as runs of this one
  echo "$output exists" >&2
  exit 1
fi
data=$(cd "$(dirname "$0")/.." && pwd)/examples/Surface_mesh_foliation/data
mkdir -p "$output"

run() # NAME MESH OPTION...
{
  local name=$1 mesh=$2
  shift 2
  if [ ! -e "$mesh" ]; then
    echo "$name: no $mesh" >&2
    return
  fi
  mkdir -p "$output/$name"
  local status=0
  "$program" "$mesh" "$@" --json --output "$output/$name/files" \
    >"$output/$name/all.json" 2>"$output/$name/errors.txt" || status=$?
  echo "$status" >"$output/$name/status.txt"
  sed '/"seconds": {/,/}/d' "$output/$name/all.json" >"$output/$name/result.json"
  rm "$output/$name/all.json"
}

poles() # VERTEX...
{
  printf -- '--pole %s ' "$@"
}

hand=$(poles 51 21 217 435 852 1076)
elephant=$(poles 2759 2555 2047 1671 2279 1401 982)
# shellcheck disable=SC2086
{
  # given poles and loops
  run hand "$meshes/hand.off" $hand
  run hand_loops "$meshes/hand.off" $hand --loops "$data/hand.loops"
  run hand_heights "$meshes/hand.off" $hand --heights 1,2,0.01,4,5,300
  run hand_cotangent "$meshes/hand.off" $hand --weights cotangent
  run hand_one_iteration "$meshes/hand.off" $hand --max-iterations 1
  run hand_two_poles "$meshes/hand.off" $(poles 51 435)
  run hand_line "$meshes/hand.off" $(poles 51 21) --pole-line 434,435,436
  run hand_bad_pole "$meshes/hand.off" $(poles 51 51)
  run elephant "$meshes/elephant.off" $elephant
  run elephant_loops "$meshes/elephant.off" $elephant --loops "$data/elephant.loops"
  run elephant_found_loops "$meshes/elephant.off" $elephant --auto-loops
  # Whitehead moves
  run hand_whitehead "$meshes/hand.off" $hand --solver whitehead --relaxation 1.9
  run cross_whitehead "$meshes/cross.off" --auto-poles --solver whitehead --relaxation 1.5 \
    --tolerance 1e-8
  run eight_whitehead "$meshes/eight.off" --auto-loops --solver whitehead
  # what is found
  run hand_found "$meshes/hand.off"
  run elephant_found "$meshes/elephant.off"
  run bear_found "$meshes/bear.off" --auto-poles
  run camel_found "$meshes/camel.off" --auto-poles 6
  run knot_found "$meshes/knot1.off"
  run eight_loops "$meshes/eight.off" --auto-loops
  run holes_long_loops "$meshes/elephant.off" $elephant --auto-loops --min-loop-length 0.2
  run open "$meshes/elephant-with-holes.off"
}
if [ -n "$more" ]; then
  for mesh in "$more"/*.off; do
    name=$(basename "$mesh" .off)
    run "${name}_found" "$mesh"
    case $name in
      fish_* | spot_829) run "${name}_lines" "$mesh" --pole-lines auto --auto-poles ;;
      torus_*) run "${name}_poles" "$mesh" $(poles 0 1200) --auto-loops ;;
    esac
  done
fi
echo "recorded $(find "$output" -mindepth 1 -maxdepth 1 | wc -l) runs, $(cat "$output"/*/status.txt | grep -c '^0$') of them without error"
