#!/usr/bin/env bash
# test/coverage.sh [CTEST-ARGUMENT...]: which lines and branches of include/ the tests reach. Builds
# them in build/coverage with clang, runs them, and prints a table by folder and the places that no
# test reaches. Fails if there is one that coverage/unreached.txt does not explain, or if less than
# 97 % of the lines are reached. Every line is marked in build/coverage/html/index.html. Debian 12.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh library program tests optional coverage speed

build=build/coverage
cmake --preset coverage
cmake --build --preset coverage
rm -rf $build/profiles
failed=0
ctest --preset coverage --exclude-regex '^consumer' --parallel "$(nproc)" "$@" || failed=$?
llvm-profdata-14 merge -sparse $build/profiles/*.profraw -o $build/tests.profdata

# all programs of tests, by name as one option each
objects=()
while IFS= read -r program; do
  objects+=(-object "$program")
done < <(find $build/test -type f -executable -name 'test_*')

arguments=("${objects[@]:1}" -instr-profile $build/tests.profdata
  -ignore-filename-regex '^/usr/|/(test|generators|benchmark)/(Surface_mesh_foliation/|[^/]*$)')
llvm-cov-14 show "${arguments[@]}" -format=html -show-branches=count -output-dir $build/html
llvm-cov-14 export "${arguments[@]}" -format=lcov >$build/tests.lcov
llvm-cov-14 export "${arguments[@]}" -skip-functions -skip-expansions >$build/tests.json
python3 test/coverage/report.py $build/tests.lcov $build/tests.json || failed=$?
exit $failed
