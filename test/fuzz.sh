#!/usr/bin/env bash
# test/fuzz.sh SECONDS [TARGET...]: fuzzes the readers, repair, loop systems, edits, the three ways
# to a foliation and the module for Python, or only the targets given (the names of the files in
# test/fuzz), each for that many seconds, as many at once as there are processors, with clang's
# address and undefined behavior sanitizers. What is found is kept as build/fuzz/finds/TARGET-...,
# and the test fails. To run an input again, and to see what its bytes mean:
#   SMF_FUZZ_PRINT=1 build/fuzz/test/fuzz/fuzz_TARGET FILE
# Interesting inputs are kept in build/fuzz/corpus/TARGET, where the next run begins.
# Environment variable:
#   SMF_FUZZ_SEED  the first random number (0, which takes another one each time)
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
  targets=(loop_systems edits three_ways python_boundary repair read_off read_obj read_ply read_stl
    read_loops)
fi

test/install_packages.sh compilers library tests python
cmake --preset fuzz -D Python_EXECUTABLE=/usr/bin/python3
cmake --build --preset fuzz --target write_seeds "${targets[@]/#/fuzz_}"

build=build/fuzz
mkdir -p $build/finds $build/logs
$build/test/fuzz/write_seeds $build/seeds

fuzz()
{
  local target=$1 status=0
  local arguments=(-max_len=2048)
  case $target in
    read_*) arguments+=(-dict=test/fuzz/mesh_files.dict) ;;
    repair) arguments=(-max_len=256) ;;
    *) arguments=(-max_len=512 -len_control=0) ;;
  esac
  mkdir -p "$build/corpus/$target"
  "$build/test/fuzz/fuzz_$target" "${arguments[@]}" -max_total_time="$seconds" \
    -rss_limit_mb=1024 -malloc_limit_mb=1024 -timeout=30 -print_final_stats=1 \
    -seed="${SMF_FUZZ_SEED:-0}" \
    -artifact_prefix="$build/finds/$target-" \
    "$build/corpus/$target" "$build/seeds/$target" >"$build/logs/$target" 2>&1 || status=1
  [ $status -eq 0 ] || tail -n 60 "$build/logs/$target"
  # covered code of the target and its corpus are on the last line of progress
  printf '%-15s %9s runs, coverage %s\n' "$target" \
    "$(sed -n 's/^stat::number_of_executed_units: *//p' "$build/logs/$target")" \
    "$(grep -o 'cov: .* corp: [0-9]*' "$build/logs/$target" | tail -n 1)"
  return $status
}

status=0
running=0
for target in "${targets[@]}"; do
  if [ $running -eq "$(nproc)" ]; then
    wait -n || status=1
    running=$((running - 1))
  fi
  fuzz "$target" &
  running=$((running + 1))
done
while [ $running -gt 0 ]; do
  wait -n || status=1
  running=$((running - 1))
done
exit $status
