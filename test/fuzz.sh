#!/usr/bin/env bash
# test/fuzz.sh SECONDS [TARGET...]: fuzzes the readers, repair, loop systems, edits and the three
# ways to a foliation, or only the targets given (the names of the files in test/fuzz), each for that
# many seconds, with clang's address and undefined behavior sanitizers. What is found is kept as
# build/fuzz/finds/TARGET-..., and the test fails. To run an input again:
#   build/fuzz/test/fuzz/fuzz_TARGET FILE
# Interesting inputs are kept in build/fuzz/corpus/TARGET, where the next run begins.
set -euo pipefail
cd "$(dirname "$0")/.."

if [ $# -eq 0 ]; then
  echo "usage: test/fuzz.sh SECONDS [TARGET...]" >&2
  exit 2
fi
seconds=$1
shift
targets=("$@")
if [ $# -eq 0 ]; then
  targets=(read_off read_obj read_ply read_stl read_loops repair loop_systems edits three_ways)
fi

if ! command -v clang++-14 >/dev/null; then
  test/install_packages.sh compilers library tests
fi
cmake --preset fuzz
cmake --build --preset fuzz --target write_seeds "${targets[@]/#/fuzz_}"

build=build/fuzz
mkdir -p $build/finds $build/logs
$build/test/fuzz/write_seeds $build/seeds

status=0
for target in "${targets[@]}"; do
  arguments=(-max_len=2048)
  case $target in
    read_*) arguments+=(-dict=test/fuzz/mesh_files.dict) ;;
    repair) arguments=(-max_len=256) ;;
    *) arguments=(-max_len=512 -len_control=0) ;;
  esac
  mkdir -p "$build/corpus/$target"
  if ! "$build/test/fuzz/fuzz_$target" "${arguments[@]}" -max_total_time="$seconds" \
    -rss_limit_mb=1024 -malloc_limit_mb=1024 -timeout=30 -print_final_stats=1 \
    -artifact_prefix="$build/finds/$target-" \
    "$build/corpus/$target" "$build/seeds/$target" >"$build/logs/$target" 2>&1; then
    status=1
    tail -n 60 "$build/logs/$target"
  fi
  # covered code of the target and its corpus are on the last line of progress
  printf '%-12s %9s runs, coverage %s\n' "$target" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/logs/$target")" \
    "$(grep -o 'cov: .* corp: [0-9]*' "$build/logs/$target" | tail -n 1)"
done
exit $status
