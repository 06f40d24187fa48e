#!/usr/bin/env bash
# test/clang_tidy.sh [BASE]: lets clang-tidy 14 look at the headers that have changed since the
# revision BASE, with the checks of .clang-tidy; anything found is a failure. BASE is by default
# where this branch has left origin/main, or else the last commit but one; without either, or if
# BASE is not known (a shallow clone), all headers count as changed. Most of the time goes into what
# they include, CGAL and Eigen, so they are looked at together, in one unit per core; at most
# CLANG_TIDY_LIMIT headers, by default 20: those with most changed lines. The others are named.
set -euo pipefail
cd "$(dirname "$0")/.."
git rev-parse --verify --quiet HEAD >/dev/null || {
  echo "git cannot read this folder" >&2
  exit 1
}

test/install_packages.sh tidy library optional

revision() { git rev-parse --verify --quiet "$1^{commit}"; }

base=
if [ $# -gt 0 ]; then
  base=$(revision "$1") || echo "$1 is not known here"
else
  base=$(git merge-base HEAD origin/main 2>/dev/null) || true
  # this is main, or a branch that has been merged
  [ "$base" != "$(revision HEAD)" ] || base=
fi
[ -n "$base" ] || base=$(revision HEAD~1) || base=$(git hash-object -t tree /dev/null)

# number of changed lines and name of each header, without those that were only moved
headers=()
while IFS=$'\t' read -r -d '' added deleted header; do
  if [ -z "$header" ]; then # moved: the old and the new name follow
    read -r -d '' _
    read -r -d '' header
  fi
  [ $((added + deleted)) -eq 0 ] || headers+=("$((added + deleted)) $header")
done < <(git diff --numstat -z --find-renames --diff-filter=d "$base" -- 'include/*.h')
if [ ${#headers[@]} -eq 0 ]; then
  echo "No header has changed since ${base:0:12}"
  exit 0
fi
mapfile -t headers < <(printf '%s\n' "${headers[@]}" | LC_ALL=C sort -k 1,1nr -k 2 |
  cut -d ' ' -f 2)

limit=${CLANG_TIDY_LIMIT:-20}
skipped=("${headers[@]:$limit}")
headers=("${headers[@]:0:$limit}")
echo "clang-tidy looks at ${#headers[@]} headers changed since ${base:0:12}:"
printf '  %s\n' "${headers[@]}"
[ ${#skipped[@]} -eq 0 ] || printf 'not looked at: %s\n' "${skipped[@]}"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
number_of_units=$(nproc)
for i in "${!headers[@]}"; do
  echo "#include <${headers[$i]#include/}>" >>"$folder/unit_$((i % number_of_units)).cpp"
done

# what is found in headers that these include is not shown
filter=$(printf '|%s' "${headers[@]//./\\.}")
arguments=(-std=c++17 -I include -isystem /usr/include/eigen3 -isystem /usr/include/suitesparse
  -isystem /usr/include/hypre -isystem "/usr/include/$(gcc -print-multiarch)/mpi")
for folder_of_vtk in /usr/include/vtk-*; do
  arguments+=(-isystem "$folder_of_vtk")
done
printf '%s\0' "$folder"/unit_*.cpp |
  xargs -0 -I UNIT -P "$number_of_units" clang-tidy-14 --quiet --config-file=.clang-tidy \
    --header-filter="(${filter:1})\$" UNIT -- "${arguments[@]}"
