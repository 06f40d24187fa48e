#!/usr/bin/env bash
# package/cgal/test.sh [PROGRAM...]: lays the package over the CGAL that is installed (Debian's
# libcgal-dev), copied to build/cgal, and tests it there as CGAL's test suite does: each folder of
# programs is a project that finds CGAL, and is compiled and run by ctest. Fails at a warning in a
# header of the package, too. PROGRAM: only these examples and tests. Before that, what CGAL's scripts
# look for is looked for: permissions, notices, calls of min and max, names of headers, dependencies.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD/build/cgal
name=Surface_mesh_foliation

test/install_packages.sh library tests speed

# ===  A CGAL with this package

rm -rf "$root/include/CGAL/$name" "$root"/{sources,examples,test,benchmark,demo,doc,package_info}
if [ ! -d "$root/include" ]; then
  mkdir -p "$root.part"
  dpkg -L libcgal-dev | grep -E '^/usr/(include|lib)/.*' | while IFS= read -r file; do
    [ -d "$file" ] || printf '%s\0' "${file#/usr/}"
  done | tar -C /usr --null -T - -cf - | tar -C "$root.part" -xf -
  archive=/usr/share/doc/libcgal-dev/data.tar.gz
  [ ! -e $archive ] || tar -xzf $archive -C "$root.part" data
  mv "$root.part" "$root"
fi
package/cgal/lay_out.sh --flat "$root"
# An installed CGAL counts as a part of the system, in which compilers see no warnings; in CGAL's
# sources each package has its own folder of headers, which does not.
package/cgal/lay_out.sh "$root/sources"
cgal_dir=$(ls -d "$root"/lib/*/cmake/CGAL)

# ===  What CGAL's scripts look for

# refuse MESSAGE FILES: fails if there are such files or lines
refuse()
{
  [ -z "$2" ] || { printf '%s:\n%s\n' "$1" "$2" >&2; exit 1; }
}
mapfile -t headers < <(cd "$root/include" &&
  find CGAL/$name.h CGAL/$name CGAL/license/$name.h -name '*.h' | sort)
refuse "files with wrong permissions" \
  "$(find "$root"/{examples,test,benchmark,demo,doc,package_info} "$root/include/CGAL/$name" \
    -type f ! -perm 644)"
refuse "headers without a license" \
  "$(cd "$root/include" && grep -L 'SPDX-License-Identifier: GPL-3.0-or-later' "${headers[@]}")"
# shellcheck disable=SC2015
refuse "min and max that are macros on Windows" \
  "$(cd "$root/include" && grep -nE '(^|[^(])std::(min|max)\(|::(min|max)\(\)' "${headers[@]}" || true)"
# shellcheck disable=SC2015
refuse "headers that differ only in case" \
  "$(cd "$root/include" && find CGAL -name '*.h' | tr '[:upper:]' '[:lower:]' | sort | uniq -d |
    grep -F "$(printf '%s\n' "${headers[@]}" | tr '[:upper:]' '[:lower:]')" || true)"
package/cgal/dependencies.sh "$root" | diff package_info/$name/dependencies - ||
  refuse "package_info/$name/dependencies" "is not what package/cgal/dependencies.sh prints"

# ===  Examples and tests

for kind in examples test; do
  build=$root/build/$kind
  cmake -S "$root/$kind/$name" -B "$build" -G Ninja \
    -D CGAL_DIR="$cgal_dir" \
    -D BUILD_TESTING=ON \
    -D CMAKE_BUILD_TYPE=Release \
    -D CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG" \
    -D CMAKE_CXX_FLAGS="-Wall -Wextra -I$root/sources/$name/include" \
    ${CCACHE_LAUNCHER:+-D CMAKE_CXX_COMPILER_LAUNCHER="$CCACHE_LAUNCHER"}
  targets=() expression=.
  if [ $# -gt 0 ]; then
    for program in "$@"; do
      [ ! -e "$root/$kind/$name/$program.cpp" ] || targets+=("$program")
    done
    [ ${#targets[@]} -gt 0 ] || continue
    expression="^(compilation_of|execution___of)__($(IFS='|'; echo "${targets[*]}"))$"
  fi
  cmake --build "$build" --target "${targets[@]:-all}" | tee "$root/build/$kind.log"
  refuse "warnings" "$(grep -A 3 "$name.*warning: " "$root/build/$kind.log" || true)"
  ctest --test-dir "$build" --output-on-failure --no-tests=error --tests-regex "$expression"
done
