#!/usr/bin/env bash
# test/clang_tidy.sh [BASE]: lets clang-tidy 14 look at the headers that have changed since the
# revision BASE, with the checks of .clang-tidy, each compiled alone; anything found is a failure.
# BASE is by default where this branch has left origin/main, or else the last commit but one;
# without either, or if BASE is not known (a shallow clone), all headers count as changed. Of many
# headers only those with most changed lines are looked at, and the others named: at most
# CLANG_TIDY_LIMIT, by default 20, since each takes about ten seconds.
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh tidy library optional

revision() { git rev-parse --verify --quiet "$1^{commit}"; }

head=$(revision HEAD)
if [ $# -gt 0 ]; then
  base=$(revision "$1") || echo "$1 is not known here"
else
  base=$(git merge-base HEAD origin/main 2>/dev/null) || base=
  # a branch that has been merged, or main itself
  [ "$base" != "$head" ] || base=
fi
[ -n "$base" ] || base=$(revision HEAD~1) || base=$(git hash-object -t tree /dev/null)

# changed lines and name of each header, without those that were only moved
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
echo "clang-tidy looks at ${#headers[@]} headers changed since ${base:0:12}"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
multiarch=$(gcc -print-multiarch)
export folder multiarch

# shellcheck disable=SC2317
look_at()
{
  local name=${1//\//_}
  echo "#include <${1#include/}>" >"$folder/$name.cpp"
  # its warnings are not shown if they come from headers that it includes
  if clang-tidy-14 --quiet --header-filter="/${1//./\\.}\$" "$folder/$name.cpp" -- -std=c++17 \
    -I include -isystem /usr/include/eigen3 -isystem /usr/include/suitesparse \
    -isystem /usr/include/hypre -isystem "/usr/include/$multiarch/mpi" >"$folder/$name.txt" 2>&1
  then
    echo "ok      $1"
  else
    printf 'FAILED  %s\n%s\n' "$1" "$(cat "$folder/$name.txt")"
    return 1
  fi
}
export -f look_at

result=0
# shellcheck disable=SC2016
printf '%s\0' "${headers[@]}" |
  xargs -0 -n 1 -P "$(nproc)" bash -c 'look_at "$1"' look_at || result=1
[ ${#skipped[@]} -eq 0 ] || printf 'not looked at: %s\n' "${skipped[@]}"
exit $result
