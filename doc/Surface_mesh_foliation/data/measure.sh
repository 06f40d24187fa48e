#!/usr/bin/env bash
# doc/Surface_mesh_foliation/data/measure.sh TABLE...: installs what it needs (Debian 12), builds
# the benchmarks in build/measure, measures the numbers of some tables of the manual, and writes
# them into the files TABLE.csv beside this script. The tables are
#   whole_way     from a mesh to its graph
#   edits         foliations after edits of poles and loops
#   growth        how time and memory grow with the size of the mesh
#   speed         from a mesh to its foliation, and restarts
#   parallel      the same with Parallel_tag
#   whitehead     Whitehead moves beside Newton's method
#   after_solve   everything after the solve, and Reeb graphs of functions
#   edge_values   foliations from edge values
#   torus_moduli  moduli of a torus, which do not depend on the machine
#   loop_moduli   errors of moduli of loops, which do not depend on it either
#   canonical     canonical loops of CGAL's and of shared meshes, which do not
#   python_overhead     the Python module beside C++
#   python_collections  collections of meshes by several processes, and on a cluster
#   python_cluster      written together with python_collections
# Environment variables:
#   SMF_SHARED_DIR  a folder with meshes/human_man_6890.off, the body of the tables; without it
#                   CGAL's hand is measured instead
#   SMF_LEVELS      how often the body is subdivided at most: 0 to 4 (4, which needs 14 GiB)
#   SMF_OUTPUT      the folder to write to, instead of this one
# Let nothing else run meanwhile. All tables take some hours.
set -euo pipefail
script=$(realpath "$0")
[ -z "${SMF_SHARED_DIR:-}" ] || SMF_SHARED_DIR=$(realpath "$SMF_SHARED_DIR")
[ -z "${SMF_OUTPUT:-}" ] || SMF_OUTPUT=$(realpath "$SMF_OUTPUT")
cd "$(dirname "$script")/../../.."

output=${SMF_OUTPUT:-doc/Surface_mesh_foliation/data}
levels=${SMF_LEVELS:-4}
restart_levels=$((levels < 3 ? levels : 3)) # what is measured for the smaller meshes only
build=build/measure
programs=$build/benchmark/Surface_mesh_foliation

test/install_packages.sh library program benchmarks optional tables

# build TARGET...: of the package
build()
{
  cmake --preset release -B "$build" \
    -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF \
    -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=OFF \
    -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=ON \
    -D SURFACE_MESH_FOLIATION_SHARED_DIR="${SMF_SHARED_DIR:-}" >"$build.log"
  cmake --build "$build" --target "$@" >>"$build.log"
}

# run PROGRAM FILTER: prints the rows of a benchmark as CSV, with the names of the columns first
run()
{
  "$programs/$1" --benchmark_filter="$2" --benchmark_format=csv 2>>"$build.log" |
    sed -n '/^name,/,$p' | grep -v '_BigO"\|_RMS"' || {
    echo "$1 has no rows $2; see $build.log" >&2
    return 1
  }
}

# column NAME FORMAT [EXPRESSION]: of the rows that `run` prints, one column; EXPRESSION is in terms
# of x, such as 1/x
column()
{
  awk -F, -v name="$1" -v format="$2\n" '
    { gsub(/"/, "") }
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i; next }
    { x = $c; printf format, '"${3:-x}"' }'
}

# write TABLE NOTE TITLES: writes the rows of the standard input into the file of a table
write()
{
  local machine system cgal
  machine="$(lscpu | sed -n 's/^Model name: *//p'), $(nproc) cores"
  system=$(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release)
  cgal=$(sed -n 's/^# *define CGAL_VERSION \([0-9.]*\)$/\1/p' /usr/include/CGAL/version.h)
  {
    echo "# $machine, $system, g++ $(g++ -dumpfullversion), CGAL $cgal, $(date +%F)."
    echo "# $2 Made by: measure.sh $1"
    echo "$3"
    cat
  } >"$build/$1.csv"
  cp "$build/$1.csv" "$output/$1.csv"
  echo "written: $output/$1.csv"
}

whole_way()
{
  build benchmark_whole_way
  # of the three tables it prints, the columns of the first and the memory of the last
  "$programs/benchmark_whole_way" --levels="$restart_levels" --runs=3 | awk -F'|' '
    { gsub(/ /, "") }
    $2 == "vertices" { ++table; row = 0 }
    $2 + 0 > 0 { ++row }
    $2 + 0 > 0 && table == 1 { cells[row] = $2 "," $3 "," $4 "," $5; rows = row }
    $2 + 0 > 0 && table == 3 { cells[row] = cells[row] "," $4 "," $5 }
    END { for (i = 1; i <= rows; ++i) print cells[i] }' |
    write whole_way "Times in units of one solve; medians of three runs." \
      "vertices,poles given,in parallel,from the bare mesh,memory of a solve (MiB),memory with poles given (MiB)"
}

edits()
{
  build benchmark_edits
  "$programs/benchmark_edits" --levels="$restart_levels" --runs=3 |
    sed -n 's/^| \([0-9].*\) |$/\1/p' | sed 's/ | /,/g' |
    write edits "One core; times in units of one solve; medians of three runs." \
      "vertices,first,another height,a pole moved by an edge,a pole moved by 2%,a pole removed,a pole added"
}

growth()
{
  build benchmark_growth
  local rows
  rows=$("$programs/benchmark_growth" --first=3 --last=$((levels + 6)))
  tail -n +2 <<<"$rows" | write growth "One core; seconds and MiB." "$(head -n 1 <<<"$rows")"
}

speed()
{
  build benchmark_speed
  local rows cholmod restarts=()
  rows=$(run benchmark_speed "^from_cold<Default_solver>/[0-$levels]/")
  cholmod=$(run benchmark_speed "^from_cold<SMF::Cholmod_solver>/$levels/")
  for kind in moved_pole other_height other_pose; do
    run benchmark_speed "^$kind/[0-$restart_levels]/" | column solves %.1f >"$build/$kind.txt"
    restarts+=("$build/$kind.txt")
  done
  {
    paste -d, <(column vertices %d <<<"$rows") <(column vertices default <<<"$rows") \
      <(column solves %.1f <<<"$rows") <(column iterations %d <<<"$rows") \
      <(column peak_MB %.0f <<<"$rows") "${restarts[@]}"
    paste -d, <(column vertices %d <<<"$cholmod") <(column vertices Cholmod_solver <<<"$cholmod") \
      <(column solves %.1f <<<"$cholmod") <(column iterations %d <<<"$cholmod") \
      <(column peak_MB %.0f <<<"$cholmod") <(echo ,,)
  } | write speed "One core; times in units of one solve, memory in MiB." \
    "vertices,linear solver,from mesh to certified foliation,iterations,peak memory (MiB),a pole moved,other heights,another pose"
}

parallel()
{
  build benchmark_speed
  local rows
  rows=$(run benchmark_speed "^from_cold_in_parallel/[0-$levels]/")
  paste -d, <(column vertices %d <<<"$rows") <(column speedup %.2f 1/x <<<"$rows") |
    write parallel "All cores." "vertices,time in parallel / time in sequence"
}

whitehead()
{
  build benchmark_whitehead_moves
  local rows
  rows=$(run benchmark_whitehead_moves "^whitehead_moves/1/")
  paste -d, <(printf '%s\n' 1 1.9) <(column sweeps %d <<<"$rows") <(column newtons %.0f <<<"$rows") \
    <(column parallel_newtons %.0f <<<"$rows") <(column newtons_to_gap %.0f <<<"$rows") |
    write whitehead "Whitehead moves on one core; times in units of Newton's method." \
      "over-relaxation,sweeps,time / certified foliation on one core,time / certified foliation on all cores,time / Newton's method to the same energy"
}

after_solve()
{
  build benchmark_speed benchmark_scalar_reeb_graph
  # within <( ), a benchmark that fails would only leave its column empty
  local stages coordinates height random_values
  stages=$(run benchmark_speed "^stages_after_solve/[0-$restart_levels]/")
  coordinates=$(run benchmark_speed "^component_coordinates/[0-$restart_levels]/")
  height=$(run benchmark_scalar_reeb_graph "^height/[0-$restart_levels]/")
  random_values=$(run benchmark_scalar_reeb_graph "^random_values/[0-$restart_levels]/")
  paste -d, <(column vertices %d <<<"$stages") <(column solves %.1f <<<"$stages") \
    <(column solves %.1f <<<"$coordinates") <(column solves %.1f <<<"$height") \
    <(column solves %.1f <<<"$random_values") |
    write after_solve "One core; times in units of one solve." \
      "vertices,combinatorial stages after the solve,Component_coordinates,Reeb graph of the elevation,Reeb graph of random values"
}

edge_values()
{
  build benchmark_stages
  local solves rows
  solves=$(run benchmark_stages "^one_solve/[0-$restart_levels]$")
  rows=$(run benchmark_stages "^integration/[0-$restart_levels]$")
  paste -d, <(column vertices %d <<<"$rows") <(column real_time %.9g <<<"$rows") \
    <(column real_time %.9g <<<"$solves") | awk -F, '{ printf "%d,%.1f\n", $1, $2 / $3 }' |
    write edge_values "One core; times in units of one solve." "vertices,integrate_foliation()"
}

# moduli PROGRAM: runs one of the programs beside this script
moduli()
{
  cmake -G Ninja -S doc/Surface_mesh_foliation/data -B "$build/moduli" >"$build.log"
  cmake --build "$build/moduli" --target "$1" >>"$build.log"
  "$build/moduli/$1"
}

loop_moduli()
{
  moduli loop_moduli |
    write loop_moduli "Relative errors of moduli, positive if they are too small." \
      "vertices around,capsule with four poles,tube between two openings,tube of a torus,disk with two poles"
}

canonical()
{
  cmake --preset release -B "$build" \
    -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF \
    -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=ON \
    -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF >"$build.log"
  cmake --build "$build" --target foliation_reeb_graph >>"$build.log"
  local meshes=("$build"/cgal/data/meshes/{armadillo,bear,camel,elephant,hand,homer}.off)
  [ -z "${SMF_SHARED_DIR:-}" ] || meshes+=("$SMF_SHARED_DIR"/meshes/*.off)
  for mesh in "${meshes[@]}"; do
    "$build/examples/Surface_mesh_foliation/foliation_reeb_graph" "$mesh" --quiet --json |
      python3 -c '
import json, sys
result = json.load(sys.stdin)
loops = result["found_loops"]
moduli = lambda completing: " ".join(
    "%.2f" % loop["modulus"] + ("" if loop["separating"] else "*")
    for loop in loops if loop.get("completing") == completing)
print(sys.argv[1], result["vertices"], result["genus"], len(result["poles"]),
      moduli(False), moduli(True), sep=",")' "$(basename "$mesh" .off)"
  done | write canonical "A star marks loops that do not separate the surface." \
    "mesh,vertices,genus,poles,moduli of canonical loops,of further loops for handles"
}

torus_moduli()
{
  moduli torus_moduli |
    write torus_moduli "Radii R = 3 and r = 1, cotangent weights." \
      "vertices around the tube,error of k/c around the tube,error of k/c around the axis,energy above conformal around the tube,energy above conformal around the axis"
}

# the Python module, and the program that it is measured beside, as pip compiles them
build_python()
{
  test/install_packages.sh library python clusters
  cmake -G Ninja -S python -B "$build/python" -D Python_EXECUTABLE=/usr/bin/python3 \
    -D SURFACE_MESH_FOLIATION_PYTHON_BENCHMARKS=ON >"$build.log"
  cmake --build "$build/python" --target _core from_arrays >>"$build.log"
  mkdir -p "$build/module"
  cp -r python/surface_mesh_foliation "$build/module"
  cp "$build"/python/_core*.so "$build/module/surface_mesh_foliation"
}

# run_python SCRIPT ARGUMENT...: runs one of those in python/benchmarks
run_python()
{
  PYTHONPATH=$build/module /usr/bin/python3 "python/benchmarks/$1" "${@:2}"
}

python_overhead()
{
  build_python
  local mesh=$build/python/hand.off importing
  if [ -n "${SMF_SHARED_DIR:-}" ]; then
    mesh=$SMF_SHARED_DIR/meshes/human_man_6890.off
  else
    tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build/python" --strip-components=2 \
      data/meshes/hand.off
  fi
  importing=$(run_python measure_overhead.py --importing)
  run_python measure_overhead.py "$build/python/benchmarks/from_arrays" "$mesh" \
    --levels="$((levels < 2 ? levels : 2))" |
    write python_overhead \
      "One core, time of the processor. Importing the module takes $importing ms." \
      "vertices,time in Python / time in C++"
}

# of those shared meshes that have less than 9,000 vertices, or of CGAL's
python_collections()
{
  build_python
  local meshes=("$build"/python/data/meshes/{bear,elephant,hand}.off)
  if [ -n "${SMF_SHARED_DIR:-}" ]; then
    meshes=("$SMF_SHARED_DIR"/meshes/*_{[0-9],[1-8][0-9]}[0-9][0-9].off)
  else
    tar -xzf /usr/share/doc/libcgal-dev/data.tar.gz -C "$build/python" data/meshes
  fi
  run_python measure_collection.py "${meshes[@]}" --output "$build"
  write python_collections "400 meshes, turned and stretched." "way,speed-up" <"$build/gains.csv"
  write python_cluster "100,000 meshes with $(cat "$build/overhead.txt")." \
    "workers,speed-up,limited by" <"$build/estimates.csv"
}

python_cluster()
{
  python_collections
}

if [ $# -eq 0 ]; then
  sed -n '2,/^set/{/^# /s/^# //p}' "$script"
  exit 1
fi
mkdir -p "$build" "$output"
for table in "$@"; do
  case $table in
    whole_way | edits | growth | speed | parallel | whitehead | after_solve | edge_values | \
      torus_moduli | loop_moduli | canonical | python_overhead | python_collections | python_cluster)
      "$table"
      ;;
    *) echo "there is no table $table" >&2 && exit 1 ;;
  esac
done
