#!/usr/bin/env bash
# test/matrix.sh [COMPILER/CGAL/BUILD-TYPE[/STANDARD]...]: builds everything with warnings as errors
# and runs the tests, for each combination of
#   g++-12, clang++-14  x  CGAL 5.5.1 (Debian 12), CGAL 6.0.1 (Debian 13)  x  Release, Debug,
# as C++17, and for some of them as C++20 and C++23; or only for those given, such as
# clang++-14/6.0.1/Release/20. CGAL 6.0.1 is unpacked below build; nothing of it is installed.
# Environment: CMAKE_ARGUMENTS, more arguments of cmake; CTEST_ARGUMENTS, more arguments of ctest.
set -euo pipefail
cd "$(dirname "$0")/.."

combinations=("$@")
if [ $# -eq 0 ]; then
  for cgal in 5.5.1 6.0.1; do
    for compiler in g++-12 clang++-14; do
      for build_type in Release Debug; do
        combinations+=("$compiler/$cgal/$build_type")
      done
    done
  done
  combinations+=(g++-12/5.5.1/Release/20 g++-12/6.0.1/Release/23 clang++-14/6.0.1/Release/20)
fi

test/install_packages.sh compilers library tests python benchmarks

# Downloads Debian 13's libcgal-dev from the mirror that the system uses, with package lists of its
# own beside the system's, and unpacks it into the folder $1.
unpack_cgal_6()
{
  local folder=$1 apt=$1.apt mirror
  mirror=$(test/debian_mirror.sh)
  rm -rf "$folder" "$apt"
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
  cat >"$apt/debian.sources" <<SOURCES
Types: deb
URIs: $mirror
Suites: trixie
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
SOURCES
  local options=(-qq -o APT::Sandbox::User=root -o Dir::Etc::sourcelist="$apt/debian.sources"
    -o Dir::Etc::sourceparts=/dev/null -o Dir::Etc::preferencesparts=/dev/null
    -o Dir::State::lists="$apt/lists" -o Dir::Cache="$apt/cache")
  apt-get "${options[@]}" update
  (cd "$apt" && apt-get "${options[@]}" download libcgal-dev)
  dpkg-deb -x "$apt"/libcgal-dev_6.0.1-*.deb "$folder.part"
  rm -rf "$apt"
  mv "$folder.part" "$folder"
}

for combination in "${combinations[@]}"; do
  IFS=/ read -r compiler cgal build_type standard <<<"$combination"
  build="build/matrix/$compiler-cgal-$cgal-$build_type${standard:+-c++$standard}"
  echo "== $combination"

  root=
  if [ "$cgal" = 6.0.1 ]; then
    root="$PWD/build/matrix/cgal-6.0.1"
    [ -d "$root" ] || unpack_cgal_6 "$root"
  fi
  cgal_dir=$(ls -d "$root"/usr/lib/*/cmake/CGAL)
  grep -q "(CGAL_VERSION_PUBLIC_RELEASE_VERSION \"$cgal\")" "$cgal_dir/CGALConfigVersion.cmake" ||
    { echo "$cgal_dir is not CGAL $cgal" >&2; exit 1; }

  # shellcheck disable=SC2086
  cmake -S . -B "$build" -G Ninja \
    -D CMAKE_CXX_COMPILER="$compiler" \
    -D CMAKE_BUILD_TYPE="$build_type" \
    -D CMAKE_CXX_STANDARD="${standard:-17}" \
    -D CGAL_DIR="$cgal_dir" \
    -D Python_EXECUTABLE=/usr/bin/python3 \
    -D SURFACE_MESH_FOLIATION_WERROR=ON \
    ${CMAKE_ARGUMENTS:-}
  cmake --build "$build"
  # (no grep -m or -q: ninja would die of the closed pipe, and with pipefail that is no match)
  if [ -n "$root" ] && ninja -C "$build" -t deps | grep ' /usr/include/CGAL/' >/dev/null; then
    echo "$combination has included a header of the system's CGAL" >&2
    exit 1
  fi
  # shellcheck disable=SC2086
  ctest --test-dir "$build" --output-on-failure --no-tests=error --parallel "$(nproc)" \
    ${CTEST_ARGUMENTS:-}
done
