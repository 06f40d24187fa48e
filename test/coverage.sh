#!/usr/bin/env bash
# test/coverage.sh [CTEST-ARGUMENT...]: which lines and branches of include/ the tests reach. Builds
# them in build/coverage with clang, runs them, and prints a table by header, and the lines that no
# test reaches. Every line is marked in build/coverage/html/index.html. Debian 12.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh library program tests optional coverage speed

build=build/coverage
cmake --preset coverage
cmake --build --preset coverage
rm -rf $build/profiles
ctest --preset coverage --exclude-regex '^consumer' --parallel "$(nproc)" "$@" || failed=$?
llvm-profdata-14 merge -sparse $build/profiles/*.profraw -o $build/tests.profdata

# all programs that have left a profile, by name as one option each
objects=()
while IFS= read -r program; do
  objects+=(-object "$program")
done < <(find $build -type f -executable -name 'test_*' -o -type f -executable -name foliation_reeb_graph)

arguments=("${objects[@]:1}" -instr-profile $build/tests.profdata include)
llvm-cov-14 show "${arguments[@]}" -format=html -show-branches=count -output-dir $build/html
llvm-cov-14 report "${arguments[@]}" -show-branch-summary | tee $build/report.txt
# each line of include/ once, whatever it is instantiated for
llvm-cov-14 show "${arguments[@]}" -show-instantiations=false -show-line-counts |
  sed -n 's,^\(/.*\):$,\1,p; s/^ *\([0-9]*\)| *0|\(.*\)/  \1:\2/p' >$build/missed.txt
echo "Lines that no test reaches: $build/missed.txt"
exit "${failed:-0}"
