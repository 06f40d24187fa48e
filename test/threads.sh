#!/usr/bin/env bash
# test/threads.sh: the tests of what runs in threads of TBB, with clang's thread sanitizer. It
# has to see how these threads wait for each other, so TBB is built with the sanitizer, too, from
# Debian's source package, into build/threads; nothing of it is installed. (Threads made by tests,
# without TBB, are checked with the preset tsan.)
set -euo pipefail
cd "$(dirname "$0")/.."

test/install_packages.sh compilers library tests threads

# Downloads TBB's sources from the mirror that the system uses, with package lists of its own beside
# the system's, and builds it into the folder $1.
build_tbb()
{
  local folder=$1 work=$1.work mirror
  mirror=$(test/debian_mirror.sh)
  rm -rf "$folder" "$work"
  mkdir -p "$work/lists/partial" "$work/cache/archives/partial"
  cat >"$work/debian.sources" <<SOURCES
Types: deb-src
URIs: $mirror
Suites: bookworm
Components: main
Signed-By: /usr/share/keyrings/debian-archive-keyring.gpg
SOURCES
  local options=(-qq -o APT::Sandbox::User=root -o Dir::Etc::sourcelist="$work/debian.sources"
    -o Dir::Etc::sourceparts=/dev/null -o Dir::Etc::preferencesparts=/dev/null
    -o Dir::State::lists="$work/lists" -o Dir::Cache="$work/cache")
  apt-get "${options[@]}" update
  (cd "$work" && apt-get "${options[@]}" source onetbb >/dev/null)
  cmake -S "$work"/onetbb-*/ -B "$work/build" -G Ninja \
    -D CMAKE_C_COMPILER=clang-14 -D CMAKE_CXX_COMPILER=clang++-14 \
    -D CMAKE_BUILD_TYPE=RelWithDebInfo -D TBB_SANITIZE=thread \
    -D TBB_TEST=OFF -D CMAKE_INSTALL_PREFIX="$folder.part"
  cmake --build "$work/build"
  cmake --install "$work/build" >/dev/null
  rm -rf "$work"
  mv "$folder.part" "$folder"
}

tbb="$PWD/build/threads/tbb"
[ -d "$tbb" ] || { mkdir -p build/threads && build_tbb "$tbb"; }

cmake --preset tsan -B build/threads \
  -D CMAKE_CXX_COMPILER=clang++-14 \
  -D CMAKE_PREFIX_PATH="$tbb" \
  -D TBB_DIR="$tbb/lib/cmake/TBB" \
  -D SURFACE_MESH_FOLIATION_CHECK_HEADERS=OFF \
  -D SURFACE_MESH_FOLIATION_TESTS='^test_parallel$'
cmake --build build/threads --target test_parallel
ldd build/threads/test/Surface_mesh_foliation/test_parallel | grep "$tbb" >/dev/null ||
  { echo "test_parallel does not use the TBB in $tbb" >&2; exit 1; }
ctest --test-dir build/threads --output-on-failure --no-tests=error \
  --tests-regex '^test_parallel\.'
