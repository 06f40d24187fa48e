#!/usr/bin/env bash
# package/set_version.sh X.Y.Z: makes this the version of the package, in version.h and in the files
# that have to repeat it. CHANGES.md is written by hand.
set -euo pipefail
cd "$(dirname "$0")/.."

[[ $# -eq 1 && $1 =~ ^([0-9]+)\.([0-9]+)\.([0-9]+)$ ]] || {
  echo "usage: package/set_version.sh X.Y.Z" >&2
  exit 2
}
version=$1
number=$((10000 * BASH_REMATCH[1] + 100 * BASH_REMATCH[2] + BASH_REMATCH[3]))

demo=demo/Surface_mesh_foliation
sed -Ei -e "s/^(#define CGAL_SURFACE_MESH_FOLIATION_VERSION) .*/\1 \"$version\"/" \
  -e "s/^(#define CGAL_SURFACE_MESH_FOLIATION_VERSION_NR) .*/\1 $number/" \
  include/CGAL/Surface_mesh_foliation/version.h
sed -Ei "s/^version: .*/version: $version/" CITATION.cff
sed -Ei "s/^version = .*/version = \"$version\"/" python/pyproject.toml
sed -Ei "0,/^  \"version\"/s/^(  \"version\"): \"[^\"]*\"/\1: \"$version\"/" \
  $demo/package.json $demo/package-lock.json package/vcpkg/vcpkg.json
# the second place in package-lock.json: the first of its packages is the page itself
sed -Ei "0,/^      \"version\"/s/^(      \"version\"): \"[^\"]*\"/\1: \"$version\"/" \
  $demo/package-lock.json

cmake -D SOURCE_DIR="$PWD" -P test/versions_agree.cmake
