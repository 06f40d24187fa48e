#!/usr/bin/env bash
# package/make_packages.sh [BUILD-FOLDER]: builds the Debian packages of the library, the program and
# the documentation (Debian 12) into BUILD-FOLDER/packages, build/packages by default, and checks them
# by lintian. The program is built without VTK, which would bring hundreds of packages along.
# Environment: DEBFULLNAME and DEBEMAIL, who makes the packages; SOURCE_DATE_EPOCH, the date in them,
# by default that of the last commit; what dpkg-buildflags knows, such as DEB_CXXFLAGS_APPEND=-O1 for
# a program that is made quickly.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/packages}

test/install_packages.sh library debian speed

DEBFULLNAME=${DEBFULLNAME:-$(git config user.name)}
DEBEMAIL=${DEBEMAIL:-$(git config user.email)}
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
export DEBFULLNAME DEBEMAIL SOURCE_DATE_EPOCH
export DEB_CXXFLAGS_MAINT_STRIP=-g # the program would be stripped of it
umask 022

cmake --preset release -B "$build" \
  -D SURFACE_MESH_FOLIATION_BUILD_TESTS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_EXAMPLES=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_BENCHMARKS=OFF \
  -D SURFACE_MESH_FOLIATION_BUILD_PROGRAM=ON \
  -D SURFACE_MESH_FOLIATION_BUILD_DOC=ON \
  -D SURFACE_MESH_FOLIATION_DOC_MATHJAX_DIR=/usr/share/javascript/mathjax \
  -D CMAKE_DISABLE_FIND_PACKAGE_VTK=ON \
  -D CMAKE_CXX_FLAGS="$(dpkg-buildflags --get CXXFLAGS) $(dpkg-buildflags --get CPPFLAGS)" \
  -D CMAKE_CXX_FLAGS_RELEASE=-DNDEBUG \
  -D CMAKE_EXE_LINKER_FLAGS="$(dpkg-buildflags --get LDFLAGS)"
cmake --build "$build"
cmake --build "$build" --target doc
rm -rf "$build/packages"
cmake --build "$build" --target package
package/test_completion.sh "$build/package"
lintian --fail-on error,warning --profile debian --tag-display-limit 0 "$build"/packages/*.deb
ls -l "$build"/packages/*.deb
